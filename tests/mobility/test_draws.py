"""Random numbers of linkages: drawn once for all time."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from dhcli.mobility.draws import Draws


@given(st.integers(0, 50), st.lists(st.integers(0, 4), max_size=3))
def test_a_seed_draws_the_same_in_any_shape(seed: int, shape: list[int]) -> None:
    """The numbers follow one another row by row."""
    drawn = Draws(seed).normal(*shape)
    assert drawn.shape == tuple(shape)
    assert drawn.dtype == float
    assert (drawn.ravel() == Draws(seed).normal(drawn.size)).all()


def test_they_are_normal_and_differ() -> None:
    """Mean and deviation of many, and another seed."""
    drawn = Draws(1).normal(20_000)
    assert abs(drawn.mean()) < 0.03
    assert abs(drawn.std() - 1) < 0.03
    assert abs(np.mean(np.abs(drawn) < 1) - 0.6827) < 0.02
    assert not np.isclose(drawn[:100], Draws(2).normal(100)).any()


@given(st.integers(0, 50), st.integers(0, 9))
def test_shuffled_rows_are_the_same_rows(seed: int, count: int) -> None:
    """In an order of the seed's."""
    rows = np.arange(2 * count).reshape(count, 2)
    found = Draws(seed).shuffled(rows)
    assert sorted(found.tolist()) == rows.tolist()
    assert (found == Draws(seed).shuffled(rows)).all()
