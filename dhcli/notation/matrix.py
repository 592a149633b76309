r"""Matrices in all the ways people write them.

`[[a, b], [c, d]]`, MATLAB's `[a b; c d]`, rows by lines, `np.array(...)`, `\begin{bmatrix} a & b \\ c & d`, CSV,
and tables pasted back from a terminal or from Markdown, dhcli's own among them.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import replace
from itertools import pairwise

from dhcli.errors import Place, plural
from dhcli.frozen import frozen
from dhcli.notation.brackets import OPENING
from dhcli.notation.cells import cells_in, matching, rows_in, trimmed, with_depths
from dhcli.notation.parser import read_all
from dhcli.notation.scaled import times, without_factor
from dhcli.notation.scope import OPEN, Scope
from dhcli.notation.tokens import MOST_CHARACTERS, Source, Token, tokenize
from dhcli.notation.tree import ONE, Expr, Unit
from dhcli.regex import regex

MOST_CELLS = 256
MOST_WRAPPINGS = 8
"""Brackets around a matrix that are taken off, such as those of `np.array([[...]])`."""

_SIDE = 4
LONGEST_COLUMNS = 100
"""Tokens in the list of columns of a LaTeX array."""
LONGEST = 64 * 2000

_GOES_ON = frozenset("+-*/^,(")
"""What a line ends in that is not the end of a row."""
_WRAPPERS = frozenset(("array", "matrix", "Matrix", "mat"))
_ENVIRONMENTS = frozenset(("bmatrix", "pmatrix", "matrix", "Bmatrix", "vmatrix", "smallmatrix", "array"))
_COMMENT = regex(r"^[ \t]*[%#].*$", re.MULTILINE)
"""A line that MATLAB or numpy would skip, such as the heading of dhcli's own output."""


@frozen
class Cell:
    """One entry of a matrix as it was typed and as it was read.

    Attributes:
        expr: As it was read, with the unit that stands behind the whole matrix.
        text: As it was typed.
        start: Offset of its first character.
        own: As it was read without that unit, which directions among lengths do not have.
    """

    expr: Expr
    text: str
    start: int
    own: Expr


def parse_matrix(text: str, scope: Scope = OPEN, place: Place | None = None) -> tuple[tuple[Cell, ...], ...]:
    """Read a matrix; all rows have the same number of cells.

    Args:
        text: What a person wrote or pasted.
        scope: The names it may use.
        place: Where the text stands, for errors.

    Raises:
        NotationError: With the column and what is wrong there.
    """
    bare = _COMMENT.sub(lambda comment: " " * len(comment[0]), text)
    source = Source(bare, place or Place("matrix"))
    return read_matrix(source, tokenize(source, most=LONGEST), scope)


def bracketed(rows: Iterable[Iterable[str]]) -> str:
    """Cells as the text of a matrix that can be read again: `[[1, 0], [0, 1]]`."""
    return "[" + ", ".join("[" + ", ".join(row) + "]" for row in rows) + "]"


def read_matrix(source: Source, tokens: Sequence[Token], scope: Scope) -> tuple[tuple[Cell, ...], ...]:
    """Read a matrix from tokens; see `parse_matrix`."""
    scaled = without_factor(source, _labelled([token for token in tokens if token.kind != "end"]), scope, _WRAPPERS)
    body = _unwrap(scaled.body)
    if {"&", ";"} <= {token.text for token in body}:  # LaTeX ends a row with \\ alone, and long rows are broken
        body = [token for token in body if token.kind != "newline"]
    if body and body[0].text == "[" and matching(body, 0) < 0:
        raise source.error(body[0].start, "this [ is never closed", "write the bracket behind the last row")
    rows = _without_axes([found for row in rows_in(body) if (found := cells_in(source, row))])
    if not rows:
        raise source.error(0, "no matrix is written here", "write [1 0 0 0; 0 1 0 0; 0 0 1 0; 0 0 0 1]")
    if sum(map(len, rows)) > MOST_CELLS:
        raise source.error(0, f"a matrix of more than {MOST_CELLS} cells is not read")
    widths = [len(row) for row in rows]
    if len(set(widths)) > 1:
        usual = max(set(widths), key=widths.count)
        odd = next(i for i, width in enumerate(widths) if width != usual)
        shown = " | ".join(_text(source, cell) for cell in rows[odd])
        hint = "c1 -s1 and a1 c1 are two cells, c1 - s1 and a1*c1 are one; commas settle it"
        if (odd, shown) == (_SIDE - 1, "0 | 0 | 1"):
            hint = "the bottom row of a pose is 0 0 0 1"
        raise source.error(
            rows[odd][0][0].start,
            f"row {odd + 1} has {plural(widths[odd], 'cell')} where others have {usual}: {shown}",
            hint,
        )
    read = tuple(tuple(_cell(source, cell, scope) for cell in row) for row in rows)
    if scaled.factor != ONE:
        read = tuple(tuple(_scaled(cell, scaled.factor) for cell in row) for row in read)
    return tuple(zip(*read, strict=True)) if scaled.is_transposed else read


