"""Residues modulo a random prime: the arithmetic in which two expressions are compared.

Let `e^{iθ}` go to a random unit z of F_p, then cos θ = (z + 1/z)/2 and sin θ = (z - 1/z)/(2i). With p = 1 mod 720
the field holds i, √2, √3, √5 and a consistent cosine for every multiple of half a degree, so every identity of
trigonometry holds for residues too; with p = 1 mod 7, 11 ... 31 it holds the roots of these primes besides. Unequal
residues prove two expressions unequal; equal ones of degree d may be an accident with probability at most d/p, far
below 2^-100 for a random prime of 127 bits.
Source: the idea of `testeq`, G. Gonnet, Determining equivalence of expressions in random polynomial time, 1984.
"""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Iterable, Mapping
from functools import lru_cache

from dhcli.algebra.arithmetic import CannotHoldError, evaluate, right_angle
from dhcli.notation.angle import Angle, Rational
from dhcli.notation.tree import Expr, Trig
from dhcli.notation.walk import walk

STEPS = 720
"""Steps of a full turn that the field holds: multiples of half a degree."""

ROOTED = (7, 11, 13, 17, 19, 23, 29, 31)
"""Primes whose square roots the field holds besides those of 2, 3 and 5, which are combinations of cosines."""

RADIAN = "rad"
"""The name under which one radian has a random unit, for e^i is transcendental; no joint is called so."""

ROUNDS = 24
"""Bases that a prime is tried with."""

LARGEST_RADICAND = 10**12
"""Roots are taken of small integers; a larger residue is the image of some expression."""

