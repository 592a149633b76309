"""All sheets of a class graded, in parallel."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import closing
from functools import partial

from dhcli.classroom.folder import Submission
from dhcli.classroom.grades import Graded, failed
from dhcli.classroom.pool import Lost, spread
from dhcli.errors import Problem

TIMEOUT = 10.0
"""Seconds that one sheet may take; an honest one takes a hundredth of one."""

_GLANCE = 1024
"""Bytes of a sheet before which it has named its exercise; one that has not is graded all the same."""

MARKING = "dhcli.classroom.marking"
"""What grades a sheet, imported where it is graded, and not where the grades are collected."""


def _graded(submission: Submission, only: str | None = None) -> Graded:
    """One sheet."""
    from dhcli.classroom.marking import grade

    return grade(submission, only)


def grade_all(
    submissions: Sequence[Submission],
    only: str | None = None,
    *,
    jobs: int,
    timeout: float = TIMEOUT,
    tell: Callable[[], object] = lambda: None,
    work: Callable[..., Graded] = _graded,
) -> tuple[Graded, ...]:
    """Grade the sheets of a class in several processes.

    Args:
        submissions: The sheets.
        only: The exercise that all of them should be of; each says its own by default.
        jobs: Most processes at a time.
        timeout: Longest that one sheet may take [s].
        tell: Called when a sheet is done.
        work: What grades one sheet; another one only in tests.

    Returns:
        The grades in the order of the sheets.
    """
    graded: dict[Submission, Graded] = {}
    named = _named if only is None else lambda _: only
    done = spread(partial(work, only=only), submissions, jobs=jobs, timeout=timeout, needs=MARKING, alike=named)
    with closing(done) as outcomes:
        for submission, outcome in outcomes:
            graded[submission] = _lost(submission, outcome, timeout) if isinstance(outcome, Lost) else outcome
            tell()
    return tuple(graded[submission] for submission in submissions)


def _named(submission: Submission) -> bytes:
    """Which exercise a sheet seems to be of, at a glance: one process works out an exercise for all of its sheets."""
    if submission.problem:
        return b""
    try:
        with open(submission.path, "rb") as sheet:
            lines = sheet.read(_GLANCE).splitlines()
    except OSError:
        return b""
    return next((line for line in lines if line.startswith(b"exercise:")), b"")


def _lost(submission: Submission, why: Lost, timeout: float) -> Graded:
    if why is Lost.TIMED_OUT:
        problem = Problem(f"took longer than {timeout:g} s", hint="--timeout gives it more")
    else:
        problem = Problem("the process that graded it died", hint="perhaps it ran out of memory")
    return failed(Graded(submission.sheet, submission.student), problem)
