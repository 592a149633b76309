"""Screw axes and the home pose: `T = exp(S1 q1) ... exp(Sn qn) M`, or with body screws behind M.

Source: Lynch and Park, Modern Robotics, chapter 4.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Literal

from dhcli.errors import RobotError
from dhcli.frozen import frozen
from dhcli.geometry.vectors import ORIGIN, Vector, cross, dot, length, scaled
from dhcli.kinematics.describe.drawn import Drawing, Frame, Line
from dhcli.kinematics.describe.linear import Point, moved, shifted
from dhcli.notation.tree import ONE

_NO_PITCH = 1e-12
"""A part of v along ω that is rounding [m]."""

Side = Literal["space", "body"]


@frozen
class ScrewAxis:
    """The screw of one joint.

    Attributes:
        name: The joint variable.
        omega: Angular velocity for each unit of the variable; zero where it slides.
        v: Velocity of the point at the origin [m], or [1] where it slides.
    """

    name: str
    omega: Vector
    v: Point


def screws_of(drawing: Drawing, side: Side) -> tuple[ScrewAxis, ...]:
    """The screws of a robot drawn at zero, seen from its base, or from its end."""
    return tuple(_screw(line, drawing.end if side == "body" else Frame()) for line in drawing.lines)


def lines_of(screws: tuple[ScrewAxis, ...], home: Frame, side: Side) -> tuple[Line, ...]:
    """The lines of screws in the base, from their home pose and the frame that they are seen from.

    Raises:
        RobotError: A screw is zero.
    """
    return tuple(_line(screw, home if side == "body" else Frame()) for screw in screws)


def _screw(line: Line, seen_from: Frame) -> ScrewAxis:
    direction = _seen(scaled(line.direction, float(line.rate)), seen_from)
    if not line.turns:
        return ScrewAxis(line.name, ORIGIN, {ONE: direction})
    gap = moved(line.through or {}, seen_from.origin, -1)
    point = {letter: _seen(vector, seen_from) for letter, vector in gap.items()}
    v = {letter: cross(vector, direction) for letter, vector in point.items()}
    return ScrewAxis(line.name, direction, shifted(v, _seen(line.direction, seen_from), line.pitch))


def _line(screw: ScrewAxis, frame: Frame) -> Line:
    rate = length(screw.omega)
    if rate:
        axis = scaled(screw.omega, 1 / rate)
        pitch = {letter: slid for letter, vector in screw.v.items() if abs(slid := dot(axis, vector)) > _NO_PITCH}
        point = {letter: scaled(cross(axis, vector), 1 / rate) for letter, vector in screw.v.items()}
        through = moved(frame.origin, {letter: _back(vector, frame) for letter, vector in point.items()})
        return Line(screw.name, _back(axis, frame), through, turns=True, rate=_whole(rate), pitch=pitch)
    if set(screw.v) - {ONE}:
        raise RobotError(f"the direction in which {screw.name} slides depends on a letter")
    speed = length(screw.v.get(ONE, ORIGIN))
    if not speed:
        raise RobotError(f"the screw of {screw.name} is zero", "write six numbers, ω then v")
    axis = scaled(screw.v[ONE], 1 / speed)
    return Line(screw.name, _back(axis, frame), None, turns=False, rate=_whole(speed))


def _whole(rate: float) -> Fraction:
    """A rate as the fraction that it is."""
    near = Fraction(rate).limit_denominator(1000)
    return near if abs(float(near) - rate) < 1e-12 else Fraction(repr(rate))  # noqa: PLR2004


def _seen(vector: Vector, frame: Frame) -> Vector:
    return dot(frame.x, vector), dot(frame.y, vector), dot(frame.z, vector)


def _back(vector: Vector, frame: Frame) -> Vector:
    (a, b, c), (d, e, f), (g, h, i) = frame.x, frame.y, frame.z
    x, y, z = vector
    return a * x + d * y + g * z, b * x + e * y + h * z, c * x + f * y + i * z
