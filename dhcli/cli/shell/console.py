"""The two streams: results on stdout, talk on stderr; a reader that goes away is no error."""

from __future__ import annotations

import errno
import io
import os
import sys
from collections.abc import Iterable, Sequence
from contextlib import suppress
from itertools import pairwise
from typing import Any, BinaryIO, TextIO, cast

from dhcli.errors import FileError, Place, Problem

_CLOSED = {errno.EPIPE, errno.EINVAL, errno.ESHUTDOWN}
"""What writing to a pipe without a reader fails with; Windows says EINVAL."""


class GuardedStream:
    """A text stream that takes everything in silence once its reader has gone away.

    The work of a command is done when it writes; `dhcli fk scara | head -1` has the exit code of that work.

    Attributes:
        is_read: Whether anybody still reads.
    """

    def __init__(self, stream: TextIO, *, is_talk: bool = False) -> None:
        """Stand before a stream.

        Args:
            stream: The stream.
            is_talk: Whether what is written there may be lost: the exit code tells what cannot be said on a full disk.
        """
        self._stream = stream
        self._is_talk = is_talk
        self.is_read = True

    @classmethod
    def around(cls, stream: TextIO | None, *, is_talk: bool = False) -> TextIO:
        """The guarded stream; nowhere, if the caller has closed it."""
        return cast("TextIO", cls(stream or open(os.devnull, "w", encoding="utf-8"), is_talk=is_talk))  # noqa: PTH123

    def write(self, text: str) -> int:
        """Write, or forget it if nobody reads any more."""
        try:
            return self._stream.write(text)
        except UnicodeEncodeError:  # a help page, or a name: what dhcli draws itself is spelled for its paper
            from dhcli.render.paper import in_ascii

            return self.write("\n".join(map(in_ascii, text.split("\n"))))
        except OSError as error:
            self._let_go(error)
        return len(text)

    def write_bytes(self, content: bytes) -> int:
        """Write what is no text, or forget it if nobody reads any more."""
        try:
            self._stream.flush()
            self._stream.buffer.write(content)
            self._stream.buffer.flush()
        except OSError as error:
            self._let_go(error)
        return len(content)

    def flush(self) -> None:
        """Flush, or forget it if nobody reads any more."""
        try:
            self._stream.flush()
        except OSError as error:
            self._let_go(error)

    def _let_go(self, error: OSError) -> None:
        if error.errno not in _CLOSED and not self._is_talk:
            reason = error.strerror or str(error)
            self._to_nowhere()
            raise FileError(Problem(f"cannot be written: {reason}", Place("standard output"))) from None
        self._to_nowhere()

    def _to_nowhere(self) -> None:
        """What is left in buffers would fail again when Python ends; the null device takes it."""
        self.is_read = False
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, self._stream.fileno())
        os.close(nowhere)

    def __getattr__(self, name: str) -> Any:  # noqa: ANN401  whatever the stream has
        return getattr(self._stream, name)


def write_out(text: str) -> None:
    """Write a result."""
    sys.stdout.write(text)


def somebody_reads() -> bool:
    """Whether what is written to stdout still has a reader; work that goes on for ever may end when it has none."""
    return bool(getattr(sys.stdout, "is_read", True))


def raw_out() -> BinaryIO:
    """Standard output for bytes, as forgiving as it is for text."""
    return cast("BinaryIO", _RawOut())


class _RawOut(io.RawIOBase):
    """A stream of bytes in front of the guarded stdout."""

    def writable(self) -> bool:
        """Yes; but it cannot be turned back."""
        return True

    def write(self, content: bytes) -> int:  # type: ignore[override]  # only bytes are written here
        """Write, or forget it if nobody reads any more."""
        return cast("GuardedStream", sys.stdout).write_bytes(content)


def say(text: str) -> None:
    """Write talk: errors, warnings, what was done."""
    sys.stdout.flush()
    sys.stderr.write(text)


def tell(text: str) -> None:
    """Write talk that has foreign text in it, such as the name of a file, on a line of its own."""
    from dhcli.render.paper import Paper

    say(f"{Paper.of(sys.stderr).spell(text)}\n")


def finish() -> None:
    """Make sure that everything is written while errors can still be told."""
    sys.stdout.flush()


def complain(problems: Iterable[Problem], words: Sequence[str]) -> None:
    """Tell what went wrong, on stderr; with `--format json` also in the envelope on stdout."""
    from dhcli.render.paper import Paper
    from dhcli.render.text.problems import problems_text

    listed = list(problems)
    with suppress(FileError):  # results written before may have no room
        sys.stdout.flush()
    say(problems_text(listed, Paper.of(sys.stderr)))
    if wants_json(words):
        from dhcli.render.json.envelope import envelope

        with suppress(FileError):  # what went wrong first is what the exit code tells
            write_out(envelope(command_of(words), None, listed))
            sys.stdout.flush()


def wants_json(words: Sequence[str]) -> bool:
    """Whether the words ask for JSON on stdout; read without typer, which may have failed on them."""
    return "--format=json" in words or ("--format", "json") in pairwise(words)


def command_of(words: Sequence[str]) -> str:
    """The command that was typed, also behind an option that should stand behind it."""
    return next((word for before, word in pairwise(("", *words)) if word[:1] != "-" and before != "--format"), "")
