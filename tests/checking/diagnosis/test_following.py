"""Parts that are right from a student's own DH table."""

from __future__ import annotations

from dataclasses import replace

import pytest

from dhcli import load_exercise, load_robot
from dhcli.checking.exercise import Exercise, Part
from dhcli.checking.kinds.registry import read_question
from dhcli.checking.verdicts import Mark, Verdict
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.values import joint_values
from tests.judging import answer_with, expected, mark_sheet

ASKED = ("pose 0..6", "pose 3..5", "link 4", "position of pose 0..5", "point (1, 2, 3) of pose 0..6")


def puma(asked: str, *, numeric: bool = False) -> Exercise:
    """The table of PUMA 560, and then something of a pose."""
    robot = load_robot("puma560")
    table = Part("table", read_question("table modified", robot.scope))
    later = Part("pose", read_question(asked, robot.scope), depends=("table",))
    given = joint_values(robot, "25°,40°,65°,35°,70°,20°") if numeric else {}
    return Exercise("e", "", "", "", (table, later), robot, given, numeric=numeric)


def second(exercise: Exercise, slip: str, other: str = "") -> Mark:
    """The judgement of the later part, both answered with the same slip, or the later one with another."""
    answers = {part.id: answer_with(exercise, part, slip) for part in exercise.parts}
    if other:
        answers["pose"] = answer_with(exercise, exercise.part("pose"), other)
    return next(one.mark for one in mark_sheet(exercise, answers).parts if one.part.id == "pose")


@pytest.mark.parametrize("numeric", [False, True])
@pytest.mark.parametrize(
    "asked", ["pose 0..6", "pose 3..5", "link 4", "position of pose 0..5", "point (1, 2, 3) of pose 0..6"]
)
def test_a_pose_from_a_wrong_table_keeps_its_credit(asked: str, *, numeric: bool) -> None:
    """The slip is in the table, and said there; everything behind it is worked out rightly."""
    mark = second(puma(asked, numeric=numeric), "alpha-sign 4")
    assert mark.verdict is Verdict.WRONG
    assert mark.earned == 1
    assert mark.diagnosis is not None
    assert mark.diagnosis.follows == ("table",)
    assert mark.remarks == ("right from your table: the slip is there; this part keeps its credit",)


def test_a_pose_with_a_slip_of_its_own_is_told_that_slip() -> None:
    """It follows neither from the solution nor from the student's own table."""
    mark = second(puma("pose 0..6"), "alpha-sign 4", "d-forgotten 3")
    assert mark.earned < 1
    assert mark.diagnosis is not None
    assert mark.diagnosis.ids == ("d-forgotten 3",)


def test_a_pose_from_a_right_table_with_other_frames_keeps_its_credit() -> None:
    """The table is right, its x1 points the other way; so do the matrices of frame 1."""
    exercise = puma("pose 0..1")
    table = answer_with(exercise, exercise.part("table"), "alpha-sign 2").replace(
        "0, 0, 0, theta1", "0, 0, 0, theta1+180°"
    )
    answers = {"table": table, "pose": "[-c1 s1 0 0; -s1 -c1 0 0; 0 0 1 0; 0 0 0 1]"}
    marks = {one.part.id: one.mark for one in mark_sheet(exercise, answers).parts}
    assert marks["table"].verdict.passed
    assert marks["pose"].earned == 1
    assert marks["pose"].remarks == ("right from your table, which has other frames; this part keeps its credit",)


def test_a_cell_that_agrees_with_the_own_table_keeps_its_credit() -> None:
    """One slip costs once."""
    exercise = load_exercise("puma560-table")
    table = expected(exercise, exercise.part("table")).replace(" a2,", " a3,", 1)
    marks = {one.part.id: one.mark for one in mark_sheet(exercise, {"table": table, "upper": "a3"}).parts}
    assert marks["table"].verdict is Verdict.WRONG
    assert marks["upper"].diagnosis is not None
    assert marks["upper"].diagnosis.follows == ("table",)
    assert marks["upper"].earned == 1
    marks = {one.part.id: one.mark for one in mark_sheet(exercise, {"table": table, "upper": "d3"}).parts}
    assert marks["upper"].earned == 0


def test_a_table_that_cannot_be_read_or_has_other_rows_is_followed_by_nothing() -> None:
    """There are no frames to go through."""
    exercise = puma("pose 0..6")
    pose = answer_with(exercise, exercise.part("pose"), "alpha-sign 4")
    table = answer_with(exercise, exercise.part("table"), "alpha-sign 4")
    longer = table.replace("[[", "[[0, 0, 0, 0], [", 1)
    for typed in ("[1 2 3]", longer):
        marks = {one.part.id: one.mark for one in mark_sheet(exercise, {"table": typed, "pose": pose}).parts}
        assert marks["pose"].diagnosis is not None
        assert marks["pose"].diagnosis.follows == ()


IDENTITY = "[1 0 0 0; 0 1 0 0; 0 0 1 0; 0 0 0 1]"


