"""Square roots of exact numbers, as a rational times the root of a small integer."""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache
from math import isqrt


@lru_cache(maxsize=1024)
def square_root(value: int | Fraction) -> tuple[Fraction, int]:
    """The square root of a number that is not negative, as a rational times the root of a small integer."""
    inside = value.numerator * value.denominator
    whole = isqrt(inside)
    if whole * whole == inside:
        return Fraction(whole, value.denominator), 1
    outside = 1
    for prime in (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31):
        while inside % (prime * prime) == 0:
            inside //= prime * prime
            outside *= prime
    return Fraction(outside, value.denominator), inside
