"""Rotations printed with two or three decimals: how far their digits let them be from one, and the nearest."""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from typing import TypeAlias

from dhcli.algebra.floats import Floats
from dhcli.errors import plural
from dhcli.geometry.vectors import cross
from dhcli.notation.tree import Expr, Number, number
from dhcli.notation.walk import symbols, walk

PLACES = 12
"""Decimals of the nearest rotation."""

SHARP = 1e-9
"""A matrix nearer to a rotation than this is taken as it stands [1]."""

Matrix: TypeAlias = list[list[float]]
Rows: TypeAlias = Sequence[Sequence[Expr]]
_ROUNDS = 30
"""Averages: each of the last ones doubles the digits."""

_FLAT = 1e-3
"""Columns with a smaller determinant are nowhere near a rotation."""


def digit_slack(rows: Rows) -> float:
    """Half a unit of the last decimal of a matrix that is printed with decimals; 0 if it has none.

    The most decimals in it count for all, for 0.5 stands in a table of two decimals for 0.50.
    """
    places = [
        node.places
        for row in rows
        for entry in row[:3]
        for node in walk(entry)
        if type(node) is Number and node.places is not None
    ]
    return 0.5 * 10.0 ** -max(places) if places else 0.0


def sharp_rows(rows: Rows) -> tuple[Rows, str]:
    """A matrix of decimals with the nearest rotation in it, and a remark; itself and nothing where it is sharp.

    Args:
        rows: Three rows of direction cosines and a length, numbers whose columns are a rotation to their digits.
    """
    typed = [list(row[:3]) for row in rows]
    slack = digit_slack(rows)
    if not slack or any(symbols(entry) for row in typed for entry in row):
        return rows, ""
    values = [[Floats().value(entry) for entry in row] for row in typed]
    if _distance(values) <= SHARP:
        return rows, ""
    found = nearest_rotation(values)
    if found is None:
        return rows, ""
    sharp = tuple(
        (*(_entry(entry, value) for entry, value in zip(row, near, strict=True)), *whole[3:])
        for row, near, whole in zip(typed, found, rows, strict=True)
    )
    decimals = round(-math.log10(2 * slack))
    apart = max(abs(x - y) for row, near in zip(values, found, strict=True) for x, y in zip(row, near, strict=True))
    kind = f"a matrix with {plural(decimals, 'decimal')} is a rotation to its digits"
    return sharp, f"{kind}; the nearest rotation is taken, an entry of it {apart:.2g} away"


def _entry(typed: Expr, value: float) -> Expr:
    """An entry of the nearest rotation; 0 and ±1 that were typed stay exact."""
    if isinstance(typed, Number) and typed.value.denominator == 1 and abs(float(typed.value) - value) < SHARP:
        return typed
    return number(Fraction(f"{value:.{PLACES}f}"), PLACES)


def _distance(rows: Matrix) -> float:
    """How far a matrix is from orthonormal columns."""
    return max(abs(sum(rows[k][i] * rows[k][j] for k in range(3)) - (i == j)) for i in range(3) for j in range(i, 3))


def nearest_rotation(rows: Sequence[Sequence[float]]) -> tuple[tuple[float, ...], ...] | None:
    """The rotation nearest to nine numbers, shape (3, 3), or None where they are nearer to a reflection or flat.

    The matrix is averaged with its inverse's transpose until nothing changes.
    Source: N. J. Higham, Computing the polar decomposition, SIAM J. Sci. Stat. Comput. 7, 1986.
    """
    now = tuple(tuple(row[:3]) for row in rows[:3])
    for _ in range(_ROUNDS):
        a, b, c = now
        cofactors = (cross(b, c), cross(c, a), cross(a, b))
        size = sum(x * y for x, y in zip(a, cofactors[0], strict=True))
        if not size > _FLAT:
            return None
        pairs = zip(now, cofactors, strict=True)
        now = tuple(tuple((x + y / size) / 2 for x, y in zip(one, other, strict=True)) for one, other in pairs)
    return now
