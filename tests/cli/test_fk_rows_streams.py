"""`dhcli fk --rows` and its streams: pipes that break, disks that fill up, Ctrl-C, terminals, and memory."""

from __future__ import annotations

import contextlib
import errno
import io
import os
import re
import signal
import subprocess
import sys
from pathlib import Path
from time import monotonic

import numpy as np
import pytest

from tests.cli.running import PIPES, Run, start
from tests.cli.terminal import PATIENCE, Terminal

ROOT = Path(__file__).parents[2]
POSIX = pytest.mark.skipif(os.name != "posix", reason="streams and signals as POSIX has them")
SIGNALS = [("SIGINT", 130), ("SIGTERM", 143), ("SIGHUP", 129)]
GOOD = "theta1,theta2,d3\n0.3,0.5,0.1\n-0.2,1.5,0\n"


def puma(rows: int) -> np.ndarray:
    """Joint values for PUMA 560 within its limits."""
    return np.random.default_rng(5).uniform(-1, 0.7, (rows, 6))


@POSIX
def test_a_reader_that_goes_away_ends_the_work_in_silence(process: Run) -> None:
    """The rows never end; the exit code is that of the work."""
    words = "fk scara --rows - --as position"
    done = process(f'yes 0.1,0.2,0.3 | {{ "$0" -m dhcli {words}; echo $? >code; }} | head -2; cat code')
    head, row, code = done.out.split()
    assert (head, code) == ("p_x,p_y,p_z", "0")
    assert len(row.split(",")) == 3
    assert done.err == ""


@POSIX
def test_a_reader_of_bytes_that_goes_away_is_no_error(process: Run, tmp_path: Path) -> None:
    """As one of text is not."""
    np.save(tmp_path / "q.npy", puma(20_000))
    words = "fk puma560 --rows q.npy --format npy"
    done = process(f'"$0" -m dhcli {words} | true; echo "${{PIPESTATUS[0]}}"')
    assert (done.out, done.err) == ("0\n", "")


@POSIX
def test_rows_show_as_they_come(tmp_path: Path) -> None:
    """A pose is there before the next row is typed; Ctrl-C then ends with 130."""
    with start(tmp_path, "fk", "scara", "--rows", "-", "--as", "position", **PIPES) as running:
        assert running.stdin is not None
        assert running.stdout is not None
        for _ in range(2):
            running.stdin.write("0.1,0.2,0.3\n")
            running.stdin.flush()
            while running.stdout.readline().startswith("p_x"):
                pass
        running.send_signal(signal.SIGINT)
        out, err = running.communicate(timeout=PATIENCE)
    assert (running.returncode, out) == (130, "")
    assert "Traceback" not in err


class Stopped(io.RawIOBase):
    """Rows on standard input, and then a signal, once there is a file to be left behind."""

    def __init__(self, rows: bytes, number: int) -> None:
        """The rows come in one piece."""
        self.rows, self.number = rows, number

    def readable(self) -> bool:
        """As every standard input."""
        return True

    def readinto(self, into: memoryview) -> int:
        """The rows; what comes next is the signal."""
        if not self.rows:
            assert list(Path().glob(".dhcli-*"))
            assert signal.getsignal(self.number) is not signal.SIG_DFL, "the signal would end the tests"
            signal.raise_signal(self.number)
        count = len(self.rows)
        into[:count], self.rows = self.rows, b""
        return count


@POSIX
@pytest.mark.parametrize("suffix", ["csv", "jsonl", "npy"])
@pytest.mark.parametrize("there_before", [False, True])
@pytest.mark.parametrize(("name", "code"), SIGNALS)
def test_a_signal_leaves_nothing_that_looks_complete(
    dhcli: Run, tmp_path: Path, suffix: str, there_before: bool, name: str, code: int
) -> None:
    """No new file, or the old one; nothing beside it."""
    target = tmp_path / f"poses.{suffix}"
    if there_before:
        target.write_text("old")
    rows = io.BufferedReader(Stopped(b"0.1,0.2,0.3\n" * 9, getattr(signal, name)))
    done = dhcli("fk", "scara", "--rows", "-", "-o", target.name, "--overwrite", stdin=rows)
    assert (done.code, done.out, done.err.strip()) == (code, "", "")
    assert [path.read_text() for path in tmp_path.iterdir()] == (["old"] if there_before else [])


