"""Orientations said in other ways, there and back, and at the poles where an angle is free."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import product
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhcli.algebra.floats import Floats
from dhcli.geometry.euler import RollPitchYaw
from dhcli.geometry.rotations import AxisAngle, Quaternion
from dhcli.geometry.words import in_words
from dhcli.kinematics.fold import fold
from dhcli.kinematics.moves import read_chain
from dhcli.kinematics.pose import Pose
from dhcli.notation.angle import Angle
from tests.row_by_row import row_by_row
from tests.strategies import quarter_turns

angles = st.floats(-math.pi, math.pi)
rounded = st.sampled_from([k * math.pi / 4 for k in range(-4, 5)])
triples = st.tuples(*[st.one_of(angles, rounded)] * 3)


def cosines(matrix: np.ndarray[Any, Any] | Sequence[Sequence[int]]) -> list[list[float]]:
    """Direction cosines as floats."""
    return [[float(entry) for entry in row] for row in matrix]


def turn(axis: int, angle: float) -> np.ndarray[Any, Any]:
    """A rotation about a coordinate axis, shape (3, 3)."""
    first, second = [(1, 2), (2, 0), (0, 1)][axis]
    matrix = np.eye(3)
    matrix[first, first] = matrix[second, second] = math.cos(angle)
    matrix[second, first], matrix[first, second] = math.sin(angle), -math.sin(angle)
    return matrix


def of_rpy(roll: float, pitch: float, yaw: float) -> np.ndarray[Any, Any]:
    """R = Rz(yaw) Ry(pitch) Rx(roll)."""
    return turn(2, yaw) @ turn(1, pitch) @ turn(0, roll)


def about(axis: tuple[float, float, float], angle: float) -> np.ndarray[Any, Any]:
    """Rodrigues' formula."""
    x, y, z = axis
    skew = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    matrix: np.ndarray[Any, Any] = np.eye(3) + math.sin(angle) * skew + (1 - math.cos(angle)) * skew @ skew
    return matrix


@given(triples)
def test_roll_pitch_yaw_give_the_rotation_back(given_: tuple[float, float, float]) -> None:
    """With pitch in [-90°, 90°], at the poles too."""
    matrix = of_rpy(*given_)
    found = RollPitchYaw.of(cosines(matrix))
    assert of_rpy(found.roll, found.pitch, found.yaw) == pytest.approx(matrix, abs=1e-8)
    assert abs(found.pitch) <= math.pi / 2
    assert not found.locked or found.roll == 0


@given(st.floats(-3, 3), st.floats(-1.5, 1.5), st.floats(-3, 3))
def test_away_from_the_poles_roll_pitch_and_yaw_are_the_ones_put_in(roll: float, pitch: float, yaw: float) -> None:
    """The angles themselves, not only their rotation."""
    found = RollPitchYaw.of(cosines(of_rpy(roll, pitch, yaw)))
    assert (found.roll, found.pitch, found.yaw) == pytest.approx((roll, pitch, yaw), abs=1e-9)
    assert not found.locked


@row_by_row(("pitch", "roll", "yaw"), [*product((90, -90), (0, 30, -120), (0, 45, 180))])
def test_at_the_poles_roll_is_zero_and_yaw_takes_it_all(pitch: int, roll: int, yaw: int) -> None:
    """Only yaw - roll, or yaw + roll, can be told there."""
    matrix = of_rpy(*map(math.radians, (roll, pitch, yaw)))
    found = RollPitchYaw.of(cosines(matrix))
    assert found.locked
    assert found.roll == 0
    assert math.degrees(found.pitch) == pytest.approx(pitch)
    assert of_rpy(found.roll, found.pitch, found.yaw) == pytest.approx(matrix, abs=1e-9)


