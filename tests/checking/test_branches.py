"""Answers that are right on one branch only are wrong, and the verdict says where they hold."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from dhcli import load_exercise
from dhcli.checking.judge import Judge
from dhcli.checking.verdicts import Verdict
from tests.checking.mutated_kinds import FILES, exercise_of
from tests.cli.running import run
from tests.judging import mark
from tests.row_by_row import row_by_row


@row_by_row(
    ("ask", "answer", "where"),
    [
        ("entry 2 4 of link 1", "a1*sqrt(1 - c1^2)", "right only where sin(theta1) >= 0; a square root loses the sign"),
        ("entry 2 4 of link 1", "-a1*sqrt(1 - c1^2)", "right only where sin(theta1) <= 0"),
        ("entry 2 4 of link 1", "a1*sin(acos(c1))", "right only where sin(theta1) >= 0; acos gives angles from 0°"),
        ("entry 1 4 of link 1", "a1*cos(atan(s1/c1))", "right only where cos(theta1) >= 0; atan does not tell"),
        ("entry 1 4 of link 1", "a1*cos(asin(s1))", "right only where cos(theta1) >= 0; asin gives angles from -90°"),
        ("entry 1 2 of pose 0..2", "-sqrt(1 - c12^2)", "right only where sin(theta1+theta2) >= 0"),
        ("scalar theta1", "acos(c1)", "right only where sin(theta1) >= 0"),
        ("scalar theta1", "asin(s1)", "right only where cos(theta1) >= 0"),
        ("scalar theta1 + 90°", "acos(c1) + 90°", "right only where sin(theta1) >= 0"),
    ],
)
def test_one_branch_is_not_enough(ask: str, answer: str, where: str) -> None:
    """A root, or an arc function other than atan2, where both signs occur; with a point at which it is wrong."""
    exercise, part = exercise_of(ask)
    judged = mark(exercise, part, answer)
    assert judged.verdict is Verdict.WRONG
    assert judged.cells[0].note.startswith(where)
    assert "yours gives" in judged.cells[0].note
    assert judged.earned == 0


@pytest.mark.parametrize("words", [(), ("--format", "json")], ids=["table", "json"])
def test_where_it_holds_is_said_in_every_format(tmp_path: Path, words: tuple[str, ...]) -> None:
    """To people and to programs."""
    path = tmp_path / "x.yaml"
    path.write_text(FILES[id(exercise_of("entry 2 4 of link 1")[0])], "utf-8")
    done = run("check", str(path), "--part", "a", "--answer", "a1*sqrt(1 - c1^2)", *words)
    assert done.code == 1
    assert "right only where sin(theta1) >= 0; a square root loses the sign" in done.out


@pytest.mark.parametrize(
    ("answer", "where"),
    [
        ("atan(py/px)", "right only where px >= 0; atan does not tell opposite directions apart"),
        ("acos(px/sqrt(px^2 + py^2))", "right only where py >= 0; acos gives angles from 0° to 180° only"),
        ("asin(py/sqrt(px^2 + py^2))", "right only where px >= 0"),
        ("atan2(-py, -px)", ""),
    ],
)
def test_coordinates_have_both_signs(answer: str, where: str) -> None:
    """A point may stand on any side; what is off by half a turn everywhere is right nowhere."""
    exercise, part = exercise_of("scalar atan2(py, px)", robot=None, names=["px", "py"])
    judged = mark(exercise, part, answer)
    assert judged.verdict is Verdict.WRONG
    assert judged.cells[0].note.startswith(where or "at px")


@pytest.mark.parametrize(
    ("ask", "answer"),
    [
        ("entry 2 4 of link 1", "sqrt(a1^2)*s1"),
        ("entry 2 4 of link 1", "a1*sin(atan2(s1, c1))"),
        ("entry 2 4 of link 1", "a1*s1/sqrt(c1^2 + s1^2)"),
        ("scalar theta1", "atan2(s1, c1)"),
        ("scalar theta1", "atan2(a1*s1, a1*c1) - 360°"),
        ("scalar theta1", "2*atan(s1/(1 + c1))"),
    ],
)
def test_what_holds_everywhere_is_right(ask: str, answer: str) -> None:
    """Lengths are positive, a sum of squares keeps no sign, atan2 tells all directions, full turns do not matter."""
    exercise, part = exercise_of(ask)
    assert mark(exercise, part, answer).verdict is Verdict.RIGHT


@pytest.mark.parametrize(
    ("robot", "answer", "verdict"),
    [
        ("ur5e", "sqrt(a2^2)", Verdict.WRONG),
        ("ur5e", "-sqrt(a2^2)", Verdict.RIGHT),
        ("planar-2r", "sqrt(a2^2)", Verdict.RIGHT),
    ],
)
def test_a_length_has_the_sign_that_the_robot_gives_it(robot: str, answer: str, verdict: Verdict) -> None:
    """UR robots have negative a."""
    exercise, part = exercise_of("scalar a2", robot=robot)
    assert mark(exercise, part, answer).verdict is verdict


def test_limits_that_are_stated_count() -> None:
    """Theta 3 of the Panda's elbow is never positive, so that its sine has one sign; its cosine has both."""
    exercise, part = exercise_of("scalar sin(theta4)", robot="panda")
    low, high = exercise.robot.limits["theta4"] if exercise.robot else (None, None)
    assert low is not None
    assert high is not None
    assert mark(exercise, part, "-sqrt(1 - cos(theta4)^2)").verdict is Verdict.RIGHT
    assert mark(exercise, part, "sqrt(1 - cos(theta4)^2)").verdict is Verdict.WRONG
    exercise, part = exercise_of("scalar cos(theta4)", robot="panda")
    assert mark(exercise, part, "sqrt(1 - sin(theta4)^2)").verdict is Verdict.WRONG


def test_ranges_that_are_stated_count() -> None:
    """An angle drawn between 20° and 70° has a positive sine and cosine."""
    exercise, part = exercise_of("scalar sin(beta)", robot=None, names=["beta"])
    assert mark(exercise, part, "sqrt(1 - cos(beta)^2)").verdict is Verdict.WRONG
    exercise, part = exercise_of(
        "scalar sin(beta)", robot=None, given={"beta": "30°"}, variants={"beta": "20°..70° step 5°"}
    )
    assert mark(exercise, part, "sqrt(1 - cos(beta)^2)").verdict is Verdict.RIGHT


@pytest.mark.parametrize(
    ("exercise", "part", "answer"),
    [
        ("yim/planar-linkages", "grow", "3*n"),
        ("yim/counting-freedoms", "gruebler", "lambda*(n - j) + j*f"),
    ],
)
def test_numbers_of_things_are_tried_at_whole_numbers(exercise: str, part: str, answer: str) -> None:
    """Nobody builds 0.6 links."""
    judge = Judge(load_exercise(exercise))
    asked = judge.exercise.part(part)
    note = judge.check(asked, answer).cells[0].note
    values = re.findall(r"\w+ = (-?[\d.]+)", note)
    assert values, note
    assert all(value.isdecimal() and int(value) >= 3 for value in values), note
