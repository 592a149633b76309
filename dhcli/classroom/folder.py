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
_LINK = "is a link; links are not followed"


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
    found = tuple(sorted(_submissions("" if str(root) == "." else str(root), others), key=lambda one: one.sheet))
    if not found and not may_be_none:
        hint = "sheets are files that end in .yaml or .yml; dhcli start EXERCISE writes one"
        raise FileError(Problem("there is no sheet in this folder", Place(folder), hint))
    handed_in = {one.sheet.partition("/")[0] for one in found}
    with os.scandir(root) as inside:
        rest = (one for one in inside if _counts(one.name) and one.name not in handed_in)
        empty = sorted(one.name for one in rest if os.path.isdir(one.path))
    return Folder(folder, found, tuple(empty), tuple(sorted(others)))


def _no_folder(root: Path, folder: str) -> Problem:
    if root.exists():
        return Problem("is a file, not a folder", Place(folder), f"dhcli check EXERCISE {folder} judges one sheet")
    beside = [child.name for child in root.parent.iterdir() if child.is_dir()] if root.parent.is_dir() else []
    return Problem("there is no such folder", Place(folder), instead_of(root, beside))


def _submissions(root: str, others: list[str]) -> Iterator[Submission]:
    """The sheets; what else was handed in is noted."""
    folders = [""]  # below the root, each with a / behind it
    for below in folders:
        try:
            with os.scandir(os.path.join(root, *below.split("/")[:-1]) or ".") as inside:
                there = [one for one in inside if _counts(one.name)]
        except OSError as error:
            problem = f"cannot be opened: {error.strerror}"
            if not below:
                raise FileError(Problem(problem, Place(root or "."))) from None
            yield _submission(root, below[:-1], problem, is_folder=True)
            continue
        for one in there:
            name, is_link = below + one.name, one.is_symlink()
            is_folder = os.path.isdir(one.path) if is_link else one.is_dir()
            problem = _LINK if is_link else ""
            if is_folder and not is_link:
                folders.append(f"{name}/")
            elif is_folder or os.path.splitext(one.name)[1].lower() in _SUFFIXES:
                problem = problem or ("" if one.is_file() else "is no file")
                yield _submission(root, name, problem, is_folder=is_folder)
            else:
                others.append(name)


def _counts(name: str) -> bool:
    return not name.startswith(".") and name != _PACKED_BY_MACOS


def _submission(root: str, name: str, problem: str, *, is_folder: bool) -> Submission:
    first, *below = name.split("/")
    student = first if below or is_folder else os.path.splitext(first)[0].removesuffix(_SHEET)
    return Submission(os.path.join(root, first, *below), name, student, problem)
