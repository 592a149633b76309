"""README and the manual keep their word: every command in them is run, every example works, and nothing is left out."""

from __future__ import annotations

import doctest
import importlib.util
import re
import subprocess
import sys
from pathlib import Path

import pytest

from dhcli.cli import app
from dhcli.files.manual import FOLDER, GROUPS, topics
from tests.manual.generated import GENERATED
from tests.manual.pages import MANUAL, PAGES, ROOT, fenced, named, played
from tests.row_by_row import row_by_row

README = (ROOT / "README.md").read_text("utf-8")
_LINK = re.compile(r"(?<!!)\[[^\]]*\]\(([^)\s]+)\)")
_OPTION = re.compile(r"(?<![\w-])--[a-z][a-z-]*")


@pytest.mark.parametrize("path", PAGES, ids=named)
def test_a_page_shows_what_its_commands_print(path: Path) -> None:
    """The output under each command, errors included, is that of today to the letter."""
    page = path.read_text("utf-8")
    assert played(page) == page


def test_the_pages_have_commands_to_run() -> None:
    """The blocks are found at all."""
    assert sum(len(fenced(path.read_text("utf-8"), "console")) for path in PAGES) > 25


@pytest.mark.parametrize("path", [path for path in PAGES if fenced(path.read_text("utf-8"), "pycon")], ids=named)
def test_an_example_of_the_library_works(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The lines with prompts give the results under them; the blocks of a page know what those before them made."""
    monkeypatch.chdir(ROOT)
    names: dict[str, object] = {}
    for block in fenced(path.read_text("utf-8"), "pycon"):
        test = doctest.DocTestParser().get_doctest(block, names, path.name, str(path), 0)
        assert test.examples
        assert doctest.DocTestRunner(verbose=False).run(test, clear_globs=False).failed == 0
        names |= test.globs


@pytest.mark.parametrize("path", GENERATED, ids=named)
def test_a_page_made_from_the_program_is_up_to_date(path: Path) -> None:
    """`python tests/manual/pages.py` makes it again."""
    assert GENERATED[path]() == path.read_text("utf-8")


def test_readme_opens_with_two_commands_that_stand_alone() -> None:
    """Each sets up by itself; the second is the one CI runs."""
    first, second = (block.strip() for block in fenced(README, "sh")[:2])
    assert first.startswith("python3 -m venv .venv && ")
    assert first.endswith("dhcli fk scara --q 0.3,0.5,0.1")
    assert second.startswith("python3 -m venv .venv && ")
    assert second.endswith("-m pytest")


def test_readme_is_short() -> None:
    """It leads on; what it does not say stands in the manual."""
    assert README.count("\n") <= 150


def test_every_command_has_a_page() -> None:
    """In whose heading it stands, so that `dhcli help COMMAND` finds it."""
    assert {name for topic in topics() for name in topic.commands} == set(app.COMMANDS)


def test_every_page_has_a_group_and_every_topic_occurs_once() -> None:
    """A page in no group, or two of one name, could not be asked for."""
    names = [topic.name for topic in topics()]
    assert len(set(names)) == len(names)
    assert set(MANUAL.rglob("*.md")) == {FOLDER / "index.md", *(topic.path for topic in topics())}
    assert {path.name for path in MANUAL.iterdir() if path.is_dir()} == set(GROUPS)


@row_by_row("path", PAGES)
def test_a_link_leads_to_a_file(path: Path) -> None:
    """Relative to the page; links to the web are nobody's promise here."""
    links = [link.partition("#")[0] for link in _LINK.findall(path.read_text("utf-8")) if "://" not in link]
    missing = [link for link in links if link and not (path.parent / link).exists()]
    assert not missing


def _options() -> dict[str, set[str]]:
    """The long options of each command."""
    found: dict[str, set[str]] = {}
    for name in app.COMMANDS:
        command = app.load(name)
        commands = [command, *getattr(command, "commands", {}).values()]
        found[name] = {option for one in commands for param in one.params for option in (*param.opts, "--help")}
    return found


@row_by_row("path", [path for path in PAGES if path not in GENERATED])
def test_a_page_names_only_options_that_exist(path: Path) -> None:
    """Behind a command its own; alone, one of some command or of the tools that a developer runs."""
    known = _options()
    every = set().union(*known.values()) | {"--version", "--strict", "--install-completion"}
    for span in (*re.findall(r"`([^`\n]+)`", page := path.read_text("utf-8")), *_typed(page)):
        words = span.split()
        if words[0] == "dhcli" and len(words) > 1 and words[1] in known:
            assert set(_OPTION.findall(span)) <= known[words[1]], span
        elif not re.match(r"(pip|python|bash|mkdocs|pytest|ruff|\.venv|--hypothesis)", span):
            assert set(_OPTION.findall(span)) <= every, span


def _typed(page: str) -> list[str]:
    return [
        line.removeprefix("$ ").split(" | ")[-1] if line.startswith("$ ") else line
        for language in ("console", "sh", "bash")
        for block in fenced(page, language)
        for line in block.replace("\\\n", " ").splitlines()
        if line.startswith(("$ dhcli", "dhcli "))
    ]


def test_a_page_that_names_an_unknown_option_is_caught() -> None:
    """Were no option found, the test above could not fail."""
    assert _OPTION.findall("dhcli fk scara --no-such-option --q 1") == ["--no-such-option", "--q"]
    assert "--no-such-option" not in _options()["fk"]


def test_every_key_of_a_file_format_is_documented() -> None:
    """Keys that a loader knows stand as code on the page about its files."""
    from dhcli.files.keys import exercises, linkages, robots
    from dhcli.files.keys.shapes import names
    from dhcli.files.yaml import sheets

    known = {
        "robot-files": {name for keys in robots.ROBOTS.values() for name in names(keys)},
        "exercise-files": {*names((*exercises.EXERCISE, *exercises.PART, *exercises.TOLERANCE)), *sheets.KEYS},
        "linkage-files": {*names((*linkages.LINKAGE, *linkages.JOINT, *linkages.LOOP_ROW))},
    }
    for topic, keys in known.items():
        page = (MANUAL / "reference" / f"{topic}.md").read_text("utf-8")
        code = "\n".join((*re.findall(r"`[^`\n]+`", page), *fenced(page, "yaml")))
        missing = {key for key in keys if not re.search(rf"(?<![\w-]){re.escape(key)}(?![\w-])", code)}
        assert not missing, topic


def test_every_room_of_the_package_stands_in_how_it_is_built() -> None:
    """The list of rooms is the list of folders."""
    rooms = {path.name for path in (ROOT / "dhcli").iterdir() if path.is_dir() and not path.name.startswith("_")}
    page = (MANUAL / "explanation" / "building.md").read_text("utf-8")
    missing = [room for room in rooms if f"  {room}/" not in page]
    assert not missing


def test_every_file_that_how_it_is_built_names_is_there() -> None:
    """A newcomer is sent to no file that has moved."""
    page = (MANUAL / "explanation" / "building.md").read_text("utf-8")
    said = set(re.findall(r"`(?:dhcli/)?((?:[a-z_]+/)+(?:[a-z_]+\.py)?)`", page))
    assert len(said) > 25
    assert not [name for name in said if not any((root / name).exists() for root in (ROOT / "dhcli", ROOT))]


def test_the_robot_files_in_the_manual_load() -> None:
    """Every example of the format is a robot."""
    from dhcli.files.yaml.robots import read_robot

    pages = [path.read_text("utf-8") for path in PAGES]
    blocks = [
        block
        for page in pages
        for block in fenced(page, "yaml")
        if "\nconvention:" in block and "\nframes:" not in block
    ]
    assert blocks
    assert all(read_robot(block, "manual", "example").pattern for block in blocks)


def test_the_exercise_file_in_the_reference_has_nothing_to_mend(tmp_path: Path) -> None:
    """A lecturer starts from it: it loads, and lint finds nothing in it."""
    from dhcli.lint.files import lint

    page = (MANUAL / "reference" / "exercise-files.md").read_text("utf-8")
    [block] = [block for block in fenced(page, "yaml") if "parts:" in block]
    path = tmp_path / "tip.yaml"
    path.write_text(block, "utf-8")
    assert [str(told.problem) for told in lint([str(path)]).told] == []


def site(config: Path, into: Path) -> subprocess.CompletedProcess[str]:
    """The manual as a site, as the README has it made."""
    if importlib.util.find_spec("mkdocs") is None:
        pytest.skip("mkdocs is not installed: pip install -e '.[docs]'")
    words = [sys.executable, "-m", "mkdocs", "build", "--strict", "-f", str(config), "-d", str(into)]
    return subprocess.run(words, cwd=ROOT, capture_output=True, encoding="utf-8", check=False)


def test_the_site_is_made_of_the_same_pages(tmp_path: Path) -> None:
    """MkDocs takes them with no warning."""
    done = site(Path(".ci/mkdocs.yml"), tmp_path)
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "tutorial" / "student" / "index.html").is_file()


def test_the_site_is_refused_with_a_broken_link(tmp_path: Path) -> None:
    """To a page that is not there, and to a heading that is not; both are told."""
    settings = (ROOT / ".ci" / "mkdocs.yml").read_text("utf-8").replace("../dhcli/manual", "docs")
    config, page = tmp_path / "mkdocs.yml", tmp_path / "docs" / "page.md"
    config.write_text(settings, "utf-8")
    page.parent.mkdir()
    (page.parent / "index.md").write_text("# A manual\n\nIt has [a page](page.md).\n", "utf-8")
    page.write_text("# A page\n\n[This](nowhere.md) and [that](page.md#no-heading) lead nowhere.\n", "utf-8")
    done = site(config, tmp_path / "site")
    assert done.returncode != 0
    warned = [line for line in done.stderr.splitlines() if line.startswith("WARNING")]
    assert len(warned) == 2, done.stderr
    assert "'nowhere.md'" in warned[0]
    assert "#no-heading" in warned[1]
