"""The folders in which a user's data and caches live."""

from __future__ import annotations

import os
from pathlib import Path


def user_folder(variable: str, *usual: str) -> Path:
    """The folder that a variable of the XDG standard names, else the usual one below the user's home.

    A relative value is ignored, as the standard says. A user without a home (a container may run for one) gets a folder
    below the root: there is nothing in it, and nothing can be written there.

    Args:
        variable: `XDG_DATA_HOME`, `XDG_CACHE_HOME`.
        usual: The folders below the home where the variable is not set.
    """
    named = os.environ.get(variable, "")
    if os.path.isabs(named):
        return Path(named)
    home = os.path.expanduser("~")
    return Path(home if os.path.isabs(home) else os.sep, *usual)


def unexpanded(path: Path | str) -> str:
    """What to write instead of a path in which `~` was left for dhcli to expand, as a hint; empty if it was not.

    A shell makes the home of it, but not between quotes, and nobody does in a file, which others read too.
    """
    before, mark, below = Path(path).as_posix().partition("~/")
    if not mark or (before and not before.endswith("/")):
        return ""
    return f"~ stays as it is here, write {Path(os.path.expanduser('~'), below)}"
