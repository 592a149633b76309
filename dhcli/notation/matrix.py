r"""Matrices in all the ways people write them.

`[[a, b], [c, d]]`, MATLAB's `[a b; c d]`, rows by lines, `np.array(...)`, `\begin{bmatrix} a & b \\ c & d`, CSV,
and tables pasted back from a terminal or from Markdown, dhcli's own among them.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

from dhcli.errors import Place
from dhcli.notation.functions import FUNCTIONS
from dhcli.notation.parser import Parser
from dhcli.notation.quantity import UNITS
from dhcli.notation.scaled import times, without_factor
from dhcli.notation.scope import OPEN, Scope
from dhcli.notation.tokens import MOST_CHARACTERS, Source, Token, tokenize
from dhcli.notation.tree import Expr

MOST_CELLS = 64
MOST_WRAPPINGS = 8
"""Brackets around a matrix that are taken off, such as those of `np.array([[...]])`."""

_SIDE = 4
LONGEST_COLUMNS = 100
"""Tokens in the list of columns of a LaTeX array."""
LONGEST = 64 * 2000

_WRAPPERS = frozenset(("array", "matrix", "Matrix", "mat"))
_ENVIRONMENTS = frozenset(("bmatrix", "pmatrix", "matrix", "Bmatrix", "vmatrix", "smallmatrix", "array"))
_OPENING = {"(": ")", "[": "]", "{": "}"}
_RULES = frozenset("-|:+=")
_COMMENT = re.compile(r"^[ \t]*[%#].*$", re.MULTILINE)
"""A line that MATLAB or numpy would skip, such as the heading of dhcli's own output."""


@dataclass(frozen=True, slots=True)
class Cell:
    """One entry of a matrix as it was typed and as it was read."""

    expr: Expr
    text: str
    start: int


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
    rows = _without_axes([cells for row in _rows(body) if (cells := _cells(source, row))])
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
            f"row {odd + 1} has {widths[odd]} cell{'s'[: widths[odd] != 1]} where others have {usual}: {shown}",
            hint,
        )
    found = tuple(tuple(_cell(source, cell, scope) for cell in row) for row in rows)
    if not scaled.text:
        return found
    return tuple(
        tuple(Cell(times(scaled.factor, c.expr), f"{scaled.text}*({c.text})", c.start) for c in row) for row in found
    )


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
    tokens = _trim(tokens)
    return tokens[2:] if [token.kind for token in tokens[:2]] == ["word", "sign"] and tokens[1].text == "=" else tokens


def _cell(source: Source, tokens: list[Token], scope: Scope) -> Cell:
    end = tokens[-1].end
    if end - tokens[0].start > MOST_CHARACTERS:
        raise source.error(tokens[0].start, f"a cell of more than {MOST_CHARACTERS} characters is not read")
    parser = Parser(source, [*tokens, Token("end", "", end, end, spaced=False)], scope)
    expr = parser.expression()
    parser.finish()
    return Cell(expr, _text(source, tokens), tokens[0].start)


def _text(source: Source, tokens: list[Token]) -> str:
    return source.text[tokens[0].start : tokens[-1].end]


def _unwrap(tokens: list[Token]) -> list[Token]:
    """Without LaTeX environments, `T =`, `array(...)` and the outermost brackets."""
    tokens = _labelled(_without_environments(tokens))
    for _ in range(MOST_WRAPPINGS):
        tokens = _trim(tokens)
        if len(tokens) > 1 and tokens[0].kind == "word" and tokens[0].text in _WRAPPERS and tokens[1].text in _OPENING:
            tokens = tokens[1:]
        closing = matching(tokens, 0)
        if closing != len(tokens) - 1 or closing < 1:
            break
        inside = _trim(tokens[1:-1])
        if tokens[0].text == "(" and not (inside and (inside[0].text in ("[", "{") or _has_rows(inside))):
            break
        tokens = inside
    return tokens


def _has_rows(tokens: Sequence[Token]) -> bool:
    r"""Whether cells and rows are separated here as in LaTeX, `\left(\begin{array}{cc} a & b \\ ...`."""
    return any(depth == 0 and token.text == "&" for token, depth in _depths(tokens))


def _trim(tokens: list[Token]) -> list[Token]:
    start, end = 0, len(tokens)
    while start < end and tokens[start].kind == "newline":
        start += 1
    while end > start and (tokens[end - 1].kind == "newline" or tokens[end - 1].text in (",", ";")):
        end -= 1
    return tokens[start:end]


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


