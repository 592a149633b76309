"""Rotations printed with two or three decimals: how far their digits let them be from one, and the nearest."""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from typing import TypeAlias

from dhcli.algebra.floats import Floats
from dhcli.errors import plural
from dhcli.geometry.polar import nearest_rotation
from dhcli.notation.tree import Expr, Number, number
from dhcli.notation.walk import symbols, walk

PLACES = 12
"""Decimals of the nearest rotation."""

SHARP = 1e-9
"""A matrix nearer to a rotation than this is taken as it stands [1]."""

Matrix: TypeAlias = list[list[float]]
Rows: TypeAlias = Sequence[Sequence[Expr]]


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