def links(*, numeric: bool) -> Exercise:
    """Two links of PUMA 560, and their product."""
    robot = load_robot("puma560")
    asked = {"t01": "link 1", "t12": "link 2", "t02": "pose 0..2"}
    parts = tuple(
        Part(name, read_question(text, robot.scope), depends=("t01", "t12") if name == "t02" else ())
        for name, text in asked.items()
    )
    given = joint_values(robot, "25°,40°,65°,35°,70°,20°") if numeric else {}
    return Exercise("e", "", "", "", parts, robot, given, numeric=numeric)


@pytest.mark.parametrize("numeric", [False, True])
def test_what_follows_from_the_identity_earns_nothing(*, numeric: bool) -> None:
    """Nothing has been worked out, however well it is multiplied."""
    sheet = mark_sheet(links(numeric=numeric), dict.fromkeys(("t01", "t12", "t02"), IDENTITY))
    assert [one.mark.earned for one in sheet.parts] == [0, 0, 0]
    assert all(one.mark.diagnosis is None or not one.mark.diagnosis.follows for one in sheet.parts)


def test_what_follows_from_a_table_without_joints_earns_nothing() -> None:
    """A table of zeros says that nothing moves."""
    zeros = "[" + "; ".join(["0 0 0 0"] * 6) + "]"
    answers = {"table": zeros, "pose": IDENTITY}
    marks = {one.part.id: one.mark for one in mark_sheet(puma("pose 0..6"), answers).parts}
    assert marks["pose"].earned == 0
    exercise = load_exercise("puma560-table")
    marks = {one.part.id: one.mark for one in mark_sheet(exercise, {"table": zeros, "upper": "0"}).parts}
    assert marks["upper"].earned == 0


def test_what_follows_from_numbers_that_have_nothing_to_do_with_the_task_earns_nothing() -> None:
    """Such as those of another variant; a slip that is known leads on."""
    exercise = links(numeric=True)
    assert exercise.robot is not None
    given = joint_values(exercise.robot, "31°,52°,65°,35°,70°,20°")
    copied = {part.id: expected(replace(exercise, given=given), part) for part in exercise.parts}
    assert [one.mark.earned for one in mark_sheet(exercise, copied).parts] == [0, 0, 0]
    slip = {part.id: answer_with(exercise, part, "theta-sign 1") for part in exercise.parts if part.id != "t12"}
    marks = {one.part.id: one.mark for one in mark_sheet(exercise, slip).parts}
    assert marks["t02"].earned == 1


def test_a_misprint_that_is_copied_leads_on() -> None:
    """Although a matrix with a wrong entry is no rigid motion: it is known where it comes from."""
    exercise = load_exercise("three-r-arm-tip")
    copied = "[c2 -s2 0 b*c2; s2 c2 0 b*s2; 0 0 1 0; 0 0 0 1]"
    own = "[c12 -s12 0 a*c1 + b*c12; s12 c12 0 a*s1 + b*s12; 0 0 1 0; 0 0 0 1]"
    marks = {one.part.id: one.mark for one in mark_sheet(exercise, {"t12": copied, "t02": own}).parts}
    assert marks["t02"].earned == 1


GIVEN, TURNED = "25°,40°,65°,35°,70°,20°", "25°,40°,-65°,35°,70°,20°"


def chained(*asked: str, at: str = "") -> Exercise:
    """Questions about PUMA 560, in numbers at joint values, each of which may build on those before it."""
    robot = load_robot("puma560")
    parts: list[Part] = []
    for text in asked:
        depends = tuple(one.id for one in parts)
        parts.append(Part(f"p{len(parts)}", read_question(text, robot.scope), depends=depends))
    given = joint_values(robot, at) if at else {}
    return Exercise("e", "", "", "", tuple(parts), robot, given, numeric=bool(at))


def last_mark(exercise: Exercise, *answers: str) -> Mark:
    """The judgement of the last part."""
    return mark_sheet(exercise, dict(zip((part.id for part in exercise.parts), answers, strict=True))).parts[-1].mark


@pytest.mark.parametrize(
    "said", ["rpy of", "euler zyz of", "fixed xyz of", "quaternion of", "axis-angle of", "rotation-vector of"]
)
@pytest.mark.parametrize("first", ["pose 0..3", "rotation of pose 0..3"])
def test_an_orientation_said_from_a_wrong_matrix_keeps_its_credit(first: str, said: str) -> None:
    """Whoever says in angles what their own matrix holds has made no second slip."""
    asked = first, f"{said} pose 0..3"
    turned = chained(*asked, at=TURNED)
    mark = last_mark(chained(*asked, at=GIVEN), *(expected(turned, part) for part in turned.parts))
    assert (mark.verdict, mark.earned) == (Verdict.WRONG, 1)
    assert mark.diagnosis is not None
    assert mark.diagnosis.follows == ("p0",)


def test_an_orientation_beside_a_wrong_matrix_needs_to_be_that_of_it() -> None:
    """Another wrong orientation than that of the own matrix earns nothing."""
    asked = "rotation of pose 0..3", "rpy of pose 0..3"
    turned = chained(*asked, at=TURNED)
    assert last_mark(chained(*asked, at=GIVEN), expected(turned, turned.parts[0]), "10, 20, 30").earned == 0


