"""A robot as it is drawn: the line of each joint, and the frame at its end, in one pose; and a robot's drawing."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import field, replace
from fractions import Fraction
from typing import TypeAlias

from dhcli.algebra.floats import Floats
from dhcli.errors import RobotError
from dhcli.frozen import frozen
from dhcli.geometry.vectors import ORIGIN, UNITS, Vector, cross, dot, length, plus, scaled
from dhcli.kinematics.axes import no_axis
from dhcli.kinematics.derived import Value
from dhcli.kinematics.describe.linear import Form, LettersError, Point, Ruler, along, form_of, moved, shifted
from dhcli.kinematics.moves import PLANES, Chain, Fixed, Move, Rot, Trans, angle_names, names, substituted
from dhcli.notation.angle import Angle, Rational, magnitude
from dhcli.notation.tree import ONE, ZERO, Expr, Number
from dhcli.notation.walk import substitute, symbols, symbols_in

Placed: TypeAlias = tuple[tuple[Vector, Vector, Vector], Point]
"""The three axes of a frame, and its origin."""


class SharedMovesError(RobotError):
    """A variable stands in two moves that are no screw, or a move has two; what `uncoupled` makes can be drawn."""


@frozen
class Line:
    """The axis of a joint, or the z axis of the base or of the end.

    Attributes:
        name: The joint variable; `base` or `end`.
        direction: Unit vector, in the sense in which the variable grows.
        through: A point of it; None for a sliding joint, of which only the direction matters.
        turns: Whether the joint turns.
        rate: Motion for each unit of the variable.
        drawn: Value of the variable in the pose drawn.
        pitch: Of a screw, how far it slides along its axis for each unit of the variable.
    """

    name: str
    direction: Vector
    through: Point | None
    turns: bool = True
    rate: Rational = 1
    drawn: Value = ZERO
    pitch: Form = field(default_factory=dict)

    def reversed(self) -> Line:
        """The same axis pointing the other way, against which the variable grows."""
        return replace(self, direction=scaled(self.direction, -1), rate=-self.rate)


@frozen
class Frame:
    """A frame: two of its axes and its origin."""

    x: Vector = UNITS[0]
    z: Vector = UNITS[2]
    origin: Point = field(default_factory=dict)

    @property
    def y(self) -> Vector:
        """The third axis, which makes it right-handed."""
        return cross(self.z, self.x)


@frozen
class Drawing:
    """A robot drawn.

    Attributes:
        lines: The axis of each joint, in order, in the base.
        end: The end frame in the same pose.
        values: Value of each letter that has one.
    """

    lines: tuple[Line, ...]
    end: Frame
    values: Mapping[str, Angle | float] = field(default_factory=dict)

    @property
    def ruler(self) -> Ruler:
        """What decides about lengths: the distance of the farthest point counts as 1."""
        points = [self.end.origin, *(line.through for line in self.lines if line.through)]
        plain = [length(point[ONE]) for point in points if ONE in point]
        return Ruler(self.values, max(plain, default=1.0) or 1.0)


def drawing_of(
    chain: Chain,
    variables: tuple[str, ...],
    values: Mapping[str, Angle | float],
    pose: Mapping[str, Value] | None = None,
) -> Drawing:
    """A chain drawn in one pose.

    Args:
        chain: From the base to the end.
        variables: The joint variables.
        values: Values of its other names, which decide about signs; the drawing keeps its letters.
        pose: Values of variables in the pose drawn; zero for those that are not named.

    Raises:
        LettersError: A direction depends on a letter.
        SharedMovesError: A variable stands in two moves that are no screw, or a move has two.
        RobotError: A variable stands in a matrix.
    """
    drawn = pose or {}
    turning = angle_names(chain)
    lengths: dict[str, Expr] = {name: ZERO for name in variables if name not in turning}
    lengths |= {name: value for name, value in drawn.items() if isinstance(value, Expr)}
    angles = {name: Angle() for name in variables if name in turning}
    angles |= {name: value for name, value in drawn.items() if isinstance(value, Angle)}
    lines: list[Line] = []
    slides: dict[str, Point] = {}
    here: Placed = (UNITS, {})
    for move in chain:
        held = names((move,))
        moving = [name for name in variables if name in held]
        known = [line.name for line in lines]
        if len(moving) > 1 or (slides and moving != list(slides)) or any(name in known[:-1] for name in moving):
            raise SharedMovesError(*no_axis(moving[-1]))
        for name in moving:
            if isinstance(move, Trans) and name in turning:
                slides[name] = _slide(name, move, here)
            elif name in known:
                raise SharedMovesError(*no_axis(name))
            else:
                lines.append(replace(_line(name, move, here), drawn=drawn.get(name, ZERO)))
            if slides and lines and lines[-1].name == name:
                lines[-1] = _screwed(lines[-1], slides.pop(name))
        (still,) = substituted((move,), lengths, angles)
        here = _after(here, still)
    if slides:
        raise SharedMovesError(*no_axis(next(iter(slides))))
    (x, _, z), origin = here
    return Drawing(tuple(lines), Frame(x, z, origin), values)


def _screwed(line: Line, slide: Point) -> Line:
    """A turn and a slide of the same variable as one screw.

    Raises:
        SharedMovesError: It slides across its axis, or twice.
    """
    pitch = along(slide, line.direction)
    across = moved(slide, {letter: scaled(line.direction, value) for letter, value in pitch.items()}, -1)
    if line.pitch or any(length(vector) > 1e-12 for vector in across.values()):  # noqa: PLR2004
        raise SharedMovesError(*no_axis(line.name))
    return replace(line, pitch=pitch)


def _after(here: Placed, move: Move) -> Placed:
    """Axes and origin of the frame behind a move without variables."""
    axes, origin = here
    if isinstance(move, Rot):
        if move.angle.names:
            raise LettersError(f"directions depend on {', '.join(sorted(move.angle.names))}", "give it a value")
        cos, sin = Floats().cos_sin(move.angle)
        i, j = PLANES[move.axis]
        turned = list(axes)
        turned[i] = plus(scaled(axes[i], cos), axes[j], sin)
        turned[j] = plus(scaled(axes[j], cos), axes[i], -sin)
        return (turned[0], turned[1], turned[2]), origin
    rows = move.rows if isinstance(move, Fixed) else None
    offset = tuple(row[3] for row in rows) if rows else move.offset  # type: ignore[union-attr]
    for axis, expr in zip(axes, offset, strict=True):
        origin = shifted(origin, axis, form_of(expr))
    if rows is None:
        return axes, origin
    found = []
    for k in range(3):
        entries = [row[k] for row in rows]
        if free := sorted(symbols_in(entries)):
            raise LettersError(f"directions depend on {', '.join(free)}", "give it a value")
        column = ORIGIN
        for axis, entry in zip(axes, entries, strict=True):
            column = plus(column, axis, Floats().value(entry))
        found.append(column)
    return (found[0], found[1], found[2]), origin


def _line(name: str, move: Move, here: Placed) -> Line:
    axes, origin = here
    if isinstance(move, Rot):
        rate = dict(move.angle.terms)[name]
        axis = axes["xyz".index(move.axis)]
        return Line(name, scaled(axis, math.copysign(1, rate)), origin, turns=True, rate=magnitude(rate))
    if name in angle_names((move,)):
        raise RobotError(f"{name} does not move one joint about or along one axis")
    slide = _slide(name, move, here)
    if free := [str(letter) for letter in slide if letter != ONE]:
        raise LettersError(f"how far {name} slides depends on {', '.join(free)}")
    total = slide.get(ONE, ORIGIN)
    rate = Fraction(length(total)).limit_denominator(10**6)
    if not rate or abs(float(rate) - length(total)) > 1e-12:  # noqa: PLR2004
        raise RobotError(f"{name} slides by {length(total):g} m for each metre of its own", "write it once in a row")
    return Line(name, scaled(total, 1 / length(total)), None, turns=False, rate=rate)


def _offset(move: Move) -> tuple[Expr, ...]:
    if isinstance(move, Fixed):
        turned = [entry for row in move.rows for entry in row[:3]]
        if any(symbols(entry) for entry in turned):
            raise LettersError("directions depend on the letters of a matrix")
        return tuple(row[3] for row in move.rows)
    return move.offset if isinstance(move, Trans) else ()


def _slide(name: str, move: Move, here: Placed) -> Point:
    """How far a move slides for each unit of a variable, in the base."""
    total: Point = {}
    for axis, expr in zip(here[0], _offset(move), strict=True):
        grown = form_of(substitute(expr, {name: Number(Fraction(1))}, {}) - substitute(expr, {name: ZERO}, {}))
        total = shifted(total, axis, {letter: value for letter, value in grown.items() if value})
    return total


def same_direction(u: Vector, v: Vector, close: float = 1e-12) -> int:
    """1 where two unit vectors are parallel, -1 where they are antiparallel, else 0."""
    sign = 1.0 if dot(u, v) >= 0 else -1.0
    gap = (v[0] - sign * u[0], v[1] - sign * u[1], v[2] - sign * u[2])
    return int(sign) if length(cross(u, gap)) <= close else 0
