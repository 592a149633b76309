"""Parameters of a robot file: values, formulas of others, angles by inverse functions, right angles in decimals."""

from __future__ import annotations

import math

import numpy as np
import pytest

from dhcli import forward, symbolic
from dhcli.errors import FileError, RobotError
from dhcli.files.yaml.robots import read_robot
from dhcli.kinematics.limits import warnings
from dhcli.kinematics.robot import Robot
from dhcli.notation.angle import Angle
from tests.row_by_row import row_by_row

FILE = """format: 1
title: t
source: t
convention: standard
{extra}
variables: [theta1, theta2]
parameters: {{{parameters}}}
links:
  - {{a: a3, alpha: {alpha}, d: 0, theta: "theta1 + off"}}
  - {{a: r, alpha: 0, d: 0, theta: "theta2 - acos(1/2)"}}
"""
PARAMETERS = 'a2: 128 mm, a3: 2*a2, r: "sqrt(a2^2 + a3^2)", off: "atan2(24 mm, 128 mm)"'


def robot(parameters: str = PARAMETERS, alpha: str = "90°", extra: str = "") -> Robot:
    """An arm with these parameters."""
    return read_robot(FILE.format(parameters=parameters, alpha=alpha, extra=extra), "arm.yaml", "arm")


def by_hand(a2: float, theta1: float, theta2: float, off: float) -> np.ndarray:
    """The pose in numpy, from the four matrices of each row."""

    def link(a: float, alpha: float, theta: float) -> np.ndarray:
        c, s, ca, sa = math.cos(theta), math.sin(theta), math.cos(alpha), math.sin(alpha)
        return np.array([[c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, a * s], [0, sa, ca, 0], [0, 0, 0, 1]])

    return link(2 * a2, math.pi / 2, theta1 + off) @ link(math.sqrt(5) * a2, 0, theta2 - math.pi / 3)


def test_what_follows_from_others_follows_when_they_change() -> None:
    """At load, and with `--set`; what is given itself is taken as given."""
    arm, off = robot(), math.atan2(24, 128)
    assert np.array(forward(arm, [0.3, 0.5]).rows) == pytest.approx(by_hand(0.128, 0.3, 0.5, off), abs=1e-14)
    changed = forward(arm, [0.3, 0.5], parameters={"a2": 1.5})
    assert np.array(changed.rows) == pytest.approx(by_hand(1.5, 0.3, 0.5, off), abs=1e-14)
    own = forward(arm, [0.3, 0.5], parameters={"a2": 1.5, "off": "10°"})
    assert np.array(own.rows) == pytest.approx(by_hand(1.5, 0.3, 0.5, math.radians(10)), abs=1e-14)
    assert arm.derived.keys() == {"a3", "r"}


def test_symbols_keep_their_names() -> None:
    """`a3` stays `a3` in the textbook's form."""
    assert "a3" in str(symbolic(robot()).rows[0][3])


def test_what_follows_from_an_open_parameter_is_open() -> None:
    """Until it is given."""
    arm = robot('a2: , a3: 2*a2, r: a3, off: "atan2(a2, a3)"')
    assert arm.parameters["a3"] is None
    with pytest.raises(RobotError, match="have no value"):
        forward(arm, [0, 0])
    pose = forward(arm, [0, 0], parameters={"a2": 0.5})
    assert pose.rows[0][3] == pytest.approx(by_hand_open(0.5), abs=1e-14)


def by_hand_open(a2: float) -> float:
    """p_x of that arm at zero."""
    off, turn = math.atan2(1, 2), -math.pi / 3
    return 2 * a2 * math.cos(off) + 2 * a2 * math.cos(off) * math.cos(turn)