@POSIX
@pytest.mark.parametrize(("name", "code"), SIGNALS)
def test_a_process_that_waits_for_rows_can_be_stopped(tmp_path: Path, name: str, code: int) -> None:
    """By a signal from outside, and it cleans up."""
    target = tmp_path / "poses.csv"
    target.write_text("old")
    with start(tmp_path, "fk", "scara", "--rows", "-", "-o", target.name, "--overwrite", **PIPES) as running:
        assert running.stdin is not None
        running.stdin.write("0.1,0.2,0.3\n")
        running.stdin.flush()
        last = monotonic() + PATIENCE
        while not list(tmp_path.glob(".dhcli-*")) and monotonic() < last:
            with contextlib.suppress(subprocess.TimeoutExpired):
                running.wait(timeout=0.02)
        running.send_signal(getattr(signal, name))
        _, err = running.communicate(timeout=PATIENCE)
    assert running.returncode == code
    assert "Traceback" not in err
    assert [path.read_text() for path in tmp_path.iterdir()] == ["old"]


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs /dev/full")
@pytest.mark.parametrize("format_", ["csv", "jsonl", "npy"])
def test_a_full_disk_is_told(dhcli: Run, tmp_path: Path, format_: str) -> None:
    """On stdout, and for a file."""
    (tmp_path / "q.csv").write_text(GOOD)
    words = ("fk", "scara", "--rows", "q.csv", "--format", format_)
    with open("/dev/full", "w", encoding="utf-8") as full:  # noqa: PTH123  what a shell does
        done = dhcli(*words, stdout=full)
    assert done.code == 2
    assert "standard output: cannot be written" in done.err
    done = dhcli(*words, "-o", "/dev/full", "--overwrite")
    assert done.code == 2
    assert "/dev/full: cannot be written: the disk is full" in done.err
    assert "Traceback" not in done.err


def test_a_disk_that_fills_up_leaves_no_file(dhcli: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    """Nor half of one."""
    Path("q.csv").write_text(GOOD, "utf-8")

    def fail(_: int) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(os, "fsync", fail)
    done = dhcli("fk", "scara", "--rows", "q.csv", "-o", "p.npy")
    assert done.code == 2
    assert "p.npy: cannot be written: the disk is full" in done.err
    assert os.listdir() == ["q.csv"]


MEASURED = """
import os
from dhcli.cli.main import main
for ending, *counts in [("csv", 8_000, 40_000), ("jsonl", 8_000, 40_000), ("npy", 30_000, 150_000)]:
    if not os.fork():
        for count in counts:
            main(["fk", "scara", "--rows", f"{count}.{ending}", "-o", f"p.{ending}", "--overwrite"])
            status = open("/proc/self/status").read()
            print(status.partition("VmHWM:")[2].split()[0], flush=True)
        os._exit(0)
    os.wait()
"""
"""A process of its own for each format, and the most memory that it has had after few rows and after many."""


@pytest.mark.skipif(not Path("/proc/self/status").exists(), reason="memory as Linux tells it")
def test_memory_does_not_grow_with_the_rows(tmp_path: Path) -> None:
    """The most that was in use, for five times the rows, is the same but for a fraction of what came out."""
    cells = [value + 60 * "0" for value in ("0.123456789", "0.2", "0.3")]  # so long that few rows are many pieces
    for count in (8_000, 40_000):
        (tmp_path / f"{count}.csv").write_text(f"{','.join(cells)}\n" * count)
        (tmp_path / f"{count}.jsonl").write_text(f"[{','.join(cells)}]\n" * count)
    for count in (30_000, 150_000):
        np.save(tmp_path / f"{count}.npy", np.full((count, 3), 0.123456789))
    done = subprocess.run(
        [sys.executable, "-c", MEASURED],
        cwd=tmp_path,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
        capture_output=True,
        text=True,
        timeout=60,
        check=True,
    )
    most = [int(word) for word in done.stdout.split()]
    assert re.findall(r"(\d+) rows", done.stderr) == ["8000", "40000", "8000", "40000", "30000", "150000"]
    for format_, few, many in zip(("csv", "jsonl", "npy"), most[::2], most[1::2], strict=True):
        size = (tmp_path / f"p.{format_}").stat().st_size // 1024
        assert many - few < size / 5
        assert size > 5_000


def test_a_terminal_sees_a_bar_while_rows_go_to_a_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """And what was done; the bar is gone then."""
    monkeypatch.setattr("dhcli.render.text.progress._OFTEN", 0)
    np.save(tmp_path / "q.npy", puma(500))
    with Terminal(tmp_path, "fk", "puma560", "--rows", "q.npy", "-o", "p.csv") as terminal:
        terminal.until(r"500 rows")
        terminal.until(r"wrote p\.csv: 500 rows")
        assert terminal.end() == 0


def test_a_terminal_is_spared_bytes(tmp_path: Path) -> None:
    """It is told what to do instead."""
    np.save(tmp_path / "q.npy", puma(1))
    with Terminal(tmp_path, "fk", "puma560", "--rows", "q.npy", "--format", "npy") as terminal:
        terminal.until("npy is not for a terminal")
        assert terminal.end() == 2
