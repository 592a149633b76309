"""What the library holds, one line each: files that cannot be read are listed too, with what is wrong.

Reading all of it takes half a second, so what was read is kept in the user's cache folder, beside how long each file is
and when it was changed. As soon as one of them differs, or another dhcli asks, all of it is read anew; what cannot be
read is, each time.
"""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterable
from dataclasses import replace
from pathlib import Path
from typing import Any, NamedTuple

from dhcli.errors import DhcliError, Problem
from dhcli.files.library.entries import Entry, Kind, entries
from dhcli.frozen import frozen
from dhcli.storage.cache import cache, cached


@frozen
class Listed:
    """One file of the library.

    Attributes:
        kind: What the file describes.
        entry: Its name, path and origin.
        title: What it is called; empty if it cannot be read.
        joints: The joints as letters, such as RRP; empty where there are none.
        problems: What is wrong with it.
        parts: The parts that an exercise asks; else none.
        solved: Of an exercise, how many of its parts this user has solved, such as 3/8; else empty.
    """

    kind: Kind
    entry: Entry
    title: str = ""
    joints: str = ""
    problems: tuple[Problem, ...] = ()
    parts: tuple[str, ...] = ()
    solved: str = ""


INDEX = "library.json"
"""What it is called in the cache."""

ROOMS = ("checking", "files", "kinematics", "mobility", "notation")
"""Where it is decided what a file says: a checkout changes without a new version."""


class Kept(NamedTuple):
    """What is kept of a file that could be read; see `Listed`."""

    title: str
    joints: str
    parts: tuple[str, ...] = ()

    def of(self, kind: Kind, entry: Entry) -> Listed:
        """As it is listed."""
        return Listed(kind, entry, self.title, self.joints, parts=self.parts)


def catalogue(kinds: Iterable[Kind] = tuple(Kind)) -> tuple[Listed, ...]:
    """Everything of some kinds that the library holds, in the order of the search."""
    library = {kind: entries(kind) for kind in Kind}
    state = _state(library)
    known = _remembered(state)
    every = {kind: tuple(_listed(known, kind, entry) for entry in found) for kind, found in library.items()}
    if not known:
        _remember(state, every)
    return tuple(_with_progress(one) for kind in kinds for one in every[kind])


def _listed(known: dict[str, Kept], kind: Kind, entry: Entry) -> Listed:
    kept = known.get(str(entry.path))
    return kept.of(kind, entry) if kept else _read(kind, entry)


def _read(kind: Kind, entry: Entry) -> Listed:
    try:
        return _READERS[kind](entry).of(kind, entry)
    except DhcliError as error:
        return Listed(kind, entry, problems=error.problems)


def _robot(entry: Entry) -> Kept:
    from dhcli.files.yaml.robots import load_robot

    robot = load_robot(entry.path)
    return Kept(robot.title, robot.pattern)


def _exercise(entry: Entry) -> Kept:
    from dhcli.files.yaml.exercises import load_exercise

    exercise = load_exercise(entry.path)
    return Kept(
        exercise.title, exercise.robot.pattern if exercise.robot else "", tuple(part.id for part in exercise.asked)
    )


def _linkage(entry: Entry) -> Kept:
    from dhcli.files.yaml.linkages import load_linkage

    linkage = load_linkage(entry.path)
    return Kept(linkage.title, linkage.pattern)


_READERS: dict[Kind, Callable[[Entry], Kept]] = {
    Kind.ROBOTS: _robot,
    Kind.LINKAGES: _linkage,
    Kind.EXERCISES: _exercise,
}
"""How to find out what a file holds."""


def _with_progress(one: Listed) -> Listed:
    if not one.parts:
        return one
    from dhcli.files.progress import solved_parts

    done = {*one.parts} & {*solved_parts(one.entry.name)}
    return replace(one, solved=f"{len(done)}/{len(one.parts)}")


def _state(library: dict[Kind, tuple[Entry, ...]]) -> list[Any]:
    """What the index depends on: every file of the library, those that read them, and this release."""
    from dhcli import __version__

    package = Path(__file__).parents[2]
    files = [str(entry.path) for found in library.values() for entry in found]
    readers = sorted(str(path) for room in ROOMS for path in package.joinpath(room).rglob("*.py"))
    return [__version__, *([os.path.abspath(path), *stamp(path)] for path in (*files, *readers))]


def stamp(path: str) -> tuple[int, int]:
    """When a file was changed and how long it is; an editor that replaces the file may take it away for a moment."""
    try:
        found = os.stat(path)
    except OSError:
        return (0, 0)
    return found.st_mtime_ns, found.st_size


def _remembered(state: list[Any]) -> dict[str, Kept]:
    """What was read when the library was in this state; nothing if it was in another, or nothing is kept."""
    try:
        kept = json.loads(cached(INDEX) or "null")
        if kept["state"] != state:
            return {}
        return {
            str(path): Kept(str(title), str(joints), tuple(map(str, parts)))
            for path, (title, joints, parts) in kept["rows"].items()
        }
    except (ValueError, TypeError, KeyError, AttributeError, RecursionError):
        return {}


def _remember(state: list[Any], every: dict[Kind, tuple[Listed, ...]]) -> None:
    """Keep what was read of the files that could be; where that cannot be, the next list takes as long as this one."""
    read = [one for listed in every.values() for one in listed if not one.problems]
    rows = {str(one.entry.path): (one.title, one.joints, one.parts) for one in read}
    cache(json.dumps({"state": state, "rows": rows}), INDEX)
