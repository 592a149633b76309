"""Going through trees: their nodes, their names, what they cost, and the same tree with other leaves."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from operator import attrgetter
from typing import Any

from dhcli.notation.angle import Angle
from dhcli.notation.tree import Call, Expr, Number, Power, Product, Sum, Symbol, Trig, add, multiply, power, split
from dhcli.notation.trig import cosine, sine

_BELOW: dict[type[Expr], Callable[[Any], tuple[Expr, ...]]] = {
    Sum: attrgetter("terms"),
    Product: attrgetter("factors"),
    Power: lambda node: (node.base,),
    Call: attrgetter("arguments"),
}
"""What the nodes that are no leaves have below them."""


def children(expr: Expr) -> tuple[Expr, ...]:
    """The nodes directly below."""
    below = _BELOW.get(type(expr))
    return below(expr) if below else ()


def walk(expr: Expr) -> Iterator[Expr]:
    """Every node, each before those below it."""
    stack = [expr]
    while stack:
        node = stack.pop()
        yield node
        if below := _BELOW.get(type(node)):
            stack += below(node)[::-1]


def unknowns(*exprs: Expr) -> frozenset[Symbol | Trig]:
    """The names, and the cosines and sines, each once."""
    return frozenset(node for expr in exprs for node in walk(expr) if type(node) is Trig or type(node) is Symbol)


def symbols(expr: Expr) -> frozenset[str]:
    """All names, those inside angles too."""
    if type(expr) is Number:  # as most that is typed for numbers
        return frozenset()
    if type(expr) is Symbol:
        return frozenset((expr.name,))
    stack, found = [expr], set[str]()
    while stack:
        node = stack.pop()
        if type(node) is Symbol:
            found.add(node.name)
        elif type(node) is Trig:
            found.update(name for name, _ in node.angle.terms)
        else:
            stack += children(node)
    return frozenset(found)


def symbols_in(exprs: Iterable[Expr]) -> frozenset[str]:
    """All names in some expressions."""
    return frozenset[str]().union(*map(symbols, exprs))


def angles_in(expr: Expr) -> frozenset[str]:
    """The names inside its cosines and sines."""
    return frozenset(name for node in walk(expr) if type(node) is Trig for name in node.angle.names)


def decimals(expr: Expr) -> tuple[int | None, ...]:
    """The decimal places of its numbers: with them expressions that are equal, such as 0.5 and 1/2, are told apart."""
    stack, found = [expr], []
    while stack:
        node = stack.pop()
        if type(node) is Number:
            found.append(node.places)
        else:
            stack += children(node)
    return tuple(found)


def operations(expr: Expr) -> int:
    """Binary + - * / in the written form; unary minus, cosines and sines cost nothing."""
    return sum(_own_operations(node) for node in walk(expr))


def rebuild(expr: Expr, leaf: Callable[[Expr], Expr]) -> Expr:
    """The tree with every leaf passed through a function, put together again by the constructors."""
    if type(expr) is Sum:
        return add(*(rebuild(term, leaf) for term in expr.terms))
    if type(expr) is Product:
        return multiply(*(rebuild(factor, leaf) for factor in expr.factors))
    if type(expr) is Power:
        return power(rebuild(expr.base, leaf), expr.exponent)
    if type(expr) is Call:
        return Call(expr.function, tuple(rebuild(argument, leaf) for argument in expr.arguments))
    return leaf(expr)


def parted(values: Mapping[str, Expr | Angle]) -> tuple[dict[str, Expr], dict[str, Angle]]:
    """Values of names, lengths and angles apart, as `substitute` takes them."""
    lengths = {name: value for name, value in values.items() if isinstance(value, Expr)}
    return lengths, {name: value for name, value in values.items() if isinstance(value, Angle)}


def substitute(expr: Expr, lengths: Mapping[str, Expr], angles: Mapping[str, Angle]) -> Expr:
    """Put exact values in the place of names: lengths where they stand as numbers, angles inside cosines and sines."""

    def leaf(node: Expr) -> Expr:
        if type(node) is Symbol:
            return lengths.get(node.name, node)
        if type(node) is Trig:
            angle = node.angle.substitute(angles)
            return cosine(angle) if node.function == "cos" else sine(angle)
        return node

    return rebuild(expr, leaf)


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


def _own_operations(node: Expr) -> int:
    if type(node) is Sum:
        return len(node.terms) - 1
    if type(node) is Product:
        first, rest = split(node)
        shown = (abs(first.value.numerator) != 1) + (0 if type(rest) is not Product else len(rest.factors) - 1)
        return shown + (first.value.denominator != 1)
    if type(node) is Number:
        return 0
    return abs(node.exponent.numerator) - 1 if type(node) is Power and node.exponent.denominator == 1 else 0
