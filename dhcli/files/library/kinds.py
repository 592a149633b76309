"""What a name or a file is: a robot, a linkage or an exercise."""

from __future__ import annotations

from dhcli.errors import FileError
from dhcli.files.library.lookup import Kind, entries
from dhcli.files.reading import read_text
from dhcli.files.yaml.exercises import full_id

_SIGNS = {
    "parts:": Kind.EXERCISES,
    **dict.fromkeys(("joints:", "chain:", "bars:", "loop:", "lambda:", "space:"), Kind.LINKAGES),
}
"""Keys at the left of a file that tell what it is; a robot has none of them."""


def kind_of(name: str) -> Kind:
    """The kind of a name of the library, or of a file by its content; a robot if nothing tells.

    Args:
        name: A name, a path, or `-`, which is taken for a robot without being read.
    """
    if name.endswith((".yaml", ".yml")):
        return _kind_of_file(name)
    for kind, wanted in ((Kind.EXERCISES, full_id(name)), (Kind.LINKAGES, name)):
        if any(entry.name == wanted for entry in entries(kind)):
            return kind
    return Kind.ROBOTS


def _kind_of_file(path: str) -> Kind:
    try:
        lines = read_text(path).splitlines()
    except FileError:
        return Kind.ROBOTS  # whoever loads it says what is wrong
    found = (kind for line in lines for key, kind in _SIGNS.items() if line.startswith(key))
    return next(found, Kind.ROBOTS)
