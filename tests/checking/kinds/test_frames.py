"""Frames on the axes of a robot: every assignment that keeps the rules is right, and a broken rule is named."""

from __future__ import annotations

import math
import random
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

from dhcli.algebra.floats import Floats
from dhcli.checking.exercise import Exercise
from dhcli.checking.frames.marking import frames_text, table_of
from dhcli.checking.frames.reading import TypedFrame
from dhcli.checking.frames.rules import DH2, DH3, TASK, Rules
from dhcli.checking.frames.sketch import Sketch, at_values, sketch_of
from dhcli.checking.frames.slips import as_typed
from dhcli.checking.kinds.made import question_about_frames, question_about_table
from dhcli.checking.tables.cells import dh_table_text
from dhcli.checking.tolerance import DEFAULT
from dhcli.checking.verdicts import Mark, Verdict
from dhcli.errors import DhcliError, NotationError, UnknownNameError
from dhcli.files.yaml.exercises import read_exercise
from dhcli.files.yaml.robots import load_robot
from dhcli.geometry.vectors import Vector, across, cross, dot, length, plus, scaled
from dhcli.kinematics.conventions import Convention
from dhcli.kinematics.describe.drawn import Frame
from dhcli.kinematics.describe.linear import shifted
from dhcli.kinematics.describe.normals import Lie
from dhcli.notation.tree import ONE
from tests.coupled import COUPLED
from tests.judging import answer_with, checked, expected, mark, slips, solution, vary
from tests.nightly import NIGHT, paired
from tests.row_by_row import row_by_row

LIBRARY = Path(__file__).parents[3] / "robots"
OPEN = ("dh-link", "dh-link-modified", "assembly-blocks", *COUPLED)
ROBOTS = [path.stem for path in sorted(LIBRARY.glob("*.yaml")) if path.stem not in (*OPEN, *COUPLED)]
CONVENTIONS = (Convention.STANDARD, Convention.MODIFIED)
ZHOU = "0 +x +z; (a, 0, 0) +x +z; (a + b, 0, 0) +x +y; (a + b, 0, 0) +x +y"


def asked(robot: str, convention: Convention = Convention.STANDARD, pose: str = "zero") -> Exercise:
    """Frames of a robot of the library."""
    return question_about_frames(load_robot(robot), convention, pose)


def told(answer: str, robot: str = "zhou-3r", convention: Convention = Convention.STANDARD) -> Mark:
    """An answer judged, with the slip behind it."""
    exercise = asked(robot, convention)
    return checked(exercise, exercise.parts[0], answer)


def turned(vector: Vector, axis: Vector, angle: float) -> Vector:
    """A vector turned about a unit axis."""
    beside = cross(axis, vector)
    flat = plus(scaled(across(vector, axis), math.cos(angle)), beside, math.sin(angle))
    return plus(flat, axis, dot(axis, vector))


def freely(sketch: Sketch, draw: random.Random) -> list[Frame]:
    """Other frames that keep the rules: each x and z turned over, and moved where axes are parallel or one."""
    frames = list(sketch.frames)
    for k, frame in enumerate(frames):
        legs = [leg.normal for leg in sketch.walked.legs]
        lie = legs[k].lie
        new = frame
        is_last = k == len(frames) - 1
        if lie in (Lie.PARALLEL, Lie.SAME) and not is_last:
            along = sketch.walked.lines[k].direction
            new = replace(new, origin=shifted(new.origin, along, {ONE: draw.choice((0.0, 0.25, -1.0))}))
        if lie is Lie.SAME:
            new = replace(new, x=turned(new.x, new.z, draw.choice((0.0, 0.5, 2.0))))
        if draw.random() < 0.5:
            new = replace(new, x=scaled(new.x, -1))
        if draw.random() < 0.5:
            new = replace(new, z=scaled(new.z, -1))
        frames[k] = new
    return frames


