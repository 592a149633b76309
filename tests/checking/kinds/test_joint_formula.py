"""Formulas for a joint: right if every value solves and none is missing, in whatever form."""

from __future__ import annotations

import pytest

from dhcli.checking.judge import Judge
from dhcli.checking.kinds.made import question_about
from dhcli.checking.verdicts import Mark, Verdict
from dhcli.errors import DhcliError, NotationError
from dhcli.files.yaml.robots import load_robot

COSINE = "(px^2 + py^2 - a1^2 - a2^2)/(2*a1*a2)"
PUMA_K = "K = (px^2 + py^2 + pz^2 - a2^2 - a3^2 - d3^2 - d4^2)/(2*a2)\n"


def judged(answer: str, ask: str = "angle theta2 of position", robot: str = "planar-2r") -> Mark:
    """An answer, explained where it is wrong."""
    exercise = question_about(load_robot(robot), ask, numeric=False, given={})
    return Judge(exercise).check(exercise.parts[0], answer)


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
        ("stanford", "joint d3 of pose", "±sqrt((px-d6*r13)^2 + (py-d6*r23)^2 + (pz-d6*r33)^2 - d2^2)"),
    ],
)
def test_every_form_of_a_right_formula_is_right(robot: str, ask: str, answer: str) -> None:
    """With names for its parts, as books have it, with the other joints or without."""
    mark = judged(answer, ask, robot)
    assert (mark.verdict, mark.earned) == (Verdict.RIGHT, 1), mark.remarks


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
