"""Going through a grid, slab by slab, and what is found on the way."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from dhcli.errors import RobotError
from dhcli.frozen import FrozenDict, frozen
from dhcli.kinematics.derived import in_floats
from dhcli.kinematics.sharing import check_threads, shared
from dhcli.kinematics.sweep.grid import Grid
from dhcli.kinematics.sweep.highest import SLACK, Highest, Record
from dhcli.kinematics.sweep.plan import remarks
from dhcli.kinematics.sweep.result import SIDES, Extreme, Sweep
from dhcli.kinematics.sweep.target import Target
from dhcli.kinematics.sweep.walk import Slab, Walk, slabs, tables_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from dhcli.kinematics.robot import Robot


def sweep(
    target: Target,
    grid: Grid,
    each: Callable[[NDArray[np.float64]], None] | None = None,
    *,
    threads: int = 1,
    tell: Callable[[int], None] | None = None,
) -> Sweep:
    """Follow a target through a grid.

    >>> from dhcli import load_robot
    >>> from dhcli.kinematics.sweep.plan import plan
    >>> from dhcli.kinematics.sweep.target import target_of
    >>> target = target_of(load_robot("planar-2r"))
    >>> found = sweep(target, plan(target, ()))
    >>> found.farthest.distance, found.box[1]
    (0.7, (-0.7, 0.7))

    Args:
        target: What is followed.
        grid: The joint values.
        each: What to call with every block of rows, shape (N, n + 3): joint values and position; radians and metres.
        threads: How many threads share the work; what is found is the same with any number, and so is the order in
            which `each` is called, by the thread that asks.
        tell: What to call with the number of poses done, again and again.

    Returns:
        Where the target is farthest and nearest, and the box that it stays in.

    Raises:
        RobotError: A position is not a real number, or beyond what a float can hold; or that is no number of threads.
    """
    check_threads(threads)
    found = {name: Highest(sign) for name, sign in _SIGNS.items()}
    look = _Look(target, grid, found, threads, wants_rows=each is not None)
    outside = 0
    for seen in shared(look.at, slabs(grid, threads), threads):
        for name, records in seen.records.items():
            found[name].take(records)
        outside += seen.outside
        if each is not None and seen.rows is not None:
            each(seen.rows)
        if tell is not None:
            tell(seen.done)
    extremes = {name: _extreme(target, grid, highest.index) for name, highest in found.items()}
    farthest, nearest = extremes.pop("farthest"), extremes.pop("nearest")
    told = [*remarks(target, grid)]
    if outside and look.forbidden is not None:
        names = look.forbidden.names
        told.append(f"{outside:,} of the {grid.count:,} poses are beyond the limits of {names}, and count")
    return Sweep(target, grid, farthest, nearest, FrozenDict(extremes), tuple(told))


_SIGNS = {"farthest": 1, "nearest": -1, **{side: -1 if side.endswith("min") else 1 for side in SIDES}}
"""What is looked for, and whether it is largest or smallest there."""


@frozen
class Seen:
    """What is found in a slab.

    Attributes:
        done: How many poses there are up to its end.
        records: What may be an extreme, for each of them.
        outside: How many poses are forbidden.
        rows: Joint values and positions, shape (N, n + 3), if they are wanted; radians and metres.
    """

    done: int
    records: dict[str, list[Record]]
    outside: int
    rows: NDArray[np.float64] | None


class _Look:
    """Looks at slabs of a grid, several at once if need be."""

    def __init__(
        self, target: Target, grid: Grid, found: dict[str, Highest], threads: int, *, wants_rows: bool
    ) -> None:
        """Prepare what all slabs share."""
        self.forbidden = Forbidden.of(target.robot)
        self._found, self._wants_rows = found, wants_rows
        self._walk = Walk(target, grid, threads)
        self._tables = tables_of(grid) if wants_rows or self.forbidden is not None else []

    def at(self, slab: Slab) -> Seen:
        """What is in a slab.

        Raises:
            RobotError: A position is not a real number, or beyond what a float can hold.
        """
        places = self._walk.places(slab)
        distances = np.sqrt(np.einsum("ij,ij->j", places, places))
        if not math.isfinite(distances.max()):
            raise RobotError("a position is not a real number, or too large to compute with")
        heights = {"farthest": distances, "nearest": distances}
        heights |= {side: places["xyz".index(side[0])] for side in SIDES}
        records = {name: self._found[name].records(values, slab.first) for name, values in heights.items()}
        rows = slab.rows(self._tables) if self._tables else None
        outside = 0 if self.forbidden is None or rows is None else self.forbidden.count(rows)
        taken = np.concatenate((rows, places.T), axis=1) if self._wants_rows and rows is not None else None
        return Seen(slab.first + distances.size, records, outside, taken)


@frozen
class Forbidden:
    """Limits of joints that motors drive, which a grid of motor values may leave.

    Attributes:
        names: The joints that have some.
        slopes: How fast each goes with each motor, shape (m, n).
        low: Where each may be at least, from where it is with all motors at 0, shape (m,).
        high: And at most.
    """

    names: str
    slopes: NDArray[np.float64]
    low: NDArray[np.float64]
    high: NDArray[np.float64]

    @classmethod
    def of(cls, robot: Robot) -> Forbidden | None:
        """Those of a robot by its motors; None for any other, and where no joint has limits."""
        driven = robot.drives
        if driven is None or driven.actuators is None:
            return None
        motors = driven.actuators
        kept = [k for k, name in enumerate(motors.joints) if name in driven.limits and name not in motors.motors]
        if not kept:
            return None
        ends = np.array([[in_floats(end) for end in driven.limits[motors.joints[k]]] for k in kept])
        ends = ends - np.array(motors.offsets(), dtype=float)[kept][:, None]
        names = ", ".join(motors.joints[k] for k in kept)
        return cls(names, np.array(motors.slopes(), dtype=float)[kept], ends[:, 0] - SLACK, ends[:, 1] + SLACK)

    def count(self, rows: NDArray[np.float64]) -> int:
        """How many of some motor values, shape (N, n), they forbid."""
        joints = rows @ self.slopes.T
        return int(((joints < self.low) | (joints > self.high)).any(axis=1).sum())


def _extreme(target: Target, grid: Grid, index: int) -> Extreme:
    q = FrozenDict(grid.at(index))
    return Extreme(index, q, target.at(q))