@given(triples)
def test_the_quaternion_gives_the_rotation_back(given_: tuple[float, float, float]) -> None:
    """Of length one, with w >= 0; R = 1 + 2w K + 2K² for K of its vector."""
    matrix = of_rpy(*given_)
    q = Quaternion.of(cosines(matrix))
    assert q.w >= 0
    assert q.w**2 + q.x**2 + q.y**2 + q.z**2 == pytest.approx(1)
    skew = np.array([[0, -q.z, q.y], [q.z, 0, -q.x], [-q.y, q.x, 0]])
    assert np.eye(3) + 2 * q.w * skew + 2 * skew @ skew == pytest.approx(matrix, abs=1e-9)


@given(triples)
def test_axis_and_angle_give_the_rotation_back(given_: tuple[float, float, float]) -> None:
    """About a unit vector, by an angle in [0, π]."""
    matrix = of_rpy(*given_)
    found = AxisAngle.of(cosines(matrix))
    assert 0 <= found.angle <= math.pi
    assert math.hypot(*found.axis) == pytest.approx(1)
    assert about(found.axis, found.angle) == pytest.approx(matrix, abs=1e-8)


@row_by_row("matrix", quarter_turns())
def test_quarter_turns_are_said_exactly(matrix: tuple[tuple[int, ...], ...]) -> None:
    """All 24, the nine half turns among them, in all three ways."""
    turned = cosines(matrix)
    q, found, rpy = Quaternion.of(turned), AxisAngle.of(turned), RollPitchYaw.of(turned)
    assert about(found.axis, found.angle) == pytest.approx(np.array(matrix), abs=1e-12)
    assert of_rpy(rpy.roll, rpy.pitch, rpy.yaw) == pytest.approx(np.array(matrix), abs=1e-12)
    assert q.w == pytest.approx(math.cos(found.angle / 2))
    assert math.degrees(found.angle) == pytest.approx(round(math.degrees(found.angle)), abs=1e-9)


@pytest.mark.parametrize("axis", [(1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 0), (1, -1, 0), (0, 1, -1), (1, 2, -3)])
def test_of_the_two_axes_of_half_a_turn_the_first_part_is_positive(axis: tuple[int, int, int]) -> None:
    """A half turn about an axis is one about the opposite axis; the same one is always named."""
    length = math.hypot(*axis)
    unit = (axis[0] / length, axis[1] / length, axis[2] / length)
    for sign in (1, -1):
        found = AxisAngle.of(cosines(about((sign * unit[0], sign * unit[1], sign * unit[2]), math.pi)))
        assert found.angle == pytest.approx(math.pi)
        assert found.axis == pytest.approx(unit)


def test_no_rotation_is_about_z() -> None:
    """The axis is free there."""
    found, q = AxisAngle.of(cosines(np.eye(3))), Quaternion.of(cosines(np.eye(3)))
    assert (found.axis, found.angle) == ((0.0, 0.0, 1.0), 0.0)
    assert (q.w, q.x, q.y, q.z) == (1, 0, 0, 0)


@given(st.floats(1e-6, 1e-3))
def test_a_small_turn_keeps_its_angle(angle: float) -> None:
    """No arc cosine that loses half of the digits."""
    assert AxisAngle.of(cosines(turn(1, angle))).angle == pytest.approx(angle, rel=1e-9)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("Rot(z, 0.3 rad)", ("z' points along +z",)),
        ("Rot(y, 90°) Rot(z, 90°)", ("x' points along +y", "y' points along +z", "z' points along +x")),
        ("Rot(x, 180°)", ("x' points along +x", "y' points along -y", "z' points along -z")),
        ("Rot(x, 0.3 rad) Rot(y, 0.4 rad)", ()),
    ],
)
def test_axes_along_axes_are_said_in_words(text: str, words: tuple[str, ...]) -> None:
    """Where it is plain, and nothing where it is not."""
    assert in_words(Pose(fold(read_chain(text), Floats())).rotation) == words


def test_an_exact_pose_has_an_exact_orientation() -> None:
    """90° about z through the fold is 90° to the last digit."""
    turned = Pose(fold(read_chain("Rot(z, theta)"), Floats({"theta": Angle.in_degrees(90)}))).rotation
    assert RollPitchYaw.of(turned).yaw == math.pi / 2
