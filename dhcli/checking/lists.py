"""Lists of numbers as people write them: in brackets of any kind, in groups, with one unit behind all of them."""

from __future__ import annotations

import re

from dhcli.notation.brackets import closing
from dhcli.regex import regex

_UNIT_BEHIND = regex(r"(?<![\w\])])[(\[](?P<values>[^()\[\]\n]{0,400})[)\]][ \t]{0,9}(?P<unit>rad|deg|°)(?!\w)")
_SIZED = regex(r"\\(?:left|right|[bB]igg?[lr]?)(?![A-Za-z])")
_GROUP = regex(r"(?<!\w)[(\[](?P<inside>[^()\[\]]{0,400})[)\]](?P<behind>[ \t]{0,9}[,;|]?)")
_SEPARATED = regex(r"[,;|]")
_NUMBERS = regex(r"[-+−]?[\d.]{1,30}°?(?:[ \t]+[-+−]?[\d.]{1,30}°?){1,9}")  # noqa: RUF001
_PLAIN = r"[-+−]?(?:\d{1,20}(?:\.\d{0,20})?|\.\d{1,20})"  # noqa: RUF001
_LONE_UNIT = regex(
    r"\s{0,9}(?:\w{1,9}\s{0,9}=\s{0,9})?[(\[]?"
    rf"(?P<numbers>{_PLAIN}(?:(?:\s{{0,9}}[,;]\s{{0,9}}|[ \t]{{1,9}}){_PLAIN}){{1,9}})"
    r"\s{0,9}(?P<unit>°/s|°|[A-Za-z][A-Za-z·*/ ]{0,7})[)\]]?\s{0,9}\.?\s{0,9}"
)
_NEXT = regex(r"[ \t]{0,9}\n\s{0,9}|[,;][ \t]{0,9}(?=\(?\d[.)][ \t])")
_NUMBERED = regex(r"\(?(?P<number>\d)[.)][ \t]{1,9}(?P<rest>\S.{0,998})")
"""A line of a numbered list, `2. a1*s1`; without a blank behind the stop it begins with a number."""
_FACTOR = regex(
    r"(?P<factor>[-+−]|[-+−]?\d[\d./]{0,20}|[^\s,;\[\](){}&|=][^,;\n\[\]&|=]{0,40}?\*)[ \t]{0,9}(?=[\[(])"  # noqa: RUF001
)
_SEPARATED_ROWS = regex(r"[,;\n]")
_ROW_ENDS = regex(r"\s{0,9}[;\n]\s{0,9}")
LONGEST = 400
"""Characters of a list in which the unit behind its last number may be that of all."""
_TRANSPOSED = regex(r"(?:\^ ?\{? ?\\?(?:T|top|mathsf\{T\}) ?\}?|\.T|\.?') ?$")


def unit_for_all(text: str) -> tuple[str, str]:
    """A list whose last number alone has a unit, `1, 2, 3 mm`, with that behind a bracket around all; and the unit.

    Both are empty where the text is no such list.
    """
    match = _LONE_UNIT.fullmatch(text) if len(text) <= LONGEST else None
    if match is None:
        return "", ""
    return f"({', '.join(_values(match['numbers'].strip()))}) {match['unit']}", match["unit"]


def with_unit_inside(text: str, count: int) -> str:
    """`(30, 45)°` as `(30 °, 45 °)`, where so many numbers stand in the bracket."""

    def within(match: re.Match[str]) -> str:
        values = _values(match["values"])
        inside = ", ".join(f"{value} {match['unit']}" for value in values)
        return f"({inside})" if len(values) == count else match[0]

    return _UNIT_BEHIND.sub(within, text)


def flat(text: str) -> str:
    """A list without the brackets around it and around groups of its numbers: `(0, 0, 1), 60°` as `0, 0, 1, 60°`."""
    text = untransposed(_SIZED.sub("", text).strip())
    end = closing(text)
    if text[:1] in ("(", "[") and end == len(text) - 1:
        text = text[1:end]

    def outside(match: re.Match[str]) -> str:
        inside = match["inside"].strip()
        inside = ", ".join(inside.split()) if _NUMBERS.fullmatch(inside) else inside
        return f"{inside}{match['behind'].strip() or ','} " if _SEPARATED.search(inside) else match[0]

    return _GROUP.sub(outside, text).rstrip(" ,")


def unnumbered(text: str) -> str:
    """Lines or pieces behind `1.`, `2.`, `3.`, or `1)`, without these numbers; a text without all of them as it is."""
    lines = _NEXT.split(text.strip())
    found = [_NUMBERED.fullmatch(line) for line in lines]
    numbers = [match["number"] for match in found if match]
    if len(lines) < 2 or numbers != [str(k) for k in range(1, len(lines) + 1)]:  # noqa: PLR2004
        return text
    return "\n".join(match["rest"].strip(" \t,;") for match in found if match)


def untransposed(text: str) -> str:
    """A list without the sign that makes a column of a row, `[3 -3 7]^T`: either is read."""
    return _TRANSPOSED.sub("", text)


def in_square_brackets(text: str) -> str:
    """A list in round brackets in square ones, whatever stands behind it, `(1, 2)*0.001`; another text as it is."""
    end = closing(text)
    if text[:1] != "(" or end < 0 or not set(text[:end]) & set(",;|"):
        return text
    return f"[{text[1:end]}]{text[end + 1 :]}"


def _values(text: str) -> list[str]:
    """The numbers between commas, semicolons or bars; those between blanks where there are none."""
    return re.split(r"[,;|]", text) if set(text) & set(",;|") else text.split()


def scaled(text: str) -> str:
    """A list behind a sign or a factor, `-(1, 2, 3)` or `2*[1; 2; 3]`, as a matrix is written; empty if it is none."""
    match = _FACTOR.match(text)
    inside = text[match.end() + 1 : -1] if match else ""
    if (
        match is None
        or match.end() + closing(text[match.end() :]) != len(text) - 1
        or not _SEPARATED_ROWS.search(inside)
    ):
        return ""
    factor = match["factor"].strip()
    factor = (
        f"{factor}1*" if factor in ("+", "-", "\N{MINUS SIGN}") else factor if factor.endswith("*") else f"{factor}*"
    )
    return f"{factor}[{_ROW_ENDS.sub(', ', inside)}]"
