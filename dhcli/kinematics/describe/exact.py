"""Floats that the geometry gives as the exact numbers they stand for; whether they do is proved afterwards."""

from __future__ import annotations

import math
from fractions import Fraction

from dhcli.notation.angle import Angle
from dhcli.notation.tree import HALF, Expr, Number, decimal, multiply, power

CLOSE = 1e-12
"""How far a float may be from an exact number that it is taken for; a few roundings."""

SPELLED = 4e-15
"""How far a float may be from the decimals that are written for it; a foot far away multiplies it."""

_ROOTS = (1, 2, 3, 6)
_LARGEST = 64
_PLACES = 9


def exact_angle(radians: float) -> Angle:
    """An angle in [-π, π] in degrees where it is a round number of them, else in radians.

    >>> exact_angle(-math.pi / 2).degrees
    Fraction(-90, 1)
    """
    degrees = Fraction(round(math.degrees(radians), 6)).limit_denominator(10**6)
    if abs(math.radians(degrees) - radians) <= SPELLED:
        return Angle(degrees=Fraction(180) if degrees == -180 else degrees)  # noqa: PLR2004  the same half turn
    return Angle(radians=Fraction(repr(radians)))


def exact_factor(value: float) -> Expr:
    """A factor of a letter: a fraction of small numbers, with √2, √3 or √6, or the float itself."""
    for root in _ROOTS:
        part = Fraction(value / math.sqrt(root)).limit_denominator(_LARGEST)
        if abs(float(part) * math.sqrt(root) - value) <= CLOSE * max(1.0, abs(value)):
            return multiply(Number(part), power(Number(Fraction(root)), HALF))
    return exact_length(value)


def exact_length(metres: float) -> Number:
    """A length with as few decimals as say it."""
    rounded = round(metres, _PLACES)
    text = repr(rounded if abs(rounded - metres) <= SPELLED * max(1.0, abs(metres)) else metres)
    return decimal(Fraction(text))
