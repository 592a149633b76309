"""Formulas for a joint: right if every value solves and none is missing, in whatever form."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import pytest

from dhcli.checking.exercise import Case
from dhcli.checking.judge import Judge, check
from dhcli.checking.kinds.made import question_about
from dhcli.checking.returned import Reading
from dhcli.checking.solving.mended import mended
from dhcli.checking.verdicts import Mark, Verdict
from dhcli.errors import DhcliError, NotationError
from dhcli.files.yaml.exercises import load_exercise
from dhcli.files.yaml.robots import load_robot
from dhcli.kinematics.robot import Robot
from dhcli.notation.styles import THETAS
from tests.nightly import NIGHT
from tests.row_by_row import row_by_row

COSINE = "(px^2 + py^2 - a1^2 - a2^2)/(2*a1*a2)"
PUMA_K = "K = (px^2 + py^2 + pz^2 - a2^2 - a3^2 - d3^2 - d4^2)/(2*a2)\n"


IN_NUMBERS = Robot.from_dh([(0.3, 0, 0, "theta1"), (0.2, 0, 0, "theta2")], variables=["theta1", "theta2"])
SLIDING = Robot.from_dh([(0, "90°", 0.4, "theta1"), (0, 0, "d2", 0)], variables=["theta1", "d2"])


IN_AN_EXERCISE = [
    ("stanford", "joint d3 of pose", "±sqrt((px-d6*r13)^2 + (py-d6*r23)^2 + (pz-d6*r33)^2 - d2^2)"),
]
"""A slow one, which by day is right in the tests of the exercise that asks it."""


@cache
def judge_of(ask: str, robot: str | Robot, unit: str) -> Judge:
    """The judge of a question, made once for all its answers."""
    arm = load_robot(robot) if isinstance(robot, str) else robot
    return Judge(replace(question_about(arm, ask, numeric=False, given={}), unit=unit))


def judged(
    answer: str, ask: str = "angle theta2 of position", robot: str | Robot = "planar-2r", unit: str = "m"
) -> Mark:
    """An answer, explained where it is wrong."""
    judge = judge_of(ask, robot, unit)
    return judge.check(judge.exercise.parts[0], answer)


@pytest.mark.parametrize(
    ("robot", "ask", "answer"),
    [
        ("planar-2r", "angle theta2 of position", f"±acos({COSINE})"),
        ("planar-2r", "angle theta2 of position", f"theta_2 = \\pm arccos({COSINE})"),
        ("planar-2r", "angle theta2 of position", f"D = {COSINE}\ntheta2 = atan2(+-sqrt(1 - D^2), D)"),
        ("planar-2r", "angle theta2 of position", f"theta2 = atan2(±sqrt(1 - D^2), D), D = {COSINE}"),
        ("planar-2r", "angle theta2 of position", f"±acos(D), where D = {COSINE}"),
        ("planar-2r", "angle theta2 of position", f"acos(D), -acos(D) with D = {COSINE}"),
        ("planar-2r", "angle theta2 of position", f"D = {COSINE}, theta2 = ±acos(D)"),
        ("planar-2r", "angle theta2 of position", f"theta2 = ±acos(D)\nD = {COSINE}"),
        ("planar-2r", "angle theta2 of position", f"c2 = {COSINE}; s2 = ±sqrt(1 - c2^2); θ2 = atan2(s2, c2)"),
        ("planar-2r", "angle theta2 of position", f"D = {COSINE}, θ2 = atan2(±√(1 − D²), D)"),
        ("planar-2r", "angle theta2 of position", f"θ2 = atan2(±sqrt(1-D^2), D) with D = {COSINE}."),
        ("planar-2r", "angle theta2 of position", f"theta2 = acos(D) or theta2 = -acos(D), D = {COSINE}"),
        ("planar-2r", "angle theta2 of position", f"θ2 = atan2(±sqrt(1-D^2), D)\nD = {COSINE}"),
        ("planar-2r", "angle theta2 of position", f"θ2 = acos({COSINE}), θ2 = -acos({COSINE})"),
        ("planar-2r", "angle theta2 of position", "\\theta_2 = \\pm\\arccos\\frac{p_x^2+p_y^2-a_1^2-a_2^2}{2a_1a_2}"),
        ("planar-2r", "angle theta2 of position", "π ∓ acos((a1^2 + a2^2 - x^2 - y^2)/(2 a1 a2))"),
        ("planar-2r", "angle theta2 of position", f"acos({COSINE}), -acos({COSINE})"),
        ("planar-2r", "angle theta2 of position", f"acos({COSINE}) or -acos({COSINE})"),
        ("planar-2r", "angle theta2 of position", "atan2(py - a1*s1, px - a1*c1) - theta1"),
        ("planar-2r", "angle theta1 of position", "atan2(py, px) - atan2(a2*s2, a1 + a2*c2)"),
        ("puma560", "angle theta1 of pose", "atan2(py, px) - atan2(d3, ±sqrt(px^2 + py^2 - d3^2))"),
        ("puma560", "angle theta3 of pose", f"{PUMA_K}theta3 = atan2(a3, d4) - atan2(K, ±sqrt(a3^2 + d4^2 - K^2))"),
        ("spherical-wrist", "angle theta5 of orientation", "±acos(r33)"),
        ("cylindrical", "angle theta1 of position", "atan2(-px, py), or 180° more"),
        ("cylindrical", "angle theta1 of position", "atan2(∓px, ±py)"),
        *(IN_AN_EXERCISE if NIGHT else []),
    ],
)
def test_every_form_of_a_right_formula_is_right(robot: str, ask: str, answer: str) -> None:
    """With names for its parts, as books have it, with the other joints or without."""
    mark = judged(answer, ask, robot)
    assert (mark.verdict, mark.earned) == (Verdict.RIGHT, 1), mark.remarks


SHOULDER = "angle theta1 of position"
ELBOW = "angle theta2 of position"


@pytest.mark.parametrize(
    ("ask", "answer", "words"),
    [
        (ELBOW, "±acos((px + py^2 - a1^2 - a2^2)/(2*a1*a2))", "the formula for theta2 has px for px^2"),
        (ELBOW, "±acos((px^2 + py^2 - a1^2 - a2)/(2*a1*a2))", "the formula for theta2 has a2 for a2^2"),
        (ELBOW, "±acos((px^2 + py^2 - a1^2 - a2^2)/(a1*a2))", "the factor 2 is missing in the formula for theta2"),
        (ELBOW, "±acos((px^2 + py^2 - a1^2)/(2*a1*a2))", "the formula for theta2 lacks a2^2"),
        (
            ELBOW,
            "±acos((px^2 + py^2 + a1^2 - a2^2)/(2*a1*a2))",
            "the sign of a1^2 in the formula for theta2 is turned round",
        ),
        (ELBOW, f"±asin({COSINE})", "the formula for theta2 has asin for acos"),
        (
            ELBOW,
            "D = (px^2 + py^2 - a1^2 + a2^2)/(2*a1*a2)\ntheta2 = atan2(±sqrt(1 - D^2), D)",
            "the sign of a2^2 in the formula for theta2 is turned round",
        ),
        (SHOULDER, "atan2(py, px)", "the formula for theta1 lacks atan2(a2*s2, a1 + a2*c2)"),
        (
            SHOULDER,
            "atan2(py, px) - atan2(a1*s2, a2 + a1*c2)",
            "a1 and a2 have changed places in the formula for theta1",
        ),
        (
            SHOULDER,
            "atan2(py, px) - atan2(a2*c2, a1 + a2*s2)",
            "sines and cosines have changed places in the formula for theta1",
        ),
    ],
)
def test_a_slip_in_the_terms_of_a_formula_has_a_name(ask: str, answer: str, words: str) -> None:
    """Even where the formula has a value at no pose that the arm reaches; the hint says none of it."""
    found = judged(answer, ask).diagnosis
    assert found is not None
    assert found.names == (words,)
    assert not set(found.hints[0]) & set("^*/()")


D = f"D = {COSINE}"
ROOT = "±sqrt(px^2 + py^2)"
ARM = "angle theta2 of position"
WHOLE = "py*(a1 + a2*c2) - px*a2*s2, px*(a1 + a2*c2) + py*a2*s2"
SWAPPED = "the arguments of {} in {} have changed places: the sine comes first"
ADDED = "an angle is added in {} that has to be subtracted, or the other way round"


@pytest.mark.parametrize(
    ("robot", "ask", "answer", "words"),
    [
        ("planar-2r", ELBOW, f"{D}; atan2(D, ±sqrt(1 - D^2))", SWAPPED.format("atan2", "theta2")),
        ("planar-2r", ELBOW, f"{D}; atan2(±sqrt(1 + D^2), D)", "a sign under a square root is turned round in"),
        ("planar-2r", ELBOW, f"{D}; atan2(±sqrt(1 - D^2), -D)", "the sign in the law of cosines is wrong in theta2"),
        ("planar-2r", ELBOW, f"{D.replace('- a', '+ a')}; atan2(±sqrt(1 - D^2), D)", "the signs of a1^2 and a2^2 in"),
        ("planar-2r", SHOULDER, f"atan2({', '.join(WHOLE.split(', ')[::-1])})", SWAPPED.format("atan2", "theta1")),
        ("planar-2r", SHOULDER, f"atan2({WHOLE.replace('+ py', '- py')})", "the sign of a2*py*s2 in"),
        (
            "articulated",
            ARM,
            f"atan2({ROOT}, pz - d1) - atan2(a3*s3, a2 + a3*c3)",
            SWAPPED.format("the first atan2", "theta2"),
        ),
        (
            "articulated",
            ARM,
            f"atan2(pz - d1, {ROOT}) - atan2(a2 + a3*c3, a3*s3)",
            SWAPPED.format("the second atan2", "theta2"),
        ),
        ("articulated", ARM, f"atan2(pz - d1, {ROOT}) + atan2(a3*s3, a2 + a3*c3)", ADDED.format("theta2")),
        ("planar-2r", SHOULDER, "atan2(py, px) - atan2(a2*s2, a1 + a2*c2) + 90°", "theta1 is off by 90°"),
        ("planar-2r", ELBOW, f"pi/2 ± acos({COSINE})", "theta2 is off by 90°"),
        ("cylindrical", "angle theta1 of position", "atan2(py, px)", "theta1 is off by -90°"),
        ("articulated", ARM, f"atan2(pz + d1, {ROOT}) - atan2(a3*s3, a2 + a3*c3)", "the sign of d1 in"),
        (
            "spherical-wrist",
            "angle theta5 of orientation",
            "atan2(r33, ±sqrt(r13^2 + r23^2))",
            SWAPPED.format("atan2", "theta5"),
        ),
    ],
)
def test_a_slip_in_a_form_of_ones_own_has_a_name(robot: str, ask: str, answer: str, words: str) -> None:
    """The formula is right once it is taken back, whatever form it has."""
    found = judged(answer, ask, robot).diagnosis
    assert found is not None
    assert len(found.names) == 1
    assert found.names[0].startswith(words)
    assert not set(found.hints[0]) & set("^*/()")


FORMS = [
    ("planar-2r", ELBOW, f"{D}; atan2(±sqrt(1 - D^2), D)"),
    ("planar-2r", ELBOW, f"{D}; ±(pi/2 - asin(D))"),
    ("planar-2r", SHOULDER, f"atan2({WHOLE})"),
    ("articulated", ARM, f"atan2(pz - d1, {ROOT}) - atan2(a3*s3, a2 + a3*c3)"),
]


@row_by_row(("robot", "ask", "answer"), FORMS)
def test_whoever_made_a_slip_in_any_form_is_told_one(robot: str, ask: str, answer: str) -> None:
    """Each slip that can be taken back, made in a right formula: it is right still, or has a name."""
    judge = judge_of(ask, robot, "m")
    part, name = judge.exercise.parts[0], ask.split()[1]
    case, question = Case(part, judge.memo), part.question
    right = question.read(case, answer)
    assert question.mark(case, Reading(answer, right)).verdict is Verdict.RIGHT
    for _, wrong in mended(right, name, THETAS):
        reading = Reading(answer, wrong)
        if question.mark(case, reading).verdict is not Verdict.RIGHT:
            assert question.causes(case, reading), wrong.values


@pytest.mark.parametrize("answer", ["±acos(px/a1)", f"±acos(({COSINE})^3)", "±acos((px + py - a1 - a2)/(2*a1*a2))"])
def test_a_formula_with_more_than_one_slip_has_no_name(answer: str) -> None:
    """Nothing is called what it is not."""
    assert judged(answer).diagnosis is None


@pytest.mark.parametrize("unit", ["m", "mm"])
def test_numbers_for_letters_do_not_hide_a_slip_in_a_formula(unit: str) -> None:
    """The lengths that the task gives may stand for their letters."""
    a1, a2 = ("0.3", "0.2") if unit == "m" else ("300", "200")
    found = judged(f"±acos((px + py^2 - {a1}^2 - {a2}^2)/(2*{a1}*{a2}))", robot=IN_NUMBERS, unit=unit).diagnosis
    assert found is not None
    assert found.ids == ("square-missing theta2 px for px^2",)


@pytest.mark.parametrize(
    ("robot", "ask", "answer", "earned", "said"),
    [
        (
            "planar-2r",
            "angle theta2 of position",
            f"acos({COSINE})",
            0.5,
            "right where theta2 > 0 only: acos gives one",
        ),
        ("planar-2r", "angle theta1 of position", "atan(py/px) - atan2(a2*s2, a1 + a2*c2)", 0, "right where px > 0"),
        ("planar-2r", "angle theta1 of position", "atan2(py, px) - asin(a2*s2/sqrt(px^2+py^2))", 0, "a1 + a2*c2 > 0"),
        ("planar-2r", "angle theta2 of position", f"±acos({COSINE}), pi/2", 0.5, "some of its values solve nothing"),
        ("planar-2r", "angle theta2 of position", f"acos(2 + ({COSINE})^2)", 0, "no real value"),
        ("spherical-wrist", "angle theta5 of orientation", "acos(r33)", 0.5, "theta5 > 0"),
    ],
)
def test_part_of_a_formula_is_told_from_too_much(robot: str, ask: str, answer: str, earned: float, said: str) -> None:
    """Where it is right is said by the sign that tells it."""
    mark = judged(answer, ask, robot)
    assert mark.verdict is Verdict.WRONG
    assert mark.earned == earned
    assert any(said in remark for remark in mark.remarks), mark.remarks


@pytest.mark.parametrize(
    ("answer", "name"),
    [
        (f"±acos(-{COSINE})", "cosine-sign theta2"),
        ("±acos((a1^2 + a2^2 - px^2 - py^2)/(2*a1*a2))", "cosine-sign theta2"),
        (f"atan2(sqrt(1 - ({COSINE})^2), {COSINE})", "one-branch theta2"),
    ],
)
def test_a_slip_has_its_name_in_whatever_form(answer: str, name: str) -> None:
    """Two formulas are one if their values are."""
    mark = judged(answer)
    assert mark.diagnosis is not None
    assert name in mark.diagnosis.ids


@pytest.mark.parametrize(
    ("exercise", "part", "answer", "name"),
    [
        ("planar", "shoulder", "atan2(px, py) - atan2(a2*s2, a1 + a2*c2)", "atan2-swapped theta1"),
        ("planar", "shoulder", "atan2(py, px) - atan2(a1 + a2*c2, a2*s2)", "atan2-swapped theta1 2"),
        ("planar", "shoulder", "atan2(-py, px) - atan2(a2*s2, a1 + a2*c2)", "atan2-sign-of-sine theta1"),
        ("planar", "shoulder", "atan2(py, -px) - atan2(a2*s2, a1 + a2*c2)", "atan2-sign-of-cosine theta1"),
        ("planar", "shoulder", "atan2(py, px) - atan2(a2*s2, -a1 - a2*c2)", "atan2-sign-of-cosine theta1 2"),
        ("planar", "shoulder", "atan2(py, px) - atan2(-a2*s2, a1 + a2*c2)", "angle-sign theta1"),
        ("articulated", "theta1", "atan2(-py, px), atan2(py, -px)", "atan2-sign theta1"),
        ("wrist", "theta4", "atan2(-r23, r13), or 180° more", "atan2-sign theta4"),
    ],
)
def test_signs_and_order_in_each_arctangent_have_a_name(exercise: str, part: str, answer: str, name: str) -> None:
    """One name, also where a formula holds two of them."""
    kind = "angles" if exercise == "wrist" else "joints"
    mark = check(load_exercise(f"inverse/{exercise}-{kind}"), part, answer)
    assert mark.diagnosis is not None
    assert mark.diagnosis.ids == (name,)


@pytest.mark.parametrize(
    ("answer", "said"),
    [
        ("theta2", "theta2 itself stands in it"),
        ("180 - theta1", "write 180° for degrees"),
        ("±1 ±1 ±1 ±1 ±1", "5 signs"),
        ("D = 3", "no line says what theta2 is"),
        ("theta1 = 3°", "no line says what theta2 is"),
        ("b7 + 1", "b7"),
        ("acos(", ""),
    ],
)
def test_what_is_no_formula_says_what_would_be(answer: str, said: str) -> None:
    """Never a wrong answer for a form."""
    mark = judged(answer)
    assert mark.verdict is Verdict.CANNOT_READ, mark
    assert any(said in remark for remark in mark.remarks), mark.remarks


def test_only_a_joint_with_a_textbook_form_is_asked_for() -> None:
    """Another name is refused, and so is a robot for which the rules find nothing."""
    with pytest.raises(NotationError):
        judged("1", "angle beta of position")
    with pytest.raises(NotationError):
        judged("1", "angle theta2 of speed")
    with pytest.raises(DhcliError):
        judged("1", "angle theta2 of pose", "puma200")


@pytest.mark.parametrize("answer", ["atan2(px, py)", "atan2(px, py), atan2(px, py) + pi"])
def test_swapped_arguments_are_named_with_one_value_of_two_as_with_both(answer: str) -> None:
    """Who swaps them seldom thinks of the second angle as well."""
    mark = judged(answer, "angle theta1 of position", "articulated")
    assert mark.verdict is Verdict.WRONG
    assert mark.diagnosis is not None
    assert "atan2-swapped theta1" in mark.diagnosis.ids


@pytest.mark.parametrize(
    ("unit", "right", "other"),
    [
        ("mm", "±acos((px^2 + py^2 - 130000)/120000)", "±acos((px^2 + py^2 - 0.13)/0.12)"),
        ("cm", "±acos((px^2 + py^2 - 1300)/1200)", "±acos((px^2 + py^2 - 130000)/120000)"),
        ("m", "±acos((px^2 + py^2 - 0.13)/0.12)", "±acos((px^2 + py^2 - 130000)/120000)"),
        ("mm", "D = px^2/120000 + py^2/120000 - 13/12; theta2 = atan2(±sqrt(1 - D^2), D)", ""),
        ("mm", "±acos((px^2 + py^2 - (300 mm)^2 - (0.2 m)^2)/(120000))", ""),
        ("mm", "atan2(py - 300*s1, px - 300*c1) - theta1", "atan2(py - 0.3*s1, px - 0.3*c1) - theta1"),
    ],
)
def test_bare_lengths_in_a_formula_are_in_the_unit_of_the_sheet(unit: str, right: str, other: str) -> None:
    """An area in its square, a ratio in none; what is right in another unit is told so, and costs no try."""
    assert judged(right, robot=IN_NUMBERS, unit=unit).verdict is Verdict.RIGHT
    if other:
        mark = judged(other, robot=IN_NUMBERS, unit=unit)
        assert mark.verdict is Verdict.CANNOT_READ
        assert f"this sheet is in {unit}" in mark.remarks[0]


@pytest.mark.parametrize("unit", ["m", "mm", "cm"])
@pytest.mark.parametrize(
    ("robot", "ask"),
    [
        (IN_NUMBERS, "angle theta1 of position"),
        (IN_NUMBERS, "angle theta2 of position"),
        (SLIDING, "joint d2 of position"),
    ],
)
def test_the_formula_shown_is_right_on_its_own_sheet(unit: str, robot: Robot, ask: str) -> None:
    """Its numbers are in that unit, too, and the question says so where it is not metres."""
    exercise = replace(question_about(robot, ask, numeric=False, given={}), unit=unit)
    judge, part = Judge(exercise), exercise.parts[0]
    assert judge.check(part, judge.expected(part)).verdict is Verdict.RIGHT
    said = "Numbers that stand for lengths are in"
    assert any(said in note for note in part.question.notes(exercise)) is (unit != "m")


@pytest.mark.parametrize(
    ("answer", "said"),
    [
        ("3 mm", "by its units this is no angle, and theta2 is an angle"),
        ("px*(2 mm)^2 + 1 mm", "by its units this is no angle"),
        ("30° + 3 m", "a number and a length cannot be added"),
    ],
)
def test_a_length_for_an_angle_costs_no_try(answer: str, said: str) -> None:
    """Its units show it."""
    mark = judged(answer)
    assert mark.verdict is Verdict.CANNOT_READ
    assert said in mark.remarks[0]


def test_an_angle_for_a_length_costs_no_try() -> None:
    """An inverse function gives no length."""
    mark = judged("atan2(py, px)", "joint d3 of pose", "stanford")
    assert mark.verdict is Verdict.CANNOT_READ
    assert mark.remarks == ("this is an angle, and d3 is a length",)
