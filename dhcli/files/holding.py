"""Holding a folder while something in it is read, changed and written back. No file is left behind by it.

A process that ends, whatever ends it, lets go. Where the system cannot hold a folder (Windows, some network disks)
nobody waits for anybody.
"""

from __future__ import annotations

import errno
import os
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from dhcli.errors import FileError, Place, Problem

PATIENCE = 5.0
"""Seconds after which somebody who holds a folder is taken for stuck; a change takes a few thousandths of one."""
_PAUSE = 0.005
_IS_HELD = {errno.EAGAIN, errno.EACCES}


@contextmanager
def held(folder: Path) -> Iterator[None]:
    """Hold a folder that exists.

    Raises:
        FileError: Somebody else does, and does not let go.
    """
    descriptor = _opened(folder)
    if descriptor is None:
        yield
        return
    try:
        _lock(descriptor, folder)
        yield
    finally:
        os.close(descriptor)  # which lets go


def _opened(folder: Path) -> int | None:
    """The folder as something that can be held; None where there is no such thing."""
    try:
        return os.open(folder, os.O_RDONLY | os.O_DIRECTORY)
    except (AttributeError, OSError):  # Windows knows no O_DIRECTORY
        return None


def _lock(descriptor: int, folder: Path) -> None:
    try:
        from fcntl import LOCK_EX, LOCK_NB, flock
    except ImportError:
        return
    until = time.monotonic() + PATIENCE
    while True:
        try:
            flock(descriptor, LOCK_EX | LOCK_NB)
        except OSError as error:
            if error.errno not in _IS_HELD:
                return  # this disk cannot
            if time.monotonic() > until:
                raise FileError(Problem("is held by another dhcli", Place(str(folder)))) from None
            time.sleep(_PAUSE)
        else:
            return
