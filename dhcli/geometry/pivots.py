"""Rank by elimination, without numpy: for a few columns on the way to something else."""

from __future__ import annotations

import math

VANISHED = 1e-9
"""A column shorter than this counts as zero, and two lengths that differ by less of their size as alike."""


def pivots(columns: list[list[float]]) -> list[float]:
    """Lengths that columns have across those taken before, longest first: as many as the rank."""
    left, found = columns, []
    while left:
        most = max(map(_length, left))
        longest = next(column for column in left if _length(column) >= most * (1 - VANISHED))  # the first of alike
        size = _length(longest)
        if size < VANISHED:
            break
        found.append(size)
        unit = [x / size for x in longest]
        left = [_across(column, unit) for column in left if column is not longest]
    return found


def _across(column: list[float], unit: list[float]) -> list[float]:
    along = sum(x * y for x, y in zip(column, unit, strict=True))
    return [x - along * y for x, y in zip(column, unit, strict=True)]


def _length(column: list[float]) -> float:
    return math.sqrt(sum(x * x for x in column))
