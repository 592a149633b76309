"""What an answer draws over the arm that is right."""

from __future__ import annotations

from dataclasses import replace

import pytest

from dhcli import load_robot
from dhcli.checking.exercise import Case, Exercise
from dhcli.checking.judge import Judge
from dhcli.checking.kinds.made import question_about
from dhcli.checking.returned import Overlaid
from dhcli.cli.shell.overlaid import values_of
from dhcli.files.library.entries import Kind, entries
from dhcli.files.yaml.exercises import load_exercise
from dhcli.kinematics.values import Values, joint_values
from dhcli.scene.beside import first_difference
from dhcli.scene.skeleton import Skeleton
from tests.nightly import in_turn


def _overlaid(exercise: Exercise, part: str, answer: str, values: Values) -> Overlaid:
    judge, one = Judge(exercise), exercise.part(part)
    reading = judge.judged(one, answer).reading
    assert reading is not None
    found = one.question.overlaid(Case(one, judge.memo), reading, values)
    assert found is not None
    return found


@pytest.mark.parametrize("name", in_turn([entry.name for entry in entries(Kind.EXERCISES)], 1, 3))
def test_the_right_answer_lies_on_the_right_frame(name: str) -> None:
    """Of every table, pose, rotation and position of the library, at each pose that may be drawn."""
    exercise = load_exercise(name)
    if exercise.robot is None:
        return
    judge = Judge(exercise)
    for part in exercise.asked:
        if not part.question.is_overlaid or part.printed:
            continue
        reading = judge.judged(part, judge.expected(part)).reading
        assert reading is not None
        for values in values_of(exercise.robot, exercise.given):
            over = part.question.overlaid(Case(part, judge.memo), reading, values)
            if over is None:
                continue
            skeleton = Skeleton.of(over.robot, over.values)
            if part.question.words == ("frames",):  # judged by rules, and the solution has the frames of the table
                names = tuple(name for name, _ in over.traced.frames)
                over = replace(over, traced=replace(over.traced, pairs=tuple(zip(names, names, strict=True))))
            assert over.traced.pairs
            assert first_difference(skeleton, over.traced) is None


def test_an_inverse_is_the_first_frame_seen_from_the_last() -> None:
    """Its frame is compared with the one that it describes."""
    robot = load_robot("planar-2r")
    q = joint_values(robot, [0.3, 0.5])
    exercise = question_about(robot, "inverse of pose 0..2", numeric=False, given={})
    values = {**next(iter(values_of(robot, {}))), **q}
    right = Judge(exercise).expected(exercise.parts[0])
    over = _overlaid(exercise, exercise.parts[0].id, right, values)
    assert over.traced.pairs == (("0", "0"),)
    assert first_difference(Skeleton.of(robot, values), over.traced) is None
    wrong = _overlaid(exercise, exercise.parts[0].id, "c12 s12 0 0; -s12 c12 0 0; 0 0 1 0; 0 0 0 1", values)
    assert first_difference(Skeleton.of(robot, values), wrong.traced) == "0"
