"""Rotations printed with a few decimals: taken where their digits allow it, and the nearest rotation in their place."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from dhcli.algebra.floats import Floats
from dhcli.errors import NotationError, Place
from dhcli.geometry.orthonormal import not_a_rotation
from dhcli.geometry.printed import digit_slack, sharp_rows
from dhcli.kinematics.fold import fold
from dhcli.kinematics.moves import Fixed, Rot, read_chain, sharpened
from dhcli.kinematics.transform import Wanted, compose, read_product
from dhcli.notation.angle import Angle

angles = st.integers(-180, 180)


def printed(first: int, second: int, third: int, places: int) -> tuple[str, np.ndarray]:
    """A rotation with so many decimals, as text and in floats before it was rounded."""
    turns = (Rot("z", Angle.in_degrees(first)), Rot("y", Angle.in_degrees(second)), Rot("x", Angle.in_degrees(third)))
    right = np.array(fold(turns, Floats()), float)
    rows = [" ".join(f"{entry:.{places}f}" for entry in row[:3]) + f" {i}" for i, row in enumerate(right[:3])]
    return f"[{'; '.join(rows)}; 0 0 0 1]", right[:3, :3]


@given(angles, angles, angles, st.integers(2, 6))
@example(133, -86, -138, 2)
def test_every_rounded_rotation_is_taken_and_becomes_one(first: int, second: int, third: int, places: int) -> None:
    """Within its digits of the true one, orthonormal, and never again in need of sharpening."""
    text, right = printed(first, second, third, places)
    (move,) = read_chain(text)
    assert isinstance(move, Fixed)
    assert not_a_rotation(move.rows) == ""
    sharp, remark = sharp_rows(move.rows)
    found = np.array([[Floats().value(entry) for entry in row[:3]] for row in sharp])
    assert found == pytest.approx(right, abs=2 * 10.0**-places)
    assert found.T @ found == pytest.approx(np.eye(3), abs=1e-9)
    assert np.linalg.det(found) == pytest.approx(1, abs=1e-9)
    assert sharp_rows(sharp) == (sharp, "")
    typed = np.array([[Floats().value(entry) for entry in row[:3]] for row in move.rows])
    u, _, v = np.linalg.svd(typed)
    assert found == pytest.approx(u @ v, abs=1e-9)
    if remark:
        assert f"a matrix with {places} decimals" in remark or f"a matrix with {places - 1} decimal" in remark


@given(angles, angles, angles, st.integers(2, 5), st.integers(0, 8), st.sampled_from([-1, 1]))
def test_a_matrix_off_by_more_than_its_digits_is_no_rotation(
    first: int, second: int, third: int, places: int, entry: int, sign: int
) -> None:
    """One entry changed by thirty units of the last digit, in a column that shows it."""
    text, right = printed(first, second, third, places)
    row, column = divmod(entry, 3)
    if abs(right[row][column]) < 0.4:
        return  # a small cosine hardly changes the length of its column
    rows = [line.split() for line in text.strip("[]").split(";")]
    rows[row][column] = f"{float(rows[row][column]) + sign * 30 * 10.0**-places:.{places}f}"
    (move,) = read_chain("[" + "; ".join(" ".join(line) for line in rows) + "]")
    assert isinstance(move, Fixed)
    assert not_a_rotation(move.rows) != ""


def test_a_transform_takes_a_printed_matrix_and_says_so() -> None:
    """`dhcli transform` with two decimals; one that is no rotation is refused with its column."""
    product = read_product("[0.87 -0.5 0 1; 0.5 0.87 0 2; 0 0 1 3; 0 0 0 1]", Place("product"))
    result = compose(product, {}, Wanted())
    assert np.array(result.pose.rows, float)[:2, :2] == pytest.approx(
        np.array([[0.87, -0.5], [0.5, 0.87]]) / math.hypot(0.87, 0.5), abs=1e-12
    )
    said = (
        "a matrix with 2 decimals is a rotation to its digits; the nearest rotation is taken, an entry of it 0.003 away"
    )
    assert result.warnings == (said,)
    with pytest.raises(NotationError, match="this matrix is no pose: column 1 is not a unit vector"):
        read_product("[0.9 -0.5 0 1; 0.5 0.87 0 2; 0 0 1 3; 0 0 0 1]", Place("product"))
    assert (
        compose(read_product("[0.6 -0.8 0 1; 0.8 0.6 0 2; 0 0 1 3; 0 0 0 1]", Place("p")), {}, Wanted()).warnings == ()
    )


def test_exact_matrices_and_those_of_symbols_stay_as_they_are() -> None:
    """Zeros and ones are exact in the nearest rotation, too."""
    for text in ("[1 0 0 5; 0 1 0 6; 0 0 1 7; 0 0 0 1]", "[√3/2 -1/2 0 0; 1/2 √3/2 0 0; 0 0 1 0; 0 0 0 1]"):
        chain = read_chain(text)
        remarks: list[str] = []
        assert sharpened(chain, remarks) == chain
        assert remarks == []
    (move,) = read_chain("[0.87 -0.5 0 1; 0.5 0.87 0 2; 0 0 1 3; 0 0 0 1]")
    assert isinstance(move, Fixed)
    assert digit_slack(move.rows) == 0.005
    sharp, _ = sharp_rows(move.rows)
    assert [sharp[2][k] for k in range(4)] == [move.rows[2][k] for k in range(4)]
    assert sharpened((move,), None) == (move,)
