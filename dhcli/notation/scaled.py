r"""What stands beside a matrix: a factor, `\frac{1}{2} \begin{bmatrix} ... \end{bmatrix}`, a unit, a raised T."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from dhcli.frozen import frozen
from dhcli.notation.angle import Rational
from dhcli.notation.brackets import OPENING
from dhcli.notation.cells import matching, trimmed
from dhcli.notation.parser import read_all
from dhcli.notation.quantity import LENGTH_UNITS
from dhcli.notation.scope import Scope
from dhcli.notation.tokens import Source, Token
from dhcli.notation.tree import ONE, Expr, Number, Unit, multiply, number
from dhcli.notation.walk import symbols

_LARGEST_POWER = 9
_SEPARATORS = frozenset(",;&|=")
_TRANSPOSED = (("^", "T"), ("^", "top"), ("^", "{", "T", "}"), ("^", "{", "top", "}"), ("'",))


@frozen
class Scaled:
    """A matrix with its factor taken off.

    Attributes:
        body: The tokens of the matrix.
        factor: What every cell is to be multiplied with; 1 where nothing stands.
        is_transposed: Whether rows are written for columns, as the sign behind it says.
    """

    body: list[Token]
    factor: Expr = ONE
    is_transposed: bool = False


def without_factor(source: Source, tokens: list[Token], scope: Scope, wrappers: frozenset[str]) -> Scaled:
    """Take the factor, the unit and the sign of a transposition off a matrix, if any stand before or behind it.

    Args:
        source: The text.
        tokens: Its tokens, without `end`.
        scope: The names it may use.
        wrappers: Words that stand before the bracket of a matrix, such as array.

    Raises:
        NotationError: What stands there cannot be read.
    """
    start, end = _matrix(tokens, wrappers)
    if end < 0 or (start == 0 and end == len(tokens) - 1):
        return Scaled(tokens)
    before, after = trimmed(tokens[:start]), trimmed(tokens[end + 1 :])
    if not (before or after) or not _is_factor(before) or not _is_factor(after):
        return Scaled(tokens)
    sign = next((sign for sign in _TRANSPOSED if tuple(token.text for token in after[: len(sign)]) == sign), ())
    after, turned = after[len(sign) :], bool(sign)
    body = tokens[start : end + 1]
    if not before and not after:
        return Scaled(body, is_transposed=turned)
    if not before and len(after) == 1 and after[0].text in LENGTH_UNITS:
        return Scaled(body, Unit(after[0].text), turned)
    if after and after[0].text not in ("*", "/"):
        return Scaled(tokens)  # the number of an equation, or another matrix
    if not any(token.text in _SEPARATORS or token.kind == "newline" for token in body[:-1]):
        return Scaled(tokens)
    signed = bool(before and before[-1].text == "*") or bool(after and after[0].text in ("*", "/"))
    factor: Expr = ONE
    for side in (before, after):
        if side:
            factor = multiply(factor, _read(source, side, scope))
    if symbols(factor) and not signed:
        return Scaled(tokens)  # `T [1 0; 0 1]` has a label without its sign
    return Scaled(body, factor, turned)


def times(factor: Expr, cell: Expr) -> Expr:
    """A cell with its factor; a power of ten moves the point and leaves the digits as many as they are."""
    if isinstance(factor, Number) and isinstance(cell, Number) and cell.places is not None:
        shift = _power_of_ten(factor.value)
        if shift is not None:
            places = cell.places - shift
            return Number(factor.value * cell.value, places if places > 0 else None)
    return multiply(factor, cell)


def _power_of_ten(value: Rational) -> int | None:
    for power in range(-_LARGEST_POWER, _LARGEST_POWER + 1):
        if value == Fraction(10) ** power:
            return power
    return None


def _matrix(tokens: Sequence[Token], wrappers: frozenset[str]) -> tuple[int, int]:
    """Where the first matrix in brackets or in an environment begins and ends; -1 if there is none."""
    for i, token in enumerate(tokens):
        if token.kind == "newline" and i:
            return 0, -1
        if token.text == "begin" and tokens[i + 1 : i + 2] and tokens[i + 1].text == "{":
            ends = [k for k in range(len(tokens) - 3) if tokens[k].text == "end" and tokens[k + 1].text == "{"]
            return (i, ends[-1] + 3) if ends else (0, -1)
        called = token.kind == "word" and token.text in wrappers and i + 1 < len(tokens)
        opening = i + 1 if called else i
        if (tokens[opening].text == "[" or (called and tokens[opening].text in OPENING)) or _holds_matrix(tokens, i):
            return i, matching(tokens, opening)
    return 0, -1


def _holds_matrix(tokens: Sequence[Token], at: int) -> bool:
    """Whether a round bracket stands here around a matrix."""
    return tokens[at].text == "(" and at + 1 < len(tokens) and tokens[at + 1].text in ("begin", "[")


def _is_factor(tokens: Sequence[Token]) -> bool:
    """Whether nothing in some tokens separates cells or rows."""
    return not any(token.kind == "newline" or token.text in _SEPARATORS for token in tokens)


def _read(source: Source, tokens: list[Token], scope: Scope) -> Expr:
    if len(tokens) == 1 and tokens[0].text in ("+", "-"):
        return number(1 if tokens[0].text == "+" else -1)
    if tokens[-1].text == "*":
        tokens = tokens[:-1]
    elif tokens[0].text == "*":
        tokens = tokens[1:]
    elif tokens[0].text == "/":
        tokens = [Token("number", "1", tokens[0].start, tokens[0].start, spaced=False), *tokens]
    return read_all(source, tokens, scope)
