"""What a name or a file is: a robot, a linkage or an exercise."""

from __future__ import annotations

from collections.abc import Sequence
from os.path import isdir, isfile

from dhcli.errors import FileError, UnknownNameError, joined
from dhcli.files.library.lookup import YAML, Kind, above, entries, full_id, similar
from dhcli.files.reading import read_text

_SIGNS = {
    **dict.fromkeys(("parts:", "task:", "tests:", "numeric:"), Kind.EXERCISES),
    **dict.fromkeys(("joints:", "chain:", "bars:", "loop:", "lambda:", "space:"), Kind.LINKAGES),
}
"""Keys at the left of a file that tell what it is; a robot has none of them."""


def kind_of(name: str) -> Kind:
    """The kind of a name of the library, or of a file by its content; a robot if nothing tells.

    Args:
        name: A name, a path, or `-`, which is taken for a robot without being read.
    """
    if name.endswith(YAML):
        return _kind_of_file(name)
    for kind, wanted in ((Kind.EXERCISES, full_id(name)), (Kind.LINKAGES, name)):
        if any(entry.name == wanted for entry in entries(kind)):
            return kind
    course, slash, rest = name.partition("/")
    is_id = slash and "/" not in rest and course.strip("~.") and not isfile(name)
    if is_id and (not isdir(course) or any(entry.name.startswith(f"{course}/") for entry in entries(Kind.EXERCISES))):
        return Kind.EXERCISES  # misspelled, and whoever loads it says so
    return Kind.ROBOTS


def unknown(name: str, kinds: Sequence[Kind], error: UnknownNameError) -> UnknownNameError:
    """The error for a name that nothing of several kinds has.

    Args:
        name: What was typed.
        kinds: What could be meant, the likeliest first.
        error: What was said when one of the kinds was searched.
    """
    nouns = [f"no {kind.noun}" for kind in kinds]
    said = error.problems[0].hint.partition("; dhcli list")[0]
    said = next(filter(None, (above(kind, name) for kind in kinds)), said)
    near = said if said and not said.startswith(("did you mean", "dhcli list")) else similar(name, kinds)
    hint = "; ".join(filter(None, (near, "dhcli list shows what there is")))
    return UnknownNameError(f"there is {joined(nouns)} '{name}'", hint)


def _kind_of_file(path: str) -> Kind:
    try:
        lines = read_text(path).splitlines()
    except FileError:
        return Kind.ROBOTS  # whoever loads it says what is wrong
    found = (kind for line in lines for key, kind in _SIGNS.items() if line.startswith(key))
    return next(found, Kind.ROBOTS)