@pytest.mark.parametrize(("name", "convention"), paired(ROBOTS, CONVENTIONS))
def test_our_own_frames_are_right_and_give_the_robots_own_table(name: str, convention: Convention) -> None:
    """Of every robot, in both conventions; the table is that of the file where that has one in the convention."""
    exercise = asked(name, convention)
    part = exercise.parts[0]
    text = expected(exercise, part)
    judged = mark(exercise, part, text)
    assert (judged.verdict, judged.remarks, judged.earned) == (Verdict.RIGHT, (), 1)
    robot = load_robot(name)
    sketch = sketch_of(exercise, convention, "zero")
    rows = table_of(sketch, sketch.frames)
    if robot.convention is convention and name != "panda":
        assert rows == tuple(link.row for link in robot.links)
    shown = solution(exercise, part)
    assert shown[-1].text == f"So the answer is {text}"
    assert shown[0].text.startswith("1  z axes: DH1: ")
    *_, rows = shown[-2].text.partition("\n")
    assert mark(exercise, part, rows).verdict is Verdict.RIGHT


@pytest.mark.parametrize(
    ("name", "convention"),
    paired(["zhou-3r", "stanford", "puma560", "scara-yim", "ur5e", "cylindrical", "scara"], CONVENTIONS),
)
def test_every_other_assignment_that_keeps_the_rules_is_right_and_its_table_is_the_robot(
    name: str, convention: Convention
) -> None:
    """The table is judged by its motion, which knows nothing of frames."""
    exercise = asked(name, convention)
    sketch = sketch_of(exercise, convention, "zero")
    table = question_about_table(load_robot(name), convention, "same-motion")
    draw = random.Random(f"{name} {convention}")  # noqa: S311  the same frames every time
    for turn in range(5 if NIGHT else 2):
        frames = freely(sketch, draw)
        if turn % 2:
            frames[0], frames[-1] = sketch.frames[0], sketch.frames[-1]
        judged = checked(exercise, exercise.parts[0], frames_text(frames, exercise))
        assert judged.verdict is Verdict.RIGHT, judged
        rows = dh_table_text(table_of(sketch, frames), table.robot.columns, exercise.writing)  # type: ignore[union-attr]
        other = mark(exercise, exercise.parts[0], rows)
        assert other.verdict.passed, (rows, other)
        if turn % 2:  # else it is the robot between other frames
            assert mark(table, table.parts[0], rows).verdict.passed, rows


def fits(before: Frame, after: Frame, convention: Convention, over: Floats) -> bool:
    """Whether four DH parameters lead from one frame to another, by the entries of the matrix between them."""
    one, two = (np.array([f.x, f.y, f.z]).T for f in (before, after))
    between = one.T @ two
    gap = one.T @ (np.array(at_values(after.origin, over)) - np.array(at_values(before.origin, over)))
    if convention is Convention.STANDARD:  # Rz Tz Tx Rx: x' has no part along z, and o' lies on x' but for d
        x = between[:, 0]
        return bool(abs(x[2]) < 1e-9 and abs(gap[0] * x[1] - gap[1] * x[0]) < 1e-9)
    z = between[:, 2]  # Rx Tx Tz Rz: z' has no part along x, and o' lies on z' but for a
    return bool(abs(z[0]) < 1e-9 and abs(gap[1] * z[2] - gap[2] * z[1]) < 1e-9)


