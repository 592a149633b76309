"""Single values and moves: angles by inverse functions, turns, numbers for letters, chains as long as fk computes."""

from __future__ import annotations

from dataclasses import replace

import pytest

from dhcli.checking.kinds.made import question_about, question_about_table
from dhcli.checking.tolerance import Tolerance
from dhcli.checking.verdicts import Verdict
from dhcli.files.yaml.robots import read_robot
from dhcli.kinematics.conventions import Convention
from dhcli.kinematics.forward import forward
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.values import joint_values
from tests.checking.mutated_kinds import exercise_of, written
from tests.judging import checked, expected, mark
from tests.row_by_row import row_by_row

RIGHT, CLOSE, WRONG, UNREAD = Verdict.RIGHT, Verdict.CLOSE, Verdict.WRONG, Verdict.CANNOT_READ


@row_by_row("ask", ["scalar atan2(a2, a1)", "scalar acos(a1/sqrt(a1^2 + a2^2))"])
@row_by_row(
    ("answer", "verdict"),
    [
        ("36.87", RIGHT),
        ("36.87°", RIGHT),
        ("396.87°", RIGHT),
        ("0.6435 rad", RIGHT),
        ("atan(3/4)", RIGHT),
        ("atan2(3 mm, 4 mm)", RIGHT),
        ("37.2", CLOSE),
        ("53.13", WRONG),
        ("0.6435", UNREAD),
        ("0.6435 m", UNREAD),
        ("a1", UNREAD),
    ],
)
def test_an_inverse_function_is_an_angle(ask: str, answer: str, verdict: Verdict) -> None:
    """In degrees or radians, modulo a full turn; a length is none."""
    given = {"a1": "0.4 m", "a2": "0.3 m"}
    exercise, part = exercise_of(ask, given=given, numeric=True, unit="mm")
    assert mark(exercise, part, answer).verdict is verdict


def test_an_angle_by_an_inverse_function_is_shown_in_degrees() -> None:
    """Where it has a value; else as it is written."""
    given = {"a1": "0.4 m", "a2": "0.3 m"}
    assert expected(*exercise_of("scalar atan2(a2, a1)", given=given, numeric=True)) == "36.8699°"
    assert expected(*exercise_of("scalar atan2(a2, a1)")) == "atan2(a2, a1)"


@row_by_row(
    ("answer", "verdict"),
    [
        ("Rot(z, theta1) Trans(a1, 0, 0)", RIGHT),
        ("Rot(z, 30°) Trans(400, 0, 0)", RIGHT),
        ("Rot(z, -330°) Trans(0.4 m, 0, 0) Rot(x, 360°)", RIGHT),
        ("Rot(z, 30.04°) Trans(400.3, 0, 0)", RIGHT),
        ("Rot(z, 31°) Trans(400, 0, 0)", WRONG),
        ("Rot(z, 30°) Trans(0.4, 0, 0)", WRONG),
        ("Trans(400, 0, 0) Rot(z, 30°)", WRONG),
        ("Rot(z, 30°)", WRONG),
        ("Rot(z, 30°) Trans(200, 0, 0) Trans(200, 0, 0) Rot(y, 5°)", WRONG),
    ],
)
def test_moves_may_be_in_numbers(answer: str, verdict: Verdict) -> None:
    """At the values given and within the tolerance, lengths in the unit of the sheet."""
    given = {"theta1": "30°", "a1": "0.4 m"}
    exercise, part = exercise_of("factors 1", given=given, numeric=True, unit="mm")
    assert mark(exercise, part, answer).verdict is verdict


@pytest.mark.parametrize(("turned", "verdict"), [("-180°", RIGHT), ("540°", RIGHT), ("pi", RIGHT), ("0", WRONG)])
def test_turns_are_the_same_modulo_a_full_one(turned: str, verdict: Verdict) -> None:
    """In symbols too."""
    exercise, part = exercise_of("factors 2", robot="scara-yim")
    right = expected(exercise, part)
    assert "180°" in right
    assert mark(exercise, part, right.replace("180°", turned)).verdict is verdict


def test_moves_in_another_order_are_told() -> None:
    """They are all there."""
    exercise, part = exercise_of("factors 1")
    assert mark(exercise, part, "Trans(a1, 0, 0) Rot(z, theta1)").remarks == (
        "the moves are right, their order is not",
    )


