"""Drawn axes as a product of moves: every frame stands as the base does in the pose drawn, the last as the end."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from dhcli.geometry.euler import euler
from dhcli.geometry.vectors import UNITS, Vector, cross, length
from dhcli.kinematics.describe.drawn import Drawing, Frame, Line
from dhcli.kinematics.describe.exact import exact_angle, exact_factor
from dhcli.kinematics.describe.linear import Point, coordinates_of, length_of, moved
from dhcli.kinematics.moves import Chain, Rot, Trans, along, in_radians, inverse
from dhcli.notation.angle import Angle
from dhcli.notation.factors import AXES, Axis
from dhcli.notation.tree import PI, ZERO, Expr, Number, Symbol, multiply, negate

_STRAIGHT = 1e-12


def chains_of(drawing: Drawing) -> Iterator[Chain]:
    """The moves of each link: to the axis, about it or along it; behind the last one to the end."""
    here: Point = {}
    count = len(drawing.lines)
    for k, line in enumerate(drawing.lines):
        there = here if line.through is None else line.through
        chain = (*_shift(here, there), *_motion(line))
        here = there
        yield (*chain, *_shift(here, drawing.end.origin), *turned(drawing.end)) if k == count - 1 else chain
    if not count:
        yield (*_shift(here, drawing.end.origin), *turned(drawing.end))


def turned(frame: Frame) -> Chain:
    """The orientation of a frame as turns about z, y and x."""
    rows = tuple(zip(frame.x, frame.y, frame.z, strict=True))
    angles = euler("zyx").of(rows).angles
    exact = [exact_angle(float(angle)) for angle in angles]
    axes: tuple[Axis, ...] = ("z", "y", "x")
    return tuple(Rot(axis, angle) for axis, angle in zip(axes, exact, strict=True) if not angle.is_zero)


def end_of(frame: Frame) -> Chain:
    """The moves that lead to a frame."""
    return (*_shift({}, frame.origin), *turned(frame))


def _shift(start: Point, end: Point) -> Chain:
    x, y, z = coordinates_of(moved(end, start, -1))
    return () if x == y == z == ZERO else (Trans(x, y, z),)


def _motion(line: Line) -> Chain:
    """What the joint does: nothing in the pose drawn."""
    if line.turns:
        drawn = line.drawn if isinstance(line.drawn, Angle) else Angle()
        angle = (Angle.of(line.name) - drawn) * line.rate
        axis, sign, before = _towards(line.direction)
        slid = screwed(line, length_of(line.pitch))
        slide = (along(axis, multiply(Number(Fraction(sign)), slid)),) if line.pitch else ()
        return (*before, Rot(axis, angle * sign), *slide, *inverse(before))
    away = line.drawn if isinstance(line.drawn, Expr) else ZERO
    way = multiply(Number(line.rate), Symbol(line.name) - away)
    x, y, z = (multiply(exact_factor(part), way) if abs(part) > _STRAIGHT else ZERO for part in line.direction)
    return (Trans(x, y, z),)


def pitch_of(line: Line) -> Expr:
    """How far a screw goes in one turn of its variable."""
    return multiply(Number(Fraction(2)), PI, length_of(line.pitch))


def screwed(line: Line, pitch: Expr) -> Expr:
    """How far a screw has slid: nothing in the pose drawn."""
    drawn = in_radians(line.drawn) if isinstance(line.drawn, Angle) else ZERO
    return multiply(pitch, Symbol(line.name)) + negate(multiply(pitch, drawn))


def _towards(direction: Vector) -> tuple[Axis, int, Chain]:
    """A coordinate axis, its sense, and the turns that bring it onto a direction."""
    for name, unit in zip(AXES, UNITS, strict=True):
        if length(cross(unit, direction)) < _STRAIGHT:
            return name, 1 if direction[AXES.index(name)] > 0 else -1, ()
    x, y, z = direction
    from math import atan2, hypot

    turns = (Rot("z", exact_angle(atan2(y, x))), Rot("y", exact_angle(atan2(hypot(x, y), z))))
    return "z", 1, tuple(turn for turn in turns if not turn.angle.is_zero)
