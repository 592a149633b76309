"""Processes that die are replaced, and what they worked on is told."""

from __future__ import annotations

import os
import signal

import pytest

from dhcli.classroom.pool import Lost, _Worker, spread
from tests.classroom.workers import halved


def test_every_task_has_one_outcome() -> None:
    """However many processes die on the way: each odd number kills one."""
    outcomes = list(spread(halved, range(12), jobs=3, timeout=60))
    assert sorted(task for task, _ in outcomes) == list(range(12))
    assert dict(outcomes) == {n: Lost.DIED if n % 2 else n / 2 for n in range(12)}


def test_no_task_needs_no_process() -> None:
    """Nothing to do, nothing done."""
    assert list(spread(halved, [], jobs=3, timeout=60)) == []


@pytest.mark.skipif(os.name == "nt", reason="signals as Unix knows them")
def test_ctrl_c_while_a_process_ends_leaves_it_ended(monkeypatch: pytest.MonkeyPatch) -> None:
    """At the worst moment: the system has told that the process is gone, and tells it once; nobody wrote it down."""
    worker = _Worker(halved)
    wait = os.waitpid

    def interrupted(process: int, options: int) -> tuple[int, int]:
        told = wait(process, options)
        signal.raise_signal(signal.SIGINT)
        return told

    with monkeypatch.context() as patched:
        patched.setattr(os, "waitpid", interrupted)
        with pytest.raises(KeyboardInterrupt):
            worker.end()
    worker.end()  # as `spread` does on its way out
    assert worker.pipe.closed
