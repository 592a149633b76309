"""A DH table as CSV, or as a table of a Markdown page: heads that name the four columns, and a row for each link."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import islice, pairwise

from dhcli.errors import FileError, Place, Problem, did_you_mean, plural
from dhcli.files.foreign.heads import COUNTED, Heads, cells_of, heads_of
from dhcli.files.foreign.rows import Cell, RowText
from dhcli.files.yaml.placed import PlacedScalar
from dhcli.files.yaml.slips import items_of
from dhcli.kinematics.conventions import COLUMNS
from dhcli.regex import regex

MOST_ROWS = 100
MOST_LINES = 2000
_RULE = regex(r"[\s|:+=-]+")
_AROUND = regex(r"^\s*[-*] |^\s*[A-Za-z]\w{0,40} ?= ?[\w.]{0,40}\(?\[|[\[\](){}]|[#%].*")
_OPENED = regex(r"(?:- |[A-Za-z]\w{0,40} ?= ?(?:[\w.]{1,40}\()?)?\[{1,2}")
_CLOSED = regex(r"\]{1,2}\)?[,;]?(?:\s*[#%/].*)?")
_ROW_PARTS = regex(r"\s*[,;|&\t]\s*|\s+")
_KINDS = {"r": "R", "revolute": "R", "0": "R", "p": "P", "prismatic": "P", "1": "P", "f": "F", "fixed": "F"}
LIMITS = ("lower", "upper")
READ = (*COLUMNS, "beta", "offset", "kind", "range", *LIMITS)
_NONE = frozenset(("", "-", "–", "—", "−"))  # noqa: RUF001  dashes, and a minus sign
"""Cells of nothing, which are 0."""
_TWO_WAYS = regex(r"\+?(?P<high>[^-+/]{1,40})/ ?(?P<low>[-−][^-+/]{1,40})")  # noqa: RUF001  a minus sign


def read_table(text: str, source: str) -> tuple[Heads, list[RowText]]:
    """The heads and the rows of a table.

    Args:
        text: CSV, or a page with a table.
        source: What it is called in errors.

    Raises:
        FileError: It has no heads, or a row has not as many cells.
    """
    heads = heads_of(text)
    if heads is None:
        raise FileError(Problem("holds no heads a, alpha, d, theta", Place(source), "the first row names the columns"))
    lines = list(islice(_lines(text, source, heads), MOST_ROWS + 1))
    if not lines:
        raise FileError(Problem("holds heads and no rows", Place(source, heads.line)))
    if len(lines) > MOST_ROWS:
        raise FileError(Problem(f"holds more than {MOST_ROWS} rows", Place(source), "is it the right file?"))
    heads = _without_numbers(heads, [cells for cells, _ in lines])
    unknown = next((column for column in heads.columns if column and column not in READ), None)
    if unknown is not None:
        line = text.split("\n")[heads.line - 1]
        hint = did_you_mean(unknown, READ) or "a column without a head is left out"
        place = Place(source, heads.line, line.find(unknown) + 1, line)
        raise FileError(Problem(f"{unknown} is no column of a DH table", place, hint))
    return heads, [_row(cells, place, heads) for cells, place in lines]


def first_row(text: str) -> int | None:
    """The number of the first line of a text that is rows of four cells or more without heads; None if it is none."""
    lines = ((n, _AROUND.sub(" ", line).strip(" ,;")) for n, line in enumerate(islice(text.split("\n"), MOST_LINES), 1))
    rows = [(n, _ROW_PARTS.split(line)) for n, line in lines if line]
    if len(rows) == 1 and _is_row(rows[0][1]):
        return rows[0][0]
    pairs = pairwise(rows)
    return next((n for (n, row), (_, other) in pairs if _is_row(row) and _is_row(other, len(row))), None)


def _is_row(cells: Sequence[str], width: int = 0) -> bool:
    """Whether cells are those of a row: four or more, of which at most one has no number."""
    if not len(COLUMNS) <= len(cells) <= len(READ) or width not in (0, len(cells)):
        return False
    return sum(not (cell[-1:].isdigit() or cell.endswith(("°", "pi", "π"))) for cell in cells) <= 1


def _without_numbers(heads: Heads, rows: Sequence[Sequence[str]]) -> Heads:
    """The heads, of which a first one over the numbers of the rows says nothing; it may be missing, too."""
    if all(len(cells) == len(heads.columns) + 1 for cells in rows) and _are_numbers([cells[0] for cells in rows]):
        heads = replace(heads, columns=("", *heads.columns), units=("", *heads.units))
    if not all(len(cells) == len(heads.columns) for cells in rows):
        return heads  # which is told of the row
    first, *others = heads.columns
    is_number = first not in READ and _are_numbers([cells[0] for cells in rows])
    return replace(heads, columns=("", *others)) if is_number else heads


def _are_numbers(texts: Sequence[str]) -> bool:
    """Whether texts count rows, `1`, `2` or `L1`, `L2`, from 0 or 1 on."""
    found = [COUNTED.fullmatch(text) for text in texts]
    numbers = [int(match[1]) for match in found if match]
    return numbers in ([*range(len(texts))], [*range(1, len(texts) + 1)])


def _lines(text: str, source: str, heads: Heads) -> Iterator[tuple[list[str], Place]]:
    """The cells of each row, and where it stands; each row, or all of them, may stand in brackets."""
    depth = 0
    for number, line in enumerate(text.split("\n")[heads.line :], heads.line + 1):
        stripped = line.strip()
        if (heads.sign == "|" and "|" not in stripped) or stripped.startswith("\\end"):
            return  # the table of a page has ended
        before, (bare, depth) = depth, _without_brackets(stripped, depth)
        is_between = heads.sign == "&" and "&" not in stripped  # \hline
        if not (not bare or is_between or stripped.startswith("#") or _RULE.fullmatch(stripped)):
            yield cells_of(bare if bare != stripped else line, heads.sign), Place(source, number, 1, line)
        if before and not depth:
            return  # the list of rows has ended


def _without_brackets(row: str, depth: int) -> tuple[str, int]:
    """A row without the brackets of lists in YAML, Python and MATLAB around it, and how many are open behind it."""
    behind = depth + row.count("[") - row.count("]")
    opened, bare = _OPENED.match(row), row
    if not 0 <= behind <= 1 or (not depth and opened is None):
        return row, depth
    bare = row[opened.end() :] if opened else row
    closed = next((match for match in _CLOSED.finditer(bare) if match.end() == len(bare)), None)
    return (bare[: closed.start()] if closed else bare).strip(), behind


def _row(cells: list[str], place: Place, heads: Heads) -> RowText:
    if len(cells) != len(heads.columns):
        message = f"{plural(len(cells), 'cell')}, and {plural(len(heads.columns), 'head')}"
        raise FileError(Problem(message, place, "a row has a cell under each head; text with a comma needs quotes"))
    found: dict[str, Cell] = {}
    kind, column_of_text = "", 0
    for column, text, unit in zip(heads.columns, cells, heads.units, strict=True):
        column_of_text = max(column_of_text, place.text.find(text, column_of_text))
        here = replace(place, column=column_of_text + 1)
        if column == "kind":
            kind = kind_of(text, here)
        elif column == "range" and text not in _NONE:
            found |= dict(zip(LIMITS, (Cell(end.text, end.place, unit) for end in _ends(text, here)), strict=True))
        elif column != "range" and column and (text not in _NONE or column not in LIMITS):
            found[column] = Cell("0" if text in _NONE else text, here, unit)
        column_of_text += len(text)
    return RowText(place, found, kind)


def _ends(text: str, place: Place) -> Sequence[PlacedScalar]:
    """The lowest and the highest value of a range: `±170°`, `-170..170`, `+170/-170`.

    Raises:
        FileError: It is none.
    """
    text = _TWO_WAYS.sub(r"\g<low>..\g<high>", text)
    if len(ends := items_of(PlacedScalar(text, place), 2)[0]) != 2:  # noqa: PLR2004  lowest and highest
        raise FileError(Problem(f"'{text:.40}' is no range", place, "write ±170° or -170°..170°"))
    return ends


def kind_of(text: str, place: Place) -> str:
    """R, P or F, of the word for a kind of joint.

    Raises:
        FileError: It is none.
    """
    known = _KINDS.get(text.strip().lower())
    if known is None:
        hint = did_you_mean(text, _KINDS)
        raise FileError(Problem(f"{text!r:.60} is no kind of joint", place, hint))
    return known
