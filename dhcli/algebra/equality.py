"""Whether two expressions are equal for all values of their names."""

from __future__ import annotations

from dhcli.algebra.arithmetic import CannotHoldError
from dhcli.algebra.floats import Floats
from dhcli.algebra.points import Reach, all_round
from dhcli.algebra.residues import Residues
from dhcli.notation.tree import Expr

CLOSE = 1e-9


def equal(first: Expr, second: Expr) -> bool:
    """Decide equality in residues; where those cannot hold a number, at seeded points in floats.

    A different residue means certainly unequal; an equal one is wrong with probability below 2^-100.
    """
    known = equal_in_residues(first, second)
    return equal_in_floats(first, second) if known is None else known


def equal_in_residues(first: Expr, second: Expr) -> bool | None:
    """Whether two expressions are equal, decided in residues; None where those cannot hold a number in them."""
    if first == second:
        return True
    try:
        point = Residues((first, second))
        return point.value(first) == point.value(second)
    except (CannotHoldError, ZeroDivisionError):
        return None


def equal_in_floats(first: Expr, second: Expr, reach: Reach | None = None) -> bool:
    """Whether two expressions agree to nine digits at points all round; where both are NaN, a point says nothing."""
    agreed = 0
    for values in all_round((first, second), reach):
        over = Floats(values)
        one, other = over.value(first), over.value(second)
        if one != one and other != other:  # noqa: PLR0124  NaN
            continue
        if not agree(one, other):
            return False
        agreed += 1
    return agreed > 0


def agree(one: float, other: float) -> bool:
    """Whether two numbers are the same to nine digits; NaN is the same as nothing."""
    return abs(one - other) <= CLOSE * max(1.0, abs(one), abs(other))
