"""Joint values from CSV: a header or none, whatever separates the cells; whole blocks at once while all is well."""

from __future__ import annotations

import csv
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from dhcli.errors import FileError, Place, Problem, plural
from dhcli.files.rows.blocks import Block, Sieve, cell_problem
from dhcli.files.rows.cells import CellError, is_number, plain_table, read_cell
from dhcli.files.rows.columns import JointColumns, JointTable
from dhcli.files.rows.source import Source, text_blocks
from dhcli.regex import regex

if TYPE_CHECKING:
    from numpy.typing import NDArray

DECLARED = regex(r'\s*"?sep=(?P<sign>[;,\t|])"?\s*', re.IGNORECASE)
"""The line with which Excel says what stands between cells."""

SIGNS = ";\t,"
"""What may stand between cells. Commas last: between the others they are decimal ones."""
DECIMAL_BETWEEN = (";", "\t")

_BETWEEN_BLANKS = regex(r"\S+(?:[ ]{1,40}[\[(][^\])]{0,40}[\])])?")
"""A cell between blanks; a unit may stand apart from its name."""


class CsvRows:
    """Reads the rows of a CSV file.

    The first line is a header unless one of its cells is a number; without a header the columns are the joints in
    their order. A line that begins with `#` says nothing, unless it is the first and names a joint. Between semicolons
    or tabs a comma in a number is a decimal one.
    """

    def __init__(self, source: Source, asked: JointTable) -> None:
        """Read the joint values of a robot."""
        self._source = source
        self._asked = asked
        self._separator = ""

    def place_of(self, row: int) -> Place:
        """Where a row stands."""
        return Place(self._source.name, row)

    def blocks(self) -> Iterator[Block]:
        """The rows.

        Raises:
            FileError: The header is not that of a table for this robot, or the source cannot be read.
        """
        columns: JointColumns | None = None
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
            if columns is not None and body:
                yield self._block(line, body, columns)
        if columns is None:
            names = ",".join(joint.name for joint in self._asked.open)
            raise FileError(Problem("is empty", Place(self._source.name), f"wanted: a header, {names}, and rows"))

    def _columns(self, head: str, line: int) -> tuple[JointColumns | None, bool]:
        """What the first line says of the columns, nothing if it is a comment; and whether it is a header."""
        declared = self._separator
        self._separator = declared or next(
            (sign for sign in SIGNS if sign in head), " " if " " in head.strip() else ","
        )
        is_comment = head.startswith("#")
        if is_comment:  # numpy.savetxt writes headers like this
            head = " " + head[1:]
        cells = self._cells(head)
        if is_comment and not any(self._asked.is_joint(cell) for _, cell in cells):
            self._separator = declared
            return None, False
        if any(is_number(cell) for _, cell in cells):
            return self._asked.in_joint_order(), False
        if len(cells) > 1 and not cells[-1][1].strip():  # a separator at the end of each line
            cells.pop()
        heads = [cell for _, cell in cells]
        places = [Place(self._source.name, line, column, head) for column, _ in cells]
        return self._asked.columns(heads, places, self.place_of(line)), True

    def _block(self, first: int, text: str, columns: JointColumns) -> Block:
        count = text.count("\n")
        table = self._at_once(text, count, columns.width)
        if table is not None:
            return Block(columns.values(table), range(first, first + count), columns.in_radians)
        return self._line_by_line(first, text, columns)

    def _at_once(self, text: str, count: int, width: int) -> NDArray[np.float64] | None:
        """All rows of a block, shape (count, width), if there is nothing to say about any of them."""
        if self._has_decimal_commas and "." not in text:
            text = text.replace(",", ".")
        text = text.replace(f"{self._separator}\n", "\n")  # of a line that has a cell too few without it, too
        table = plain_table(text, self._separator, width)
        return table if table is not None and len(table) == count and np.isfinite(table).all() else None

    def _line_by_line(self, first: int, text: str, columns: JointColumns) -> Block:
        """The same with an eye on every cell."""
        sieve, width = Sieve(), columns.width
        names = {k: name for k, name in zip(columns.order, self._asked.robot.variables, strict=True) if k is not None}
        for row, line in enumerate(text.split("\n")[:-1], first):
            if not line.strip() or line.startswith("#"):
                continue
            cells = self._cells(line)
            if len(cells) == width + 1 and not cells[-1][1].strip():
                cells.pop()
            has_point = any("." in cell for _, cell in cells)
            if len(cells) != width:
                message = f"{plural(len(cells), 'cell')} in a table of {plural(width, 'column')}"
                sieve.refuse([Problem(message, Place(self._source.name, row, None, line))])
                continue
            values, problems = [0.0] * width, []
            for k, (column, cell) in enumerate(cells):
                if k not in names:
                    continue
                try:
                    values[k] = read_cell(
                        cell, decimal_comma=self._has_decimal_commas and not has_point, units_in_header=True
                    )
                except CellError as error:
                    problems.append(cell_problem(names[k], error, Place(self._source.name, row, column, line)))
            if problems:
                sieve.refuse(problems)
            else:
                sieve.good(row, values)
        q = columns.values(sieve.table(width))
        return Block(q, sieve.rows, columns.in_radians, tuple(sieve.bad), sieve.bad_rows)

    @property
    def _has_decimal_commas(self) -> bool:
        """Whether a comma can be nothing else; beside a number with a point it might group thousands, all the same."""
        return self._separator in DECIMAL_BETWEEN

    def _cells(self, line: str) -> list[tuple[int, str]]:
        """The cells of a line with the columns where they begin, from 1."""
        if self._separator == " ":
            return [(match.start() + 1, match[0]) for match in _BETWEEN_BLANKS.finditer(line)]
        texts = self._unquoted(line) if '"' in line else line.split(self._separator)
        found, end = [], 0
        for text in texts:
            start = max(line.find(text, end), end)
            found.append((start + 1 + len(text) - len(text.lstrip()), text))
            end = start + len(text) + 1
        return found

    def _unquoted(self, line: str) -> list[str]:
        """The cells of a line with quotes."""
        try:
            return next(csv.reader([line], delimiter=self._separator))
        except csv.Error:  # a cell longer than any number
            return [line]
