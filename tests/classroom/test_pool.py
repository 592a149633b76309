"""Processes that die are replaced, and what they worked on is told."""

from __future__ import annotations

from dhcli.classroom.pool import Lost, spread
from tests.classroom.workers import halved


def test_every_task_has_one_outcome() -> None:
    """However many processes die on the way: each odd number kills one."""
    outcomes = list(spread(halved, range(12), jobs=3, timeout=60))
    assert sorted(task for task, _ in outcomes) == list(range(12))
    assert dict(outcomes) == {n: Lost.DIED if n % 2 else n / 2 for n in range(12)}


def test_no_task_needs_no_process() -> None:
    """Nothing to do, nothing done."""
    assert list(spread(halved, [], jobs=3, timeout=60)) == []
