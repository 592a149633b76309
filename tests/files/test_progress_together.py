"""Progress under pressure: many at once, killed half-way, on disks that cannot be written, and without a home."""

from __future__ import annotations

import errno
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from dhcli.checking.verdicts import Verdict
from dhcli.errors import FileError
from dhcli.files import progress
from dhcli.files.progress import Try, path_of_progress, read_progress, record, solved_parts
from dhcli.storage.atomic import write_whole
from dhcli.storage.home import user_folder

ROOT = Path(__file__).parents[2]
TRIES = """
import os, sys
from dhcli.checking.verdicts import Verdict
from dhcli.files.progress import record
reading, writing = os.pipe()
for _ in range(20):
    if not os.fork():
        os.close(writing)
        os.read(reading, 1)  # so that all of them begin together
        sys.stderr.write(record("yim/x", {"a": Verdict.WRONG}))
        sys.exit()
os.close(writing)
assert [os.wait()[1] for _ in range(20)] == [0] * 20
"""
DAY = 24 * 3600


def broken() -> Path:
    """A progress file that cannot be read."""
    path = path_of_progress()
    path.parent.mkdir(parents=True)
    path.write_text("{")
    return path


@pytest.mark.skipif(not hasattr(os, "O_DIRECTORY"), reason="this system cannot hold a folder")
def test_twenty_checks_at_once_are_twenty_tries() -> None:
    """And nothing but the file is left behind."""
    done = subprocess.run([sys.executable, "-c", TRIES], cwd=ROOT, capture_output=True, encoding="utf-8", check=False)
    assert (done.returncode, done.stderr) == (0, "")
    assert read_progress() == ({"yim/x": {"a": Try("WRONG", 20)}}, "")
    assert os.listdir(path_of_progress().parent) == ["progress.json"]


@pytest.mark.skipif(not hasattr(os, "O_DIRECTORY"), reason="this system cannot hold a folder")
def test_who_does_not_let_go_is_not_waited_for(monkeypatch: pytest.MonkeyPatch) -> None:
    """The verdict shows all the same; the next one waits no more once it is free."""
    monkeypatch.setattr(progress, "PATIENCE", 0.0)
    record("yim/x", {"a": Verdict.WRONG})
    with progress.held(path_of_progress().parent):
        assert "held by another dhcli" in record("yim/x", {"a": Verdict.RIGHT})
    assert record("yim/x", {"a": Verdict.RIGHT}) == ""
    assert read_progress()[0] == {"yim/x": {"a": Try("RIGHT", 2)}}


@pytest.mark.parametrize("missing", ["fcntl", "O_DIRECTORY", "flock"])
def test_where_folders_cannot_be_held_progress_is_kept_all_the_same(
    monkeypatch: pytest.MonkeyPatch, missing: str
) -> None:
    """Windows, and disks of a network."""
    if missing == "fcntl":
        monkeypatch.setitem(sys.modules, "fcntl", None)
    elif missing == "O_DIRECTORY":
        monkeypatch.delattr(os, "O_DIRECTORY", raising=False)
    else:
        fcntl = pytest.importorskip("fcntl")

        def fail(*_: object) -> None:
            raise OSError(errno.ENOLCK, os.strerror(errno.ENOLCK))

        monkeypatch.setattr(fcntl, "flock", fail)
    assert record("yim/x", {"a": Verdict.RIGHT}) == ""
    assert read_progress() == ({"yim/x": {"a": Try("RIGHT", 1)}}, "")


