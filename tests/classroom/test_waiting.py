"""Tasks of a kind are done by the same, as long as there is other work for others."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhcli.classroom.waiting import Waiting


def by_letter(task: str) -> str:
    """The kind of `a1` is `a`."""
    return task[:1]


def test_everyone_goes_on_with_his_kind_and_then_takes_one_that_nobody_has() -> None:
    """And helps with the largest when there is none."""
    waiting = Waiting(["a1", "b1", "c1", "b2", "a2", "b3", "b4", "a3"], by_letter)
    assert [waiting.take(who) for who in (1, 2, 1, 2, 1)] == ["a1", "b1", "a2", "b2", "a3"]
    assert [waiting.take(1), waiting.take(1), waiting.take(2), len(waiting)] == ["c1", "b3", "b4", 0]
    with pytest.raises(LookupError):
        waiting.take(1)


def test_what_is_given_back_is_done_next_by_somebody_else() -> None:
    """In its order; the kind of whoever has gone is free again."""
    waiting = Waiting(["a1", "a2", "a3", "b1", "b2", "b3", "b4"], by_letter)
    assert [waiting.take(who) for who in (1, 1, 2)] == ["a1", "a2", "b1"]
    waiting.give_back(1, ["a1", "a2"])
    assert [waiting.take(3) for _ in range(3)] == ["a1", "a2", "a3"]


def test_kinds_that_are_nothing_are_kinds() -> None:
    """Empty text and None say nothing less than others."""
    waiting = Waiting([None, "", None, "", None, ""], lambda task: task)
    assert [waiting.take(who) for who in (1, 2, 1, 2, 1, 2)] == [None, "", None, "", None, ""]


@given(st.lists(st.text("abc", min_size=1, max_size=3)), st.lists(st.integers(0, 3)))
def test_every_task_is_taken_once(tasks: list[str], takers: list[int]) -> None:
    """Whoever comes, and whatever is given back meanwhile; those of a kind in their order."""
    waiting = Waiting(tasks, by_letter)
    taken: list[str] = []
    for who in takers:
        if len(waiting):
            task = waiting.take(who)
            waiting.give_back(who, [task])
            taken.append(waiting.take(who))
            assert by_letter(taken[-1]) in {by_letter(each) for each in tasks}
    while len(waiting):
        taken.append(waiting.take("the last"))
    assert sorted(taken) == sorted(tasks)
    for kind in "abc":
        assert [task for task in taken if task[0] == kind] == [task for task in tasks if task[0] == kind]