def test_an_axis_read_from_a_wrong_rotation_keeps_its_credit_and_a_position_does_not() -> None:
    """A rotation says nothing about where a frame is."""
    exercise = chained("rotation of pose 0..3", "axis x of pose 0..3")
    rotation = answer_with(exercise, exercise.parts[0], "transposed")
    mark = last_mark(exercise, rotation, "[c1*c23, -c1*s23, -s1]")
    assert (mark.verdict, mark.earned) == (Verdict.WRONG, 1)
    placed = chained("rotation of pose 0..3", "position of pose 0..3")
    assert last_mark(placed, rotation, "[0, 0, 0]").earned < 1
    assert last_mark(placed, rotation, "[a2*c2, a2*s2, -d3]").earned < 1


ABOUT_MOTION = (
    "jacobian of 0..3",
    "jacobian linear of 0..3 in frame 3",
    "jacobian body of 0..3",
    "column 2 of jacobian of 0..3",
    "determinant of jacobian linear of 0..3",
    "torques for (10, 20, 5) of 0..3",
    "velocity of 0..3 with rates (0.5, 0.2, -1)",
    "joint rates for (0.1, 0, 0.2) of 0..3",
)


@pytest.mark.parametrize("asked", ABOUT_MOTION)
@pytest.mark.parametrize("numeric", [False, True])
def test_what_the_motion_of_a_wrong_table_is_keeps_its_credit(asked: str, *, numeric: bool) -> None:
    """The slip is in the table; whoever goes on from there rightly, in letters or in numbers, has made no other."""
    robot = load_robot("articulated")
    wrong = Robot.from_dh(
        [("0", "-90°", "d1", "theta1"), ("a2", "0", "0", "theta2"), ("a3", "0", "0", "theta3")],
        variables=robot.variables,
        parameters=robot.parameters,
    )
    given = joint_values(robot, "25°,40°,65°") if numeric else {}
    parts = (
        Part("table", read_question("table standard", robot.scope)),
        Part("then", read_question(asked, robot.scope), depends=("table",)),
    )
    here, there = (Exercise("e", "", "", "", parts, arm, given, numeric=numeric) for arm in (robot, wrong))
    assert expected(here, here.parts[1]) != expected(there, there.parts[1])
    answers = {part.id: expected(there, part) for part in there.parts}
    mark = mark_sheet(here, answers).parts[-1].mark
    assert (mark.verdict, mark.earned) == (Verdict.WRONG, 1)
    assert mark.diagnosis is not None
    assert mark.diagnosis.follows == ("table",)
    alone = mark_sheet(here, {"then": answers["then"]}).parts[-1].mark
    assert alone.earned < 1


@pytest.mark.parametrize("first", ["pose 0..2", "position of pose 0..2"])
@pytest.mark.parametrize(
    ("then", "answer"),
    [
        ("jacobian linear of 0..2", "[a1*c1 + a2*c12, a2*c12; -a1*s1 - a2*s12, -a2*s12; 0, 0]"),
        ("determinant of jacobian linear of 0..2", "a1*a2*(s1*c12 - c1*s12)"),
        ("column 1 of jacobian of 0..2", "a1*c1 + a2*c12, -a1*s1 - a2*s12, 0, 0, 0, 1"),
        ("torques for (1, 0, 0) of 0..2", "a1*c1 + a2*c12, a2*c12"),
    ],
)
def test_a_jacobian_differentiated_from_a_wrong_position_keeps_its_credit(first: str, then: str, answer: str) -> None:
    """With sines and cosines changed about in the position, derivatives have the signs of that position."""
    robot = load_robot("planar-2r")
    parts = (
        Part("where", read_question(first, robot.scope)),
        Part("then", read_question(then, robot.scope), depends=("where",)),
    )
    exercise = Exercise("e", "", "", "", parts, robot)
    place = ["a1*s1 + a2*s12", "a1*c1 + a2*c12", "0"]
    turn = ["s12, c12, 0", "-c12, s12, 0", "0, 0, 1"]
    pose = "[" + "; ".join(f"{r}, {x}" for r, x in zip(turn, place, strict=True)) + "; 0, 0, 0, 1]"
    mark = last_mark(exercise, pose if first.startswith("pose") else ", ".join(place), answer)
    assert (mark.verdict, mark.earned) == (Verdict.WRONG, 1)
    assert mark.diagnosis is not None
    assert mark.diagnosis.follows == ("where",)


def test_a_position_that_is_right_gives_no_credit_for_a_wrong_jacobian() -> None:
    """Nor does a wrong one for a Jacobian that is not its own."""
    exercise = chained("position of pose 0..3", "jacobian linear of 0..3")
    right, wrong = expected(exercise, exercise.parts[0]), answer_with(exercise, exercise.parts[0], "a-forgotten 3")
    jacobian = answer_with(exercise, exercise.parts[1], "cosine-sign")
    assert last_mark(exercise, right, jacobian).earned < 1
    assert last_mark(exercise, wrong, jacobian).earned < 1
