"""Which matrices were seen before: of thousands that mistakes lead to, many are the same but for rounding."""

from __future__ import annotations

import math
from bisect import bisect_left, bisect_right
from operator import mul

from dhcli.checking.diagnosis.work import Matrix

SAME = 1e-9
"""Relative difference up to which two entries are the same."""

_WEIGHTS = tuple(math.sqrt(k + 2) for k in range(64))
"""What the entries count in the number of a matrix: those that have changed places have another sum."""


class Seen:
    """Matrices of one shape, kept by one number of each, so that a further one is compared with few of them."""

    def __init__(self) -> None:
        """None yet."""
        self._sums: list[float] = []
        self._matrices: list[Matrix[float]] = []

    def is_new(self, matrix: Matrix[float]) -> bool:
        """Whether it is none that was seen before; from now on it was."""
        entries = [entry for row in matrix for entry in row]
        total = sum(map(mul, _WEIGHTS, entries))
        width = 2 * SAME * (sum(_WEIGHTS[: len(entries)]) + sum(map(mul, _WEIGHTS, map(abs, entries))))
        if not math.isfinite(total):
            return True  # not even the same as itself
        first, last = bisect_left(self._sums, total - width), bisect_right(self._sums, total + width)
        if any(same(matrix, other) for other in self._matrices[first:last]):
            return False
        place = bisect_right(self._sums, total, first, last)
        self._sums.insert(place, total)
        self._matrices.insert(place, matrix)
        return True


def same(first: Matrix[float], second: Matrix[float]) -> bool:
    """Whether two matrices are the same but for rounding."""
    for row, other in zip(first, second, strict=True):
        for a, b in zip(row, other, strict=True):
            if not abs(a - b) <= SAME * (1 + abs(b)):
                return False
    return True