@row_by_row(
    ("parameters", "message"),
    [
        ("a2: 1, a3: 2*a3, r: 1, off: 0", "a3: follows from itself"),
        ("a2: 2*a3, a3: 2*a2, r: 1, off: 0", "a2 and a3 follow from each other"),
        ("a2: 1, a3: 1/(a2-1), r: 1, off: 0", "a3: a division by zero, or a number that becomes too large"),
        ("a2: 1, a3: 2*b2, r: 1, off: 0", "b2 is not a name that is known here"),
        ("a2: 1, a3: 2*off, r: 1, off: 30°", "a3: off is an angle, and a length is wanted"),
        ("a2: 1, a3: 1, r: 1, off: acos(2)", "off: acos(2) is not a real number"),
        ('a2: 1, a3: "acos(1/2)", r: 1, off: 0', "a3: an inverse function is an angle, a length is wanted"),
        ("a2: 1, a3: 400mm/2mm, r: 1, off: 0", "a second unit, mm, stands in one product"),
    ],
)
def test_a_formula_that_has_no_value_is_told_with_its_line(parameters: str, message: str) -> None:
    """As every other slip of a file."""
    with pytest.raises(FileError) as caught:
        robot(parameters)
    assert any(message in str(problem) for problem in caught.value.problems)
    assert all(problem.place is not None and problem.place.line == 7 for problem in caught.value.problems)


def test_values_that_do_not_allow_a_formula_are_told() -> None:
    """Where they are given."""
    arm = robot("a2: 1, a3: 1/(a2-2), r: 1, off: 0")
    assert forward(arm, [0, 0]).rows[0][3] == pytest.approx(-1 + 0.5)
    with pytest.raises(RobotError, match="with these values: a division by zero"):
        forward(arm, [0, 0], parameters={"a2": 2})


def test_right_angles_in_decimals_are_taken_exactly_and_said() -> None:
    """In cells, parameters and poses; `exact: false` keeps them."""
    given = PARAMETERS.replace('"atan2(24 mm, 128 mm)"', "1.5708 rad")
    arm = robot(given, "-1.570796327 rad", "poses: {up: [3.1416 rad, 0]}")
    assert arm.parameters["off"] == Angle.in_degrees(90)
    assert arm.poses["up"][0] == Angle.in_degrees(180)
    said = arm.remarks
    assert list(warnings(arm, {})) == []  # no result shows it
    assert len(said) == 3
    assert said[0] == "alpha: -1.570796327 rad is taken as -90°, which it is to its digits (exact: false keeps it)"
    assert "1.57" not in str(symbolic(arm).rows)
    kept = robot(given, "-1.5708 rad", "exact: false")
    assert "1.5708" in str(symbolic(kept).rows)
    assert kept.remarks == ()


def test_a_printed_rotation_is_sharpened_unless_the_file_says_no() -> None:
    """In base and tool as in links of products."""
    tool = 'tool: "[0.87 -0.5 0 0; 0.5 0.87 0 0; 0 0 1 0; 0 0 0 1]"'
    arm = robot(extra=tool)
    pose = np.array(forward(arm, [0.3, 0.5], end="tool").rows)
    assert pose[:3, :3] @ pose[:3, :3].T == pytest.approx(np.eye(3), abs=1e-11)
    assert any("2 decimals" in said for said in arm.remarks)
    kept = robot(extra=tool + "\nexact: false")
    assert kept.remarks == ()
    rough = np.array(forward(kept, [0.3, 0.5], end="tool").rows)
    assert rough[:3, :3] @ rough[:3, :3].T != pytest.approx(np.eye(3), abs=1e-4)
    with pytest.raises(FileError, match="not a unit vector"):
        robot(extra=tool.replace("0.87", "0.82"))


@pytest.mark.parametrize("unit", ["m/s", "rad/s", "°/s", "N", "N m", "kN*mm", "kg"])
def test_a_unit_of_something_else_is_named(unit: str) -> None:
    """And not its letters as names that are not known."""
    with pytest.raises(FileError) as caught:
        robot(PARAMETERS.replace('"atan2(24 mm, 128 mm)"', f"1.5 {unit}"))
    assert any(f"{unit} is no unit of an angle or a length" in problem.message for problem in caught.value.problems)
