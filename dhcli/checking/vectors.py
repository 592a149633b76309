"""Vectors as people write them besides columns: `(3, -3, 7)`, `3i - 3j + 7k`, `[3 -3 7]^T`, `+y`, `-x0`."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from dhcli.checking.lists import scaled, unnumbered, untransposed
from dhcli.errors import NotationError
from dhcli.notation.brackets import closing
from dhcli.notation.parser import parse
from dhcli.notation.scope import Scope
from dhcli.notation.tree import ONE, ZERO
from dhcli.notation.walk import substitute, symbols
from dhcli.notation.writer import write
from dhcli.regex import regex

_AXIS = regex(r"([+−-]?) ?([xyz]) ?['_]{0,3}\{?\d{0,3}\}? ?(?:axis)?")  # noqa: RUF001
_NAMED = regex(r"(^|[,;\n])[ \t]{0,9}(?:[xyz]|[pd]_?\{?[xyz]\}?)[ \t]{0,9}[=:]")
_POINT = regex(r"[A-Z]['_]?\d{0,2} ?(?=\()")
"""The name of a point before its coordinates, `P(1, 2, 3)`."""
_NAMED_BESIDE = regex(r"(?:^|(?<=[^\s,;=])\s+)(?:[xyz]|[pd]_?\{?[xyz]\}?)[ \t]{0,9}=")
"""The same between blanks, `x = 1 y = 2 z = 3`."""
_UNIT_BEHIND = regex(
    r"(?P<vector>[\s\S]*[\])}T'])\s*(?:\\[,;] ?|~)?(?:\\(?:mathrm|text) ?\{ ?)?(?P<unit>mm|cm|m|in)\}?"
)
_LATEX_ENDS = regex(
    r"^(?:\\left ?[\[(])? ?\\begin ?\{\w{1,20}\}(?:\{[clr|]{1,20}\})?|\\end ?\{\w{1,20}\} ?(?:\\right ?[\])])?$"
)
_NAME_PARTS = regex(r"_\{[^{}\n]{0,20}\}|\\\\|\\[A-Za-z]{1,20}")
"""What of a name or of LaTeX has braces and backslashes, `c_{12}` and `\\theta`."""
_WIDE = regex(r"[^\s+*/^-][ \t]+-?[\w.]+[ \t]+-?[\w.]+[ \t]+-?[\w.]")
"""Four cells or more in a row: a whole matrix, not a coordinate."""
_UNIT_VECTORS = ("i", "j", "k")
_NO_STEP = regex(r"(?<![\w.])0(?=[ijk](?!\w))")
"""The 0 of `0k`, which alone would be read as the beginning of a number such as 0x1F."""
LENGTHS = (3, 4)
"""Coordinates of a vector, without and with the last one of homogeneous coordinates."""


def as_column(text: str, scope: Scope, *, is_axis: bool) -> str:
    """A vector in the spelling of a matrix; a text that is none of the above is handed back in brackets.

    Args:
        text: What was typed.
        scope: The names it may use.
        is_axis: Whether a direction was asked for, which `+y` is.
    """
    body = unnumbered(untransposed(text.strip()))
    if (match := _UNIT_BEHIND.fullmatch(body)) and _is_whole(vector := untransposed(match["vector"])):
        return f"{as_column(vector, scope, is_axis=is_axis)} {match['unit']}"
    if times := scaled(body):
        return times
    if is_axis and (match := _AXIS.fullmatch(body)):
        sign = "-" if match[1] == "-" else ""
        return "[" + " ".join(f"{sign}1" if name == match[2] else "0" for name in "xyz") + "]"
    if (match := _POINT.match(body)) and set(body) & set(",;|") and not scope.has(match[0].strip()):
        body = body[match.end() :]
    if (body.startswith("(") and body.endswith(")") and _closes_at_end(body)) or (body[:1], body[-1:]) == ("<", ">"):
        body = body[1:-1]
    named = [piece for piece in _NAMED_BESIDE.split(body) if piece]  # the first name may be off, as a label is
    body = ", ".join(named) if len(named) == LENGTHS[0] else body
    body = _NAMED.sub(r"\1", body)
    if "," in body and ";" not in body:
        body = body.replace("\n", " ")  # commas separate already; the line was only long
    if rows := column_of_rows(body, LENGTHS):
        return rows
    if body.startswith(("[", "{", "\\", "|")):
        return body
    return _from_unit_vectors(body, scope) or f"[{body}]"


def column_of_rows(text: str, lengths: Sequence[int]) -> str:
    """A column with an entry in each row, where blanks cannot separate: `[a1 c1; a1 s1; 0]`; else empty.

    Args:
        text: What was typed.
        lengths: How many entries there may be.
    """
    return _one_a_row(text, max(lengths)) or _latex_column(text, lengths)


def _one_a_row(text: str, most: int) -> str:
    """Such a column between semicolons or line ends."""
    inside = text.removeprefix("[").removesuffix("]").strip(" \n;")
    plain = not set(_NAME_PARTS.sub("", inside)) & set("[]{}|&,\\")
    for separator in (";", "\\\\", "\n"):
        if separator in inside:
            rows = [row for row in inside.split(separator) if row.strip()]
            wide = all(_WIDE.search(row) for row in rows)
            return "[" + ", ".join(rows) + "]" if plain and len(rows) <= most and not wide else ""
    return ""


def _latex_column(text: str, lengths: Sequence[int]) -> str:
    r"""A LaTeX column, whose blanks are products: `\begin{bmatrix} a \cos\theta \\ 0 \\ 1 ...`; else empty."""
    if not text.startswith(("\\begin", "\\left")) or "&" in text:
        return ""
    rows = [row for row in _LATEX_ENDS.sub("", text).replace("\n", " ").split("\\\\") if row.strip()]
    return "[" + ", ".join(rows) + "]" if len(rows) in lengths else ""


def _from_unit_vectors(text: str, scope: Scope) -> str:
    """The coefficients of i, j and k in a sum; empty if it is no such sum."""
    if any(scope.has(name) for name in _UNIT_VECTORS) or "," in text or ";" in text:
        return ""
    try:
        expr = parse(_NO_STEP.sub("0 ", text), replace(scope, lengths=(*scope.lengths, *_UNIT_VECTORS)))
    except NotationError:
        return ""
    if not symbols(expr) & set(_UNIT_VECTORS):
        return ""
    nothing = dict.fromkeys(_UNIT_VECTORS, ZERO)
    if substitute(expr, nothing, {}) != ZERO:
        return ""
    parts = [substitute(expr, {**nothing, name: ONE}, {}) for name in _UNIT_VECTORS]
    return "[" + ", ".join(write(part, "full") for part in parts) + "]"


def _is_whole(text: str) -> bool:
    """Whether a text is one bracket or one environment, so that a unit behind it is that of all coordinates."""
    return (text[:1] in ("(", "[") and _closes_at_end(text)) or bool(_LATEX_ENDS.match(text) and "&" not in text)


def _closes_at_end(text: str) -> bool:
    """Whether the first bracket closes with the last character."""
    return closing(text) == len(text) - 1
