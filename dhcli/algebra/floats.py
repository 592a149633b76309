"""Python floats: one pose, without importing numpy."""

from __future__ import annotations

import math
from collections.abc import Mapping

from dhcli.algebra.arithmetic import evaluate, evaluate_settled, right_angle
from dhcli.notation.angle import Angle, Rational
from dhcli.notation.tree import ZERO, Expr, Number

_EXACT_SINES: Mapping[Rational, float] = {0: 0.0, 30: 0.5, 90: 1.0}

MOST_TURNED = 1000
"""Angles whose cosines are kept: a point may serve the answers of a whole class."""

_CALLS = {"tan": math.tan, "acos": math.acos, "asin": math.asin, "atan": math.atan, "cos": math.cos, "sin": math.sin}


class Floats:
    """Double precision.

    Attributes:
        values: Value of each name: an exact `Angle`, an angle in radians, or a length in metres.
    """

    def __init__(self, values: Mapping[str, Angle | float] | None = None) -> None:
        """Take the values of the names."""
        values = values or {}
        self._angles: dict[str, Angle] = {}
        self._floats: dict[str, float] = {}
        for name, value in values.items():
            if isinstance(value, Angle):
                self._angles[name] = value
            else:
                self._floats[name] = float(value)
        self._turned: dict[Angle, tuple[float | int, float | int]] = {}

    def cos_sin(self, angle: Angle) -> tuple[float | int, float | int]:
        """Cosine and sine; exact where the angle is exact, NaN where it is too large."""
        found = self._turned.get(angle)
        if found is None:
            if len(self._turned) >= MOST_TURNED:
                self._turned.clear()
            found = self._turned[angle] = self._cos_sin(angle)
        return found

    def _cos_sin(self, angle: Angle) -> tuple[float | int, float | int]:
        try:
            angle = angle.substitute(self._angles)
        except OverflowError:  # so small a part of a sum that it has no exact form
            radians = angle.constant() + sum(float(factor) * self.symbol(name) for name, factor in angle.terms)
            return math.cos(radians), math.sin(radians)
        exact = right_angle(angle)
        if exact is not None:
            return exact
        if not angle.terms and not angle.radians:
            return cosine_of_degrees(angle.degrees), cosine_of_degrees(angle.degrees - 90)
        try:
            radians = angle.constant()
            for name, factor in angle.terms:
                radians += float(factor) * self._floats[name]
            return math.cos(radians), math.sin(radians)
        except (ValueError, OverflowError):  # an angle beyond all floats
            return math.nan, math.nan

    def length(self, expr: Expr) -> float | int:
        """Value of an expression of lengths [m]."""
        if expr is ZERO:
            return 0
        if type(expr) is Number:
            return self.number(expr.value) if expr.value else 0
        return evaluate(expr, self)

    def value(self, expr: Expr) -> float:
        """Value of any expression."""
        return evaluate_settled(expr, self)

    def constant(self, value: int) -> float:
        """0.0, 1.0 or -1.0."""
        return float(value)

    def number(self, value: Rational) -> float:
        """The nearest float; a quotient of two integers is one."""
        return value.numerator / value.denominator

    def symbol(self, name: str) -> float:
        """Value of a name; an angle outside a cosine counts in radians."""
        if name in self._angles:
            return self._angles[name].constant()
        return self._floats[name]

    def pi(self) -> float:
        """3.14159..."""
        return math.pi

    def power(self, base: float, exponent: Rational) -> float:
        """A power; NaN where it is not real."""
        try:
            if exponent.numerator == 1 and exponent.denominator == 2:  # noqa: PLR2004  a square root
                return math.sqrt(base)
            return math.pow(base, exponent.numerator / exponent.denominator)
        except (ValueError, ZeroDivisionError, OverflowError):
            return math.nan

    def call(self, function: str, arguments: list[float]) -> float:
        """A function of floats; NaN where it is not defined."""
        try:
            if function == "atan2":
                return math.atan2(*arguments)
            return _CALLS[function](arguments[0])
        except (ValueError, OverflowError):
            return math.nan


def cosine_of_degrees(degrees: Rational) -> float:
    """Cosine of exact degrees, reduced exactly to the first 45° before a float exists."""
    degrees %= 360
    if degrees > 180:  # noqa: PLR2004
        degrees = 360 - degrees
    if degrees > 90:  # noqa: PLR2004
        return -cosine_of_degrees(180 - degrees)
    if degrees > 45:  # noqa: PLR2004
        exact = _EXACT_SINES.get(90 - degrees)
        return math.sin(math.radians(90 - degrees)) if exact is None else exact
    return math.cos(math.radians(degrees))
