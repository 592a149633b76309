"""Ctrl-C and its like while processes are started and ended: heard, and acted upon a moment later."""

from __future__ import annotations

import signal
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from threading import current_thread, main_thread

ENDINGS = tuple(getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name))
"""The signals at which work ends in order; the first is Ctrl-C."""


@contextmanager
def without_interrupts() -> Iterator[None]:
    """Hear Ctrl-C and its like only afterwards; a process that starts meanwhile never hears Ctrl-C.

    A process is started with the signals blocked that are blocked here. That does not keep them from this one: a
    signal goes to any thread that takes it, such as that of a progress bar, and Python raises it in the main thread.
    """
    if current_thread() is not main_thread():  # Python raises nothing here
        with _blocked():
            yield
        return
    heard: list[int] = []
    handlers = {number: signal.getsignal(number) for number in ENDINGS}
    handlers = {number: handler for number, handler in handlers.items() if handler not in {None, signal.SIG_IGN}}
    try:
        with ExitStack() as before:  # whatever comes in between, each gets back what it had, Ctrl-C last
            for number, handler in handlers.items():
                before.callback(signal.signal, number, handler)
                signal.signal(number, lambda number, _: heard.append(number))
            with _blocked():
                yield
    finally:
        for number in heard[:1]:
            signal.raise_signal(number)


@contextmanager
def _blocked() -> Iterator[None]:
    """Block Ctrl-C and its like in this thread, and in processes that it starts, where the system can."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, ENDINGS)
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def start_tracker() -> None:
    """Start what Python keeps beside processes that start from nothing, deaf to what this one is deaf to just now."""
    if not hasattr(signal, "pthread_sigmask"):  # there it keeps nothing
        return
    from multiprocessing import resource_tracker

    blocked = signal.pthread_sigmask(signal.SIG_BLOCK, ())
    resource_tracker.ensure_running()
    signal.pthread_sigmask(signal.SIG_SETMASK, blocked)  # Python unblocks Ctrl-C and SIGTERM when it has started it
