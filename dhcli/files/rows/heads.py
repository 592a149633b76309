"""The head of a column: a name and a unit, `theta1[deg]`, and what that makes of the numbers under it."""

from __future__ import annotations

import math

from dhcli.errors import Place, Problem, RobotError, did_you_mean
from dhcli.notation.quantity import ANGLE_UNITS, LENGTH_UNITS, RADIANS
from dhcli.regex import regex

_HEAD = regex(r"(?P<name>[^\[(]*)(?:[\[(](?P<unit>[^\])]*)[\])])?")
"""A head without the blanks around it; those inside are taken off the pieces, and nothing is tried twice."""


def name_and_unit(head: str, place: Place | None = None) -> tuple[str, str]:
    """Name and unit of a head, `theta1[deg]`; the unit is empty where none stands.

    Raises:
        RobotError: It is no head.
    """
    match = _HEAD.fullmatch(head.strip())
    if match is None:
        raise RobotError(Problem(f"'{head.strip():.60}' is not read as a column", place, "write theta1 or theta1[deg]"))
    name, unit = match["name"].strip(), (match["unit"] or "").strip()
    if not name:
        hint = "a column of row numbers? pandas leaves it out with index=False; --ignore-columns leaves it aside"
        raise RobotError(Problem("a column has no name", place, hint))
    return name, unit


def factor_of(name: str, unit: str, place: Place | None = None, *, turns: bool) -> tuple[float, float]:
    """What makes radians or metres of a number in a unit; two numbers, because a thousandth is no float.

    Args:
        name: What is measured.
        unit: The unit; radians or metres where it is empty.
        place: Where the unit stands.
        turns: Whether it is an angle; else it is a length.

    Raises:
        RobotError: It is no unit of that.
    """
    unit = unit or ("rad" if turns else "m")
    if turns and unit in ANGLE_UNITS:
        return (1.0, 1.0) if unit in RADIANS else (math.pi, 180.0)
    if not turns and unit in LENGTH_UNITS:
        return float(LENGTH_UNITS[unit].numerator), float(LENGTH_UNITS[unit].denominator)
    known = ("deg", "rad") if turns else tuple(LENGTH_UNITS)
    if unit in ANGLE_UNITS or unit in LENGTH_UNITS:
        kind = "length" if turns else "angle"
        message, hint = f"{unit} is a unit of {kind}, and {name} is {'an angle' if turns else 'a length'}", ""
    else:
        message, hint = f"{unit} is no unit", did_you_mean(unit, known)
    raise RobotError(Problem(message, place, hint or f"write {name}[{known[0]}]"))
