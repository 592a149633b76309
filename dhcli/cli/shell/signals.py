"""Being told to end: SIGTERM and SIGHUP stop the work as Ctrl-C does, so that nothing half-done is left behind."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType

from dhcli.errors import ExitStatus

_STATUS = {"SIGTERM": ExitStatus.TERMINATED, "SIGHUP": ExitStatus.HUNG_UP}
"""The signals that ask a process to end, where the system has them, and the exit code that each leads to."""


@contextmanager
def ending_in_order() -> Iterator[None]:
    """Raise `SystemExit` when a signal asks for it; one that is ignored (`nohup`) or has a handler stays as it is."""
    if threading.current_thread() is not threading.main_thread():  # only there may Python set handlers
        yield
        return
    known = {getattr(signal, name): status for name, status in _STATUS.items() if hasattr(signal, name)}
    taken = [number for number in known if signal.getsignal(number) is signal.SIG_DFL]

    def end(number: int, _: FrameType | None) -> None:
        for each in taken:  # what is cleaned up now must not be stopped again; SIGKILL and Ctrl-C still can
            signal.signal(each, signal.SIG_IGN)
        raise SystemExit(known[number])

    for number in taken:
        signal.signal(number, end)
    try:
        yield
    finally:
        for number in taken:
            signal.signal(number, signal.SIG_DFL)
