"""Names for brackets that occur more than once, as a lecturer writes a long result: `let k1 = c4*c5*c6 - s4*s6`."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TypeAlias

from dhcli.frozen import frozen
from dhcli.notation.tree import Expr, Power, Product, Sum, Symbol, negate
from dhcli.notation.walk import children, operations, symbols_in

LONG = 12
"""Operations above which a bracket gets a name even if it occurs once."""

Rows: TypeAlias = Sequence[Sequence[Expr]]


@frozen
class Definition:
    """An intermediate result.

    Attributes:
        name: Its name, k1, k2, ...
        expr: What it stands for, in names that are defined before it.
    """

    name: str
    expr: Expr


def name_parts(rows: Rows) -> tuple[tuple[Definition, ...], tuple[tuple[Expr, ...], ...]]:
    """Give names to brackets that occur more than once or are long.

    Args:
        rows: Expressions, such as the entries of one matrix or of several.

    Returns:
        The definitions, each in terms of those before it, and the rows with the names put in. Putting the
        definitions back gives the rows as they were, up to the order of terms.
    """
    entries = [entry for row in rows for entry in row]
    naming = _Naming(entries)
    named = [naming.entry(entry) for entry in entries]
    replaced = iter(named)
    return tuple(naming.definitions), tuple(tuple(next(replaced) for _ in row) for row in rows)


_Key: TypeAlias = frozenset[Expr]
"""A bracket without the order of its terms."""


class _Naming:
    def __init__(self, entries: Sequence[Expr]) -> None:
        self.taken = symbols_in(entries)
        self.counts: dict[_Key, int] = {}
        self.names: dict[_Key, Expr] = {}
        self.definitions: list[Definition] = []
        self.fresh = self.new_names()
        for entry in entries:
            self.count(entry)

    def count(self, node: Expr) -> None:
        """Count the brackets at and below a node; what stands in a bracket counts once however often it occurs."""
        if type(node) is Sum:
            key, _ = self.key_of(node)
            self.counts[key] = self.counts.get(key, 0) + 1
            if self.counts[key] > 1:
                return
        for child in children(node):
            self.count(child)

    def key_of(self, node: Sum) -> tuple[_Key, bool]:
        """The key under which a bracket or its opposite is known, and whether it is the opposite."""
        key = frozenset(node.terms)
        if key not in self.counts:
            opposite = frozenset(map(negate, node.terms))
            if opposite in self.counts:
                return opposite, True
        return key, False

    def entry(self, node: Expr) -> Expr:
        """An entry of the matrix, which has a name of its own already unless it occurs elsewhere."""
        if type(node) is Sum and self.counts[self.key_of(node)[0]] == 1:
            return Sum(tuple(map(self.put_in, node.terms)))
        return self.put_in(node)

    def put_in(self, node: Expr) -> Expr:
        """A node with names in the place of brackets. The constructors would move the names to the front."""
        if type(node) is Product:
            return _flat_product(tuple(map(self.put_in, node.factors)))
        if type(node) is Power:
            return Power(self.put_in(node.base), node.exponent)
        if type(node) is not Sum:
            return node
        key, opposite = self.key_of(node)
        if key not in self.names:
            body = Sum(tuple(map(self.put_in, node.terms)))
            if self.counts[key] == 1 and operations(body) <= LONG:
                return body
            if opposite:
                body = Sum(tuple(map(negate, body.terms)))
            self.names[key] = Symbol(next(self.fresh))
            self.definitions.append(Definition(self.names[key].name, body))  # type: ignore[attr-defined]
        return negate(self.names[key]) if opposite else self.names[key]

    def new_names(self) -> Iterator[str]:
        number = 0
        while True:
            number += 1
            if f"k{number}" not in self.taken:
                yield f"k{number}"


def _flat_product(factors: tuple[Expr, ...]) -> Expr:
    """A product in which a name with a minus has become a product of its own."""
    flat = [inner for factor in factors for inner in (factor.factors if type(factor) is Product else (factor,))]
    signs = [factor for factor in flat if _is_minus_one(factor)]
    rest = tuple(factor for factor in flat if not _is_minus_one(factor))
    product = rest[0] if len(rest) == 1 else Product(rest)
    return negate(product) if len(signs) % 2 else product


def _is_minus_one(factor: Expr) -> bool:
    from dhcli.notation.tree import MINUS_ONE

    return factor == MINUS_ONE
