"""Whether a matrix that somebody typed is a rigid pose at all."""

from __future__ import annotations

from dhcli.algebra.equality import equal
from dhcli.algebra.floats import Floats
from dhcli.kinematics.moves import Fixed
from dhcli.notation.tree import ONE, ZERO, Expr, add, multiply
from dhcli.notation.walk import symbols

LOOSE = 1e-3
"""How far the cosines of a matrix typed with decimals may be from a rotation."""


def not_a_rotation(move: Fixed) -> str:
    """What keeps the matrix from being a pose, in words; empty if nothing does."""
    columns = [[row[i] for row in move.rows] for i in range(3)]
    for i in range(3):
        for j in range(i, 3):
            dot = add(*(multiply(p, q) for p, q in zip(columns[i], columns[j], strict=True)))
            if not _agree(dot, ONE if i == j else ZERO):
                if i == j:
                    return f"column {i + 1} is not a unit vector"
                return f"columns {i + 1} and {j + 1} are not perpendicular"
    cross = [
        add(
            multiply(columns[0][(k + 1) % 3], columns[1][(k + 2) % 3]),
            -multiply(columns[0][(k + 2) % 3], columns[1][(k + 1) % 3]),
        )
        for k in range(3)
    ]
    if not all(_agree(c, column) for c, column in zip(cross, columns[2], strict=True)):
        return "the columns are left-handed"
    return ""


def _agree(first: Expr, second: Expr) -> bool:
    if symbols(first) or symbols(second):
        return equal(first, second)
    return abs(Floats().value(first) - Floats().value(second)) <= LOOSE
