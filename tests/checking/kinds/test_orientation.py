"""Orientations in numbers: judged as rotations, however they are said."""

from __future__ import annotations

import math
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhcli.checking.exercise import Exercise
from dhcli.checking.judge import Judge
from dhcli.checking.kinds.made import question_about
from dhcli.checking.verdicts import Mark, Verdict
from dhcli.errors import DhcliError
from dhcli.files.yaml.robots import load_robot
from dhcli.geometry.euler import AXES
from dhcli.kinematics.forward import forward
from dhcli.notation.angle import Angle
from tests.row_by_row import row_by_row

Q = (10, 20, 30, 40, 50, 60)
ORDERS = tuple(f"{kind} {axes}" for kind in ("euler", "fixed") for axes in AXES)
FORMS = ("rpy", "quaternion", "axis-angle", "rotation-vector", *ORDERS)


def asked(form: str, q: tuple[float, ...] = Q) -> Exercise:
    """A form of the end frame of PUMA 560 at joint values in degrees."""
    robot = load_robot("puma560")
    values: dict[str, Any] = {name: Angle.in_degrees(value) for name, value in zip(robot.variables, q, strict=True)}
    return question_about(robot, f"{form} of pose 0..6", numeric=True, given=values)


def judged(form: str, answer: str, q: tuple[float, ...] = Q) -> Mark:
    """An answer, explained where it is wrong."""
    exercise = asked(form, q)
    return Judge(exercise).check(exercise.parts[0], answer)


@row_by_row("form", FORMS)
def test_its_own_solution_is_right(form: str) -> None:
    """In every form."""
    exercise = asked(form)
    judge, part = Judge(exercise), exercise.parts[0]
    assert judge.check(part, judge.expected(part)).verdict is Verdict.RIGHT


@row_by_row("form", FORMS)
def test_every_slip_is_wrong_and_has_its_name(form: str) -> None:
    """A slip that gives what another gives shares its name."""
    exercise = asked(form)
    judge, part = Judge(exercise), exercise.parts[0]
    slips = judge.slips(part)
    assert slips
    for slip in slips:
        mark = judge.check(part, judge.answer_with(part, slip.name))
        assert mark.verdict in (Verdict.WRONG, Verdict.CLOSE)
        assert mark.diagnosis is not None
        assert slip.words in mark.diagnosis.names


@given(st.tuples(*[st.integers(-180, 180)] * 6))
def test_roll_pitch_yaw_of_forward_are_right_and_a_degree_more_is_not(q: tuple[int, ...]) -> None:
    """The library's own angles, at any pose; 0.02° less than the tolerance of a cosine is right, a degree is not."""
    robot = load_robot("puma560")
    rpy = forward(robot, [math.radians(value) for value in q]).rpy
    roll, pitch, yaw = (math.degrees(angle) for angle in rpy.numbers)
    assert judged("rpy", f"{roll:.6f}, {pitch:.6f}, {yaw:.6f}", q).verdict is Verdict.RIGHT
    assert judged("rpy", f"{roll:.6f}, {pitch:.6f}, {yaw + 0.02:.6f}", q).verdict is Verdict.RIGHT
    assert judged("rpy", f"{roll:.6f}, {pitch:.6f}, {yaw + 1:.6f}", q).verdict in (Verdict.WRONG, Verdict.CLOSE)


@pytest.mark.parametrize(
    ("form", "answer"),
    [
        ("rpy", "roll = 87.9163°\npitch = 0.4795°\nyaw = -109.5376°"),  # as fk prints it
        ("rpy", "[87.9163, 0.4795, -109.5376]"),
        ("rpy", "447.9163, 0.4795, 250.4624"),
        ("rpy", "-92.0837, 179.5205, 70.4624"),  # the other triple
        ("rpy", "1.534430 rad, 0.008369 rad, -1.911792 rad"),
        ("quaternion", "-0.412887, -0.402887, 0.565247, 0.589664"),
        ("quaternion", "w = 0.413, x = 0.403, y = -0.565, z = -0.590"),
    ],
)
def test_any_numbers_that_say_the_rotation_are_right(form: str, answer: str) -> None:
    """Full turns, the other triple, the other quaternion, labels and units."""
    assert judged(form, answer).verdict is Verdict.RIGHT


@row_by_row(
    ("form", "answer", "remark"),
    [
        ("rpy", "1.534430, 0.008369, -1.911792", "right in radians"),
        ("rpy", "87.9, 0.5", "2 numbers for 3: roll, pitch, yaw"),
        ("rpy", "87.9, 0.5, 1 m", "yaw: m is a unit of length"),
        ("quaternion", "1, 1, 1, 1", "a quaternion has length 1; yours has 2"),
        ("axis-angle", "0, 0, 2, 30°", "an axis has length 1"),
        ("quaternion", "0, 0, 0, 0", "a quaternion has length 1; yours has 0"),
        ("rpy", "a, b, c", "is not a name"),
        ("rpy", "sqrt(-1), 0, 0", ""),
    ],
)
def test_what_says_no_orientation_is_not_wrong_but_unread(form: str, answer: str, remark: str) -> None:
    """With what would be read."""
    mark = judged(form, answer)
    assert mark.verdict is Verdict.CANNOT_READ
    assert remark in " ".join(mark.remarks)


