"""Expressions as n-ary trees: what the parser builds, what the symbolic product builds, what the writer prints.

The constructors `add`, `multiply` and `power` here, `cosine` and `sine` in `trig`, keep every tree in one shape:
nested sums and products are flat, numbers are collected exactly, factors stand in the order a textbook gives them,
like terms are gathered, and a bracket that is multiplied starts with a positive term. Nothing is ever distributed or
contracted: a factor times a sum stays a factor times a sum, and the sine of a sum stays the sine of a sum.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import field
from fractions import Fraction
from functools import lru_cache
from itertools import pairwise
from operator import itemgetter
from typing import Literal

from dhcli.frozen import frozen
from dhcli.notation.angle import ONCE, Angle, Hashed, Rational
from dhcli.notation.names import natural_key
from dhcli.notation.roots import square_root

HALF = Fraction(1, 2)
MOST_PLACES = 60
"""With more decimals than this a number is shown as a fraction."""

MOST_BITS = 1000
"""Numbers above this size are refused: no float holds them, and towers of powers must not run away."""


class Expr(Hashed):
    """Base of every node; gives the four operations."""

    __slots__ = ()

    def __add__(self, other: Expr | int) -> Expr:
        return add(self, _lift(other))

    def __radd__(self, other: int) -> Expr:
        return add(_lift(other), self)

    def __sub__(self, other: Expr | int) -> Expr:
        return add(self, negate(_lift(other)))

    def __rsub__(self, other: int) -> Expr:
        return add(_lift(other), negate(self))

    def __mul__(self, other: Expr | int) -> Expr:
        return multiply(self, _lift(other))

    def __rmul__(self, other: int) -> Expr:
        return multiply(_lift(other), self)

    def __neg__(self) -> Expr:
        return negate(self)

    def __str__(self) -> str:
        """The textbook form, `a1*c1 + a2*c12`."""
        from dhcli.notation.writer import write

        return write(self)

    def __repr__(self) -> str:
        """The same, for the prompt."""
        return str(self)

    def _repr_latex_(self) -> str:
        from dhcli.notation.writer import write

        return f"$\\displaystyle {write(self, 'latex')}$"


@frozen
class Number(Expr):
    """An exact rational number.

    Attributes:
        value: The number.
        places: Decimal places to show it with; None shows a fraction.
    """

    value: Rational
    places: int | None = field(default=None, compare=False)

    def __hash__(self) -> int:
        """Cheaper than hashing the fraction, which costs a power modulo a prime."""
        return hash((self.value.numerator, self.value.denominator))


@frozen
class Symbol(Expr):
    """A length, or any other number known by its name."""

    name: str


@frozen
class Constant(Expr):
    """The number π; its value is known to every arithmetic."""

    name: Literal["pi"] = "pi"


@frozen
class Unit(Expr):
    """A unit behind a number, `mm` or `deg`; `quantity` turns it into metres or an angle."""

    name: str


@frozen
class Trig(Expr):
    """Cosine or sine of an exact angle; built by `cosine` and `sine`, which normalise the angle."""

    function: Literal["cos", "sin"]
    angle: Angle

    def __eq__(self, other: object) -> bool:
        """At once; see `Angle`."""
        if type(other) is not Trig:
            return NotImplemented
        return self.function == other.function and (self.angle is other.angle or self.angle == other.angle)

    def __hash__(self) -> int:
        """Kept; see `Hashed`."""
        try:
            return self._hashed
        except AttributeError:
            return self.hashed((self.function, self.angle))


@frozen
class Sum(Expr):
    """Two or more terms."""

    terms: tuple[Expr, ...]

    def __hash__(self) -> int:
        """Kept; see `Hashed`."""
        try:
            return self._hashed
        except AttributeError:
            return self.hashed(("+", self.terms))


@frozen
class Product(Expr):
    """Two or more factors; a number, if any, comes first."""

    factors: tuple[Expr, ...]

    def __hash__(self) -> int:
        """Kept; see `Hashed`."""
        try:
            return self._hashed
        except AttributeError:
            return self.hashed(("*", self.factors))


@frozen
class Power(Expr):
    """A base to a rational exponent that is not 1; square roots are powers of one half."""

    base: Expr
    exponent: Rational

    def __hash__(self) -> int:
        """See `Number`."""
        return hash((self.base, self.exponent.numerator))


@frozen
class Call(Expr):
    """A function of expressions that is not a cosine or sine of an exact angle, such as atan2."""

    function: str
    arguments: tuple[Expr, ...]


ZERO = Number(0)
ONE = Number(1)
MINUS_ONE = Number(-1)
PI = Constant()


def number(value: Rational, places: int | None = None) -> Number:
    """An exact number, shown with the given decimal places or as a fraction."""
    return Number(value, places)


def decimal(value: Rational) -> Number:
    """An exact number, shown with as many decimals as say it: 0.05; as a fraction where none do."""
    return Number(value, places_of(value))


def places_of(value: Rational, most: int | None = None) -> int | None:
    """How many decimals say a fraction exactly; None where none do, or more than the most."""
    twos = fives = 0
    rest = value.denominator
    while rest % 2 == 0:
        rest, twos = rest // 2, twos + 1
    while rest % 5 == 0:
        rest, fives = rest // 5, fives + 1
    places = max(twos, fives)
    return places if rest == 1 and (most is None or places <= most) else None


def split(term: Expr) -> tuple[Number, Expr]:
    """A term as its numeric factor and the rest: `-2*a*c1` is -2 and `a*c1`; a number is itself times one."""
    if type(term) is Number:
        return term, ONE
    if type(term) is Product and type(term.factors[0]) is Number:
        rest = term.factors[1:]
        return term.factors[0], rest[0] if len(rest) == 1 else Product(rest)
    return ONE, term


def is_negative(term: Expr) -> bool:
    """Whether a term is written with a minus in front."""
    return split(term)[0].value < 0


def negate(expr: Expr) -> Expr:
    """The opposite; a sum is negated term by term, which costs no operation."""
    if type(expr) is Number:
        return Number(-expr.value, expr.places)
    if type(expr) is Sum:
        return Sum(tuple(negate(term) for term in expr.terms))
    if type(expr) is Product:
        head = expr.factors[0]
        if type(head) is Number:
            if head.value == -1:
                rest = expr.factors[1:]
                return rest[0] if len(rest) == 1 else Product(rest)
            return Product((Number(-head.value, head.places), *expr.factors[1:]))
        return Product((MINUS_ONE, *expr.factors))
    return Product((MINUS_ONE, expr))


def add(*terms: Expr) -> Expr:
    """The sum, flat, with like terms gathered where the first of them stands.

    Raises:
        OverflowError: A number in it has more than 1000 bits.
    """
    gathered: dict[Expr, Number] = {}
    for term in _flat(terms, Sum):
        factor, rest = split(term)
        known = gathered.get(rest)
        gathered[rest] = factor if known is None else _add_numbers(known, factor)
    kept = tuple(_scale(factor, rest) for rest, factor in gathered.items() if factor.value)
    if len(kept) == 1:
        return kept[0]
    return Sum(kept) if kept else ZERO


def multiply(*factors: Expr) -> Expr:
    """The product, flat, numbers collected in front, equal bases gathered, no bracket expanded."""
    plain = _plain_product(factors)
    if plain is not None:
        return plain
    number_part = ONE
    radicand: Rational = ONCE
    powers: dict[Expr, Rational] = {}
    for factor in _flat(factors, Product):
        if type(factor) is Number:
            if not factor.value:
                return ZERO
            number_part = _multiply_numbers(number_part, factor)
            continue
        if type(factor) is Sum and is_negative(factor.terms[0]):
            factor = negate(factor)  # noqa: PLW2901  the sign moves outside the bracket
            number_part = Number(-number_part.value, number_part.places)
        base, exponent = (factor.base, factor.exponent) if type(factor) is Power else (factor, ONCE)
        if type(base) is Number and exponent == HALF and base.value >= 0:
            radicand *= base.value
        else:
            known = powers.get(base)
            powers[base] = exponent if known is None else known + exponent
    if radicand is not ONCE:
        outside, root = square_root(radicand)
        number_part = _multiply_numbers(number_part, Number(outside))
        if root != 1:
            powers[Power(Number(root), HALF)] = ONCE
    kept = [
        base if exponent is ONCE or exponent == 1 else Power(base, exponent)
        for base, exponent in powers.items()
        if exponent or type(base) is Unit
    ]
    return _scale(number_part, *sorted(kept, key=factor_key))


def _plain_product(factors: tuple[Expr, ...]) -> Expr | None:
    """The product of names, cosines and sines, all of them others, and one bracket at most, as most products are.

    None where numbers but -1 or equal bases have to be gathered. What is the same has the same place in the order.
    """
    ordered: list[tuple[tuple[int, tuple[object, ...], bool], Expr]] = []
    has_bracket = minus = False
    for factor in _flat(factors, Product):
        if type(factor) is Trig:
            ordered.append((_trig_key(factor), factor))
            continue
        if type(factor) is Number and factor.places is None and factor.value == -1:
            minus = not minus
            continue
        if type(factor) is Sum and not has_bracket:
            has_bracket = True
            if is_negative(factor.terms[0]):
                factor, minus = negate(factor), not minus  # noqa: PLW2901  the sign moves outside the bracket
        elif type(factor) is not Symbol:
            return None
        ordered.append((factor_key(factor), factor))
    if len(ordered) < 2:  # noqa: PLR2004
        return None
    ordered.sort(key=itemgetter(0))
    if any(one[0] == other[0] for one, other in pairwise(ordered)):
        return None
    in_order = [factor for _, factor in ordered]
    return Product((MINUS_ONE, *in_order) if minus else tuple(in_order))


def power(base: Expr, exponent: Rational) -> Expr:
    """A power; exact where the base is a number and the exponent whole or one half.

    Raises:
        ZeroDivisionError: Zero to a negative exponent.
        OverflowError: The result has more than 1000 bits.
    """
    if exponent == 1:
        return base
    if exponent == 0 and type(base) is not Unit:  # units that cancel stay, so that a ratio is known for one
        return ONE
    if type(base) is Number:
        return _power_of_number(base, exponent)
    if type(base) is Power and exponent.denominator == 1:
        return power(base.base, base.exponent * exponent)
    if type(base) is Product and exponent.denominator == 1:
        return multiply(*(power(factor, exponent) for factor in base.factors))
    if type(base) is Sum and is_negative(base.terms[0]) and exponent.denominator == 1:
        return multiply(power(MINUS_ONE, exponent), Power(negate(base), exponent))
    return Power(base, exponent)


def factor_key(factor: Expr) -> tuple[int, tuple[object, ...], bool]:
    """Order of factors: roots, lengths, cosines and sines by their joints, brackets as they come, divisors last."""
    base, divides = (factor.base, factor.exponent < 0) if type(factor) is Power else (factor, False)
    if type(base) is Number:
        return (0, (base.value,), divides)
    if type(base) is Symbol:
        return (2, natural_key(base.name), divides)
    if type(base) is Trig:
        key = _trig_key(base)
        return (*key[:2], True) if divides else key
    return (1 if type(base) in (Constant, Unit) else 4, (), divides)


@lru_cache(4096)
def _trig_key(factor: Trig) -> tuple[int, tuple[object, ...], bool]:
    """Of a cosine or sine; a formula has few of them, and multiplies them again and again."""
    angle = factor.angle
    names = tuple(natural_key(name) for name, _ in angle.terms)
    multiples = tuple(multiple for _, multiple in angle.terms)
    return (3, (names, angle.degrees, angle.radians, factor.function, multiples), False)


def _lift(value: Expr | int) -> Expr:
    return Number(value) if isinstance(value, int) else value


def _flat(nodes: Iterable[Expr], kind: type[Sum | Product]) -> Iterator[Expr]:
    for node in nodes:
        if type(node) is kind:
            yield from node.terms if type(node) is Sum else node.factors  # type: ignore[union-attr]
        else:
            yield node


def _scale(factor: Number, *rest: Expr) -> Expr:
    """A number times factors that are in order already."""
    rest = tuple(node for node in rest if node is not ONE)
    if not rest:
        return factor
    if len(rest) == 1 and type(rest[0]) is Product:
        rest = rest[0].factors
    if factor is ONE or factor.value == 1:
        return rest[0] if len(rest) == 1 else Product(rest)
    if factor.value == -1 and len(rest) == 1 and type(rest[0]) is Sum:
        return negate(rest[0])
    return Product((factor, *rest))


def _add_numbers(first: Number, second: Number) -> Number:
    places = [n.places for n in (first, second) if n.places is not None]
    value = first.value + second.value
    if value.denominator != 1:
        _check_size(value)
    return Number(value, max(places) if places else None)


def _multiply_numbers(first: Number, second: Number) -> Number:
    if second.value == 1 and second.places is None:
        return first
    if first is ONE and second.places is None:
        _check_size(second.value)
        return second
    places = [n.places for n in (first, second) if n.places is not None]
    product = Number(first.value * second.value, sum(places) if 0 < sum(places) <= MOST_PLACES else None)
    _check_size(product.value)
    return product


def _power_of_number(base: Number, exponent: Rational) -> Expr:
    if exponent.denominator == 1:
        size = max(base.value.numerator.bit_length(), base.value.denominator.bit_length())
        if size * abs(exponent.numerator) > MOST_BITS:
            raise OverflowError
        value = Fraction(base.value) ** exponent.numerator
        return Number(value, places_of(value, MOST_PLACES) if base.places else None)
    if exponent.denominator == 2 and base.value >= 0:  # noqa: PLR2004  a square root
        outside, root = square_root(base.value)
        whole = power(Number(base.value), (exponent - HALF).numerator)
        return multiply(Number(outside), whole, Power(Number(root), HALF) if root != 1 else ONE)
    return Power(Number(base.value), exponent)


def _check_size(value: Rational) -> None:
    if value.numerator.bit_length() > MOST_BITS or value.denominator.bit_length() > MOST_BITS:
        raise OverflowError
