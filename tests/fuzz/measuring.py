"""Running one case with counters: how many calls it made, and how much memory it held at most.

Calls are counted, not seconds: a count is the same on every machine, and a case that would never end is stopped by it.
"""

from __future__ import annotations

import signal
import sys
import tracemalloc
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from types import FrameType
from typing import Any

MOST_CALLS = 8_000_000
"""Calls of functions; about a second of a processor without the counting."""
MOST_BYTES = 200_000_000
_LAST_RESORT = 60.0
"""Seconds of a processor after which work that makes no calls, such as a search for a pattern, is stopped."""


class TooMuchWorkError(BaseException):
    """More calls than allowed; no `Exception`, so that nobody takes it for a bug and goes on."""


@dataclass
class Count:
    """What a case took.

    Attributes:
        calls: How many functions were called.
        bytes: How much memory was held at most, beyond what was held before [B].
    """

    calls: int = 0
    bytes: int = 0


@contextmanager
def counted(*, memory: bool = True) -> Iterator[Count]:
    """Count what is done meanwhile.

    Args:
        memory: Whether memory is looked at, too; it takes as long as all the rest.

    Raises:
        TooMuchWorkError: It is more than `MOST_CALLS`, or no call was made for long.
    """
    count = Count()

    def called(_frame: FrameType, event: str, _argument: object) -> None:
        if event == "call":
            count.calls += 1
            if count.calls > MOST_CALLS:
                sys.setprofile(None)
                raise TooMuchWorkError(f"more than {MOST_CALLS:,} calls")

    before = sys.getprofile()
    if memory:
        tracemalloc.start()
    sys.setprofile(called)
    try:
        with _last_resort():
            yield count
    finally:
        sys.setprofile(before)
        if memory:
            count.bytes = tracemalloc.get_traced_memory()[1]
            tracemalloc.stop()


@contextmanager
def _last_resort() -> Iterator[None]:
    """Stop what goes on for ever within one call, where the system can."""
    if not hasattr(signal, "SIGPROF"):
        yield
        return

    def stop(*_: object) -> None:
        raise TooMuchWorkError("no end in sight")

    before: Callable[..., Any] | int | None = signal.signal(signal.SIGPROF, stop)
    signal.setitimer(signal.ITIMER_PROF, _LAST_RESORT)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
        signal.signal(signal.SIGPROF, before)
