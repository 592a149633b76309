"""The terms of an expression, one by one: each with its sign turned round."""

from __future__ import annotations

from collections.abc import Iterator

from dhcli.notation.styles import Joints
from dhcli.notation.tree import Expr, Product, Sum, add, is_negative, multiply, negate
from dhcli.notation.writer import write


def flipped(expr: Expr) -> Iterator[tuple[Expr, Expr]]:
    """Each term of each sum in an expression, and the expression with its sign turned round."""
    if isinstance(expr, Sum):
        for k, term in enumerate(expr.terms):
            before, after = expr.terms[:k], expr.terms[k + 1 :]
            yield term, add(*before, negate(term), *after)
            for inner, changed in flipped(term):
                yield inner, add(*before, changed, *after)
    elif isinstance(expr, Product):
        for k, factor in enumerate(expr.factors):
            for inner, changed in flipped(factor):
                yield inner, multiply(*expr.factors[:k], changed, *expr.factors[k + 1 :])


def shown(term: Expr, writing: Joints) -> str:
    """A term without its sign, as a person would write it."""
    return write(negate(term) if is_negative(term) else term, "short", writing)
