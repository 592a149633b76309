"""Sizes: how long a symbolic product will be, known before it is multiplied out.

A number of this arithmetic is the count of symbols that the expression in its place would be written with, so that
the one fold tells the length of a result in no time, and a result that nobody can read is never computed.
"""

from __future__ import annotations

from dhcli.algebra.arithmetic import right_angle
from dhcli.frozen import frozen
from dhcli.notation.angle import Angle
from dhcli.notation.tree import Expr, Number
from dhcli.notation.walk import walk


@frozen
class Size:
    """A count that adds up under every operation."""

    count: int

    def __add__(self, other: Size | int) -> Size:
        return Size(self.count + (other.count if isinstance(other, Size) else 1))

    __radd__ = __mul__ = __rmul__ = __add__

    def __neg__(self) -> Size:
        return self


class Sizes:
    """Counts of symbols."""

    def cos_sin(self, angle: Angle) -> tuple[Size | int, Size | int]:
        """One symbol each; structural integers for right angles."""
        return right_angle(angle) or (Size(1), Size(1))

    def length(self, expr: Expr) -> Size | int:
        """The symbols in an expression."""
        if type(expr) is Number and expr.value in (-1, 0, 1):
            return int(expr.value)
        return Size(sum(1 for _ in walk(expr)))

    def constant(self, value: int) -> Size:
        """A number that is written as itself."""
        return Size(1)


SIZES = Sizes()
