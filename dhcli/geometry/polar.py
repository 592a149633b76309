"""The rotation nearest to nine numbers, in plain floats."""

from __future__ import annotations

from collections.abc import Sequence

_ROUNDS = 30
"""Averages: each of the last ones doubles the digits."""

_FLAT = 1e-3
"""Columns with a smaller determinant are nowhere near a rotation."""


def nearest_rotation(rows: Sequence[Sequence[float]]) -> tuple[tuple[float, ...], ...] | None:
    """The rotation nearest to nine numbers, shape (3, 3), or None where they are nearer to a reflection or flat.

    The matrix is averaged with its inverse's transpose until nothing changes.
    Source: N. J. Higham, Computing the polar decomposition, SIAM J. Sci. Stat. Comput. 7, 1986.
    """
    now = tuple(tuple(row[:3]) for row in rows[:3])
    for _ in range(_ROUNDS):
        a, b, c = now
        cofactors = (_cross(b, c), _cross(c, a), _cross(a, b))
        size = sum(x * y for x, y in zip(a, cofactors[0], strict=True))
        if not size > _FLAT:
            return None
        pairs = zip(now, cofactors, strict=True)
        now = tuple(tuple((x + y / size) / 2 for x, y in zip(one, other, strict=True)) for one, other in pairs)
    return now


def _cross(one: Sequence[float], other: Sequence[float]) -> tuple[float, float, float]:
    (a, b, c), (d, e, f) = one, other
    return b * f - c * e, c * d - a * f, a * e - b * d