@pytest.mark.parametrize("name", ["zhou-3r", "stanford", "puma560", "ur5e"])
@pytest.mark.parametrize("convention", CONVENTIONS)
def test_a_rule_is_broken_just_where_no_four_parameters_lead_from_frame_to_frame(
    name: str, convention: Convention
) -> None:
    """DH2 and DH3 of frames that stand on their axes and are turned or moved at random, against numpy."""
    exercise = asked(name, convention)
    sketch = sketch_of(exercise, convention, "zero")
    over = Floats(sketch.values)
    draw = random.Random(f"{name} {convention} numpy")  # noqa: S311  the same frames every time
    seen = set()
    for _ in range(40):
        frames = list(sketch.frames)
        k = draw.randrange(len(frames))
        frame = frames[k]
        if draw.random() < 0.5:
            frame = replace(frame, x=turned(frame.x, frame.z, draw.choice((math.pi / 2, 1.0, math.pi))))
        if draw.random() < 0.5:
            frame = replace(frame, origin=shifted(frame.origin, frame.z, {ONE: draw.choice((0.2, -0.1))}))
        frames[k] = frame
        broken = Rules(sketch, DEFAULT).broken([as_typed(one) for one in frames])
        pairs = pairwise(frames)
        is_right = all(fits(before, after, convention, over) for before, after in pairs)
        assert bool(broken) is not is_right, (frames, broken)
        seen.add(is_right)
        assert {one.rule for one in broken} <= {DH2, DH3}
    assert seen == {True, False}


@pytest.mark.parametrize(
    ("name", "convention"), paired(["zhou-3r", "stanford", "puma560", "scara-yim", "planar-2r"], CONVENTIONS)
)
def test_each_mistake_is_named(name: str, convention: Convention) -> None:
    """By the frames of a student who makes it."""
    exercise = asked(name, convention)
    part = exercise.parts[0]
    names = [slip.name for slip in slips(exercise, part)]
    assert names[0] == "convention"
    for slip in names:
        judged = checked(exercise, part, answer_with(exercise, part, slip))
        assert judged.verdict is Verdict.WRONG
        assert 0 <= judged.earned < 1
        assert judged.diagnosis is not None
        assert judged.diagnosis.ids == (slip,)


@pytest.mark.parametrize(
    ("answer", "said", "earned"),
    [
        (ZHOU.replace("(a + b, 0, 0) +x +y;", "(a + b, 0, 0) +x +z;"), "is 90° off", 0.75),
        (
            ZHOU.replace("(a, 0, 0)", "(a, b, 0)"),
            "DH1: o1 is off the axis of joint 2 (theta2): z1 passes b beside it",
            0.75,
        ),
        (ZHOU.replace("(a, 0, 0) +x", "(a, 0, 0) (1, 1, 0)"), "DH3: x1 does not meet z0: it passes sqrt(2)*a/2", 0.8),
        (
            ZHOU.replace("(a, 0, 0) +x", "(a, 0, 0) (1, 0, 1)"),
            "DH2: x1 is not perpendicular to z0: the angle is 45°",
            0.8,
        ),
        (ZHOU.replace("(a, 0, 0) +x", "(a, 0, 0) -z"), "x1 is not perpendicular to z1: they are parallel", 0.8),
        (ZHOU.replace("(a, 0, 0) +x +z", "o = (a, 0, 0), x = +x, y = -y, z = +z"), "y1 must be z1 × x1 = +y", 0.8),
        (ZHOU.replace("(a + b, 0, 0) +x +y;", "(a + b, 0.1, 0) -z +y;"), "DH2: x2 is not perpendicular to z1", 0.8),
    ],
)
def test_each_broken_rule_is_said_with_its_joint_and_by_how_much(answer: str, said: str, earned: float) -> None:
    """The third rule is left out where the second already fails."""
    judged = told(answer)
    assert judged.verdict is Verdict.WRONG
    assert any(said in remark for remark in judged.remarks), judged.remarks
    assert sum("x2" in remark for remark in judged.remarks if "DH" in remark) <= 1
    assert judged.earned == pytest.approx(earned)


def test_frames_that_are_all_the_same_earn_nothing() -> None:
    """Nobody has worked them out; and what lies as the base does earns nothing by itself."""
    assert told("; ".join(["0 +x +z"] * 4)).earned == 0
    assert told("0 +x +z; 0 +x +z; (a, 0, 0) +x +z; (a + b, 0, 0) +x +y").earned == pytest.approx(0.5)


