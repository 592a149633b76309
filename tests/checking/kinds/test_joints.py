"""Joint values for a pose: judged by where they take the arm, whole turns aside, then by the branch asked for."""

from __future__ import annotations

import math
from functools import cache
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhcli import forward
from dhcli.checking.exercise import Exercise
from dhcli.checking.judge import Judge
from dhcli.checking.kinds.joint_formula import JointFormulaQuestion
from dhcli.checking.kinds.joints import JointsQuestion
from dhcli.checking.kinds.made import question_about
from dhcli.checking.kinds.reaching import SolutionsQuestion
from dhcli.checking.verdicts import Mark, Verdict
from dhcli.errors import DhcliError, NotationError
from dhcli.files.yaml.exercises import load_exercise
from dhcli.files.yaml.robots import load_robot
from tests.judging import judge_of
from tests.nightly import NIGHT, in_turn
from tests.row_by_row import row_by_row

PLACE = "joints of position (0.5, 0.3, 0)"
FOLDER = Path(__file__).parents[3] / "exercises" / "inverse"
BACK = (JointsQuestion, JointFormulaQuestion, SolutionsQuestion)
NAMES = sorted(path.stem for path in FOLDER.glob("*.yaml"))


def asked(ask: str, robot: str = "planar-2r") -> Exercise:
    """A question about a robot, in numbers."""
    return question_about(load_robot(robot), ask, numeric=True, given={})


@cache
def judge_about(ask: str, robot: str) -> Judge:
    """The judge of a question, made once for all its answers."""
    return Judge(asked(ask, robot))


def judged(answer: str, ask: str = PLACE, robot: str = "planar-2r") -> Mark:
    """An answer, explained where it is wrong."""
    judge = judge_about(ask, robot)
    return judge.check(judge.exercise.parts[0], answer)


@row_by_row(
    "answer",
    [
        "2.4773°, 67.9757°",
        "59.4502, -67.9757",
        "[59.45° -67.98°]",
        "theta2 = -67.98°, theta1 = 59.45°",
        "theta1 = 2.4773°\ntheta2 = 67.9757°",
        "q = [2.4773°, 67.9757°]",
        "362.4773°, -292.0243°",
        "0.0432371 rad, 1.1864 rad",
        "acos(0.99906540), 67.9757°",
        "2,4773; 67,9757",
        "2,4773° 67,9757°",
        "theta1 = 2,4773; theta2 = 67,9757",
        "θ1 = 2.4773° θ2 = 67.9757°",
        "(2.4773, 67.9757)",
        "θ1 ≈ 2.4773°, θ2 ≈ 67.9757°",
        "q1: 2.4773°, q2: 67.9757°",
        "2.4773° and 67.9757°",
        "(2.4773°, 67.9757°).",
        "(0.0432371, 1.1864) rad",
        "[2.4773; 67.9757]°",
        "（２．４７７３°，６７．９７５７°）",
    ],
)
def test_joint_values_are_read_as_people_type_them(answer: str) -> None:
    """In rows and columns, with labels in any order, in degrees or radians, in any turn."""
    assert judged(answer).verdict is Verdict.RIGHT


def test_an_answer_is_judged_by_where_it_takes_the_arm() -> None:
    """A wrong one is told where it leads; a near one is close."""
    wrong = judged("10°, 20°")
    assert wrong.verdict is Verdict.WRONG
    x = 0.4 * math.cos(math.radians(10)) + 0.3 * math.cos(math.radians(30))
    assert f"({x:.4f}, " in wrong.remarks[0]
    assert judged("2.6°, 67.9757°").verdict is Verdict.CLOSE


@pytest.mark.parametrize(
    ("answer", "ask", "robot", "unit"),
    [
        ("0.0432371, 1.1864", PLACE, "planar-2r", "radians"),
        ("theta2 = 1.1864, theta1 = 0.0432371", PLACE, "planar-2r", "radians"),
        ("2.4773°, 1.1864", PLACE, "planar-2r", "radians"),
        ("0.0432371, 1.1864; 1.03760, -1.1864", f"{PLACE} all", "planar-2r", "radians"),
        ("0.0432371, 1.1864", f"{PLACE} branch elbow down", "planar-2r", "radians"),
        ("300, 200, 100", "joints of position (0.1, 0.2, 0.3)", "cartesian", "mm"),
        ("0.3 m, 20, 10", "joints of position (0.1, 0.2, 0.3)", "cartesian", "cm"),
    ],
)
def test_another_unit_of_joint_values_is_told_and_earns_its_share(answer: str, ask: str, robot: str, unit: str) -> None:
    """Half of the credit, as that of every other kind; only mere numbers are read so."""
    mark = judged(answer, ask, robot)
    assert (mark.verdict, mark.other_unit, mark.earned) == (Verdict.CANNOT_READ, unit, 0.5)
    assert mark.remarks[0].startswith(f"right in {unit}; ")


