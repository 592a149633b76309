"""Numbers with the way to them, `400 - 120 = 280 mm`: what was meant, if the one side is the other."""

from __future__ import annotations

import math

from dhcli.checking.tolerance import is_rounding_of
from dhcli.errors import NotationError
from dhcli.notation.arcs import constant
from dhcli.notation.dimensions import DimensionError, has_units, in_metres
from dhcli.notation.parser import parse
from dhcli.notation.quantity import has_angle_unit, to_angle
from dhcli.notation.scope import Scope
from dhcli.notation.tree import Expr, Product, Unit
from dhcli.regex import regex

LONGEST = 200
"""Characters of an answer that is looked at."""

_EQUALS = regex(r"(?<![<>=!:])=(?!=)")
_NO_NUMBER = regex(r"[\[\]{};&\n]")
RELATIVE = 1e-9


class ReckonedError(Exception):
    """Two numbers with a sign of equality between them that are not equal."""


def reckoned(text: str) -> str:
    """The number of which the others are the way or the result, `3*(4 - 1) - 8 = 1`; any other text as it is.

    The first has all digits; the last is taken where it alone has a unit.

    Raises:
        ReckonedError: They are not equal, as far as the digits of the last go.
    """
    if "=" not in text or len(text) > LONGEST or _NO_NUMBER.search(text):
        return text
    pieces = [piece.strip() for piece in _EQUALS.split(text)]
    read = [_number(piece) for piece in pieces]
    first = next((k for k in range(len(pieces)) if all(read[k:])), len(pieces))
    numbers = [one for one in read[first:] if one is not None]
    if len(numbers) < 2:  # noqa: PLR2004  a label, or nothing that can be compared
        return text
    *others, last = numbers
    is_measured = has_units(last) and not any(map(has_units, others))
    for piece, other in zip(pieces[first:], others, strict=False):
        if not (_is_shown(last, other) or (is_measured and _is_shown(_without_unit(last), other))):
            is_known = has_units(other) == has_units(last)  # what a number without a unit is, the sheet says
            said = "is not" if is_known else "stands beside"
            raise ReckonedError(f"{piece} {said} {pieces[-1]}: write the answer alone")
    return pieces[-1] if is_measured else pieces[first]


def _is_shown(last: Expr, other: Expr) -> bool:
    """Whether a number is another one, as far as its digits go in its own unit."""
    shown, value, number = _value(last), _value(other), _without_unit(last)
    unit = shown / bare if (bare := _value(number)) else 1.0
    return abs(value - shown) <= RELATIVE * abs(shown) or is_rounding_of(number, value / unit, least=0)


def _number(text: str) -> Expr | None:
    """A piece as a number with a value; None where it is none."""
    try:
        expr = parse(text, Scope()) if any(letter.isdigit() for letter in text) else None
    except NotationError:
        return None
    return expr if expr is not None and math.isfinite(_value(expr)) else None


def _value(expr: Expr) -> float:
    try:
        return to_angle(expr).constant() if has_angle_unit(expr) and has_units(expr) else constant(in_metres(expr))
    except DimensionError:
        return math.nan


def _without_unit(expr: Expr) -> Expr:
    """The number before a unit."""
    if isinstance(expr, Product) and len(expr.factors) == 2 and isinstance(expr.factors[1], Unit):  # noqa: PLR2004
        return expr.factors[0]
    return expr
