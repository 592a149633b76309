"""`dhcli start --class`: a sheet for everybody, which `grade` takes back."""

from __future__ import annotations

from pathlib import Path

import pytest

from dhcli.files.yaml.sheets import read_sheet
from tests.cli.running import Run

NUMBERS, LETTERS = "yim/planar-in-numbers", "yim/planar-two-links"


def roster(tmp_path: Path, text: str) -> str:
    """A file with names."""
    (tmp_path / "names.txt").write_text(text, "utf-8")
    return "names.txt"


def test_everybody_gets_the_sheet_of_a_variant_of_that_name(dhcli: Run, tmp_path: Path) -> None:
    """In a folder of their own; it is the one that `--variant` writes, with a name on it."""
    names = roster(tmp_path, "\ufeffAda\n\n# from the register\n  Jörg Müller \nO'Hara, Z.-Y.\n")
    done = dhcli("start", NUMBERS, "--class", names, "-o", "home work")
    assert (done.code, done.out) == (0, "")
    assert done.err == (
        "wrote 3 sheets into home work, with numbers of its own each\n"
        "next: dhcli grade 'home work', when they are filled in\n"
    )
    for name in ("Ada", "Jörg Müller", "O'Hara, Z.-Y."):
        path = tmp_path / "home work" / name / "planar-in-numbers.sheet.yaml"
        sheet = read_sheet(path)
        assert (sheet.name, sheet.variant) == (name, name)
        alone = dhcli("start", NUMBERS, "--variant", name, "-o", "-").out
        kept = [line for line in path.read_text("utf-8").splitlines(keepends=True) if not line.startswith("name: ")]
        assert "".join(kept) == alone
    graded = dhcli("grade", "home work", "--format", "csv").out.splitlines()
    assert [line.split("planar-in-numbers")[0] for line in graded[1:]] == [
        "Ada,Ada/",
        "Jörg Müller,Jörg Müller/",
        '"O\'Hara, Z.-Y.","O\'Hara, Z.-Y./',
    ]


def test_an_exercise_without_variants_is_the_same_for_all(dhcli: Run, tmp_path: Path) -> None:
    """And its folder is called after it."""
    done = dhcli("start", LETTERS, "--class", roster(tmp_path, "Ada\nBob\n"))
    assert done.err.startswith("wrote 2 sheets into planar-two-links-sheets, all with the same numbers\n")
    sheet = read_sheet(tmp_path / "planar-two-links-sheets/Bob/planar-two-links.sheet.yaml")
    assert (sheet.name, sheet.variant) == ("Bob", "")


def test_no_sheet_is_written_where_one_may_hold_answers(dhcli: Run, tmp_path: Path) -> None:
    """Of nobody; those who came later get theirs from a file of their own, and nothing of the others is touched."""
    assert dhcli("start", LETTERS, "--class", roster(tmp_path, "Bob"), "-o", "x").code == 0
    done = dhcli("start", LETTERS, "--class", roster(tmp_path, "Ada\nBob"), "-o", "x")
    assert done.code == 2
    assert "Bob/planar-two-links.sheet.yaml: exists already\n  hint: it may hold answers" in done.err.replace("\\", "/")
    assert "a file with only the names that have none (Ada) adds theirs" in done.err
    assert not (tmp_path / "x/Ada").exists()
    assert dhcli("start", LETTERS, "--class", roster(tmp_path, "Eve"), "-o", "x").code == 0
    assert (tmp_path / "x/Eve").is_dir()
    assert "have none" not in dhcli("start", LETTERS, "--class", roster(tmp_path, "Bob"), "-o", "x").err
    roster(tmp_path, "Ada\nBob")
    assert dhcli("start", LETTERS, "--class", "names.txt", "-o", "x", "--overwrite").code == 0
    assert (tmp_path / "x/Ada").is_dir()


def test_every_name_that_can_be_none_of_a_folder_is_told(dhcli: Run, tmp_path: Path) -> None:
    """With its line, and before anything is written."""
    done = dhcli("start", LETTERS, "--class", roster(tmp_path, f"Ada\na/b\n..\nADA\n{'x' * 101}\n"), "-o", "x")
    assert done.code == 2
    assert [line for line in done.err.splitlines() if line.startswith("dhcli:")] == [
        "dhcli: names.txt:2: 'a/b' holds a letter that no folder can have in its name",
        "dhcli: names.txt:3: '..' begins with a dot",
        "dhcli: names.txt:4: ADA stands in line 1 too",
        f"dhcli: names.txt:5: '{'x' * 100}' has more than 100 letters",
    ]
    assert not (tmp_path / "x").exists()


@pytest.mark.parametrize(
    ("words", "text", "said"),
    [
        ((), "# nobody\n", "names.txt holds no name"),
        (("--variant", "ada"), "Ada\n", "leave out --variant"),
        (("-o", "-"), "Ada\n", "leave out --variant, and -o -"),
        (("-o", "names.txt"), "Ada\n", "names.txt"),
        (("-o", "no/where"), "Ada\n", "no folder can be made here"),
    ],
)
def test_what_makes_no_class_is_refused(
    dhcli: Run, tmp_path: Path, words: tuple[str, ...], text: str, said: str
) -> None:
    """With what would be right."""
    done = dhcli("start", NUMBERS, "--class", roster(tmp_path, text), *words)
    assert (done.code, done.out) == (2, "")
    assert said in done.err
