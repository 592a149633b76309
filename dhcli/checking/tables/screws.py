"""Joint axes in space: what is left of a chain when its table is forgotten, and the geometry to compare it with."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TypeAlias

from dhcli.algebra.floats import Floats
from dhcli.errors import RobotError
from dhcli.kinematics.fold import fold
from dhcli.kinematics.moves import Chain, Fixed, Move, Rot, expressions, names
from dhcli.notation.angle import Angle
from dhcli.notation.factors import AXES
from dhcli.notation.tree import Expr

Vector: TypeAlias = tuple[float, float, float]
Point: TypeAlias = Mapping[str, Angle | float]
"""A value for each name that is not a joint variable."""

ORIGIN: Vector = (0.0, 0.0, 0.0)
UNITS: tuple[Vector, Vector, Vector] = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


def dot(a: Vector, b: Vector) -> float:
    """Scalar product."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Vector, b: Vector) -> Vector:
    """Vector product."""
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def plus(a: Vector, b: Vector, times: float = 1.0) -> Vector:
    """A vector and a multiple of another."""
    return a[0] + times * b[0], a[1] + times * b[1], a[2] + times * b[2]


def scaled(a: Vector, factor: float) -> Vector:
    """A multiple of a vector."""
    return a[0] * factor, a[1] * factor, a[2] * factor


def length(a: Vector) -> float:
    """Euclidean length."""
    return math.sqrt(dot(a, a))


def across(a: Vector, unit: Vector) -> Vector:
    """The part of a vector that is perpendicular to a unit vector."""
    return plus(a, unit, -dot(a, unit))


def angle_about(axis: Vector, start: Vector, end: Vector) -> float:
    """Angle about a unit axis that turns one vector into the half-plane of another; 0 where that says nothing."""
    start, end = across(start, axis), across(end, axis)
    return math.atan2(dot(axis, cross(start, end)), dot(start, end))


@dataclass(frozen=True, slots=True)
class Rigid:
    """A rigid motion: rows of its rotation, and its translation [m]."""

    rows: tuple[Vector, Vector, Vector] = UNITS
    offset: Vector = ORIGIN

    @classmethod
    def of(cls, matrix: tuple[tuple[float, ...], ...]) -> Rigid:
        """A homogeneous matrix, shape (4, 4), as a rigid motion."""
        (a, b, c, x), (d, e, f, y), (g, h, i, z) = matrix[:3]
        return cls(((a, b, c), (d, e, f), (g, h, i)), (x, y, z))

    @classmethod
    def shift(cls, offset: Vector) -> Rigid:
        """A translation."""
        return cls(UNITS, offset)

    @classmethod
    def turn(cls, axis: Vector, angle: float, through: Vector = ORIGIN) -> Rigid:
        """The rotation about a line."""
        cos, sin = math.cos(angle), math.sin(angle)
        columns = [
            plus(plus(scaled(unit, cos), cross(axis, unit), sin), axis, dot(axis, unit) * (1 - cos)) for unit in UNITS
        ]
        (a, d, g), (b, e, h), (c, f, i) = columns
        rotation = cls(((a, b, c), (d, e, f), (g, h, i)))
        return cls(rotation.rows, plus(through, rotation.turned(through), -1))

    def turned(self, vector: Vector) -> Vector:
        """A direction after the motion."""
        return dot(self.rows[0], vector), dot(self.rows[1], vector), dot(self.rows[2], vector)

    def moved(self, point: Vector) -> Vector:
        """A point after the motion."""
        return plus(self.turned(point), self.offset)

    def column(self, index: int) -> Vector:
        """Where an axis of the reference points after the motion."""
        return self.rows[0][index], self.rows[1][index], self.rows[2][index]

    def __matmul__(self, other: Rigid) -> Rigid:
        (a, d, g), (b, e, h), (c, f, i) = (self.turned(other.column(k)) for k in range(3))
        return Rigid(((a, b, c), (d, e, f), (g, h, i)), self.moved(other.offset))

    def inverse(self) -> Rigid:
        """The motion that undoes this one."""
        back = Rigid((self.column(0), self.column(1), self.column(2)))
        return Rigid(back.rows, scaled(back.turned(self.offset), -1.0))

    def angle_about(self, axis: Vector) -> float:
        """Angle of the rotation about a unit axis that comes nearest."""
        (_, b, c), (d, _, f), (g, h, _) = self.rows
        trace = self.rows[0][0] + self.rows[1][1] + self.rows[2][2]
        return math.atan2(dot(axis, (h - f, c - g, d - b)), trace - dot(axis, self.turned(axis)))

    def tilt(self) -> float:
        """How far the rotation is from none: the largest difference of a direction cosine."""
        return max(
            abs(x - y) for row, unit in zip(self.rows, UNITS, strict=True) for x, y in zip(row, unit, strict=True)
        )


