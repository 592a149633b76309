"""Ranks, determinants and solutions of a few equations in floats, without numpy."""

from __future__ import annotations

import math
from collections.abc import Sequence

from dhcli.errors import RobotError

SMALL = 1e-9
"""A pivot below this share of the largest entry is nothing."""
VANISHED = 1e-9
"""A column shorter than this counts as zero, and two lengths that differ by less of their size as alike."""


def reduced(
    rows: Sequence[Sequence[float]], width: int | None = None
) -> tuple[list[list[float]], list[float], list[int]]:
    """Rows after elimination with pivots from the whole matrix.

    Args:
        rows: The rows.
        width: How many of their columns have pivots; all by default.

    Returns:
        The rows; the pivots with the sign of the exchanges; and which column stands in which place.
    """
    table, pivots = [list(row) for row in rows], []
    width = width if width is not None else len(table[0]) if table else 0
    largest, order = max((abs(value) for row in table for value in row[:width]), default=0.0), list(range(width))
    for k in range(min(len(table), width)):
        r, c = max(
            ((i, j) for i in range(k, len(table)) for j in range(k, width)), key=lambda at: abs(table[at[0]][at[1]])
        )
        if abs(table[r][c]) <= SMALL * largest:
            break
        sign = (-1.0) ** ((r != k) + (c != k))
        table[k], table[r] = table[r], table[k]
        for row in table:
            row[k], row[c] = row[c], row[k]
        order[k], order[c] = order[c], order[k]
        pivots.append(sign * table[k][k])
        for i in range(k + 1, len(table)):
            factor = table[i][k] / table[k][k]
            table[i] = [a - factor * b for a, b in zip(table[i], table[k], strict=True)]
    return table, pivots, order


def rank(rows: Sequence[Sequence[float]]) -> int:
    """The rank of a matrix of floats."""
    return len(reduced(rows)[1])


def determinant_of(rows: Sequence[Sequence[float]]) -> float:
    """The determinant of a square matrix of floats."""
    product, pivots = 1.0, reduced(rows)[1]
    if len(pivots) < len(rows):
        return 0.0
    for pivot in pivots:
        product *= pivot
    return product


def solution(rows: Sequence[Sequence[float]], right: Sequence[float]) -> tuple[float, ...]:
    """The solution of as many equations as unknowns, in floats.

    Raises:
        RobotError: There is none, or more than one.
    """
    size = len(rows)
    table, pivots, order = reduced([[*row, value] for row, value in zip(rows, right, strict=True)], size)
    if len(pivots) < size:
        raise RobotError("the arm is singular at the values given: no joint rates give every velocity")
    found = [0.0] * size
    for k in reversed(range(size)):
        known = sum(table[k][j] * found[order[j]] for j in range(k + 1, size))
        found[order[k]] = (table[k][size] - known) / table[k][k]
    return tuple(found)


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
