"""Rigid motions: a group, the same over every arithmetic, and floats by themselves no other than all others."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhcli.algebra.floats import Floats
from dhcli.algebra.terms import TERMS
from dhcli.geometry.linear import pivots
from dhcli.geometry.motion import identity, inverse, product
from dhcli.geometry.orthonormal import faults
from dhcli.geometry.rigid import Rigid
from dhcli.geometry.twists import about, along, displacements
from dhcli.geometry.twists import inverse as inverse_pose
from dhcli.kinematics.fold import fold
from dhcli.kinematics.moves import read_chain
from dhcli.notation.tree import Expr

number = st.floats(-3, 3)
vectors = st.tuples(number, number, number)
axes = vectors.filter(lambda v: math.hypot(*v) > 0.1).map(lambda v: tuple(x / math.hypot(*v) for x in v))
rigid = st.builds(Rigid.turn, axes, number, vectors).flatmap(
    lambda turn: vectors.map(lambda offset: Rigid.shift(offset) @ turn)
)


def whole(motion: Rigid) -> np.ndarray:
    """The homogeneous matrix, shape (4, 4)."""
    return np.array([*motion.motion, (0, 0, 0, 1)])


@given(rigid, rigid)
def test_the_product_is_that_of_the_matrices(one: Rigid, other: Rigid) -> None:
    """In floats, where none is structural, and by the general product."""
    expected = whole(one) @ whole(other)
    assert np.allclose(whole(one @ other), expected, rtol=0, atol=1e-12)
    assert np.allclose(product(one.motion, other.motion), expected[:3], rtol=0, atol=1e-12)


@given(rigid)
def test_the_inverse_undoes_a_motion(motion: Rigid) -> None:
    """From either side; structural numbers stay what they are."""
    assert np.allclose(whole(motion.inverse() @ motion), np.eye(4), rtol=0, atol=1e-12)
    assert np.allclose(product(motion.motion, inverse(motion.motion)), np.eye(4)[:3], rtol=0, atol=1e-12)
    assert np.allclose(inverse_pose(whole(motion)), whole(motion.inverse()), rtol=0, atol=1e-12)
    assert product(identity(), motion.motion) == [list(row) for row in motion.motion]
    assert inverse(identity()) == identity()


@given(axes, vectors, number)
def test_a_turn_about_a_line_is_the_exponential_of_its_twist(
    axis: tuple[float, float, float], point: tuple[float, float, float], angle: float
) -> None:
    """With numpy and without; a slide likewise."""
    turn, slide = about(np.array(point), np.array(axis)), along(np.array(axis))
    both = displacements(np.array([turn, slide]), np.array([angle, angle]))
    assert np.allclose(both[0], whole(Rigid.turn(axis, angle, point)), rtol=0, atol=1e-12)
    assert np.allclose(both[1][:3, 3], np.array(axis) * angle, rtol=0, atol=1e-12)


@given(number, number)
def test_a_product_in_terms_is_the_product_in_numbers(angle: float, length: float) -> None:
    """With the numbers put in."""
    chains = [read_chain("Rot(x, t) Trans(l, 2, 0)"), read_chain("Rot(z, t) Trans(0, l, 1)")]
    values = Floats({"t": angle, "l": length})
    terms = product(*(fold(chain, TERMS) for chain in chains))
    found = [[values.value(entry) if isinstance(entry, Expr) else entry for entry in row] for row in terms]
    assert np.allclose(found, product(*(fold(chain, values) for chain in chains)), rtol=0, atol=1e-12)


@pytest.mark.parametrize(
    ("columns", "expected"),
    [
        (((1, 0, 0), (0, 1, 0), (0, 0, 1)), []),
        (((1, 0, 0), (0, 1, 0), (0, 0, -1)), [(0, 1, 2)]),
        (((2, 0, 0), (0, 1, 0), (0, 0, 1)), [(0,)]),
        (((1, 0, 0), (0.6, 0.8, 0), (0, 0, 3)), [(0, 1), (2,)]),
        (((0, 1, 0), (0, 0, 1), (1, 0, 0)), []),
        (((0, 1, 0), (1, 0, 0), (0, 0, 1)), [(0, 1, 2)]),
    ],
)
def test_what_keeps_columns_from_being_a_rotation_is_told(
    columns: tuple[tuple[float, ...], ...], expected: list[tuple[int, ...]]
) -> None:
    """Every length, every pair, and the sense in which they follow each other."""
    rows = list(zip(*columns, strict=True))
    assert list(faults(rows, lambda a, b: abs(a - b) < 1e-9)) == expected


@given(st.integers(0, 4), st.integers(0, 2**32 - 1))
def test_there_are_as_many_pivots_as_the_rank(rank: int, seed: int) -> None:
    """Longest first, and none longer than the largest singular value."""
    draw = np.random.default_rng(seed)
    matrix = draw.uniform(-1, 1, (6, rank)) @ draw.uniform(-1, 1, (rank, 5))
    found = pivots(matrix.T.tolist())
    values = np.linalg.svd(matrix, compute_uv=False)
    if rank == 0 or values[rank - 1] > 1e-3:
        assert len(found) == rank
        assert found == sorted(found, reverse=True)
        assert found[0] <= values[0] + 1e-9 if found else rank == 0