def test_what_is_drawn_otherwise_than_ours_is_named_with_its_table() -> None:
    """And is as right."""
    judged = told("0 -x +z; (a, 0, 5) +x -z; (a + b, 0, 0) +x +y; (a + b, 3, 0) +z +y")
    assert judged.verdict is Verdict.RIGHT
    assert "your x0 points the other way" in judged.remarks
    assert "your z1 points the other way, and theta2 counts against it" in judged.remarks
    assert "your o1 stands elsewhere on z1" in judged.remarks
    assert "your x3 is +z, and may be" in judged.remarks
    table = "[[a, 180°, 5, theta1 + 180°], [b, 90°, 5, -theta2], [0, 0, 3, theta3 - 90°]]"
    assert judged.remarks[-1] == f"your frames give the table {table}"


MARKDOWN = """
| i | origin | x | z |
|---|---|---|---|
| 0 | (0,0,0) | +x | +z |
| 1 | (a,0,0) | x | z |
| 2 | (a+b,0,0) | +x | +y |
| 3 | (a+b,0,0) | +x | +y |
"""
NAMED = """
o0 = (0, 0, 0), x0 = +x0, z0 = +z0; o1 = (a, 0, 0), x1 = +x0, z1 = +z0
frame 2 z = (0, 1, 0), x = (1, 0, 0), origin: (a + b; 0; 0)
frame 3 o = (a+b, 0, 0) x = +x y = −z z = +y
"""


@row_by_row(
    "answer",
    [
        ZHOU,
        "[0 0 0 +x +z; a 0 0 +x +z; a+b 0 0 +x +y; a+b 0 0 +x +y]",
        "0, 0, 0, +x, +z\na, 0, 0, +x, +z\na + b, 0, 0, +x, +y\na + b, 0, 0, +x, +y",
        "[[0, 0, 0, +x, +z], [a, 0, 0, +x, +z], [a + b, 0, 0, +x, +y], [a + b, 0, 0, +x, +y]]",
        MARKDOWN,
        "3: (a+b,0,0) +x +y\n2: (a+b,0,0) +x +y\n1: (a,0,0) +x +z\n0: (0,0,0) +x +z",
        NAMED,
        "0 0 0 0 1 0 0 0 0 1\n1 a 0 0 1 0 0 0 0 1\n2 a+b 0 0 2 0 0 0 3 0\n3 a+b 0 0 1 0 0 0 1 0",
        "0 +x +z; (0.4, 0, 0) +x +z; (700 mm, 0, 0) +x +y; (a + b, 0, 0) +x +y",
        "0 +x +z; (a*c1, a*s1, 0) +x +z; (a + b*c12, 0, 0) +x +y; (a + b, 0, 0) +x +y",
        "a 0 0 theta1; b -90 0 theta2; 0 0 0 theta3",
    ],
)
def test_frames_are_read_as_people_type_them(answer: str) -> None:
    """In rows, columns, tables, with names and numbers, letters or lengths; or as their table."""
    assert told(answer).verdict is Verdict.RIGHT


