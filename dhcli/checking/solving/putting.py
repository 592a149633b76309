"""Expressions put in the place of others, and as they are typed."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from dhcli.notation.tree import Call, Expr, Power, Product, Sum, add, multiply, power
from dhcli.notation.walk import children


def put_for(expr: Expr, instead: Mapping[Expr, Expr]) -> Expr:
    """An expression with others in the place of some that stand in it."""
    if expr in instead:
        return instead[expr]
    if not children(expr):
        return expr
    if isinstance(expr, Call):
        return Call(expr.function, tuple(put_for(one, instead) for one in expr.arguments))
    parts = [put_for(one, instead) for one in children(expr)]
    if all(new is old for new, old in zip(parts, children(expr), strict=True)):
        return expr  # as it is written
    if isinstance(expr, Power):
        return power(parts[0], expr.exponent)
    return add(*parts) if isinstance(expr, Sum) else multiply(*parts)


def with_roots(expr: Expr) -> Expr:
    """An expression with `1/sqrt(x)` for x to the power -1/2, which nobody writes."""
    if not children(expr):
        return expr
    if isinstance(expr, Call):
        return Call(expr.function, tuple(map(with_roots, expr.arguments)))
    parts = tuple(map(with_roots, children(expr)))
    if isinstance(expr, Power):
        if expr.exponent.denominator == 2 and expr.exponent < 0:  # noqa: PLR2004
            return Power(Power(parts[0], Fraction(1, 2)), Fraction(expr.exponent.numerator))
        return Power(parts[0], expr.exponent)
    return Sum(parts) if isinstance(expr, Sum) else Product(parts)
