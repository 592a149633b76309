"""Three ways to write a polynomial in lengths, cosines, sines: nested, multiplied out, contracted; the shortest wins.

A cosine and a sine of sums stay as they are; `c3*c23 + s3*s23` becomes `c2` only where somebody asks for `contracted`.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from itertools import combinations
from typing import TypeAlias

from dhcli.notation.tree import (
    ZERO,
    Expr,
    Number,
    Power,
    Product,
    Sum,
    Trig,
    add,
    factor_key,
    is_negative,
    multiply,
    negate,
    number,
    power,
    split,
)
from dhcli.notation.trig import cosine, sine
from dhcli.notation.walk import operations

Monomial: TypeAlias = frozenset[tuple[Expr, int]]
"""Bases with their exponents; the number in front stands elsewhere."""

Polynomial: TypeAlias = dict[Monomial, Fraction]

MOST_TERMS = 400
"""More terms than this are not multiplied out."""


class TooLongError(ArithmeticError):
    """A product with more terms than anybody would read."""


def factors_of(expr: Expr) -> tuple[Fraction, dict[Expr, int]]:
    """An expression as a number and its factors with whole exponents; a sum gives what its terms share."""
    if type(expr) is Number:
        return expr.value, {}
    if type(expr) is Product:
        value, found = Fraction(1), dict[Expr, int]()
        for factor in expr.factors:
            own, inner = factors_of(factor)
            value *= own
            for base, exponent in inner.items():
                found[base] = found.get(base, 0) + exponent
        return value, found
    if type(expr) is Power and expr.exponent.denominator == 1:
        value, found = factors_of(expr.base)
        exponent = expr.exponent.numerator
        return value**exponent, {base: own * exponent for base, own in found.items()}
    if type(expr) is Sum:
        return _shared(expr)
    return Fraction(1), {expr: 1}


def _shared(expr: Sum) -> tuple[Fraction, dict[Expr, int]]:
    """What all terms of a sum have as a factor, and the bracket that is left."""
    taken = [factors_of(term) for term in expr.terms]
    common = {base: least for base in taken[0][1] if (least := min(factors.get(base, 0) for _, factors in taken)) > 0}
    sign = -1 if taken[0][0] < 0 else 1
    sizes = {abs(value) for value, _ in taken}
    size = sizes.pop() if len(sizes) == 1 else Fraction(1)
    if not common and size == 1:
        rest = negate(expr) if sign < 0 else expr
        return Fraction(sign), {rest: 1}
    terms = [
        product(value / (size * sign), {b: e - common.get(b, 0) for b, e in factors.items()})
        for value, factors in taken
    ]
    value, found = factors_of(add(*terms))
    for base, exponent in common.items():
        found[base] = found.get(base, 0) + exponent
    return value * size * sign, found


def product(value: Fraction, factors: dict[Expr, int]) -> Expr:
    """A number times factors with exponents."""
    return multiply(number(value), *(power(base, exponent) for base, exponent in factors.items() if exponent))


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


def _without_common(rows: Sequence[Sequence[Expr]]) -> tuple[Fraction, dict[Expr, int], list[list[Expr]]]:
    """What the entries of a row or column share, and the rest of the matrix."""
    value, taken = Fraction(1), dict[Expr, int]()
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


def shortest(expr: Expr) -> tuple[Fraction, dict[Expr, int]]:
    """An expression in factors, each in the shortest of its forms."""
    value, factors = factors_of(expr)
    found: dict[Expr, int] = {}
    for base, exponent in factors.items():
        own, inner = _shortest(base) if type(base) is Sum else (Fraction(1), {base: 1})
        value *= own**exponent
        for one, times in inner.items():
            found[one] = found.get(one, 0) + times * exponent
    return value, found


def _shortest(expr: Sum) -> tuple[Fraction, dict[Expr, int]]:
    candidates: list[Expr] = [expr]
    try:
        terms = expanded(expr)
        candidates += [_written(terms), grouped(terms)]
        fewer = contracted(terms)
        candidates += [_written(fewer), grouped(fewer)]
    except TooLongError:
        pass
    ways = [factors_of(candidate) for candidate in candidates]
    value, factors = min(ways, key=lambda found: operations(product(*found)))
    found: dict[Expr, int] = {}
    for base, exponent in factors.items():
        ordered = _in_order(base)
        if ordered is not base and is_negative(ordered.terms[0]):  # type: ignore[attr-defined]
            ordered, value = negate(ordered), value * (-1) ** exponent
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


def expanded(expr: Expr) -> Polynomial:
    """A sum of monomials; squares of a cosine and a sine of one angle with the same rest become 1.

    Raises:
        TooLongError: It has too many terms.
    """
    return _pythagoras(_expanded(expr))


def _expanded(expr: Expr) -> Polynomial:
    if type(expr) is Number:
        return {frozenset(): expr.value} if expr.value else {}
    if type(expr) is Sum:
        total: Polynomial = {}
        for term in expr.terms:
            _add(total, _expanded(term))
        return total
    if type(expr) is Product:
        total = {frozenset(): Fraction(1)}
        for factor in expr.factors:
            total = _multiplied(total, _expanded(factor))
        return total
    if type(expr) is Power and expr.exponent.denominator == 1 and expr.exponent > 0:
        total = {frozenset(): Fraction(1)}
        for _ in range(expr.exponent.numerator):
            total = _multiplied(total, _expanded(expr.base))
        return total
    return {frozenset({(expr, 1)}): Fraction(1)}


def _add(total: Polynomial, other: Polynomial) -> None:
    for monomial, value in other.items():
        total[monomial] = total.get(monomial, Fraction(0)) + value
        if not total[monomial]:
            del total[monomial]


def _multiplied(one: Polynomial, other: Polynomial) -> Polynomial:
    if len(one) * len(other) > MOST_TERMS:
        raise TooLongError
    total: Polynomial = {}
    for a, x in one.items():
        for b, y in other.items():
            _add(total, {_merged(a, b): x * y})
    return total


def _merged(a: Monomial, b: Monomial) -> Monomial:
    together = dict(a)
    for base, exponent in b:
        together[base] = together.get(base, 0) + exponent
    return frozenset((base, exponent) for base, exponent in together.items() if exponent)


def _pythagoras(terms: Polynomial) -> Polynomial:
    """x·c² + x·s² is x, again and again."""
    changed = True
    while changed:
        changed = False
        for monomial, value in list(terms.items()):
            for base, exponent in monomial:
                if type(base) is not Trig or exponent < 2 or base.function != "cos":  # noqa: PLR2004  a square
                    continue
                rest = _merged(monomial, frozenset({(base, -2)}))
                partner = _merged(rest, frozenset({(Trig("sin", base.angle), 2)}))
                if terms.get(partner) == value:
                    del terms[monomial], terms[partner]
                    _add(terms, {rest: value})
                    changed = True
                    break
            if changed:
                break
    return terms


def contracted(terms: Polynomial) -> Polynomial:
    """Pairs such as c·c' + s·s' put together, wherever that leaves fewer terms."""
    terms = dict(terms)
    while (pair := _pair(terms)) is not None:
        one, other, value, merged = pair
        del terms[one], terms[other]
        _add(terms, {m: value * v for m, v in merged.items()})
    return _pythagoras(terms)


def _pair(terms: Polynomial) -> tuple[Monomial, Monomial, Fraction, Polynomial] | None:
    """Two terms that an addition theorem makes one."""
    for one, other in combinations(terms, 2):
        if abs(terms[one]) != abs(terms[other]):
            continue
        mine, yours = one - other, other - one
        first, second = _pure_trigs(mine), _pure_trigs(yours)
        if first is None or second is None:
            continue
        sign = terms[other] / terms[one]
        found = _together(first, second, sign)
        if found is not None:
            return one, other, terms[one], _multiplied({one & other: Fraction(1)}, _expanded(found))
    return None


def _pure_trigs(monomial: Monomial) -> tuple[Trig, Trig] | None:
    """The two cosines or sines that a monomial is, if it is."""
    found = sorted((base for base, exponent in monomial if exponent == 1 and type(base) is Trig), key=str)
    return (found[0], found[1]) if len(found) == 2 == len(monomial) else None  # noqa: PLR2004


def _together(first: tuple[Trig, Trig], second: tuple[Trig, Trig], sign: Fraction) -> Expr | None:
    """The sum of a product of two and another such product by an addition theorem, or None."""
    (a, b), (c, d) = first, second
    if {a.angle, b.angle} != {c.angle, d.angle}:
        return None
    if c.angle != a.angle:
        c, d = d, c
    functions = a.function + b.function
    if a.angle == b.angle or c.function == a.function or d.function == b.function:
        return None
    if functions in {"coscos", "sinsin"}:
        result = cosine(a.angle + b.angle * (-1 if sign > 0 else 1))
        return result if functions == "coscos" or sign > 0 else negate(result)
    if functions == "sincos":
        return sine(a.angle + b.angle * (1 if sign > 0 else -1))
    return sine(b.angle + a.angle * (1 if sign > 0 else -1))


def grouped(terms: Polynomial) -> Expr:
    """A sum of monomials with the factor that most of them share taken out, and so on inside."""
    if len(terms) == 1:
        return _written(terms)
    counts: dict[Expr, int] = {}
    for monomial in terms:
        for base, exponent in monomial:
            if exponent > 0:
                counts[base] = counts.get(base, 0) + 1
    most = max(counts.values(), default=0)
    if most < 2:  # noqa: PLR2004  nothing is shared
        return _written(terms)
    base = next(base for base, count in counts.items() if count == most)
    unit = frozenset({(base, -1)})
    inside = {_merged(m, unit): v for m, v in terms.items() if dict(m).get(base, 0) > 0}
    outside = {m: v for m, v in terms.items() if dict(m).get(base, 0) <= 0}
    bracket = multiply(base, grouped(inside))
    return add(bracket, grouped(outside)) if outside else bracket


def _written(terms: Polynomial) -> Expr:
    return add(*(product(value, dict(monomial)) for monomial, value in terms.items())) if terms else ZERO
