"""Rows and cells of a matrix among its tokens: bracket groups, semicolons and line ends; commas, `&`, bars, blanks."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise

from dhcli.notation.brackets import OPENING, closing, depths
from dhcli.notation.functions import FUNCTIONS
from dhcli.notation.quantity import UNITS
from dhcli.notation.tokens import Source, Token

_RULES = frozenset("-|:+=")


def matching(tokens: Sequence[Token], start: int) -> int:
    """Index of the bracket that closes the one at `start`, or -1."""
    if start >= len(tokens) or tokens[start].kind != "sign" or tokens[start].text not in OPENING:
        return -1
    end = closing(tokens[i].text for i in range(start, len(tokens)))
    return -1 if end < 0 else start + end


def rows_in(tokens: list[Token]) -> Iterator[list[Token]]:
    """Rows as bracket groups, else as stretches between semicolons and line ends."""
    groups = _groups(tokens)
    if groups:
        yield from groups
        return
    row: list[Token] = []
    for token, depth in with_depths(_as_commas(tokens)):
        if depth == 0 and (token.kind == "newline" or token.text == ";"):
            yield row
            row = []
        elif token.kind != "newline":
            row.append(token)
    yield row


def _as_commas(tokens: list[Token]) -> list[Token]:
    """Semicolons as commas where they stand between the cells of rows by lines, `a;b;c` below `d;e;f`."""
    lines: list[list[list[Token]]] = [[[]]]
    for token, depth in with_depths(tokens):
        if depth == 0 and token.kind == "newline":
            lines.append([[]])
        elif depth == 0 and token.text == ";":
            lines[-1].append([])
        elif depth == 0 and token.text in (",", "&", "|"):
            return tokens
        else:
            lines[-1][-1].append(token)
    rows = [line for line in lines if any(line)]
    whole = len(rows) > 1 and len(rows[0]) > 1 and len({len(row) for row in rows}) == 1
    if not whole or not all(cell and len(_blank_separated(cell)) == 1 for row in rows for cell in row):
        return tokens
    both = with_depths(tokens)
    return [replace(token, text=",") if depth == 0 and token.text == ";" else token for token, depth in both]


def _groups(tokens: list[Token]) -> list[list[Token]]:
    """The rows if every one stands in brackets of its own."""
    rows: list[list[Token]] = []
    i, items = 0, _items(tokens)
    while i < len(tokens):
        token = tokens[i]
        if token.kind == "newline" or token.text in (",", ";", "|") or i in items:
            i += 1
        elif _opens_row(tokens, i) and (closing := matching(tokens, i)) > i:
            rows.append([inner for inner in tokens[i + 1 : closing] if inner.kind != "newline"])
            i = closing + 1
        else:
            return []
    return rows


def _items(tokens: list[Token]) -> set[int]:
    """The bullets of a YAML list; one alone is a minus sign."""
    found = {
        i
        for i, (token, behind) in enumerate(pairwise(tokens))
        if token.text == "-" and behind.text == "[" and (i == 0 or tokens[i - 1].kind == "newline")
    }
    return found if len(found) > 1 else set()


def _opens_row(tokens: list[Token], i: int) -> bool:
    """Whether a bracket around a row opens here; a round one is around a line of several cells, and begins it."""
    if tokens[i].text != "(":
        return tokens[i].text in ("[", "{")
    end = matching(tokens, i)
    own = tokens[i + 1 : end]
    begins, ends = (
        i == 0 or tokens[i - 1].kind == "newline",
        end + 1 >= len(tokens) or tokens[end + 1].kind == "newline",
    )
    return end > i and begins and ends and len(_blank_separated(own) if own else own) > 1


def cells_in(source: Source, row: list[Token]) -> list[list[Token]]:
    """The cells of a row: separated by commas, `&` or bars if there are any, else by blanks."""
    if all(token.kind == "sign" and token.text in _RULES for token in row) or all(token.text == "&" for token in row):
        return []
    texts = {token.text for token in row}
    for separator in ("&", ",", "|"):
        both = enumerate(with_depths(row)) if separator in texts else ()
        marks = [i for i, (token, depth) in both if depth == 0 and token.text == separator]
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
    depths = [depth for _, depth in with_depths(row)]
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
    if before.kind == "word" and (before.text in FUNCTIONS or (before.text in ("c", "s") and token.text in OPENING)):
        return False
    if token.kind == "sign":
        if token.text in "*/^°)]}'":
            return False
        if token.text in "+-":
            return bool(after) and not after[0].spaced
    return not (token.kind == "word" and token.text in UNITS and before.kind == "number")


def with_depths(row: Sequence[Token]) -> Iterator[tuple[Token, int]]:
    """Each token with the bracket depth it stands at; a bracket stands outside itself."""
    return zip(row, depths(token.text for token in row), strict=True)


def trimmed(tokens: Sequence[Token]) -> list[Token]:
    """Tokens without the ends of lines around them, nor the separators behind them."""
    start, end = 0, len(tokens)
    while start < end and tokens[start].kind == "newline":
        start += 1
    while end > start and (tokens[end - 1].kind == "newline" or tokens[end - 1].text in (",", ";")):
        end -= 1
    return list(tokens[start:end])
