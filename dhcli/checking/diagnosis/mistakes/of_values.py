"""Mistakes in a single value: an angle, a length or a number that is computed from an expression."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

from dhcli.checking.diagnosis import scalars
from dhcli.checking.exercise import Exercise
from dhcli.notation.tree import Expr


@dataclass(frozen=True, slots=True)
class ValueMistake:
    """A kind of mistake in a value.

    Attributes:
        id: The name under which exercises ask for it.
        words: What has happened, `{where}` for the place.
        hint: Where to look, without the answer.
        made: Every way to make it in an expression, each with its place.
    """

    id: str
    words: str
    hint: str
    made: Callable[[Expr, Exercise], Iterator[tuple[str, Expr]]]


IN_VALUES = (
    ValueMistake("value-sign", "the sign of the whole value is turned round", "look at the sign", scalars.sign),
    ValueMistake(
        "term-sign", "the sign of {where} is turned round", "look at the signs of the terms", scalars.term_sign
    ),
    ValueMistake("term-forgotten", "{where} is left out", "count the terms", scalars.term_forgotten),
    ValueMistake(
        "sin-cos",
        "sine and cosine have changed places",
        "look at sine and cosine: from which axis is the angle measured?",
        scalars.sine_cosine,
    ),
    ValueMistake(
        "angle-unit",
        "an angle is taken in the wrong unit, degrees for radians or the other way round",
        "is your calculator in degrees or in radians?",
        scalars.angle_unit,
    ),
    ValueMistake("in-mm", "the unit is another, mm for m", "look at the unit of the sheet", scalars.other_unit),
    ValueMistake("turned", "the angle is off by {where}", "from which axis is the angle measured?", scalars.turned),
)
"""In the expression that a part asks the value of."""
