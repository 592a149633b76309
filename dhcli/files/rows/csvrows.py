"""Joint values from CSV: a header or none, whatever separates the cells; whole blocks at once while all is well."""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from dhcli.errors import FileError, Place, Problem, plural
from dhcli.files.rows.blocks import Block, Sieve, cell_problem
from dhcli.files.rows.cells import PLAIN, CellError, is_number, read_cell
from dhcli.files.rows.columns import Columns, columns_of, in_joint_order
from dhcli.files.rows.source import Source, text_blocks
from dhcli.kinematics.robot import Robot

if TYPE_CHECKING:
    from numpy.typing import NDArray

_BETWEEN_BLANKS = re.compile(r"\S+(?:[ ]+[\[(][^\])]*[\])])?")
"""A cell between blanks; a unit may stand apart from its name."""


class CsvRows:
    """Reads the rows of a CSV file.

    The first line is a header unless one of its cells is a number; without a header the columns are the joints in
    their order.
    """

    def __init__(self, source: Source, robot: Robot, *, degrees: bool) -> None:
        """Read the joint values of a robot; bare columns in radians and metres, or in degrees and metres."""
        self._source = source
        self._robot = robot
        self._degrees = degrees
        self._separator = ","

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
                if head.strip():
                    columns, is_header = self._columns(head, line)
                    if not is_header:
                        break
                line, body = line + 1, rest
            if columns is not None and body:
                yield self._block(line, body, columns)
        if columns is None:
            names = ",".join(self._robot.variables)
            raise FileError(Problem("is empty", Place(self._source.name), f"wanted: a header, {names}, and rows"))

    def _columns(self, head: str, line: int) -> tuple[Columns, bool]:
        """What the first line says of the columns, and whether it is a header."""
        # Commas last: between semicolons or tabs they are decimal ones, which are refused cell by cell.
        self._separator = next((sign for sign in ";\t," if sign in head), " " if " " in head.strip() else ",")
        if head.startswith("#"):  # numpy.savetxt writes headers like this
            head = " " + head[1:]
        cells = self._cells(head)
        if any(is_number(cell) for _, cell in cells):
            return in_joint_order(self._robot, degrees=self._degrees), False
        heads = [cell for _, cell in cells]
        places = [Place(self._source.name, line, column, head) for column, _ in cells]
        return columns_of(self._robot, heads, places, whole=self.place_of(line), degrees=self._degrees), True

    def _block(self, first: int, text: str, columns: Columns) -> Block:
        count = text.count("\n")
        table = self._at_once(text, count, len(columns.order))
        if table is not None:
            return Block(columns.values(table), range(first, first + count), columns.in_radians)
        return self._line_by_line(first, text, columns)

    def _at_once(self, text: str, count: int, width: int) -> NDArray[np.float64] | None:
        """All rows of a block, shape (count, width), if there is nothing to say about any of them."""
        if text.encode().translate(None, PLAIN + self._separator.encode()) or text.isspace():
            return None
        try:
            separator = None if self._separator == " " else self._separator
            table = np.loadtxt(io.StringIO(text), delimiter=separator, comments=None, ndmin=2)
        except ValueError:
            return None
        return table if table.shape == (count, width) and np.isfinite(table).all() else None

    def _line_by_line(self, first: int, text: str, columns: Columns) -> Block:
        """The same with an eye on every cell."""
        sieve, width = Sieve(), len(columns.order)
        names = dict(zip(columns.order, self._robot.variables, strict=True))
        for row, line in enumerate(text.split("\n")[:-1], first):
            if not line.strip():
                continue
            cells = self._cells(line)
            if len(cells) != width:
                message = f"{plural(len(cells), 'cell')} in a table of {plural(width, 'column')}"
                sieve.refuse([Problem(message, Place(self._source.name, row, None, line))])
                continue
            values, problems = [], []
            for k, (column, cell) in enumerate(cells):
                try:
                    values.append(read_cell(cell))
                except CellError as error:
                    problems.append(cell_problem(names[k], error, Place(self._source.name, row, column, line)))
            if problems:
                sieve.refuse(problems)
            else:
                sieve.good(row, values)
        q = columns.values(sieve.table(width))
        return Block(q, sieve.rows, columns.in_radians, tuple(sieve.bad), sieve.bad_rows)

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
