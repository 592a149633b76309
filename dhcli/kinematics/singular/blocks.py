"""The finest block-triangular form of a pattern of zeros."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeAlias

Block: TypeAlias = tuple[tuple[int, ...], tuple[int, ...]]
"""The rows and the columns of a square block on the diagonal."""


def blocks_of(pattern: Sequence[int], size: int) -> tuple[Block, ...] | None:
    """The irreducible diagonal blocks of a square matrix, of which its determinant is the product, up to sign.

    Args:
        pattern: For each row the columns that are not zero, as bits.
        size: How many rows and columns there are.

    Returns:
        The blocks, in the order of their first columns, or None if the determinant is zero by the pattern alone.

    Source: Dulmage and Mendelsohn; a perfect matching, and the strong components of the graph it gives.
    """
    row_of = _matching(pattern, size)
    if row_of is None:
        return None
    reach = [pattern[row_of[column]] | 1 << column for column in range(size)]
    for middle in range(size):
        for column in range(size):
            if reach[column] >> middle & 1:
                reach[column] |= reach[middle]
    blocks = []
    left = set(range(size))
    while left:
        first = min(left)
        members = tuple(c for c in sorted(left) if reach[first] >> c & 1 and reach[c] >> first & 1)
        left.difference_update(members)
        blocks.append((tuple(sorted(row_of[c] for c in members)), members))
    return tuple(blocks)


def _matching(pattern: Sequence[int], size: int) -> list[int] | None:
    """For each column a row of its own in which it is not zero, or None if there is no such choice."""
    row_of = [-1] * size

    def place(row: int, tried: set[int]) -> bool:
        for column in range(size):
            if pattern[row] >> column & 1 and column not in tried:
                tried.add(column)
                if row_of[column] < 0 or place(row_of[column], tried):
                    row_of[column] = row
                    return True
        return False

    return row_of if all(place(row, set()) for row in range(size)) else None
