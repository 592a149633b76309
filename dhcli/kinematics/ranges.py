"""Ranges of values as people write them, in sweeps as in exercises: `20°..70° step 5°`, `0..0.2 n 11`."""

from __future__ import annotations

import re
from collections.abc import Callable
from fractions import Fraction
from typing import Literal, TypeAlias

from dhcli.errors import NotationError, Place, Problem, RobotError
from dhcli.frozen import frozen
from dhcli.kinematics.derived import metres
from dhcli.kinematics.robot import Value
from dhcli.notation.angle import Angle, Rational
from dhcli.notation.quantity import UNITS
from dhcli.notation.tokens import Source, tokenize
from dhcli.notation.tree import Number, number, places_of
from dhcli.regex import regex

_RANGE = regex(r"(?P<low>.*?)(?:\.\.(?P<high>.*?)(?:\s(?P<word>step|n)(?P<more>(?:\s.*)?))?)?", re.DOTALL)
"""Matches any text, in one go: nothing in it is tried twice."""

_LONGEST_COUNT = 40
_MOST_PLACES = 9

Word: TypeAlias = Literal["step", "n", ""]


@frozen
class Piece:
    """A part of a range without the blanks around it.

    Attributes:
        text: How it is spelled; empty where it is missing.
        place: Where it stands.
    """

    text: str
    place: Place


@frozen
class Written:
    """A range as it is written.

    Attributes:
        low: The first value, or the only one.
        high: The last one; None where there is no `..`.
        word: What stands behind it: a step, or how many values there are.
        more: The step, or that number; None where there is no such word.
    """

    low: Piece
    high: Piece | None
    word: Word
    more: Piece | None


def split_range(text: str, place_of: Callable[[int], Place], start: int = 0) -> Written:
    """The pieces of a range; any text is one, and may lack some.

    Args:
        text: The text that holds it.
        place_of: The place of one character of the text.
        start: Where in the text the range begins.
    """
    match = _RANGE.fullmatch(text, start)
    assert match is not None, "the pattern matches any text"  # noqa: S101
    found: dict[str, Piece | None] = {}
    for name in ("low", "high", "more"):
        piece = match[name]
        blanks = 0 if piece is None else len(piece) - len(piece.lstrip())
        found[name] = None if piece is None else Piece(piece.strip(), place_of(match.start(name) + blanks))
    word: Word = "step" if match["word"] == "step" else "n" if match["word"] else ""
    return Written(found["low"] or Piece("", place_of(start)), found["high"], word, found["more"])


def read_count(text: str, place: Place, example: str) -> int:
    """How many values there are, both ends among them.

    Raises:
        RobotError: It is no whole number, or less than two; the hint has the example of one value.
    """
    if not (text.isdecimal() and text.isascii() and len(text) <= _LONGEST_COUNT):
        raise RobotError(Problem(f"'{text}' is not a number of values", place, "write n 11"))
    count = int(text)
    if count < 2:  # noqa: PLR2004  both ends
        what = "no value" if count == 0 else "one value, and a range has two ends"
        raise RobotError(Problem(f"n {count} is {what}", place, f"write n 2 or more; or one value, {example}"))
    return count


def units_in(text: str) -> tuple[str, ...]:
    """The units that are written in a value, as they are spelled; in its tree 0° would be 0."""
    try:
        tokens = tokenize(Source(text, Place("")))
    except NotationError:
        return ()
    return tuple(token.text for token in tokens if token.kind in ("word", "sign") and token.text in UNITS)


def spread(first: Value, last: Value, count: int) -> tuple[Value, ...]:
    """So many values from one to another, evenly spaced and exact."""
    step = times(difference(first, last), Fraction(1, max(1, count - 1)))
    return tuple(total(first, times(step, k)) for k in range(count))


def steps_between(first: Value, last: Value, step: Value) -> Fraction:
    """How many steps it is from one value to another; exact unless one is in degrees and the other in radians."""
    way = difference(first, last)
    if isinstance(way, Angle) and isinstance(step, Angle):
        if not way.radians and not step.radians:
            return Fraction(way.degrees, step.degrees)
        if not way.degrees and not step.degrees:
            return Fraction(way.radians, step.radians)
        return Fraction(way.constant()) / Fraction(step.constant())
    return metres(way) / metres(step)


def difference(first: Value, last: Value) -> Value:
    """How far it is from one constant value to another of the same kind."""
    if isinstance(first, Angle) and isinstance(last, Angle):
        return last - first
    return _length(metres(last) - metres(first))


def total(first: Value, second: Value) -> Value:
    """The sum of two constant values of the same kind."""
    if isinstance(first, Angle) and isinstance(second, Angle):
        return first + second
    return _length(metres(first) + metres(second))


def times(value: Value, factor: Rational) -> Value:
    """A multiple of a constant value."""
    return value * factor if isinstance(value, Angle) else _length(metres(value) * factor)


def _length(amount: Fraction) -> Number:
    """A length that is shown with its decimals, if it has not too many: 0.12 and not 3/25."""
    return number(amount, places_of(amount, _MOST_PLACES))
