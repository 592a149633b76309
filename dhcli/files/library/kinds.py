"""What a name or a file is: a robot, a linkage or an exercise."""

from __future__ import annotations

from os.path import isdir, isfile

from dhcli.errors import FileError
from dhcli.files.keys.linkages import SIGNS
from dhcli.files.library.entries import YAML, Kind, entries, full_id, holds
from dhcli.files.reading import read_text

_SIGNS = {
    **dict.fromkeys(("convention:", "variables:"), Kind.ROBOTS),
    **dict.fromkeys(("parts:", "task:", "tests:", "numeric:"), Kind.EXERCISES),
    **dict.fromkeys((f"{key}:" for key in SIGNS), Kind.LINKAGES),
}
"""Keys at the left of a file that tell what it is, the first of them."""


def kind_of(name: str) -> Kind:
    """The kind of a name of the library, or of a file by its content; a robot if nothing tells.

    Args:
        name: A name, a path, or `-`, which is taken for a robot without being read.
    """
    if name.endswith(YAML):
        return _kind_of_file(name)
    for kind, wanted in ((Kind.EXERCISES, full_id(name)), (Kind.LINKAGES, name)):
        if holds(kind, wanted):
            return kind
    course, slash, rest = name.partition("/")
    is_id = slash and "/" not in rest and course.strip("~.") and not isfile(name)
    if is_id and (not isdir(course) or any(entry.name.startswith(f"{course}/") for entry in entries(Kind.EXERCISES))):
        return Kind.EXERCISES  # misspelled, and whoever loads it says so
    return Kind.ROBOTS


def _kind_of_file(path: str) -> Kind:
    try:
        lines = read_text(path).splitlines()
    except FileError:
        return Kind.ROBOTS  # whoever loads it says what is wrong
    found = (kind for line in lines for key, kind in _SIGNS.items() if line.startswith(key))
    return next(found, Kind.ROBOTS)
