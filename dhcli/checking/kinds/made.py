"""Exercises of one part that are made on the spot, of a robot and the options of a command."""

from __future__ import annotations

from collections.abc import Mapping

from dhcli.checking.exercise import Exercise, Part
from dhcli.checking.kinds.matrix import MatrixQuestion
from dhcli.checking.kinds.table import TableQuestion
from dhcli.checking.wanted import Span
from dhcli.kinematics.conventions import Convention
from dhcli.kinematics.robot import Robot, Value


def question_about(robot: Robot, start: str, end: str, *, numeric: bool, given: Mapping[str, Value]) -> Exercise:
    """The pose of a frame of a robot."""
    part = Part("pose", MatrixQuestion(Span(start, end)))
    return Exercise(robot.name, robot.title, robot.source, "", (part,), robot, given, numeric=numeric)


def question_about_table(robot: Robot, convention: Convention) -> Exercise:
    """The DH table of a robot in one of the conventions."""
    part = Part("table", TableQuestion(convention))
    return Exercise(robot.name, robot.title, robot.source, "", (part,), robot)
