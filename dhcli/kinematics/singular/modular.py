"""Small matrices modulo a prime: determinant, rank, null space; and roots of quadratics."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeAlias

from dhcli.algebra.residues import Field, random_below

Table: TypeAlias = list[list[int]]
"""Rows of residues."""


def echelon(rows: Sequence[Sequence[int]], field: Field) -> tuple[Table, list[int], int]:
    """The reduced echelon form, its pivot columns, and the determinant of the pivots with the sign of the swaps."""
    prime = field.prime
    table = [[entry % prime for entry in row] for row in rows]
    pivots: list[int] = []
    product = 1
    for column in range(len(table[0]) if table else 0):
        top = len(pivots)
        found = next((k for k in range(top, len(table)) if table[k][column]), None)
        if found is None:
            continue
        if found != top:
            table[top], table[found] = table[found], table[top]
            product = -product
        product = product * table[top][column] % prime
        inverse = field.inverse(table[top][column])
        table[top] = [entry * inverse % prime for entry in table[top]]
        for k, row in enumerate(table):
            if k != top and row[column]:
                share = row[column]
                table[k] = [(a - share * b) % prime for a, b in zip(row, table[top], strict=True)]
        pivots.append(column)
        if len(pivots) == len(table):
            break
    return table, pivots, product % prime


def determinant(rows: Sequence[Sequence[int]], field: Field) -> int:
    """The determinant of a square matrix."""
    _, pivots, product = echelon(rows, field)
    return product if len(pivots) == len(rows) else 0


def rank(rows: Sequence[Sequence[int]], field: Field) -> int:
    """The rank."""
    return len(echelon(rows, field)[1])


def null_space(rows: Sequence[Sequence[int]], field: Field) -> Table:
    """A basis of the vectors x with A x = 0, in reduced form."""
    table, pivots, _ = echelon(rows, field)
    count = len(rows[0]) if rows else 0
    basis = []
    for free in (k for k in range(count) if k not in pivots):
        vector = [0] * count
        vector[free] = 1
        for row, pivot in zip(table, pivots, strict=False):
            vector[pivot] = -row[free] % field.prime
        basis.append(vector)
    return basis


def cross(a: Sequence[int], b: Sequence[int], prime: int) -> tuple[int, int, int]:
    """The cross product."""
    return (
        (a[1] * b[2] - a[2] * b[1]) % prime,
        (a[2] * b[0] - a[0] * b[2]) % prime,
        (a[0] * b[1] - a[1] * b[0]) % prime,
    )


def dot(a: Sequence[int], b: Sequence[int], prime: int) -> int:
    """The scalar product."""
    return sum(x * y for x, y in zip(a, b, strict=True)) % prime


def minus(a: Sequence[int], b: Sequence[int], prime: int) -> tuple[int, int, int]:
    """The difference of two points."""
    x, y, z = ((u - v) % prime for u, v in zip(a, b, strict=True))
    return x, y, z


def square_root(value: int, field: Field) -> int | None:
    """A root of a residue, or None where it has none; by Cipolla, with a random start."""
    prime = field.prime
    value %= prime
    if not value:
        return 0
    if pow(value, (prime - 1) // 2, prime) != 1:
        return None
    while True:
        start = random_below(prime)
        outside = (start * start - value) % prime
        if outside and pow(outside, (prime - 1) // 2, prime) != 1:
            break
    result, power, exponent = (1, 0), (start, 1), (prime + 1) // 2
    while exponent:
        if exponent & 1:
            result = _times(result, power, outside, prime)
        power = _times(power, power, outside, prime)
        exponent >>= 1
    return result[0]


def _times(a: tuple[int, int], b: tuple[int, int], square: int, prime: int) -> tuple[int, int]:
    """A product of numbers x + y·√square."""
    return (a[0] * b[0] + a[1] * b[1] % prime * square) % prime, (a[0] * b[1] + a[1] * b[0]) % prime
