"""Blanks that multiply, where they might separate: `a1 c1 + a2 c12` is one coordinate, and not the three of a point."""

from __future__ import annotations

from collections.abc import Sequence

from dhcli.checking.pasted import UnreadableError
from dhcli.checking.units import is_homogeneous
from dhcli.errors import NotationError
from dhcli.notation.matrix import Cell
from dhcli.notation.parser import parse
from dhcli.notation.scope import Scope
from dhcli.notation.tree import Expr, Product
from dhcli.notation.writer import write
from dhcli.regex import regex

LONGEST = 400
"""Characters of one expression among those that are asked about."""

_SEPARATED = regex(r"[,;&|\n]")
_SUM = regex(r"(?<=[\w)\]}])(?: +[+−-]|[+−-] )")  # noqa: RUF001
_SPACED_SUM = regex(r"(?<=[\w)\]}]) +[+−-] ")  # noqa: RUF001
_NUMBER_BEHIND = regex(r"[\w)\]}] +[\d.]")


def refuse_one_expression(text: str, cells: Sequence[Sequence[Cell]], wanted: int, scope: Scope) -> None:
    """Refuse a list whose blanks may as well multiply, or can do nothing else.

    It is one expression where that is a sum of like terms and the cells between the blanks are none, `c1 + a2` for one;
    a question where both are, and no product in it is written without a blank.

    Args:
        text: What was typed, in square brackets or none, without names before its numbers.
        cells: The cells between its blanks.
        wanted: How many are asked for.
        scope: The names it may use.

    Raises:
        UnreadableError: It is one expression, or may be one.
    """
    body = text.strip(" \t[]")
    count = sum(map(len, cells))
    sums = _SPACED_SUM if count == wanted else _SUM
    if len(body) > LONGEST or count == 1 or _SEPARATED.search(body) or not sums.search(body):
        return
    expr = None if _NUMBER_BEHIND.search(body) else _read(body, scope)
    if expr is None or not is_homogeneous(expr, scope):
        return
    split = all(is_homogeneous(cell.expr, scope) for row in cells for cell in row)
    if split and any(isinstance(_read(piece.strip("+-−"), scope), Product) for piece in body.split()):  # noqa: RUF001
        return
    raise UnreadableError(
        f"this is one expression, {write(expr, 'short')}, and {wanted} were asked: write commas between them"
    )


def _read(text: str, scope: Scope) -> Expr | None:
    try:
        return parse(text, scope)
    except NotationError:
        return None
