"""Rows of numbers in numpy's own format, without holding them all."""

from __future__ import annotations

import shutil
import tempfile
from types import TracebackType
from typing import TYPE_CHECKING, BinaryIO, Self

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray


class NpyWriter:
    """Writes a .npy file of rows whose number is not known before the last one.

    The header says how many there are, and it comes first: it is written again at the end. A stream that cannot be
    turned back, such as a pipe, gets all of it then, from a temporary file.

    Attributes:
        count: Rows written so far.
    """

    def __init__(self, stream: BinaryIO, shape: tuple[int, ...]) -> None:
        """Write rows of a shape, as float64, to the beginning of a stream."""
        self.count = 0
        self._shape = shape
        self._target = stream
        self._spool = None if stream.seekable() else tempfile.TemporaryFile()  # noqa: SIM115  closed by `__exit__`
        self._stream: BinaryIO = self._spool or stream
        self._length = self._header()

    def write(self, block: NDArray[np.float64]) -> None:
        """Append rows, shape (N, ...) with as many numbers a row as the shape has."""
        self._stream.write(np.ascontiguousarray(block, dtype="<f8").data)
        self.count += len(block)

    def __enter__(self) -> Self:
        """Itself."""
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        """Write the header that tells the truth, unless something went wrong."""
        try:
            if kind is None:
                self._stream.seek(0)
                assert self._header() == self._length, "numpy leaves room for any number of rows"  # noqa: S101
                self._stream.seek(0, 2)
                if self._spool is not None:
                    self._spool.seek(0)
                    shutil.copyfileobj(self._spool, self._target)
        finally:
            if self._spool is not None:
                self._spool.close()

    def _header(self) -> int:
        """Write the header for the rows so far; its length in bytes."""
        header = {"descr": "<f8", "fortran_order": False, "shape": (self.count, *self._shape)}
        np.lib.format.write_array_header_1_0(self._stream, header)
        return self._stream.tell()
