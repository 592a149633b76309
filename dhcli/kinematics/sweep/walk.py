"""A grid cut into slabs, and where a target is at the poses of each."""

from __future__ import annotations

import itertools
import math
import threading
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import numpy as np

from dhcli.algebra.arithmetic import settled
from dhcli.algebra.spread import Spread
from dhcli.algebra.tape import Number, Tape
from dhcli.frozen import frozen
from dhcli.kinematics.fold import fold_rows
from dhcli.kinematics.merge import merge
from dhcli.kinematics.playing import MODEST
from dhcli.kinematics.recorded import Recording, kept
from dhcli.kinematics.sweep.grid import Grid
from dhcli.kinematics.sweep.target import Target
from dhcli.kinematics.values import numbers

if TYPE_CHECKING:
    from numpy.typing import NDArray

BLOCK = 65_536
"""Poses at a time."""

SHARED = 4
"""How many times more where threads share them: each is to be longer at work than at taking turns."""


@frozen
class Slab:
    """A part of a grid that is a grid itself, and whose poses have one number after another."""

    first: int
    parts: tuple[slice, ...]

    def rows(self, tables: Sequence[NDArray[np.float64]]) -> NDArray[np.float64]:
        """Its joint values, shape (N, n), from those of each axis; radians and metres."""
        values = [table[part] for table, part in zip(tables, self.parts, strict=True)]
        return np.stack([axis.ravel() for axis in np.meshgrid(*values, indexing="ij")], axis=1)


def tables_of(grid: Grid) -> list[NDArray[np.float64]]:
    """The values of each axis; radians and metres."""
    return [np.array(axis.floats()) for axis in grid.axes]


def slabs(grid: Grid, threads: int = 1) -> Iterator[Slab]:
    """A grid in its order, in parts of at most `BLOCK` poses: the last axes whole, one in pieces, the others fixed."""
    most = BLOCK if threads == 1 else SHARED * BLOCK
    counts = [axis.count for axis in grid.axes]
    whole = len(counts)
    while whole and math.prod(counts[whole - 1 :]) <= most:
        whole -= 1
    cut = max(0, whole - 1)
    size = math.prod(counts[cut + 1 :])
    pieces = math.ceil(counts[cut] / max(1, most // size))
    borders = [counts[cut] * k // pieces for k in range(pieces + 1)]
    first = 0
    for fixed in itertools.product(*map(range, counts[:cut])):
        for begin, end in itertools.pairwise(borders):
            outer = (slice(k, k + 1) for k in fixed)
            yield Slab(first, (*outer, slice(begin, end), *(slice(0, count) for count in counts[cut + 1 :])))
            first += (end - begin) * size


class Walk:
    """A target on its way through a grid.

    Each step of the formula is played over the axes that it depends on, and what only the axes move that every slab
    holds whole, once.
    """

    def __init__(self, target: Target, grid: Grid, threads: int = 1) -> None:
        """Work out what all slabs share."""
        self._tables = tables_of(grid)
        merged = all(np.abs(table).max() <= MODEST for table in self._tables)
        program = _recorded(target).program(merged=merged, tangents=True)
        self._swept = [k for k, axis in enumerate(grid.axes) if axis.count > 1]
        parts = next(slabs(grid, threads)).parts
        self._moving = [k for k, part in enumerate(parts) if part.stop - part.start < grid.axes[k].count]
        staying = {k: self._along(k, part) for k, part in enumerate(parts) if k not in self._moving}
        self._spread = Spread(program, staying)
        self._memory = threading.local()  # pages that the system must hand out anew cost more than what is put there

    def places(self, slab: Slab) -> NDArray[np.float64]:
        """Positions at the poses of a slab in their order, shape (3, N) [m].

        Threads may ask at once; what one is given stays until it asks again.
        """
        found = self._spread.play({k: self._along(k, slab.parts[k]) for k in self._moving})
        shape = (3, *(slab.parts[k].stop - slab.parts[k].start for k in self._swept))
        places = getattr(self._memory, "places", None)
        if places is None or places.shape != shape:
            places = self._memory.places = np.empty(shape)
        for k, coordinate in enumerate(found):
            places[k, ...] = coordinate
        return places.reshape(3, -1)

    def _along(self, k: int, part: slice) -> NDArray[np.float64]:
        """Values of a joint along its own axis; those that stand still have none, for numpy has 32 at most."""
        return self._tables[k][part].reshape([-1 if other == k else 1 for other in self._swept])


def _recorded(target: Target) -> Recording:
    """The steps to the three coordinates of what is followed, kept with its robot."""
    values = numbers(target.lengths)

    def record() -> Recording:
        def entries(tape: Tape, merged: bool) -> list[Number]:  # noqa: FBT001  called by `Recording` alone
            rows = fold_rows(merge(target.chain) if merged else target.chain, tape)
            return [settled(row[3], tape) for row in rows]

        return Recording(target.robot.variables, values, entries)

    return kept(target.robot, ("place", target.view, tuple(values.items())), record)
