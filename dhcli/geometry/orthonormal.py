"""Whether three columns are a rotation: of length one, perpendicular and right-handed, in any arithmetic."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import TypeVar

from dhcli.algebra.arithmetic import times
from dhcli.algebra.equality import equal
from dhcli.algebra.floats import Floats
from dhcli.geometry.motion import dot
from dhcli.geometry.printed import digit_slack
from dhcli.notation.tree import ZERO, Expr
from dhcli.notation.walk import symbols

N = TypeVar("N")

LOOSE = 1e-6
"""How far numbers may be from a rotation beyond what their digits allow."""


def faults(rotation: Sequence[Sequence[N]], agree: Callable[[N | int, N | int], bool]) -> Iterator[tuple[int, ...]]:
    """What keeps columns from being a rotation, one thing after the other.

    Args:
        rotation: Direction cosines, shape (3, 3); what stands behind them in a row is not looked at.
        agree: Whether two numbers are the same.

    Yields:
        The column that has another length than 1; the two that are not perpendicular; all three where they are
        perpendicular unit vectors and left-handed. Columns count from 0.
    """
    columns = [[row[i] for row in rotation[:3]] for i in range(3)]
    found = False
    for i in range(3):
        for j in range(i, 3):
            if not agree(dot(columns[i], columns[j]), int(i == j)):
                found = True
                yield (i,) if i == j else (i, j)
    (a, b, c), (d, e, f), third = columns
    crossed = ((b, c, f, e), (c, a, d, f), (a, b, e, d))
    normal = [dot((p, times(-1, q), 0), (s, r, 0)) for p, q, s, r in crossed]
    if not found and not all(map(agree, normal, third)):
        yield (0, 1, 2)


def not_a_rotation(rows: Sequence[Sequence[Expr]]) -> str:
    """What keeps a matrix that somebody typed from being a pose, in words; empty if nothing does."""
    slack = _slack(rows)

    def agree(first: Expr | int, second: Expr | int) -> bool:
        """Exactly for symbols; numbers may be rounded."""
        one, other = (ZERO + each for each in (first, second))
        if symbols(one) or symbols(other):
            return equal(one, other)
        return abs(Floats().value(one) - Floats().value(other)) <= slack

    match next(faults(rows, agree), ()):
        case (i,):
            return f"column {i + 1} is not a unit vector"
        case (i, j):
            return f"columns {i + 1} and {j + 1} are not perpendicular"
        case (_, _, _):
            return "the columns are left-handed"
    return ""


def _slack(rows: Sequence[Sequence[Expr]]) -> float:
    """How far a product of two columns may be off, where each decimal may be off by half a unit of its last digit.

    That is at most what a dot product may be off, and what an entry of a cross product may from that of a third column.
    """
    half = digit_slack(rows)
    if not half or any(symbols(entry) for row in rows for entry in row[:3]):
        return LOOSE
    largest = max(sum(abs(Floats().value(row[i])) for row in rows[:3]) for i in range(3))
    return half * (2 * largest + 1) + 3 * half * half + LOOSE
