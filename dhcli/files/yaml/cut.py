"""Texts without quotes that a comma has cut: between brackets and braces of YAML it ends a value.

`{ask: point (1, 2, 3) of pose 0..2}` is a value, `point (1`, and two keys without one. Such pieces are put together
again, so that one problem is told, with the text in the quotes that it needs, and the text is read as it was meant.
"""

from __future__ import annotations

from dhcli.errors import Place, Problem
from dhcli.notation.brackets import STEPS
from dhcli.regex import regex
from dhcli.safe import yaml_scalar

_ENDS_IN_NUMBER = regex(r"(?<![.\w])[0-9]+,\Z")


def is_piece(text: str, place: Place) -> bool:
    """Whether a plain key between braces has no colon: what a comma has cut off the value before it.

    Args:
        text: The key.
        place: Where it stands.
    """
    at = (place.column or 1) - 1
    return place.text[at:].startswith(text) and place.text[at + len(text) :].lstrip()[:1] in (",", "}")


def is_open(text: str) -> bool:
    """Whether a bracket that opens in a plain text does not close in it."""
    return sum(STEPS.get(letter, 0) for letter in text) > 0


def is_quoting(text: str) -> bool:
    """Whether a double quote that opens in a plain text does not close in it."""
    return text.count('"') % 2 == 1


def whole(first: str, start: Place, piece: str, end: Place) -> str:
    """A text and the next piece of it, as they stand in the file.

    Args:
        first: What was put together so far.
        start: Where it begins.
        piece: The next piece.
        end: Where that begins.
    """
    if start.line != end.line:
        return f"{first}, {piece}"
    return start.text[(start.column or 1) - 1 : (end.column or 1) - 1 + len(piece)]


def tell(problems: list[Problem], before: str, text: str, place: Place, key: str = "") -> None:
    """Say once of a text that was put together what it needs: what was said before the last piece is taken back.

    Args:
        problems: Where it is said.
        before: The text without its last piece.
        text: All of it.
        place: Where it begins.
        key: Its key; empty of an item of a list.
    """
    if problems and problems[-1] == _told(before, place, key):
        problems.pop()
    problems.append(_told(text, place, key))


def with_decimal_comma(text: str, place: Place) -> str:
    """The number `0,3` of which YAML has made a value and a key that has none; empty if the key is no such."""
    if not text[:1].isdecimal() or not is_piece(text, place):
        return ""
    before = _ENDS_IN_NUMBER.search(place.text[: (place.column or 1) - 1])
    return before[0] + text if before else ""


def _told(text: str, place: Place, key: str) -> Problem:
    name = f"{key}: " if key else ""
    is_list = text.startswith("(") and text.endswith(")") and not is_open(text[1:-1])
    listed = f"[{text[1:-1]}], or as a text " if is_list else ""
    message = f"{name}a comma ends a text without quotes here"
    return Problem(message, place, f"write {name}{listed}{yaml_scalar(text)}")
