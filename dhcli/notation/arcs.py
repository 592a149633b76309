"""Angles by inverse functions of numbers: `acos(1/2)` is 60°, `atan2(24 mm, 128 mm)` an angle in radians.

An angle that is a multiple of 30° or 45° is found exactly; any other is the decimal of 16 digits that a float is.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from fractions import Fraction

from dhcli.notation.angle import Angle, Rational
from dhcli.notation.dimensions import DimensionError, check_is, has_units, in_metres
from dhcli.notation.tree import Call, Constant, Expr, Number, Power, Product, Sum, Trig, multiply, power
from dhcli.notation.walk import symbols

_SQUARES_OF_COSINES: Mapping[Rational, int] = {0: 90, Fraction(1, 4): 60, Fraction(1, 2): 45, Fraction(3, 4): 30, 1: 0}
"""The acute angle in degrees by the square of its cosine."""

_SQUARES_OF_TANGENTS: Mapping[Rational, int] = {0: 0, Fraction(1, 3): 30, 1: 45, 3: 60}
"""The acute angle in degrees by the square of its tangent."""

_FLOATS = {"acos": math.acos, "asin": math.asin, "atan": math.atan, "tan": math.tan, "cos": math.cos, "sin": math.sin}


def arc(call: Call) -> Angle:
    """The angle that an inverse function of constants is.

    Args:
        call: acos, asin, atan or atan2; lengths in it may have units.

    Raises:
        DimensionError: A name stands in it, it is not defined there, or lengths and numbers are mixed.
    """
    names = sorted(symbols(call))
    if names:
        hint = f"give the angle a name among the parameters, off: {call}"
        raise DimensionError(f"{call} has no value here, for {', '.join(names)} is a name", hint)
    if has_units(call):
        check_is(call, Fraction(0))
    arguments = [in_metres(argument) for argument in call.arguments]
    exact = _exact(call.function, arguments)
    if exact is not None:
        return Angle(degrees=exact)
    values = [constant(argument) for argument in arguments]
    try:
        found = math.atan2(*values) if call.function == "atan2" else _FLOATS[call.function](values[0])
    except (ValueError, OverflowError):
        found = math.nan
    if not math.isfinite(found):
        raise DimensionError(f"{call} is not a real number", "acos and asin take numbers from -1 to 1")
    return Angle(radians=Fraction(repr(found)))


def constant(expr: Expr) -> float:
    """The value of an expression without names; NaN where it is not a real number."""
    try:
        return _value(expr)
    except (ValueError, ZeroDivisionError, OverflowError):
        return math.nan


def _value(expr: Expr) -> float:
    match expr:
        case Number(value):
            return float(value)
        case Constant():
            return math.pi
        case Trig(function, angle):
            return _FLOATS[function](angle.constant())
        case Sum(terms):
            return math.fsum(map(_value, terms))
        case Product(factors):
            return math.prod(map(_value, factors))
        case Power(base, exponent):
            return math.pow(_value(base), float(exponent))
        case Call(function, arguments):
            values = [_value(argument) for argument in arguments]
            return math.atan2(*values) if function == "atan2" else _FLOATS[function](values[0])
    return math.nan


def _exact(function: str, arguments: list[Expr]) -> Rational | None:
    """The angle in degrees if it is a multiple of 30° or 45°, known from exact squares."""
    squares = [_square(argument) for argument in arguments]
    if None in squares:
        return None
    signs = [
        math.copysign(1, constant(argument)) if square else 0
        for argument, square in zip(arguments, squares, strict=True)
    ]
    first = squares[0] or 0
    if function in ("acos", "asin"):
        acute = _SQUARES_OF_COSINES.get(first)
        if acute is None:
            return None
        turned = acute if signs[0] >= 0 else 180 - acute
        return turned if function == "acos" else 90 - turned
    second = (squares[1] or 0) if function == "atan2" else 1
    side = signs[1] if function == "atan2" else 1
    if second == 0:
        return 90 * int(signs[0]) if first else 0
    acute = _SQUARES_OF_TANGENTS.get(Fraction(first, second))
    if acute is None:
        return None
    turned = acute if side > 0 else 180 - acute
    return turned if signs[0] >= 0 else -turned


def _square(expr: Expr) -> Rational | None:
    """The square of a constant, if it is rational."""
    try:
        squared = multiply(expr, expr) if not isinstance(expr, Power) else power(expr.base, expr.exponent * 2)
    except (ZeroDivisionError, OverflowError):
        return None
    return squared.value if isinstance(squared, Number) else None
