"""Three turns about coordinate axes, in all 24 orders: there and back, both triples, and where two fall in line."""

from __future__ import annotations

import math
from itertools import product

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhcli.algebra.floats import Floats
from dhcli.errors import UnknownNameError
from dhcli.geometry.euler import AXES, ORDERS, EulerAngles, Order, RollPitchYaw, euler
from dhcli.geometry.rotations import AxisAngle, Quaternion, RotationVector
from dhcli.kinematics.fold import fold
from dhcli.kinematics.moves import read_chain
from tests.row_by_row import row_by_row

Cosines = list[list[float]]

orders = st.sampled_from(ORDERS)
angles = st.floats(-math.pi, math.pi)
nearly = st.builds(  # at right angles, and by a hair, a trifle or a rounding beside them
    lambda quarter, beside: quarter * math.pi / 2 + beside,
    st.integers(-2, 2),
    st.one_of(st.just(0.0), st.floats(-1e-5, 1e-5), st.floats(-1e-9, 1e-9), st.floats(-1e-12, 1e-12)),
)
triples = st.tuples(*[st.one_of(angles, nearly)] * 3)


def folded(text: str, **values: float) -> Cosines:
    """Direction cosines of a product of moves, by the fold that robots use."""
    return [list(row[:3]) for row in fold(read_chain(text), Floats(values))[:3]]


def turned(order: Order, values: tuple[float, ...]) -> Cosines:
    """A rotation by an order as people write it: current axes from left to right, fixed ones from right to left."""
    moves = [f"Rot({axis}, {name})" for axis, name in zip(order.axes, "abc", strict=True)]
    text = " ".join(reversed(moves) if order.fixed else moves)
    return folded(text, **dict(zip("abc", values, strict=True)))


def test_there_are_twelve_orders_about_current_axes_and_twelve_about_fixed_ones() -> None:
    """Each axis is another one than that before it."""
    assert len(AXES) == len({*AXES}) == 12
    assert {"".join(axes) for axes in product("xyz", repeat=3) if axes[0] != axes[1] != axes[2]} == {*AXES}
    assert len(ORDERS) == len({*ORDERS}) == 24
    assert euler("ZYZ") is not None
    assert euler(" zyz ", fixed=True) == Order("zyz", fixed=True)


@pytest.mark.parametrize("axes", ["", "zz", "zzy", "xyzx", "abc", "z-y-z"])
def test_other_orders_are_refused(axes: str) -> None:
    """And those that there are listed."""
    with pytest.raises(UnknownNameError, match="no order") as caught:
        euler(axes)
    assert "zyz" in str(caught.value)


@given(orders, triples)
def test_the_matrix_of_three_angles_is_that_of_their_moves(order: Order, values: tuple[float, float, float]) -> None:
    """The fold of a chain says the same."""
    assert np.allclose(EulerAngles(order, values).rotation(), turned(order, values), rtol=0, atol=1e-14)


@given(orders, triples, st.sampled_from(["left", "right"]))
def test_both_triples_give_the_matrix_back(order: Order, values: tuple[float, float, float], free: str) -> None:
    """To 1e-12 wherever the middle angle is, and each of them is the other's other."""
    matrix = turned(order, values)
    found = order.of(matrix, free)  # type: ignore[arg-type]
    middle = found.angles[1]
    assert (0 <= middle <= math.pi) if order.is_proper else abs(middle) <= math.pi / 2
    for triple in (found, found.other):
        assert np.allclose(turned(order, triple.angles), matrix, rtol=0, atol=1e-12)
        assert max(map(abs, triple.angles)) <= math.pi
    again = found.other.other.angles
    assert np.allclose(np.exp(1j * np.array(again)), np.exp(1j * np.array(found.angles)), rtol=0, atol=1e-12)


@given(orders, st.tuples(st.floats(-3.1, 3.1), st.floats(0.05, 1.5), st.floats(-3.1, 3.1)))
def test_away_from_singular_attitudes_the_angles_are_the_ones_put_in(
    order: Order, values: tuple[float, float, float]
) -> None:
    """The angles themselves."""
    found = order.of(turned(order, values))
    assert found.angles == pytest.approx(values, abs=1e-12)
    assert not found.locked


