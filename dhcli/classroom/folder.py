"""Finding the sheets of a class: in a folder, or in a folder for each student as learning platforms pack them."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path

from dhcli.errors import FileError, Place, Problem
from dhcli.files.reading import instead_of
from dhcli.frozen import frozen

_SUFFIXES = (".yaml", ".yml")
_SHEET = ".sheet"
_PACKED_BY_MACOS = "__MACOSX"


@frozen
class Submission:
    """One sheet that was handed in.

    Attributes:
        path: The file.
        sheet: Its path below the folder of the class, with `/`.
        student: Who handed it in, going by folder or file; the sheet may know better.
        problem: What keeps it from being read at all; empty if nothing is known to.
    """

    path: str
    sheet: str
    student: str
    problem: str = ""


@frozen
class Folder:
    """What a class has handed in.

    Attributes:
        path: The folder as the user wrote it.
        submissions: The sheets, by their path.
        empty: Folders of students that hold no sheet.
        others: Paths of files that are no sheets by their name, below the folder: nobody looks at them.
    """

    path: str
    submissions: tuple[Submission, ...]
    empty: tuple[str, ...]
    others: tuple[str, ...] = ()


def find_sheets(folder: str, *, may_be_none: bool = False) -> Folder:
    """Everything in a folder that looks like a sheet, opened by nobody yet.

    Links are not followed: a student might have packed one that leads to somebody else's file. Hidden files, and the
    folder that macOS adds to archives, are no sheets.

    Args:
        folder: The folder.
        may_be_none: Whether a folder without a sheet is one, too.

    Raises:
        FileError: There is no such folder, or no sheet in it.
    """
    root = Path(folder)
    if not folder:
        from dhcli.storage.atomic import EMPTY

        raise FileError(Problem(EMPTY, hint="name a folder; . is the current one"))
    if not root.is_dir():
        raise FileError(_no_folder(root, folder))
    others: list[str] = []
    found = tuple(sorted(_submissions(root, others), key=lambda one: one.sheet))
    if not found and not may_be_none:
        hint = "sheets are files that end in .yaml or .yml; dhcli start EXERCISE writes one"
        raise FileError(Problem("there is no sheet in this folder", Place(folder), hint))
    handed_in = {one.sheet.partition("/")[0] for one in found}
    empty = (child.name for child in root.iterdir() if child.is_dir() and _counts(child.name))
    without = tuple(sorted(name for name in empty if name not in handed_in))
    return Folder(folder, found, without, tuple(sorted(others)))


def _no_folder(root: Path, folder: str) -> Problem:
    if root.exists():
        return Problem("is a file, not a folder", Place(folder), f"dhcli check EXERCISE {folder} judges one sheet")
    beside = [child.name for child in root.parent.iterdir() if child.is_dir()] if root.parent.is_dir() else []
    return Problem("there is no such folder", Place(folder), instead_of(root, beside))


def _submissions(root: Path, others: list[str]) -> Iterator[Submission]:
    """The sheets; what else was handed in is noted."""
    unreadable: list[OSError] = []
    for where, folders, files in os.walk(root, onerror=unreadable.append):
        here = Path(where)
        folders[:] = [name for name in folders if _counts(name)]
        for name in folders:
            if (here / name).is_symlink():
                yield _submission(root, here / name, "is a link; links are not followed")
        for name in files:
            path = here / name
            if not _counts(name):
                continue
            if path.suffix.lower() not in _SUFFIXES:
                others.append(path.relative_to(root).as_posix())
                continue
            problem = "is a link; links are not followed" if path.is_symlink() else ""
            yield _submission(root, path, problem or ("" if path.is_file() else "is no file"))
    for error in unreadable:
        if error.filename == str(root):
            raise FileError(Problem(f"cannot be opened: {error.strerror}", Place(str(root))))
        yield _submission(root, Path(error.filename), f"cannot be opened: {error.strerror}")


def _counts(name: str) -> bool:
    return not name.startswith(".") and name != _PACKED_BY_MACOS


def _submission(root: Path, path: Path, problem: str) -> Submission:
    below = path.relative_to(root)
    is_folder = len(below.parts) > 1 or path.is_dir()
    student = below.parts[0] if is_folder else below.stem.removesuffix(_SHEET)
    return Submission(str(path), below.as_posix(), student, problem)
