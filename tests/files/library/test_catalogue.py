"""The index beside the library: as good as reading every file, and never older than they are."""

from __future__ import annotations

import json
import os
import shutil
from pathlib import Path

import pytest

from dhcli.files.library import catalogue as room
from dhcli.files.library import entries as library
from dhcli.files.library.catalogue import catalogue
from dhcli.files.library.entries import Kind
from dhcli.storage.cache import place

ARM = """format: 1
title: {}
source: mine
convention: standard
variables: [q1]
links:
  - {{a: 1, alpha: 0, d: 0, theta: q1}}
"""


ALL = library._built_in_root()
ONE_OF_EACH = ("robots/planar-2r.yaml", "robots/linkages/watt.yaml", "exercises/yim/planar-in-numbers.yaml")


@pytest.fixture(scope="module")
def one_of_each(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A library with one thing of each kind: all of dhcli's takes long to read anew in each test."""
    folder = tmp_path_factory.mktemp("library")
    for name in ONE_OF_EACH:
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ALL / name, path)
    return folder


@pytest.fixture(autouse=True)
def home(tmp_path: Path, one_of_each: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with one robot of the user's own, and a dhcli that brings along one thing of each kind."""
    monkeypatch.setattr(library, "_built_in_root", lambda: one_of_each)
    monkeypatch.chdir(tmp_path)
    (tmp_path / "robots").mkdir()
    (tmp_path / "robots" / "mine.yaml").write_text(ARM.format("Mine"), "utf-8")
    return tmp_path


@pytest.fixture
def read(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Names of the files that were read."""
    names: list[str] = []
    before = room._read

    def counted(kind: Kind, entry: room.Entry) -> room.Listed:
        names.append(entry.name)
        return before(kind, entry)

    monkeypatch.setattr(room, "_read", counted)
    return names


def titles() -> list[str]:
    """The titles of the robots in this folder."""
    return [one.title for one in catalogue([Kind.ROBOTS]) if one.entry.origin == "./robots"]


def test_the_second_list_reads_no_file(read: list[str], monkeypatch: pytest.MonkeyPatch) -> None:
    """And says the same as the first, of everything that dhcli brings along."""
    monkeypatch.setattr(library, "_built_in_root", lambda: ALL)
    first = catalogue()
    assert len(read) == len(first) > 100
    read.clear()
    assert catalogue() == first
    assert read == []


@pytest.mark.parametrize("change", ["rewritten", "added", "removed"])
def test_a_file_that_changes_is_seen_at_once(home: Path, change: str) -> None:
    """Also where the clock stands still but for a moment."""
    assert titles() == ["Mine"]
    path = home / "robots" / "mine.yaml"
    if change == "rewritten":
        path.write_text(ARM.format("Anew"), "utf-8")
        assert titles() == ["Anew"]
    elif change == "added":
        (home / "robots" / "next.yaml").write_text(ARM.format("Next"), "utf-8")
        assert titles() == ["Mine", "Next"]
    else:
        path.unlink()
        assert titles() == []


def test_another_folder_of_the_same_names_is_another_library(home: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Paths as the user writes them are the same in both."""
    assert titles() == ["Mine"]
    stamp = (home / "robots" / "mine.yaml").stat()
    other = home / "other" / "robots" / "mine.yaml"
    other.parent.mkdir(parents=True)
    other.write_text(ARM.format("Ours"), "utf-8")
    os.utime(other, ns=(stamp.st_atime_ns, stamp.st_mtime_ns))
    monkeypatch.chdir(home / "other")
    assert titles() == ["Ours"]


@pytest.mark.parametrize("content", ["", "{", "[]", '{"state": 1}', "\0"])
def test_a_broken_index_is_made_again(content: str) -> None:
    """Nothing is said of it: it is nobody's work."""
    first = catalogue()
    path = place(room.INDEX)
    path.write_text(content, "utf-8")
    assert catalogue() == first
    assert json.loads(path.read_text("utf-8"))["rows"]


def test_a_broken_file_is_read_each_time(home: Path, read: list[str]) -> None:
    """And it alone, so that what is wrong with it is told as long as it is."""
    (home / "robots" / "mine.yaml").write_text("format: 1\n", "utf-8")
    first = catalogue()
    assert len(read) == len(first) == 1 + len(ONE_OF_EACH)
    read.clear()
    assert catalogue() == first
    assert read == ["mine"]
    assert [bool(one.problems) for one in first if one.entry.name == "mine"] == [True]


def test_where_nothing_can_be_kept_the_list_comes_all_the_same(home: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A cache folder that is a file."""
    (home / "file").write_text("", "utf-8")
    monkeypatch.setenv("XDG_CACHE_HOME", str(home / "file"))
    assert titles() == ["Mine"]
