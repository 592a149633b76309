r"""Decimal commas: read where a comma can separate nothing, and spoken of where it might.

Whether it can is seen from how many cells are wanted: `0,449; 0,4819; 0` are three numbers and no more. The commas
become points where they stand; what else is in the text, its rows and units and brackets, is read by those who do.
"""

from __future__ import annotations

import re

from dhcli.regex import regex

Shape = tuple[int, int]

LONGEST = 2000
"""Characters of an answer that may be plain numbers; longer ones are not searched."""
SIDES = (3, 4)
"""Cells in the rows of rotations, of poses and of tables."""

_COMMA = regex(r"(?<![\w.,])(\d{1,30}),(?=\d{1,30}(?![\d,.]))")
_ALONE = regex(r"[+-]?(\d{1,30},\d{1,30})")
_UNIT = r"(?:[ ]?[A-Za-z°][^\d,;\n]{0,9})"
_NUMBER = regex(rf"[+−-]?\d{{0,30}}[.,]?\d{{1,30}}(?:[eE][+-]?\d{{1,3}})?{_UNIT}?")  # noqa: RUF001
_MEASURED = regex(rf"(?:[+−-]?0|[+−-]?\d{{1,30}}(?:[.,]\d{{1,30}})?{_UNIT})")  # noqa: RUF001
_AROUND = regex(
    r"^[\s\[(|]*(?:\\left ?[\[(]? ?)?(?:\\begin ?\{\w{1,20}\}(?:\{[clr| ]{1,20}\})?)?"
    r"|(?:\\\\)?\s*(?:\\end ?\{\w{1,20}\} ?(?:\\right ?[\])]?)?)?[\s\])|;]*$"
)
_BEHIND = regex(r"(?<=[\])}])[^\[\](){},;\n]{1,20}$")
"""A unit or the sign of a transposition behind the bracket."""
_RULE = regex(r"[-|:+=\s]*")
_ROWS = regex(r"\n|\\\\")
_BLANKS = regex(r"[ \t]+(?![A-Za-z°])")
_BETWEEN = regex(r"\s*[;\n]\s*|,?\s+")
_SEPARATORS = (";", "&", "|", "\t")


def with_points(text: str, shape: Shape | None = None) -> str:
    """A text with points for its decimal commas, where each comma in it must be one; else the text.

    Args:
        text: An answer, or a matrix out of a file.
        shape: Rows and columns of what is wanted; where nothing is, rows of three or four cells are believed.
    """
    if len(text) > LONGEST or not _COMMA.search(text):
        return text
    inside = _AROUND.sub("", _BEHIND.sub("", text.strip()))
    if "," in _COMMA.sub("", inside):
        pieces = re.split(r",\s+", inside) if shape and min(shape) == 1 else []
        fits = len(pieces) == max(shape or SIDES) and all(map(_MEASURED.fullmatch, pieces))
    else:
        fits = _are_outside(inside) and _fits(inside, shape)
    return _COMMA.sub(r"\1.", text) if fits else text


def comma_remark(text: str) -> str:
    """What to say about an answer that cannot be read, where its commas may be decimal ones; else empty."""
    if len(text) > LONGEST:
        return ""
    pieces = [piece for piece in _BETWEEN.split(text.strip(" \n[]();")) if piece]
    meant = next((match[1] for piece in pieces if (match := _ALONE.fullmatch(piece))), "")
    if len(pieces) < min(SIDES) - 1 or not meant:
        return ""
    return f"if {meant} is one number, write {meant.replace(',', '.')}: decimals take a point"


def _are_outside(text: str) -> bool:
    """Whether each comma stands outside the brackets of functions."""
    depth = 0
    for letter in text:
        depth += (letter in "([{") - (letter in ")]}")
        if letter == "," and depth:
            return False
    return True


def _fits(text: str, shape: Shape | None) -> bool:
    """Whether a text has the cells that are wanted, its commas inside them."""
    rows = [row for row in _ROWS.split(text) if not _RULE.fullmatch(row)]
    if len(rows) == 1:
        rows = [row for row in text.split(";") if row.strip()]
    if shape and min(shape) == 1 and len(rows) in _lengths(shape) and len(rows) > 1:
        return True
    cells = [_cells(row) for row in rows]
    widths = {len(row) for row in cells}
    if len(widths) != 1 or not widths.pop():
        return False
    found = len(cells), len(cells[0])
    if shape and (found == shape or (min(shape) == min(found) == 1 and max(found) in _lengths(shape))):
        return True
    return min(shape or SIDES) > 1 and found[0] > 1 and found[1] in SIDES


def _lengths(shape: Shape) -> tuple[int, ...]:
    """The lengths that a list may have: a vector may end with the last of homogeneous coordinates."""
    longest = max(shape)
    return (longest, longest + 1) if longest == min(SIDES) else (longest,)


def _cells(row: str) -> list[str]:
    """The cells of a row; none where blanks separate what is no number, for they may multiply as well."""
    for separator in _SEPARATORS:
        if separator in row.strip(" |;"):
            return [cell.strip() for cell in row.strip(" |;").split(separator)]
    cells = _BLANKS.split(row.strip(" |;"))
    return cells if all(map(_NUMBER.fullmatch, cells)) else []
