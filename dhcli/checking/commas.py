"""Decimal commas: read where a comma can separate nothing, and spoken of where it might."""

from __future__ import annotations

import re

from dhcli.regex import regex

_NUMBER = regex(r"[+−-]?\d*[.,]?\d+(?:[ ]?(?:[a-z]{1,3}|°))?")  # noqa: RUF001
_COMMA = regex(r"\d+,\d+")
_BETWEEN = regex(r"\s*[;\n]\s*|,?\s+")
COORDINATES = 3
LONGEST = 500
"""Characters of an answer that may be three plain numbers; longer ones are not searched."""


def with_points(text: str, count: int = COORDINATES) -> str:
    """So many numbers, decimal commas among them, with points and commas where a matrix has them; else the text.

    `0,449; 0,4819; 0` and `0,449 0,4819 0` cannot be read otherwise: the commas stand inside the three pieces that
    semicolons, line ends or blanks leave.
    """
    if len(text) > LONGEST:
        return text
    inside = text.strip(" \n[]();")
    for separator in (r"\s*[;\n]\s*", r"[ \t]+"):
        pieces = re.split(separator, inside)
        if len(pieces) == count and all(_NUMBER.fullmatch(piece) for piece in pieces) and _COMMA.search(inside):
            return "[" + ", ".join(piece.replace(",", ".") for piece in pieces) + "]"
    return text


def comma_remark(text: str) -> str:
    """What to say about an answer that cannot be read, where its commas may be decimal ones; else empty."""
    if len(text) > LONGEST:
        return ""
    pieces = [piece for piece in _BETWEEN.split(text.strip(" \n[]();")) if piece]
    meant = next((match[0] for piece in pieces if (match := _COMMA.fullmatch(piece.lstrip("+-")))), "")
    if len(pieces) < COORDINATES - 1 or not meant:
        return ""
    return f"if {meant} is one number, write {meant.replace(',', '.')}: decimals take a point"