def _without_axes(rows: list[list[list[Token]]]) -> list[list[list[Token]]]:
    """Rows without a head that only names the axes, `x' y' z'`, above four."""
    if len(rows) == _SIDE + 1 and [_letters(cell) for cell in rows[0][:3]] == ["x", "y", "z"]:
        return rows[1:]
    return rows


def _letters(cell: list[Token]) -> str:
    """A cell without primes and indices."""
    return "".join(token.text for token in cell if token.text not in ("'", '"')).partition("_")[0]


def _labelled(tokens: list[Token]) -> list[Token]:
    """Without `T =` in front."""
    tokens = trimmed(tokens)
    return tokens[2:] if [token.kind for token in tokens[:2]] == ["word", "sign"] and tokens[1].text == "=" else tokens


def _cell(source: Source, tokens: list[Token], scope: Scope) -> Cell:
    end = tokens[-1].end
    if end - tokens[0].start > MOST_CHARACTERS:
        raise source.error(tokens[0].start, f"a cell of more than {MOST_CHARACTERS} characters is not read")
    expr = read_all(source, tokens, scope)
    return Cell(expr, _text(source, tokens), tokens[0].start, expr)


def _scaled(cell: Cell, factor: Expr) -> Cell:
    expr = times(factor, cell.expr)
    return replace(cell, expr=expr, own=cell.expr if isinstance(factor, Unit) else expr)


def _text(source: Source, tokens: list[Token]) -> str:
    return source.text[tokens[0].start : tokens[-1].end]


def _unwrap(tokens: list[Token]) -> list[Token]:
    """Without LaTeX environments, `T =`, `array(...)` and the outermost brackets."""
    tokens = _labelled(_without_environments(tokens))
    for _ in range(MOST_WRAPPINGS):
        tokens = trimmed(tokens)
        if len(tokens) > 1 and tokens[0].kind == "word" and tokens[0].text in _WRAPPERS and tokens[1].text in OPENING:
            tokens = tokens[1:]
        closing = matching(tokens, 0)
        if closing != len(tokens) - 1 or closing < 1:
            break
        inside = trimmed(tokens[1:-1])
        if tokens[0].text == "(" and not (inside and (inside[0].text in ("[", "{") or _has_rows(inside))):
            return _tuples(inside) or tokens
        tokens = inside
    return tokens


def _has_rows(tokens: Sequence[Token]) -> bool:
    r"""Whether cells or rows are separated here, as in `(a b; c d)` or `\left(\begin{array}{cc} a & b \\ ...`."""
    ends = (previous for previous, token in pairwise(tokens) if token.kind == "newline")
    lines = any(token.kind != "newline" and token.text not in _GOES_ON for token in ends)
    flat = [token for token, depth in with_depths(tokens) if depth == 0]
    return any(token.text in ("&", ";") for token in flat) or (lines and any(token.kind == "newline" for token in flat))


def _tuples(tokens: list[Token]) -> list[Token]:
    """Rows in square brackets, where a text has them in round ones, `((1, 0), (0, 1))`; none where it has no rows."""
    start, rows = 0, list[Token]()
    while start < len(tokens):
        closing = matching(tokens, start)
        row = tokens[start + 1 : closing]
        if tokens[start].text != "(" or not any(not d and token.text == "," for token, d in with_depths(row)):
            return []
        rows += [replace(tokens[start], text="["), *row, replace(tokens[closing], text="]")]
        start = closing + 1
        while start < len(tokens) and (tokens[start].kind == "newline" or tokens[start].text == ","):
            start += 1
    return rows


def _without_environments(tokens: list[Token]) -> list[Token]:
    kept: list[Token] = []
    skip = 0
    for i, token in enumerate(tokens):
        if skip:
            skip -= 1
        elif token.text in ("begin", "end") and [t.text for t in tokens[i + 1 : i + 4 : 2]] == ["{", "}"]:
            environment = tokens[i + 2].text
            skip = 3 if environment in _ENVIRONMENTS else 0
            if skip and environment == "array" and token.text == "begin":
                closing = i + 4 + matching(tokens[i + 4 : i + 4 + LONGEST_COLUMNS], 0)
                skip = max(skip, closing - i)
            if not skip:
                kept.append(token)
        else:
            kept.append(token)
    return kept
