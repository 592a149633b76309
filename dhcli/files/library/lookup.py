"""What is meant by a name that is typed: a file of the library, or a path."""

from __future__ import annotations

import os
from pathlib import Path

from dhcli.errors import UnknownNameError
from dhcli.files.library.entries import BUILT_IN, YAML, Kind, entries, holds

OWN = "builtin:"
"""What a name begins with that means the file that dhcli brings along."""
_PATHS = (*YAML, ".urdf", ".xml", ".xacro", ".sdf", ".csv", ".tsv", ".md", ".m", ".py")
"""What the name of a file ends in, where it is no name of the library."""


def find(kind: Kind, name: str) -> Path:
    """The file that a user means.

    Args:
        kind: What is looked for.
        name: A name of the library; or a path: what ends in `.yaml` or `.yml`, has a `/`, or is `-`. The id of an
            exercise has a `/` too and is a name, of no robot, as long as no file is called so.

    Returns:
        The file; a path is handed back as it is, whether it exists or not.

    Raises:
        UnknownNameError: The library holds nothing of that name; the hint has the nearest and what to type next.
    """
    check_typed(kind, name)
    if is_path(kind, name) and (kind is Kind.EXERCISES or os.path.exists(name) or not _is_exercise(name)):
        return Path(name)
    known = entries(kind)
    if name.startswith(OWN):  # the library's own, whatever file of the user's has the same name
        name = name.removeprefix(OWN)
        known = tuple(entry for entry in known if entry.origin == BUILT_IN)
    for entry in known:
        if entry.name == name:
            return entry.path
    from dhcli.files.library.near import instead  # for names that are not found

    raise UnknownNameError(f"there is no {kind.noun} '{name}'", instead(kind, name, known))


def _is_exercise(name: str) -> bool:
    """Whether a text with a `/` in it is the id of an exercise of the library."""
    return not is_path(Kind.EXERCISES, name) and holds(Kind.EXERCISES, name)


def typed(name: str, path: Path | None) -> str:
    """What is typed behind a command to mean a robot: its name, or its path where that leads to no or another file."""
    if path is None or any(entry.path == path and not entry.shadowed for entry in entries(Kind.ROBOTS)):
        return name
    return typed_path(path)


def typed_path(path: Path) -> str:
    """A path as it is typed in a command, where it is no name."""
    from shlex import quote  # for messages alone

    return quote(str(path) if is_path(Kind.ROBOTS, str(path)) else f"./{path}")


def check_typed(kind: Kind, name: object) -> None:
    """Make sure that a name may be one.

    Raises:
        UnknownNameError: It is no text, or no system has files of that name.
    """
    if not isinstance(name, str | os.PathLike):
        raise UnknownNameError(
            f"{name!r:.60} is no name of a{'n' * (kind is Kind.EXERCISES)} {kind.noun}", "write it as text"
        )
    if "\0" in str(name):
        raise UnknownNameError(
            f"there is no {kind.noun} '{name!s:.60}'",
            f"no file has NUL in its name; dhcli list {kind.value} shows what there is",
        )


def is_path(kind: Kind, name: str) -> bool:
    """Whether a text is a path and not a name."""
    if name == "-" or name.lower().endswith(_PATHS):
        return True
    separators = {"/", os.sep, os.altsep or os.sep}
    if not any(separator in name for separator in separators):
        return False
    is_id = kind is Kind.EXERCISES and name.count("/") == 1 and not name.startswith((".", "/", "~"))
    return not is_id or os.path.isfile(name)