@row_by_row(
    ("answer", "said"),
    [
        ("0 +x +z; (a, 0, 0) +x +z", "frame 2 is missing: frames 0 to 3 are asked for"),
        (f"{ZHOU}; 0 +x +z", "there is no frame 4"),
        (ZHOU.replace("(a, 0, 0) +x", "(a, 0, 0) (0, 0, 0)"), "x1 is (0, 0, 0): a direction is not zero"),
        (ZHOU.replace("(a, 0, 0) +x", "(a, 0, 0) (a, 0, 0)"), "x1: a direction is three numbers, and a is a letter"),
        (ZHOU.replace("(a, 0, 0)", "(a, 0)"), "o1: three values are wanted, not 2"),
        (ZHOU.replace("(a, 0, 0)", "(q, 0, 0)"), "q is not a name that is known here"),
        (ZHOU.replace("(a, 0, 0)", "(sqrt(-1), 0, 0)"), "o1: "),
        (ZHOU.replace("(a, 0, 0)", "(30°, 0, 0)"), "o1: "),
        (ZHOU.replace("(a, 0, 0) +x", "(a, 0, 0) (1/0, 0, 0)"), "x1"),
        ("0: 0 +x +z; 0: 0 +x +z", "frame 0 stands there twice"),
        ("0: o = 0, x = +x; 1: 0 +x +z", "frame 0: its z axis is missing"),
        ("o1 = 0, x2 = +x, z = +z", "names more than one frame"),
        ("x = +x, x = +y, o = 0, z = +z", "x stands twice"),
        ("+x +y +z +x +y", "has 5 of three vectors"),
        ("(((((((((x", "has 1 of three vectors"),
        ("a 0 0 theta1", "theta2, theta3"),
    ],
)
def test_what_cannot_be_read_says_what_would_be(answer: str, said: str) -> None:
    """Never a traceback, and never a verdict."""
    judged = told(answer)
    assert judged.verdict is Verdict.CANNOT_READ
    assert any(said in remark for remark in judged.remarks), judged.remarks


@pytest.mark.parametrize(
    "answer",
    [
        "+x " * 10_000,
        "(" * 9_000 + "+x" + ")" * 9_000,
        "[" * 400 + "0 +x +z" + "]" * 400,
        ";" * 15_000 + "+x",
        "+x\n" * 6_000,
        ZHOU.replace("a, 0, 0", "1e8^60, 0, 0", 1),
        ZHOU.replace("a, 0, 0", "9^9^9^9, 0, 0", 1),
        ZHOU.replace("(a, 0, 0) +x", "(a, 0, 0) (1e-300, 0, 0)", 1),
        ZHOU.replace("(a, 0, 0) +x", "(a, 0, 0) (1e8^40, 0, 0)", 1),
        ZHOU.replace("(a, 0, 0) +x", "(a, 0, 0) __import__('os')", 1),
        "\u202e +x \x00",
    ],
)
def test_nothing_that_is_typed_ends_in_anything_but_a_verdict(answer: str) -> None:
    """Work is bounded, and nothing is evaluated as code."""
    judged = told(answer)
    assert judged.verdict in (Verdict.CANNOT_READ, Verdict.WRONG)
    assert judged.remarks


def test_a_table_that_no_frames_on_these_axes_have_is_wrong() -> None:
    """With the row, and the slip that gives it; one of the other convention is told so."""
    judged = told("a 0 0 theta1; b 0 0 theta2; 0 0 0 theta3")
    assert judged.verdict is Verdict.WRONG
    assert judged.remarks[0] == "no frames on these axes have this table in standard DH"
    assert judged.diagnosis is not None
    assert judged.diagnosis.ids == ("alpha-forgotten 2",)
    other = told("0 0 0 theta1; a 0 0 theta2; b -90 0 theta3")
    assert other.diagnosis is not None
    assert other.diagnosis.ids == ("convention",)


TASK_TEXT = """
format: 1
title: Frames
source: a test
robot: planar-2r
task: >-
  {task}
parts:
  - {{id: frames, ask: frames {convention}, hints: [z first]}}
  - {{id: a1, ask: cell a 1, depends: [frames], hints: [look]}}
"""
PLANAR = "0 +x +z; (a1, 0, 0) +x +z; (a1 + a2, 0, 0) +x +z"


def written(task: str, convention: str = "standard") -> Exercise:
    """An exercise with a task of its own."""
    return read_exercise(TASK_TEXT.format(task=task, convention=convention), "x.yaml", "x")


