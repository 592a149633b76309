"""The pieces of an expression: its terms at any depth, its cosines and sines, its products; each can be exchanged."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from dhcli.frozen import frozen
from dhcli.notation.styles import Joints
from dhcli.notation.tree import Expr, Product, Sum, Symbol, Trig, add, is_negative, multiply, negate
from dhcli.notation.walk import rebuild, walk
from dhcli.notation.writer import write


@frozen
class Piece:
    """A term of a sum that stands somewhere in an expression.

    Attributes:
        term: The term.
        whole: What it is worth: the term times the factors of the brackets that it stands in.
        put: The expression with something else in the place of the term.
    """

    term: Expr
    whole: Expr
    put: Callable[[Expr], Expr]


def pieces(expr: Expr, around: Expr | None = None, put: Callable[[Expr], Expr] = lambda new: new) -> Iterator[Piece]:
    """Each term of each sum in an expression."""
    if isinstance(expr, Sum):
        for k, term in enumerate(expr.terms):
            here = _put_term(expr, k, put)
            yield Piece(term, term if around is None else multiply(around, term), here)
            yield from pieces(term, around, here)
    elif isinstance(expr, Product):
        for k, factor in enumerate(expr.factors):
            others = (*expr.factors[:k], *expr.factors[k + 1 :])
            beside = multiply(*others) if around is None else multiply(around, *others)
            yield from pieces(factor, beside, _put_factor(expr, k, put))


def products(expr: Expr, put: Callable[[Expr], Expr] = lambda new: new) -> Iterator[tuple[Product, int, Expr]]:
    """Each factor of each product in an expression, by its place, and the expression without it."""
    if isinstance(expr, Sum):
        for k, term in enumerate(expr.terms):
            yield from products(term, _put_term(expr, k, put))
    elif isinstance(expr, Product):
        for k, factor in enumerate(expr.factors):
            others = (*expr.factors[:k], *expr.factors[k + 1 :])
            yield expr, k, put(multiply(*others))
            yield from products(factor, _put_factor(expr, k, put))


def functions(expr: Expr) -> tuple[Trig, ...]:
    """The cosines and sines in an expression, each once."""
    return tuple(dict.fromkeys(node for node in walk(expr) if isinstance(node, Trig)))


def lengths(expr: Expr) -> tuple[Symbol, ...]:
    """The lengths in an expression, each once."""
    return tuple(dict.fromkeys(node for node in walk(expr) if isinstance(node, Symbol)))


def exchanged(expr: Expr, old: Expr, new: Expr) -> Expr:
    """An expression with something else in the place of a leaf, wherever that stands."""
    return rebuild(expr, lambda leaf: new if leaf == old else leaf)


def flipped(expr: Expr) -> Iterator[tuple[Expr, Expr]]:
    """Each term of each sum in an expression, and the expression with its sign turned round."""
    return ((piece.term, piece.put(negate(piece.term))) for piece in pieces(expr))


def shown(term: Expr, writing: Joints) -> str:
    """A term without its sign, as a person would write it."""
    return write(negate(term) if is_negative(term) else term, "short", writing)


def _put_term(expr: Sum, k: int, put: Callable[[Expr], Expr]) -> Callable[[Expr], Expr]:
    return lambda new: put(add(*expr.terms[:k], new, *expr.terms[k + 1 :]))


def _put_factor(expr: Product, k: int, put: Callable[[Expr], Expr]) -> Callable[[Expr], Expr]:
    return lambda new: put(multiply(*expr.factors[:k], new, *expr.factors[k + 1 :]))