def test_where_only_a_sum_counts_every_pair_of_that_sum_is_right() -> None:
    """Rz(a) Ry(0) Rz(b) is a turn by a + b."""
    robot = load_robot("planar-2r")
    values: dict[str, Any] = {"theta1": Angle.in_degrees(30), "theta2": Angle.in_degrees(45)}
    exercise = question_about(robot, "euler zyz of pose 0..2", numeric=True, given=values)
    judge, part = Judge(exercise), exercise.parts[0]
    assert judge.mark(part, "75, 0, 0").verdict is Verdict.RIGHT
    assert judge.mark(part, "100, 0, -25").verdict is Verdict.RIGHT
    assert judge.mark(part, "75, 0, 1").verdict in (Verdict.WRONG, Verdict.CLOSE)


def test_in_symbols_there_is_none() -> None:
    """Angles of a symbolic rotation are no textbook's answer."""
    exercise = question_about(load_robot("planar-2r"), "rpy of pose 0..2", numeric=False, given={})
    with pytest.raises(DhcliError, match="an orientation is said in numbers"):
        Judge(exercise).mark(exercise.parts[0], "1, 2, 3")


@pytest.mark.parametrize(
    ("ask", "right"),
    [
        ("rpy of rotation from euler(zyz, 0°, 30°, 0°)", "0, 30, 0"),
        ("quaternion of rotation from Rot([0, 0, 1], 60°)", "0.8660254, 0, 0, 0.5"),
        ("axis-angle of inverse of rotation from rpy(0, 0, 40°)", "0, 0, -1, 40°"),
        ("euler zyz of rotation of product 'Rot(y, 50°) Trans(1, 2, 3)'", "0, 50, 0"),
        ("axis x of rotation from rotvec(0, 0, 90°)", "0, 1, 0"),
    ],
)
def test_one_form_is_asked_of_another(ask: str, right: str) -> None:
    """A rotation may stand wherever a pose does, named as one or not."""
    exercise = question_about(load_robot("planar-2r"), ask, numeric=True, given={})
    assert Judge(exercise).mark(exercise.parts[0], right).verdict is Verdict.RIGHT


def test_an_orientation_in_an_exercise_in_letters_says_that_it_is_in_numbers() -> None:
    """Where the robot has all lengths, it is not one of these that is missing."""
    robot = load_robot("planar-2r")
    values: dict[str, Any] = {name: Angle.in_degrees(10) for name in robot.variables}
    exercise = question_about(robot, "rpy of pose 0..2", numeric=False, given=values)
    with pytest.raises(DhcliError, match="said in numbers \\(numeric: true\\)"):
        Judge(exercise).expected(exercise.parts[0])


@row_by_row(
    ("ask", "answer"),
    [
        ("quaternion of rotation from Rot([0, 0, 1], 60°)", answer)
        for answer in (
            "(0.866, 0, 0, 0.5)",
            "(0.866 | 0 | 0 | 0.5)",
            "0,866; 0; 0; 0,5",
            "(0,866; 0; 0; 0,5)",
            "0,866\n0\n0\n0,5",
            "w = 0,866; x = 0; y = 0; z = 0,5",
            "w: 0.866, x: 0, y: 0, z: 0.5",
            "[0.866 0 0 0.5]ᵀ",
            "(0.866, (0, 0, 0.5))",
            r"\left(\frac{\sqrt{3}}{2}, 0, 0, \frac12\right)",
            "√3/2, 0, 0, ½",
            "(cos(30°), 0, 0, sin(30°))",
        )
    ]
    + [
        ("rpy of rotation from rpy(10°, 20°, 30°)", answer)
        for answer in (
            "(10, 20, 30)",
            "(10; 20; 30)°",
            "[10 20 30] deg",
            "(π/18, π/9, π/6)",
            "roll: 10°, pitch: 20°, yaw: 30°",
            "10,0° 20,0° 30,0°",
        )
    ]
    + [
        ("axis-angle of rotation from Rot([0, 0, 1], 60°)", answer)
        for answer in ("(0, 0, 1), 60°", "[0 0 1] 60°", "k = (0, 0, 1), θ = pi/3")
    ],
)
def test_an_orientation_is_read_as_people_write_lists(ask: str, answer: str) -> None:
    """In brackets of any kind, in groups, behind names, with decimal commas, with one unit behind all of it."""
    exercise = question_about(load_robot("planar-2r"), ask, numeric=True, given={})
    mark = Judge(exercise).mark(exercise.parts[0], answer)
    assert mark.verdict is Verdict.RIGHT, mark