@pytest.mark.parametrize(
    ("task", "answer", "said"),
    [
        ("Base frame 0 stands in the shoulder.", PLANAR.replace("0 +x", "0 -x", 1), "frame 0 is the base frame"),
        (
            "The end frame 2 stands at the tip.",
            PLANAR.replace("a2, 0, 0) +x", "a2, 0, 0) -x"),
            "frame 2 is the end frame",
        ),
        ("The end frame 2 stands at the tip.", PLANAR.replace("a1 + a2, 0, 0", "a1 + a2, 0, 1"), "its origin is"),
        (
            "Positive sense: from above.",
            PLANAR.replace("(a1, 0, 0) +x +z", "(a1, 0, 0) +x -z"),
            "z1 points the other way",
        ),
    ],
)
def test_what_a_task_fixes_is_not_free(task: str, answer: str, said: str) -> None:
    """Where it does not, the same frames are right."""
    exercise = written(task)
    judged = checked(exercise, exercise.parts[0], answer)
    assert judged.verdict is Verdict.WRONG
    assert any(said in remark for remark in judged.remarks), judged.remarks
    rules = Rules(sketch_of(exercise, Convention.STANDARD, ""), DEFAULT)
    assert {one.rule for one in rules.broken(_typed(exercise, answer))} == {TASK}
    free = written("Put frames on it.")
    assert mark(free, free.parts[0], answer).verdict is Verdict.RIGHT


def _typed(exercise: Exercise, answer: str) -> tuple[TypedFrame, ...]:
    from dhcli.checking.frames.reading import read_frames

    return read_frames(answer, exercise, range(3), {})


def test_the_sense_that_a_task_states_has_a_name_where_it_is_missed() -> None:
    """The right-hand rule."""
    exercise = written("Positive sense: from above.")
    names = [slip.name for slip in slips(exercise, exercise.parts[0])]
    assert "z-sign 1" in names


def test_a_cell_that_follows_from_other_frames_keeps_its_credit() -> None:
    """Frames are free, and a table is read off them."""
    from tests.judging import mark_sheet

    exercise = written("Put frames on it.")
    other = "0 +x +z; (a1, 0, 0) -x +z; (a1 + a2, 0, 0) +x +z"
    marked = mark_sheet(exercise, {"frames": other, "a1": "-a1"})
    assert [one.mark.verdict for one in marked.parts] == [Verdict.RIGHT, Verdict.WRONG]
    assert marked.parts[1].mark.earned == 1
    assert "right from your frames" in marked.parts[1].mark.remarks[0]


def test_matrices_that_follow_from_other_frames_keep_their_credit() -> None:
    """A link matrix and a pose of the exercise that walks the process, from frames whose x1 and x2 are turned over."""
    from dhcli.files.yaml.exercises import load_exercise
    from tests.judging import mark_sheet

    frames = "0 +x +z; (a, 0, 0) -x +z; (a + b, 0, 0) +x +y; (a + b, 0, 0) +x +y"
    link = "[-c2 0 s2 -b*c2; -s2 0 -c2 -b*s2; 0 -1 0 0; 0 0 0 1]"
    marked = mark_sheet(load_exercise("yim/dh-process"), {"frames": frames, "step5": link})
    found = {one.part.id: one.mark for one in marked.parts}
    assert found["frames"].verdict is Verdict.RIGHT
    assert found["step5"].earned == 1
    assert "right from your frames, which has other frames" in found["step5"].remarks[0]
    alone = mark_sheet(load_exercise("yim/dh-process"), {"step5": link})
    assert next(one.mark for one in alone.parts if one.part.id == "step5").earned < 1


def test_a_sheet_shows_the_axes_and_a_row_for_each_frame() -> None:
    """There is no picture on it."""
    from dhcli.files.yaml.sheets import write_sheet

    sheet = write_sheet(written("Put frames on it."))
    words = " ".join(sheet.replace("#", "").split())
    assert "seen from the base, drawn with all joints at 0: theta1 +z through (0, 0, 0); theta2 +z" in words
    assert "  frames: |\n    _  _  _  _  _\n    _  _  _  _  _\n    _  _  _  _  _\n" in sheet


