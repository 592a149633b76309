"""The list of what there is: name, joints, title, origin, a row each."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import groupby
from typing import Any

from dhcli.files.library.catalogue import Listed
from dhcli.files.library.entries import BUILT_IN, Kind
from dhcli.render.code.matrices import csv_line
from dhcli.render.look import Look
from dhcli.render.paper import WIDE
from dhcli.render.text.table import Inked, table_text
from dhcli.safe import csv_cell


def library_table(listed: Sequence[Listed], look: Look) -> str:
    """A table for each kind, its titles whole."""
    tables = []
    for kind, group in groupby(listed, key=lambda one: one.kind):
        listed_here = list(group)
        solved = ["solved"] if any(one.solved for one in listed_here) else []
        # In a narrow window what is the same in every row leaves its place to titles, and so do joints of exercises.
        is_narrow = look.paper.terminal and look.paper.width < WIDE
        origin = [] if is_narrow and all(one.entry.origin == BUILT_IN for one in listed_here) else ["from"]
        joints = [] if is_narrow and kind is Kind.EXERCISES else ["joints"]
        heads = [kind.value, *joints, *solved, "title", *origin]
        cells = [{**_cells(one, look), kind.value: _name(one, look)} for one in listed_here]
        rows = [[row[head] for head in heads] for row in cells]
        tables.append(table_text(heads, rows, look.paper, fold="title"))
    return "\n".join(tables)


def library_csv(listed: Sequence[Listed], _look: Look) -> str:
    """One line for each file."""
    lines = [csv_line(["kind", "name", "joints", "title", "origin", "path"])]
    for one in listed:
        entry = one.entry
        lines.append(
            csv_line(map(csv_cell, (one.kind.noun, entry.name, one.joints, one.title, entry.origin, str(entry.path))))
        )
    return "".join(lines)


def library_content(listed: Sequence[Listed], _look: Look) -> dict[str, Any]:
    """The list as JSON holds it."""
    return {
        "entries": [
            {
                "kind": one.kind.noun,
                "name": one.entry.name,
                "joints": one.joints,
                "solved": one.solved,
                "title": one.title,
                "origin": one.entry.origin,
                "path": str(one.entry.path),
                "shadowed": one.entry.shadowed,
                "broken": bool(one.problems),
            }
            for one in listed
        ]
    }


def _name(one: Listed, look: Look) -> str:
    return Inked(look.paper.ink(look.paper.spell(one.entry.name), "cyan"))


def _cells(one: Listed, look: Look) -> dict[str, str]:
    """What may stand behind the name, by its head."""
    paper = look.paper
    if one.problems:
        more = f" (and {len(one.problems) - 1} more)" if len(one.problems) > 1 else ""
        place = one.problems[0].place
        where = ":".join(str(part) for part in (place.line, place.column) if part) if place else ""
        text = f"broken: {where + ': ' if where else ''}{one.problems[0].message}{more}"
        title = paper.ink(paper.spell(text), "red")
    elif one.entry.shadowed:
        title = paper.ink(paper.spell(f"hidden by the one above of this name: {one.title}"), "dim")
    else:
        title = paper.spell(one.title)
    origin = Inked(paper.ink(paper.spell(one.entry.origin), "dim"))
    return {"joints": one.joints or "-", "solved": one.solved or "-", "title": Inked(title), "from": origin}
