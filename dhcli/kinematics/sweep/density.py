"""Counting the points of a sweep as they come, however many and however far away they are."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from dhcli.kinematics.sweep.target import Target
from dhcli.kinematics.sweep.workspace import Workspace

if TYPE_CHECKING:
    from numpy.typing import NDArray

SIDE, TOP, FRONT = (0, 2), (0, 1), (1, 2)
"""Which coordinate goes to the right in a square, and which upwards."""

CELLS = 128
"""Cells on a side; a multiple of four, so that a square may double around its middle."""

SAMPLE = 1500
"""Points that are kept, at the most; at least half as many where there are that many."""


class Density:
    """Counts points in cells of three squares around the origin, which grow when a point lies outside.

    >>> from dhcli import load_robot
    >>> from dhcli.kinematics.sweep.plan import plan
    >>> from dhcli.kinematics.sweep.run import sweep
    >>> from dhcli.kinematics.sweep.target import target_of
    >>> target = target_of(load_robot("planar-2r"))
    >>> density = Density()
    >>> found = sweep(target, plan(target, ()), density.take)
    >>> seen = density.workspace(target)
    >>> seen.count == found.grid.count == sum(map(sum, seen.top))
    True
    """

    def __init__(self) -> None:
        """Nothing counted yet."""
        self.half = 0.0
        self.count = 0
        self._squares = {plane: np.zeros((CELLS, CELLS), np.int64) for plane in (SIDE, TOP, FRONT)}
        self._kept: list[NDArray[np.float64]] = []
        self._step = 1

    def take(self, rows: NDArray[np.float64]) -> None:
        """Count more points.

        Args:
            rows: Rows whose last three numbers are a position, shape (N, m) [m].
        """
        places = rows[:, -3:]
        reach = float(np.abs(places).max(initial=0.0))
        if not self.half:
            self.half = reach * 1.02 or 1.0
        while reach >= self.half:
            self._double()
        size = 2 * self.half / CELLS
        cells = np.minimum(((places + self.half) / size).astype(np.int64), CELLS - 1)
        for (right, up), square in self._squares.items():
            new = np.bincount(cells[:, up] * CELLS + cells[:, right], minlength=CELLS**2)
            np.add(square, new.reshape(CELLS, CELLS), out=square)
        first = -self.count % self._step
        self._kept += list(places[first :: self._step])
        self.count += len(rows)
        while len(self._kept) > SAMPLE:
            self._kept, self._step = self._kept[::2], 2 * self._step

    def workspace(self, target: Target) -> Workspace:
        """What was counted of the points of a target."""
        sample = tuple((float(x), float(y), float(z)) for x, y, z in self._kept)
        view = target.view
        side, top, front = (tuple(map(tuple, self._squares[plane].tolist())) for plane in (SIDE, TOP, FRONT))
        return Workspace(self.half, side, top, front, sample, self.count, view.frame, view.reference)

    def _double(self) -> None:
        """A square of twice the side around the same middle, each of its cells four of the old ones."""
        quarter = CELLS // 4
        for plane, square in self._squares.items():
            merged = square.reshape(CELLS // 2, 2, CELLS // 2, 2).sum(axis=(1, 3))
            grown = np.zeros_like(square)
            grown[quarter:-quarter, quarter:-quarter] = merged
            self._squares[plane] = grown
        self.half *= 2
