"""Rows from a .npy file, read piece by piece: never all of it, never a pickled object."""

from __future__ import annotations

import io
import math
from collections.abc import Iterator
from tokenize import TokenError
from typing import TYPE_CHECKING, Any

import numpy as np

from dhcli.errors import FileError, Place, Problem, plural
from dhcli.files.rows.blocks import MOST, Block, cell_problem
from dhcli.files.rows.cells import CellError
from dhcli.files.rows.columns import JointTable
from dhcli.files.rows.source import Source
from dhcli.kinematics.many import are_finite
from dhcli.kinematics.playing import BLOCK

if TYPE_CHECKING:
    from numpy.typing import NDArray

MAGIC = b"\x93NUMPY"
_HEADER = 1 << 16
"""Most bytes of a header; those of plain arrays have 128."""
ROWS = 4 * BLOCK
"""Most rows at a time, and as many for each of some threads."""
MOST_BYTES = 1 << 20
"""Most bytes of those, unless one row has more."""
MOST_THREADS = 4
"""Threads up to which blocks grow; more share one of that length, and memory stays small."""
_SAVE = "np.save('q.npy', np.ascontiguousarray(Q, dtype=float))"
"""What makes a file that is read."""
_PLAIN = "np.save('q.npy', np.lib.recfunctions.structured_to_unstructured(Q))"
"""What makes one of an array whose columns have names."""


def place_in_array(source: Source, row: int) -> Place:
    """Where a row stands, as numpy counts: from 0."""
    return Place(f"{source.name}[{row}]")


class NpyArray:
    """An array in a stream.

    Attributes:
        shape: Its shape, as its header promises.
    """

    def __init__(self, source: Source) -> None:
        """Read what the header says.

        Raises:
            FileError: It is none that can be read.
        """
        self._source = source
        self.shape, self._is_fortran, self._kind = self._described()

    def check(self, *, is_wanted: bool, wanted: str, hint: str = "") -> None:
        """Make sure that it holds rows of real numbers.

        Args:
            is_wanted: Whether its shape is right.
            wanted: What is said of one that is not.
            hint: What would be right.

        Raises:
            FileError: It holds something else.
        """
        place = Place(self._source.name)
        if self._kind.kind not in "fiu":
            what, how = (self._kind.name, _SAVE) if self._kind.names is None else ("records", _PLAIN)
            raise FileError(Problem(f"holds {what}, not real numbers", place, how))
        if not is_wanted:
            raise FileError(Problem(f"has the shape {self.shape}, and {wanted}", place, hint))
        if self.shape[0] < 0:
            raise FileError(Problem(f"promises {self.shape[0]} rows", place, _SAVE))

    def pieces(self, most: int) -> Iterator[tuple[int, NDArray[np.float64]]]:
        """The numbers of the first row of a piece, and the rows of it.

        Args:
            most: Most rows of a piece.

        Raises:
            FileError: It is cut off.
        """
        count, each = self.shape[0], self.shape[1:]
        at_once = count if self._is_fortran else most  # stored column by column, the first row is not there before all
        for begun in range(0, count, at_once or 1):
            wanted = min(at_once, count - begun)
            content = self._bytes(wanted * self.row_bytes)
            if (whole := len(content) // self.row_bytes) < wanted:
                message = f"is cut off: it holds {begun + whole} of the {plural(count, 'row')} that it promises"
                raise FileError(Problem(message, Place(self._source.name)))
            rows = np.frombuffer(content, self._kind).reshape(wanted, *each, order="F" if self._is_fortran else "C")
            for first in range(0, wanted, most):
                yield begun + first, rows[first : first + most].astype(np.float64, order="C", copy=False)

    @property
    def row_bytes(self) -> int:
        """Bytes of a row."""
        return math.prod(self.shape[1:]) * self._kind.itemsize

    def _described(self) -> tuple[tuple[int, ...], bool, np.dtype[Any]]:
        """What the header says; numpy reads it as a literal, and runs nothing."""
        stream = io.BytesIO(self._source.peek(_HEADER))
        try:
            version = np.lib.format.read_magic(stream)
            read = {(1, 0): np.lib.format.read_array_header_1_0, (2, 0): np.lib.format.read_array_header_2_0}[version]
            described = read(stream)
        except (ValueError, KeyError, EOFError, SyntaxError, TypeError, RecursionError, TokenError):
            # numpy promises the first only, and lets through what Python says of a literal that is none.
            raise FileError(Problem("is no .npy file that can be read", Place(self._source.name), _SAVE)) from None
        self._bytes(stream.tell())
        return described

    def _bytes(self, count: int) -> bytes:
        """The next bytes, all of them unless the source ends."""
        pieces = []
        while count and (piece := self._source.read(count)):
            pieces.append(piece)
            count -= len(piece)
        return b"".join(pieces)


class NpyRows:
    """Reads the rows of an array, shape (N, n), joints in their order; what follows them is nobody's joint."""

    def __init__(self, source: Source, asked: JointTable, threads: int) -> None:
        """Read the joint values of a robot, blocks long enough for so many threads."""
        self._source = source
        self._threads = min(threads, MOST_THREADS)
        self._asked = asked
        self._columns = asked.in_order()

    def place_of(self, row: int) -> Place:
        """Where a row stands, as numpy counts: from 0."""
        return place_in_array(self._source, row)

    def blocks(self) -> Iterator[Block]:
        """The rows.

        Raises:
            FileError: It is no array of numbers with a column for each joint, or it is cut off.
        """
        array = NpyArray(self._source)
        self._check(array)
        at_once = min(ROWS, max(1, MOST_BYTES // array.row_bytes)) * self._threads
        for first, table in array.pieces(at_once):
            yield self._block(first, table)

    def _check(self, array: NpyArray) -> None:
        """Make sure that the array has a column for each joint, and nothing else unless that is left aside."""
        shape, joints = array.shape, len(self._asked.open)
        self._columns = self._asked.in_order(shape[-1] if shape else 0)
        is_table = len(shape) == 2  # noqa: PLR2004  rows and columns
        hint = "one pose is Q.reshape(1, -1)" if shape == (joints,) else ""
        if is_table and shape[1] > joints:
            hint = f"--ignore-columns takes the first {plural(joints, 'column')}"
        if is_table and shape[1] == joints + 1:
            hint += "; where the numbers of rows stand in front, save Q[:, 1:]"
        wanted = f"{self._asked.robot.name} has {plural(joints, 'joint')}: (N, {joints}) is wanted"
        array.check(is_wanted=is_table and shape[1] == self._columns.width, wanted=wanted, hint=hint)

    def _block(self, first: int, table: NDArray[np.float64]) -> Block:
        columns = self._columns
        if are_finite(table) or np.isfinite(table).all():
            return Block(columns.values(table), range(first, first + len(table)), columns.in_radians)
        finite = np.isfinite(table[:, : len(self._asked.open)])
        good = finite.all(axis=1)
        bad = []
        for row, k in np.argwhere(~finite)[:MOST]:
            error = CellError(f"is {table[row, k]}, not a finite number")
            bad.append(cell_problem(self._asked.open[k].name, error, self.place_of(first + row)))
        rows = (first + np.flatnonzero(good)).tolist()
        return Block(columns.values(table[good]), rows, columns.in_radians, tuple(bad), int((~good).sum()))
