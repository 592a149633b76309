"""Rotations about any axis, by several numbers, and moves about fixed axes among others."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhcli.algebra.floats import Floats
from dhcli.errors import NotationError
from dhcli.geometry.euler import AXES, euler
from dhcli.geometry.rotations import AxisAngle, Quaternion, RotationVector
from dhcli.kinematics.fold import fold
from dhcli.kinematics.moves import read_chain
from tests.row_by_row import row_by_row

degrees = st.integers(-179, 179)
whole = st.integers(-9, 9)


def rotation_of(text: str, **values: float) -> np.ndarray:
    """The rotation of a product."""
    return np.array(fold(read_chain(text), Floats(values)))[:3, :3]


@given(st.tuples(whole, whole, whole).filter(any), degrees)
def test_a_turn_about_any_axis_is_rodrigues(axis: tuple[int, int, int], angle: int) -> None:
    """Whatever the length of the axis."""
    size = math.sqrt(sum(part * part for part in axis))
    x, y, z = (part / size for part in axis)
    expected = AxisAngle((x, y, z), math.radians(angle)).rotation()
    assert np.allclose(rotation_of(f"Rot([{axis[0]}, {axis[1]}, {axis[2]}], {angle}°)"), expected, atol=1e-14)
    assert np.allclose(rotation_of(f"Rot({axis}, q)", q=math.radians(angle)), expected, atol=1e-14)


@given(st.sampled_from(AXES), st.booleans(), degrees, degrees, degrees)
def test_three_turns_are_those_of_their_order(axes: str, fixed: bool, a: int, b: int, c: int) -> None:
    """All 24 orders."""
    order = f"fixed {axes}" if fixed else axes
    found = rotation_of(f"euler({order}, {a}°, {b}°, {c}°)")
    single = [rotation_of(f"Rot({axis}, {angle}°)") for axis, angle in zip(axes, (a, b, c), strict=True)]
    expected = single[2] @ single[1] @ single[0] if fixed else single[0] @ single[1] @ single[2]
    assert np.allclose(found, expected, atol=1e-14)
    told = euler(axes, fixed=fixed).of(found.tolist())
    for triple in (told, told.other):
        assert np.allclose(np.array(triple.rotation(), float), expected, atol=1e-12)


def test_roll_pitch_yaw_is_about_fixed_x_y_z() -> None:
    """R = Rz(yaw) Ry(pitch) Rx(roll)."""
    assert np.allclose(rotation_of("rpy(10°, 20°, 30°)"), rotation_of("Rot(z, 30°) Rot(y, 20°) Rot(x, 10°)"))


@given(st.tuples(whole, whole, whole, whole).filter(any))
def test_a_quaternion_rounded_to_decimals_is_made_one_of_length_one(parts: tuple[int, int, int, int]) -> None:
    """What people paste has four digits."""
    size = math.sqrt(sum(part * part for part in parts))
    w, x, y, z = (round(part / size, 4) for part in parts)
    found = rotation_of(f"quaternion({w}, {x}, {y}, {z})")
    assert np.allclose(found @ found.T, np.eye(3), atol=1e-14)
    assert np.allclose(found, Quaternion(*(part / size for part in parts)).rotation(), atol=1e-3)


@given(st.tuples(degrees, degrees, degrees))
def test_a_rotation_vector_is_its_axis_times_its_angle(parts: tuple[int, int, int]) -> None:
    """In degrees and in radians."""
    x, y, z = (math.radians(part) for part in parts)
    expected = RotationVector(x, y, z).rotation()
    assert np.allclose(rotation_of(f"rotvec({parts[0]}°, {parts[1]}°, {parts[2]}°)"), expected, atol=1e-13)
    assert np.allclose(rotation_of(f"rotation_vector({x!r} rad, {y!r} rad, {z!r} rad)"), expected, atol=1e-13)


def test_a_move_about_the_fixed_frame_stands_before_all_that_was_typed_before_it() -> None:
    """A textbook's mixed sequence: current, fixed, current, fixed."""
    mixed = "Rot(x, 10°) fixed(Rot(z, 20°)) Rot(y, 30°) fixed(Rot(x, 40°) Trans(1, 2, 3))"
    assert read_chain(mixed) == read_chain("Rot(x, 40°) Trans(1, 2, 3) Rot(z, 20°) Rot(x, 10°) Rot(y, 30°)")


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("inv(Rot(x, 1°) (Rot(y, 2°) Rot(z, 3°)))", "Rot(z, -3°) Rot(y, -2°) Rot(x, -1°)"),
        ("inv(Rot(x, 1°) inv(Rot(y, 2°) Rot(z, 3°)))", "Rot(y, 2°) Rot(z, 3°) Rot(x, -1°)"),
        ("inv(Rot(x, 1°) rpy(1°, 2°, 3°))", "Rot(x, -1°) Rot(y, -2°) Rot(z, -3°) Rot(x, -1°)"),
        ("inv(Rot(x, 1°) rpy(1°, 2°, 3°)^-1)", "Rot(z, 3°) Rot(y, 2°) Rot(x, 1°) Rot(x, -1°)"),
        ("rpy(1°, 2°, 3°)^-1", "Rot(x, -1°) Rot(y, -2°) Rot(z, -3°)"),
    ],
)
def test_an_inverse_turns_everything_round(text: str, plain: str) -> None:
    """Brackets within brackets, and moves that several factors stand for."""
    assert read_chain(text) == read_chain(plain)


@row_by_row(
    ("text", "message"),
    [
        ("Rot([0, 0, 0], 10°)", "an axis of length zero has no direction"),
        ("Rot([a, 0, 1], 10°)", "an axis is made of plain numbers, not a"),
        ("Rot([1, 0], 10°)", "an axis has three coordinates, not 2"),
        ("quaternion(1, 1, 0, 0)", "a quaternion has length 1, this one 1.414"),
        ("quaternion(0, 0, 0, 0)", "a quaternion has length 1, this one 0"),
        ("euler(zzx, 1°, 2°, 3°)", "zzx is no order of three axes"),
        ("euler(zyx, 1°, 2°)", "euler takes 4 values, not 3"),
        ("rpy(1, 2, 3)", "the angle 1 has no unit"),
        ("rotvec(1°, 1 rad, 0)", "a rotation vector is in degrees or in radians"),
        ("rotvec(phi, 0, 0)", "a rotation vector is three constant angles"),
        ("(fixed(Rot(x, 1°)))", "fixed(...) stands by itself"),
    ],
)
def test_what_is_no_rotation_is_refused_where_it_stands(text: str, message: str) -> None:
    """With what would be right."""
    with pytest.raises(NotationError) as caught:
        read_chain(text)
    assert message in str(caught.value)
