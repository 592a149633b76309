"""Orientations in every form, asked for and given."""

from __future__ import annotations

import math

import pytest

from tests.cli.running import run


def test_both_triples_of_an_order_are_said() -> None:
    """Half a turn apart, the middle one turned back."""
    out = run("transform", "euler(zyz, 10°, 20°, 30°)", "--as", "zyz").out
    assert "1 about z = 10°" in out
    assert "the same rotation: -170°, -20°, -150°" in out
    assert "about current axes" in out


def test_at_a_singular_attitude_it_is_said_which_angle_was_chosen() -> None:
    """Only the sum of the outer two counts."""
    done = run("fk", "spherical-wrist", "--q", "30,0,20", "--deg", "--as", "zyz")
    assert "1 about z = 50°" in done.out
    assert "the last was chosen as 0" in done.err
    assert "the same rotation" not in done.out


def test_json_and_csv_have_the_angles_in_radians() -> None:
    """And the rotation vector as three numbers."""
    data = run("transform", "euler(xyz, 10°, 20°, 30°)", "--as", "xyz,rotation-vector", "--format", "json").data
    assert data["as"]["xyz"]["angles"] == pytest.approx([math.radians(10), math.radians(20), math.radians(30)])
    assert data["as"]["xyz"]["locked"] is False
    assert len(data["as"]["rotation-vector"]) == 3


def test_rows_have_columns_for_three_angles() -> None:
    """Many poses at once."""
    out = run("fk", "scara", "--in", "-", "--as", "zyz,rotation-vector", stdin="theta1,theta2,d3\n0.1,0.2,0\n").out
    head, row = out.split("\n")[:2]
    assert head == "zyz_1,zyz_2,zyz_3,r_x,r_y,r_z"
    assert [float(cell) for cell in row.split(",")] == pytest.approx([0.3, 0, 0, 0, 0, 0.3])


def test_moves_about_fixed_axes_are_said_apart() -> None:
    """One product with both."""
    out = run("transform", "Rot(z, 90°) fixed(Rot(x, 30°))").out
    assert out.startswith("T_02 = Rot(x, 30°) Rot(z, 90°)\n")
    assert "but Rot(x, 30°) about the fixed frame 0" in out
    out = run("transform", "--fixed", "Rot(z, 90°) current(Rot(x, 30°))").out
    assert out.startswith("T_02 = Rot(z, 90°) Rot(x, 30°)\n")
