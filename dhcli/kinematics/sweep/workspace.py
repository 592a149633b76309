"""Where the points of a sweep are, for pictures: how many in each cell, seen along each axis."""

from __future__ import annotations

from typing import TypeAlias

from dhcli.frozen import frozen

Counts: TypeAlias = tuple[tuple[int, ...], ...]
"""Points in each cell of a square, row by row from the lowest, shape (N, N)."""


@frozen
class Workspace:
    """The points that a robot comes by.

    Attributes:
        half: Half of the side of the square around the origin in which points are counted [m].
        side: Counts by x, to the right, and z, upwards.
        top: Counts by x, to the right, and y, upwards.
        front: Counts by y, to the right, and z, upwards.
        sample: Some of the points, evenly among all [m].
        count: How many points there are.
        frame: The frame whose origin, or a point of which, they are.
        reference: The frame that they are seen from.
    """

    half: float
    side: Counts
    top: Counts
    front: Counts
    sample: tuple[tuple[float, float, float], ...]
    count: int
    frame: str
    reference: str

    @property
    def extents(self) -> tuple[float, float, float]:
        """How far the points go along x, y and z, in whole cells [m]."""
        size = 2 * self.half / len(self.top) if self.top else 0.0
        return (
            size * _span([any(column) for column in zip(*self.top, strict=True)]),
            size * _span([any(row) for row in self.top]),
            size * _span([any(row) for row in self.side]),
        )


def _span(full: list[bool]) -> int:
    """From the first to the last cell in which there is something."""
    return len(full) - full.index(True) - full[::-1].index(True) if any(full) else 0
