"""Rows from CSV: a header or none, whatever separates the cells; whole blocks at once while all is well."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import numpy as np

from dhcli.errors import FileError, Place, Problem, plural
from dhcli.files.rows.blocks import Block, Columns, Sieve, Table, cell_problem, sifted
from dhcli.files.rows.cells import (
    DECIMAL_BETWEEN,
    CellError,
    cells_of,
    decimals_in,
    is_number,
    other_sign,
    plain_table,
    read_cell,
    sign_between,
)
from dhcli.files.rows.source import Source, parted, text_blocks
from dhcli.notation.quantity import UNITS
from dhcli.regex import regex

if TYPE_CHECKING:
    from numpy.typing import NDArray

DECLARED = regex(r'\s*"?sep=(?P<sign>[;,\t|])"?\s*', re.IGNORECASE)
"""The line with which Excel says what stands between cells."""


class CsvRows:
    """Reads the rows of a CSV file.

    The first line is a header unless one of its cells is a number; without a header the columns are the joints in
    their order. A line that begins with `#` says nothing, unless it is the first and names what is asked for. Between
    semicolons, tabs or blanks a comma in a number is a decimal one.
    """

    def __init__(self, source: Source, asked: Table, most: int | None = None) -> None:
        """Read a table.

        Args:
            source: Where it stands.
            asked: What it is read for.
            most: Rows of a block; by default as many as come in a piece.
        """
        self._most = most
        self._source = source
        self._asked = asked
        self._separator = ""
        self._heads: list[str] = []

    def place_of(self, row: int) -> Place:
        """Where a row stands."""
        return Place(self._source.name, row)

    def blocks(self) -> Iterator[Block]:
        """The rows.

        Raises:
            FileError: The header is not that of a table for this robot, or the source cannot be read.
        """
        columns: Columns | None = None
        for first, text in text_blocks(self._source):
            line, body = first, text
            while columns is None and body:
                head, _, rest = body.partition("\n")
                if match := DECLARED.fullmatch(head):
                    self._separator = match["sign"]
                elif head.strip():
                    columns, is_header = self._columns(head, line)
                    if columns is not None and not is_header:
                        break
                line, body = line + 1, rest
            for start, part in parted(line, body, self._most):
                if columns is not None:
                    yield self._block(start, part, columns)
        if columns is None:
            names = ",".join(self._asked.wanted)
            raise FileError(Problem("is empty", Place(self._source.name), f"wanted: a header, {names}, and rows"))

    def _columns(self, head: str, line: int) -> tuple[Columns | None, bool]:
        """What the first line says of the columns, nothing if it is a comment; and whether it is a header."""
        declared = self._separator
        self._separator = declared or sign_between(head, len(self._asked.wanted))
        is_comment = head.startswith("#")
        if is_comment:  # numpy.savetxt writes headers like this
            head = " " + head[1:]
        cells = cells_of(head, self._separator)
        if is_comment and not any(self._asked.is_known(cell) for _, cell in cells):
            self._separator = declared
            return None, False
        if any(is_number(cell) for _, cell in cells):
            return self._asked.in_order(len(cells), self.place_of(line)), False
        if len(cells) > 1 and not cells[-1][1].strip():  # a separator at the end of each line
            cells.pop()
        self._heads = [cell.strip() for _, cell in cells]
        places = [Place(self._source.name, line, column, head) for column, _ in cells]
        return self._asked.columns(self._heads, places, self.place_of(line)), True

    def _block(self, first: int, text: str, columns: Columns) -> Block:
        count = text.count("\n")
        table = self._at_once(text, count, columns.width)
        if table is not None:
            return sifted(table, range(first, first + count), columns, self.place_of)
        return self._line_by_line(first, text, columns)

    def _at_once(self, text: str, count: int, width: int) -> NDArray[np.float64] | None:
        """All rows of a block, shape (count, width), if there is nothing to say about any of them."""
        if self._separator in DECIMAL_BETWEEN and "." not in text:
            text = text.replace(",", ".")
        text = text.replace(f"{self._separator}\n", "\n")  # of a line that has a cell too few without it, too
        table = plain_table(text, self._separator, width)
        return table if table is not None and len(table) == count and np.isfinite(table).all() else None

    def _line_by_line(self, first: int, text: str, columns: Columns) -> Block:
        """The same with an eye on every cell."""
        sieve = Sieve()
        for row, line in enumerate(text.split("\n")[:-1], first):
            if not line.strip() or line.startswith("#"):
                continue
            try:
                sieve.good(row, self._row(row, line, columns, text))
            except FileError as error:
                sieve.refuse(error.problems)
        return sieve.block(columns, self.place_of)

    def _row(self, row: int, line: str, columns: Columns, text: str) -> list[float]:
        """The numbers of a row, 0 where none is wanted.

        Raises:
            FileError: With all that is wrong.
        """
        width = columns.width
        cells = cells_of(line, self._separator)
        if len(cells) == width + 1 and not cells[-1][1].strip():
            cells.pop()
        if len(cells) != width:
            message, hint = other_sign(line, self._separator, width)
            message = message or f"{plural(len(cells), 'cell')} in a table of {plural(width, 'column')}"
            if line.count('"') % 2:
                hint = "a quote is not closed"
            elif not (hint or self._heads) and len(cells) > width:
                hint = f"--ignore-columns takes the first {plural(width, 'column')}"
            raise FileError(Problem(message, Place(self._source.name, row, None, line), hint))
        decimals = decimals_in([cell for _, cell in cells], self._separator, text)
        values, problems = [0.0] * width, []
        for k, name in columns.names.items():
            column, cell = cells[k]
            try:
                values[k] = read_cell(cell, decimals=decimals)
            except CellError as error:
                problems.append(cell_problem(name, error, Place(self._source.name, row, column, line)))
        if problems:
            message, hint = self._said_of_all([cell for _, cell in cells], line, width)
            raise FileError(Problem(message, Place(self._source.name, row, None, line), hint) if message else problems)
        return values

    def _said_of_all(self, cells: Sequence[str], line: str, width: int) -> tuple[str, str]:
        """What is wrong with a row as a whole, and what would be right; nothing where it is single cells."""
        bare = [cell.strip() for cell in cells]
        if bare == self._heads:
            return "is the header once more", "take it out"
        units = [cell.strip("[]()") for cell in bare]
        if any(units) and all(unit in UNITS or not unit for unit in units):
            heads = ",".join(
                f"{head}[{unit}]" if unit else head for head, unit in zip(self._heads, units, strict=False)
            )
            return "holds units, not numbers", f"they stand in the header: {heads}" if heads else ""
        return other_sign(line, self._separator, width)
