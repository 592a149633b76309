"""The value of a name, and parameters that follow from others: `a3: 2*a2`, `off: atan2(a3, d4)`."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import TypeAlias

from dhcli.algebra.floats import Floats
from dhcli.frozen import frozen
from dhcli.notation.angle import Angle
from dhcli.notation.quantity import DimensionError, to_angle, to_plain_length
from dhcli.notation.tree import Expr, Number
from dhcli.notation.walk import parted, substitute, symbols

Value: TypeAlias = Angle | Expr
"""The value of a name: an exact angle, or an expression of lengths in metres."""


def in_floats(value: Value) -> float:
    """A constant value in radians or metres."""
    return value.constant() if isinstance(value, Angle) else Floats().value(value)


def metres(length: Value) -> Fraction:
    """A constant length [m]; exact where it is a plain number."""
    return Fraction(length.value) if isinstance(length, Number) else Fraction(in_floats(length))


@frozen
class Formula:
    """What a parameter is in terms of others.

    Attributes:
        expr: The expression as it was read, units and inverse functions in it.
        is_angle: Whether it is an angle; else it is a length or a number.
    """

    expr: Expr
    is_angle: bool


def with_derived(formulas: Mapping[str, Formula], known: Mapping[str, Value]) -> dict[str, Value]:
    """Values with those that follow from them; one that stands among them already is taken as it is.

    Args:
        formulas: The formula of each parameter that has one, in any order, none in terms of itself.
        known: Values of parameters.

    Raises:
        DimensionError: A formula has no real value there, or mixes angles and lengths.
    """
    values = dict(known)
    waiting = [name for name in formulas if name not in values]
    while waiting:
        ready = [name for name in waiting if symbols(formulas[name].expr) <= values.keys()]
        for name in ready:
            values[name] = value_of(formulas[name], values)
        waiting = [name for name in waiting if name not in values]
        if not ready:
            break
    return values


def replaced(
    formulas: Mapping[str, Formula], own: Mapping[str, Value | None], given: Mapping[str, Value]
) -> dict[str, Value]:
    """A robot's own values with some given instead, and what follows from those.

    Raises:
        DimensionError: A formula has no real value there.
    """
    kept = {name: value for name, value in own.items() if value is not None}
    if not formulas or not given:
        return {**kept, **given}
    return with_derived(formulas, {**{name: v for name, v in kept.items() if name not in formulas}, **given})


def value_of(formula: Formula, values: Mapping[str, Value]) -> Value:
    """The value of a formula where all names in it have one.

    Raises:
        DimensionError: It has no real value there, or mixes angles and lengths.
    """
    lengths, angles = parted(values)
    try:
        expr = substitute(formula.expr, lengths, angles)
        found: Value = to_angle(expr, bare="refuse").substitute(angles) if formula.is_angle else to_plain_length(expr)
    except (ZeroDivisionError, OverflowError):
        raise DimensionError("a division by zero, or a number that becomes too large") from None
    left = found.names if isinstance(found, Angle) else symbols(found)
    if left:
        name = min(left)
        kind = ("an angle", "a length") if name in angles else ("a length", "an angle")
        raise DimensionError(f"{name} is {kind[0]}, and {kind[1]} is wanted")
    return found


def circle(formulas: Mapping[str, Formula]) -> tuple[str, ...]:
    """Names whose formulas lead back to themselves; empty if none do."""
    left = dict(formulas)
    while left:
        ready = [name for name, formula in left.items() if not symbols(formula.expr) & left.keys()]
        if not ready:
            return tuple(left)
        for name in ready:
            del left[name]
    return ()
