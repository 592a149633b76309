"""Right angles written in radians: 1.5708 rad is 90° to its own digits, and so are -1.5708, 3.1416 and 1.570796327.

Whoever types one means the right angle; taken as it stands, its cosine would be -0.0000036732 and not 0.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from operator import is_

from dhcli.notation.angle import Angle, Rational
from dhcli.notation.dimensions import RADIANS
from dhcli.notation.tree import Expr, Number, Product, Sum, Unit, add, multiply, places_of

MOST_QUARTERS = 8
"""Two turns; beyond them nobody writes a right angle in radians."""

SEEN = 5e-5
"""From here on a result shows a difference: half of the fourth decimal, the last that is shown [rad or m]."""
_QUARTER = Fraction(31415926535897932384626433832795028841971, 2 * 10**40)
_LEAST_PLACES = 2
_MOST_PLACES = 29


class Slight(str):
    """A remark on what no result shows: it is told where a robot is shown, and not each time that it is used."""

    __slots__ = ()


def remark_on(text: str, by: float) -> str:
    """A remark on what was taken for something else, which is slight if that is so near that nobody sees it.

    Args:
        text: The remark.
        by: How far the two are apart [rad], or how far that moves the tip [m].
    """
    return Slight(text) if by < SEEN else text


def right_angle_of(value: Rational, places: int | None) -> int | None:
    """The multiple of 90° that a decimal number of radians is to its digits; None if it is none.

    Args:
        value: The number.
        places: The decimals it is written with; 1.57 has two, and two are the fewest that say enough.
    """
    if places is None or places < _LEAST_PLACES:
        return None
    count = round(value / _QUARTER)
    if not 0 < abs(count) <= MOST_QUARTERS:
        return None
    off = abs(value - count * _QUARTER)
    within = Fraction(1, 10**places) if places > _LEAST_PLACES else Fraction(1, 2 * 10**places)
    return 90 * count if off <= within else None


def with_right_angles(expr: Expr, remarks: list[str]) -> Expr:
    """An angle with multiples of 90° in the place of the decimals that are meant as such.

    Args:
        expr: The expression, units and all.
        remarks: Where to say what was taken for what.
    """
    if isinstance(expr, Sum):
        terms = [with_right_angles(term, remarks) for term in expr.terms]
        return expr if all(map(is_, terms, expr.terms)) else add(*terms)
    match expr:
        case Product((Number(value, places), Unit(name))) if name in RADIANS:
            degrees = right_angle_of(value, places)
            if degrees is not None:
                text = f"{Number(value, places)} rad is taken as {degrees}°, which it is to its digits"
                remarks.append(remark_on(text, float(abs(value - degrees // 90 * _QUARTER))))
                return multiply(Number(degrees), Unit("deg"))
    return expr


def right_angles_among(values: Mapping[str, Angle | Expr], remarks: list[str]) -> dict[str, Angle | Expr]:
    """Values of joints with multiples of 90° in the place of their decimals in radians, for a symbolic result."""
    found = dict(values)
    for name, value in values.items():
        if isinstance(value, Angle) and value.radians and not value.terms and not value.degrees:
            degrees = right_angle_of(value.radians, places_of(value.radians, _MOST_PLACES))
            if degrees is not None:
                found[name] = Angle.in_degrees(degrees)
                remarks.append(
                    f"{name}: {float(value.radians):.16g} rad is taken as {degrees}°, which it is to its digits"
                )
    return found
