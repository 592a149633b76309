"""Floats as the shortest text that is read back as the same float, many at once: what `repr` says, faster.

A float in [1e-4, 1e16) times a power of ten is brought to 17 digits before the point, exactly: as a float and what it
leaves (Dekker). The text may be any decimal nearer to that than half the distance to the next float; 17 digits are
always enough, and if a multiple of 10 or of 100 is near enough, it has fewer. The few cases that are too close to call,
and all other magnitudes, are left to `repr`.

Source: T. J. Dekker, A floating-point technique for extending the available precision, Numer. Math. 18, 1971.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from typing import TYPE_CHECKING, NamedTuple, TypeAlias

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats: TypeAlias = NDArray[np.float64]
    Integers: TypeAlias = NDArray[np.int64]
    Bytes: TypeAlias = NDArray[np.uint8]

WIDTH = 24
"""Most letters of a float, such as -2.2250738585072014e-308."""

_DIGITS = 17
_LEAST, _MOST = -4, 16
"""Exponents of ten between which `repr` writes no exponent."""
_SPLIT = float((1 << 27) + 1)
_DOUBT = 1e-6
"""Closer than this to the border of what may be written, in units of the 17th digit, nothing is decided here."""


def lines(block: Floats, pieces: Sequence[str]) -> str:
    """Rows of numbers between pieces of text.

    Args:
        block: Finite numbers without minus zero, shape (N, k).
        pieces: What stands before the first number of each row, between the numbers, and after the last, k + 1 texts.
    """
    count, columns = block.shape
    fixed = [np.frombuffer(piece.encode(), np.uint8) for piece in pieces]
    cells = spelled(block.ravel()).reshape(count, columns, WIDTH)
    table = np.empty((count, sum(map(len, fixed)) + columns * WIDTH), np.uint8)
    at = 0
    for k, piece in enumerate(fixed):
        table[:, at : at + len(piece)] = piece
        at += len(piece)
        if k < columns:
            table[:, at : at + WIDTH] = cells[:, k]
            at += WIDTH
    return table.tobytes().translate(None, b"\0").decode()


def spelled(x: Floats) -> Bytes:
    """Each float as `repr` spells it, shape (N, WIDTH); letters that are not needed are NUL.

    Args:
        x: Finite floats, shape (N,).
    """
    powers = _powers()
    size = np.abs(x)
    usual = (size >= powers.tens[0]) & (size < powers.tens[-1])
    size = np.where(usual, size, 1.0)
    exponents = np.floor(np.log10(size)).astype(np.int64)
    exponents -= size < powers.tens[exponents - _LEAST]  # log10 is good to a few bits only
    exponents += size >= powers.tens[exponents - _LEAST + 1]
    number, sure = _shortest(size, exponents)
    text = np.zeros((len(x), WIDTH), np.uint8)
    text[:, 0] = (x < 0) * ord("-")
    digits = _digits(number, exponents)
    for exponent in np.unique(exponents).tolist():
        rows = np.flatnonzero(exponents == exponent)
        whole = max(exponent + 1, 0)  # digits before the point
        text[rows, 1 : 1 + whole] = digits[rows, :whole]
        start = 1 + whole
        point = b"." if whole else b"0." + b"0" * (-exponent - 1)
        text[rows, start : start + len(point)] = np.frombuffer(point, np.uint8)
        text[rows, start + len(point) : start + len(point) + _DIGITS - whole] = digits[rows, whole:]
    text[x == 0] = np.frombuffer(b"0.0".ljust(WIDTH, b"\0"), np.uint8)
    for i in np.flatnonzero(~(usual & sure) & (x != 0)).tolist():
        text[i] = np.frombuffer(repr(float(x[i])).encode().ljust(WIDTH, b"\0"), np.uint8)
    return text


def _shortest(size: Floats, exponents: Integers) -> tuple[Integers, NDArray[np.bool_]]:
    """The decimals to write, without the zeros at their ends, as whole numbers of 17 digits; and which are sure.

    Args:
        size: Floats in [1e-4, 1e16).
        exponents: The whole part of their logarithm to base ten.
    """
    powers = _powers()
    scale = powers.scale[exponents - _LEAST]
    product = size * scale
    high = _SPLIT * size - (_SPLIT * size - size)
    low = size - high
    scale_high, scale_low = powers.high[exponents - _LEAST], powers.low[exponents - _LEAST]
    error = ((high * scale_high - product) + high * scale_low + low * scale_high) + low * scale_low
    room = np.spacing(size) / 2 * scale
    is_power = np.frexp(size)[0] == 0.5  # noqa: PLR2004  the mantissa of a power of two
    room = np.where(is_power, room / 2, room)  # below one, floats are twice as close
    base = (product * 0.01).astype(np.int64) * 100
    rest = (product.astype(np.int64) - base) + error  # beyond 2**53 a float has no fraction
    chosen = np.rint(rest)
    sure = np.abs(np.abs(chosen - rest) - 0.5) > _DOUBT
    for step in (10.0, 100.0):
        rounder = step * np.rint(rest / step)
        away = np.abs(rounder - rest)
        fits = away < room
        chosen = np.where(fits, rounder, chosen)
        sure &= (np.abs(away - room) > _DOUBT) & (np.abs(away - step / 2) > _DOUBT)
    number = base + chosen.astype(np.int64)
    return number, sure & (number < 10**_DIGITS)


def _digits(number: Integers, exponents: Integers) -> Bytes:
    """The digits of whole numbers of 17 digits, shape (N, 17); NUL for zeros at the end of a fraction."""
    powers = _powers()
    first, tail = _parted(number, 10**16)
    left, right = _parted(tail, 10**8)
    fours = (*_parted(left, 10**4), *_parted(right, 10**4))
    digits = np.empty((len(number), _DIGITS), np.uint8)
    digits[:, 0] = first + ord("0")
    digits[:, 1:] = np.stack([powers.fours[four] for four in fours], axis=1).view(np.uint8)
    ending = powers.zeros[fours[3]]
    for k, four in ((4, fours[2]), (8, fours[1]), (12, fours[0])):
        if not (more := ending == k).any():
            break
        ending[more] += powers.zeros[four[more]]
    kept = np.maximum(_DIGITS - ending, exponents + 2)  # a digit after the point at least
    digits *= np.arange(_DIGITS, dtype=np.uint8) < kept.astype(np.uint8)[:, None]
    return digits


def _parted(number: Integers, by: int) -> tuple[Integers, Integers]:
    """Quotient and remainder of numbers that are not negative, several times as fast as `divmod`."""
    quotient = number // by
    return quotient, number - quotient * by


class _Powers(NamedTuple):
    """What is looked up.

    Attributes:
        tens: Powers of ten from the least to the most that have no exponent.
        scale: For each exponent, the power that gives 17 digits before the point.
        high: Its upper bits.
        low: What is left of it.
        fours: Four digits as ASCII, for each number below 10000.
        zeros: How many zeros they end with.
    """

    tens: Floats
    scale: Floats
    high: Floats
    low: Floats
    fours: NDArray[np.uint32]
    zeros: Integers


@cache
def _powers() -> _Powers:
    tens = np.array([float(f"1e{k}") for k in range(_LEAST, _MOST + 1)])
    scale = np.array([float(f"1e{_DIGITS - 1 - k}") for k in range(_LEAST, _MOST + 1)])  # exact up to 1e22
    high = _SPLIT * scale - (_SPLIT * scale - scale)
    fours = np.frombuffer("".join(f"{k:04d}" for k in range(10_000)).encode(), np.uint32)
    zeros = np.array([4 if k == 0 else len(str(k)) - len(str(k).rstrip("0")) for k in range(10_000)])
    return _Powers(tens, scale, high, scale - high, fours, zeros)
