"""The right arm of a table, and what is worked out of it once for every table that is compared with it."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import count

from dhcli.algebra.arithmetic import CannotHoldError
from dhcli.algebra.floats import Floats
from dhcli.algebra.residues import Residues
from dhcli.checking.tables.samples import Values, general_points, points_all_round
from dhcli.kinematics.axes import Arm, Point
from dhcli.kinematics.fold import fold
from dhcli.kinematics.forward import put_in
from dhcli.kinematics.moves import Chain, Rot, expressions

EXACT = 1e-7
"""What two products that are equal may differ by in floats, at lengths and angles near 1."""

MOST_KEPT = 64
"""Sets of names whose points are kept: a table may bring names of its own."""


class RightArm:
    """The right arm, what is known of its names, and where and with what it is compared."""

    def __init__(self, arm: Arm, values: Values) -> None:
        """Begin with nothing worked out."""
        self.arm = arm
        self.values = values
        self._points: dict[frozenset[str], tuple[list[Point], Iterator[Point]]] = {}
        self._residues: tuple[Residues, tuple[tuple[int, ...], ...]] | None = None

    def points(self, other: Arm) -> Iterator[Point]:
        """Values of all names but the joints, the same for all arms that bring the same names; see `general_points`."""
        free = (self.arm.names | other.names) - {*self.arm.variables, *other.variables}
        if free not in self._points:
            if len(self._points) >= MOST_KEPT:
                self._points.clear()
            self._points[free] = [], general_points(free, self.values)
        drawn, more = self._points[free]
        for k in count():
            if k == len(drawn):
                drawn.append(next(more))
            yield drawn[k]

    def equals(self, other: Chain) -> bool:
        """Whether a chain has the same product for all values of its names, decided in residues; else at points."""
        second = put_in(other, self.values.given)
        try:
            over, right = self._folded(second)
            return all(
                a == over.value(b)
                for one, two in zip(right, fold(second, over), strict=True)
                for a, b in zip(one, two, strict=True)
            )
        except (CannotHoldError, ZeroDivisionError):
            first = put_in(self.arm.chain, self.values.given)
            points = points_all_round((first, second), self.arm, self.values)
            return all(_agree(first, second, point) for point in points)

    def _folded(self, other: Chain) -> tuple[Residues, tuple[tuple[int, ...], ...]]:
        """A random point that holds the fractions of angles of both chains, and the right product there."""
        angles = [move.angle for move in other if isinstance(move, Rot)]
        if self._residues is None or not self._residues[0].holds(expressions(other), angles):
            first = put_in(self.arm.chain, self.values.given)
            both = (*first, *other)
            over = Residues(tuple(expressions(both)), [move.angle for move in both if isinstance(move, Rot)])
            self._residues = over, tuple(tuple(over.value(a) for a in row) for row in fold(first, over))
        return self._residues


def _agree(first: Chain, second: Chain, point: Point) -> bool:
    """Whether two products are equal at a point; what is no number there is not."""
    over = Floats(point)
    one, two = fold(first, over), fold(second, over)
    return all(abs(a - b) <= EXACT for r, s in zip(one, two, strict=True) for a, b in zip(r, s, strict=True))
