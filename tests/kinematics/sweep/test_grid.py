"""Grids are the products that they stand for, without holding them."""

from __future__ import annotations

from fractions import Fraction
from itertools import product

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhcli.kinematics.derived import in_floats
from dhcli.kinematics.robot import Value
from dhcli.kinematics.sweep import walk
from dhcli.kinematics.sweep.grid import Axis, Grid
from dhcli.kinematics.sweep.walk import slabs, tables_of
from dhcli.notation.angle import Angle
from dhcli.notation.tree import number
from tests.strategies import numeric_angles

lengths = st.fractions(-10, 10, max_denominator=10**6).map(number)
ends = st.one_of(st.tuples(numeric_angles, numeric_angles), st.tuples(lengths, lengths))
axes = st.builds(lambda ends, count: Axis("q", *ends, count), ends, st.integers(1, 12))


@given(axes)
def test_the_floats_of_an_axis_are_those_of_its_exact_values(axis: Axis) -> None:
    """To the last bit, so that a pose computed again is the same pose."""
    assert axis.floats() == [in_floats(axis.at(k)) for k in range(axis.count)]


@pytest.mark.parametrize(
    ("first", "last", "count"),
    [
        (Angle.in_degrees(-90), Angle.in_degrees(90), 37),
        (number(Fraction(0)), number(Fraction(1, 5)), 11),
        (Angle(radians=Fraction(3, 10)), Angle.in_degrees(90), 4),
    ],
)
def test_an_axis_meets_both_ends_and_its_steps_are_equal(first: Value, last: Value, count: int) -> None:
    """In degrees, metres, and from radians to degrees."""
    axis = Axis("q", first, last, count)
    assert (axis.at(0), axis.at(count - 1)) == (first, last)
    assert np.allclose(np.diff(axis.floats()), in_floats(axis.step), rtol=1e-12)


def test_decimal_steps_are_the_decimals_that_a_person_writes() -> None:
    """Not 0.06000000000000001."""
    axis = Axis("d3", number(0), number(Fraction(1, 5)), 11)
    assert axis.floats() == [0.0, 0.02, 0.04, 0.06, 0.08, 0.1, 0.12, 0.14, 0.16, 0.18, 0.2]


@given(st.lists(axes, min_size=1, max_size=4), st.integers(1, 50))
def test_the_rows_of_a_grid_are_the_product_of_its_axes(axes: list[Axis], block: int) -> None:
    """In the order of itertools.product, whatever the blocks; and the exact pose of each number is its row."""
    grid = Grid(tuple(Axis(f"q{k}", axis.first, axis.last, axis.count) for k, axis in enumerate(axes)))
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(walk, "BLOCK", block)
        blocks = [slab.rows(tables_of(grid)) for slab in slabs(grid)]
    rows = [tuple(row) for rows in blocks for row in rows.tolist()]
    assert rows == list(product(*(axis.floats() for axis in grid.axes)))
    assert all(len(rows) <= block for rows in blocks)
    for index in {0, len(rows) // 2, len(rows) - 1}:
        assert tuple(map(in_floats, grid.at(index).values())) == rows[index]


def test_a_large_grid_costs_nothing_until_it_is_walked() -> None:
    """10^18 poses; the first block is made alone."""
    grid = Grid(tuple(Axis(f"q{k}", number(0), number(1), 1000) for k in range(6)))
    assert grid.count == 10**18
    assert in_floats(grid.at(10**18 - 1)["q0"]) == 1.0
    assert walk.BLOCK / 2 < len(next(slabs(grid)).rows(tables_of(grid))) <= walk.BLOCK
