"""What the library holds, one line each: files that cannot be read are listed too, with what is wrong."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass

from dhcli.errors import DhcliError, Problem
from dhcli.files.library import Entry, Kind, entries


@dataclass(frozen=True, slots=True)
class Listed:
    """One file of the library.

    Attributes:
        kind: What the file describes.
        entry: Its name, path and origin.
        title: What it is called; empty if it cannot be read.
        joints: The joints as letters, such as RRP; empty where there are none.
        problems: What is wrong with it.
    """

    kind: Kind
    entry: Entry
    title: str = ""
    joints: str = ""
    problems: tuple[Problem, ...] = ()


def catalogue(kinds: Iterable[Kind] = tuple(Kind)) -> tuple[Listed, ...]:
    """Everything of some kinds that the library holds, in the order of the search."""
    return tuple(_listed(kind, entry) for kind in kinds for entry in entries(kind))


def _listed(kind: Kind, entry: Entry) -> Listed:
    read = _READERS.get(kind)
    if read is None:
        return Listed(kind, entry)
    try:
        title, joints = read(entry)
    except DhcliError as error:
        return Listed(kind, entry, problems=error.problems)
    return Listed(kind, entry, title, joints)


def _robot(entry: Entry) -> tuple[str, str]:
    from dhcli.files.robots import load_robot

    robot = load_robot(entry.path)
    return robot.title, robot.pattern


def _exercise(entry: Entry) -> tuple[str, str]:
    from dhcli.files.exercises import load_exercise

    exercise = load_exercise(entry.path)
    return exercise.title, exercise.robot.pattern if exercise.robot else ""


def _linkage(entry: Entry) -> tuple[str, str]:
    from dhcli.files.linkages import load_linkage

    linkage = load_linkage(entry.path)
    return linkage.title, linkage.pattern


_READERS: dict[Kind, Callable[[Entry], tuple[str, str]]] = {
    Kind.ROBOTS: _robot,
    Kind.LINKAGES: _linkage,
    Kind.EXERCISES: _exercise,
}
"""How to find out what a file holds, for each kind that dhcli can load."""
