"""Orientations in every form, asked for and given."""

from __future__ import annotations

import math

import pytest

from dhcli.checking.judge import check
from dhcli.errors import DhcliError
from dhcli.files.yaml.exercises import read_exercise
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
    out = run("fk", "scara", "--rows", "-", "--as", "zyz,rotation-vector", stdin="theta1,theta2,d3\n0.1,0.2,0\n").out
    head, row = out.split("\n")[:2]
    assert head == "zyz_1,zyz_2,zyz_3,r_x,r_y,r_z"
    assert [float(cell) for cell in row.split(",")] == pytest.approx([0.3, 0, 0, 0, 0, 0.3])


@pytest.mark.parametrize(
    ("form", "said"),
    [
        ("zyz", "zyz: the middle angle is 0° or 180° in 1 of 2 rows"),
        ("fixed-zyz", "the first was chosen as 0"),
        ("zyx", None),
        ("rotation-vector", None),
    ],
)
def test_rows_at_a_singular_attitude_are_counted_by_form(form: str, said: str | None) -> None:
    """In the words of that form."""
    rows = "theta4,theta5,theta6\n0.1,0.2,0.3\n0.4,0,0\n"
    done = run("fk", "spherical-wrist", "--rows", "-", "--as", form, stdin=rows)
    assert done.code == 0, done.err
    assert said in done.err if said else not done.err


@pytest.mark.parametrize(
    "ask",
    [
        "rotation from rpy(10°, 20°, 30°)",
        "rotation from euler(fixed xyz, 10°, 20°, 30°)",
        "rotation from Rot(z, 30°) Rot(y, 20°) Rot(x, 10°)",
    ],
)
def test_a_rotation_from_angles_is_a_question(ask: str) -> None:
    """The same matrix in three words."""
    head = "format: 1\ntitle: t\nsource: s\ntask: t\nnumeric: true\nparts:\n"
    exercise = read_exercise(f"{head}  - {{id: a, ask: '{ask}'}}\n", "x", "x")
    right = run("transform", "Rot(z, 30°) Rot(y, 20°) Rot(x, 10°)", "--format", "csv", "--digits", "6").out
    rows = [row.split(",")[:3] for row in right.split()][:3]
    answer = "; ".join(" ".join(row) for row in rows)
    assert check(exercise, "a", f"[{answer}]").verdict.passed
    assert not check(exercise, "a", "[1 0 0; 0 1 0; 0 0 1]").verdict.passed


def test_a_rotation_from_what_shifts_is_refused() -> None:
    """A shift is no turn."""
    text = "format: 1\ntitle: t\nsource: s\ntask: t\nparts:\n  - {id: a, ask: 'rotation from Trans(1, 0, 0)'}\n"
    with pytest.raises(DhcliError, match="Trans is none"):
        read_exercise(text, "x", "x")


def test_moves_about_fixed_axes_are_said_apart() -> None:
    """One product with both."""
    out = run("transform", "Rot(z, 90°) fixed(Rot(x, 30°))").out
    assert out.startswith("T_02 = Rot(x, 30°) Rot(z, 90°)\n")
    assert "but Rot(x, 30°) about the fixed frame 0" in out
    out = run("transform", "--fixed", "Rot(z, 90°) current(Rot(x, 30°))").out
    assert out.startswith("T_02 = Rot(z, 90°) Rot(x, 30°)\n")
