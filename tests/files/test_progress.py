"""Progress of a student: kept in one small file that is never half written and never lost in silence."""

from __future__ import annotations

import json
import os
from pathlib import Path

import pytest

from dhcli.checking.verdicts import Verdict
from dhcli.files.progress import ORDER, Try, path_of_progress, read_progress, record, record_hint


def test_progress_begins_empty_and_makes_no_file() -> None:
    """Reading writes nothing."""
    assert read_progress() == ({}, "")
    assert not path_of_progress().exists()


def test_progress_lives_in_the_data_folder_of_the_user(user_data: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """XDG's, or the usual one where that is not set or not absolute."""
    assert path_of_progress() == user_data / "dhcli" / "progress.json"
    for value in ("", "relative/folder"):
        monkeypatch.setenv("XDG_DATA_HOME", value)
        assert path_of_progress() == Path.home() / ".local" / "share" / "dhcli" / "progress.json"


def test_every_verdict_has_its_rank() -> None:
    """What is best is decided by one list."""
    assert set(ORDER) == {verdict.word for verdict in Verdict}


def test_the_best_verdict_stays_and_every_try_counts() -> None:
    """A later mistake takes nothing away."""
    for verdict in (Verdict.WRONG, Verdict.RIGHT, Verdict.CANNOT_READ):
        assert record("yim/x", {"a": verdict}) == ""
    assert read_progress() == ({"yim/x": {"a": Try("RIGHT", 3)}}, "")


def test_a_part_left_blank_is_no_try() -> None:
    """And a sheet of blanks makes no file."""
    assert record("yim/x", {"a": Verdict.SKIPPED}) == ""
    assert not path_of_progress().exists()
    record("yim/x", {"a": Verdict.SKIPPED, "b": Verdict.CLOSE})
    assert read_progress()[0] == {"yim/x": {"b": Try("CLOSE", 1)}}


def test_exercises_and_parts_are_kept_apart() -> None:
    """Nothing of one touches the other."""
    record("yim/x", {"a": Verdict.RIGHT})
    record("wpi/x", {"a": Verdict.WRONG})
    assert read_progress()[0] == {"yim/x": {"a": Try("RIGHT", 1)}, "wpi/x": {"a": Try("WRONG", 1)}}


def test_hints_are_counted_and_are_no_tries() -> None:
    """Nor does a try forget them."""
    record_hint("yim/x", "a")
    record_hint("yim/x", "a")
    assert read_progress()[0] == {"yim/x": {"a": Try("SKIPPED", 0, 2)}}
    record("yim/x", {"a": Verdict.WRONG})
    assert read_progress()[0] == {"yim/x": {"a": Try("WRONG", 1, 2)}}


@pytest.mark.parametrize(
    "content",
    [
        b"",
        b"{",
        b"[]",
        b"5",
        b"null",
        b"{}",
        b"\xff\xfe\x00",
        b"\x00" * 100,
        b'{"format": 1}',
        b'{"format": 1, "exercises": []}',
        b'{"format": 1, "exercises": {"x": []}}',
        b'{"format": 1, "exercises": {"x": {"a": {}}}}',
        b'{"format": 1, "exercises": {"x": {"a": {"best": "SPLENDID", "tries": 1}}}}',
        b'{"format": 1, "exercises": {"x": {"a": {"best": "RIGHT", "tries": "many"}}}}',
        b'{"format": 1, "exercises": {"x": {"a": {"best": "RIGHT", "tries": null}}}}',
        b'{"format": 1, "exercises": {"x": {"a": {"best": "RIGHT", "tries": Infinity}}}}',
        b'{"format": 1, "exercises": {"x": {"a": {"best": [], "tries": 1}}}}',
        b"[" * 100_000,
    ],
    ids=range(18),
)
def test_a_broken_file_is_set_aside_and_said_so(content: bytes) -> None:
    """It is kept as it was, and progress starts anew."""
    path = path_of_progress()
    path.parent.mkdir(parents=True)
    path.write_bytes(content)
    progress, message = read_progress()
    assert progress == {}
    assert "set aside as progress.json.broken-1" in message
    assert not path.exists()
    assert path.with_name("progress.json.broken-1").read_bytes() == content


def test_broken_files_do_not_overwrite_each_other() -> None:
    """The second one gets a number of its own, and the try is kept in a new file."""
    path = path_of_progress()
    path.parent.mkdir(parents=True)
    for text in ("first", "second"):
        path.write_text(text)
        assert "set aside" in record("yim/x", {"a": Verdict.RIGHT})
        assert read_progress() == ({"yim/x": {"a": Try("RIGHT", 1)}}, "")
    names = sorted(entry.name for entry in path.parent.iterdir())
    assert names == ["progress.json", "progress.json.broken-1", "progress.json.broken-2"]


def test_a_file_of_a_later_version_is_left_alone() -> None:
    """It is not broken, and not ours to change."""
    path = path_of_progress()
    path.parent.mkdir(parents=True)
    content = json.dumps({"format": 2, "exercises": {}})
    path.write_text(content)
    assert "newer dhcli" in read_progress()[1]
    assert "newer dhcli" in record("yim/x", {"a": Verdict.RIGHT})
    assert path.read_text() == content
    assert [entry.name for entry in path.parent.iterdir()] == ["progress.json"]


def test_nothing_but_the_file_is_left_behind() -> None:
    """No half written file beside it."""
    for _ in range(3):
        record("yim/x", {"a": Verdict.WRONG})
    assert [entry.name for entry in path_of_progress().parent.iterdir()] == ["progress.json"]
    assert json.loads(path_of_progress().read_text())["exercises"]["yim/x"]["a"]["tries"] == 3


@pytest.mark.skipif(os.name == "nt" or os.geteuid() == 0, reason="root may write everywhere")
def test_a_folder_that_may_not_be_written_is_said_so(user_data: Path) -> None:
    """The verdict is not lost with it."""
    user_data.mkdir()
    user_data.chmod(0o500)
    assert "progress could not be saved" in record("yim/x", {"a": Verdict.RIGHT})
    user_data.chmod(0o700)


def test_a_file_where_the_folder_should_be_is_said_so(user_data: Path) -> None:
    """And nothing is raised."""
    user_data.parent.mkdir(exist_ok=True)
    user_data.write_text("in the way")
    assert "progress could not be saved" in record("yim/x", {"a": Verdict.RIGHT})
    assert read_progress()[0] == {}
