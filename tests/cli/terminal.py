"""A terminal for commands that only talk to people: a pseudo-terminal, read until what is waited for has come.

The command runs in a thread of this process, which spares its start; or in a process of its own, where it is to be
stopped, never ends by itself, or starts processes.
"""

from __future__ import annotations

import contextlib
import io
import os
import re
import select
import signal
import struct
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path
from threading import Thread
from time import monotonic
from types import TracebackType
from typing import Self, TextIO

import pytest

from dhcli.cli.main import main
from tests.cli.running import STREAMS, start

PATIENCE = 30.0
"""Seconds after which what has not come will not come."""
MOMENT = 1.0
"""Seconds after which a person presses a key again."""


class Terminal:
    """A command that runs on a terminal of its own."""

    def __init__(
        self, folder: Path, *words: str, no_color: str = "1", own_process: bool = False, columns: int = 0
    ) -> None:
        """Start `dhcli` with these words in a folder, by default without colour and in this process.

        It has 100 columns, or as many as are said and can be changed then.
        """
        import pty

        self.screen, other = pty.openpty()
        environment = {"COLUMNS": "0" if columns else "100", "NO_COLOR": no_color, "TERM": "xterm"}
        if columns:
            self.resize(columns)
        runner = _Process if own_process else _Thread
        self.running = runner(folder, words, other, environment)
        self.seen = ""

    def __enter__(self) -> Self:
        """Itself."""
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        """End what still runs."""
        self.running.end(self.screen)

    def type(self, text: str) -> None:
        """Press keys."""
        os.write(self.screen, text.encode())

    def resize(self, columns: int) -> None:
        """Make the window wider or narrower."""
        import fcntl
        import termios

        fcntl.ioctl(self.screen, termios.TIOCSWINSZ, struct.pack("HHHH", 40, columns, 0, 0))

    def interrupt(self) -> None:
        """What Ctrl-C does to a process of its own, which shows something then.

        A signal that comes after a line editor has shown its prompt and before it waits for keys is seen by Python at
        the next one only; a person presses Ctrl-C again.
        """
        assert isinstance(self.running, _Process)
        for _ in range(int(PATIENCE / MOMENT)):
            self.running.process.send_signal(signal.SIGINT)
            if select.select([self.screen], [], [], MOMENT)[0]:
                return

    def until(self, pattern: str) -> str:
        """Wait until something is shown; what was shown up to it, which is then forgotten."""
        for _ in self._pieces():
            if found := re.search(pattern, self.seen):
                text, self.seen = self.seen[: found.end()], self.seen[found.end() :]
                return text
        raise AssertionError(f"{pattern!r} was never shown, only {self.seen!r}")

    def end(self) -> int:
        """Wait until the command has ended; its exit code."""
        for _ in self._pieces():
            pass
        return self.running.wait()

    def _pieces(self) -> Iterator[None]:
        """Read on, until the command has closed the terminal or patience is at its end."""
        last = monotonic() + PATIENCE
        yield
        while (left := last - monotonic()) > 0:
            ready, _, _ = select.select([self.screen], [], [], left)
            piece = b""
            with contextlib.suppress(OSError):  # Linux says EIO when the other side is closed
                piece = os.read(self.screen, 65536) if ready else b""
            if not piece:
                return
            self.seen += piece.decode("utf-8", "replace").replace("\r\n", "\n")
            yield


class _Process:
    """A command in a process of its own."""

    def __init__(self, folder: Path, words: Sequence[str], terminal: int, environment: dict[str, str]) -> None:
        """Start it on a terminal, given by its descriptor."""
        self.process = start(folder, *words, environment=environment, stdin=terminal, stdout=terminal, stderr=terminal)
        os.close(terminal)

    def wait(self) -> int:
        """Its exit code."""
        return self.process.wait(timeout=PATIENCE)

    def end(self, screen: int) -> None:
        """Kill it if it still runs, and close its screen."""
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()
        os.close(screen)


class _Thread:
    """A command in a thread, which has the streams, the variables and the folder of this process meanwhile."""

    def __init__(self, folder: Path, words: Sequence[str], terminal: int, environment: dict[str, str]) -> None:
        """Start it on a terminal, given by its descriptor."""
        self.patch = pytest.MonkeyPatch()
        self.patch.chdir(folder)
        for name, text in environment.items():
            self.patch.setenv(name, text)
        self.streams = [_stream(os.dup(terminal), name) for name in STREAMS]
        os.close(terminal)
        for name, stream in zip(STREAMS, self.streams, strict=True):
            self.patch.setattr(sys, name, stream)
        self.code: int | None = None
        self.is_over = False
        self.thread = Thread(target=self._run, args=(words,), daemon=True)
        self.thread.start()

    def _run(self, words: Sequence[str]) -> None:
        try:
            self.code = int(main(words))
        except Exception:
            if not self.is_over:  # else it is told that nobody listens any more, and cannot say so to anybody
                raise
        finally:
            for stream in self.streams:
                with contextlib.suppress(OSError):
                    stream.close()

    def wait(self) -> int:
        """Its exit code."""
        self.thread.join(PATIENCE)
        assert self.code is not None, "the command has not ended"
        return self.code

    def end(self, screen: int) -> None:
        """Close its screen, which ends whoever reads from it or writes to it."""
        self.is_over = True
        os.close(screen)
        self.thread.join(PATIENCE)
        self.patch.undo()
        assert not self.thread.is_alive(), "the command goes on without its terminal"


def _stream(descriptor: int, name: str) -> TextIO:
    """What Python makes of a terminal for one of the three streams."""
    mode = "rb" if name == "stdin" else "wb"
    binary = open(descriptor, mode, 0 if name == "stderr" else -1)  # noqa: SIM115  a descriptor, closed with the stream
    return io.TextIOWrapper(binary, "utf-8", line_buffering=name == "stdout", write_through=name == "stderr")
