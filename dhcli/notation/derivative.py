"""Derivatives of trees, in the form a textbook gives them: no bracket is expanded, none contracted."""

from __future__ import annotations

from dhcli.notation.tree import (
    ONE,
    ZERO,
    Call,
    Expr,
    Power,
    Product,
    Sum,
    Symbol,
    Trig,
    add,
    multiply,
    negate,
    number,
    power,
)
from dhcli.notation.trig import cosine, sine
from dhcli.notation.walk import symbols


def derivative(expr: Expr, name: str) -> Expr:
    """The partial derivative of an expression by a name that stands as a number or inside angles [rad].

    Raises:
        TypeError: The name stands inside a function such as atan2, where no joint may stand.
    """
    match expr:
        case Symbol(own):
            return ONE if own == name else ZERO
        case Trig(function, angle):
            factor = next((factor for own, factor in angle.terms if own == name), None)
            if factor is None:
                return ZERO
            changed = cosine(angle) if function == "sin" else negate(sine(angle))
            return multiply(number(factor), changed)
        case Sum(terms):
            return add(*(derivative(term, name) for term in terms))
        case Product(factors):
            return add(*(_by_one(factors, place, name) for place in range(len(factors))))
        case Power(base, exponent):
            return multiply(number(exponent), power(base, exponent - 1), derivative(base, name))
        case Call(function, _) if name in symbols(expr):
            raise TypeError(function)
    return ZERO


def _by_one(factors: tuple[Expr, ...], place: int, name: str) -> Expr:
    """A product with one of its factors differentiated."""
    changed = derivative(factors[place], name)
    return ZERO if changed == ZERO else multiply(*factors[:place], changed, *factors[place + 1 :])
