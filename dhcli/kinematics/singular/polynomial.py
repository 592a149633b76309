"""Polynomials in lengths, cosines and sines: multiplied out, contracted by addition theorems, grouped.

A cosine and a sine of sums stay as they are; `c3*c23 + s3*s23` becomes `c2` only where somebody asks for `contracted`.
"""

from __future__ import annotations

from itertools import combinations
from typing import TypeAlias

from dhcli.notation.angle import Angle, Rational, magnitude
from dhcli.notation.tree import ZERO, Expr, Number, Power, Product, Sum, Trig, add, multiply, negate, number, power
from dhcli.notation.trig import cosine, sine

Monomial: TypeAlias = frozenset[tuple[Expr, int]]
"""Bases with their exponents; the number in front stands elsewhere."""

Polynomial: TypeAlias = dict[Monomial, Rational]

MOST_DECIMALS = 16

MOST_TERMS = 400
"""More terms than this are not multiplied out."""


class TooLongError(ArithmeticError):
    """A product with more terms than anybody would read."""


def product(value: Rational, factors: dict[Expr, int]) -> Expr:
    """A number times factors with exponents; a number of tenths is written with decimals, as lengths are."""
    places = _decimals(value)
    return multiply(number(value, places), *(power(base, exponent) for base, exponent in factors.items() if exponent))


def _decimals(value: Rational) -> int | None:
    """Decimals of a number such as 0.12; None for one that is better shown as a fraction, such as 1/4 or 1/3."""
    if value.denominator % 5:
        return None
    return next((places for places in range(1, MOST_DECIMALS) if 10**places % value.denominator == 0), None)


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
        total = {frozenset(): 1}
        for factor in expr.factors:
            total = _multiplied(total, _expanded(factor))
        return total
    if type(expr) is Power and expr.exponent.denominator == 1 and expr.exponent > 0:
        total = {frozenset(): 1}
        for _ in range(expr.exponent.numerator):
            total = _multiplied(total, _expanded(expr.base))
        return total
    return {frozenset({(expr, 1)}): 1}


def _add(total: Polynomial, other: Polynomial) -> None:
    for monomial, value in other.items():
        total[monomial] = total.get(monomial, 0) + value
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


def _pair(terms: Polynomial) -> tuple[Monomial, Monomial, Rational, Polynomial] | None:
    """Two terms that an addition theorem makes one."""
    for one, other in combinations(terms, 2):
        if magnitude(terms[one]) != magnitude(terms[other]):
            continue
        mine, yours = one - other, other - one
        if not (_are_two_trigs(mine) and _are_two_trigs(yours) and _angles(mine) == _angles(yours)):
            continue
        sign = 1 if terms[other] == terms[one] else -1
        found = _together(_in_order(mine), _in_order(yours), sign)
        if found is not None:
            return one, other, terms[one], _multiplied({one & other: 1}, _expanded(found))
    return None


def _are_two_trigs(monomial: Monomial) -> bool:
    """Whether a monomial is a cosine or sine times another."""
    return len(monomial) == 2 and all(exponent == 1 and type(base) is Trig for base, exponent in monomial)  # noqa: PLR2004


def _angles(trigs: Monomial) -> set[Angle]:
    return {base.angle for base, _ in trigs if type(base) is Trig}


def _in_order(trigs: Monomial) -> tuple[Trig, Trig]:
    """The two of them, always in the same order."""
    first, second = sorted((base for base, _ in trigs if type(base) is Trig), key=str)
    return first, second


def _together(first: tuple[Trig, Trig], second: tuple[Trig, Trig], sign: int) -> Expr | None:
    """The sum of a product of two and another such product of the same angles by an addition theorem, or None."""
    (a, b), (c, d) = first, second
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
        return written(terms)
    counts: dict[Expr, int] = {}
    for monomial in terms:
        for base, exponent in monomial:
            if exponent > 0:
                counts[base] = counts.get(base, 0) + 1
    most = max(counts.values(), default=0)
    if most < 2:  # noqa: PLR2004  nothing is shared
        return written(terms)
    base = next(base for base, count in counts.items() if count == most)
    unit = frozenset({(base, -1)})
    inside = {_merged(m, unit): v for m, v in terms.items() if dict(m).get(base, 0) > 0}
    outside = {m: v for m, v in terms.items() if dict(m).get(base, 0) <= 0}
    bracket = multiply(base, grouped(inside))
    return add(bracket, grouped(outside)) if outside else bracket


def written(terms: Polynomial) -> Expr:
    """The monomials one after the other."""
    return add(*(product(value, dict(monomial)) for monomial, value in terms.items())) if terms else ZERO