_SQUARES: Mapping[int, Callable[[Field], int]] = {
    2: lambda field: field.two_cosines(STEPS // 8),
    3: lambda field: field.two_cosines(STEPS // 12),
    5: lambda field: (2 * field.two_cosines(STEPS // 5) + 1) % field.prime,
}
"""Square roots as combinations of cosines: 2 cos 45° = √2, 2 cos 30° = √3, 4 cos 72° + 1 = √5."""


class Field:
    """The integers modulo a prime p = 1 mod 720."""

    def __init__(self, prime: int) -> None:
        """Find a primitive 720th root of unity."""
        self.prime: int = prime
        self._unit = self._primitive()
        self.i = self.root_of_unity(STEPS // 4)

    def inverse(self, value: int) -> int:
        """1/value.

        Raises:
            ZeroDivisionError: The value is 0 modulo the prime.
        """
        if value % self.prime == 0:
            raise ZeroDivisionError
        return pow(value, -1, self.prime)

    def root_of_unity(self, steps: int) -> int:
        """e^{iφ} for an angle of so many half degrees."""
        return pow(self._unit, steps % STEPS, self.prime)

    def two_cosines(self, steps: int) -> int:
        """2 cos φ for an angle of so many half degrees."""
        return (self.root_of_unity(steps) + self.root_of_unity(-steps)) % self.prime

    def square_root(self, value: Rational) -> int:
        """The root of a rational whose prime factors are at most 31, with any square.

        Raises:
            CannotHoldError: Another prime stands under the root.
        """
        inside, outside, root = value.numerator * value.denominator, 1, 1
        if inside < 0:
            inside, root = -inside, self.i
        for prime in (*_SQUARES, *ROOTED):
            while inside % (prime * prime) == 0:
                inside //= prime * prime
                outside *= prime
            if inside % prime == 0:
                inside //= prime
                root = root * self._root_of(prime) % self.prime
        whole = math.isqrt(inside)
        if whole * whole != inside:
            raise CannotHoldError
        return outside * whole * root * self.inverse(value.denominator) % self.prime

    def _root_of(self, prime: int) -> int:
        """√2, √3, √5 by cosines; √q by Gauss's sum of e^{2πi k²/q}, which is √q, or i√q where q = 3 mod 4."""
        if prime in _SQUARES:
            return _SQUARES[prime](self)
        if (self.prime - 1) % prime:
            raise CannotHoldError
        powers = (pow(candidate, (self.prime - 1) // prime, self.prime) for candidate in range(2, 1000))
        unit = next(power for power in powers if power != 1)
        total = sum(pow(unit, k * k % prime, self.prime) for k in range(prime)) % self.prime
        return total if prime % 4 == 1 else total * self.inverse(self.i) % self.prime

    def _primitive(self) -> int:
        for candidate in range(2, 1000):
            unit = pow(candidate, (self.prime - 1) // STEPS, self.prime)
            if all(pow(unit, STEPS // factor, self.prime) != 1 for factor in (2, 3, 5)):
                return unit
        raise ArithmeticError


@lru_cache(maxsize=1)
def field_of_the_day() -> Field:
    """A field that is drawn once in a process."""
    return random_field()


def random_field() -> Field:
    """A field with a random 127-bit prime."""
    step = math.prod(ROOTED) * STEPS
    while True:
        prime = (random_below(1 << 84) | 1 << 84) * step + 1
        if is_prime(prime):
            return Field(prime)


def random_below(limit: int) -> int:
    """A random integer from 0 to limit - 1; the standard module for it takes longer to import than a proof takes."""
    size = limit.bit_length() + 64
    return int.from_bytes(os.urandom((size + 7) // 8), "big") % limit


def is_prime(value: int) -> bool:
    """Miller-Rabin with random bases; wrong with probability below 4^-24."""
    for small in (3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53, 59, 61, 67, 71, 73):
        if value % small == 0:
            return value == small
    odd, twos = value - 1, 0
    while odd % 2 == 0:
        odd, twos = odd // 2, twos + 1
    for _ in range(ROUNDS):
        witness = pow(random_below(value - 3) + 2, odd, value)
        if witness in (1, value - 1):
            continue
        for _ in range(twos - 1):
            witness = witness * witness % value
            if witness == value - 1:
                break
        else:
            return False
    return True


class Residues:
    """A random point: every name has a random residue, and every angle a random unit."""

    def __init__(
        self,
        expressions: Iterable[Expr] = (),
        angles: Iterable[Angle] = (),
        scale: int = 1,
        field: Field | None = None,
    ) -> None:
        """Prepare a point for some expressions and angles.

        Args:
            expressions: Trees that will be evaluated, looked through for fractions of angles.
            angles: Angles that will occur besides.
            scale: A common denominator that the fractions of angles have at least.
            field: The field; by default that of the day.
        """
        self.field = field or field_of_the_day()
        self._scale = math.lcm(scale, *_denominators(expressions, angles))
        self._units: dict[str, tuple[int, int]] = {}
        self._numbers: dict[str, int] = {}

    def holds(self, expressions: Iterable[Expr], angles: Iterable[Angle]) -> bool:
        """Whether the point was prepared for the fractions of other angles, too."""
        return all(self._scale % denominator == 0 for denominator in _denominators(expressions, angles))

    def cos_sin(self, angle: Angle) -> tuple[int, int]:
        """Cosine and sine as residues.

        Raises:
            CannotHoldError: An angle finer than half a degree.
        """
        exact = right_angle(angle)
        if exact is not None:
            return exact
        if (angle.degrees * 2).denominator != 1:
            raise CannotHoldError
        prime = self.field.prime
        steps = int(angle.degrees * 2)
        unit, inverse = self.field.root_of_unity(steps), self.field.root_of_unity(-steps)
        for name, factor in (*angle.terms, *(((RADIAN, angle.radians),) if angle.radians else ())):
            exponent = factor * self._scale
            if exponent.denominator != 1:
                raise CannotHoldError
            known = self._unit(name)
            forward, backward = known if exponent > 0 else known[::-1]
            unit = unit * pow(forward, abs(exponent.numerator), prime) % prime
            inverse = inverse * pow(backward, abs(exponent.numerator), prime) % prime
        half = (prime + 1) // 2
        return (unit + inverse) * half % prime, (inverse - unit) * self.field.i * half % prime

    def length(self, expr: Expr) -> int:
        """An expression of lengths as a residue."""
        return self.value(expr)

    def value(self, expr: Expr | int) -> int:
        """An expression, or a number that the fold left behind, reduced modulo the prime."""
        return (expr if isinstance(expr, int) else evaluate(expr, self)) % self.field.prime

    def constant(self, value: int) -> int:
        """The same integer."""
        return value

    def number(self, value: Rational) -> int:
        """A fraction as a residue."""
        return value.numerator * self.field.inverse(value.denominator) % self.field.prime

    def symbol(self, name: str) -> int:
        """The random residue of a name."""
        if name not in self._numbers:
            self._numbers[name] = random_below(self.field.prime - 1) + 1
        return self._numbers[name]

    def pi(self) -> int:
        """The number π is transcendental, so it is one more name."""
        return self.symbol("π")

    def power(self, base: int, exponent: Rational) -> int:
        """A whole power; roots are known for rationals only."""
        if exponent.denominator == 1:
            if exponent < 0:
                base = self.field.inverse(base)
            return pow(base, abs(exponent.numerator), self.field.prime)
        if exponent.denominator != 2 or base > LARGEST_RADICAND:  # noqa: PLR2004  a square root
            raise CannotHoldError
        root = self.field.square_root(base)
        return self.power(root, exponent.numerator)

    def call(self, function: str, arguments: list[int]) -> int:
        """No other function has a value among residues."""
        raise CannotHoldError

    def _unit(self, name: str) -> tuple[int, int]:
        if name not in self._units:
            unit = random_below(self.field.prime - 2) + 2
            self._units[name] = (unit, self.field.inverse(unit))
        return self._units[name]


def _denominators(expressions: Iterable[Expr], angles: Iterable[Angle]) -> Iterable[int]:
    """The fractions of names and of a radian that stand in angles."""
    for angle in (*_angles(expressions), *angles):
        yield angle.radians.denominator
        for _, factor in angle.terms:
            yield factor.denominator


def _angles(expressions: Iterable[Expr]) -> Iterable[Angle]:
    for expr in expressions:
        yield from (node.angle for node in walk(expr) if type(node) is Trig)
