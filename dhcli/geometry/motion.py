"""Rigid motions over any arithmetic: the product, the inverse and the elementary rotation, written once.

A motion is the upper three rows of its homogeneous matrix, `[R | p]`. The integers 0, 1 and -1 are structural, so that
no product with them is computed, in floats as little as in terms.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TypeAlias, TypeVar

from dhcli.algebra.arithmetic import plus, times

N = TypeVar("N")

Rows: TypeAlias = list[list[N | int]]
"""Three rows of a motion, as they are worked on."""

Motion: TypeAlias = Sequence[Sequence[N | int]]
"""The same as they are given; a fourth row is not looked at."""


Dot: TypeAlias = Callable[[Sequence[N | int], Sequence[N | int]], N | int]
"""How a row meets a column: the scalar product of the first three of each."""


def dot(row: Sequence[N | int], column: Sequence[N | int]) -> N | int:
    """The scalar product in any arithmetic; what is structural costs nothing."""
    total = times(row[0], column[0])
    for k in (1, 2):
        total = plus(total, times(row[k], column[k]))
    return total


def identity() -> Rows[N]:
    """No motion."""
    return [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]


def product(left: Motion[N], right: Motion[N], dot: Dot[N] = dot) -> Rows[N]:
    """One motion after another: `[R | p] [S | q] = [R S | p + R q]`.

    Args:
        left: The motion seen from the reference.
        right: The motion seen from where that one leads.
        dot: How rows meet columns; numbers that are known to be no integers can be added up faster.
    """
    x, y, z, offset = zip(*right[:3], strict=True)
    return [[dot(row, x), dot(row, y), dot(row, z), plus(row[3], dot(row, offset))] for row in left[:3]]


def inverse(motion: Motion[N], dot: Dot[N] = dot) -> Rows[N]:
    """The motion that undoes another: `[R^T | -R^T p]`."""
    x, y, z, offset = zip(*motion[:3], strict=True)
    return [[*column, times(-1, dot(column, offset))] for column in (x, y, z)]


def rotate(rows: Rows[N], plane: tuple[int, int], cos: N | int, sin: N | int) -> None:
    """Put the rotation in a coordinate plane in front of a motion, in place.

    Args:
        rows: Rows of a motion, of a rotation, or a single column of one.
        plane: The two coordinates that it mixes, in the order of its positive sense.
        cos: Cosine of the angle.
        sin: Sine of the angle.
    """
    first, second = plane
    upper, lower = rows[first], rows[second]
    minus = times(-1, sin)
    if type(cos) is int and cos == 0:  # a right angle changes the places of the rows
        rows[first], rows[second] = [times(minus, v) for v in lower], [times(sin, u) for u in upper]
        return
    is_plain = type(cos) is not int
    for at, (u, v) in enumerate(zip(upper, lower, strict=True)):  # most entries are 0
        if type(v) is int and v == 0:
            if type(u) is not int or u != 0:
                upper[at], lower[at] = times(cos, u), times(sin, u)
        elif type(u) is int and u == 0:
            upper[at], lower[at] = times(minus, v), times(cos, v)
        elif is_plain and type(u) is not int and type(v) is not int:
            upper[at], lower[at] = cos * u + minus * v, sin * u + cos * v  # type: ignore[operator]
        else:
            upper[at], lower[at] = plus(times(cos, u), times(minus, v)), plus(times(sin, u), times(cos, v))
