"""Vectors as people write them besides columns: `(3, -3, 7)`, `3i - 3j + 7k`, `[3 -3 7]^T`, `+y`, `-x0`."""

from __future__ import annotations

import re
from dataclasses import replace

from dhcli.errors import NotationError
from dhcli.notation.parser import parse
from dhcli.notation.scope import Scope
from dhcli.notation.tree import ONE, ZERO
from dhcli.notation.walk import substitute, symbols
from dhcli.notation.writer import write

_TRANSPOSED = re.compile(r"(?:\^\s*\{?\s*\\?(?:T|top|mathsf\{T\})\s*\}?|\.T|\.?')\s*$")
_AXIS = re.compile(r"\s*([+-]?)\s*([xyz])\s*['_]*\{?\d*\}?\s*(?:axis)?\s*")
_UNIT_VECTORS = ("i", "j", "k")
LENGTHS = (3, 4)
"""Coordinates of a vector, without and with the last one of homogeneous coordinates."""


def as_column(text: str, scope: Scope, *, is_axis: bool) -> str:
    """A vector in the spelling of a matrix; a text that is none of the above is handed back in brackets.

    Args:
        text: What was typed.
        scope: The names it may use.
        is_axis: Whether a direction was asked for, which `+y` is.
    """
    body = _TRANSPOSED.sub("", text.strip())
    if is_axis and (match := _AXIS.fullmatch(body)):
        sign = "-" if match[1] == "-" else ""
        return "[" + " ".join(f"{sign}1" if name == match[2] else "0" for name in "xyz") + "]"
    if body.startswith("(") and body.endswith(")") and _closes_at_end(body):
        body = body[1:-1]
    if "," in body and ";" not in body:
        body = body.replace("\n", " ")  # commas separate already; the line was only long
    rows = _one_a_row(body)
    if rows:
        return rows
    if body.startswith(("[", "{", "\\", "|")):
        return body
    return _from_unit_vectors(body, scope) or f"[{body}]"


def _one_a_row(text: str) -> str:
    """A column with a coordinate in each row, where blanks cannot separate: `[a1 c1; a1 s1; 0]`; else empty."""
    inside = text.removeprefix("[").removesuffix("]").strip(" \n;")
    for separator in (";", "\n"):
        if separator in inside:
            rows = inside.split(separator)
            plain = not any(bracket in inside for bracket in "[]{}|&,\\")
            return "[" + ", ".join(rows) + "]" if plain and len(rows) in LENGTHS else ""
    return ""


def _from_unit_vectors(text: str, scope: Scope) -> str:
    """The coefficients of i, j and k in a sum; empty if it is no such sum."""
    if any(scope.has(name) for name in _UNIT_VECTORS) or "," in text or ";" in text:
        return ""
    try:
        expr = parse(text, replace(scope, lengths=(*scope.lengths, *_UNIT_VECTORS)))
    except NotationError:
        return ""
    if not symbols(expr) & set(_UNIT_VECTORS):
        return ""
    nothing = dict.fromkeys(_UNIT_VECTORS, ZERO)
    if substitute(expr, nothing, {}) != ZERO:
        return ""
    parts = [substitute(expr, {**nothing, name: ONE}, {}) for name in _UNIT_VECTORS]
    return "[" + ", ".join(write(part, "full") for part in parts) + "]"


def _closes_at_end(text: str) -> bool:
    """Whether the first bracket closes with the last character."""
    depth = 0
    for i, letter in enumerate(text):
        depth += (letter == "(") - (letter == ")")
        if depth == 0:
            return i == len(text) - 1
    return False
