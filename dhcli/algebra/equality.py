"""Whether two expressions are equal for all values of their names."""

from __future__ import annotations

from itertools import islice

from dhcli.algebra.arithmetic import CannotHoldError
from dhcli.algebra.floats import Floats
from dhcli.algebra.points import general
from dhcli.algebra.residues import Residues
from dhcli.notation.tree import Expr
from dhcli.notation.walk import symbols

POINTS = 8
SEED = 20
CLOSE = 1e-9


def equal(first: Expr, second: Expr) -> bool:
    """Decide equality in residues; where those cannot hold a number, at seeded random points in floats.

    A different residue means certainly unequal; an equal one is wrong with probability below 2^-100.
    """
    if first == second:
        return True
    try:
        point = Residues((first, second))
        return point.value(first) == point.value(second)
    except (CannotHoldError, ZeroDivisionError):
        return equal_in_floats(first, second)


def equal_in_floats(first: Expr, second: Expr) -> bool:
    """Whether two expressions agree at seeded random points to nine digits; points where both are NaN say nothing."""
    agreed = 0
    for values in islice(general(symbols(first) | symbols(second), SEED), POINTS):
        over = Floats(values)
        one, other = over.value(first), over.value(second)
        if one != one and other != other:  # noqa: PLR0124  NaN
            continue
        if not abs(one - other) <= CLOSE * max(1.0, abs(one), abs(other)):
            return False
        agreed += 1
    return agreed > 0
