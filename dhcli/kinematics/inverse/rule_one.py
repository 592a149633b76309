"""The rule ONE: a joint is read off equations in which nothing else is unknown."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from dhcli.kinematics.inverse.rows import NOISE, Rows
from dhcli.kinematics.inverse.steps import One
from dhcli.kinematics.inverse.weak import from_all

if TYPE_CHECKING:
    from dhcli.kinematics.inverse.arm import Array, Flags

WEAK = 1e-4
"""Where an equation falls below this share of its ordinary size, all equations are used."""

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


def read_off(rows: Rows, step: One, draws: Array) -> Rows:
    """Candidates with one joint more.

    Args:
        rows: The candidates.
        step: The joint and its equations.
        draws: Values to try where the joint turns out to be free.
    """
    joint = step.joint
    if not len(rows):
        return known_as(rows, joint, np.empty(0), np.empty(0))
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        strong, found = _ordinary(rows, step)
    if strong.all():
        return found
    weak = from_all(rows.take(~strong), step, draws)
    return found.joined(weak)


def known_as(rows: Rows, joint: int, u: Array, v: Array) -> Rows:
    """The same rows with one joint known."""
    rows.known[joint] = u, v
    return rows


def _ordinary(rows: Rows, step: One) -> tuple[Flags, Rows]:
    """Which rows the chosen equations serve, and these with the joint known."""
    k = [np.broadcast_arrays(*rows.coefficients(e, step.joint), rows.loss)[:3] for e in step.equations]
    sizes = [equation.size for equation in step.equations]
    if step.kind == "both":
        return _both(rows, step.joint, k, sizes)
    (e, a, b), size = k[0], sizes[0]
    if step.kind == "length":
        strong = np.abs(a) > WEAK * size
        at = _strong(rows, strong)
        d = -e[strong] / a[strong]
        at.loss = at.loss * size / np.abs(a[strong])
        return strong, known_as(at, step.joint, d, 0.5 * d * d)
    if step.kind == "lengths":
        return _lengths(rows, step.joint, (e, a, b), size)
    r = np.hypot(a, b)
    strong = r > WEAK * size
    at = _strong(rows, strong)
    a, b, e, r = a[strong] / r[strong], b[strong] / r[strong], -e[strong] / r[strong], r[strong]
    at.loss = at.loss * size / r
    if step.kind == "opposite":
        return strong, two_ways(at, step.joint, (-b, a), (b, -a))
    return strong, pair(at, step.joint, a, b, e)


def _strong(rows: Rows, strong: Flags) -> Rows:
    """The rows that the chosen equations serve; all of them as they are."""
    return rows.take(np.arange(len(rows))) if strong.all() else rows.take(strong)


def _both(rows: Rows, joint: int, k: list[tuple[Array, ...]], sizes: list[float]) -> tuple[Flags, Rows]:
    (e1, a1, b1), (e2, a2, b2) = k
    det = a1 * b2 - b1 * a2
    share = np.abs(det) / (sizes[0] * sizes[1])
    strong = share > WEAK
    c, s = (b1 * e2 - e1 * b2) / det, (e1 * a2 - a1 * e2) / det
    h = np.hypot(c, s)
    kept = strong & (np.abs(h - 1) < STRAY)
    whole = kept.all()
    at = rows.take(np.arange(len(rows)) if whole else kept)
    c, s = c / h, s / h
    at.loss = at.loss / np.minimum(share if whole else share[kept], 1)
    return strong, known_as(at, joint, c if whole else c[kept], s if whole else s[kept])


def _lengths(rows: Rows, joint: int, k: tuple[Array, Array, Array], size: float) -> tuple[Flags, Rows]:
    e, a, b = k
    strong = np.abs(b) > WEAK * size
    at, e, a, b = _strong(rows, strong), e[strong], a[strong], b[strong]
    return strong, slides(at, joint, e / b, a / b)


def slides(rows: Rows, joint: int, e: Array, a: Array) -> Rows:
    """Both roots of `e + a d + d²/2 = 0`."""
    square = a * a - 2 * e
    scale = np.maximum(np.maximum(a * a, np.abs(e)), NOISE)
    real = square > OUTSIDE * scale
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
