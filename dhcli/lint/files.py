"""Linting: every content rule over files and folders, all findings at once."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path

from dhcli.errors import DhcliError, FileError, Place, Problem
from dhcli.files.library.entries import FOLDERS, YAML
from dhcli.files.reading import read_text
from dhcli.frozen import frozen
from dhcli.lint.names import Names
from dhcli.lint.one_file import SHEETS, Told, told_of


@frozen
class Linted:
    """What was found in files.

    Attributes:
        files: The files, in the order in which they were read.
        told: The findings, by file and line.
    """

    files: tuple[str, ...]
    told: tuple[Told, ...]

    @property
    def errors(self) -> int:
        """Findings that must be mended."""
        return sum(not one.is_warning for one in self.told)

    @property
    def warnings(self) -> int:
        """Findings that an author may leave."""
        return len(self.told) - self.errors


def lint(paths: Sequence[str]) -> Linted:
    """Look at files, and at every YAML file in folders and below them; answer sheets are passed over there.

    Args:
        paths: Files and folders; `./robots` and `./exercises` if there are none.

    Raises:
        FileError: Paths lead nowhere or to folders without a file to read; all of them are told.
    """
    files = list(_files(paths or _usual()))
    told: list[Told] = []
    names = Names.of(files)
    for path in files:
        told += told_of(path, names)
    return Linted(tuple(files), tuple(told))


def _usual() -> list[str]:
    found = [folder for folder in FOLDERS if os.path.isdir(folder)]  # noqa: PTH112
    if not found:
        raise DhcliError(
            "there is no ./robots and no ./exercises here", "name files or folders: dhcli lint my-arm.yaml"
        )
    return found


def _files(paths: Iterable[str]) -> Iterator[str]:
    """The files meant, each once."""
    problems: list[Problem] = []
    found: dict[str, str] = {}
    for path in paths:
        before = len(problems)
        inner = sorted(_in_folder(Path(path), problems)) if path and Path(path).is_dir() else [Path(path)]
        if not path:
            problems.append(_missing(path))
        elif not inner and len(problems) > before:
            continue  # what cannot be read is told
        elif not inner:
            problems.append(Problem("holds no YAML file", Place(path), "name a folder with robots or exercises"))
        elif path == "-":
            problems.append(
                Problem("lint reads files, not standard input", hint="save it first: a file name is a name")
            )
        elif not os.path.lexists(path):
            problems.append(_missing(path))
        for one in inner:
            found.setdefault(os.path.realpath(one), str(one))
    if problems:
        raise FileError(problems)
    yield from found.values()


def _missing(path: str) -> Problem:
    """Why a path leads nowhere, as reading it tells; a name of the library is not a path."""
    from dhcli.storage.home import unexpanded

    try:
        read_text(path)
    except FileError as error:
        problem = error.problems[0]
        if not path.lower().endswith(YAML):
            message = problem.message.replace("no such file", "no such file or folder")
            hint = unexpanded(path) or "lint takes files and folders, such as robots/my-arm.yaml"
            problem = replace(problem, message=message, hint=hint)
        return problem
    return Problem("has just appeared", Place(path), "try again")  # between two looks at the disk


def _in_folder(folder: Path, problems: list[Problem]) -> Iterator[Path]:
    """YAML files in a folder and below; hidden ones and sheets are passed over."""

    def refused(error: OSError) -> None:
        problems.append(Problem(f"cannot be read: {error.strerror}", Place(str(error.filename))))

    for here, folders, names in os.walk(folder, onerror=refused):
        folders[:] = sorted(name for name in folders if not name.startswith("."))
        for name in names:
            if name.lower().endswith(YAML) and not name.lower().endswith(SHEETS) and not name.startswith("."):
                yield Path(here, name)
