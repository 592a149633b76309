"""Writing a file whole or not at all: a reader never sees half of it, and a failure leaves the old one as it was."""

from __future__ import annotations

import errno
import os
import stat
import time
from collections.abc import Iterator
from contextlib import contextmanager
from itertools import islice
from pathlib import Path
from typing import BinaryIO

from dhcli.errors import FileError, Place, Problem
from dhcli.regex import regex
from dhcli.storage.home import unexpanded

EMPTY = "the name is empty, as of a variable of the shell that is not set"
"""What is wrong with a path of no letters, which stands for the current folder elsewhere."""
_DISK_FULL = {errno.ENOSPC, errno.EDQUOT}
_TEMPORARY = regex(r"\.dhcli-[0-9a-f]{12}\.tmp")
_LEFT_AFTER = 24 * 3600
"""Seconds after which nobody writes to a file any more."""
_MOST_LOOKED_AT = 10_000
"""Names in a folder among which such files are looked for."""


def write_whole(path: Path | str, content: str | bytes, *, overwrite: bool) -> None:
    """Write a file in one step; see `whole_file`.

    Args:
        path: Where to write.
        content: Text, written as UTF-8 with the line ends it has, or bytes.
        overwrite: Whether a file that stands there may be replaced.

    Raises:
        FileError: Something stands there already, or it cannot be written; nothing has changed then.
    """
    try:
        payload = content if isinstance(content, bytes) else content.encode("utf-8")
    except UnicodeEncodeError as error:
        character = f"U+{ord(error.object[error.start]):04X}"
        raise FileError(Problem(f"cannot be written: {character} has no UTF-8", Place(str(path)))) from None
    with whole_file(path, overwrite=overwrite) as stream:
        stream.write(payload)


def check_place(path: Path | str) -> None:
    """Refuse a place where no file can be written, before work begins that would be lost.

    Raises:
        FileError: It is a folder, its own folder is not there, or nothing may be written in it.
    """
    there = Path(os.path.realpath(path))
    if not str(path):
        raise FileError(Problem(EMPTY, hint="name a file"))
    if there.is_dir():
        raise FileError(Problem("is a folder", Place(str(path)), "name a file in it"))
    if not there.parent.is_dir():
        raise FileError(_explain(FileNotFoundError(), Path(path)))
    if (not there.exists() or there.is_file()) and not os.access(there.parent, os.W_OK | os.X_OK):
        raise FileError(_explain(PermissionError(), Path(path)))


@contextmanager
def whole_file(path: Path | str, *, overwrite: bool) -> Iterator[BinaryIO]:
    """A file to write piece by piece, which appears in one step when all of it is written.

    A new file gets the usual permissions, an overwritten one keeps its own, and a symbolic link stays a link.
    Devices and pipes (`/dev/stdout`) cannot be replaced and are written directly.

    Args:
        path: Where to write.
        overwrite: Whether a file that stands there may be replaced.

    Yields:
        Where to write the bytes. If anything is raised meanwhile, Ctrl-C too, the file is not there, or is the old one.

    Raises:
        FileError: Something stands there already, or it cannot be written; nothing has changed then.
    """
    path = Path(path)
    try:
        mode = _mode_of(path)
        if mode is not None and stat.S_ISDIR(mode):
            raise FileError(Problem("is a folder", Place(str(path)), "name a file in it"))
        if mode is not None and not stat.S_ISREG(mode):
            with open(path, "wb") as stream:
                yield stream
            return
        if mode is not None and not overwrite:
            raise FileError(Problem("exists already", Place(str(path)), "choose another name, or allow overwriting"))
        with _beside(Path(os.path.realpath(path)), mode) as stream:
            yield stream
    except OSError as error:
        raise FileError(_explain(error, path)) from None


def _mode_of(path: Path) -> int | None:
    """Kind and permissions of what stands at a path, or None if nothing does."""
    try:
        return path.stat().st_mode
    except FileNotFoundError:
        return None


@contextmanager
def _beside(path: Path, mode: int | None) -> Iterator[BinaryIO]:
    """A new file beside the target, where a rename is one step, and that step."""
    _sweep(path.parent)
    temporary = path.with_name(f".dhcli-{os.urandom(6).hex()}.tmp")
    try:  # opening is a part of it: Ctrl-C may come as soon as the file is there
        with open(temporary, "xb") as stream:
            yield stream
            stream.flush()
            os.fsync(stream.fileno())
        if mode is not None:
            temporary.chmod(stat.S_IMODE(mode))
        temporary.replace(path)
    except BaseException:  # Ctrl-C too must leave nothing behind
        temporary.unlink(missing_ok=True)
        raise


def _sweep(folder: Path) -> None:
    """Remove what processes that were killed have left in a folder: files that nobody has written to for a day."""
    before = time.time() - _LEFT_AFTER
    try:
        with os.scandir(folder) as found:
            for entry in islice(found, _MOST_LOOKED_AT):
                if _TEMPORARY.fullmatch(entry.name) and entry.stat(follow_symlinks=False).st_mtime < before:
                    os.unlink(entry.path)
    except OSError:  # it is somebody else's, or gone already
        return


def _explain(error: OSError, path: Path) -> Problem:
    """What the operating system said, as a problem."""
    place = Place(str(path))
    if isinstance(error, FileNotFoundError | NotADirectoryError):
        return Problem(
            f"cannot be written: there is no folder {path.parent}", place, unexpanded(path) or "make it first"
        )
    if isinstance(error, PermissionError):
        return Problem("cannot be written: no permission", place)
    if error.errno in _DISK_FULL:
        return Problem("cannot be written: the disk is full", place)
    return Problem(f"cannot be written: {error.strerror or error}", place)