def test_a_broken_file_on_a_disk_that_cannot_be_written_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    """It stays where it is, and nothing is raised."""

    def refuse(*_: object) -> None:
        raise OSError(errno.EROFS, os.strerror(errno.EROFS))

    path = broken()
    monkeypatch.setattr(Path, "rename", refuse)
    for message in (read_progress()[1], record("yim/x", {"a": Verdict.RIGHT})):
        assert "could not be read, nor set aside: Read-only file system" in message
    assert read_progress()[0] == {}
    assert solved_parts("yim/x") == ()
    assert path.read_text() == "{"


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="this system has no pipes with names")
def test_a_pipe_in_the_place_of_the_file_is_not_waited_for() -> None:
    """It is set aside as what it is."""
    path = path_of_progress()
    path.parent.mkdir(parents=True)
    os.mkfifo(path)
    assert "set aside as progress.json.broken-1" in read_progress()[1]
    assert path.with_name("progress.json.broken-1").is_fifo()


def test_a_folder_or_a_dangling_link_in_the_place_of_the_file_is_set_aside() -> None:
    """Neither stops a try from being kept."""
    path = path_of_progress()
    path.mkdir(parents=True)
    assert "broken-1" in record("yim/x", {"a": Verdict.RIGHT})
    path.unlink()
    path.symlink_to("nowhere")
    assert "broken-2" in record("yim/x", {"a": Verdict.RIGHT})
    assert read_progress() == ({"yim/x": {"a": Try("RIGHT", 1)}}, "")


@pytest.mark.parametrize("value", ["/" + "x" * 5000, "/dev/null/x", "/proc/self/mem"])
def test_a_folder_that_cannot_be_is_told(monkeypatch: pytest.MonkeyPatch, value: str) -> None:
    """A name too long, and a file for a folder."""
    monkeypatch.setenv("XDG_DATA_HOME", value)
    assert read_progress()[0] == {}
    assert solved_parts("yim/x") == ()
    assert "progress could not be saved" in record("yim/x", {"a": Verdict.RIGHT})


def test_a_user_without_a_home_has_a_folder_all_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    """Never one that is called ~."""
    monkeypatch.setenv("XDG_DATA_HOME", "")
    monkeypatch.setattr(os.path, "expanduser", lambda path: path)
    assert user_folder("XDG_DATA_HOME", ".local", "share") == Path(os.sep, ".local", "share")


def test_what_a_killed_process_has_left_is_swept_a_day_later(tmp_path: Path) -> None:
    """What is new may still be written, and what is called otherwise is not ours."""
    names = (".dhcli-0123456789ab.tmp", ".dhcli-ba9876543210.tmp", ".dhcli-mine.tmp", "a.tmp")
    for name in names:
        (tmp_path / name).write_text("half")
        if name != names[1]:
            os.utime(tmp_path / name, (time.time() - 2 * DAY,) * 2)
    write_whole(tmp_path / "out", "x", overwrite=False)
    assert sorted(os.listdir(tmp_path)) == sorted([*names[1:], "out"])


@pytest.mark.skipif(not hasattr(signal, "SIGKILL"), reason="this system kills otherwise")
def test_a_kill_leaves_a_file_of_the_kind_that_is_swept(tmp_path: Path) -> None:
    """Whatever it is called, the sweep knows it."""
    program = (
        "import os, signal\n"
        "from dhcli.storage.atomic import whole_file\n"
        "with whole_file('out', overwrite=False) as stream:\n"
        "    stream.write(b'half'); stream.flush(); os.kill(os.getpid(), signal.SIGKILL)\n"
    )
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    subprocess.run([sys.executable, "-c", program], cwd=tmp_path, env=environment, check=False)
    (left,) = tmp_path.iterdir()
    os.utime(left, (time.time() - 2 * DAY,) * 2)
    write_whole(tmp_path / "out", "x", overwrite=False)
    assert os.listdir(tmp_path) == ["out"]


def test_a_folder_that_is_no_folder_is_not_held(tmp_path: Path) -> None:
    """Whoever writes there says what is wrong."""
    with progress.held(tmp_path / "nowhere"):
        pass
    with pytest.raises(FileError, match="no folder"):
        write_whole(tmp_path / "nowhere" / "a", "x", overwrite=False)
