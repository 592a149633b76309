"""Moves as answers: which are the same, whatever the spelling of their angles, and whether their order is right."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Literal

from dhcli.algebra.floats import Floats
from dhcli.algebra.terms import TERMS
from dhcli.checking.exercise import Exercise
from dhcli.checking.symbolic import same
from dhcli.checking.tolerance import ZERO as NOTHING
from dhcli.checking.tolerance import Tolerance
from dhcli.frozen import frozen
from dhcli.kinematics.fold import fold
from dhcli.kinematics.forward import put_in
from dhcli.kinematics.moves import Chain, Fixed, Rot, Trans, expressions, names
from dhcli.kinematics.values import numbers
from dhcli.notation.angle import FULL_TURN, Angle
from dhcli.notation.factors import AXES
from dhcli.notation.tree import ZERO, Expr
from dhcli.notation.walk import symbols

RELATIVE = 1e-3


@frozen
class Elementary:
    """One move about or along one axis, or a matrix.

    Attributes:
        kind: Which.
        axis: x, y or z; empty for a matrix.
        value: The angle, the length, or the twelve entries.
    """

    kind: Literal["rot", "trans", "matrix"]
    axis: str
    value: Angle | Expr | tuple[Expr, ...]


class Comparison:
    """Compares moves with those of a link, at the values given where the exercise is in numbers."""

    def __init__(self, exercise: Exercise, right: Chain, tolerance: Tolerance) -> None:
        """Take the right moves."""
        self.exercise = exercise
        self.right = right
        self.tolerance = tolerance
        over = Floats(numbers(exercise.values))
        known = (expr for move in right if isinstance(move, Trans) for expr in expressions((move,)))
        lengths = [abs(over.value(expr)) for expr in known if symbols(expr) <= exercise.values.keys()]
        share = RELATIVE * sum(lengths)
        self.position = tolerance.position if tolerance.position is not None else max(share, NOTHING)

    def elementary(self, chain: Chain) -> list[Elementary]:
        """The moves about and along single axes that move anything."""
        return list(self._elementary(chain))

    def matched(self, typed: list[Elementary], wanted: list[Elementary]) -> int:
        """How many of the moves typed are among those wanted, each of which counts once."""
        left = list(wanted)
        for one in typed:
            found = next((k for k, other in enumerate(left) if self._are_same(one, other)), None)
            if found is not None:
                del left[found]
        return len(wanted) - len(left)

    def same_product(self, typed: Chain) -> bool:
        """Whether moves lead to the same place; in numbers at the values given, within the tolerance."""
        if self.exercise.numeric and not (names(typed) | names(self.right)) - self.exercise.values.keys():
            over = Floats(numbers(self.exercise.values))
            pairs = zip(fold(typed, over), fold(self.right, over), strict=True)
            limits = (*(self.tolerance.rotation,) * 3, self.position)
            return all(
                abs(a - b) <= limits[c] for one, other in pairs for c, (a, b) in enumerate(zip(one, other, strict=True))
            )
        given = self.exercise.values
        rows = zip(fold(put_in(typed, given), TERMS), fold(put_in(self.right, given), TERMS), strict=True)
        return all(self._same(a, b) for one, other in rows for a, b in zip(one, other, strict=True))

    def _elementary(self, chain: Chain) -> Iterator[Elementary]:
        for move in chain:
            if isinstance(move, Rot) and not self._same_angle(move.angle, Angle()):
                yield Elementary("rot", move.axis, move.angle)
            elif isinstance(move, Trans):
                for axis, length in zip(AXES, move.offset, strict=True):
                    if not self._same_length(length, ZERO):
                        yield Elementary("trans", axis, length)
            elif isinstance(move, Fixed):
                yield Elementary("matrix", "", tuple(entry for row in move.rows for entry in row))

    def _are_same(self, one: Elementary, other: Elementary) -> bool:
        if (one.kind, one.axis) != (other.kind, other.axis):
            return False
        match one.value, other.value:
            case Angle(), Angle():
                return self._same_angle(one.value, other.value)
            case tuple(), tuple():
                return all(self._same(a, b) for a, b in zip(one.value, other.value, strict=True))
            case Expr(), Expr():
                return self._same_length(one.value, other.value)
        return False

    def _same_angle(self, one: Angle, other: Angle) -> bool:
        """Modulo a full turn, and within the tolerance of angles where both have a value."""
        apart = one.substitute(self.exercise.values) - other.substitute(self.exercise.values)
        if apart.terms:
            return False
        degrees = float(apart.degrees % FULL_TURN) + math.degrees(float(apart.radians))
        limit = self.tolerance.angle if apart.radians or self.exercise.numeric else 0.0
        return abs((degrees + 180) % 360 - 180) <= limit

    def _same_length(self, one: Expr, other: Expr) -> bool:
        if self._same(one, other):
            return True
        if not self.exercise.numeric or (symbols(one) | symbols(other)) - self.exercise.values.keys():
            return False
        over = Floats(numbers(self.exercise.values))
        return abs(over.value(one) - over.value(other)) <= self.position

    def _same(self, one: Expr, other: Expr) -> bool:
        return same(one, other, self.exercise.values, self.exercise)