@dataclass(frozen=True, slots=True)
class Screw:
    """A joint axis in the zero pose.

    Attributes:
        name: The joint variable.
        turns: Whether the joint turns; else it slides and only the direction matters.
        point: A point of the axis.
        direction: Unit vector, in the sense in which the variable counts.
        rate: Motion per unit of the variable, positive.
    """

    name: str
    turns: bool
    point: Vector
    direction: Vector
    rate: float


@dataclass(frozen=True, slots=True)
class Arm:
    """A chain and the joints it meets on its way.

    Attributes:
        chain: The moves.
        movers: Index of each move that a joint makes, and the variable of the joint, in order.
    """

    chain: Chain
    movers: tuple[tuple[int, str], ...]

    @classmethod
    def of(cls, chain: Chain, variables: tuple[str, ...]) -> Arm:
        """Find the joints.

        Raises:
            RobotError: A variable stands in two moves, or a move has two variables.
        """
        movers: list[tuple[int, str]] = []
        for index, move in enumerate(chain):
            inside = names((move,)).intersection(variables)
            if len(inside) > 1 or not inside.isdisjoint(name for _, name in movers):
                raise RobotError(f"{min(inside)} does not move one joint about or along one axis")
            movers += [(index, name) for name in inside]
        return cls(chain, tuple(movers))

    @property
    def variables(self) -> tuple[str, ...]:
        """The joint variables in the order in which the chain meets them."""
        return tuple(name for _, name in self.movers)

    def pose(self, point: Point, q: Mapping[str, float] | None = None) -> Rigid:
        """The end frame at a point; variables without a value are zero."""
        return Rigid.of(fold(self.chain, Floats({**point, **dict.fromkeys(self.variables, 0.0), **(q or {})})))

    def screws(self, point: Point) -> tuple[tuple[Screw, ...], Rigid]:
        """The joint axes at a point, and the end frame, all in the zero pose and seen from the first frame."""
        over = Floats({**point, **dict.fromkeys(self.variables, 0.0)})
        found: list[Screw] = []
        here, start = Rigid(), 0
        for index, name in self.movers:
            here @= Rigid.of(fold(self.chain[start:index], over))
            start = index
            found.append(self._screw(name, self.chain[index], here, point))
        return tuple(found), here @ Rigid.of(fold(self.chain[start:], over))

    def _screw(self, name: str, move: Move, here: Rigid, point: Point) -> Screw:
        if isinstance(move, Rot):
            rate = float(dict(move.angle.terms)[name])
            axis = scaled(here.column(AXES.index(move.axis)), math.copysign(1, rate))
            return Screw(name, turns=True, point=here.offset, direction=axis, rate=abs(rate))
        lengths = [row[3] for row in move.rows] if isinstance(move, Fixed) else list(expressions((move,)))
        x, y, z = (self._slope(expr, name, point) for expr in lengths)
        rate = length((x, y, z))
        direction = scaled(here.turned((x, y, z)), 1 / rate) if rate else UNITS[2]
        return Screw(name, turns=False, point=here.offset, direction=direction, rate=rate)

    def _slope(self, expr: Expr, name: str, point: Point) -> float:
        at = [Floats({**point, **dict.fromkeys(self.variables, 0.0), name: q}).value(expr) for q in (0.0, 1.0)]
        return at[1] - at[0]
