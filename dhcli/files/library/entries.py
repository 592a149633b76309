"""The library: where robots, linkages and exercises are found by name.

A root is a folder with `robots/`, `robots/linkages/` and `exercises/` in it, each of them optional. The roots are,
first to last: the current folder; each entry of `$DHCLI_PATH`; `dhcli` in the user's data folder (`$XDG_DATA_HOME`,
else `~/.local/share`); what dhcli brings along. The first file of a name wins, so a user's robot hides a built-in one.
An entry of `$DHCLI_PATH` that has neither `robots/` nor `exercises/` is itself taken as a folder of robots.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from enum import Enum
from functools import lru_cache
from pathlib import Path
from stat import S_ISDIR

from dhcli.errors import DhcliError
from dhcli.frozen import frozen

BUILT_IN = "built-in"
YAML = (".yaml", ".yml")
"""What the name of a file of the library ends in."""
FOLDERS = ("robots", "exercises")
"""What makes an entry of `$DHCLI_PATH` a root."""
_PACKAGE = Path(__file__).parents[2]
_path = lru_cache(1024)(Path)
"""A path by its text: the same few are made, split and hashed for every name that is looked up."""


class Kind(Enum):
    """What a file can describe; the value is the word on the command line."""

    ROBOTS = "robots"
    LINKAGES = "linkages"
    EXERCISES = "exercises"

    @property
    def folder(self) -> str:
        """Its folder in a root."""
        return "robots/linkages" if self is Kind.LINKAGES else self.value

    @property
    def noun(self) -> str:
        """The word for one of it."""
        return self.value.removesuffix("s")


@frozen
class Entry:
    """One file of the library.

    Attributes:
        name: The file name without its suffix; of an exercise `folder/name`.
        path: The file.
        origin: `built-in`, or its folder as the user would write it.
        shadowed: Whether a file found earlier has the same name, so that this one is found by its path only.
    """

    name: str
    path: Path
    origin: str
    shadowed: bool = False


def entries(kind: Kind) -> tuple[Entry, ...]:
    """Everything of a kind that the library holds, in the order of the search, then by name. Opens no file."""
    found: list[Entry] = []
    names: set[str] = set()
    for folder, origin in _folders(kind):
        for name, path in sorted(files_in(folder, nested=kind is Kind.EXERCISES)):
            found.append(Entry(name, _path(path), origin, shadowed=name in names))
            names.add(name)
    return tuple(found)


def holds(kind: Kind, name: str) -> bool:
    """Whether the library has something of a kind and name."""
    return any(entry.name == name for entry in entries(kind))


def list_robots() -> tuple[str, ...]:
    """The names of all robots that `load_robot` finds, in alphabetical order."""
    return tuple(sorted({entry.name for entry in entries(Kind.ROBOTS)}))


def is_own(name: str) -> bool:
    """Whether dhcli brings a robot of that name along."""
    return any(entry.name == name and entry.origin == BUILT_IN for entry in entries(Kind.ROBOTS))


def refuse_namesake(kind: Kind, name: str) -> None:
    """Refuse a new name that something of another kind has: which of them is meant would be anybody's guess.

    Args:
        kind: What is to be called so.
        name: Its name; of an exercise the part behind its course counts.

    Raises:
        DhcliError: It is taken.
    """
    last = name.rsplit("/", maxsplit=1)[-1]
    for other in Kind:
        if other is kind:
            continue
        for entry in entries(other):
            if entry.name.split("/")[-1] == last:
                where = f"{'built-in ' if entry.origin == BUILT_IN else ''}{other.noun} {entry.name}"
                raise DhcliError(f"{last} is the name of the {where}, too", f"name the {kind.noun} otherwise")


def full_id(name: str) -> str:
    """An id from its last part, where only one exercise ends so."""
    if "/" in name or name.endswith(YAML) or name == "-":
        return name
    ends = [entry.name for entry in entries(Kind.EXERCISES) if entry.name.split("/")[-1] == name and not entry.shadowed]
    return ends[0] if len(ends) == 1 else name


def _folders(kind: Kind) -> Iterator[tuple[str, str]]:
    """The folders of a kind that exist, each once, with what the user calls them."""
    built_in = os.path.join(_built_in_root(), kind.folder)
    seen = {None, _identity(built_in)}
    for folder, written in _user_folders(kind):
        # In a checkout the current folder is the root that dhcli brings along: not the user's own.
        if (found := _identity(folder)) not in seen:
            seen.add(found)
            yield folder, written
    yield built_in, BUILT_IN


def _identity(folder: str) -> tuple[int, int] | None:
    """What a folder has by whichever way it is reached, and no other has; None if it is not there."""
    try:
        found = os.stat(folder)
    except (OSError, ValueError):
        return None
    return (found.st_dev, found.st_ino) if S_ISDIR(found.st_mode) else None


def _user_folders(kind: Kind) -> Iterator[tuple[str, str]]:
    """The folders of a kind in the user's roots, existing or not."""
    yield kind.folder, f"./{kind.folder}"
    for written in filter(None, os.environ.get("DHCLI_PATH", "").split(os.pathsep)):
        root = os.path.expanduser(written)
        below = kind.folder
        if kind is not Kind.EXERCISES and not any(os.path.isdir(os.path.join(root, own)) for own in FOLDERS):
            below = below.removeprefix("robots").removeprefix("/")
        yield os.path.join(root, below), os.path.join(written, below)
    data_home = os.environ.get("XDG_DATA_HOME", "")
    written = data_home if os.path.isabs(data_home) else "~/.local/share"  # the standard says: ignore a relative one
    written = os.path.join(written, "dhcli", kind.folder)
    yield os.path.expanduser(written), written


def _built_in_root() -> Path:
    """The root that dhcli brings along: in the installed package, else beside the package in a checkout."""
    # importlib.resources would find it too, and takes as long to import as the rest of a command
    installed = _PACKAGE / "_data"
    return installed if os.path.isdir(installed) else _PACKAGE.parent


def files_in(folder: str | Path, *, nested: bool, below: str = "") -> Iterator[tuple[str, str]]:
    """The YAML files in a folder, or in its folders, each with its name; one that cannot be read stops no command."""
    try:
        with os.scandir(folder) as found:
            children = list(found)
    except OSError:
        return
    # What a child is, most folders say of it; only links are looked at.
    for child in children:
        name = child.name
        if name.startswith("."):
            continue
        if nested:
            if child.is_dir(follow_symlinks=False) or os.path.isdir(child.path):
                yield from files_in(child.path, nested=False, below=f"{name}/")
        elif name.lower().endswith(YAML) and (child.is_file(follow_symlinks=False) or os.path.isfile(child.path)):
            yield below + name[: name.rindex(".")], child.path