@row_by_row(
    "answer",
    [
        "(2.4773, 67.9757), (59.4502, -67.9757)",
        "[(2.4773, 67.9757), (59.4502, -67.9757)]",
        "(2.4773; 67.9757)\n(59.4502; -67.9757)",
        "[[2.4773, 67.9757], [59.4502, -67.9757]]",
        "q1 = 2.4773, q2 = 67.9757\nq2 = -67.9757, q1 = 59.4502",
        "theta1 = 2.4773° theta2 = 67.9757°; theta1 = 59.4502° theta2 = -67.9757°",
        "2,4773 67,9757; 59,4502 -67,9757",
        "2.4773 67.9757, 59.4502 -67.9757",
        "59.4502° -67.9757°, 2.4773° 67.9757°",
        "(acos(0.99906540), 67.9757°), (59.4502, -67.9757)",
        "(2.4773°, 67.9757°) or (59.4502°, -67.9757°)",
        "((2.4773°, 67.9757°), (59.4502°, -67.9757°))",
        "1) 2.4773°, 67.9757°\n2) 59.4502°, -67.9757°",
        "a) 2.4773°, 67.9757°; b) 59.4502°, -67.9757°",
        "elbow down: 2.4773°, 67.9757°\nelbow up: 59.4502°, -67.9757°",
        "Solution 1: (2.4773°, 67.9757°)\nSolution 2: (59.4502°, -67.9757°)",
        "1: theta1 = 2.4773°, theta2 = 67.9757°\n2: theta1 = 59.4502°, theta2 = -67.9757°",
        "(2.4773, 67.9757) deg, (59.4502, -67.9757) deg",
        "(0.04324, 1.18640) rad or (1.03760, -1.18640) rad",
        "2,4773; 67,9757\n59,4502; -67,9757",
        "2.4773; 67.9757\n59.4502; -67.9757",
        "θ1 = 2.4773°, θ2 = 67.9757° or θ1 = 59.4502°, θ2 = -67.9757°",
    ],
)
def test_several_solutions_are_read_as_people_type_them(answer: str) -> None:
    """A row each, in brackets, behind the names of joints or one of its own, with points or decimal commas."""
    assert judged(answer, f"{PLACE} all").verdict is Verdict.RIGHT


@pytest.mark.parametrize(
    ("answer", "unit"), [("0.2, 0.2 m, 0.1 m", ""), ("0.2, 200, 100", "mm"), ("0, 200, 100", "mm")]
)
def test_a_length_that_is_0_is_right_in_another_unit_only_beside_one_that_is_not(answer: str, unit: str) -> None:
    """By chance a wrong one is near enough to 0 there."""
    mark = judged(answer, "joints of position (0.1, 0.2, 0)", "cartesian")
    assert (mark.verdict, mark.other_unit) == (Verdict.CANNOT_READ if unit else Verdict.WRONG, unit)


@pytest.mark.parametrize(
    "answer", ["(10) - 7.5227, 67.9757", "atan2(0.04324, 1) rad, 67.9757", "2*(1.23865)°, 67.9757"]
)
def test_brackets_of_a_sum_and_of_a_function_belong_to_the_value(answer: str) -> None:
    """They are no number of a row, and no row with a unit behind it."""
    assert judged(answer).verdict is Verdict.RIGHT


@pytest.mark.parametrize(
    ("answer", "said"),
    [
        ("theta1 = 2, theta1 = 3", "each joint is named once in a row: theta1, theta2"),
        ("2,4773, 67,9757, 5", "if 2,4773 is one number, write 2.4773"),
    ],
)
def test_joint_values_that_cannot_be_told_apart_are_asked_about(answer: str, said: str) -> None:
    """Which belongs to which joint is never guessed."""
    mark = judged(answer)
    assert mark.verdict is Verdict.CANNOT_READ
    assert said in " ".join(mark.remarks)


