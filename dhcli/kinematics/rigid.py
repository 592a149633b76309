"""Whether a matrix that somebody typed is a rigid pose at all."""

from __future__ import annotations

from collections.abc import Sequence

from dhcli.algebra.equality import equal
from dhcli.algebra.floats import Floats
from dhcli.kinematics.moves import Chain, Fixed, Move
from dhcli.kinematics.printed import digit_slack, nearest_rotation
from dhcli.notation.tree import ONE, ZERO, Expr, Number, add, multiply
from dhcli.notation.walk import symbols

LOOSE = 1e-6
"""How far numbers may be from a rotation beyond what their digits allow."""


def not_a_rotation(move: Fixed) -> str:
    """What keeps the matrix from being a pose, in words; empty if nothing does."""
    columns = [[row[i] for row in move.rows] for i in range(3)]
    half = digit_slack(move)
    for i in range(3):
        for j in range(i, 3):
            dot = add(*(multiply(p, q) for p, q in zip(columns[i], columns[j], strict=True)))
            if not _agree(dot, ONE if i == j else ZERO, _slack(columns[i], columns[j], half)):
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
    slack = max(_slack(column, column, half) for column in columns) + half
    if not all(_agree(c, column, slack) for c, column in zip(cross, columns[2], strict=True)):
        return "the columns are left-handed"
    return ""


def sharpened(chain: Chain, remarks: list[str] | None) -> Chain:
    """A chain with the nearest rotations in the place of those that are printed with a few decimals.

    Args:
        chain: The moves.
        remarks: Where to say so; None leaves the chain as it is.
    """
    if remarks is None or not any(isinstance(move, Fixed) for move in chain):
        return chain
    moves: list[Move] = []
    for move in chain:
        if not isinstance(move, Fixed) or not_a_rotation(move):
            moves.append(move)
            continue
        sharp, remark = nearest_rotation(move)
        moves.append(sharp)
        remarks += [remark] if remark else []
    return tuple(moves)


def _slack(first: Sequence[Expr], second: Sequence[Expr], half: float) -> float:
    """How far the product of two columns may be off, where each decimal may be off by half a unit of its last digit.

    A column with a decimal in it is printed, and its 1 may be 0.9998; one without is exact.
    """
    if not half or any(symbols(entry) for entry in (*first, *second)):
        return LOOSE
    off, other = (half * any(map(_has_decimals, column)) for column in (first, second))
    if not (off or other):
        return LOOSE
    return other * _size(first) + off * _size(second) + 3 * off * other + LOOSE


def _size(column: Sequence[Expr]) -> float:
    return sum(abs(Floats().value(entry)) for entry in column)


def _has_decimals(expr: Expr) -> bool:
    return isinstance(expr, Number) and expr.places is not None


def _agree(first: Expr, second: Expr, slack: float) -> bool:
    if symbols(first) or symbols(second):
        return equal(first, second)
    return abs(Floats().value(first) - Floats().value(second)) <= slack
