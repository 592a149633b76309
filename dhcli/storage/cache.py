"""What has been computed once, kept in the user's cache: a loss that nobody notices but by the time it takes."""

from __future__ import annotations

import os
from contextlib import suppress
from pathlib import Path

from dhcli.errors import FileError
from dhcli.storage.home import user_folder

MOST = 400
"""Files that a folder of the cache holds before the older half of them goes."""


def cached(*names: str) -> str | None:
    """What is kept under a name, or None.

    Args:
        names: The file, behind the folders of the cache that it is in.
    """
    path = place(*names)
    if not os.path.isfile(path):
        return None
    try:
        return path.read_text(encoding="utf-8")
    except (OSError, ValueError):
        return None


def cache(text: str, *names: str) -> None:
    """Keep a text under a name; where that cannot be, it is computed again the next time.

    Args:
        text: What to keep.
        names: The file, behind the folders of the cache that it is in.
    """
    from dhcli.storage.atomic import write_whole

    path = place(*names)
    with suppress(FileError, OSError):
        path.parent.mkdir(parents=True, exist_ok=True)
        if os.path.exists(path) and not os.path.isfile(path):  # a pipe would be waited for
            return
        _thinned(path.parent)
        write_whole(path, text, overwrite=True)


def place(*names: str) -> Path:
    """Where what has a name is kept."""
    return user_folder("XDG_CACHE_HOME", ".cache").joinpath("dhcli", *names)


def _thinned(folder: Path) -> None:
    """Take the older half of the files out of a folder that is full."""
    with os.scandir(folder) as found:
        files = [entry for entry in found if entry.is_file(follow_symlinks=False)]
    if len(files) >= MOST:
        for entry in sorted(files, key=lambda entry: entry.stat().st_mtime)[: len(files) // 2]:
            os.unlink(entry.path)
