"""Cosines and sines of exact angles, in one shape.

Right angles become signs and swapped functions, multiples of 30° and 45° exact roots, and the angle that stays in a
cosine or sine starts with a plus.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal

from dhcli.notation.angle import FULL_TURN, Angle, Rational
from dhcli.notation.tree import HALF, ZERO, Expr, Number, Trig, multiply, negate, power


def cosine(angle: Angle) -> Expr:
    """Cosine of an exact angle: right angles become signs and swapped functions, 30° and 45° become roots."""
    quarters, rest = _reduce(angle)
    return (_cos_of, _minus_sin_of, _minus_cos_of, _sin_of)[quarters](rest)


def sine(angle: Angle) -> Expr:
    """Sine of an exact angle; see `cosine`."""
    quarters, rest = _reduce(angle)
    return (_sin_of, _cos_of, _minus_sin_of, _minus_cos_of)[quarters](rest)


def swapped(node: Expr) -> Expr:
    """The sine of an angle for its cosine and back; anything else as it is."""
    if isinstance(node, Trig):
        return sine(node.angle) if node.function == "cos" else cosine(node.angle)
    return node


def _reduce(angle: Angle) -> tuple[int, Angle]:
    """An angle as a number of right angles, 0 to 3, and a rest that holds none."""
    constant = angle.degrees  # most are whole, and to divide fractions takes ten times as long
    if constant.denominator == 1 and constant.numerator % 90 == 0:
        rest = Angle(angle.terms, radians=angle.radians) if constant else angle
        return constant.numerator // 90 % 4, rest
    degrees = angle.degrees % FULL_TURN
    if not angle.terms and not angle.radians:
        return int(degrees // 90), Angle(degrees=degrees % 90)
    return 0, Angle(angle.terms, degrees if degrees <= FULL_TURN // 2 else degrees - FULL_TURN, angle.radians)


_ROOT_HALVES: Mapping[int, tuple[Rational, int]] = {0: (1, 1), 30: (HALF, 3), 45: (HALF, 2), 60: (HALF, 1)}
"""Cosines of 0°, 30°, 45° and 60° as a rational times a square root."""


def _cos_of(rest: Angle) -> Expr:
    return _trig("cos", rest, _ROOT_HALVES.get(int(rest.degrees)) if rest.degrees.denominator == 1 else None)


def _sin_of(rest: Angle) -> Expr:
    if rest.is_zero:
        return ZERO
    return _trig("sin", rest, _ROOT_HALVES.get(90 - int(rest.degrees)) if rest.degrees.denominator == 1 else None)


def _minus_cos_of(rest: Angle) -> Expr:
    return negate(_cos_of(rest))


def _minus_sin_of(rest: Angle) -> Expr:
    return negate(_sin_of(rest))


def _trig(function: Literal["cos", "sin"], rest: Angle, exact: tuple[Rational, int] | None) -> Expr:
    if not rest.terms and not rest.radians and exact is not None:
        value, root = exact
        return multiply(Number(value), power(Number(root), HALF))
    leading = rest.terms[0][1] if rest.terms else rest.radians or rest.degrees
    if leading >= 0:
        return Trig(function, rest)
    flipped = Trig(function, -rest)
    return flipped if function == "cos" else negate(flipped)
