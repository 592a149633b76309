"""Going through a grid, block by block, and what is found on the way."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING

import numpy as np

from dhcli.algebra.arithmetic import settled
from dhcli.algebra.spread import Spread
from dhcli.algebra.tape import Number, Tape
from dhcli.errors import RobotError
from dhcli.frozen import frozen
from dhcli.kinematics.fold import fold_rows
from dhcli.kinematics.merge import merge
from dhcli.kinematics.playing import MODEST
from dhcli.kinematics.recorded import Recording, kept
from dhcli.kinematics.sweep.grid import Grid
from dhcli.kinematics.sweep.plan import remarks
from dhcli.kinematics.sweep.result import SIDES, Extreme, Sweep
from dhcli.kinematics.sweep.target import Target
from dhcli.kinematics.validity import in_floats
from dhcli.kinematics.values import numbers

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from dhcli.kinematics.robot import Robot

BLOCK = 32_768
"""Poses at a time."""

SLACK = 1e-9
"""Part of a value, and at least of a metre, within which two are one: rounding differs from machine to machine."""


def sweep(target: Target, grid: Grid, each: Callable[[NDArray[np.float64]], None] | None = None) -> Sweep:
    """Follow a target through a grid.

    >>> from dhcli import load_robot
    >>> from dhcli.kinematics.sweep.plan import plan
    >>> from dhcli.kinematics.sweep.target import target_of
    >>> target = target_of(load_robot("planar-2r"))
    >>> found = sweep(target, plan(target))
    >>> found.farthest.distance, found.box[1]
    (0.7, (-0.7, 0.7))

    Args:
        target: What is followed.
        grid: The joint values.
        each: What to call with every block of rows, shape (N, n + 3): joint values and position; radians and metres.

    Returns:
        Where the target is farthest and nearest, and the box that it stays in.

    Raises:
        RobotError: A position is not a real number, or beyond what a float can hold.
    """
    found = {name: Highest() for name in ("farthest", "nearest", *SIDES)}
    forbidden = Forbidden.of(target.robot)
    tables = tables_of(grid) if each is not None or forbidden is not None else []
    outside = 0
    for slab, places in walked(target, grid):
        distances = np.sqrt(np.einsum("ij,ij->j", places, places))
        if not math.isfinite(distances.max()):
            raise RobotError("a position is not a real number, or too large to compute with")
        found["farthest"].take(distances, slab.first)
        found["nearest"].take(distances, slab.first, sign=-1)
        for k, axis in enumerate("xyz"):
            found[f"{axis}_min"].take(places[k], slab.first, sign=-1)
            found[f"{axis}_max"].take(places[k], slab.first)
        rows = slab.rows(tables) if tables else np.empty((0, 0))
        if forbidden is not None:
            outside += forbidden.count(rows)
        if each is not None:
            each(np.concatenate((rows, places.T), axis=1))
    extremes = {name: _extreme(target, grid, highest.index) for name, highest in found.items()}
    farthest, nearest = extremes.pop("farthest"), extremes.pop("nearest")
    told = [*remarks(target, grid)]
    if outside and forbidden is not None:
        told.append(f"{outside:,} of the {grid.count:,} poses are beyond the limits of {forbidden.names}, and count")
    return Sweep(target, grid, farthest, nearest, extremes, tuple(told))


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


@frozen
class Slab:
    """A part of a grid that is a grid itself, and whose poses have one number after another.

    Attributes:
        first: The number of its first pose.
        parts: Which values of each axis are in it.
    """

    first: int
    parts: tuple[slice, ...]

    def rows(self, tables: Sequence[NDArray[np.float64]]) -> NDArray[np.float64]:
        """Its joint values, shape (N, n), from those of each axis; radians and metres."""
        values = [table[part] for table, part in zip(tables, self.parts, strict=True)]
        return np.stack([axis.ravel() for axis in np.meshgrid(*values, indexing="ij")], axis=1)


def tables_of(grid: Grid) -> list[NDArray[np.float64]]:
    """The values of each axis; radians and metres."""
    return [np.array(axis.floats()) for axis in grid.axes]


def slabs(grid: Grid) -> Iterator[Slab]:
    """A grid in its order, in parts of at most `BLOCK` poses: the last axes whole, one in pieces, the others fixed."""
    counts = [axis.count for axis in grid.axes]
    whole = len(counts)
    while whole and math.prod(counts[whole - 1 :]) <= BLOCK:
        whole -= 1
    cut = max(0, whole - 1)
    size = math.prod(counts[cut + 1 :])
    pieces = math.ceil(counts[cut] / max(1, BLOCK // size))
    borders = [counts[cut] * k // pieces for k in range(pieces + 1)]
    first = 0
    for fixed in itertools.product(*map(range, counts[:cut])):
        for begin, end in itertools.pairwise(borders):
            outer = (slice(k, k + 1) for k in fixed)
            yield Slab(first, (*outer, slice(begin, end), *(slice(0, count) for count in counts[cut + 1 :])))
            first += (end - begin) * size


def walked(target: Target, grid: Grid) -> Iterator[tuple[Slab, NDArray[np.float64]]]:
    """Positions of a grid in its order, part by part.

    Each step of the formula is played over the axes that it depends on, and what only the last axes move, once.

    Yields:
        A part, and its positions, shape (3, N) [m]; they stay until the next one.
    """
    tables = tables_of(grid)
    merged = all(np.abs(table).max() <= MODEST for table in tables)
    program = _recorded(target).program(merged=merged, tangents=True)
    swept = [k for k, axis in enumerate(grid.axes) if axis.count > 1]

    def spread(k: int, part: slice) -> NDArray[np.float64]:
        """Values of a joint along its own axis; those that stand still have none, for numpy has 32 at most."""
        return tables[k][part].reshape([-1 if other == k else 1 for other in swept])

    played: Spread | None = None
    places = np.empty(0)
    for slab in slabs(grid):
        moving = [k for k, part in enumerate(slab.parts) if part.stop - part.start < grid.axes[k].count]
        if played is None:
            staying = {k: spread(k, part) for k, part in enumerate(slab.parts) if k not in moving}
            played = Spread(program, staying)
        shape = [slab.parts[k].stop - slab.parts[k].start for k in swept]
        found = played.play({k: spread(k, slab.parts[k]) for k in moving})
        if places.shape[1:] != tuple(shape):
            places = np.empty((3, *shape))
        for k, coordinate in enumerate(found):
            places[k, ...] = coordinate
        yield slab, places.reshape(3, -1)


def _recorded(target: Target) -> Recording:
    """The steps to the three coordinates of what is followed, kept with its robot."""
    values = numbers(target.lengths)

    def record() -> Recording:
        def entries(tape: Tape, merged: bool) -> list[Number]:  # noqa: FBT001  called by `Recording` alone
            rows = fold_rows(merge(target.chain) if merged else target.chain, tape)
            return [settled(row[3], tape) for row in rows]

        return Recording(target.robot.variables, values, entries)

    return kept(target.robot, ("place", target.view, tuple(values.items())), record)


def _extreme(target: Target, grid: Grid, index: int) -> Extreme:
    q = grid.at(index)
    return Extreme(index, q, target.at(q))


class Highest:
    """The highest of the numbers seen so far, and where the first stands that is as high but for rounding.

    Only a number above all before it can be that first one, whatever comes later. So it is enough to keep, of these
    records, those within rounding of the last: when a higher one comes, the first still near it is the answer.
    """

    def __init__(self) -> None:
        """Nothing seen yet."""
        self._records: list[tuple[float, int]] = []

    @property
    def index(self) -> int:
        """Where it stands.

        Raises:
            IndexError: Nothing was seen.
        """
        return self._records[0][1]

    def take(self, values: NDArray[np.float64], first: int, *, sign: int = 1) -> None:
        """See more numbers.

        Args:
            values: The numbers, shape (N,), at least one, all finite.
            first: Where the first of them stands.
            sign: -1 for those of the other sign.
        """
        best = self._records[-1][0] if self._records else -np.inf
        top = float(values.max()) if sign > 0 else -float(values.min())
        if top <= best:
            return
        level = top - SLACK * max(1.0, abs(top))
        near = np.flatnonzero(values >= level if sign > 0 else values <= -level)
        heights = values[near] * sign
        before = np.maximum.accumulate(np.concatenate(([best], heights[:-1])))
        is_record = heights > before
        self._records = [record for record in self._records if record[0] >= level]
        self._records += zip(heights[is_record].tolist(), (first + near[is_record]).tolist(), strict=True)
