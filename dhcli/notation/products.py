"""Products of moves as text: `Trans(8, -6, 14) Rot(y, 90°) [1 0 0 2; ...] inv(Rot_z(theta1))`.

Reads brackets, inverses and the order of the factors; what one factor is, `factors` says.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import groupby
from typing import Literal

from dhcli.errors import Place
from dhcli.notation.cells import matching
from dhcli.notation.factors import EXAMPLE, Factor, Reading, read_matrix_factor, read_move
from dhcli.notation.operators import DEEPEST
from dhcli.notation.scope import OPEN, Scope
from dhcli.notation.tokens import Source, Token, tokenize

MOST_FACTORS = 200
LONGEST = 20_000

_INVERSE = frozenset(("inv", "inverse", "Inv"))
_WHERE = frozenset(("fixed", "current"))


def parse_factors(
    text: str, scope: Scope = OPEN, place: Place | None = None, remarks: list[str] | None = None, unit: str = ""
) -> tuple[Factor, ...]:
    """Read a product of moves and matrices, from left to right.

    Args:
        text: What a person wrote.
        scope: The names it may use.
        place: Where the text stands, for errors.
        remarks: Where to say that 1.5708 rad was taken as 90°; without it such angles are taken as they stand.
        unit: The unit of bare lengths; empty for metres.

    Raises:
        NotationError: With the column, what is wrong there, and what would be read.
    """
    source = Source(text, place or Place("product"))
    tokens = [token for token in tokenize(source, most=LONGEST) if token.kind != "end"]
    factors = tuple(_product(Reading(source, scope, remarks, unit), tokens, inverse=False))
    if not factors:
        raise source.error(0, "no move is written here", EXAMPLE)
    if len(factors) > MOST_FACTORS:
        raise source.error(factors[MOST_FACTORS].start, f"more than {MOST_FACTORS} moves are not read")
    return factors


def moves_of(factors: Sequence[Factor]) -> Iterator[list[Factor]]:
    """Factors move by move: a rotation about any axis is one move, and so is what stands in `fixed(...)`."""
    for _, group in groupby(factors, key=lambda factor: factor.start):
        yield list(group)


def in_order_of_motion(factors: Sequence[Factor]) -> list[Factor]:
    """Factors as they are multiplied: a move about the fixed frame stands before all that were typed before it."""
    ordered: list[Factor] = []
    for group in moves_of(factors):
        ordered = group + ordered if group[0].about == "fixed" else ordered + group
    return ordered


def _product(reading: Reading, tokens: Sequence[Token], *, inverse: bool, depth: int = 0) -> list[Factor]:
    source = reading.source
    if depth > DEEPEST:
        raise source.error(tokens[0].start if tokens else 0, f"brackets nested deeper than {DEEPEST} are not read")
    factors: list[Factor] = []
    i = 0
    while i < len(tokens):
        token = tokens[i]
        if token.kind == "newline" or (token.kind == "sign" and token.text in "*@"):
            i += 1
            continue
        opening = i + 1 if token.kind == "word" and token.text != "begin" else i
        closing = _end_of_environment(tokens, i) if token.text == "begin" else matching(tokens, opening)
        if closing < 0 and tokens[opening : opening + 1] and tokens[opening].text in ("(", "[", "{"):
            raise source.error(tokens[opening].start, f"{tokens[opening].text} is never closed", "close the bracket")
        if closing < 0:
            raise source.error(token.start, f"{token.text!r} is not a move or a matrix", EXAMPLE)
        inside = tokens[opening + 1 : closing]
        end = _inverse_mark(tokens, closing)
        turned = inverse != (end > closing)
        if token.kind == "word" and token.text in _INVERSE:
            part = _product(reading, inside, inverse=not turned, depth=depth + 1)
            factors.extend(part[::-1] if inverse else part)
        elif token.text == "(":
            part = _product(reading, inside, inverse=turned, depth=depth + 1)
            factors.extend(part[::-1] if inverse else part)
        elif token.kind == "word" and token.text in _WHERE:
            if depth or turned:
                raise source.error(token.start, f"{token.text}(...) stands by itself", "not in brackets, nor inverted")
            part = _product(reading, inside, inverse=False, depth=depth + 1)
            about: Literal["fixed", "current"] = "fixed" if token.text == "fixed" else "current"
            text = source.text[inside[0].start : inside[-1].end] if inside else ""
            factors.extend(replace(factor, about=about, start=token.start, text=text) for factor in part)
        elif token.kind == "sign" or token.text in ("begin", "array", "matrix", "Matrix"):
            factors.append(read_matrix_factor(reading, tokens[i : closing + 1], inverse=turned))
        else:
            part = read_move(reading, token, inside, tokens[closing], inverse=turned)
            factors.extend(part[::-1] if turned != inverse else part)
        i = end + 1
    return factors[::-1] if inverse else factors


def _end_of_environment(tokens: Sequence[Token], start: int) -> int:
    for i in range(start, len(tokens) - 3):
        if tokens[i].text == "end" and tokens[i + 1].text == "{":
            return i + 3
    return -1


def _inverse_mark(tokens: Sequence[Token], closing: int) -> int:
    """Where `^-1` or `^{-1}` behind a factor ends, or the closing bracket itself."""
    texts = "".join(token.text for token in tokens[closing + 1 : closing + 6])
    for mark, length in (("^-1", 3), ("^{-1}", 5), ("^(-1)", 5)):
        if texts.startswith(mark):
            return closing + length
    return closing
