"""The factors of an expression, each in the shortest of its forms: nested, multiplied out, or contracted."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction

from dhcli.kinematics.singular.polynomial import TooLongError, contracted, expanded, grouped, product, written
from dhcli.notation.angle import Rational, magnitude
from dhcli.notation.tree import (
    ZERO,
    Expr,
    Number,
    Power,
    Product,
    Sum,
    add,
    factor_key,
    is_negative,
    multiply,
    negate,
    split,
)
from dhcli.notation.walk import operations


def factors_of(expr: Expr) -> tuple[Rational, dict[Expr, int]]:
    """An expression as a number and its factors with whole exponents; a sum gives what its terms share."""
    if type(expr) is Number:
        return expr.value, {}
    if type(expr) is Product:
        value: Rational = 1
        found = dict[Expr, int]()
        for factor in expr.factors:
            own, inner = factors_of(factor)
            value *= own
            for base, exponent in inner.items():
                found[base] = found.get(base, 0) + exponent
        return value, found
    if type(expr) is Power and expr.exponent.denominator == 1:
        value, found = factors_of(expr.base)
        exponent = expr.exponent.numerator
        return Fraction(value) ** exponent, {base: own * exponent for base, own in found.items()}
    if type(expr) is Sum:
        return _shared(expr)
    return 1, {expr: 1}


def _shared(expr: Sum) -> tuple[Rational, dict[Expr, int]]:
    """What all terms of a sum have as a factor, and the bracket that is left."""
    taken = [factors_of(term) for term in expr.terms]
    common = {base: least for base in taken[0][1] if (least := min(factors.get(base, 0) for _, factors in taken)) > 0}
    sign = -1 if taken[0][0] < 0 else 1
    sizes = {magnitude(value) for value, _ in taken}
    size = sizes.pop() if len(sizes) == 1 else 1
    if not common and size == 1:
        rest = negate(expr) if sign < 0 else expr
        return sign, {rest: 1}
    terms = [
        product(Fraction(value, size * sign), {b: e - common.get(b, 0) for b, e in factors.items()})
        for value, factors in taken
    ]
    value, found = factors_of(add(*terms))
    for base, exponent in common.items():
        found[base] = found.get(base, 0) + exponent
    return value * size * sign, found


def determinant(rows: Sequence[Sequence[Expr]]) -> Expr:
    """The determinant by Laplace, along the row or column with the fewest entries, common factors taken out first."""
    size = len(rows)
    if size == 1:
        return rows[0][0]
    value, taken, rest = _without_common(rows)
    outside = product(value, taken)
    columns = list(zip(*rest, strict=True))
    by_row = min(range(size), key=lambda k: _filled(rest[k]))
    by_column = min(range(size), key=lambda k: _filled(columns[k]))
    lines, line = (rest, by_row) if _filled(rest[by_row]) <= _filled(columns[by_column]) else (columns, by_column)
    terms = []
    for k, entry in enumerate(lines[line]):
        if entry == ZERO:
            continue
        minor = [[e for c, e in enumerate(row) if c != k] for r, row in enumerate(lines) if r != line]
        cofactor = multiply(entry, determinant(minor))
        terms.append(negate(cofactor) if (k + line) % 2 else cofactor)
    return multiply(outside, add(*terms) if terms else ZERO)


def _without_common(rows: Sequence[Sequence[Expr]]) -> tuple[Rational, dict[Expr, int], list[list[Expr]]]:
    """What the entries of a row or column share, and the rest of the matrix."""
    value: Rational = 1
    taken = dict[Expr, int]()
    table = [list(row) for row in rows]
    for _ in range(2):
        for k, row in enumerate(table):
            filled = [factors_of(entry) for entry in row if entry != ZERO]
            if not filled:
                continue
            common = {b: least for b in filled[0][1] if (least := min(f.get(b, 0) for _, f in filled)) > 0}
            if common:
                table[k] = [entry if entry == ZERO else _divided(entry, common) for entry in row]
                for base, exponent in common.items():
                    taken[base] = taken.get(base, 0) + exponent
        table = [list(column) for column in zip(*table, strict=True)]
    return value, taken, table


def _divided(entry: Expr, common: dict[Expr, int]) -> Expr:
    value, factors = factors_of(entry)
    return product(value, {base: exponent - common.get(base, 0) for base, exponent in factors.items()})


def _filled(entries: Iterable[Expr]) -> int:
    return sum(entry != ZERO for entry in entries)


def shortest(expr: Expr) -> tuple[Rational, dict[Expr, int]]:
    """An expression in factors, each in the shortest of its forms."""
    value, factors = factors_of(expr)
    found: dict[Expr, int] = {}
    for base, exponent in factors.items():
        own, inner = _shortest(base) if type(base) is Sum else (1, {base: 1})
        value *= Fraction(own) ** exponent
        for one, times in inner.items():
            found[one] = found.get(one, 0) + times * exponent
    return value, found


def _shortest(expr: Sum) -> tuple[Rational, dict[Expr, int]]:
    candidates: list[Expr] = [expr]
    try:
        terms = expanded(expr)
        candidates += [written(terms), grouped(terms)]
        fewer = contracted(terms)
        candidates += [written(fewer), grouped(fewer)]
    except TooLongError:
        pass
    ways = [factors_of(candidate) for candidate in candidates]
    value, factors = min(ways, key=lambda found: operations(product(*found)))
    found: dict[Expr, int] = {}
    for base, exponent in factors.items():
        ordered = _in_order(base)
        if ordered is not base and is_negative(ordered.terms[0]):  # type: ignore[attr-defined]
            ordered, value = negate(ordered), value * (-1 if exponent % 2 else 1)
        found[ordered] = exponent
    return value, found


def _in_order(base: Expr) -> Expr:
    """A bracket with the terms in front that begin with a length, as the rest of a book does it."""
    if type(base) is not Sum:
        return base
    terms = tuple(sorted(base.terms, key=lambda term: _leading(term) > 2))  # noqa: PLR2004  lengths are of class 2
    return base if terms == base.terms else Sum(terms)


def _leading(term: Expr) -> int:
    _, rest = split(term)
    return factor_key(rest.factors[0] if type(rest) is Product else rest)[0]
