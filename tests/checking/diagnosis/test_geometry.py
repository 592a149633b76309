"""What is said of a wrong matrix that no known mistake explains."""

from __future__ import annotations

import itertools
import math
import re
from dataclasses import replace

import pytest

from dhcli import check, load_robot
from dhcli.checking.exercise import Exercise, Part
from dhcli.checking.kinds.made import question_about
from dhcli.checking.kinds.matrix import MatrixQuestion
from dhcli.checking.verdicts import Verdict
from dhcli.checking.wanted import View
from dhcli.kinematics.values import joint_values
from tests.judging import expected
from tests.nightly import in_turn


def about(name: str, start: str, end: str, q: str = "") -> Exercise:
    """The pose of a frame of a robot; in numbers where joint values are given."""
    robot = load_robot(name)
    return question_about(robot, f"pose {start}..{end}", numeric=bool(q), given=joint_values(robot, q) if q else {})


def said(exercise: Exercise, answer: str) -> tuple[str, ...]:
    """The remarks on a wrong answer without a known cause."""
    mark = check(exercise, "pose", answer)
    assert mark.verdict is Verdict.WRONG
    assert mark.diagnosis is None
    return mark.remarks


@pytest.mark.parametrize(
    ("answer", "words"),
    [
        (
            "[c12 -s12 0 a1*c1+3*a2*c12; s12 c12 0 a1*s1+3*a2*s12; 0 0 1 0; 0 0 0 1]",
            "the rotation is right; the position is off by 2*a2 along x2",
        ),
        (
            "[c12 -s12 0 3*a1*c1+a2*c12; s12 c12 0 3*a1*s1+a2*s12; 0 0 1 0; 0 0 0 1]",
            "the rotation is right; the position is off by 2*a1 along x1",
        ),
        (
            "[c12 -s12 0 a1*c1+a2*c12; s12 c12 0 a1*s1+a2*s12; 0 0 1 0.25; 0 0 0 1]",
            "the rotation is right; the position is off by 0.25 m along z0",
        ),
        (
            "[-s12 -c12 0 a1*c1+a2*c12; c12 -s12 0 a1*s1+a2*s12; 0 0 1 0; 0 0 0 1]",
            "the rotation is off by 90° about z0; the position is right",
        ),
        (
            "[c12 0 s12 a1*c1+a2*c12; s12 0 -c12 a1*s1+a2*s12; 0 1 0 0; 0 0 0 1]",
            "the rotation is off by 90° about x2; the position is right",
        ),
        (
            "[s12 c12 0 a1*c1+a2*c12; -c12 s12 0 a1*s1+a2*s12; 0 0 1 a2; 0 0 0 1]",
            "the rotation is off by -90° about z0; the position is off by a2 along z0",
        ),
        (
            "[c(θ1+3θ2) -s(θ1+3θ2) 0 a1*c1+a2*c12; s(θ1+3θ2) c(θ1+3θ2) 0 a1*s1+a2*s12; 0 0 1 0; 0 0 0 1]",
            "the rotation is off by 2*theta2 about z0; the position is right",
        ),
        (
            "[c12 -s12 0 a1*c1+a2*c12; s12 c1*c12 0 a1*s1+a2*s12; 0 0 1 0; 0 0 0 1]",
            "this is no rotation: column 2 has not length 1",
        ),
    ],
)
def test_an_answer_in_expressions_is_turned_and_shifted_in_words(answer: str, words: str) -> None:
    """By a constant or by a joint's own angle; along the axes of whichever frame says it most plainly."""
    assert said(about("planar-2r", "0", "2"), answer)[0] == words


def test_what_is_no_single_turn_or_shift_is_not_guessed_at() -> None:
    """Only which half is right is known then."""
    remarks = said(about("planar-2r", "0", "2"), "[c12 -s12 0 a1*c2*c2; s12 c12 0 a2*s1*s1; 0 0 1 0; 0 0 0 1]")
    assert remarks == ("the rotation is right; the position is not",)


