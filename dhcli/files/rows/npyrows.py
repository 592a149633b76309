"""Joint values from a .npy file, read piece by piece: never all of it, never a pickled object."""

from __future__ import annotations

import io
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


class NpyRows:
    """Reads the rows of an array, shape (N, n), joints in their order; what follows them is nobody's joint."""

    def __init__(self, source: Source, asked: JointTable, threads: int) -> None:
        """Read the joint values of a robot, blocks long enough for so many threads."""
        self._source = source
        self._threads = min(threads, MOST_THREADS)
        self._asked = asked
        self._columns = asked.in_joint_order()

    def place_of(self, row: int) -> Place:
        """Where a row stands, as numpy counts: from 0."""
        return Place(f"{self._source.name}[{row}]")

    def blocks(self) -> Iterator[Block]:
        """The rows.

        Raises:
            FileError: It is no array of numbers with a column for each joint, or it is cut off.
        """
        count, kind = self._header()
        width = self._columns.width
        at_once = min(ROWS, max(1, MOST_BYTES // (width * kind.itemsize))) * self._threads
        for first in range(0, count, at_once):
            wanted = min(at_once, count - first)
            content = self._bytes(wanted * width * kind.itemsize)
            whole = len(content) // (width * kind.itemsize)
            if whole < wanted:
                message = f"is cut off: it holds {first + whole} of the {plural(count, 'row')} that it promises"
                raise FileError(Problem(message, Place(self._source.name)))
            yield self._block(first, np.frombuffer(content, kind).reshape(wanted, width).astype(np.float64, copy=False))

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

    def _header(self) -> tuple[int, np.dtype[Any]]:
        """How many rows there are, and what kind of number is in them."""
        shape, is_fortran, kind = self._described()
        place, joints = Place(self._source.name), len(self._asked.open)
        self._columns = self._asked.in_joint_order(shape[-1] if shape else 0)
        if len(shape) != 2 or shape[1] != self._columns.width:  # noqa: PLR2004  rows and columns
            has = f"{self._asked.robot.name} has {plural(joints, 'joint')}"
            message = f"has the shape {shape}, and {has}: (N, {joints}) is wanted"
            hint = "one pose is Q.reshape(1, -1)" if shape == (joints,) else ""
            if len(shape) == 2 and shape[1] > joints:  # noqa: PLR2004
                hint = f"--ignore-columns takes the first {plural(joints, 'column')}"
            if len(shape) == 2 and shape[1] == joints + 1:  # noqa: PLR2004
                hint += "; where the numbers of rows stand in front, save Q[:, 1:]"
            raise FileError(Problem(message, place, hint))
        if shape[0] < 0:
            raise FileError(Problem(f"promises {shape[0]} rows", place, _SAVE))
        if kind.kind not in "fiu":
            message = f"holds {kind.name if kind.names is None else 'records'}, not real numbers"
            raise FileError(Problem(message, place, _SAVE))
        if is_fortran and min(shape) > 1:
            raise FileError(Problem("is stored column by column, and is read row by row", place, _SAVE))
        return shape[0], kind

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
