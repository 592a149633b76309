"""Which values the names of an exercise have, so that an answer is tried where the robot can be, and all round."""

from __future__ import annotations

import re

from dhcli.algebra.points import CIRCLE, EITHER_SIDE, GENERAL, WHOLE, Reach
from dhcli.checking.exercise import Exercise
from dhcli.kinematics.derived import in_floats
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.values import symbols_of
from dhcli.regex import regex

_COORDINATE = regex(r"[pnoasdr]?_?[xyz]\d*(_.*)?|r_?\d\d|[xyz]_?\w{1,2}", re.IGNORECASE)
"""Names of coordinates and direction cosines, `px`, `y3`, `r11`, which have both signs; lengths are positive."""


def reach_of(exercise: Exercise) -> Reach:
    """The values that each name of an exercise can have [rad or m].

    Limits and ranges that are stated count. Else an angle goes all round the circle, a coordinate to either side, and
    a length or a displacement has the sign that the robot gives it, or is positive, as books draw it; what stands in
    an exercise that counts is a number of things.
    """
    robot, scope = exercise.robot, exercise.scope
    known = {name: _of_name(exercise, name) for name in {*scope.names, *exercise.names, *exercise.given}}
    if robot is not None:
        known |= {name: _of_joint(robot, name) for name in robot.variables}
    for name, drawn in exercise.variants.items():
        values = [in_floats(value) for value in drawn.values]
        known[name] = (min(values), max(values))
    return known


def _of_name(exercise: Exercise, name: str) -> tuple[float, float]:
    """What is not a joint: a number of things, an angle, a coordinate, or a length with its sign."""
    if exercise.robot is None and any("count" in part.question.words for part in exercise.parts):
        return WHOLE
    if exercise.scope.is_angle(name):
        return CIRCLE
    if exercise.robot is not None and name in exercise.robot.parameters:
        value = exercise.robot.parameters[name]
        return (-GENERAL[1], -GENERAL[0]) if value is not None and in_floats(value) < 0 else GENERAL
    return EITHER_SIDE if _COORDINATE.fullmatch(name) else GENERAL


def _of_joint(robot: Robot, name: str) -> tuple[float, float]:
    if name in robot.limits and not any(map(symbols_of, robot.limits[name])):
        low, high = (in_floats(limit) for limit in robot.limits[name])
        return low, high
    return CIRCLE if name in robot.angles else GENERAL
