"""Poses at which a mistake makes no difference: right angles, angles that agree, lengths that agree, singularities."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from itertools import combinations

from dhcli.checking.exercise import Exercise
from dhcli.errors import RobotError
from dhcli.geometry.linear import pivots
from dhcli.kinematics.axes import Arm
from dhcli.kinematics.moves import names
from dhcli.kinematics.robot import Robot, Value
from dhcli.kinematics.values import numbers
from dhcli.notation.angle import Angle, Rational
from dhcli.notation.tree import Number

RIGHT_ANGLE = 90
NEAR = 0.1
"""A pose is near a singularity if the weakest motion of its end is below this share of what it is elsewhere."""

GENERIC = (0.73, 1.91, 2.57)
"""Joint angles [rad], and displacements as shares of the size, from which poses to compare with are made."""


def flaw(exercise: Exercise, drawn: Mapping[str, Value] | None = None) -> str:
    """Why values drawn for the varied numbers of an exercise hide mistakes, in words; empty if they do not.

    Only what varies is looked at: what the author fixed is the author's choice. The geometry is computed without
    numpy, for a sheet is started far more often than this is thought about.
    """
    values, varied = {**exercise.values, **(drawn or {})}, exercise.variants.keys()
    found = _of_angles(values, varied) or _of_lengths(values, varied)
    if not found and exercise.robot is not None and _is_near_singular(exercise.robot, values):
        return "the arm is near a singularity"
    return found


def _of_angles(values: Mapping[str, Value], varied: Collection[str]) -> str:
    """An angle at a right angle or half of one, or two that differ by a multiple of a right angle or add up to it."""
    angles = {name: value for name, value in values.items() if isinstance(value, Angle)}
    for name in varied:
        if name in angles and _is_right(
            2 * angles[name].degrees, angles[name].radians
        ):  # at 45° sine and cosine are the same
            return f"{name} is a multiple of 45°"
    for one, other in combinations(angles, 2):
        if one in varied or other in varied:
            a, b = angles[one], angles[other]
            if _is_right(a.degrees - b.degrees, a.radians - b.radians):
                return f"{one} and {other} differ by a multiple of 90°"
            if _is_right(a.degrees + b.degrees, a.radians + b.radians):
                return f"{one} and {other} add up to a multiple of 90°"
    return ""


def _is_right(degrees: Rational, radians: Rational) -> bool:
    """Whether an angle is a multiple of a right one."""
    return not radians and degrees.denominator == 1 and not degrees.numerator % RIGHT_ANGLE


def _of_lengths(values: Mapping[str, Value], varied: Collection[str]) -> str:
    """A length that is 0, or two that are equal."""
    lengths = {name: value.value for name, value in values.items() if isinstance(value, Number)}
    for name in varied:
        if name not in lengths:
            continue
        if not lengths[name]:
            return f"{name} is 0"
        for other, value in lengths.items():
            if other != name and abs(value) == abs(lengths[name]):
                return f"{name} and {other} are equal"
    return ""


def _is_near_singular(robot: Robot, values: Mapping[str, Value]) -> bool:
    """Whether the end frame can hardly move in a direction in which it can elsewhere; False if a value is missing."""
    chain = tuple(move for link in robot.links for move in link.moves)
    if names(chain) - values.keys():
        return False
    try:
        arm = Arm.of(chain, robot.variables)
    except RobotError:  # joints that are coupled in one move
        return False
    known = numbers(values)
    point = {name: value for name, value in known.items() if name not in robot.variables}
    q = {name: _plain(known[name]) for name in arm.variables}
    lengths = [abs(value) for name, value in known.items() if isinstance(value, float) and name not in q]
    size = sum(lengths) or 1.0
    turning = robot.scope.joints
    others = [
        {name: (start + 1.3 * k) if name in turning else start * size for k, name in enumerate(arm.variables)}
        for start in GENERIC
    ]
    elsewhere = max((pivots(arm.columns(point, other, size)) for other in others), key=_rank_and_least)
    here = pivots(arm.columns(point, q, size))
    return bool(elsewhere) and (len(here) < len(elsewhere) or here[-1] < NEAR * elsewhere[-1])


def _rank_and_least(found: list[float]) -> tuple[int, float]:
    return len(found), min(found, default=0.0)


def _plain(value: Angle | float) -> float:
    return value.constant() if isinstance(value, Angle) else value
