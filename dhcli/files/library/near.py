"""What a name may mean that the library does not hold: names like it, and things elsewhere."""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from pathlib import Path

from dhcli.errors import UnknownNameError, did_you_mean, joined, nearest
from dhcli.files.library.entries import YAML, Entry, Kind, entries, files_in, full_id, holds

MOST_BEGUN = 4
"""Names that are suggested for the beginning of one."""
MOST_SIMILAR = 3
"""Names that are suggested for one that is misspelled."""
AS_SIMILAR = 0.1
"""How much less like it a name may be than the nearest of all kinds, to be suggested beside it."""
LEAST_TYPED = 3
"""Letters by which names are found that hold them anywhere."""


def instead(kind: Kind, name: str, known: tuple[Entry, ...]) -> str:
    """What to type instead of an unknown name."""
    begun = _begun(name, known)
    hints = [begun or similar(name, (kind,)) or did_you_mean(name, [entry.name for entry in known])]
    for other in Kind:
        called = full_id(name) if other is Kind.EXERCISES else name
        if other is not kind and holds(other, called):
            hints = [f"'{name}' is the name of a{'n' if other is Kind.EXERCISES else ''} {other.noun}", begun]
    for path in (name, *(name + suffix for suffix in YAML)):
        if os.path.isfile(path):
            hints = [f"for the file in this folder type ./{path}"]
    if found := above(kind, name):
        hints = [found]
    return "; ".join(hint for hint in (*hints, f"dhcli list {kind.value} shows what there is") if hint)


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


def above(kind: Kind, name: str) -> str:
    """A hint at something of this name in the library of a folder above the current one; empty if there is none."""
    up = ""
    for folder in Path.cwd().parents:
        up += "../"
        for found, path in files_in(folder / kind.folder, nested=kind is Kind.EXERCISES):
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
