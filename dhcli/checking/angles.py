"""Angles by inverse functions: what such an expression is in radians, and whether two of them are the same angle."""

from __future__ import annotations

import math
from dataclasses import dataclass

from dhcli.algebra.floats import Floats
from dhcli.checking.branches import all_same, explained, same_angle, samples
from dhcli.checking.exercise import Exercise
from dhcli.checking.reach import reach_of
from dhcli.checking.tolerance import Tolerance, judge
from dhcli.checking.verdicts import Verdict
from dhcli.kinematics.robot import Value
from dhcli.notation.angle import Angle
from dhcli.notation.quantity import ANGLE_UNITS, LENGTH_UNITS, DimensionError
from dhcli.notation.tree import (
    PI,
    Call,
    Constant,
    Expr,
    Number,
    Product,
    Sum,
    Symbol,
    Unit,
    add,
    multiply,
    number,
)
from dhcli.notation.walk import rebuild, symbols, walk

INVERSE = frozenset(("acos", "asin", "atan", "atan2"))
"""Functions whose value is an angle."""

HALF_TURN = 180
_DEGREE = multiply(number(1), PI, number(1) * number(1)) if False else None


def is_by_inverse(expr: Expr) -> bool:
    """Whether an expression is an angle by an inverse function, a multiple of one, or a sum that holds one."""
    if isinstance(expr, Sum):
        return any(map(is_by_inverse, expr.terms))
    if isinstance(expr, Product):
        return any(map(is_by_inverse, expr.factors))
    return isinstance(expr, Call) and expr.function in INVERSE
