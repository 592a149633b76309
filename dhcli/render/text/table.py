"""Tables drawn by rich: as wide as they need to be, folded nowhere, with nothing read as markup."""

from __future__ import annotations

import io
import re
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

from dhcli.render.paper import Paper

if TYPE_CHECKING:
    from rich.text import Text

_UNFOLDED = 10_000
_GAP = 3
_LEAST = 12
"""Columns between two cells, and the fewest that a cell is cut to."""
_COLOURS = re.compile(r"\x1b\[[0-9;]*m")
_ASCII_BOX = "    \n    \n -- \n    \n    \n    \n    \n    \n"


def table_text(heads: Sequence[str], rows: Iterable[Sequence[str | Text]], paper: Paper, *, cut: str = "") -> str:
    """A table with a line under its heads.

    Args:
        heads: The heads of the columns.
        rows: The cells.
        paper: What it is written on.
        cut: Head of the column that may be cut, with an ellipsis, to fit a terminal; none by default.
    """
    from rich.box import SIMPLE_HEAD, Box
    from rich.console import Console
    from rich.table import Table
    from rich.text import Text

    table = Table(
        box=SIMPLE_HEAD if paper.unicode else Box(_ASCII_BOX, ascii=True), pad_edge=False, header_style="bold"
    )
    table.border_style = "dim"
    cells = [[Text(paper.spell(cell)) if isinstance(cell, str) else cell for cell in row] for row in rows]
    needed = 2 - _GAP  # a blank at either edge, and gaps between the cells only
    for i, head in enumerate(heads):
        # Only a column that might wrap gives way when the table is too wide; its cells are cut, they do not wrap.
        table.add_column(Text(paper.spell(head)), no_wrap=head != cut, overflow="ellipsis")
        column = [row[i] for row in cells]
        needed += _GAP + (_LEAST if head == cut else max(len(head), *(text.cell_len for text in column), 0))
        for text in column:
            text.no_wrap = True
    for row in cells:
        table.add_row(*row)
    room = paper.width if paper.unicode else paper.width - 2  # where ASCII writes an ellipsis as three dots
    drawn = io.StringIO()
    console = Console(
        file=drawn,
        width=max(room, needed) if cut and paper.terminal else _UNFOLDED,
        force_terminal=paper.colour,
        color_system="standard" if paper.colour else None,
        no_color=not paper.colour,
        markup=False,
        highlight=False,
        emoji=False,
        legacy_windows=False,
    )
    console.print(table)
    lines = (line.rstrip() for line in drawn.getvalue().split("\n") if _COLOURS.sub("", line).strip())
    return "\n".join(lines) + "\n"
