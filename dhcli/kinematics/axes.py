"""Joint axes in space: what is left of a chain when its table is forgotten, and how they move its end."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import field
from typing import TypeAlias

from dhcli.algebra.floats import Floats
from dhcli.errors import RobotError
from dhcli.frozen import frozen
from dhcli.geometry.rigid import Rigid
from dhcli.geometry.vectors import UNITS, Vector, cross, length, minus, scaled
from dhcli.kinematics.fold import fold
from dhcli.kinematics.moves import PLANES, Chain, Fixed, Move, Rot, Trans, expressions, names
from dhcli.notation.angle import Angle
from dhcli.notation.factors import AXES
from dhcli.notation.tree import ZERO, Expr

MOST_SEEN = 8
"""Points at which the axes of an arm are kept."""

Point: TypeAlias = Mapping[str, Angle | float]
"""A value for each name that is not a joint variable."""


def no_axis(name: str) -> tuple[str, str]:
    """What to say of a variable that shares a move with others, or makes several, and what to do about it."""
    hint = "here each row takes a variable of its own; how motors move them together stands under actuators:"
    return f"{name} does not move one joint about or along one axis", hint


@frozen
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

    def moved(self, by: float) -> Rigid:
        """What the joint does when its variable grows by so much: the exponential of its twist."""
        if self.turns:
            return Rigid.turn(self.direction, self.rate * by, self.point)
        return Rigid.shift(scaled(self.direction, self.rate * by))


@frozen
class Arm:
    """A chain and the joints it meets on its way.

    Attributes:
        chain: The moves.
        movers: Index of each move that a joint makes, and the variable of the joint, in order.
        names: Every name that the chain needs a value for.
    """

    chain: Chain
    movers: tuple[tuple[int, str], ...]
    names: frozenset[str]
    _seen: dict[object, tuple[tuple[Screw, ...], Rigid]] = field(
        default_factory=dict, init=False, repr=False, compare=False
    )
    _sizes: dict[object, float] = field(default_factory=dict, init=False, repr=False, compare=False)

    @classmethod
    def of(cls, chain: Chain, variables: tuple[str, ...]) -> Arm:
        """Find the joints.

        Raises:
            RobotError: A variable stands in two moves, or a move has two variables.
        """
        movers: list[tuple[int, str]] = []
        every: set[str] = set()
        for index, move in enumerate(chain):
            found = move.angle.names if isinstance(move, Rot) else names((move,))
            every |= found
            inside = found.intersection(variables)
            if len(inside) > 1 or not inside.isdisjoint(name for _, name in movers):
                raise RobotError(*no_axis(min(inside)))
            movers += [(index, name) for name in inside]
        return cls(chain, tuple(movers), frozenset(every))

    @property
    def variables(self) -> tuple[str, ...]:
        """The joint variables in the order in which the chain meets them."""
        return tuple(name for _, name in self.movers)

    def pose(self, point: Point, q: Mapping[str, float] | None = None) -> Rigid:
        """The end frame at a point; variables without a value are zero."""
        return _after(Rigid(), self.chain, Floats({**point, **dict.fromkeys(self.variables, 0.0), **(q or {})}))

    def screws(self, point: Point) -> tuple[tuple[Screw, ...], Rigid]:
        """The joint axes at a point, and the end frame, all in the zero pose and seen from the first frame.

        They are kept for the points at which they were asked last: arms are compared at the same few ones.
        """
        key = tuple(point.items())
        if key not in self._seen:
            if len(self._seen) >= MOST_SEEN:
                self._seen.clear()
            self._seen[key] = self._screws(point)
        return self._seen[key]

    def _screws(self, point: Point) -> tuple[tuple[Screw, ...], Rigid]:
        over = Floats({**point, **dict.fromkeys(self.variables, 0.0)})
        found: list[Screw] = []
        here, start = Rigid(), 0
        for index, name in self.movers:
            here = _after(here, self.chain[start:index], over)
            start = index
            found.append(self._screw(name, self.chain[index], here, point))
        return tuple(found), _after(here, self.chain[start:], over)

    def size(self, point: Point) -> float:
        """Sum of all lengths in the zero pose [m], or one metre where there is none."""
        key = tuple(point.items())
        if key not in self._sizes:
            if len(self._sizes) >= MOST_SEEN:
                self._sizes.clear()
            over = Floats({**point, **dict.fromkeys(self.variables, 0.0)})
            fixed = (row[3] for move in self.chain if isinstance(move, Fixed) for row in move.rows)
            others = (expr for move in self.chain if isinstance(move, Trans) for expr in move.offset)
            self._sizes[key] = sum(abs(over.value(expr)) for expr in (*fixed, *others) if expr is not ZERO) or 1.0
        return self._sizes[key]

    def columns(self, point: Point, q: Mapping[str, float], size: float) -> list[list[float]]:
        """Columns of the geometric Jacobian, without numpy.

        Args:
            point: Values of all other names.
            q: Value of each joint variable.
            size: The length that counts as 1 [m].

        Returns:
            Six numbers for each joint: the velocity of the end, in the given length, and the turning rate.
        """
        screws, end = self.screws(point)
        here, axes = Rigid(), []
        for screw in screws:
            axes.append((screw, here.turned(screw.direction), here.moved(screw.point)))
            here @= screw.moved(q[screw.name])
        tip = (here @ end).offset
        return [
            [*scaled(cross(axis, minus(tip, at)), 1 / size), *axis] if screw.turns else [*axis, 0.0, 0.0, 0.0]
            for screw, axis, at in axes
        ]

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


def _after(here: Rigid, chain: Chain, over: Floats) -> Rigid:
    """Where moves lead from a frame, in floats; what `fold` does for all kinds of number takes four times as long."""
    for move in chain:
        if isinstance(move, Rot):
            cos, sin = over.cos_sin(move.angle)
            if sin or cos != 1:
                here = here.then_turned(PLANES[move.axis], cos, sin)
        elif isinstance(move, Trans):
            x, y, z = map(over.length, move.offset)
            if x or y or z:
                here = here.then_shifted((x, y, z))
        else:
            here @= Rigid.of(fold((move,), over))
    return here
