"""Dimensions: which expression is an angle, which a length, and what its units mean.

Inside dhcli lengths are metres and constant angles exact degrees or radians; units exist only in what people write.
"""

from __future__ import annotations

import math
from typing import Literal

from dhcli.notation.angle import ONCE, ZERO, Angle, Rational, magnitude
from dhcli.notation.dimensions import (
    ANGLE_UNITS,
    INVERSE,
    LENGTH_UNITS,
    RADIANS,
    UNITS,
    DimensionError,
    check_is,
    in_metres,
    is_inverse,
)
from dhcli.notation.tree import (
    MOST_BITS,
    Call,
    Constant,
    Expr,
    Number,
    Power,
    Product,
    Sum,
    Symbol,
    Trig,
    Unit,
    add,
    multiply,
)
from dhcli.notation.walk import symbols, walk
from dhcli.notation.writer import write, write_angle

__all__ = [
    "ANGLE_UNITS",
    "LENGTH_UNITS",
    "RADIANS",
    "UNITS",
    "Bare",
    "DimensionError",
    "has_angle_unit",
    "is_affine",
    "is_inverse",
    "to_angle",
    "to_length",
    "to_plain_length",
    "value_text",
    "with_unit",
]

LARGEST_DEGREES = 1_000_000
"""Largest constant part of an angle [deg]: nearly three thousand turns, more than any joint makes."""

LARGEST_RADIANS = 17_453

LARGEST = 100_000_000
"""Largest number in a length [m] or a plain number."""

Bare = Literal["rad", "deg", "refuse"]
"""What a bare number means where an angle is wanted."""


def to_angle(expr: Expr, *, bare: Bare = "rad") -> Angle:
    """Read an expression as an exact angle.

    Args:
        expr: A sum of names, numbers with `deg`, `°` or `rad`, and multiples of π.
        bare: What a number without a unit means; 0 and multiples of π are always clear.

    Raises:
        DimensionError: A length, a product of angles, or a bare number where `bare` is `refuse`.
    """
    try:
        angle = _angle(expr, bare)
    except OverflowError:
        raise DimensionError("the angle has a number of too many digits", "write it with fewer digits") from None
    for name, part in (*angle.terms, ("°", angle.degrees), ("rad", angle.radians)):
        if part is not ZERO:
            _check_size(name, part.numerator, part.denominator)
    return angle


def to_length(expr: Expr, power: int = 1) -> Expr:
    """Read an expression as a length or plain number: units become metres, angle units are refused.

    Args:
        expr: The expression.
        power: What its units are to be: 1 for those of a length, 2 for those of an area.

    Raises:
        DimensionError: A unit of angle where a length is wanted, an area, units that cancel, or no length at all.
    """
    if type(expr) is Symbol or (type(expr) is Number and -LARGEST <= expr.value.numerator <= LARGEST):
        return expr
    measured = False
    for node in walk(expr):
        if type(node) is Number and magnitude(node.value) > LARGEST:
            raise DimensionError(f"a length or number beyond {LARGEST:,} is not read", "is the unit right?")
        if type(node) is Call or (type(node) is Power and node.exponent.denominator != 1):
            _check_real(node)
        if type(node) is Unit:
            measured = True
            if node.name in ANGLE_UNITS:
                raise DimensionError(f"{node.name} is a unit of angle, a length is wanted", "write 0.4 m or 400 mm")
    if not measured:
        return expr
    check_is(expr, power)
    return in_metres(expr)


def with_unit(expr: Expr, unit: str) -> Expr:
    """An expression of lengths in which a unit stands behind each bare number that is a term by itself.

    Args:
        expr: The expression; names, and numbers with a unit or before a name, stay what they are.
        unit: A unit of length; empty for none.
    """
    if not unit:
        return expr
    measured = any(type(node) is Unit for node in walk(expr))
    terms = expr.terms if type(expr) is Sum else (expr,)
    bare = (Symbol, Unit, Trig)
    found = [t if any(type(n) in bare for n in walk(t)) else multiply(t, Unit(unit)) for t in terms]
    return add(*(found if measured else map(in_metres, found)))


def to_plain_length(expr: Expr, power: int = 1) -> Expr:
    """Read an expression as a length or number that is no angle: `to_length` but for `atan2(1, 2)` and its like.

    Raises:
        DimensionError: As `to_length`, or it is an angle by an inverse function.
    """
    length = to_length(expr, power)
    if is_inverse(expr):
        raise DimensionError("an inverse function is an angle, a length is wanted", "write 0.4 m or 400 mm")
    return length


def has_angle_unit(expr: Expr) -> bool:
    """Whether a unit of angle, or π, stands anywhere in an expression, or it is an angle by an inverse function."""
    return is_inverse(expr) or any(
        isinstance(n, Constant) or (isinstance(n, Unit) and n.name in ANGLE_UNITS) for n in walk(expr)
    )


