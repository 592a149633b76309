"""Rank by singular values, with those kept and dropped next to the border, so that a reader can judge it."""

from __future__ import annotations

import numpy as np

from dhcli.frozen import frozen
from dhcli.geometry.twists import Array

TIGHT = 1e-9
"""Relative to the largest, below this a singular value counts as zero in exact geometry."""


@frozen
class Rank:
    """A rank and what it was decided by.

    Attributes:
        rank: The number of singular values kept.
        kept: The smallest one kept, relative to the largest; None if none was.
        dropped: The largest one dropped, relative to the largest; None if none was.
        values: All singular values, largest first.
    """

    rank: int
    kept: float | None
    dropped: float | None
    values: tuple[float, ...]


def rank_of(matrix: Array, tolerance: float = TIGHT) -> Rank:
    """The rank of a matrix."""
    if not matrix.size:
        return Rank(0, None, None, ())
    return decided(np.asarray(np.linalg.svd(matrix, compute_uv=False), dtype=np.float64), tolerance)


def decided(values: Array, tolerance: float = TIGHT) -> Rank:
    """The rank from singular values, largest first."""
    largest = float(values[0]) if len(values) else 0.0
    if largest < TIGHT:
        return Rank(0, None, None, tuple(map(float, values)))
    rank = int(np.count_nonzero(values > tolerance * largest))
    dropped = float(values[rank]) / largest if rank < len(values) else None
    return Rank(rank, float(values[rank - 1]) / largest, dropped, tuple(map(float, values)))


def spaces(matrix: Array, tolerance: float = TIGHT) -> tuple[Rank, Array, Array]:
    """The rank, and orthonormal bases of the null space (m, k) and of the left null space (rows, c)."""
    rows, columns = matrix.shape
    if not matrix.size:
        return Rank(0, None, None, ()), np.eye(columns), np.eye(rows)
    left, values, right = np.linalg.svd(matrix)
    found = decided(values, tolerance)
    return found, right[found.rank :].T, left[:, found.rank :]


def orthonormal(columns: Array, tolerance: float = TIGHT) -> Array:
    """An orthonormal basis of the span of columns, shape (m, rank)."""
    if not columns.size:
        return np.zeros((columns.shape[0], 0))
    left, values, _ = np.linalg.svd(columns, full_matrices=False)
    return left[:, : decided(values, tolerance).rank]