@pytest.mark.parametrize(
    ("ask", "error", "said"),
    [
        ("frames standrd", NotationError, "there are no frames 'standrd'"),
        ("frames standard at elbo", UnknownNameError, "has no pose elbo"),
    ],
)
def test_a_question_that_cannot_be_asked_is_refused(ask: str, error: type[DhcliError], said: str) -> None:
    """The convention and the pose are named."""
    from dhcli.checking.kinds.registry import read_question

    robot = load_robot("planar-2r")
    with pytest.raises(error) as caught:
        read_question(ask, robot.scope).check(robot)
    assert said in str(caught.value)


def test_a_robot_that_stands_on_something_is_seen_from_its_own_frame_0() -> None:
    """Where its table says what that is; else from the base."""
    robot = load_robot("zhou-3r").copy(base="Trans(0, 0, 0.5) Rot(x, 30°)")
    exercise = question_about_frames(robot, Convention.STANDARD)
    part = exercise.parts[0]
    assert mark(exercise, part, ZHOU).remarks == ()
    assert "seen from frame 0 of the robot, drawn" in " ".join(part.question.notes(exercise))
    other = question_about_frames(robot, Convention.MODIFIED)
    assert "seen from the base, drawn" in " ".join(other.parts[0].question.notes(other))
    assert mark(other, other.parts[0], expected(other, other.parts[0])).verdict is Verdict.RIGHT


def test_a_pose_turns_the_axes() -> None:
    """Drawn with theta1 at 90°, the second axis is elsewhere, and offsets make up for it."""
    exercise = asked("planar-2r", Convention.STANDARD, "up")
    part = exercise.parts[0]
    assert expected(exercise, part) == "(0, 0, 0) +x +z; (0, a1, 0) +y +z; (0, a1 + a2, 0) +y +z"
    assert mark(exercise, part, expected(exercise, part)).verdict is Verdict.RIGHT
    sketch = sketch_of(exercise, Convention.STANDARD, "up")
    assert table_of(sketch, sketch.frames) == tuple(link.row for link in load_robot("planar-2r").links)


IN_MM = """
format: 1
title: Frames in mm
source: a test
robot: planar-2r
numeric: true
unit: mm
task: Put frames on it.
given: {a1: 400 mm, a2: 300 mm}
variants: {a1: 300 mm..500 mm step 10 mm}
parts:
  - {id: frames, ask: frames standard, hints: [z first]}
tests:
  - {part: frames, answer: "0 +x +z; (400, 0, 0) +x +z; (700, 0, 0) +x +z", verdict: RIGHT}
  - {part: frames, mistake: frame-on-joint 1, verdict: WRONG}
"""


def test_frames_in_numbers_are_in_the_unit_of_the_sheet_and_vary() -> None:
    """Each variant is right with its own numbers, and with no others."""
    exercise = read_exercise(IN_MM, "x.yaml", "x")
    part = exercise.parts[0]
    assert expected(exercise, part) == "(0, 0, 0) +x +z; (400, 0, 0) +x +z; (700, 0, 0) +x +z"
    assert mark(exercise, part, "0 +x +z; (400, 0, 0) +x +z; (0.7 m, 0, 0) +x +z").verdict is Verdict.RIGHT
    other = vary(exercise, "alice")
    assert expected(other, part) != expected(exercise, part)
    assert mark(other, part, expected(other, part)).verdict is Verdict.RIGHT
    names = [slip.name for slip in slips(exercise, part)]
    assert names
    for name in names:
        assert mark(exercise, part, answer_with(exercise, part, name)).verdict is Verdict.WRONG


def test_numbers_near_the_right_ones_are_right_within_the_tolerance() -> None:
    """A thousandth of the size; letters that are wrong are wrong however small."""
    near = "0 +x +z; (0.4003, 0, 0) +x +z; (a + b, 0, 0) (1, 0.0005, 0) +y; (a + b, 0, 0) +x +y"
    assert told(near).verdict is Verdict.RIGHT
    assert told(near.replace("0.4003", "0.4103")).verdict is Verdict.WRONG
    assert length((1.0, 0.0, 0.0)) == 1
