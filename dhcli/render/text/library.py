"""The list of what there is: name, joints, title, origin, one line each."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import groupby
from typing import Any

from dhcli.files.library.catalogue import Listed
from dhcli.files.library.lookup import BUILT_IN
from dhcli.render.code.matrices import csv_line
from dhcli.render.look import Look
from dhcli.render.paper import WIDE
from dhcli.render.text.table import Inked, table_text
from dhcli.safe import csv_cell


def library_table(listed: Sequence[Listed], look: Look) -> str:
    """A table for each kind."""
    tables = []
    for kind, group in groupby(listed, key=lambda one: one.kind):
        listed_here = list(group)
        solved = ["solved"] if any(one.solved for one in listed_here) else []
        # In a narrow window what is the same in every row leaves its place to the titles.
        is_narrow = look.paper.terminal and look.paper.width < WIDE
        origin = [] if is_narrow and all(one.entry.origin == BUILT_IN for one in listed_here) else ["from"]
        rows = [_row(one, look, with_solved=bool(solved), with_origin=bool(origin)) for one in listed_here]
        heads = [kind.value, "joints", *solved, "title", *origin]
        tables.append(table_text(heads, rows, look.paper, cut="title"))
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


def _row(one: Listed, look: Look, *, with_solved: bool, with_origin: bool) -> list[str]:
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
    return [
        Inked(paper.ink(paper.spell(one.entry.name), "cyan")),
        one.joints or "-",
        *([one.solved or "-"] if with_solved else []),
        Inked(title),
        *([Inked(paper.ink(paper.spell(one.entry.origin), "dim"))] if with_origin else []),
    ]
