"""What is kept in the user's cache: there again, or quietly not."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from dhcli.storage import cache as room
from dhcli.storage.cache import cache, cached, place


def test_what_is_kept_is_there_again() -> None:
    """Under its own name alone, in the folder that the system names."""
    assert cached("plans", "one") is None
    cache("a\nb", "plans", "one")
    assert cached("plans", "one") == "a\nb"
    assert cached("plans", "two") is None
    assert place("plans", "one").is_relative_to(os.environ["XDG_CACHE_HOME"])


def test_a_full_folder_loses_its_older_half(monkeypatch: pytest.MonkeyPatch) -> None:
    """So a cache does not grow for ever."""
    monkeypatch.setattr(room, "MOST", 6)
    for k in range(7):
        cache("x", "plans", str(k))
        os.utime(place("plans", str(k)), (k, k))
    assert sorted(path.name for path in place("plans").iterdir()) == ["3", "4", "5", "6"]


@pytest.mark.parametrize("made", ["file", "locked", "pipe", "latin"])
def test_where_it_cannot_be_kept_nothing_happens(made: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A cache that is a file, a folder without permission, a pipe that nobody writes to, a text that is none."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    path = place("one")
    if made == "file":
        (tmp_path / "cache").write_text("", "utf-8")
    elif made == "locked":
        (tmp_path / "cache").mkdir(mode=0o500)
        if os.access(tmp_path / "cache", os.W_OK):
            pytest.skip("nothing is locked to this user")
    elif made == "pipe":
        path.parent.mkdir(parents=True)
        os.mkfifo(path)
    else:
        path.parent.mkdir(parents=True)
        path.write_bytes(b"\xe9\xff")
    assert cached("one") is None
    cache("text", "one")
    assert cached("one") == ("text" if made == "latin" else None)
