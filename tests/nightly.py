"""How much is tried: a part of it in ordinary runs, all of it with `--hypothesis-profile nightly`.

Every law and every kind of case is tried in both; a test that only nightly runs has others beside it for the same code.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product
from typing import TypeVar

from hypothesis import settings

T = TypeVar("T")
U = TypeVar("U")

NIGHT = settings.get_current_profile_name() == "nightly"
"""Whether all is tried."""


def examples(share: float) -> settings:
    """So many of the examples that the profile tries: `@examples(2)` for twice as many as usual."""
    return settings(max_examples=max(1, round(share * settings().max_examples)))


def some(cases: Sequence[T], step: int) -> Sequence[T]:
    """Every so many-th of the cases, the first and the last among them; all of them at night."""
    return cases if NIGHT else [*cases[:-1:step], *cases[-1:]]


def in_turn(cases: Sequence[T], turn: int, turns: int) -> Sequence[T]:
    """The cases that fall to one of several turns, so that each case is tried in one; all of them at night."""
    return cases if NIGHT else cases[turn % turns :: turns]


def paired(first: Sequence[T], second: Sequence[U]) -> Sequence[tuple[T, U]]:
    """Pairs of the cases of two kinds, in which each case of both occurs; every pair at night."""
    if NIGHT:
        return list(product(first, second))
    return [(first[k % len(first)], second[k % len(second)]) for k in range(max(len(first), len(second)))]


def cases_for_nights(cases: Sequence[T], *ordinary: T) -> Sequence[T]:
    """Cases of a test, all of them nightly but those named; by day the thousands of others are not even made."""
    assert set(ordinary) <= set(cases)
    return cases if NIGHT else [case for case in cases if case in ordinary]
