"""A DH table as CSV, or as a table of a Markdown page: heads that name the four columns, and a row for each link."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from dhcli.errors import FileError, Place, Problem, did_you_mean, plural
from dhcli.files.foreign.heads import Heads, cells_of, heads_of
from dhcli.files.foreign.rows import Cell, RowText
from dhcli.kinematics.conventions import COLUMNS
from dhcli.regex import regex

MOST_ROWS = 100
_RULE = regex(r"[\s|:+=-]+")
_KINDS = {"r": "R", "revolute": "R", "0": "R", "p": "P", "prismatic": "P", "1": "P", "f": "F", "fixed": "F"}
_READ = (*COLUMNS, "beta", "offset", "kind")


def read_table(text: str, source: str, units: str = "") -> tuple[Heads, list[RowText]]:
    """The heads and the rows of a table.

    Args:
        text: CSV, or a page with a table.
        source: What it is called in errors.
        units: Unit of lengths where the heads do not say one; metres by default.

    Raises:
        FileError: It has no heads, or a row has not as many cells.
    """
    heads = heads_of(text)
    if heads is None:
        raise FileError(Problem("holds no heads a, alpha, d, theta", Place(source), "the first row names the columns"))
    unknown = [column for column in heads.columns if column and column not in _READ]
    if unknown:
        place = Place(source, heads.line)
        hint = did_you_mean(unknown[0], _READ) or f"columns: {', '.join(_READ)}"
        raise FileError(Problem(f"{unknown[0]} is no column of a DH table", place, hint))
    rows = list(_rows(text, source, heads, units))
    if not rows:
        raise FileError(Problem("holds heads and no rows", Place(source, heads.line)))
    if len(rows) > MOST_ROWS:
        raise FileError(Problem(f"holds more than {MOST_ROWS} rows", Place(source), "is it the right file?"))
    return heads, rows


def _rows(text: str, source: str, heads: Heads, units: str) -> Iterator[RowText]:
    for number, line in enumerate(text.split("\n")[heads.line :], heads.line + 1):
        stripped = line.strip()
        if heads.sign == "|" and "|" not in stripped:
            return  # the table of a page has ended
        if not stripped or stripped.startswith("#") or _RULE.fullmatch(stripped):
            continue
        cells = cells_of(line, heads.sign)
        place = Place(source, number, 1, line)
        if len(cells) != len(heads.columns):
            message = f"{plural(len(cells), 'cell')}, and {plural(len(heads.columns), 'head')}"
            raise FileError(Problem(message, place, "a row has a cell under each head; text with a comma needs quotes"))
        yield _row(cells, place, heads, units)


def _row(cells: list[str], place: Place, heads: Heads, units: str) -> RowText:
    found: dict[str, Cell] = {}
    kind, column_of_text = "", 0
    for column, text, unit in zip(heads.columns, cells, heads.units, strict=True):
        column_of_text = max(column_of_text, place.text.find(text, column_of_text))
        here = replace(place, column=column_of_text + 1)
        if column == "kind":
            kind = _kind(text, here)
        elif column:
            default = units if column in ("a", "d") else ""
            found[column] = Cell(text or "0", here, unit or default)
        column_of_text += len(text)
    return RowText(place, found, kind)


def _kind(text: str, place: Place) -> str:
    known = _KINDS.get(text.strip().lower())
    if known is None:
        hint = did_you_mean(text, _KINDS) or "revolute, prismatic or fixed"
        raise FileError(Problem(f"{text!r:.60} is no kind of joint", place, hint))
    return known