@pytest.mark.parametrize(
    ("answer", "said"),
    [
        ("1°, 2°, 3°", "3 values in a row, and there are 2 joints"),
        ("theta1 = 1°, theta1 = 2°", "each joint is named once"),
        ("theta9 = 1°, theta1 = 2°", "theta9"),
        ("0.4 m, 10°", "theta1: "),
        ("acos(3), 10°", "not a real number"),
        ("2.4773°, 67.9757°; 59.4502°, -67.9757°", "one solution is asked for"),
    ],
)
def test_what_cannot_be_judged_says_what_would_be(answer: str, said: str) -> None:
    """Too many values, a joint twice or none, a length for an angle, two answers for one."""
    mark = judged(answer)
    assert mark.verdict is Verdict.CANNOT_READ
    assert any(said in remark for remark in mark.remarks), mark.remarks


def test_the_branch_asked_for_counts() -> None:
    """The other one reaches the pose, which is said."""
    ask = f"{PLACE} branch elbow up"
    assert judged("59.4502°, -67.9757°", ask).verdict is Verdict.RIGHT
    other = judged("2.4773°, 67.9757°", ask)
    assert other.verdict is Verdict.WRONG
    assert other.diagnosis is not None
    assert other.diagnosis.ids == ("other-branch",)
    assert "elbow down" in other.remarks[0]


@pytest.mark.parametrize("answer", ["67.9757°, 2.4773°", "-67.9757°, 59.4502°"])
def test_joint_values_in_another_order_have_a_name(answer: str) -> None:
    """On either branch."""
    mark = judged(answer)
    assert mark.verdict is Verdict.WRONG
    assert mark.diagnosis is not None
    assert mark.diagnosis.ids == ("joints-swapped theta1 theta2",)


@row_by_row(
    ("answer", "ask", "name"),
    [
        ("2.4773°, -67.9757°", PLACE, "joint-sign theta2"),
        ("-59.4502°, -67.9757°", PLACE, "joint-sign theta1"),
        ("-59.4502°, 67.9757°; -2.4773°, -67.9757°", f"{PLACE} all", "joint-signs"),
        ("59.4502°, 67.9757°; 2.4773°, -67.9757°", f"{PLACE} all", "joint-sign theta2"),
    ],
)
def test_a_joint_that_counts_the_other_way_has_a_name(answer: str, ask: str, name: str) -> None:
    """In one solution or in all of them."""
    mark = judged(answer, ask)
    assert mark.verdict is Verdict.WRONG
    assert mark.diagnosis is not None
    assert name in mark.diagnosis.ids


@pytest.mark.parametrize("answer", ["2.4773°, 70.453°", "59.4502°, -8.5175°"])
def test_an_angle_that_is_that_of_the_link_itself_has_a_name(answer: str) -> None:
    """Theta1 + theta2 for theta2, on either branch."""
    mark = judged(answer)
    assert mark.verdict is Verdict.WRONG
    assert mark.diagnosis is not None
    assert mark.diagnosis.ids == ("absolute-angle theta2",)


def test_a_set_earns_by_each_solution() -> None:
    """What is missing, what is none, and what stands there twice is named."""
    ask = f"{PLACE} all"
    whole = judged("59.4502°, -67.9757°; 2.4773°, 67.9757°", ask)
    assert (whole.verdict, whole.earned) == (Verdict.RIGHT, 1)
    half = judged("59.4502°, -67.9757°", ask)
    assert (half.verdict, half.earned) == (Verdict.WRONG, 0.5)
    assert half.remarks[0] == "1 solution of 2: the branch elbow down is left out"
    more = judged("59.4502°, -67.9757°; 2.4773°, 67.9757°; 362.4773°, 67.9757°; 5°, 6°", ask)
    assert more.earned == pytest.approx(2 / 3)
    assert any("row 3 repeats row 2" in remark for remark in more.remarks)
    assert any("row 4 is no solution" in remark for remark in more.remarks)


def test_a_repeat_alone_is_no_mistake() -> None:
    """It is told, and costs nothing."""
    mark = judged("59.4502°, -67.9757°; 2.4773°, 67.9757°; 362.4773°, 67.9757°", f"{PLACE} all")
    assert (mark.verdict, mark.earned) == (Verdict.RIGHT, 1)
    assert any("repeats" in remark for remark in mark.remarks)


