"""A few equations with letters, solved as by hand: Cramer's rule."""

from __future__ import annotations

from collections.abc import Sequence

from dhcli.algebra.equality import equal
from dhcli.errors import RobotError
from dhcli.notation.tree import ZERO, Expr, add, multiply, negate, number, power

LARGEST = 3
"""Rows up to which a determinant is written out."""


def determinant(rows: Sequence[Sequence[Expr]], *, signed: bool = True) -> Expr:
    """A determinant, written out by its first row.

    Args:
        rows: As many rows as columns.
        signed: Whether every second product is taken away, as is right.
    """
    if not rows:
        return number(1)
    shares = []
    for k, entry in enumerate(rows[0]):
        if entry != ZERO:
            minor = determinant([[*row[:k], *row[k + 1 :]] for row in rows[1:]], signed=signed)
            share = multiply(entry, minor)
            shares.append(negate(share) if k % 2 and signed else share)
    return add(*shares) if shares else ZERO


def solved(rows: Sequence[Sequence[Expr]], right: Sequence[Expr], whole: Expr | None = None) -> tuple[Expr, ...]:
    """The solution of a few equations by Cramer's rule.

    Args:
        rows: The matrix.
        right: The right-hand sides.
        whole: Its determinant, if it is known in a form that people like.

    Raises:
        RobotError: The determinant is 0.
    """
    below = whole or determinant(rows)
    if equal(below, ZERO):
        raise RobotError("the equations have no single solution")
    found = []
    for k in range(len(rows)):
        changed = [[*row[:k], value, *row[k + 1 :]] for row, value in zip(rows, right, strict=True)]
        found.append(multiply(determinant(changed), power(below, -1)))
    return tuple(found)
