"""What a sweep has for an answer."""

from __future__ import annotations

import math
from collections.abc import Mapping

from dhcli.frozen import frozen
from dhcli.kinematics.sweep.grid import Grid
from dhcli.kinematics.sweep.target import Target
from dhcli.kinematics.values import Values

SIDES = ("x_min", "x_max", "y_min", "y_max", "z_min", "z_max")
"""The sides of the box around all positions."""


@frozen
class Extreme:
    """A pose of a grid at which something is largest or smallest.

    Attributes:
        index: Its number in the grid.
        q: The joint values, exact.
        position: Where the target is [m].
    """

    index: int
    q: Values
    position: tuple[float, float, float]

    @property
    def distance(self) -> float:
        """How far the target is from the origin of the frame it is seen from [m]."""
        return math.hypot(*self.position)


@frozen
class Sweep:
    """What was found in a grid. Of poses that are extreme alike, but for rounding, it is the first.

    Attributes:
        target: What was followed.
        grid: Through which grid.
        farthest: The pose of the largest distance.
        nearest: The pose of the smallest.
        sides: The pose at each of `SIDES` of the box around all positions.
        warnings: What a person should know all the same.
    """

    target: Target
    grid: Grid
    farthest: Extreme
    nearest: Extreme
    sides: Mapping[str, Extreme]
    warnings: tuple[str, ...] = ()

    def __repr__(self) -> str:
        """One line, as the prompt shows it."""
        target, reach = self.target, f"{self.nearest.distance:.4g} to {self.farthest.distance:.4g} m"
        return f"<Sweep of {target.robot.name}: {self.grid.count:,} poses, {reach} from frame {target.view.start}>"

    @property
    def box(self) -> tuple[tuple[float, float], ...]:
        """The least and the greatest x, y and z [m]."""
        return tuple(
            (self.sides[f"{axis}_min"].position[k], self.sides[f"{axis}_max"].position[k])
            for k, axis in enumerate("xyz")
        )
