"""The rows and the cells of frames, in any spelling: with or without brackets, names, numbers, commas and bars."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from dhcli.checking.pasted import UnreadableError, refuse_long
from dhcli.notation.brackets import OPENING, depths, split
from dhcli.regex import regex

LONGEST = 20_000
"""Characters of an answer."""

SHAPE = "a row for each frame has its origin, its x axis and its z axis, such as (a1, 0, 0) +x +z"

_MINUS = "\N{MINUS SIGN}"
AXIS = regex(rf"([+\-{_MINUS}]?)([xyz])(?:_?\{{?\d{{1,3}}\}}?)?")
"""A direction along an axis of the base: `+z`, `-x0`."""

_CAPITALS = regex(rf"(?<![\w)])[+\-{_MINUS}]?[XYZ](?=_?\{{?\d{{0,3}}\}}?(?:$|[\s,;|&)\]}}=:]))")
_HAS_AXIS = regex(rf"(?:^|[\s,;=:|&(\[{{]){AXIS.pattern}(?=$|[\s,;|&)\]}}=:])")
_HEADS = regex(r"\W{0,9}(?:frame|no|i)?\W{0,9}(?:origin|o)\W{1,9}x\W{1,9}(?:y\W{1,9})?z\W{0,9}", re.IGNORECASE)
_NUMBER = regex(r"\s*(?:frame\s{0,9})?\{?(\d{1,4})\}?\s{0,9}:|\s*frame\s{1,9}(\d{1,4})(?=\s)", re.IGNORECASE)
_LABEL = regex(r"(?<![\w+.-])(frame|origin|o|x|y|z)(?:_?\{?(\d{1,4})\}?)?\s{0,9}[=:]", re.IGNORECASE)
_BLANK = regex(r"(?<![+*/^-])[ \t]+(?![*/^]|[-+][ \t])")
"""A blank that separates cells: not beside an operator, so that `a + b` is one cell, and `a -b` are two."""

_VECTOR = 3
_PAIRS = 3
"""Pairs of brackets around a text that say nothing; more of them are no notation of frames."""


def small_axes(text: str) -> str:
    """A text with small letters for the capital ones of axes, `+X0`."""
    return _CAPITALS.sub(lambda axis: axis[0].lower(), text)


def has_frames(text: str) -> bool:
    """Whether a text holds axes and no table: names of axes, or more numbers in a row than a table has.

    Raises:
        UnreadableError: It is too long to be looked at.
    """
    refuse_long(text, LONGEST)
    return bool(_HAS_AXIS.search(text)) or any(len(_cells(_bare(row))) > 2 * _VECTOR for row in rows_of(text))


def is_minus(sign: str) -> bool:
    """Whether a sign is one that people type for a minus."""
    return sign in ("-", _MINUS)


def rows_of(text: str) -> list[str]:
    """The rows of an answer: its lines, what stands between semicolons, or brackets within brackets."""
    rows = [row for line in _bare(text).splitlines() for row in _pieces(line, ";")]
    if len(rows) == 1:
        nested = _pieces(rows[0], ",")
        if all(piece[:1] in OPENING and len(_cells(_bare(piece))) > 1 for piece in nested) and len(nested) > 1:
            rows = nested if any(len(_cells(_bare(piece))) != _VECTOR for piece in nested) else rows
    return [row for row in rows if row.strip(" \t|-+:") and not _HEADS.fullmatch(row)]


def named_cells(row: str) -> tuple[int | None, dict[str, str]]:
    """The number of a frame, if it is written, and its cells by name: o, x, z, and y where it stands there.

    Raises:
        UnreadableError: There are too few cells, or too many.
    """
    number: int | None = None
    body = row.strip().strip("|")
    if match := _NUMBER.match(body):
        number, body = int(match[1] or match[2]), body[match.end() :]
    body = _bare(body)
    if labels := list(_LABEL.finditer(_masked(body))):
        return _labelled(body, labels, number)
    return _by_place(_cells(body), number, row)


def triple(text: str) -> list[str]:
    """The cells of a vector, in brackets or without."""
    return _cells(_bare(text))


def _labelled(body: str, labels: Sequence[re.Match[str]], number: int | None) -> tuple[int | None, dict[str, str]]:
    """`o1 = (a, 0, 0), x1 = +x, z1 = +z`: cells by their names."""
    found: dict[str, str] = {}
    numbers = {number} if number is not None else set()
    ends = [*(label.start() for label in labels[1:]), len(body)]
    for label, end in zip(labels, ends, strict=True):
        name, value = label[1].lower()[0], body[label.end() : end].strip(" \t,;|")
        if name == "f":
            numbers |= {int(value)} if value.isdecimal() else set()
        elif name in found:
            raise UnreadableError(f"{label[1]} stands twice in '{body.strip():.60}'; {SHAPE}")
        else:
            found[name] = value
            numbers |= {int(label[2])} if label[2] else set()
    if len(numbers) > 1:
        raise UnreadableError(f"'{body.strip():.60}' names more than one frame; {SHAPE}")
    return next(iter(numbers), None), found


def _by_place(cells: list[str], number: int | None, row: str) -> tuple[int | None, dict[str, str]]:
    """The origin, then x and z, or x, y and z; three numbers that follow one another are a vector."""
    plain = [cell[:1] not in OPENING and not AXIS.fullmatch(cell) for cell in cells]
    run = plain.index(False) if False in plain else len(plain)
    is_alone = run == 1 and len(cells) > 1 and cells[1][:1] in OPENING
    if number is None and (run % _VECTOR == 1 and (run > 1 or is_alone)) and cells[0].isdecimal():
        number, cells, plain = int(cells[0]), cells[1:], plain[1:]
    vectors: list[str] = []
    k = 0
    while k < len(cells):
        is_origin = not vectors and cells[k] in ("0", "o", "O") and not all(plain[k : k + _VECTOR])
        width = _VECTOR if plain[k] and not is_origin else 1
        vectors.append(cells[k] if width == 1 else f"({', '.join(cells[k : k + width])})")
        k += width
    names = {_VECTOR: "oxz", _VECTOR + 1: "oxyz"}.get(len(vectors), "")
    if not names:
        raise UnreadableError(f"'{row.strip():.60}' has {len(vectors)} of three vectors; {SHAPE}")
    return number, dict(zip(names, vectors, strict=True))


def _cells(text: str) -> list[str]:
    """The cells of a text: at its commas and bars outside brackets if it has some, else at its blanks."""
    pieces = _pieces(text, ",;|&")
    found: list[str] = []
    for piece in pieces:
        cells = list(_at_blanks(piece))
        is_several = len(pieces) == 1 or all(cell[:1] in OPENING or AXIS.fullmatch(cell) for cell in cells[1:])
        found += cells if is_several else [piece]
    return found


def _at_blanks(text: str) -> Iterator[str]:
    start = 0
    for blank in _BLANK.finditer(_masked(text)):
        if cell := text[start : blank.start()].strip():
            yield cell
        start = blank.end()
    if cell := text[start:].strip():
        yield cell


def _pieces(text: str, separators: str) -> list[str]:
    """What stands between some signs, those within brackets left alone."""
    return [piece.strip() for _, piece in split(text, separators) if piece.strip()]


def _masked(text: str) -> str:
    """A text of the same length without what stands within brackets."""
    return "".join("." if depth else letter for letter, depth in zip(text, depths(text), strict=True))


def _bare(text: str) -> str:
    """A text without the brackets around all of it."""
    body = text.strip()
    for _ in range(_PAIRS):
        is_whole = len(body) > 1 and body[0] in OPENING and body[-1] == OPENING[body[0]]
        if not is_whole or set(_masked(body)[1:-1]) - {"."}:
            break
        body = body[1:-1].strip()
    return body
