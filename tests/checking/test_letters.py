"""Numbers where letters were asked: a slip that has a name, if they are the robot's own."""

from __future__ import annotations

from dataclasses import replace

import pytest

from dhcli import check, load_exercise
from dhcli.checking.judge import Judge
from dhcli.checking.solving import covering
from dhcli.checking.verdicts import Verdict

ARM, JACOBIAN, FORMULAS = "yim/planar-two-links", "motion/planar-jacobian", "inverse/planar-joints"
PUMA = "wpi/puma560-entries-of-0t6"


@pytest.mark.parametrize(
    ("exercise", "part", "answer", "words"),
    [
        (ARM, "d02", "0.4*c1 + 0.3*c12, 0.4*s1 + 0.3*s12, 0", ": 0.4 m for a1"),
        (ARM, "d02", "400*c1 + 300*c12, 400*s1 + 300*s12, 0", ": 400 mm for a1"),
        (ARM, "d02", "a1*c1 + 0.3*c12, a1*s1 + 0.3*s12, 0", ": 0.3 m for a2"),
        (JACOBIAN, "column1", "-0.4 s1-0.3 s12; 0.4 c1+0.3 c12; 0", ": 0.4 m for a1"),
        (JACOBIAN, "determinant", "0.12*s2", ""),
        (FORMULAS, "elbow", "±acos((px^2 + py^2 - 0.25)/0.24)", ""),
        (PUMA, "px", "c1*(0.4318*c2 + 0.0203*c23 - 0.4318*s23) - 0.15005*s1", ": 0.4318 m for a2"),
    ],
)
def test_the_numbers_of_the_robot_for_its_letters_are_named(exercise: str, part: str, answer: str, words: str) -> None:
    """In every kind of formula, in the unit of the sheet or in another one."""
    judged = check(load_exercise(exercise), part, answer)
    assert judged.verdict is Verdict.WRONG
    assert judged.diagnosis is not None
    assert judged.diagnosis.names == (f"the robot's numbers stand for its letters{words}",)


@pytest.mark.parametrize(
    ("exercise", "part", "answer", "also"),
    [
        (FORMULAS, "elbow", "±acos((px^2 + py^2 + 0.25)/0.24)", "the sign of 0.25 in the formula for theta2"),
        (FORMULAS, "elbow", "±acos((0.25 - px^2 - py^2)/0.24)", "the sign in the law of cosines is wrong in theta2"),
        (ARM, "d02", "0.4*c1 - 0.3*c12, 0.4*s1 + 0.3*s12, 0", "the sign of a2*c12 in entry (1,1)"),
        (ARM, "d02", "0.4*c1 + 0.4*c12, 0.4*s1 + 0.3*s12, 0", "entry (1,1) has a1 for a2"),
        (JACOBIAN, "determinant", "0.12*c2", "the answer has c2 for s2"),
    ],
)
def test_a_slip_beside_numbers_for_letters_is_named_too(exercise: str, part: str, answer: str, also: str) -> None:
    """Both, where the answer is right without them."""
    judged = check(load_exercise(exercise), part, answer)
    assert judged.verdict is Verdict.WRONG
    assert judged.diagnosis is not None
    assert len(judged.diagnosis.names) == 1
    first, second = judged.diagnosis.names[0].split(" and ", 1)
    assert first.startswith("the robot's numbers stand for its letters")
    assert second.startswith(also)


@pytest.mark.parametrize("exercise", ["motion/articulated-jacobian", "wpi/puma560-links", "zhou/three-r-arm-tip"])
def test_l2_is_no_name_where_it_might_be_another_length(exercise: str) -> None:
    """Beside d1, l1 may be d1 or a2; where the lengths are a, b and c they have no numbers."""
    found = load_exercise(exercise)
    assert not [word for word in ("l1", "l2", "L2", "l3") if found.scope.has(word)]


def test_l1_is_a_question_beside_a1_and_in_a_task_with_a_length_of_its_own() -> None:
    """Whoever writes both means two lengths; whoever reads of an l in the task means that."""
    exercise = load_exercise(JACOBIAN)
    judged = check(exercise, "determinant", "a1*l2*s2 + 0*a2")
    assert judged.verdict is Verdict.CANNOT_READ
    assert "l2 stands beside a2" in judged.remarks[0]
    assert check(exercise, "determinant", "a1*l2*s2").verdict is Verdict.RIGHT
    for words in ("The arm is L = 0.7 m long.", "Let l_1 be the height.", "l1 is none of its lengths"):
        assert not replace(exercise, task=words).scope.has("l2")


@pytest.mark.parametrize(
    ("exercise", "part", "answer"),
    [
        (ARM, "d02", "0.5*c1 + 0.3*c12, 0.5*s1 + 0.3*s12, 0"),
        (PUMA, "px", "c1*(a2*c2 + a3*c23 - a2*s23) - d3*s1"),  # a2 for d4, which are equal in this arm
    ],
)
def test_other_numbers_and_letters_are_not(exercise: str, part: str, answer: str) -> None:
    """A letter in the answer stands for any length, however long two of them are in this robot."""
    judged = check(load_exercise(exercise), part, answer)
    assert judged.verdict is Verdict.WRONG
    assert judged.diagnosis is None or not any("numbers" in name for name in judged.diagnosis.names)


def test_an_arm_in_numbers_is_drawn_once_for_all_answers(monkeypatch: pytest.MonkeyPatch) -> None:
    """In each unit, whichever it is looked for from."""
    judge, drawn, points = Judge(load_exercise(FORMULAS)), list[object](), covering.points
    monkeypatch.setattr(covering, "points", lambda *given: drawn.append(given) or points(*given))  # type: ignore[func-returns-value]
    for wrong in ("acos((px^2 + py^2 - 0.25)/0.23)", "acos((px^2 + py^2 - 0.26)/0.24)"):
        judge.check(judge.exercise.part("elbow"), wrong)
    units = [judge.exercise.unit, *judge.exercise.other_units]
    assert len(drawn) == 2 * len(units)  # with the lengths in letters, and in numbers


@pytest.mark.parametrize(("behind", "is_told"), [(" m/s", True), (" m", False), ("", False)])
def test_a_speed_behind_a_whole_jacobian_is_read_and_told(behind: str, *, is_told: bool) -> None:
    """Its columns have the units of lengths or of numbers."""
    answer = f"[-0.4679 -0.2989; 0.3364 -0.0261; 0 0]{behind}"
    judged = check(load_exercise("motion/planar-rates-in-numbers"), "jacobian", answer)
    assert judged.verdict is Verdict.RIGHT
    assert any("m/s is no unit of a Jacobian" in remark for remark in judged.remarks) is is_told
