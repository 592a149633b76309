"""Reading the text of a file, or of standard input, with an upper limit and a clear error for all that can go wrong."""

from __future__ import annotations

import os
import stat
import sys
from collections.abc import Iterable
from pathlib import Path
from typing import BinaryIO

from dhcli.errors import FileError, Place, Problem, nearest

LIMIT = 256_000
_STANDARD_INPUT = "standard input"
_NEIGHBOURS = 1000
_UTF_16 = ("is written in UTF-16", "save it as UTF-8")
_OTHERS = {
    b"\xff\xfe": _UTF_16,
    b"\xfe\xff": _UTF_16,
    b"\x1f\x8b": ("is compressed by gzip", "gunzip takes it out of that"),
    b"PK\x03\x04": ("is a ZIP archive, as .xlsx and .npz are", "save a table as CSV, an array with np.save"),
    b"\xd0\xcf\x11\xe0": ("is an old spreadsheet or document", "save a table as CSV"),
    b"\x93NUMPY": ("is an array of numpy, and text is wanted", ""),
    b"MATLAB 5.0": ("is a MAT file", "writematrix(Q, 'q.csv') writes a table"),
    b"\x89HDF": ("is an HDF5 file", "save a table as CSV, an array with np.save"),
    b"%PDF": ("is a PDF", ""),
}
"""What is no text shows in its first bytes: what it is, and what would be right."""
_FIRST = 40
"""Bytes of which every second one is NUL where text is written in UTF-16."""
_NEAR = 0.75
"""How much of the letters a file name must share with the one that was typed, endings aside."""
_FIRST_PRINTABLE_LATIN_1 = 0xA1


def source_of(path: Path | str) -> str:
    """What to call a file in messages: its path as written, or `standard input` for `-`."""
    return _STANDARD_INPUT if str(path) == "-" else str(path)


def read_text(path: Path | str, *, limit: int = LIMIT) -> str:
    r"""Read a whole file as UTF-8.

    Args:
        path: The file; `-` is standard input.
        limit: Most bytes to accept [B]; a larger file is refused and not read.

    Returns:
        The text, every line end as "\n", without a byte order mark.

    Raises:
        FileError: It cannot be read, is larger than the limit, or is not text in UTF-8.
    """
    source = source_of(path)
    try:
        if str(path) == "-":
            content = _read_limited(standard_input(), _STANDARD_INPUT, limit)
        else:
            with _opened(path) as stream:
                content = _read_limited(stream, source, limit)
                if not content and stat.S_ISFIFO(os.fstat(stream.fileno()).st_mode):
                    raise FileError(Problem("is a pipe that nobody writes to", Place(source), "name a file"))
    except OSError as error:
        raise FileError(explain(error, source, path)) from None
    return decode(content, source)


def is_xml(text: str) -> bool:
    """Whether a text is XML, such as a URDF."""
    return text.lstrip().startswith("<")


def _opened(path: Path | str) -> BinaryIO:
    """A file, opened without waiting for somebody to open the other end of a pipe; reading it waits as ever."""
    descriptor = os.open(path, os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0))
    try:
        if hasattr(os, "set_blocking"):
            os.set_blocking(descriptor, True)
        return open(descriptor, "rb")
    except BaseException:
        os.close(descriptor)
        raise


def explain(error: OSError, source: str, path: Path | str) -> Problem:
    """What the operating system said, as a problem."""
    place = Place(source)
    if isinstance(error, FileNotFoundError | NotADirectoryError) and not str(path):
        from dhcli.storage.atomic import EMPTY

        return Problem(EMPTY, place)
    if isinstance(error, FileNotFoundError | NotADirectoryError):
        return Problem("there is no such file", place, instead_of(Path(path), _neighbours(Path(path))))
    if isinstance(error, IsADirectoryError) or os.path.isdir(path):
        return Problem("is a folder, not a file", place)
    if isinstance(error, PermissionError):
        return Problem("may not be read: no permission", place)
    return Problem(f"cannot be read: {error.strerror or error}", place)


