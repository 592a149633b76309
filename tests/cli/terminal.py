"""A terminal for commands that only talk to people: a pseudo-terminal, read until what is waited for has come."""

from __future__ import annotations

import contextlib
import os
import re
import select
import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from time import monotonic
from types import TracebackType
from typing import Self

ROOT = Path(__file__).parents[2]
PATIENCE = 30.0
"""Seconds after which what has not come will not come."""


class Terminal:
    """A command that runs on a terminal of its own."""

    def __init__(self, folder: Path, *words: str, no_color: str = "1") -> None:
        """Start `dhcli` with these words in a folder, by default without colour."""
        import pty

        self.screen, other = pty.openpty()
        environment = {**os.environ, "PYTHONPATH": str(ROOT), "COLUMNS": "100", "NO_COLOR": no_color}
        command = [sys.executable, "-m", "dhcli", *words]
        self.running = subprocess.Popen(command, stdin=other, stdout=other, stderr=other, cwd=folder, env=environment)
        os.close(other)
        self.seen = ""

    def __enter__(self) -> Self:
        """Itself."""
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        """End what still runs."""
        if self.running.poll() is None:
            self.running.kill()
        self.running.wait()
        os.close(self.screen)

    def type(self, text: str) -> None:
        """Press keys."""
        os.write(self.screen, text.encode())

    def interrupt(self) -> None:
        """What Ctrl-C does."""
        self.running.send_signal(signal.SIGINT)

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
        return self.running.wait(timeout=PATIENCE)

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
