"""Tables: as wide as they need to be; one column may be folded to fit a window."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable, Sequence

from dhcli.regex import regex
from dhcli.render.paper import Paper

_GAP = 3
_LEAST = 12
"""Columns between two cells, and the fewest that a cell is folded to."""
_INKED = regex(r"((?:\x1b\[[0-9;]*m)*)(.*?)((?:\x1b\[0m)*)", re.DOTALL)
_INK = regex(r"\x1b\[[0-9;]*m")


class Inked(str):
    """A cell in the letters and the colours of its paper already; any other text is spelled when it is drawn."""

    __slots__ = ()


def table_text(heads: Sequence[str], rows: Iterable[Sequence[str]], paper: Paper, *, fold: str = "") -> str:
    """A table with a line under its heads.

    Args:
        heads: The heads of the columns.
        rows: The cells.
        paper: What it is written on.
        fold: Head of the column whose cells take more lines where the table would be wider than a terminal; none by
            default.
    """
    cells = [[cell if isinstance(cell, Inked) else Inked(paper.spell(cell)) for cell in row] for row in rows]
    names = [paper.spell(head) for head in heads]
    widths = [max(map(columns_of, column)) for column in zip(names, *cells, strict=True)]
    if fold and paper.terminal:
        at = heads.index(fold)
        taken = sum(widths) - widths[at] + _GAP * (len(widths) - 1) + 2
        widths[at] = min(widths[at], max(paper.width - taken, _LEAST))
        cells = [line for row in cells for line in _folded(row, at, widths[at])]
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


def _folded(row: Sequence[Inked], at: int, width: int) -> list[list[Inked]]:
    """A row as lines: the further ones hold what the cell at a place has beyond a width, in its colours."""
    cell = row[at]
    if columns_of(cell) <= width:
        return [list(row)]
    found = _INKED.fullmatch(cell)
    before, text, after = found.groups() if found else ("", cell, "")
    lines = [Inked(f"{before}{line}{after}") for line in _lines(text, width)]
    rows = [row, *([[Inked()] * len(row)] * (len(lines) - 1))]
    return [[*row[:at], line, *row[at + 1 :]] for row, line in zip(rows, lines, strict=True)]


def _lines(text: str, width: int) -> list[str]:
    """A text on lines no wider, between words where it can be; wide letters count as the two columns they take."""
    lines = [""]
    for word in text.split():
        joined = f"{lines[-1]} {word}".lstrip()
        if columns_of(joined) <= width:
            lines[-1] = joined
            continue
        if lines[-1]:
            lines.append("")
        for letter in word:
            if columns_of(lines[-1] + letter) > width:
                lines.append("")
            lines[-1] += letter
    return lines