def instead_of(path: Path, names: Iterable[str]) -> str:
    """A hint for a path that leads nowhere: what `~` stands for, names that are very near, the folder looked in.

    Args:
        path: The path as it was typed.
        names: What stands in its folder and could be meant.
    """
    from difflib import SequenceMatcher

    from dhcli.storage.home import unexpanded

    if home := unexpanded(path):
        return home
    wanted = Path(path.name).stem.lower()
    like = {
        name: SequenceMatcher(None, wanted, Path(name).stem.lower()).ratio() for name in nearest(path.name, names, 9)
    }
    if near := [name for name, ratio in like.items() if ratio >= _NEAR][:3]:
        return f"did you mean {' or '.join(near)}?"
    folder = path.parent
    return f"looked in {os.path.abspath(folder)}" if folder.is_dir() else f"there is no folder {folder}"


def decode(content: bytes, source: str, *, before: tuple[int, int] = (0, 0)) -> str:
    r"""Bytes as text, every line end as "\n", without a byte order mark.

    Args:
        content: The bytes; whole lines, if they are a part of a file.
        source: What to call the file.
        before: How many bytes and lines stand before them.

    Raises:
        FileError: They are not text in UTF-8; the place is that of the first byte that is none.
    """
    if before == (0, 0) and (told := _no_text(content)):
        raise FileError(Problem(told[0], Place(source), told[1]))
    if (at := content.find(b"\0")) >= 0:
        raise FileError(Problem(f"is not a text file: byte {before[0] + at + 1} is NUL", Place(source)))
    try:
        text = content.decode("utf-8")
    except UnicodeDecodeError as error:
        text, byte = content[: error.start].decode("utf-8"), content[error.start]
        lines = text.replace("\r\n", "\n").replace("\r", "\n").removeprefix("\ufeff").split("\n")
        hint = "save the file as UTF-8"
        if byte >= _FIRST_PRINTABLE_LATIN_1:
            hint += f"; if it is Latin-1, this byte is '{chr(byte)}'"
        place = Place(source, before[1] + len(lines), len(lines[-1]) + 1)
        raise FileError(
            Problem(f"is not UTF-8: byte {before[0] + error.start + 1} is 0x{byte:02X}", place, hint)
        ) from None
    text = text.removeprefix("\ufeff")
    return text.replace("\r\n", "\n").replace("\r", "\n") if "\r" in text else text


def _no_text(content: bytes) -> tuple[str, str] | None:
    """What the first bytes of a file show it to be instead of text, and what would be right."""
    halves = content[0:_FIRST:2], content[1:_FIRST:2]
    if all(halves) and any(map(any, halves)) and not all(map(any, halves)):
        return _UTF_16
    return next((told for sign, told in _OTHERS.items() if content.startswith(sign)), None)


def standard_input() -> BinaryIO:
    """The bytes of standard input, which a caller of the library may have closed.

    Raises:
        FileError: It is closed.
    """
    stream: BinaryIO | None = getattr(sys.stdin, "buffer", None)
    if stream is None or stream.closed:
        raise FileError(Problem("cannot be read", Place(_STANDARD_INPUT), "name a file instead of -"))
    return stream


def _read_limited(stream: BinaryIO, source: str, limit: int) -> bytes:
    """One byte more than the limit is read, never a whole large file; pipes and devices have no size to ask for."""
    content = stream.read(limit + 1)
    if len(content) <= limit:
        return content
    size = stream.seek(0, 2) if stream.seekable() else 0
    is_size = f"is {_spell_size(size)}, more than" if size > limit else "is more than"
    raise FileError(Problem(f"{is_size} the {_spell_size(limit)} that dhcli reads", Place(source)))


def _neighbours(path: Path) -> tuple[str, ...]:
    """Names of files beside a path, not more than a few."""
    from itertools import islice

    try:
        return tuple(beside.name for beside in islice(path.parent.iterdir(), _NEIGHBOURS))
    except OSError:
        return ()


def _spell_size(size: int) -> str:
    """A size for people: `256 kB`, `104.9 MB`."""
    for unit, factor in (("GB", 1_000_000_000), ("MB", 1_000_000), ("kB", 1000)):
        if size >= factor:
            return f"{size / factor:.1f}".removesuffix(".0") + f" {unit}"
    return f"{size} bytes"
