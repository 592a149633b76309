"""Angles by inverse functions: what such an expression is in radians, and whether two are the same angle.

Two angles are the same modulo a full turn, at the values given or at points all round the circle.
"""

from __future__ import annotations

import math
from fractions import Fraction

from dhcli.algebra.floats import Floats
from dhcli.checking.branches import all_same, explained, same_angle, samples
from dhcli.checking.exercise import Exercise
from dhcli.checking.reach import reach_of
from dhcli.checking.tolerance import Tolerance, judge
from dhcli.checking.verdicts import Verdict
from dhcli.kinematics.robot import Value
from dhcli.notation.angle import Angle
from dhcli.notation.dimensions import INVERSE, has_units
from dhcli.notation.quantity import ANGLE_UNITS, LENGTH_UNITS, RADIANS, Bare, DimensionError, to_length
from dhcli.notation.scope import Scope
from dhcli.notation.tree import (
    ONE,
    PI,
    Call,
    Constant,
    Expr,
    Number,
    Power,
    Product,
    Sum,
    Symbol,
    Unit,
    add,
    multiply,
    number,
)
from dhcli.notation.walk import rebuild, symbols
from dhcli.notation.writer import write

SHOWN_DIGITS = 4

EXACT = Tolerance(angle=1e-10)
"""Two angles that are the same but for what floats leave."""

_DEGREE = multiply(Number(Fraction(1, 180)), PI)


def in_radians(value: Value, scope: Scope, bare: Bare = "rad") -> Expr:
    """An angle, exact or by an inverse function, as an expression in radians.

    Args:
        value: The angle, units as they were written.
        scope: Says which names are angles.
        bare: What a number without a unit means.

    Raises:
        DimensionError: It is a length, or a product of angles.
    """
    if isinstance(value, Angle):
        terms = (multiply(number(factor), Symbol(name)) for name, factor in value.terms)
        return add(*terms, multiply(number(value.degrees), _DEGREE), number(value.radians))
    if isinstance(value, Sum):
        return add(*(in_radians(term, scope, bare) for term in value.terms))
    factors = value.factors if isinstance(value, Product) else (value,)
    found = [_angle(factor, scope, bare) for factor in factors]
    angles = [factor for factor, is_angle in found if is_angle]
    units = [factor for factor in factors if isinstance(factor, Unit)]
    if len(angles) > 1 and not (len(angles) == 2 and PI in angles and units):  # noqa: PLR2004  π rad
        raise DimensionError("an angle is a sum of joint angles and constants", "write theta1 + 90° or pi/2")
    product = multiply(*(factor for factor, _ in found))
    return product if angles or bare != "deg" else multiply(product, _DEGREE)


def _angle(factor: Expr, scope: Scope, bare: Bare) -> tuple[Expr, bool]:
    """A factor of an angle, and whether it is an angle itself."""
    if isinstance(factor, Sum):
        return in_radians(factor, scope, bare), True
    if isinstance(factor, Unit) and factor.name in ANGLE_UNITS:
        return (ONE if factor.name in RADIANS else _DEGREE), True
    if isinstance(factor, Call) and factor.function in INVERSE:
        return Call(factor.function, tuple(map(to_length, factor.arguments))), True
    if isinstance(factor, Constant) or (isinstance(factor, Symbol) and scope.is_angle(factor.name)):
        return factor, True
    if isinstance(factor, Unit) and factor.name in LENGTH_UNITS:
        raise DimensionError(f"{factor.name} is a unit of length, an angle is wanted", "write 30° or 0.5 rad")
    if isinstance(factor, Number) or (isinstance(factor, Power) and not symbols(factor) and not has_units(factor)):
        return factor, False
    raise DimensionError(f"{write(factor)} is no angle, and one is wanted", "write 30°, 0.5 rad or atan2(y, x)")


def judge_angle(typed: Expr, right: Expr, exercise: Exercise, tolerance: Tolerance) -> Verdict:
    """Judge an angle against another, both in radians: at the values given, or at points all round the circle."""
    typed, right = _put(typed, exercise), _put(right, exercise)
    if symbols(typed) or symbols(right):
        is_right = all_same(samples(typed, right, reach_of(exercise), same_angle))
        return Verdict.RIGHT if is_right else Verdict.WRONG
    apart = math.degrees(math.remainder(Floats().value(typed) - Floats().value(right), math.tau))
    return judge(apart, 0.0, tolerance.angle) if math.isfinite(apart) else Verdict.WRONG


def branch_of(typed: Expr, right: Expr, exercise: Exercise) -> str:
    """Where an angle in radians is right, if it is anywhere, and a point where it is not."""
    typed, right = _put(typed, exercise), _put(right, exercise)
    return explained(typed, right, reach_of(exercise), same_angle, exercise.writing)


def shown_angle(expr: Expr, exercise: Exercise) -> str:
    """An angle by an inverse function as a person would type it: in degrees where it has a value, if that will do."""
    if exercise.numeric and not exercise.tolerance.exact:
        value = _put(expr, exercise)
        degrees = math.nan if symbols(value) else math.degrees(Floats().value(value))
        if math.isfinite(degrees):
            return f"{round(degrees, SHOWN_DIGITS):.10g}°"
    return write(expr, "short", exercise.writing)


def _put(expr: Expr, exercise: Exercise) -> Expr:
    """An angle with the values given; a joint outside a cosine counts in radians."""
    from dhcli.checking.symbolic import put

    def leaf(node: Expr) -> Expr:
        value = exercise.values.get(node.name) if isinstance(node, Symbol) else None
        return in_radians(value, exercise.scope) if isinstance(value, Angle) else node

    return rebuild(put(expr, exercise.values), leaf)
