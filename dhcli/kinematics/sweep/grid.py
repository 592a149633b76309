"""Grids of joint values, exact and lazy: a grid knows its poses by number and holds none of them."""

from __future__ import annotations

import math
from fractions import Fraction

from dhcli.frozen import frozen
from dhcli.kinematics.derived import in_floats, metres
from dhcli.kinematics.ranges import difference, times, total
from dhcli.kinematics.robot import Value
from dhcli.notation.angle import Angle, Rational


@frozen
class Axis:
    """The values that one joint takes, evenly spaced.

    Attributes:
        name: The joint variable.
        first: The first value.
        last: The last value; the first one again for a joint that stands still.
        count: How many values there are.
    """

    name: str
    first: Value
    last: Value
    count: int = 1

    @classmethod
    def held(cls, name: str, value: Value) -> Axis:
        """A joint that stands still."""
        return cls(name, value, value)

    @property
    def step(self) -> Value:
        """What lies between one value and the next."""
        return times(difference(self.first, self.last), Fraction(1, max(1, self.count - 1)))

    def at(self, k: int) -> Value:
        """The value of this number from 0, exact."""
        return self.first if self.count == 1 else total(self.first, times(self.step, k))

    def floats(self) -> list[float]:
        """All values in radians or metres, each the nearest float to the exact one."""
        if self.count == 1:
            return [in_floats(self.first)]
        if isinstance(self.first, Angle) and isinstance(self.last, Angle):
            turns = _line(self.first.degrees, self.last.degrees, self.count)
            rest = _line(self.first.radians, self.last.radians, self.count)
            return [math.radians(degrees) + radians for degrees, radians in zip(turns, rest, strict=True)]
        return _line(metres(self.first), metres(self.last), self.count)


@frozen
class Grid:
    """Every combination of the values of some joints, numbered from 0; the last joint changes fastest.

    Attributes:
        axes: The values of each joint, in joint order.
    """

    axes: tuple[Axis, ...]

    @property
    def count(self) -> int:
        """How many poses there are."""
        return math.prod(axis.count for axis in self.axes)

    @property
    def swept(self) -> tuple[Axis, ...]:
        """The joints that move."""
        return tuple(axis for axis in self.axes if axis.count > 1)

    @property
    def held(self) -> tuple[Axis, ...]:
        """The joints that stand still."""
        return tuple(axis for axis in self.axes if axis.count == 1)

    def at(self, index: int) -> dict[str, Value]:
        """The joint values of a pose by its number, exact."""
        found: dict[str, Value] = {}
        for axis in reversed(self.axes):
            index, k = divmod(index, axis.count)
            found[axis.name] = axis.at(k)
        return {axis.name: found[axis.name] for axis in self.axes}


def _line(first: Rational, last: Rational, count: int) -> list[float]:
    """Values from one to another in equal steps; a quotient of integers is rounded once, to the nearest float."""
    step = Fraction(last - first, count - 1)
    below = math.lcm(first.denominator, step.denominator)
    start, rise = int(first * below), int(step * below)
    return [(start + k * rise) / below for k in range(count)]