def test_a_singular_pose_takes_every_member_of_its_family() -> None:
    """Only the sum of the two angles counts."""
    ask = 'joints of orientation "Rot(z, 65°)"'
    assert judged("100°, 0°, -35°", ask, "spherical-wrist").verdict is Verdict.RIGHT
    assert judged("65°, 0°, 65°", ask, "spherical-wrist").verdict is Verdict.WRONG


def test_limits_count_where_they_are_asked_for() -> None:
    """Outside them a solution is wrong there, and told elsewhere."""
    pose = 'joints of pose "Trans(0.5, 0.2, 0.3) Rot(z, 20°) Rot(y, 110°) Rot(z, 40°)"'
    outside = "5.6226°, 16.1319°, -179.7386°, 193.5284°, -94.0837°, 35.9712°"
    free = judged(outside, pose, "puma560")
    assert free.verdict is Verdict.RIGHT
    assert "theta4" in free.remarks[0]
    kept = judged(outside, f"{pose} within limits", "puma560")
    assert kept.verdict is Verdict.WRONG
    assert kept.diagnosis is not None
    assert kept.diagnosis.ids == ("out-of-limits",)


def test_a_pose_out_of_reach_is_no_question() -> None:
    """Why is said; so is a branch that no solution has."""
    with pytest.raises(DhcliError, match="the links laid end to end"):
        judged("1°, 2°", "joints of position (0.9, 0.3, 0)")
    with pytest.raises(DhcliError, match="no solution is elbow left"):
        judged("1°, 2°", f"{PLACE} branch elbow left")


@pytest.mark.parametrize(
    "ask", ["joints", "joints of pose", "joints of position (1, 2)", f"{PLACE} some", "joints of speed (1, 2, 3)"]
)
def test_a_question_that_gives_no_pose_is_refused(ask: str) -> None:
    """With what would be read."""
    with pytest.raises(NotationError):
        asked(ask)


@given(
    st.sampled_from(["planar-2r", "articulated", "cylindrical", "scara-yim"]),
    st.lists(st.floats(0.2, 1.2), min_size=4, max_size=4),
    st.integers(-1, 1),
)
def test_the_joint_values_that_made_a_pose_are_right(name: str, values: list[float], turns: int) -> None:
    """Whatever else leads there, and in whatever turn."""
    robot = load_robot(name)
    from dhcli.kinematics.forward import forward

    q = values[: len(robot.variables)]
    pose = forward(robot, q)
    matrix = "; ".join(" ".join(repr(float(x)) for x in row) for row in pose.rows)
    texts = [
        f"{x + turns * math.tau!r} rad" if n in robot.angles else f"{x!r} m"
        for n, x in zip(robot.variables, q, strict=True)
    ]
    exercise = question_about(robot, f'joints of pose "[{matrix}]"', numeric=True, given={})
    assert Judge(exercise).mark(exercise.parts[0], ", ".join(texts)).verdict is Verdict.RIGHT


SLOW = ("puma560-eight-solutions", "stanford-joints")
"""Exercises whose slips take long to work out, and are of kinds that others have."""


@pytest.mark.parametrize("name", [name for name in in_turn(NAMES, 1, 2) if NIGHT or name not in SLOW])
def test_a_slip_on_the_way_back_has_its_name(name: str) -> None:
    """At least nine in ten of those that show, and no answer with a slip is right; by day, of each kind the last."""
    exercise = load_exercise(FOLDER / f"{name}.yaml")
    judge = judge_of(exercise)
    named = total = 0
    parts = [part for part in exercise.parts if isinstance(part.question, BACK)]
    slips = [(one, slip) for one in parts for slip in judge.slips(one)]
    of_each_kind = {(type(one.question), slip.name.split()[0]): (one, slip) for one, slip in slips}
    for part, slip in slips if NIGHT else of_each_kind.values():
        mark = judge.check(part, judge.answer_with(part, slip.name))
        assert mark.verdict is not Verdict.RIGHT, (part.id, slip.name)
        total += 1
        named += mark.diagnosis is not None and slip.name in mark.diagnosis.ids
    assert named >= 0.9 * total, (named, total)
    assert total or name in {"planar-reach", "wrist-centre", "puma560-motor-angles"}


