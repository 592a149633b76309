"""Mistakes in copying or expanding a single entry: the sign of one term of its sum."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import replace

from dhcli.checking.diagnosis.work import Setting, Work, terms
from dhcli.notation.styles import Joints
from dhcli.notation.tree import Expr, Product, Sum, add, is_negative, multiply, negate
from dhcli.notation.writer import write


def term_sign(work: Work, setting: Setting) -> Iterator[tuple[str, Work]]:
    """One term of a sum with the other sign, wherever the sum stands in an entry; a number shows no terms."""
    if setting.numeric:
        return
    for r, row in enumerate(terms(work, {})):
        for c, entry in enumerate(row):
            seen: Counter[str] = Counter()
            for term, changed in flipped(entry):
                text = shown(term, setting.writing)
                seen[text] += 1
                again = f" no. {seen[text]}" if seen[text] > 1 else ""
                yield f"{r + 1},{c + 1} {text}{again}", replace(work, entry=(r, c, changed))


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
