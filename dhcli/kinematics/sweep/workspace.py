"""Where the points of a sweep are, for pictures: how many in each cell, seen from the side and from above."""

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
        sample: Some of the points, evenly among all [m].
        count: How many points there are.
        frame: The frame whose origin, or a point of which, they are.
        reference: The frame that they are seen from.
    """

    half: float
    side: Counts
    top: Counts
    sample: tuple[tuple[float, float, float], ...]
    count: int
    frame: str
    reference: str
