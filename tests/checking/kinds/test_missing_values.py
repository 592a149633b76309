"""Exercises in numbers whose values do not suffice: they do not load, and those that load can be judged."""

from __future__ import annotations

from contextlib import suppress
from functools import partial

import pytest

from dhcli.checking.exercise import Exercise, Part
from dhcli.checking.judge import Judge
from dhcli.checking.kinds.made import question_about
from dhcli.checking.kinds.registry import examples, read_question
from dhcli.errors import DhcliError, FileError, RobotError
from dhcli.files.yaml.exercises import read_exercise
from dhcli.files.yaml.robots import load_robot
from tests.nightly import in_turn, some

ARM = load_robot("zhou-3r")
VALUES = {"theta1": "25°", "theta2": "40°", "theta3": "-70°", "f_x": "3 m", "f_y": "1 m", "v_x": "2 m", "v_y": "1 m"}
OWN = ["f_x", "f_y", "v_x", "v_y", "dtheta1", "dtheta2", "dtheta3"]


def text(ask: str, given: dict[str, str]) -> str:
    """An exercise that asks one thing in numbers."""
    values = ", ".join(f"{name}: {value}" for name, value in given.items())
    return (
        f"format: 1\ntitle: T\nsource: S\ntask: T\nrobot: zhou-3r\nnumeric: true\nnames: [{', '.join(OWN)}]\n"
        f"given: {{{values}}}\nparts:\n  - {{id: p, ask: '{ask}'}}\n"
    )


def read(ask: str, given: dict[str, str]) -> Exercise | list[str]:
    """The exercise, or the names that it lacks."""
    try:
        return read_exercise(text(ask, given), "my.yaml", "my")
    except FileError as error:
        (problem,) = error.problems
        assert problem.place is not None
        assert str(problem.place) == "my.yaml:8:1"
        start, names = problem.message.split("no value for ")
        assert start == "given: "
        return names.removesuffix(", and the answers are numbers").split(", ")


def is_asked_of_the_arm(ask: str) -> bool:
    """Whether the arm has what the question is about, and its file needs no other key."""
    with suppress(DhcliError):
        read_question(ask, ARM.scope).check(ARM)
        read_exercise(text(ask, {**VALUES, "dtheta1": "1", "dtheta2": "2", "dtheta3": "3"}), "my.yaml", "my")
        return True
    return False


ASKED = sorted({
    *filter(is_asked_of_the_arm, (one for one in examples() if "'" not in one)),
    "velocity of 0..3",
    "angular velocity of 0..2",
    "jacobian analytic zyz of 0..3",
    "determinant of jacobian linear of 0..2",
    "singular when linear of 0..2",
    "rank of jacobian linear of 0..2",
    "manipulability of jacobian linear of 0..2",
    "differential motion (0.002, 0, 0) of 0..3",
    "joint rates for (0.1, 0.2, 0) of 0..2",
    "torques for (f_x, f_y, 0) of 0..2",
    "joints 0..2 of position (0.5, 0.3, 0)",
})  # fmt: skip


def use(judge: Judge, turn: int) -> None:
    """All that is done with an exercise; a pose may be out of reach, but no name without a value is met."""
    (part,) = judge.exercise.parts
    checks = (partial(check, judge) for check in (check_own, check_one, check_three))
    doors = (judge.expected, *checks, judge.solution, judge.hidden, judge.slips, lambda _: judge.unclear())
    for door in in_turn(doors, turn, 4):
        try:
            door(part)
        except DhcliError as error:
            assert "no value" not in str(error)


def check_own(judge: Judge, part: Part) -> None:
    """The right answer is right."""
    answer = judge.expected(part)
    assert judge.check(part, answer).verdict.passed, answer


def check_one(judge: Judge, part: Part) -> None:
    """An answer that is wrong as a rule, whose slip is looked for."""
    judge.check(part, "1")


def check_three(judge: Judge, part: Part) -> None:
    """The same of three numbers."""
    judge.check(part, "[0.1, 0.2, 0.3]")


def test_many_kinds_are_asked_here() -> None:
    """So that the laws below say something."""
    assert len(ASKED) > 40
    assert {"rank", "manipulability", "torques", "velocity", "joints", "reach", "rpy", "pose", "differential"} <= {
        ask.split()[0] for ask in ASKED
    }


@pytest.mark.parametrize("ask", ASKED)
def test_an_exercise_loads_when_it_has_the_values_that_it_asked_for(ask: str) -> None:
    """And then nothing that is done with it stumbles over a name, however many of the others have no value."""
    found = read(ask, {})
    if isinstance(found, list):
        assert len(set(found)) == len(found)
        given = {name: VALUES.get(name, "0.7 m") for name in found}
        for left_out in some([*given], 3):
            less = {name: value for name, value in given.items() if name != left_out}
            assert read(ask, less) == [left_out]
        found = read(ask, given)
    assert isinstance(found, Exercise), found
    use(Judge(found), ASKED.index(ask))


@pytest.mark.parametrize("ask", ["rank of jacobian linear of 0..2", "torques for (0, 1, 0) of 0..2", "pose 0..2"])
def test_a_question_made_on_the_spot_is_not_judged_without_values(ask: str) -> None:
    """The error says which option gives them, whatever is asked of the judge."""
    judge = Judge(question_about(ARM, ask, numeric=True, given={}))
    (part,) = judge.exercise.parts
    for door in (judge.expected, judge.slips, judge.hidden, judge.solution):
        with pytest.raises(RobotError, match="has no value for theta1, theta2") as caught:
            door(part)
        assert caught.value.problems[0].hint.startswith("--set theta1=...")
    with pytest.raises(RobotError, match="has no value for theta1"):
        judge.check(part, "1")


def test_a_value_that_cannot_be_read_is_not_missed_once_more() -> None:
    """It is told where it stands."""
    with pytest.raises(FileError) as caught:
        read_exercise(text("pose 0..1", {"theta1": "25"}), "my.yaml", "my")
    (problem,) = caught.value.problems
    assert "the angle 25 has no unit" in problem.message
