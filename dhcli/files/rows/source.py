"""Where rows come from: a file or standard input, piece by piece, each as soon as it is there."""

from __future__ import annotations

import os
import stat
from collections.abc import Iterator
from contextlib import contextmanager
from typing import BinaryIO

from dhcli.errors import FileError, Place, Problem
from dhcli.files.reading import decode, explain, source_of, standard_input

PIECE = 1 << 18
"""Most bytes of one piece, and of one line [B]: some thousand rows, which keeps memory small and numpy busy."""


class Source:
    """A stream of bytes that knows what it is called and how far it is read.

    Attributes:
        path: The path as it was typed; `-` for standard input.
        name: What to call it in messages.
        size: Its length [B], or None where nobody knows, such as in a pipe.
        taken: Bytes read so far.
    """

    def __init__(self, path: str, stream: BinaryIO) -> None:
        """Read from an open stream."""
        self.path = path
        self.name = source_of(path)
        self.size = _size_of(stream)
        self.taken = 0
        self._stream = stream
        self._ahead = b""

    @property
    def share(self) -> float | None:
        """Which share of it is read, or None where nobody knows."""
        return min(1.0, self.taken / self.size) if self.size else None

    def peek(self, count: int) -> bytes:
        """The next bytes, which stay to be read; fewer at the end."""
        while len(self._ahead) < count and (piece := self._piece(PIECE)):
            self._ahead += piece
        return self._ahead[:count]

    def read(self, most: int = PIECE) -> bytes:
        """The next bytes, as soon as there are any; none at the end.

        Raises:
            FileError: They cannot be read.
        """
        piece, self._ahead = (self._ahead[:most], self._ahead[most:]) if self._ahead else (self._piece(most), b"")
        self.taken += len(piece)
        return piece

    def _piece(self, most: int) -> bytes:
        try:
            return self._stream.read1(most)  # type: ignore[attr-defined, no-any-return]  # what `open` gives has it
        except OSError as error:
            raise FileError(explain(error, self.name, self.path)) from None


@contextmanager
def open_source(path: str) -> Iterator[Source]:
    """A file, or standard input for `-`, opened to be read once from front to back.

    Raises:
        FileError: It cannot be opened.
    """
    name = source_of(path)
    if path == "-":
        yield Source(path, standard_input())
        return
    try:
        opened = open(path, "rb")  # noqa: SIM115  closed below; what fails there is not explained as this is
    except OSError as error:
        raise FileError(explain(error, name, path)) from None
    with opened:
        yield Source(path, opened)


def text_blocks(source: Source) -> Iterator[tuple[int, str]]:
    r"""The text of a source in blocks of whole lines.

    Yields:
        The number of the first line, from 1, and the lines, each with "\n" at its end.

    Raises:
        FileError: It is not text in UTF-8, or a line is longer than a piece.
    """
    rest, line, begun = b"", 1, 0
    while piece := source.read():
        whole, newline, rest = (rest + piece).rpartition(b"\n")
        if len(rest) > PIECE:
            message = f"this line is longer than {PIECE:,} bytes"
            raise FileError(Problem(message, Place(source.name, line), "a row is a line"))
        if newline:
            text = decode(whole + newline, source.name, before=(begun, line - 1))
            yield line, text
            line, begun = line + text.count("\n"), begun + len(whole) + 1
    if rest:
        yield line, decode(rest, source.name, before=(begun, line - 1)).rstrip("\n") + "\n"


def parted(first: int, text: str, most: int | None) -> Iterator[tuple[int, str]]:
    """A block of lines in shorter ones, each with the number of its first line; nothing where it is empty."""
    if most is None or text.count("\n") <= most:
        if text:
            yield first, text
        return
    lines = text.split("\n")[:-1]
    for k in range(0, len(lines), most):
        yield first + k, "\n".join(lines[k : k + most]) + "\n"


def _size_of(stream: BinaryIO) -> int | None:
    """The size of a regular file."""
    try:
        status = os.fstat(stream.fileno())
    except OSError:  # a stream in memory
        return None
    return status.st_size if stat.S_ISREG(status.st_mode) else None
