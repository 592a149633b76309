"""A few equations in floats, against numpy."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from dhcli.errors import RobotError
from dhcli.geometry.linear import determinant_of, rank, solution

ENTRY = st.sampled_from((0.0, 1.0, -1.0, 0.25, -3.5, 0.1, 40.0))


@st.composite
def squares(draw: st.DrawFn) -> list[list[float]]:
    """Square matrices with many zeros."""
    size = draw(st.integers(1, 6))
    return draw(st.lists(st.lists(ENTRY, min_size=size, max_size=size), min_size=size, max_size=size))


@given(squares(), st.data())
def test_a_solution_solves_and_there_is_one_where_the_determinant_is_not_zero(
    rows: list[list[float]], data: st.DataObject
) -> None:
    """Whatever the order of the rows and columns that have the pivots."""
    found = float(np.linalg.det(np.array(rows)))
    assert determinant_of(rows) == pytest.approx(found, abs=1e-6, rel=1e-6)
    assume(abs(found) > 1e-3 or rank(rows) < len(rows))
    right = data.draw(st.lists(ENTRY, min_size=len(rows), max_size=len(rows)))
    if rank(rows) < len(rows):
        with pytest.raises(RobotError, match="singular"):
            solution(rows, right)
    else:
        assert np.array(rows) @ np.array(solution(rows, right)) == pytest.approx(np.array(right), abs=1e-6)
