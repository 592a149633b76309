"""What counts as handed in, and whose it is."""

from __future__ import annotations

import errno
import os
from pathlib import Path

import pytest

from dhcli.classroom.folder import find_sheets
from dhcli.errors import FileError
from tests.classroom.sheets import hand_in


def test_a_sheet_belongs_to_its_folder_or_else_to_its_file(tmp_path: Path) -> None:
    """As learning platforms pack them, or all in one folder; `start` adds `.sheet` to a name."""
    for name in ("one/planar.yaml", "two.b/deep/er/planar.YML", "three.sheet.yaml", "four.yml"):
        hand_in(tmp_path, name)
    found = find_sheets(str(tmp_path))
    assert [(one.sheet, one.student) for one in found.submissions] == [
        ("four.yml", "four"),
        ("one/planar.yaml", "one"),
        ("three.sheet.yaml", "three"),
        ("two.b/deep/er/planar.YML", "two.b"),
    ]
    assert found.empty == ()


def test_what_a_computer_adds_is_no_sheet(tmp_path: Path) -> None:
    """Hidden files, the second half of a file that macOS packs, and whatever else is not YAML."""
    for name in ("one/a.yaml", "one/._a.yaml", ".git/b.yaml", "__MACOSX/one/a.yaml", "one/a.txt", "one/a.yaml~"):
        hand_in(tmp_path, name)
    assert [one.sheet for one in find_sheets(str(tmp_path)).submissions] == ["one/a.yaml"]


def test_a_student_without_a_sheet_is_not_forgotten(tmp_path: Path) -> None:
    """The folder is there, with something else in it, or with nothing."""
    hand_in(tmp_path, "one/a.yaml")
    hand_in(tmp_path, "two/a.pdf")
    (tmp_path / "three").mkdir()
    assert find_sheets(str(tmp_path)).empty == ("three", "two")


@pytest.mark.skipif(os.name == "nt", reason="links need rights there")
def test_links_are_told_and_not_followed(tmp_path: Path) -> None:
    """To a folder above, to itself, or to the sheet of somebody else."""
    real = hand_in(tmp_path, "one/a.yaml")
    (tmp_path / "two").mkdir()
    (tmp_path / "two" / "loop").symlink_to(tmp_path)
    (tmp_path / "two" / "self.yaml").symlink_to("self.yaml")
    (tmp_path / "two" / "theirs.yaml").symlink_to(real)
    os.mkfifo(tmp_path / "two" / "pipe.yaml")
    found = {one.sheet: (one.student, one.problem) for one in find_sheets(str(tmp_path)).submissions}
    assert found == {
        "one/a.yaml": ("one", ""),
        "two/loop": ("two", "is a link; links are not followed"),
        "two/pipe.yaml": ("two", "is no file"),
        "two/self.yaml": ("two", "is a link; links are not followed"),
        "two/theirs.yaml": ("two", "is a link; links are not followed"),
    }


def test_a_folder_that_may_not_be_opened_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """It may hold a sheet; the folder of the class itself is refused."""
    hand_in(tmp_path, "one/a.yaml")
    hand_in(tmp_path, "two.b/a.yaml")
    scandir = os.scandir

    def guarded(path: str) -> object:
        if str(path) in closed:
            raise PermissionError(errno.EACCES, "Permission denied", str(path))
        return scandir(path)

    monkeypatch.setattr("os.scandir", guarded)
    closed = {str(tmp_path / "two.b")}
    found = find_sheets(str(tmp_path)).submissions[1]
    assert (found.sheet, found.student, found.problem) == ("two.b", "two.b", "cannot be opened: Permission denied")
    closed = {str(tmp_path)}
    with pytest.raises(FileError, match="cannot be opened"):
        find_sheets(str(tmp_path))


@pytest.mark.parametrize(
    ("name", "message", "hint"),
    [
        ("clas", "there is no such folder", "did you mean class?"),
        ("a.yaml", "is a file, not a folder", "dhcli check EXERCISE"),
        ("class", "there is no sheet in this folder", "end in .yaml or .yml"),
    ],
)
def test_a_folder_that_cannot_be_graded_is_refused(tmp_path: Path, name: str, message: str, hint: str) -> None:
    """With what to type instead."""
    (tmp_path / "class").mkdir()
    hand_in(tmp_path, "a.yaml")
    with pytest.raises(FileError) as caught:
        find_sheets(str(tmp_path / name))
    (problem,) = caught.value.problems
    assert problem.message == message
    assert hint in problem.hint
