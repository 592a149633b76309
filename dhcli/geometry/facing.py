"""A rotation of which one axis is given."""

from __future__ import annotations

import math
from collections.abc import Sequence


def facing(direction: Sequence[float]) -> tuple[tuple[float, float, float], ...]:
    """A rotation whose z axis has a direction, shape (3, 3); x is square to it and to the axis it is farthest from.

    Args:
        direction: Three parts, not all of them 0.
    """
    size = math.hypot(*direction)
    z = [part / size for part in direction]
    nearest = min(range(3), key=lambda i: abs(z[i]))
    x = _cross([float(i == nearest) for i in range(3)], z)
    length = math.hypot(*x)
    x = [part / length for part in x]
    return tuple((a, b, c) for a, b, c in zip(x, _cross(z, x), z, strict=True))


def _cross(a: Sequence[float], b: Sequence[float]) -> list[float]:
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
