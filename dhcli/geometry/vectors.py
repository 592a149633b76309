"""Vectors of three floats, without numpy: where there are a few of them, this is faster and costs no import."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TypeAlias

Vector: TypeAlias = tuple[float, float, float]

ORIGIN: Vector = (0.0, 0.0, 0.0)
UNITS: tuple[Vector, Vector, Vector] = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
ALONG = dict(zip("xyz", UNITS, strict=True))
"""The unit vector along each axis."""


def axis_called(text: str) -> Vector | None:
    """The unit vector along `x`, `+z` or `-y`; None of any other text."""
    sign, letter = (-1.0, text[1:]) if text.startswith("-") else (1.0, text.removeprefix("+"))
    return scaled(ALONG[letter], sign) if letter in ALONG else None


def dot(a: Sequence[float], b: Sequence[float]) -> float:
    """Scalar product."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Sequence[float], b: Sequence[float]) -> Vector:
    """Vector product."""
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def plus(a: Vector, b: Vector, times: float = 1.0) -> Vector:
    """A vector and a multiple of another."""
    return a[0] + times * b[0], a[1] + times * b[1], a[2] + times * b[2]


def minus(a: Vector, b: Vector) -> Vector:
    """Difference."""
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def scaled(a: Vector, factor: float) -> Vector:
    """A multiple of a vector."""
    return a[0] * factor, a[1] * factor, a[2] * factor


def length(a: Vector) -> float:
    """Euclidean length."""
    return math.hypot(*a)


def across(a: Vector, unit: Vector) -> Vector:
    """The part of a vector that is perpendicular to a unit vector."""
    return plus(a, unit, -dot(a, unit))


def within(vector: Vector, spread: tuple[Vector, ...]) -> Vector:
    """The part of a vector in the span of perpendicular unit vectors."""
    total = ORIGIN
    for unit in spread:
        total = plus(total, unit, dot(vector, unit))
    return total


def angle_about(axis: Vector, start: Vector, end: Vector) -> float:
    """Angle about a unit axis that turns one vector into the half-plane of another; 0 where that says nothing."""
    start, end = across(start, axis), across(end, axis)
    return math.atan2(dot(axis, cross(start, end)), dot(start, end))


def facing(direction: Sequence[float]) -> tuple[tuple[float, float, float], ...]:
    """A rotation whose z axis has a direction, shape (3, 3); x is square to it and to the axis it is farthest from.

    Args:
        direction: Three parts, not all of them 0.
    """
    size = math.hypot(*direction)
    a, b, c = direction
    z = a / size, b / size, c / size
    nearest = min(range(3), key=lambda i: abs(z[i]))
    a, b, c = cross(UNITS[nearest], z)
    length = math.hypot(a, b, c)
    x = a / length, b / length, c / length
    return tuple(zip(x, cross(z, x), z, strict=True))
