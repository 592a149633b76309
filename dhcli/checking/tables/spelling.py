"""How people dress a table up: heads, link numbers, stars and drawn values, keys, all taken off before it is read."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

from dhcli.frozen import frozen
from dhcli.kinematics.conventions import COLUMNS, column_of
from dhcli.notation.brackets import STEPS
from dhcli.notation.cells import matching
from dhcli.notation.names import canonical
from dhcli.notation.quantity import LENGTH_UNITS, UNITS, Bare
from dhcli.notation.scope import Scope
from dhcli.notation.tokens import Token
from dhcli.notation.tree import Symbol
from dhcli.regex import regex

ANGLES = ("alpha", "theta")

_FILLING = frozenset(("i", "j", "n", "link", "joint", "no", "nr", "row", "type", "1", *",&|-/_[](){}")) | UNITS
_NUMBERING = frozenset(("link", "joint", "row"))
_KINDS = frozenset(("revolute", "prismatic", "fixed"))
_RULES = frozenset(("hline", "toprule", "midrule", "bottomrule"))
_BREAKS = frozenset(",&|;]}(")
_NUMBER_SIGN = regex(r"^([^\S\n]{0,40}\|?[^\S\n]{0,40})#(?=[^\S\n]{0,40}[|,&\s])")
_BULLET = regex(r"^([^\S\n]{0,40})-(?=[^\S\n]{1,40}[\[{])", re.MULTILINE)
_ROW_NAME = regex(r"^\s{0,40}(?:(?:link|joint|row)\s{0,9})?(?:\d{1,2}\s{0,9}[:.)])?\s{0,9}(?=\S)", re.IGNORECASE)
_CALL = regex(r"\s{0,40}[A-Za-z_]\w{0,30}\((?P<inside>[^()]{0,400}(?:\([^()]{0,99}\)[^()]{0,400}){0,4})\)[,;]?\s{0,40}")
_NUMBERED = regex(
    r"^[^\S\n]{0,40}(?:(?:link|joint|row)[^\S\n]{0,9})?\d{1,2}[^\S\n]{0,9}(?:[:)]|\.(?=(?:[^,\n]{0,99},){3}))(?=[^\S\n]|[^\W\d])",
    re.IGNORECASE | re.MULTILINE,
)
"""The number of a row before cells that commas separate, which would be a factor of the first."""
LONGEST_ROW = 400
"""Tokens looked ahead for a closing bracket, so that hostile text costs no more than its length."""

_ORDER = regex(r"^.*\bRot\(.*$", re.MULTILINE)


@frozen
class Heads:
    """What is known of the columns.

    Attributes:
        columns: Their order.
        bare: What an angle without a unit is in.
        unit: What a length without a unit is in.
        says_unit: Whether they say that unit themselves.
    """

    columns: tuple[str, ...]
    bare: Bare = "deg"
    unit: str = "m"
    says_unit: bool = False


def keyed_rows(text: str) -> str:
    """Rows whose cells have names, `Joint 1: θ = θ1, d = 0, a = a1, α = 0`, as those in braces; all, or none.

    They may stand in one line with semicolons between them, and in the brackets of a class, `DHLink(a=a1, ...)`.
    """
    rows = []
    lines = text.splitlines()
    for line in lines if len(lines) > 1 else text.split(";"):
        inside = _CALL.fullmatch(_ROW_NAME.sub("", line))
        bare = inside["inside"] if inside else _ROW_NAME.sub("", line)
        cells = [cell.partition("=") for cell in re.split(r"[,;]", bare) if cell.strip()]
        names = [column_of(name.strip())[0] for name, _, _ in cells]
        if cells and (sorted(names) != sorted(COLUMNS) or not all(value.strip() for _, _, value in cells)):
            return text
        named = (f"{name}: {value}" for name, (_, _, value) in zip(names, cells, strict=True))
        rows += [f"{{{', '.join(named)}}}"] if cells else []
    return "\n".join(rows)


def plain_text(text: str) -> str:
    """The text with bullets, numbers of rows and the line of the order of operations blanked out; columns stay."""
    if len(_NUMBERED.findall(text)) > 1:
        text = _NUMBERED.sub(lambda number: " " * len(number[0]), text)
    text = _BULLET.sub(r"\1 ", _NUMBER_SIGN.sub(r"\1i", text))
    return _ORDER.sub(lambda line: " " * len(line[0]), text)


def without_stars(tokens: list[Token], scope: Scope, variables: Sequence[str]) -> list[Token]:
    """Without what marks a joint variable: a star, and in brackets the value in the pose drawn."""
    kept: list[Token] = []
    i = 0
    while i < len(tokens):
        token = tokens[i]
        i += 1
        if token.kind == "word" and token.text in _RULES:
            continue
        if token.text == "tabular":
            token = replace(token, text="array")
        kept.append(token)
        if token.kind != "word" or not _is_variable(token.text, scope, variables):
            continue
        star = i + (tokens[i].text == "^" and tokens[i + 1].text == "*")
        if tokens[star].text == "*" and _ends_cell(tokens[star + 1]):
            i = star + 1
        closing = _closing(tokens, i) if tokens[i].text == "(" else -1
        if closing > i and all(_is_constant(inner) for inner in tokens[i + 1 : closing]):
            i = closing + 1
            i += tokens[i].text == "*" and _ends_cell(tokens[i + 1])
    return kept


def _is_variable(word: str, scope: Scope, variables: Sequence[str]) -> bool:
    return any(isinstance(reading, Symbol) and reading.name in variables for reading in scope.readings(word))


def _ends_cell(token: Token) -> bool:
    return token.kind in ("end", "newline") or token.text in _BREAKS or token.spaced


def _is_constant(token: Token) -> bool:
    return token.kind == "number" or token.text in ("+", "-", "/", "*", "°", "π", "pi") or token.text in UNITS


def in_order(tokens: list[Token], columns: Sequence[str]) -> list[Token]:
    """Rows such as `{alpha: 0, a: 0, d: d1, theta: theta1}` as plain lists, in the order of the columns."""
    if not any(token.text == ":" for token in tokens):
        return tokens
    kept: list[Token] = []
    i = 0
    while i < len(tokens):
        closing = _closing(tokens, i) if tokens[i].text == "{" else -1
        cells = _keyed(tokens[i + 1 : closing]) if closing > i else {}
        if set(cells) == set(COLUMNS):
            for index, column in enumerate(columns):
                kept += [replace(tokens[i], text="," if index else "["), *cells[column]]
            kept.append(replace(tokens[closing], text="]"))
            i = closing
        elif tokens[i].text != ":":
            kept.append(tokens[i])
        i += 1
    return kept


def _keyed(tokens: Sequence[Token]) -> dict[str, list[Token]]:
    cells: dict[str, list[Token]] = {}
    key = ""
    for index, token in enumerate(tokens):
        follower = tokens[index + 1].text if index + 1 < len(tokens) else ""
        if follower == ":" and canonical(token.text) in COLUMNS:
            key = canonical(token.text)
            cells[key] = []
        elif key and token.text != ":" and not (token.text == "," and _opens_key(tokens, index + 1)):
            cells[key].append(token)
    return {column: cell for column, cell in cells.items() if cell}


def _opens_key(tokens: Sequence[Token], index: int) -> bool:
    return index >= len(tokens) or (index + 1 < len(tokens) and tokens[index + 1].text == ":")


def without_heads(tokens: list[Token], known: Heads) -> tuple[list[Token], Heads]:
    """The tokens without a first row that names the columns, and what that row says."""
    start = next((i for i, t in enumerate(tokens) if t.kind == "word" and _column(t.text)), len(tokens))
    while start and tokens[start - 1].text.lower() in _FILLING - STEPS.keys():
        start -= 1
    end = _end_of_heads(tokens, start)
    row = tokens[start:end]
    found = tuple(column for token in row if (column := _column(token.text)))
    if sorted(found) != sorted(COLUMNS) or not any(token.kind in ("word", "number") for token in tokens[end:]):
        return _without_numbering(tokens), known
    units = dict.fromkeys(COLUMNS, "")
    column = ""
    for token in row:
        column = _column(token.text) or column
        if column and token.text in UNITS:
            units[column] = token.text
    bare: Bare = "rad" if any(units[angle].startswith("rad") for angle in ANGLES) else known.bare
    unit = next((units[length] for length in ("a", "d") if units[length] in LENGTH_UNITS), "")
    heads = Heads(found, bare, unit or known.unit, says_unit=bool(unit))
    return _without_numbering([*tokens[:start], *tokens[end:]]), heads


def _end_of_heads(tokens: list[Token], start: int) -> int:
    """Where a row of heads that begins here ends; where it begins if there is anything else in it."""
    depth = 0
    for index in range(start, len(tokens)):
        token = tokens[index]
        depth += STEPS.get(token.text, 0)
        if token.kind in ("newline", "end") or depth < 0 or (token.text == ";" and depth == 0):
            return index
        if not (_column(token.text) or token.text.lower() in _FILLING):
            return start
    return start


def _without_numbering(tokens: list[Token]) -> list[Token]:
    """Without the word in `link 1`, which numbers a row, and without the kind of a joint."""
    return [
        token
        for token, after in zip(tokens, [*tokens[1:], tokens[-1]], strict=True)
        if not (token.text.lower() in _NUMBERING and after.kind == "number") and token.text.lower() not in _KINDS
    ]


def _column(word: str) -> str:
    """The column that a head such as `α_{i-1}` names, or nothing."""
    return column_of(word)[0]


def _closing(tokens: Sequence[Token], start: int) -> int:
    """Index of the bracket that closes the one at `start`, or -1; a cell or a row is never longer than the window."""
    found = matching(tokens[start : start + LONGEST_ROW], 0)
    return start + found if found >= 0 else -1
