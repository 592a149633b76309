"""What the tests of a process read once: files of the library are many, and none of them changes meanwhile.

Robots and exercises are frozen, and one that was read from the same text among the same others is the same.
"""

from __future__ import annotations

from functools import cache, lru_cache, wraps
from pathlib import Path

from dhcli.checking.exercise import Exercise
from dhcli.errors import UnknownNameError
from dhcli.files.library import entries as library
from dhcli.files.library.entries import Kind, full_id
from dhcli.files.library.lookup import find
from dhcli.files.yaml import exercises, robots

LIBRARY = library._built_in_root()

MOST_READ = 500
"""Robots that are kept: more than the library has, and not each that an example draws."""

_anew = exercises.load_exercise
_of_library = cache(_anew)


@wraps(_anew)  # the manual shows what it says
def load_exercise(name: str | Path) -> Exercise:
    """The exercise that dhcli loads, which is kept if it is the library's own and has only the library beside it."""
    if not isinstance(name, str | Path):  # as of who calls the library with anything else
        return _anew(name)
    try:
        path = name if isinstance(name, Path) else find(Kind.EXERCISES, full_id(name))
    except UnknownNameError:
        return _anew(name)
    return _of_library(path) if path.is_relative_to(LIBRARY) and _is_alone() else _anew(name)


def _is_alone() -> bool:
    """Whether nobody has robots, linkages or exercises of their own that the library's may mean: of the same name."""
    return library._built_in_root() == LIBRARY and not any(
        len(list(library._folders(kind))) > 1 and any(entry.shadowed for entry in library.entries(kind))
        for kind in Kind
    )


def remember() -> None:
    """Read nothing twice from here on; before anybody has imported what reads."""
    robots.read_robot = lru_cache(MOST_READ)(robots.read_robot)
    exercises.load_exercise = load_exercise
