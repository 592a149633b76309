"""Lines of a table and their cells: plain decimal numbers, or what is wrong with them; and whole tables at once."""

from __future__ import annotations

import csv
import math
import re
from collections.abc import Sequence
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

SIGNS = ";\t,"
"""What may stand between cells. Commas last: between the others they are decimal ones."""
DECIMAL_BETWEEN = (";", "\t", " ")
_CALLED = {";": "semicolons", "\t": "tabs", ",": "commas", " ": "blanks"}

_BETWEEN_BLANKS = regex(r"\S+(?:[ ]{1,40}[\[(][^\])]{0,40}[\])])?")
"""A cell between blanks; a unit may stand apart from its name."""

_NO_NUMBERS = {"nan", "na", "n/a", "null", "none", "inf", "infinity", "-inf", "+inf", "-infinity", "-nan"}
_COMMA = regex(r"[+-]?(?:\d+,\d*|,\d+)(?:[eE][+-]?\d+)?", re.ASCII)
_DIGITS = regex(r"\s*[+-]?\d+(?:[eE][+-]?\d+)?\s*", re.ASCII)
_GROUPED = regex(r"[+-]?\d{1,3}(?:(?:,\d{3})+\.\d*|(?:\.\d{3})+,\d*)", re.ASCII)
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


def sign_between(head: str, width: int = 0) -> str:
    """What stands between the cells of a table, as its first line shows.

    Args:
        head: The line.
        width: How many numbers there are where it is no header, if that is known.
    """
    sign = next((sign for sign in SIGNS if sign in head), " " if " " in head.strip() else ",")
    numbers = head.split()
    if sign == "," and width > 1 and len(numbers) == width and all(map(_COMMA.fullmatch, numbers)):
        return " "
    return sign


def cells_of(line: str, sign: str) -> list[tuple[int, str]]:
    """The cells of a line with the columns where they begin, from 1.

    Args:
        line: The line.
        sign: What stands between them; for a blank any number of them.
    """
    if sign == " ":
        return [(match.start() + 1, match[0]) for match in _BETWEEN_BLANKS.finditer(line)]
    found, end = [], 0
    for text in _unquoted(line, sign) if '"' in line else line.split(sign):
        start = max(line.find(text, end), end)
        found.append((start + 1 + len(text) - len(text.lstrip()), text))
        end = start + len(text) + 1
    return found


def _unquoted(line: str, sign: str) -> list[str]:
    """The cells of a line with quotes."""
    try:
        return next(csv.reader([line], delimiter=sign))
    except csv.Error:  # a cell longer than any number
        return [line]


def decimals_in(cells: Sequence[str], sign: str, text: str) -> str:
    """What may stand before the decimals in a row: a point or a comma, unless it has both; then one might group digits.

    Args:
        cells: The cells of the row.
        sign: What stands between them; of commas none is a decimal one.
        text: The rows around: what is usual there is right.
    """
    if sign not in DECIMAL_BETWEEN:
        return "."
    has_comma = any(_COMMA.fullmatch(cell.strip()) for cell in cells)
    has_point = any("." in cell.rpartition(",")[2] for cell in cells)
    if not (has_comma and has_point):
        return ".,"
    return "," if text.count(",") > text.count(".") else "."


def other_sign(line: str, sign: str, width: int) -> tuple[str, str]:
    """What is wrong with a row that is not parted as the first line is, and what would be right; else nothing.

    Args:
        line: The row.
        sign: What stands between the cells of the first line.
        width: How many cells there should be.
    """
    for other in (*SIGNS, " "):
        cells = [text for _, text in cells_of(line, other)]
        if other != sign and other in line.strip() and len(cells) == width and all(map(is_number, cells)):
            message = f"has {_CALLED[other]} between its cells, and the first line has {_CALLED[sign]}"
            return message, "the same in all lines"
    cells = line.split(sign)
    if sign == "," and min(width + 2, 2 * width) <= len(cells) <= 2 * width and all(map(_DIGITS.fullmatch, cells)):
        return (
            f"{len(cells)} cells in a table of {width} columns",
            "are there decimal commas? part the cells by semicolons: 0,5;1,2",
        )
    return "", ""


def read_cell(text: str, *, decimals: str) -> float:
    """The number in a cell.

    Args:
        text: The cell.
        decimals: What may stand before decimals: a point, a comma, or either.

    Raises:
        CellError: There is none, or it is not finite.
    """
    bare = text.strip().replace("\N{MINUS SIGN}", "-")
    if "," in decimals and _COMMA.fullmatch(bare):
        bare = bare.replace(",", ".")
    elif decimals == "," and "." in bare and NUMBER.fullmatch(bare):
        raise CellError(f"{shown(bare)} has a point, and others here a comma", f"write {bare.replace('.', ',')}")
    if NUMBER.fullmatch(bare):
        value = float(bare)
        if math.isfinite(value):
            return value
        raise CellError(f"{shown(text)} is too large")
    if not bare:
        raise CellError("is empty")
    if bare.lower() in _NO_NUMBERS:
        raise CellError(f"{shown(bare)} is not a finite number")
    raise CellError(f"{shown(bare)} is not a number", _hint(bare))


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
    bare = text.strip().replace("\N{MINUS SIGN}", "-")
    if (match := _UNIT.fullmatch(bare)) and match["unit"] in UNITS:
        return True
    return any(pattern.fullmatch(bare) for pattern in (NUMBER, _COMMA)) or bare.lower() in _NO_NUMBERS


def shown(text: str) -> str:
    """A cell in a message, not too long."""
    return f"'{text}'" if len(text) <= _LONGEST else f"'{text[:_LONGEST]}...'"


def _hint(text: str) -> str:
    if _COMMA.fullmatch(text):
        return f"write {text.replace(',', '.')}, with a point"
    if _GROUPED.fullmatch(text):
        whole, _, decimals = text.rpartition("." if text.rfind(".") > text.rfind(",") else ",")
        return f"write {re.sub('[.,]', '', whole)}.{decimals}: nothing stands between thousands"
    if (match := _UNIT.fullmatch(text)) and match["unit"] in UNITS:
        return f"the unit stands once, in the header: [{match['unit']}]"
    return "a cell is a plain number, such as -0.25 or 1e-3"
