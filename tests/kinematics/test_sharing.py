"""Threads that share a work hand its results over in order, however fast each part is."""

from __future__ import annotations

from collections.abc import Iterator
from threading import Barrier, Event, get_ident

import pytest

from dhcli.kinematics import sharing
from dhcli.kinematics.sharing import AHEAD, shared
from tests.row_by_row import row_by_row


@row_by_row("threads", [1, 2, 7])
@row_by_row("count", [0, 1, 5, 50])
def test_results_come_in_order(count: int, threads: int) -> None:
    """All of them, once."""
    assert list(shared(str, range(count), threads)) == [str(k) for k in range(count)]


def test_threads_work_at_the_same_time() -> None:
    """Each of three waits for the other two; a single one is the thread that asks."""
    meeting = Barrier(3, timeout=60)
    assert len({ident for ident, _ in shared(lambda _: (get_ident(), meeting.wait()), range(3), 3)}) == 3
    assert list(shared(lambda _: get_ident(), range(2), 1)) == [get_ident()] * 2


def test_threads_are_bounded(monkeypatch: pytest.MonkeyPatch) -> None:
    """However many are asked for."""
    monkeypatch.setattr(sharing, "MOST", 3)
    assert len(set(shared(lambda _: get_ident(), range(200), 10**9))) <= 3


def test_only_few_parts_are_taken_ahead() -> None:
    """Else an endless work would fill the memory before its first result is used."""
    taken: list[int] = []

    def endless() -> Iterator[int]:
        while True:
            taken.append(len(taken))
            yield taken[-1]

    results = shared(lambda part: part, endless(), 2)
    assert [next(results), next(results)] == [0, 1]
    assert len(taken) <= 2 * AHEAD + 2
    results.close()  # type: ignore[attr-defined]  # a generator


def test_an_error_of_one_part_ends_the_work() -> None:
    """It is raised where its result would come, and what waits is not begun."""
    begun: list[int] = []
    may_go_on = Event()

    def work(part: int) -> int:
        begun.append(part)
        if part == 2:
            raise ArithmeticError(part)
        if part > 2:
            may_go_on.wait(60)
        return part

    results = shared(work, range(1000), 2)
    assert [next(results), next(results)] == [0, 1]
    may_go_on.set()
    with pytest.raises(ArithmeticError, match="2"):
        next(results)
    assert len(begun) < 20


@pytest.mark.parametrize("threads", [1, 2, 5])
def test_what_went_before_a_fault_is_there_with_any_number_of_threads(threads: int) -> None:
    """Also where no more than a few parts could be begun before the parts themselves end badly."""

    def parts() -> Iterator[int]:
        yield from range(7)
        raise ValueError("no more")

    found = list[int]()
    with pytest.raises(ValueError, match="no more"):
        found.extend(shared(lambda part: part * part, parts(), threads))
    assert found == [0, 1, 4, 9, 16, 25, 36]