def long_robot(joints: int) -> Robot:
    """An arm whose pose in symbols nobody could read."""
    names = [f"theta{k}" for k in range(1, joints + 1)]
    rows = "\n".join(f"  - {{alpha: 90°, a: 0.1, d: 0.05, theta: {name}}}" for name in names)
    text = f"format: 1\ntitle: x\nsource: x\nconvention: standard\nvariables: [{', '.join(names)}]\nlinks:\n{rows}\n"
    return read_robot(text, "long.yaml", "long")


def test_a_pose_of_fifteen_joints_is_judged_as_fk_computes_it() -> None:
    """Right as it is, wrong with a sign turned round."""
    robot = long_robot(15)
    q = ", ".join(f"{10 + 7 * k}°" for k in range(15))
    exercise = question_about(robot, "pose 0..15", numeric=True, given=joint_values(robot, q))
    [part] = exercise.parts
    rows = [[f"{float(entry):.6f}" for entry in row] for row in forward(robot, q).matrix.tolist()]
    assert mark(exercise, part, written(rows)).verdict is RIGHT
    rows[0][3] = f"{-float(rows[0][3]):.6f}"
    judged = mark(exercise, part, written(rows))
    assert judged.verdict is WRONG
    assert judged.earned == pytest.approx(3 / 4)


def test_a_table_of_seventeen_rows_is_read() -> None:
    """As many as a robot may have."""
    exercise = question_about_table(long_robot(17), Convention.STANDARD)
    [part] = exercise.parts
    assert mark(exercise, part, expected(exercise, part)).verdict in (RIGHT, Verdict.EQUIVALENT)


def test_a_cell_in_another_unit_is_told() -> None:
    """Metres on a sheet in millimetres; one that writes its unit is believed."""
    exercise, part = exercise_of("cell a 1", numeric=True, unit="mm")
    judged = checked(exercise, part, "0.4")
    assert (judged.verdict, judged.other_unit, judged.earned) == (Verdict.CANNOT_READ, "m", 0.5)
    assert judged.remarks == ("right in m; this sheet is in mm",)
    assert checked(exercise, part, "0.4 m").verdict is RIGHT
    assert checked(exercise, part, "0.4 mm").verdict is WRONG


@pytest.mark.parametrize(
    ("ask", "answer", "said"),
    [
        ("scalar 25", "25°", "deg is a unit of angle, a number is wanted (leave the unit out)"),
        ("scalar 25", "asin(1/2)", "an inverse function is an angle, a number is wanted"),
        ("scalar 2*a1", "25°", "deg is a unit of angle, a length is wanted (write 0.4 m or 400 mm)"),
        ("scalar 2*a1", "asin(1/2)", "an inverse function is an angle, a length is wanted (write 0.4 m or 400 mm)"),
        ("scalar 25°", "3 mm", "mm is a unit of length, an angle is wanted (write 30° or 0.5 rad)"),
    ],
)
def test_a_value_of_another_kind_is_told_what_is_wanted(ask: str, answer: str, said: str) -> None:
    """A number has no unit, a length one of length."""
    found = mark(*exercise_of(ask, given={"a1": "0.4 m", "a2": "0.3 m"}, numeric=True), answer)
    assert (found.verdict, found.remarks) == (UNREAD, (said,))


@pytest.mark.parametrize(
    ("ask", "answer"), [("scalar 5/2", "2½"), ("scalar 5/2 m", "２½ m"), ("scalar 90.25°", "90¼°"), ("scalar 1/2", "½")]
)
def test_a_number_with_a_fraction_behind_it_is_a_mixed_one(ask: str, answer: str) -> None:
    """Two and a half, and never twice a half."""
    assert mark(*exercise_of(ask, numeric=True), answer).verdict is RIGHT


@pytest.mark.parametrize(("ask", "answer", "unit"), [("cell d 1", "0.5", ""), ("cell a 1", "400", "mm")])
def test_a_length_near_zero_is_right_in_no_other_unit(ask: str, answer: str, unit: str) -> None:
    """Within a millimetre of 0 is whatever is a number of millimetres below 1."""
    exercise, part = exercise_of(ask, numeric=True, unit="m")
    judged = checked(replace(exercise, tolerance=Tolerance(position=0.001)), part, answer)
    assert (judged.verdict, judged.other_unit) == (UNREAD if unit else WRONG, unit)
