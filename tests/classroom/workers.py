"""What processes do in tests instead of grading: they get stuck, or die, on the sheets that say so."""

from __future__ import annotations

import os
import signal
import sys
import threading

from dhcli.checking.verdicts import Verdict
from dhcli.classroom.folder import Submission
from dhcli.classroom.grades import Graded, PartGrade


def trouble(submission: Submission, only: str | None = None) -> Graded:
    """A grade at once; never one for a sheet called `stuck`, and the end of the process for one called `deadly`."""
    if submission.student.startswith("stuck"):
        print("stuck", flush=True)  # noqa: T201  whoever waits for it reads the pipe
        threading.Event().wait()
    if submission.student.startswith("deadly"):
        os._exit(1)
    return Graded(submission.sheet, submission.student, "course/one", "", (PartGrade("a", Verdict.RIGHT, 1.0, 1.0),))


def halved(number: int) -> float:
    """Half of a number, unless it is odd: then the process dies."""
    if number % 2:
        os._exit(1)
    return number / 2


def deaf(_: object) -> bool:
    """Whether Ctrl-C is blocked in the process."""
    return signal.SIGINT in signal.pthread_sigmask(signal.SIG_BLOCK, [])


def known(module: str) -> bool:
    """Whether the process has imported a module."""
    return module in sys.modules


def endings(_: object) -> tuple[str, ...]:
    """What the process does at signals that ask it to end."""
    handlers = (signal.getsignal(number) for number in (signal.SIGTERM, signal.SIGHUP))
    return tuple(getattr(handler, "name", "its own") for handler in handlers)
