"""Dimensions: which expression is an angle, which a length, and what its units mean.

Inside dhcli lengths are metres and constant angles exact degrees or radians; units exist only in what people write.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Literal

from dhcli.notation.angle import Angle
from dhcli.notation.tree import Constant, Expr, Number, Product, Sum, Symbol, Unit
from dhcli.notation.walk import rebuild, symbols, walk
from dhcli.notation.writer import write, write_angle

LENGTH_UNITS = {
    "mm": Fraction(1, 1000),
    "cm": Fraction(1, 100),
    "m": Fraction(1),
    "in": Fraction(254, 10000),
    "inch": Fraction(254, 10000),
}
"""Metres in each unit of length."""

ANGLE_UNITS = frozenset(("deg", "degree", "degrees", "°", "rad", "radian", "radians"))
UNITS = ANGLE_UNITS | LENGTH_UNITS.keys()

Bare = Literal["rad", "deg", "refuse"]
"""What a bare number means where an angle is wanted."""


class DimensionError(ValueError):
    """An expression that is not the kind of quantity wanted; carries a message and a hint."""

    def __init__(self, message: str, hint: str = "") -> None:
        """Say what is wrong, and what would be right."""
        super().__init__(message)
        self.message = message
        self.hint = hint


def to_angle(expr: Expr, *, bare: Bare = "rad") -> Angle:
    """Read an expression as an exact angle.

    Args:
        expr: A sum of names, numbers with `deg`, `°` or `rad`, and multiples of π.
        bare: What a number without a unit means; 0 and multiples of π are always clear.

    Raises:
        DimensionError: A length, a product of angles, or a bare number where `bare` is `refuse`.
    """
    if isinstance(expr, Sum):
        return sum((to_angle(term, bare=bare) for term in expr.terms), Angle())
    factors = expr.factors if isinstance(expr, Product) else (expr,)
    scale, name, unit = Fraction(1), "", ""
    for factor in factors:
        match factor:
            case Number(value):
                scale *= value
            case Symbol() if not name and not unit:
                name = factor.name
            case Unit() if factor.name in ANGLE_UNITS and not unit and not name:
                unit = factor.name
            case Constant() if not name and unit in ("", "rad", "radian", "radians"):
                unit = "pi"
            case Unit() if factor.name in LENGTH_UNITS:
                raise DimensionError(f"{factor.name} is a unit of length, an angle is wanted", "write 30° or 0.5 rad")
            case Unit() if unit == "pi" and factor.name in ("rad", "radian", "radians"):
                pass
            case _:
                raise DimensionError("an angle is a sum of joint angles and constants", "write theta1 + 90° or pi/2")
    if name:
        return Angle(((name, scale),)) if scale else Angle()
    return _constant(scale, unit or "bare", bare)


def to_length(expr: Expr) -> Expr:
    """Read an expression as a length or plain number: units become metres, angle units are refused.

    Raises:
        DimensionError: A unit of angle where a length is wanted, or a unit that stands alone.
    """
    for node in walk(expr):
        if isinstance(node, Unit) and node.name in ANGLE_UNITS:
            raise DimensionError(f"{node.name} is a unit of angle, a length is wanted", "write 0.4 m or 400 mm")
    if not any(isinstance(node, Unit) for node in walk(expr)):
        return expr
    return rebuild(expr, _metres)


def has_angle_unit(expr: Expr) -> bool:
    """Whether a unit of angle, or π, stands anywhere in the expression."""
    return any(isinstance(n, Constant) or (isinstance(n, Unit) and n.name in ANGLE_UNITS) for n in walk(expr))


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


def _constant(scale: Fraction, unit: str, bare: Bare) -> Angle:
    if unit == "pi":
        return Angle(degrees=scale * 180)
    if unit == "bare":
        if scale and bare == "refuse":
            shown = float(scale)
            raise DimensionError(f"the angle {shown:g} has no unit", f"write {shown:g}° or {shown:g} rad")
        unit = bare
    return Angle(radians=scale) if unit in ("rad", "radian", "radians") else Angle(degrees=scale)


def _metres(node: Expr) -> Expr:
    if not isinstance(node, Unit):
        return node
    factor = LENGTH_UNITS[node.name]
    places = {"mm": 3, "cm": 2, "m": 0}.get(node.name, 4)
    return Number(factor, places)
