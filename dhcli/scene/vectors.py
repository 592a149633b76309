"""Vectors of three floats, and frames: all that drawing needs of geometry, without numpy."""

from __future__ import annotations

import math
from typing import NamedTuple, TypeAlias

Vec: TypeAlias = tuple[float, float, float]
"""A point or a direction in space."""

Flat: TypeAlias = tuple[float, float]
"""A point on paper: to the right, and down."""

NULL: Vec = (0.0, 0.0, 0.0)
TINY = 1e-12
"""Below this a direction is no direction."""


class Frame(NamedTuple):
    """A frame: the directions of its axes, and its origin, all seen from the first one."""

    x: Vec
    y: Vec
    z: Vec
    origin: Vec

    def point(self, local: Vec) -> Vec:
        """Where a point of this frame is."""
        return add(self.direction(local), self.origin)

    def direction(self, local: Vec) -> Vec:
        """Where a direction of this frame points."""
        a, b, c = local
        (x1, x2, x3), (y1, y2, y3), (z1, z2, z3), _ = self
        return a * x1 + b * y1 + c * z1, a * x2 + b * y2 + c * z2, a * x3 + b * y3 + c * z3


WORLD = Frame((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0), NULL)


def add(a: Vec, b: Vec) -> Vec:
    """Sum."""
    return a[0] + b[0], a[1] + b[1], a[2] + b[2]


def sub(a: Vec, b: Vec) -> Vec:
    """Difference."""
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def scaled(a: Vec, factor: float) -> Vec:
    """Multiple."""
    return a[0] * factor, a[1] * factor, a[2] * factor


def along(start: Vec, direction: Vec, factor: float) -> Vec:
    """A point on a line."""
    return start[0] + factor * direction[0], start[1] + factor * direction[1], start[2] + factor * direction[2]


def dot(a: Vec, b: Vec) -> float:
    """Scalar product."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Vec, b: Vec) -> Vec:
    """Vector product."""
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def norm(a: Vec) -> float:
    """Euclidean length."""
    return math.hypot(*a)


def unit(a: Vec) -> Vec:
    """Direction of length one; no length stays none."""
    length = norm(a)
    return scaled(a, 1 / length) if length > TINY else NULL


def across(axis: Vec) -> Vec:
    """Some direction of length one at right angles to an axis, always the same."""
    other: Vec = (1.0, 0.0, 0.0) if abs(axis[0]) < 0.6 * norm(axis) else (0.0, 1.0, 0.0)
    return unit(cross(axis, other))


def middle(a: Vec, b: Vec) -> Vec:
    """The point halfway."""
    return (a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2
