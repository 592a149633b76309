"""Numpy columns: the same fold over a million poses at once."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import TYPE_CHECKING

import numpy as np

from dhcli.algebra.arithmetic import evaluate, right_angle
from dhcli.algebra.floats import cosine_of_degrees
from dhcli.notation.angle import Angle
from dhcli.notation.tree import Expr

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Column = NDArray[np.float64]

_CALLS = {"tan": np.tan, "acos": np.arccos, "asin": np.arcsin, "atan": np.arctan, "cos": np.cos, "sin": np.sin}


class Columns:
    """Double precision arrays of one shape, a number for each pose.

    Attributes:
        values: Value of each name: an array (N,), or a float that all poses share; radians and metres.
    """

    def __init__(self, values: Mapping[str, Column | float]) -> None:
        """Take the values of the names."""
        self._values = {name: np.asarray(value, dtype=np.float64) for name, value in values.items()}

    def cos_sin(self, angle: Angle) -> tuple[Column | int, Column | int]:
        """Cosine and sine of each element; structural integers for right angles."""
        exact = right_angle(angle)
        if exact is not None:
            return exact
        if not angle.terms and not angle.radians:
            return np.asarray(cosine_of_degrees(angle.degrees)), np.asarray(cosine_of_degrees(angle.degrees - 90))
        radians = np.asarray(angle.constant())
        for name, factor in angle.terms:
            radians = radians + float(factor) * self._values[name]
        return np.cos(radians), np.sin(radians)

    def length(self, expr: Expr) -> Column | int:
        """Values of an expression of lengths [m]."""
        return evaluate(expr, self)

    def constant(self, value: int) -> Column:
        """A column that is the same number everywhere."""
        return np.asarray(float(value))

    def number(self, value: Fraction) -> Column:
        """A column that is the same number everywhere."""
        return np.asarray(float(value))

    def symbol(self, name: str) -> Column:
        """The values of a name."""
        return self._values[name]

    def pi(self) -> Column:
        """3.14159..."""
        return np.asarray(np.pi)

    def power(self, base: Column, exponent: Fraction) -> Column:
        """A power; NaN where it is not real."""
        with np.errstate(invalid="ignore", divide="ignore", over="ignore"):
            return np.asarray(np.power(base, float(exponent)))

    def call(self, function: str, arguments: list[Column]) -> Column:
        """A function of each element; NaN where it is not defined."""
        with np.errstate(invalid="ignore"):
            if function == "atan2":
                return np.asarray(np.arctan2(*arguments))
            return np.asarray(_CALLS[function](arguments[0]))