@row_by_row("order", ORDERS)
@row_by_row(("left", "right"), [(0.7, -0.4), (-2.0, 1.5), (0.0, 0.0)])
def test_at_a_singular_attitude_one_turn_is_none_and_the_other_takes_it_all(
    order: Order, left: float, right: float
) -> None:
    """Which of the two may be chosen; left alone it is the right one of the product."""
    for middle in (0.0, math.pi) if order.is_proper else (math.pi / 2, -math.pi / 2):
        values = (right, middle, left) if order.fixed else (left, middle, right)
        matrix = turned(order, values)
        assert order.of(matrix) == order.of(matrix, "right")
        for free, place in (("left", 0), ("right", 2)):
            found = order.of(matrix, free)  # type: ignore[arg-type]
            assert found.locked
            assert found.angles[2 - place if order.fixed else place] == 0
            assert math.cos(found.angles[1] - middle) == pytest.approx(1)
            assert np.allclose(turned(order, found.angles), matrix, rtol=0, atol=1e-12)


@given(st.floats(-12, -4), st.sampled_from([1, -1]), angles, angles)
def test_roll_pitch_yaw_near_the_poles_give_the_matrix_back_to_twelve_digits(
    exponent: float, side: int, roll: float, yaw: float
) -> None:
    """Two angles that are taken from small entries one by one would be 1e-16 divided by the distance off."""
    pitch = side * (math.pi / 2 - 10**exponent)
    matrix = folded("Rot(z, c) Rot(y, b) Rot(x, a)", a=roll, b=pitch, c=yaw)
    found = RollPitchYaw.of(matrix)
    back = folded("Rot(z, c) Rot(y, b) Rot(x, a)", a=found.roll, b=found.pitch, c=found.yaw)
    assert np.allclose(back, matrix, rtol=0, atol=1e-12)
    assert np.allclose(found.rotation(), matrix, rtol=0, atol=1e-12)


def test_angles_come_in_degrees_as_well() -> None:
    """The vertical wrist of a textbook: turned about z by 90°, tilted by 60° and turned back by 30°."""
    matrix = folded("Rot(z, 90°) Rot(y, 60°) Rot(z, -30°)")
    assert euler("zyz").of(matrix).degrees == pytest.approx((90, 60, -30))
    assert euler("zyz").of(matrix).other.degrees == pytest.approx((-90, -60, 150))


@given(st.tuples(*[st.floats(-1.8, 1.8)] * 3))
def test_a_rotation_vector_is_the_axis_times_the_angle(vector: tuple[float, float, float]) -> None:
    """As long as the angle is at most half a turn."""
    size = math.hypot(*vector)
    if size > math.pi - 1e-3:
        return
    matrix = RotationVector(*vector).rotation()
    assert RotationVector.of(matrix).numbers == pytest.approx(vector, abs=1e-12)
    found = AxisAngle.of(matrix)
    if size > 1e-8:
        assert [part * found.angle for part in found.axis] == pytest.approx(vector, abs=1e-12)


@given(st.integers(-300, -1), st.integers(-9, 9), st.integers(-9, 9))
def test_the_smallest_rotation_vector_keeps_its_digits(exponent: int, x: int, y: int) -> None:
    """Where no axis can be told any more, too."""
    vector = (x * 10.0**exponent, y * 10.0**exponent, 5 * 10.0**exponent)
    if math.hypot(*vector) < math.pi:
        assert RotationVector.of(RotationVector(*vector).rotation()).numbers == pytest.approx(vector, rel=1e-9)


@given(triples)
def test_every_form_gives_the_matrix_back(values: tuple[float, float, float]) -> None:
    """Through its own formula."""
    matrix = turned(euler("zyx"), values)
    for form in (Quaternion, AxisAngle, RotationVector, RollPitchYaw):
        assert np.allclose(form.of(matrix).rotation(), matrix, rtol=0, atol=5e-9 if form is AxisAngle else 1e-12)
