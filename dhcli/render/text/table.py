"""Tables: as wide as they need to be, folded nowhere."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable, Sequence

from dhcli.regex import regex
from dhcli.render.paper import Paper

_GAP = 3
_LEAST = 12
"""Columns between two cells, and the fewest that a cell is cut to."""
_INKED = regex(r"((?:\x1b\[[0-9;]*m)*)(.*?)((?:\x1b\[0m)*)", re.DOTALL)
_INK = regex(r"\x1b\[[0-9;]*m")


class Inked(str):
    """A cell in the letters and the colours of its paper already; any other text is spelled when it is drawn."""

    __slots__ = ()


def table_text(heads: Sequence[str], rows: Iterable[Sequence[str]], paper: Paper, *, cut: str = "") -> str:
    """A table with a line under its heads.

    Args:
        heads: The heads of the columns.
        rows: The cells.
        paper: What it is written on.
        cut: Head of the column that may be cut, with an ellipsis, to fit a terminal; none by default.
    """
    cells = [[cell if isinstance(cell, Inked) else Inked(paper.spell(cell)) for cell in row] for row in rows]
    names = [paper.spell(head) for head in heads]
    widths = [max(map(columns_of, column)) for column in zip(names, *cells, strict=True)]
    if cut and paper.terminal:
        at = heads.index(cut)
        room = paper.width if paper.unicode else paper.width - 2  # where ASCII writes an ellipsis as three dots
        taken = sum(widths) - widths[at] + _GAP * (len(widths) - 1) + 2
        widths[at] = min(widths[at], max(room - taken, _LEAST))
        for row in cells:
            row[at] = _cut(row[at], widths[at])
    rule = ("─" if paper.unicode else "-") * (sum(widths) + _GAP * (len(widths) - 1))
    lines = [_line([paper.ink(name, "bold") for name in names], widths), f" {paper.ink(rule, 'dim')}"]
    return "\n".join([*lines, *(_line(row, widths) for row in cells), ""])


def columns_of(text: str) -> int:
    """Columns that a text takes on a terminal: none for colours and accents, two for wide letters."""
    plain = _INK.sub("", text)
    if plain.isascii():
        return len(plain)
    wide = sum(unicodedata.east_asian_width(letter) in "WF" for letter in plain)
    return len(plain) + wide - sum(map(bool, map(unicodedata.combining, plain)))


def _line(cells: Sequence[str], widths: Sequence[int]) -> str:
    padded = (cell + " " * (width - columns_of(cell)) for cell, width in zip(cells, widths, strict=True))
    return f" {(' ' * _GAP).join(padded)}".rstrip()


def _cut(cell: Inked, width: int) -> Inked:
    """A cell that is no wider, in its colours."""
    if columns_of(cell) <= width:
        return cell
    found = _INKED.fullmatch(cell)
    before, text, after = found.groups() if found else ("", cell, "")
    while columns_of(text) > width - 1:
        text = text[:-1]
    return Inked(f"{before}{text}…{after}")
