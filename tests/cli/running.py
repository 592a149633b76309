"""Running a command in this process as if it had one of its own, or in a copy of it, and what it leaves behind."""

from __future__ import annotations

import gc
import io
import json
import os
import signal
import subprocess
import sys
import traceback
import warnings
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any, BinaryIO, NoReturn, TextIO, TypeAlias

import pytest

from dhcli.cli import app
from dhcli.cli.main import main

# typer takes long to make a command, and changes none that it has made
app.build, app.load = cache(app.build), cache(app.load)

STREAMS = ("stdin", "stdout", "stderr")
PIPES = dict.fromkeys(STREAMS, subprocess.PIPE)


@dataclass(frozen=True)
class Done:
    """What a command left behind."""

    code: int
    out: str
    err: str

    @property
    def envelope(self) -> dict[str, Any]:
        """Standard output as JSON that holds no NaN."""
        return json.loads(self.out, parse_constant=lambda word: pytest.fail(f"{word} in JSON"))

    @property
    def data(self) -> Any:  # noqa: ANN401  JSON
        """What stands under `data` of a command that succeeded."""
        assert self.code == 0, self.err
        return self.envelope["data"]


Run: TypeAlias = Callable[..., Done]
"""Runs dhcli with the words given."""


class Untouched(io.RawIOBase):
    """A standard input that nobody may read."""

    def readable(self) -> bool:
        """As every standard input."""
        return True

    def readinto(self, _: object) -> int:
        """A command that reads here would wait for somebody who was not asked."""
        raise AssertionError("standard input was read")


def run(
    *words: str,
    stdin: str | BinaryIO | None = None,
    stdout: TextIO | None = None,
    together: bool = False,
    **environment: str,
) -> Done:
    """Run `dhcli` with these words in this process, its streams piped.

    Args:
        words: What is typed after `dhcli`.
        stdin: What comes in; without it, nobody may read.
        stdout: Where results go; by default they are kept.
        together: Whether both streams go into one, as `2>&1` has it.
        environment: Variables to set; PYTHONIOENCODING is that of the streams.
    """
    out, err = io.BytesIO(), io.BytesIO()
    encoding = environment.get("PYTHONIOENCODING", "utf-8")
    streams = {
        "stdin": _stdin(stdin),
        "stdout": stdout or writer(out, encoding),
        "stderr": writer(out if together else err, encoding, errors="backslashreplace", at_once=True),
    }
    with replaced(streams, environment):
        code = main(words)
        streams["stdout"].flush()
        streams["stderr"].flush()
    return Done(int(code), out.getvalue().decode(), err.getvalue().decode())


def writer(stream: BinaryIO, encoding: str = "utf-8", errors: str = "strict", *, at_once: bool = False) -> TextIO:
    """What Python puts before a stream of bytes: a buffer, so that a forgotten flush shows."""
    return io.TextIOWrapper(stream, encoding, errors, newline="\n", write_through=at_once)


@contextmanager
def replaced(streams: Mapping[str, TextIO], environment: Mapping[str, str]) -> Iterator[None]:
    """Other streams and variables for a while."""
    with pytest.MonkeyPatch.context() as patch:
        for name, text in environment.items():
            patch.setenv(name, text)
        for name, stream in streams.items():
            patch.setattr(sys, name, stream)
        yield


@contextmanager
def nobody_reads() -> Iterator[TextIO]:
    """A pipe whose reader has gone away, written line by line."""
    reading, writing = os.pipe()
    os.close(reading)
    with open(writing, "w", buffering=1, encoding="utf-8") as stream:  # noqa: PTH123  a descriptor
        yield stream


def start(
    folder: Path,
    *words: str,
    environment: Mapping[str, str] | None = None,
    work: Callable[[Sequence[str]], int] = main,
    **streams: Any,  # noqa: ANN401  as Popen takes them
) -> subprocess.Popen[str]:
    """Start `dhcli`, or another program, in a process of its own, which can be stopped or need not end.

    It is a copy of this one that never becomes another program: no start of Python, nothing to import.

    Args:
        folder: Where it works.
        words: What is typed after `dhcli`.
        environment: Variables to set.
        work: What takes the words and gives an exit code.
        streams: Of the process, and whether it gets a session of its own; all as Popen has them.
    """

    def copy() -> NoReturn:
        code = 70  # of a fault in what tests
        try:
            _begin()
            os.environ.update(environment or {})
            code = work(words)
            sys.stdout.flush()
        except BaseException:  # noqa: BLE001  the test sees it
            traceback.print_exc()
        finally:
            os._exit(code)

    with warnings.catch_warnings():
        warnings.simplefilter("ignore", DeprecationWarning)  # no thread of the tests holds what a command needs
        return subprocess.Popen([sys.executable], cwd=folder, text=True, preexec_fn=copy, **streams)  # noqa: PLW1509


def _begin() -> None:
    """Have what a process has that Python has just begun: three streams, no other file, and no end by a broken pipe."""
    gc.freeze()  # nothing of the tests is given back, for it would close files by their numbers
    os.closerange(3, 4096)
    signal.signal(signal.SIGPIPE, signal.SIG_IGN)
    sys.stdin = open(0, encoding="utf-8")  # noqa: SIM115  descriptors, closed with the process
    sys.stdout = open(1, "w", encoding="utf-8")  # noqa: SIM115
    sys.stderr = open(2, "w", buffering=1, encoding="utf-8", errors="backslashreplace")  # noqa: SIM115


def _stdin(content: str | BinaryIO | None) -> TextIO:
    """A standard input that holds this."""
    if isinstance(content, str):
        content = io.BytesIO(content.encode())
    return io.TextIOWrapper(content or io.BufferedReader(Untouched()), "utf-8")
