"""Exercises of one part that are made on the spot, of a robot and the options of a command."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from dhcli.checking.exercise import Case, Exercise, Memo, Part
from dhcli.checking.kinds.registry import read_question
from dhcli.checking.kinds.table import TableQuestion
from dhcli.checking.pasted import UnreadableError
from dhcli.checking.tables.comparing import SAME_ROBOT
from dhcli.errors import NotationError
from dhcli.kinematics.conventions import Convention
from dhcli.kinematics.robot import Robot, Value
from dhcli.regex import regex

_SEPARATOR = regex(r"[\s,;]+")


def question_about(robot: Robot, ask: str, *, numeric: bool, given: Mapping[str, Value]) -> Exercise:
    """A question about a robot, asked as in an exercise file: `pose 0..3`, `rpy of pose 0..3`.

    Raises:
        NotationError: It asks nothing that is known.
        DhcliError: The robot does not have what is asked about.
    """
    question = read_question(ask, robot.scope)
    question.check(robot)
    part = Part(ask.split(maxsplit=1)[0], question)
    return Exercise(robot.name, robot.title, robot.source, "", (part,), robot, given, numeric=numeric)


def question_answered(exercises: Sequence[Exercise], answer: str) -> Exercise:
    """The first of some exercises of one part to which a text can be read as an answer; else the nearest in size."""
    for exercise in exercises:
        (part,) = exercise.parts
        try:
            part.question.read(Case(part, Memo(exercise)), answer)
        except (UnreadableError, NotationError):
            continue
        return exercise
    if not answer.strip():
        return exercises[0]
    typed = len(_SEPARATOR.split(answer.strip()))
    return min(exercises, key=lambda exercise: abs(math.prod(exercise.parts[0].question.blank(exercise)) - typed))


def question_about_table(robot: Robot, convention: Convention, compare: str = SAME_ROBOT, note: str = "") -> Exercise:
    """The DH table of a robot in one of the conventions.

    Args:
        robot: The robot.
        convention: The convention of the answer.
        compare: `literal`, `same-motion` or `same-robot`.
        note: What to tell beside the verdict.
    """
    part = Part("table", TableQuestion(convention, note), compare=compare)
    return Exercise(robot.name, robot.title, robot.source, "", (part,), robot)


def question_about_frames(
    robot: Robot, convention: Convention, pose: str = "", note: str = "", given: Mapping[str, Value] | None = None
) -> Exercise:
    """Frames on the axes of a robot, by the rules of one of the conventions.

    Args:
        robot: The robot.
        convention: The convention of the answer.
        pose: The named pose in which they are drawn; empty for the robot's own.
        note: What to tell beside the verdict.
        given: Values of lengths.

    Raises:
        UnknownNameError: The robot has no such pose.
    """
    from dhcli.checking.kinds.frames import FramesQuestion  # in a room that few commands need

    question = FramesQuestion(convention, pose, note)
    question.check(robot)
    return Exercise(robot.name, robot.title, robot.source, "", (Part("frames", question),), robot, given or {})