def test_there_are_exercises_for_every_arm_of_the_documents() -> None:
    """Sixteen at least."""
    assert len(NAMES) >= 16


IN_MILLIMETRES = """\
format: 1
title: a place in millimetres
source: made for a test
robot: planar-2r
numeric: true
unit: mm
task: Where do the joints stand?
parts:
  - {id: a, ask: "joints of position (500, 300, 0)"}
  - {id: b, ask: "joints of position (0.5 m, 300, 0)"}
  - {id: c, ask: "joints of pose 'Trans(400, 300, 0) Rot(z, 90°)'"}
  - {id: d, ask: "reach of position (500, 300, 0)"}
  - {id: e, ask: "count solutions of position (500, 300, 0)"}
"""


def test_bare_lengths_of_a_pose_are_in_the_unit_of_the_exercise(tmp_path: Path) -> None:
    """As those of a point are; a length with its own unit is what it says."""
    path = tmp_path / "place.yaml"
    path.write_text(IN_MILLIMETRES, "utf-8")
    exercise = load_exercise(path)
    answers = {part.id: "2.4773°, 67.9757°" for part in exercise.parts} | {"c": "0°, 90°", "d": "yes", "e": "2"}
    for part in exercise.parts:
        mark = Judge(exercise).check(part, answers[part.id])
        assert mark.verdict is Verdict.RIGHT, (part.id, mark)
    assert "(500, 300, 0) mm" in exercise.parts[0].question.describe(exercise)


PAN_TILT = """\
format: 1
title: pan and tilt
source: made for a test
convention: standard
variables: [theta1, theta2]
links:
  - {theta: theta1, d: 0, a: 0, alpha: -90°}
  - {theta: theta2, d: 0, a: 0, alpha: 90°}
"""


@pytest.mark.parametrize(
    ("answer", "verdict"),
    [
        ("45°, 54.7356°", Verdict.RIGHT),
        ("-135°, -54.7356°", Verdict.RIGHT),
        ("45°, -54.7356°", Verdict.WRONG),
        ("45°, 35.2644°", Verdict.WRONG),
    ],
)
def test_a_direction_is_judged_by_where_z_points(tmp_path: Path, answer: str, verdict: Verdict) -> None:
    """Whatever the spin about it: z along (1, 1, 1), of any length."""
    path = tmp_path / "pan-tilt.yaml"
    path.write_text(PAN_TILT, "utf-8")
    exercise = question_about(load_robot(str(path)), "joints of pointing (2, 2, 2)", numeric=True, given={})
    part = exercise.parts[0]
    mark = Judge(exercise).check(part, answer)
    assert mark.verdict is verdict, mark
    assert "z of frame 2 along (0.57735, 0.57735, 0.57735)" in part.question.describe(exercise)
    counted = question_about(load_robot(str(path)), "count solutions of pointing (2, 2, 2)", numeric=True, given={})
    assert Judge(counted).check(counted.parts[0], "2").verdict is Verdict.RIGHT


def test_a_place_and_a_direction_are_judged_together() -> None:
    """SCARA points the same way whatever it does, and not the other way."""
    robot = load_robot("scara")
    pose = forward(robot, [0.3, 0.5, 0.1])
    x, y, z = (row[3] for row in pose.rows[:3])
    along = [row[2] for row in pose.rows[:3]]
    place = f"joints of position ({x!r}, {y!r}, {z!r}) pointing"
    there = f"{place} ({', '.join(map(repr, along))})"
    back = f"{place} ({', '.join(repr(-part) for part in along)})"
    assert judged("0.3 rad, 0.5 rad, 0.1 m", there, "scara").verdict is Verdict.RIGHT
    assert judged("0.3 rad, 0.6 rad, 0.1 m", there, "scara").verdict is Verdict.WRONG
    with pytest.raises(DhcliError, match="the last z axis always"):
        judged("0.3 rad, 0.5 rad, 0.1 m", back, "scara")


@pytest.mark.parametrize("ask", ["joints of pointing (0, 0, 0)", "joints of pointing (1, 2)", "reach of pointing"])
def test_what_is_no_direction_is_refused(ask: str) -> None:
    """Three parts, not all of them 0."""
    with pytest.raises(NotationError):
        asked(ask)
