"""Whether a matrix that somebody typed is a rigid pose at all."""

from __future__ import annotations

from dhcli.algebra.equality import equal
from dhcli.algebra.floats import Floats
from dhcli.kinematics.moves import Chain, Fixed, Move
from dhcli.kinematics.printed import digit_slack, nearest_rotation
from dhcli.notation.tree import ONE, ZERO, Expr, add, multiply
from dhcli.notation.walk import symbols

LOOSE = 1e-6
"""How far numbers may be from a rotation beyond what their digits allow."""


def not_a_rotation(move: Fixed) -> str:
    """What keeps the matrix from being a pose, in words; empty if nothing does."""
    columns = [[row[i] for row in move.rows] for i in range(3)]
    slack = 2 * 3**0.5 * digit_slack(move) + LOOSE  # a unit of the last digit in each entry of two unit vectors
    for i in range(3):
        for j in range(i, 3):
            dot = add(*(multiply(p, q) for p, q in zip(columns[i], columns[j], strict=True)))
            if not _agree(dot, ONE if i == j else ZERO, slack):
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


def _agree(first: Expr, second: Expr, slack: float) -> bool:
    if symbols(first) or symbols(second):
        return equal(first, second)
    return abs(Floats().value(first) - Floats().value(second)) <= slack
