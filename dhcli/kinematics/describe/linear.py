"""Points and lengths as linear forms: a number for each letter, so that one geometry serves letters and numbers.

A robot in numbers has the one letter 1. What is not linear, such as `sqrt(a^2 + b^2)`, counts as a letter of its own.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import TypeAlias

from dhcli.algebra.floats import Floats
from dhcli.errors import RobotError
from dhcli.frozen import frozen
from dhcli.geometry.vectors import Vector, dot, plus, scaled
from dhcli.kinematics.describe.exact import CLOSE, exact_factor, exact_length
from dhcli.notation.angle import Angle
from dhcli.notation.tree import ONE, ZERO, Expr, Number, Product, Sum, add, multiply
from dhcli.notation.walk import symbols

Form: TypeAlias = dict[Expr, float]
"""A length [m]: a number for each letter; that of the letter 1 is in metres."""

Point: TypeAlias = dict[Expr, Vector]
"""A point, or the vector between two: a vector for each letter."""


class LettersError(RobotError):
    """A description that depends on how long letters are against each other."""


@frozen
class Ruler:
    """What decides about lengths.

    Attributes:
        values: Value of each letter; of those without one nothing is known.
        size: Length that counts as 1 for plain metres [m].
    """

    values: Mapping[str, Angle | float]
    size: float = 1.0

    def cleaned(self, form: Form) -> Form:
        """Without what is rounding."""
        return {letter: value for letter, value in form.items() if abs(value) > self._noise(letter)}

    def cleaned_point(self, point: Point) -> Point:
        """Without what is rounding, coordinate by coordinate."""
        kept = {}
        for letter, vector in point.items():
            noise = self._noise(letter)
            x, y, z = (value if abs(value) > noise else 0.0 for value in vector)
            if x or y or z:
                kept[letter] = (x, y, z)
        return kept

    def is_positive(self, form: Form) -> bool:
        """Whether a length that is not zero is positive: by the values of its letters, else by its first one."""
        try:
            total = self.number(form)
        except KeyError:
            total = 0.0
        return total > 0 if abs(total) > CLOSE * self.size else next(iter(form.values()), 1.0) > 0

    def number(self, form: Form) -> float:
        """The length in metres.

        Raises:
            KeyError: A letter has no value.
        """
        over = Floats(self.values)
        return sum(value * over.value(letter) for letter, value in form.items())

    def _noise(self, letter: Expr) -> float:
        return CLOSE * (self.size if letter == ONE else 1.0)


def form_of(expr: Expr) -> Form:
    """A length as a linear form, brackets expanded."""
    if isinstance(expr, Sum):
        return combined((1.0, form_of(term)) for term in expr.terms)
    if isinstance(expr, Product):
        total: Form = {ONE: 1.0}
        for factor in expr.factors:
            part = form_of(factor)
            total = combined(
                (value * other, {multiply(letter, more): 1.0})
                for letter, value in total.items()
                for more, other in part.items()
            )
        return total
    if not symbols(expr):
        value = Floats().value(expr)
        return {ONE: value} if value else {}
    return {expr: 1.0}


def point_of(coordinates: Iterable[Expr]) -> Point:
    """A point by its coordinates."""
    x, y, z = (form_of(expr) for expr in coordinates)
    return {
        letter: (x.get(letter, 0.0), y.get(letter, 0.0), z.get(letter, 0.0)) for letter in dict.fromkeys((*x, *y, *z))
    }


def combined(parts: Iterable[tuple[float, Form]]) -> Form:
    """A linear combination of lengths."""
    total: Form = {}
    for factor, form in parts:
        for letter, value in form.items():
            total[letter] = total.get(letter, 0.0) + factor * value
    return total


def moved(point: Point, other: Point, times: float = 1.0) -> Point:
    """A point and a multiple of a vector."""
    zero = (0.0, 0.0, 0.0)
    return {
        letter: plus(point.get(letter, zero), other.get(letter, zero), times)
        for letter in dict.fromkeys((*point, *other))
    }


def shifted(point: Point, direction: Vector, by: Form) -> Point:
    """A point moved along a direction by a length."""
    return moved(point, {letter: scaled(direction, value) for letter, value in by.items()})


def mapped(point: Point, function: Callable[[Vector], float]) -> Form:
    """A length that depends linearly on a vector, such as its part along an axis."""
    return {letter: function(vector) for letter, vector in point.items()}


def along(point: Point, direction: Vector) -> Form:
    """The part of a vector along a direction."""
    return mapped(point, lambda vector: dot(vector, direction))


def length_of(form: Form) -> Expr:
    """A length as it is written."""
    terms = []
    for letter, value in form.items():
        terms.append(exact_length(value) if letter == ONE else multiply(exact_factor(value), letter))
    return add(*terms) if terms else ZERO


def coordinates_of(point: Point) -> tuple[Expr, Expr, Expr]:
    """A point as it is written."""
    x, y, z = (length_of({letter: v[i] for letter, v in point.items() if v[i]}) for i in range(3))
    return x, y, z


def is_plain(form: Iterable[Expr]) -> bool:
    """Whether no letter stands in a form but 1."""
    return all(isinstance(letter, Number) for letter in form)