def matching(tokens: Sequence[Token], start: int) -> int:
    """Index of the bracket that closes the one at `start`, or -1."""
    if start >= len(tokens) or tokens[start].kind != "sign" or tokens[start].text not in _OPENING:
        return -1
    depth = 0
    for i in range(start, len(tokens)):
        if tokens[i].kind == "sign":
            depth += (tokens[i].text in _OPENING) - (tokens[i].text in _OPENING.values())
        if depth == 0:
            return i
    return -1


def _rows(tokens: list[Token]) -> Iterator[list[Token]]:
    """Rows as bracket groups, else as stretches between semicolons and line ends."""
    groups = _groups(tokens)
    if groups:
        yield from groups
        return
    row: list[Token] = []
    depth = 0
    for token in tokens:
        if token.kind == "sign":
            depth += (token.text in _OPENING) - (token.text in _OPENING.values())
        if depth == 0 and (token.kind == "newline" or token.text == ";"):
            yield row
            row = []
        elif token.kind != "newline":
            row.append(token)
    yield row


def _groups(tokens: list[Token]) -> list[list[Token]]:
    """The rows if every one stands in brackets of its own."""
    rows: list[list[Token]] = []
    i = 0
    while i < len(tokens):
        token = tokens[i]
        item = token.text == "-" and tokens[i + 1 : i + 2] and tokens[i + 1].text == "["  # of a YAML list
        if (
            token.kind == "newline"
            or token.text in (",", ";", "|")
            or (item and (i == 0 or tokens[i - 1].kind == "newline"))
        ):
            i += 1
        elif token.text in ("[", "{") and (closing := matching(tokens, i)) > i:
            rows.append([inner for inner in tokens[i + 1 : closing] if inner.kind != "newline"])
            i = closing + 1
        else:
            return []
    return rows


def _cells(source: Source, row: list[Token]) -> list[list[Token]]:
    """The cells of a row: separated by commas, `&` or bars if there are any, else by blanks."""
    if all(token.kind == "sign" and token.text in _RULES for token in row) or all(token.text == "&" for token in row):
        return []
    for separator in ("&", ",", "|"):
        marks = [i for i, (token, depth) in enumerate(_depths(row)) if token.text == separator and depth == 0]
        if marks:
            cells = [row[start + 1 : end] for start, end in pairwise((-1, *marks, len(row)))]
            if separator == "&":
                cells = [cell[:-1] if cell and cell[-1].text == "," else cell for cell in cells]
            first, last = separator == "|" and not cells[0], len(cells) - (not cells[-1])
            if separator == "|" and last - first == 1:  # bars around the row, not between cells
                return _blank_separated(cells[first])
            for i in range(first, last):
                if not cells[i]:
                    raise source.error(row[marks[i]].start, "a cell is empty here", "write 0 for a zero")
            return cells[first:last]
    return _blank_separated(row)


def _blank_separated(row: list[Token]) -> list[list[Token]]:
    cells: list[list[Token]] = []
    depths = [depth for _, depth in _depths(row)]
    for i, token in enumerate(row):
        new = i == 0 or (token.spaced and depths[i] == 0 and _separates(row[i - 1], token, row[i + 1 : i + 2]))
        if new:
            cells.append([token])
        else:
            cells[-1].append(token)
    return cells


def _separates(before: Token, token: Token, after: list[Token]) -> bool:
    """Whether a blank between two tokens begins a new cell: `c1 -s1` does, `c1 - s1`, `cos θ` and `30 mm` do not."""
    if before.kind == "sign" and before.text in "+-*/^√":
        return False
    if before.kind == "word" and (before.text in FUNCTIONS or (before.text in ("c", "s") and token.text in _OPENING)):
        return False
    if token.kind == "sign":
        if token.text in "*/^°)]}'":
            return False
        if token.text in "+-":
            return bool(after) and not after[0].spaced
    return not (token.kind == "word" and token.text in UNITS and before.kind == "number")


def _depths(row: Sequence[Token]) -> Iterator[tuple[Token, int]]:
    """Each token with the bracket depth it stands at; a bracket stands outside itself."""
    depth = 0
    for token in row:
        closing = token.kind == "sign" and token.text in _OPENING.values()
        depth -= closing
        yield token, depth
        depth += token.kind == "sign" and token.text in _OPENING
