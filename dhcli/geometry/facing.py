"""A rotation of which one axis is given."""

from __future__ import annotations

import math
from collections.abc import Sequence

from dhcli.geometry.vectors import UNITS, cross


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
