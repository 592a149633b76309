"""Frames, points on paper, and what drawing needs of vectors besides what `geometry.vectors` has."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple, TypeAlias

from dhcli.geometry.vectors import ORIGIN, Vector, cross, length, plus, scaled

Flat: TypeAlias = tuple[float, float]
"""A point on paper: to the right, and down."""

TINY = 1e-12
"""Below this a direction is no direction."""


class Frame(NamedTuple):
    """A frame: the directions of its axes, and its origin, all seen from the first one."""

    x: Vector
    y: Vector
    z: Vector
    origin: Vector

    def point(self, local: Vector) -> Vector:
        """Where a point of this frame is."""
        return plus(self.direction(local), self.origin)

    def direction(self, local: Vector) -> Vector:
        """Where a direction of this frame points."""
        a, b, c = local
        (x1, x2, x3), (y1, y2, y3), (z1, z2, z3), _ = self
        return a * x1 + b * y1 + c * z1, a * x2 + b * y2 + c * z2, a * x3 + b * y3 + c * z3


WORLD = Frame((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0), ORIGIN)


def unit(a: Vector) -> Vector:
    """Direction of length one; no length stays none."""
    size = length(a)
    return scaled(a, 1 / size) if size > TINY else ORIGIN


def sideways(axis: Vector) -> Vector:
    """Some direction of length one at right angles to an axis, always the same."""
    other: Vector = (1.0, 0.0, 0.0) if abs(axis[0]) < 0.6 * length(axis) else (0.0, 1.0, 0.0)
    return unit(cross(axis, other))


def centroid(points: Sequence[Vector]) -> Vector:
    """The middle of some points."""
    return scaled((sum(p[0] for p in points), sum(p[1] for p in points), sum(p[2] for p in points)), 1 / len(points))


def middle(a: Vector, b: Vector) -> Vector:
    """The point halfway."""
    return (a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2
