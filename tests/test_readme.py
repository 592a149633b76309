"""README keeps its word: every command in it is run and its output compared, every example of the library too."""

import doctest
import re
import shlex
from pathlib import Path

import pytest

from tests.cli.running import run

ROOT = Path(__file__).parent.parent
README = (ROOT / "README.md").read_text(encoding="utf-8")


def fenced(language: str) -> list[str]:
    """The blocks of README in a language."""
    return re.findall(rf"^```{language}\n(.*?)^```$", README, re.MULTILINE | re.DOTALL)


def commands() -> list[tuple[str, str]]:
    """Each command of the console blocks, with the output that stands under it."""
    pairs = []
    for block in fenced("console"):
        for piece in re.split(r"^\$ ", block, flags=re.MULTILINE)[1:]:
            command, _, output = piece.partition("\n")
            pairs.append((command, output))
    return pairs


@pytest.mark.parametrize(("command", "output"), commands(), ids=[command for command, _ in commands()])
def test_a_command_in_readme_prints_what_readme_shows(
    monkeypatch: pytest.MonkeyPatch, command: str, output: str
) -> None:
    """The output, errors included, is the one in README to the letter."""
    monkeypatch.chdir(ROOT)
    program, *words = shlex.split(command)
    assert program == "dhcli"
    assert run(*words, together=True).out == output


def test_readme_has_commands_to_run() -> None:
    """The blocks are found at all."""
    assert len(commands()) > 10


@pytest.mark.parametrize("block", fenced("pycon"))
def test_an_example_of_the_library_in_readme_works(block: str) -> None:
    """The lines with prompts give the results under them."""
    test = doctest.DocTestParser().get_doctest(block, {}, "README", "README.md", 0)
    assert test.examples
    assert doctest.DocTestRunner(verbose=False).run(test).failed == 0


def test_the_robot_file_in_readme_loads() -> None:
    """The example of the file format is a robot."""
    from dhcli.files.yaml.robots import read_robot

    [block] = [block for block in fenced("yaml") if "convention:" in block]
    assert read_robot(block, "README", "example").pattern == "RRP"


def test_the_exercise_file_in_readme_has_nothing_to_mend(tmp_path: Path) -> None:
    """A lecturer starts from it: it loads, and lint finds nothing in it."""
    from dhcli.lint.files import lint

    [block] = [block for block in fenced("yaml") if "parts:" in block]
    path = tmp_path / "tip.yaml"
    path.write_text(block, "utf-8")
    assert [str(told.problem) for told in lint([str(path)]).told] == []


def test_readme_opens_with_two_commands_that_stand_alone() -> None:
    """Each sets up by itself; the second is the one CI runs."""
    first, second = (block.strip() for block in fenced("sh")[:2])
    assert first.startswith("python3 -m venv .venv && ")
    assert first.endswith("dhcli fk scara --q 0.3,0.5,0.1")
    assert second.startswith("python3 -m venv .venv && ")
    assert second.endswith("-m pytest")


def test_every_room_of_the_package_stands_in_how_it_is_built() -> None:
    """The list of rooms is the list of folders."""
    rooms = {path.name for path in (ROOT / "dhcli").iterdir() if path.is_dir() and not path.name.startswith("_")}
    section = README.partition("## How dhcli is built")[2]
    missing = [room for room in rooms if f"  {room}/" not in section]
    assert not missing
