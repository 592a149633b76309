"""One root or two of an equation in one joint, as rows with this joint known."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from dhcli.kinematics.inverse.rows import NOISE, Rows

if TYPE_CHECKING:
    from dhcli.kinematics.inverse.arm import Array, Flags

STRAY = 0.5
"""A cosine and a sine whose squares make less or more than 1 by about this much belong to no angle."""

SNAP = 1e-14
"""A square below this is a double root: two angles that rounding alone tells apart."""

DOUBTFUL = 30.0
"""A square below this many times the rounding may be that of a double root."""

OUTSIDE = -1e-6
"""A square above this may still be a double root."""

BASE = 8
"""Digits of a path: choices at one step."""


def known_as(rows: Rows, joint: int, u: Array, v: Array) -> Rows:
    """The same rows with one joint known."""
    rows.known[joint] = u, v
    return rows


def slides(rows: Rows, joint: int, e: Array, a: Array) -> Rows:
    """Both roots of `e + a d + d²/2 = 0`."""
    square = a * a - 2 * e
    scale = np.maximum(np.maximum(a * a, np.abs(e)), NOISE)
    real = square > np.minimum(OUTSIDE * scale, -DOUBTFUL * rows.loss)
    at, a, square, scale = rows.take(real), a[real], square[real], scale[real]
    h = np.sqrt(np.where(square < SNAP * scale, 0, square))
    at.loss = at.loss / np.maximum(h / np.sqrt(scale), np.sqrt(at.loss))
    d1, d2 = h - a, -h - a
    return two_ways(at, joint, (d1, 0.5 * d1 * d1), (d2, 0.5 * d2 * d2), h > 0)


def pair(rows: Rows, joint: int, a: Array, b: Array, e: Array) -> Rows:
    """Both angles of `a c + b s = e`, with a² + b² = 1; one where they are one within rounding."""
    square = 1 - e * e
    real = square > np.minimum(OUTSIDE, -DOUBTFUL * rows.loss)
    if not real.all():
        rows, a, b, e, square = rows.take(real), a[real], b[real], e[real], square[real]
    double = square < SNAP
    h = np.sqrt(np.where(double, 0, square))
    once = np.where(double, np.sign(e), e)
    loss, rows.loss = rows.loss, rows.loss / np.maximum(h, np.sqrt(rows.loss))
    both = two_ways(rows, joint, (a * once - b * h, b * once + a * h), (a * once + b * h, b * once - a * h), ~double)
    doubtful = ~double & (square < np.minimum(DOUBTFUL * loss, -OUTSIDE))
    if not doubtful.any():
        return both
    # rounding may have split a double root: between the two stands the one that further equations may vanish at
    middle = rows.take(doubtful)
    middle.path = middle.path * BASE + 2
    sign = np.sign(e[doubtful])
    return both.joined(known_as(middle, joint, a[doubtful] * sign, b[doubtful] * sign))


def two_ways(
    rows: Rows,
    joint: int,
    first: tuple[Array, Array],
    second: tuple[Array, Array],
    apart: Flags | None = None,
) -> Rows:
    """Each row twice, with one root and with the other where they are two."""
    count = np.arange(len(rows))
    again = count if apart is None or apart.all() else count[apart]
    both = rows.take(np.concatenate([count, again]))
    both.path = both.path * BASE
    both.path[len(count) :] += 1
    u, v = (
        np.concatenate([one, two if again is count else two[again]]) for one, two in zip(first, second, strict=True)
    )
    return known_as(both, joint, u, v)