def test_a_sum_of_shifts_along_two_axes_of_one_frame_is_told() -> None:
    """Each along its own axis."""
    answer = "[c12 -s12 0 a1*c1+a2*c12+a1; s12 c12 0 a1*s1+a2*s12; 0 0 1 a2; 0 0 0 1]"
    words = "the rotation is right; the position is off by a1 along x0, a2 along z0"
    assert said(about("planar-2r", "0", "2"), answer)[0] == words


@pytest.mark.parametrize("piece", ["rotation", "position"])
def test_a_piece_of_a_matrix_is_told_alone(piece: str) -> None:
    """There is no other half to speak of."""
    question = MatrixQuestion(View("0", "2"), piece=piece)
    exercise = replace(about("planar-2r", "0", "2"), parts=(Part("pose", question),))
    answers = {
        "rotation": ("[c12 0 s12; s12 0 -c12; 0 1 0]", "the rotation is off by 90° about x2"),
        "position": ("[a1*c1+3*a2*c12, a1*s1+3*a2*s12, 0]", "the position is off by 2*a2 along x2"),
    }
    answer, words = answers[piece]
    assert said(exercise, answer)[0] == words


def test_a_shift_in_numbers_has_the_name_of_the_length() -> None:
    """Twice the last link where it stands once: not only by how much the position is off, but what that is."""
    exercise = about("planar-2r", "0", "2", "30°, 40°")
    a1, a2 = (float(exercise.values[name].value) for name in ("a1", "a2"))
    c, s = math.cos(math.radians(70)), math.sin(math.radians(70))
    x = a1 * math.cos(math.radians(30)) + 2 * a2 * c
    y = a1 * math.sin(math.radians(30)) + 2 * a2 * s
    answer = f"[{c:.6f} {-s:.6f} 0 {x:.6f}; {s:.6f} {c:.6f} 0 {y:.6f}; 0 0 1 0; 0 0 0 1]"
    words = f"the rotation is right; the position is off by {a2:g} m (as much as a2) along x2"
    assert said(exercise, answer)[0] == words


def test_a_shift_in_few_digits_has_no_name_that_it_has_not() -> None:
    """One decimal fits many lengths; the one that is told is as long as the number beside it."""
    question = MatrixQuestion(View("0", "2"), piece="position")
    exercise = replace(about("planar-2r", "0", "2", "30°, 40°"), parts=(Part("pose", question),))
    values = {name: float(exercise.values[name].value) for name in ("a1", "a2")}
    told = 0
    for x, y in in_turn([*itertools.product(range(-7, 8, 2), repeat=2)], 2, 5):  # with (0.1, 0.3), where one is told
        for words in said(exercise, f"{x / 10} {y / 10} 0"):
            if found := re.search(r"off by (\S+) m \(as much as (-?)(2?)\*?(a\d)\)", words):
                times = (-1 if found[2] else 1) * int(found[3] or 1)
                assert float(found[1]) == pytest.approx(times * values[found[4]], rel=0.02)
                told += 1
    assert told


def test_of_a_whole_arm_the_frame_in_between_is_found() -> None:
    """PUMA 560 with d3 gone along z3 twice too often."""
    exercise = about("puma560", "0", "6")
    rows = [row.split(", ") for row in expected(exercise, exercise.parts[0])[2:-2].split("], [")]
    rows[0][3] += " - 3*d3*s1 + d4"
    rows[1][3] += " + 3*d3*c1"
    answer = "[" + ", ".join("[" + ", ".join(row) + "]" for row in rows) + "]"
    assert said(exercise, answer)[0] == "the rotation is right; the position is not"
    rows[0][3] = rows[0][3].replace(" - 3*d3*s1 + d4", " - 2*d3*s1")
    rows[1][3] = rows[1][3].replace(" + 3*d3*c1", " + 2*d3*c1")
    answer = "[" + ", ".join("[" + ", ".join(row) + "]" for row in rows) + "]"
    assert said(exercise, answer)[0] == "the rotation is right; the position is off by 2*d3 along z2"
