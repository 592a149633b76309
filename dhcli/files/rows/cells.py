"""One cell of a table: a plain decimal number, or what is wrong with it; and whole tables of nothing else, at once."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING

import numpy as np

from dhcli.notation.decimals import read_decimals
from dhcli.notation.quantity import UNITS
from dhcli.regex import regex

if TYPE_CHECKING:
    from numpy.typing import NDArray

NUMBER = regex(r"\s*[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?\s*", re.ASCII)
_PLAIN = b"0123456789+-.eE \n"
"""What numbers, blanks and line ends are made of: `nan`, `1_000` and quotes have something else in them."""

_COMMA_SIGN, _LINE_END = b",\n"

_NO_NUMBERS = {"nan", "na", "n/a", "null", "none", "inf", "infinity", "-inf", "+inf", "-infinity", "-nan"}
_COMMA = regex(r"[+-]?(?:\d+,\d*|,\d+)(?:[eE][+-]?\d+)?", re.ASCII)
_UNIT = regex(r"[+-]?(?:\d+(?:\.\d*)?|\.\d+)\s*(?P<unit>\D+)", re.ASCII)
_LONGEST = 40
_WORDS = {"True": "true", "False": "false", "None": "null"}


class CellError(ValueError):
    """A cell that is no number; carries a message and a hint."""

    def __init__(self, message: str, hint: str = "") -> None:
        """Say what is wrong, and what would be right."""
        super().__init__(message)
        self.message = message
        self.hint = hint


def read_cell(text: str, *, decimal_comma: bool, units_in_header: bool) -> float:
    """The number in a cell.

    Args:
        text: The cell.
        decimal_comma: Whether `0,5` is a half.
        units_in_header: Whether the header may say a unit; else lengths are metres and angles radians.

    Raises:
        CellError: There is none, or it is not finite.
    """
    if decimal_comma and text.count(",") == 1 and _COMMA.fullmatch(text.strip()):
        text = text.replace(",", ".")
    if NUMBER.fullmatch(text):
        value = float(text)
        if math.isfinite(value):
            return value
        raise CellError(f"{shown(text)} is too large")
    bare = text.strip()
    if not bare:
        raise CellError("is empty")
    if bare.lower() in _NO_NUMBERS:
        raise CellError(f"{shown(bare)} is not a finite number")
    raise CellError(f"{shown(bare)} is not a number", _hint(bare, units_in_header=units_in_header))


def json_number(value: object) -> float:
    """A value of JSON as a number.

    Raises:
        CellError: It is none, or it is not finite.
    """
    if isinstance(value, bool) or not isinstance(value, int | float):
        spelled = shown(value) if isinstance(value, str) else _WORDS.get(repr(value), "a list or an object")
        hint = "write it without quotes" if isinstance(value, str) and NUMBER.fullmatch(value) else ""
        raise CellError(f"is {spelled}, not a number", hint)
    try:
        number = float(value)
    except OverflowError:
        number = math.inf
    if not math.isfinite(number):
        raise CellError(f"is {number}, not a finite number")
    return number


def plain_table(text: str, separator: str, width: int) -> NDArray[np.float64] | None:
    r"""The numbers of a whole table, shape (N, width); None unless every row is as wide and every cell a plain number.

    Args:
        text: The rows, each with "\n" at its end.
        separator: What stands between cells; for a blank any number of them.
        width: How many cells a row has.
    """
    if text.encode().translate(None, _PLAIN + separator.encode()) or text.isspace():
        return None
    if separator == " ":
        text = "".join(",".join(line.split()) + "\n" for line in text.split("\n")[:-1])
    text = text.replace(separator, ",")
    marks = np.frombuffer(text.encode(), np.uint8)
    marks = marks[(marks == _COMMA_SIGN) | (marks == _LINE_END)]
    pattern = [_COMMA_SIGN] * (width - 1) + [_LINE_END]
    if len(marks) % width or (marks.reshape(-1, width) != pattern).any():
        return None
    try:
        return read_decimals(text.replace("\n", ",")).reshape(-1, width)
    except ValueError:
        return None


def is_number(text: str) -> bool:
    """Whether a cell is meant for a number: also one that no joint can have, with a decimal comma, or with a unit."""
    bare = text.strip()
    if (match := _UNIT.fullmatch(bare)) and match["unit"] in UNITS:
        return True
    return any(pattern.fullmatch(bare) for pattern in (NUMBER, _COMMA)) or bare.lower() in _NO_NUMBERS


def shown(text: str) -> str:
    """A cell in a message, not too long."""
    return f"'{text}'" if len(text) <= _LONGEST else f"'{text[:_LONGEST]}...'"


def _hint(text: str, *, units_in_header: bool) -> str:
    if _COMMA.fullmatch(text):
        return f"write {text.replace(',', '.')}, with a point"
    if (match := _UNIT.fullmatch(text)) and match["unit"] in UNITS:
        in_header = f"the unit stands once, in the header: [{match['unit']}]"
        return in_header if units_in_header else "write metres and radians, without their unit"
    return "a cell is a plain number, such as -0.25 or 1e-3"