def is_affine(expr: Expr, name: str) -> bool:
    """Whether a name enters an expression of lengths at most linearly and alone."""
    if isinstance(expr, Symbol | Number | Constant | Unit):
        return True
    if isinstance(expr, Sum):
        return all(is_affine(term, name) for term in expr.terms)
    if isinstance(expr, Product):
        inside = [factor for factor in expr.factors if name in symbols(factor)]
        return len(inside) <= 1 and all(isinstance(f, Symbol | Sum) and is_affine(f, name) for f in inside)
    return name not in symbols(expr)


def value_text(value: Angle | Expr, unit: str = "m") -> str:
    """A value with its unit, as a person would write it: `30°`, `0.3 rad`, `0.4 m`.

    Args:
        value: An exact angle, or a length in metres.
        unit: The unit to write a length in; empty for a bare number.
    """
    if isinstance(value, Angle):
        if value.terms or (value.degrees and value.radians):
            return write_angle(value)
        return f"{float(value.radians):.10g} rad" if value.radians else f"{float(value.degrees):.10g}°"
    if not isinstance(value, Number):
        return f"{write(value)} m"
    return f"{float(value.value / LENGTH_UNITS.get(unit, 1)):.10g} {unit}".rstrip()


def _check_size(name: str, above: int, below: int) -> None:
    """Refuse a part of an angle, above/below, that no joint has: thousands of turns, or hundreds of digits."""
    if below.bit_length() > MOST_BITS or above.bit_length() > MOST_BITS:
        raise DimensionError("the angle has a number of too many digits", "write it with fewer digits")
    if (name == "°" and abs(above) > LARGEST_DEGREES * below) or (
        name == "rad" and abs(above) > LARGEST_RADIANS * below
    ):
        raise DimensionError(f"an angle beyond {LARGEST_DEGREES:,}° is not read", "write an angle within a few turns")


def _angle(expr: Expr, bare: Bare) -> Angle:
    """An angle as it stands, whatever its size."""
    if isinstance(expr, Sum):
        return sum((_angle(term, bare) for term in expr.terms), Angle())
    factors = expr.factors if isinstance(expr, Product) else (expr,)
    scale: Rational = ONCE
    name = unit = ""
    others: list[Expr] = []
    for factor in factors:
        match factor:
            case Number(value):
                scale = value if scale is ONCE else scale * value
            case Sum() | Call() if not others:
                others.append(factor)
            case Symbol() if not name and not unit:
                name = factor.name
            case Unit() if factor.name in ANGLE_UNITS and not unit and not name:
                unit = factor.name
            case Constant() if not name and unit in ("", *RADIANS):
                unit = "pi"
            case Unit() if factor.name in LENGTH_UNITS:
                raise DimensionError(f"{factor.name} is a unit of length, an angle is wanted", "write 30° or 0.5 rad")
            case Unit() if unit == "pi" and factor.name in RADIANS:
                pass
            case _:
                raise DimensionError(*_NO_ANGLE)
    if others:
        return _of_bracket(others[0], name, unit, bare) * scale
    if name:
        return Angle(((name, scale),)) if scale else Angle()
    return _constant(scale, unit or "bare", bare)


_NO_ANGLE = ("an angle is a sum of joint angles and constants", "write theta1 + 90° or pi/2")


def _of_bracket(expr: Expr, name: str, unit: str, bare: Bare) -> Angle:
    """A bracket of angles, or an inverse function; radians may be written behind the latter, for that is what it is."""
    if isinstance(expr, Sum) and not name and not unit:
        return _angle(expr, bare)
    if isinstance(expr, Call) and expr.function in INVERSE and not name and unit in ("", *RADIANS):
        from dhcli.notation.arcs import arc  # few angles are written so

        return arc(expr)
    raise DimensionError(*_NO_ANGLE)


def _check_real(node: Call | Power) -> None:
    """Refuse a root or a function of a constant that is not a real number, such as sqrt(-1) and acos(2)."""
    if type(node) is Power and type(node.base) is Number and node.base.value >= 0:
        return
    from dhcli.notation.arcs import constant

    if not symbols(node) and not math.isfinite(constant(in_metres(node))):
        raise DimensionError(f"{write(node)} is not a real number", "write a number, 0.4 m or 400 mm")


def _constant(scale: Rational, unit: str, bare: Bare) -> Angle:
    if unit == "pi":
        return Angle(degrees=scale * 180)
    if unit == "bare":
        if scale and bare == "refuse":
            shown = float(scale)
            turned = (
                f"{math.radians(shown):.5g}" if abs(shown) > 2 * math.pi else f"{shown:g}"
            )  # nobody means 90 radians
            raise DimensionError(f"the angle {shown:g} has no unit", f"write {shown:g}° or {turned} rad")
        unit = bare
    return Angle(radians=scale) if unit in RADIANS else Angle(degrees=scale)
