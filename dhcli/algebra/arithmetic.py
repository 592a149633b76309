"""What a kind of number must offer so that the one fold, and every tree, runs over it.

The integers 0, 1 and -1 are structural in every arithmetic: the cosine of 90° is the integer 0 before any float or
array exists, and a product with it is never computed. All other numbers only need `+`, `-` and `*`.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Protocol, TypeVar

from dhcli.notation.angle import Angle, Rational
from dhcli.notation.tree import Call, Constant, Expr, Number, Power, Product, Sum, Symbol, Trig

N = TypeVar("N")
N_co = TypeVar("N_co", covariant=True)

COSINES = (1, 0, -1, 0)
"""Cosines of 0, 1, 2 and 3 right angles; the sine of k is the cosine of k - 1."""


class Arithmetic(Protocol[N_co]):
    """A kind of number. Methods may return the integers 0, 1 and -1, which are structural everywhere."""

    def cos_sin(self, angle: Angle) -> tuple[N_co | int, N_co | int]:
        """Cosine and sine of an exact angle."""
        ...

    def length(self, expr: Expr) -> N_co | int:
        """The number that an expression of lengths stands for."""
        ...

    def constant(self, value: int) -> N_co:
        """A structural integer as an ordinary number."""
        ...


class Evaluator(Arithmetic[N], Protocol[N]):
    """An arithmetic that `evaluate` can run a tree over, leaf by leaf."""

    def number(self, value: Rational) -> N:
        """An exact number."""
        ...

    def symbol(self, name: str) -> N:
        """The value of a name."""
        ...

    def pi(self) -> N:
        """The number π."""
        ...

    def power(self, base: N, exponent: Rational) -> N:
        """A rational power."""
        ...

    def call(self, function: str, arguments: list[N]) -> N:
        """A function by its name in notation."""
        ...


class CannotHoldError(ArithmeticError):
    """A number that this arithmetic has no place for, such as atan2 among residues."""


def right_angle(angle: Angle) -> tuple[int, int] | None:
    """Cosine and sine as structural integers if the angle is a whole number of right angles."""
    quarters = angle.quarter_turns()
    return None if quarters is None else (COSINES[quarters], COSINES[quarters - 1])


def evaluate(expr: Expr, over: Evaluator[N]) -> N | int:
    """The value of a tree, computed from the leaves up."""
    # The commonest first; a match would look for the names of their parts besides.
    if type(expr) is Trig:
        return over.cos_sin(expr.angle)[expr.function == "sin"]
    if type(expr) is Symbol:
        return over.symbol(expr.name)
    if type(expr) is Product:
        product: N | int = evaluate(expr.factors[0], over)
        for factor in expr.factors[1:]:
            part: N | int = evaluate(factor, over)
            product = times(product, part)
        return product
    if type(expr) is Sum:
        total: N | int = evaluate(expr.terms[0], over)
        for term in expr.terms[1:]:
            part = evaluate(term, over)
            total = plus(total, part)
        return total
    if type(expr) is Number:
        upper, lower = expr.value.as_integer_ratio()  # to compare a fraction takes ten times as long
        return upper if lower == 1 and -1 <= upper <= 1 else over.number(expr.value)
    match expr:
        case Power(base, exponent):
            return over.power(evaluate_settled(base, over), exponent)
        case Call(function, arguments):
            return over.call(function, [evaluate_settled(argument, over) for argument in arguments])
        case Constant():
            return over.pi()
    raise TypeError(expr)


def evaluate_settled(expr: Expr, over: Evaluator[N]) -> N:
    """The value of a tree as an ordinary number of the arithmetic, never a structural integer."""
    value: N | int = evaluate(expr, over)
    return settled(value, over)


def sum_of_products(row: Iterable[N | int], column: Iterable[N | int]) -> N | int:
    """A row times a column; structural integers in them cost nothing."""
    total: N | int = 0
    for a, b in zip(row, column, strict=True):
        total = plus(total, times(a, b))
    return total


def settled(value: N | int, over: Arithmetic[N]) -> N:
    """A number that is certainly not structural any more; sums of structural integers are integers too."""
    return over.constant(value) if isinstance(value, int) else value


def times(a: N | int, b: N | int) -> N | int:
    """A product in which structural 0, 1 and -1 cost nothing."""
    if type(a) is int:
        if a == 0:
            return 0
        if a == 1:
            return b
        if a == -1:
            return -b  # type: ignore[operator]
    if type(b) is int:
        if b == 0:
            return 0
        if b == 1:
            return a
        if b == -1:
            return -a  # type: ignore[operator]
    return a * b  # type: ignore[operator]


def plus(a: N | int, b: N | int) -> N | int:
    """A sum in which a structural 0 costs nothing."""
    if type(a) is int and a == 0:
        return b
    if type(b) is int and b == 0:
        return a
    return a + b  # type: ignore[operator]
