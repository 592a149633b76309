"""The library: where robots, linkages and exercises are found by name.

A root is a folder with `robots/`, `robots/linkages/` and `exercises/` in it, each of them optional. The roots are,
first to last: the current folder; each entry of `$DHCLI_PATH`; `dhcli` in the user's data folder (`$XDG_DATA_HOME`,
else `~/.local/share`); what dhcli brings along. The first file of a name wins, so a user's robot hides a built-in one.
An entry of `$DHCLI_PATH` that has neither `robots/` nor `exercises/` is itself taken as a folder of robots.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator
from enum import Enum
from functools import lru_cache
from pathlib import Path
from stat import S_ISDIR

from dhcli.errors import UnknownNameError, did_you_mean, nearest
from dhcli.frozen import frozen

BUILT_IN = "built-in"
OWN = "builtin:"
"""What a name begins with that means the file that dhcli brings along."""
MOST_BEGUN = 4
"""Names that are suggested for the beginning of one."""
MOST_SIMILAR = 3
"""Names that are suggested for one that is misspelled."""
AS_SIMILAR = 0.1
"""How much less like it a name may be than the nearest of all kinds, to be suggested beside it."""
LEAST_TYPED = 3
"""Letters by which names are found that hold them anywhere."""
YAML = (".yaml", ".yml")
"""What the name of a file of the library ends in."""
_OWN_FOLDERS = ("robots", "exercises")
"""What makes an entry of `$DHCLI_PATH` a root."""
_PATHS = (*YAML, ".urdf", ".xml", ".xacro", ".sdf", ".csv", ".tsv", ".md", ".m", ".py")
"""What the name of a file ends in, where it is no name of the library."""
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
        for name, path in sorted(_files(folder, nested=kind is Kind.EXERCISES)):
            found.append(Entry(name, _path(path), origin, shadowed=name in names))
            names.add(name)
    return tuple(found)


def list_robots() -> tuple[str, ...]:
    """The names of all robots that `load_robot` finds, in alphabetical order."""
    return tuple(sorted({entry.name for entry in entries(Kind.ROBOTS)}))


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
    raise UnknownNameError(f"there is no {kind.noun} '{name}'", hint=_hint(kind, name, known))


def _is_exercise(name: str) -> bool:
    """Whether a text with a `/` in it is the id of an exercise of the library."""
    return not is_path(Kind.EXERCISES, name) and any(entry.name == name for entry in entries(Kind.EXERCISES))


def is_own(name: str) -> bool:
    """Whether dhcli brings a robot of that name along."""
    return any(entry.name == name and entry.origin == BUILT_IN for entry in entries(Kind.ROBOTS))


def typed(name: str, path: Path | None) -> str:
    """What is typed behind a command to mean a robot: its name, or its path where that leads to no or another file."""
    if path is None or any(entry.path == path and not entry.shadowed for entry in entries(Kind.ROBOTS)):
        return name
    return typed_path(path)


def typed_path(path: Path) -> str:
    """A path as it is typed in a command, where it is no name."""
    from shlex import quote  # for messages alone

    return quote(str(path) if is_path(Kind.ROBOTS, str(path)) else f"./{path}")


def full_id(name: str) -> str:
    """An id from its last part, where only one exercise ends so."""
    if "/" in name or name.endswith(YAML) or name == "-":
        return name
    ends = [entry.name for entry in entries(Kind.EXERCISES) if entry.name.split("/")[-1] == name and not entry.shadowed]
    return ends[0] if len(ends) == 1 else name


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


def _hint(kind: Kind, name: str, known: tuple[Entry, ...]) -> str:
    """What to type instead of an unknown name."""
    begun = _begun(name, known)
    hints = [begun or similar(name, (kind,)) or did_you_mean(name, [entry.name for entry in known])]
    for other in Kind:
        called = full_id(name) if other is Kind.EXERCISES else name
        if other is not kind and any(entry.name == called for entry in entries(other)):
            hints = [f"'{name}' is the name of a{'n' if other is Kind.EXERCISES else ''} {other.noun}", begun]
    for path in (name, *(name + suffix for suffix in YAML)):
        if os.path.isfile(path):
            hints = [f"for the file in this folder type ./{path}"]
    if found := above(kind, name):
        hints = [found]
    return "; ".join(hint for hint in (*hints, f"dhcli list {kind.value} shows what there is") if hint)


def above(kind: Kind, name: str) -> str:
    """A hint at something of this name in the library of a folder above the current one; empty if there is none."""
    up = ""
    for folder in Path.cwd().parents:
        up += "../"
        for found, path in _files(folder / kind.folder, nested=kind is Kind.EXERCISES):
            if name in (found, found.split("/")[-1]):
                typed = up + Path(path).relative_to(folder).as_posix()
                return f"in a folder above there is one: type {typed}, or go to the folder that has {kind.folder}/"
    return ""


def similar(name: str, kinds: Iterable[Kind]) -> str:
    """A hint at what a user may mean by a name, among several kinds of things; empty if nothing is near.

    Args:
        name: What was typed; an exercise is found by the last part of its name too.
        kinds: What could be meant, the likeliest first.
    """
    from difflib import SequenceMatcher

    known = {kind: entries(kind) for kind in kinds}
    if begun := _begun(name, tuple(entry for found in known.values() for entry in found)):
        return begun
    near: dict[str, float] = {}
    typed = name.lower()
    for found in known.values():
        full = {entry.name if "/" in name else entry.name.split("/")[-1]: entry.name for entry in found}
        for match in nearest(name, full):
            near[full[match]] = SequenceMatcher(None, typed, match.lower()).ratio()
    least = max(near.values(), default=0.0) - AS_SIMILAR
    best = sorted((one for one in near if near[one] >= least), key=lambda one: -near[one])[:MOST_SIMILAR]
    return f"did you mean {' or '.join(best)}?" if best else ""


def _begun(name: str, known: tuple[Entry, ...]) -> str:
    """A hint at the names that begin with what was typed, else at those that hold it; empty if there are none."""
    typed = name.lower()
    last = {entry.name: entry.name.lower().split("/")[-1] for entry in known if not entry.shadowed}
    begin = [full for full, short in last.items() if short.startswith(typed)]
    found = begin or [full for full, short in last.items() if len(typed) >= LEAST_TYPED and typed in short]
    if not found or not typed:
        return ""
    more = f" (and {len(found) - MOST_BEGUN} more)" if len(found) > MOST_BEGUN else ""
    return "did you mean " + " or ".join(found[:MOST_BEGUN]) + f"{more}?"


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
        if kind is not Kind.EXERCISES and not any(os.path.isdir(os.path.join(root, own)) for own in _OWN_FOLDERS):
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


def _files(folder: str | Path, *, nested: bool, below: str = "") -> Iterator[tuple[str, str]]:
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
                yield from _files(child.path, nested=False, below=f"{name}/")
        elif name.lower().endswith(YAML) and (child.is_file(follow_symlinks=False) or os.path.isfile(child.path)):
            yield below + name[: name.rindex(".")], child.path
