"""Exact angles: a sum of joint angles and constants that never meets a float before it has to.

`theta2 + theta3 - 90°` keeps its names and its ninety degrees, so cos 90° is 0 before any arithmetic begins.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from fractions import Fraction
from typing import TypeAlias

from dhcli.frozen import frozen
from dhcli.notation.names import natural_key

Rational: TypeAlias = int | Fraction
"""An exact number. A whole one need be no fraction, with which Python computes ten times as long; but the quotient of
two whole ones is a float, and so a quotient is written `Fraction(a, b)`, and a power to a negative exponent of one."""

ZERO, ONCE = 0, 1
"""What most angles are made of."""

FULL_TURN = 360
FULL_TURN_IN_RADIANS = Fraction(44, 7)
"""A number beyond this beside a joint angle is meant in degrees, or `rad` would stand behind it."""


FINEST = 1 << 1000
"""Largest denominator in a sum of angles; fractions beyond it make every step of the work a long one."""


class Hashed:
    """What is hashed once: the cosines in a formula are few, and are gathered again and again."""

    __slots__ = ("_hashed",)
    _hashed: int

    def hashed(self, key: object) -> int:
        """The hash of what an object is made of; its own, kept, if there is one."""
        found = hash(key)
        object.__setattr__(self, "_hashed", found)
        return found


@frozen
class Angle(Hashed):
    """An affine sum of named angles, with exact coefficients.

    Attributes:
        terms: Pairs of name and coefficient, in natural order of the names, no coefficient zero.
        degrees: The constant part that is a rational multiple of a turn, in degrees.
        radians: The constant part given in bare radians, such as 0.3.
    """

    terms: tuple[tuple[str, Rational], ...] = ()
    degrees: Rational = ZERO
    radians: Rational = ZERO

    def __eq__(self, other: object) -> bool:
        """Cheaper than comparing fractions: most have the same ones."""
        if type(other) is not Angle:
            return NotImplemented
        return (
            self.terms == other.terms
            and (self.degrees is other.degrees or self.degrees == other.degrees)
            and (self.radians is other.radians or self.radians == other.radians)
        )

    def __hash__(self) -> int:
        """Cheaper than hashing fractions, which costs a power modulo a prime each."""
        try:
            return self._hashed
        except AttributeError:
            terms, constant = self.terms, self.degrees.numerator
            if not terms:
                return self.hashed(constant)
            name, factor = terms[-1]
            return self.hashed((name, factor.numerator, factor.denominator, len(terms), terms[0][0], constant))

    def __str__(self) -> str:
        """With its units, `theta1 + 90°`."""
        from dhcli.notation.writer import write_angle

        return write_angle(self)

    def __repr__(self) -> str:
        """The same, for the prompt."""
        return str(self)

    @classmethod
    def of(cls, name: str) -> Angle:
        """The angle that a single name stands for."""
        return cls(((name, ONCE),))

    @classmethod
    def in_degrees(cls, value: Rational) -> Angle:
        """A constant angle."""
        return cls(degrees=value)

    @property
    def names(self) -> frozenset[str]:
        """The names that occur."""
        return frozenset(name for name, _ in self.terms)

    @property
    def is_zero(self) -> bool:
        """Whether nothing is left; 360° is not zero as an angle, though its cosine is that of zero."""
        return not self.terms and not self.degrees and not self.radians

    def __add__(self, other: Angle) -> Angle:
        """The sum.

        Raises:
            OverflowError: A fraction in it has more digits than anything that is measured.
        """
        if not other.terms:
            terms = self.terms
        elif not self.terms:
            terms = other.terms
        else:
            terms = _collect((*self.terms, *other.terms))
        return Angle(terms, _plus(self.degrees, other.degrees), _plus(self.radians, other.radians))

    def __neg__(self) -> Angle:
        return Angle(tuple([(name, -factor) for name, factor in self.terms]), -self.degrees, -self.radians)

    def __sub__(self, other: Angle) -> Angle:
        return self + (-other)

    def __mul__(self, factor: Rational) -> Angle:
        if factor == 0:
            return Angle()
        terms = tuple([(name, coefficient * factor) for name, coefficient in self.terms])
        return Angle(terms, self.degrees * factor, self.radians * factor)

    def quarter_turns(self) -> int | None:
        """How many right angles this is, 0 to 3, or None if it is not a whole number of them."""
        if self.terms or self.radians or self.degrees.denominator != 1:
            return None
        quarters, rest = divmod(self.degrees.numerator, 90)
        return None if rest else quarters % 4

    def substitute(self, values: Mapping[str, object]) -> Angle:
        """The same sum with some names replaced by the angles that they are; of other values nothing is taken."""
        known = {name: value for name, _ in self.terms if isinstance(value := values.get(name), Angle)}
        if not known:
            return self
        if len(self.terms) == 1 and self.terms[0][1] == 1 and not self.degrees and not self.radians:
            return known[self.terms[0][0]]  # a joint by itself, as most are
        total = Angle((), self.degrees, self.radians)
        for name, factor in self.terms:
            value = known.get(name)
            total += Angle(((name, factor),)) if value is None else value * factor
        return total

    def rename(self, names: Callable[[str], str]) -> Angle:
        """The same sum under other names."""
        return Angle(_collect((names(name), factor) for name, factor in self.terms), self.degrees, self.radians)

    def constant(self) -> float:
        """The constant part [rad]."""
        return (math.radians(self.degrees) if self.degrees else 0.0) + (float(self.radians) if self.radians else 0.0)


def magnitude(value: Rational) -> Rational:
    """The absolute value; the type checker knows `abs` of a whole number, and of a fraction, but not of either."""
    return -value if value < 0 else value


def _plus(first: Rational, second: Rational) -> Rational:
    """The sum of two constant parts, most of which are 0."""
    if second is ZERO:
        return first
    if first is ZERO:
        return second
    total = first + second
    if total.denominator > FINEST:
        raise OverflowError
    return total


def _collect(terms: Iterable[tuple[str, Rational]]) -> tuple[tuple[str, Rational], ...]:
    total: dict[str, Rational] = {}
    for name, factor in terms:
        total[name] = _plus(total.get(name, ZERO), factor)
    return tuple(sorted(((n, f) for n, f in total.items() if f), key=lambda term: natural_key(term[0])))
