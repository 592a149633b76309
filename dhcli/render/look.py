"""How a result is to look."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import field

from dhcli.frozen import frozen
from dhcli.kinematics.entries import DIGITS, rounded
from dhcli.regex import regex
from dhcli.render.paper import Paper

_NOISE = 1e-9
"""What is smaller is taken for rounding and shown as 0."""
_DECIMAL = regex(r"[0-9]+\.[0-9]+")
_COMPUTED = regex(r"[0-9]+\.[0-9]{10,}")
"""A number with more decimals than anybody types, such as the cosine of a tilted axis."""
PLACES = 6
"""Decimals of such numbers in formulas."""
_FEWEST = 3
"""Digits of a number that would be rounded to nothing."""


@frozen
class Look:
    """How a result is to look.

    Attributes:
        format: Name of the format.
        paper: What it is written on.
        digits: Decimals; None for what the format usually has.
        style: Spelling of formulas, `short` or `full`; None for what the format usually has.
        in_file: Whether it goes into a file, which should run by itself.
        places: Most decimals of a number in a formula; None for all it has.
    """

    format: str = "table"
    paper: Paper = field(default_factory=Paper)
    digits: int | None = None
    style: str | None = None
    in_file: bool = False
    places: int | None = None

    def formula(self, text: str) -> str:
        """A formula for people: a number that has more decimals than are shown is rounded, though never to nothing."""
        if self.places is None:
            return text
        return _DECIMAL.sub(lambda number: _shorter(number[0], self.places or 0), text)

    def shown(self, text: str) -> str:
        """A formula for people and papers: a number has the digits it was typed with, one that was computed few."""
        if self.places is not None:
            return self.formula(text)
        return _COMPUTED.sub(lambda number: _shorter(number[0], PLACES if self.digits is None else self.digits), text)

    def number(self, value: float) -> str:
        """A number for people."""
        return rounded(value, DIGITS if self.digits is None else self.digits)

    def numbers(self, values: Iterable[float]) -> list[str]:
        """Numbers for people that belong together; where all are small, three digits of the largest are shown."""
        values = list(values)
        texts = [self.number(value) for value in values]
        largest = max((abs(value) for value in values), default=0.0)
        if self.digits is not None or largest < _NOISE or any(text != "0" for text in texts):
            return texts
        return [rounded(value, 2 - math.floor(math.log10(largest))) for value in values]


def _shorter(number: str, places: int) -> str:
    """A decimal number without its sign, in fewer places if it has more."""
    if len(number.partition(".")[2]) <= places:
        return number
    short = rounded(float(number), places)
    return short if short != "0" else rounded(float(number), _FEWEST - 1 - math.floor(math.log10(float(number))))
