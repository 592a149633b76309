"""What the library holds, one line each: files that cannot be read are listed too, with what is wrong."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass

from dhcli.errors import DhcliError, Problem
from dhcli.files.library.lookup import Entry, Kind, entries


@dataclass(frozen=True, slots=True)
class Listed:
    """One file of the library.

    Attributes:
        kind: What the file describes.
        entry: Its name, path and origin.
        title: What it is called; empty if it cannot be read.
        joints: The joints as letters, such as RRP; empty where there are none.
        problems: What is wrong with it.
        solved: Of an exercise, how many of its parts this user has solved, such as 3/8; else empty.
    """

    kind: Kind
    entry: Entry
    title: str = ""
    joints: str = ""
    problems: tuple[Problem, ...] = ()
    solved: str = ""


def catalogue(kinds: Iterable[Kind] = tuple(Kind)) -> tuple[Listed, ...]:
    """Everything of some kinds that the library holds, in the order of the search."""
    return tuple(_listed(kind, entry) for kind in kinds for entry in entries(kind))


def _listed(kind: Kind, entry: Entry) -> Listed:
    read = _READERS.get(kind)
    if read is None:
        return Listed(kind, entry)
    try:
        return read(entry)
    except DhcliError as error:
        return Listed(kind, entry, problems=error.problems)


def _robot(entry: Entry) -> Listed:
    from dhcli.files.yaml.robots import load_robot

    robot = load_robot(entry.path)
    return Listed(Kind.ROBOTS, entry, robot.title, robot.pattern)


def _exercise(entry: Entry) -> Listed:
    from dhcli.files.progress import solved_parts
    from dhcli.files.yaml.exercises import load_exercise

    exercise = load_exercise(entry.path)
    joints = exercise.robot.pattern if exercise.robot else ""
    solved = f"{len(solved_parts(entry.name))}/{len(exercise.parts)}"
    return Listed(Kind.EXERCISES, entry, exercise.title, joints, solved=solved)


def _linkage(entry: Entry) -> Listed:
    from dhcli.files.yaml.linkages import load_linkage

    linkage = load_linkage(entry.path)
    return Listed(Kind.LINKAGES, entry, linkage.title, linkage.pattern)


_READERS: dict[Kind, Callable[[Entry], Listed]] = {
    Kind.ROBOTS: _robot,
    Kind.LINKAGES: _linkage,
    Kind.EXERCISES: _exercise,
}
"""How to find out what a file holds, for each kind that dhcli can load."""
