"""Going through a grid, block by block, and what is found on the way."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

import numpy as np

from dhcli.errors import RobotError
from dhcli.kinematics.batch import forward_batch
from dhcli.kinematics.frames import ORIGIN
from dhcli.kinematics.sweep.grid import Grid
from dhcli.kinematics.sweep.plan import remarks
from dhcli.kinematics.sweep.result import SIDES, Extreme, Sweep
from dhcli.kinematics.sweep.target import Target

if TYPE_CHECKING:
    from numpy.typing import NDArray

BLOCK = 65_536
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
    first = 0
    for rows in positions(target, grid):
        places = np.ascontiguousarray(rows[:, -3:].T)
        distances = np.sqrt(np.einsum("ij,ij->j", places, places))
        if not np.isfinite(distances).all():
            raise RobotError("a position is not a real number, or too large to compute with")
        found["farthest"].take(distances, first)
        found["nearest"].take(-distances, first)
        for k, axis in enumerate("xyz"):
            found[f"{axis}_min"].take(-places[k], first)
            found[f"{axis}_max"].take(places[k], first)
        first += len(rows)
        if each is not None:
            each(rows)
    extremes = {name: _extreme(target, grid, highest.index) for name, highest in found.items()}
    farthest, nearest = extremes.pop("farthest"), extremes.pop("nearest")
    return Sweep(target, grid, farthest, nearest, extremes, tuple(remarks(target, grid)))


def positions(target: Target, grid: Grid) -> Iterator[NDArray[np.float64]]:
    """Joint values and positions of a grid in its order, block by block.

    Yields:
        Rows, shape (N, n + 3): radians and metres.
    """
    poses = np.empty((min(BLOCK, grid.count), 4, 4))
    view = target.view
    point = None if view.coordinates == ORIGIN else np.array(target.coordinates)
    for q in joint_rows(grid):
        seen = forward_batch(
            target.robot, q, start=view.reference, end=view.frame, parameters=target.lengths, out=poses[: len(q)]
        )
        places = seen[:, :3, 3]
        if point is not None:
            places = places + seen[:, :3, :3] @ point
        yield np.concatenate((q, places), axis=1)


def joint_rows(grid: Grid) -> Iterator[NDArray[np.float64]]:
    """Joint values of a grid in its order, block by block, each made when it is asked for.

    Yields:
        Rows, shape (N, n): radians and metres.
    """
    tables = [np.array(axis.floats()) for axis in grid.axes]
    counts = [axis.count for axis in grid.axes]
    for first in range(0, grid.count, BLOCK):
        numbers = np.arange(first, min(first + BLOCK, grid.count))
        digits = np.unravel_index(numbers, counts)
        yield np.stack([table[digit] for table, digit in zip(tables, digits, strict=True)], axis=1)


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

    def take(self, values: NDArray[np.float64], first: int) -> None:
        """See more numbers.

        Args:
            values: The numbers, shape (N,), all finite.
            first: Where the first of them stands.
        """
        best = self._records[-1][0] if self._records else -np.inf
        top = float(values.max(initial=-np.inf))
        if top <= best:
            return
        level = top - SLACK * max(1.0, abs(top))
        near = np.flatnonzero(values >= level)
        heights = values[near]
        before = np.maximum.accumulate(np.concatenate(([best], heights[:-1])))
        is_record = heights > before
        self._records = [record for record in self._records if record[0] >= level]
        self._records += zip(heights[is_record].tolist(), (first + near[is_record]).tolist(), strict=True)
