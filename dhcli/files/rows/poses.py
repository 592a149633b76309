"""Poses a row each, as `fk --in` writes them: CSV, JSON Lines or .npy, block by block."""

from __future__ import annotations

import csv
import json
import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from functools import partial
from itertools import chain, islice
from typing import TYPE_CHECKING, TextIO, TypeVar

import numpy as np

from dhcli.errors import FileError, Place, Problem
from dhcli.files.reading import explain, source_of
from dhcli.files.rows import POSITION
from dhcli.files.rows.blocks import cell_problem
from dhcli.files.rows.cells import DECIMAL_BETWEEN, SIGNS, CellError, decimals_in, json_number, plain_table, read_cell
from dhcli.files.rows.csvrows import DECLARED
from dhcli.files.rows.turns import TURNS, check_alone, factors_of, flat, heads_of, posed
from dhcli.notation.decimals import read_json

if TYPE_CHECKING:
    from numpy.typing import NDArray

T = TypeVar("T")

BLOCK = 2048
"""Poses at a time."""

MATRIX = tuple(head for i in (1, 2, 3) for head in (*(f"r{i}{k}" for k in (1, 2, 3)), f"p_{'xyz'[i - 1]}"))
"""The columns of a pose: three rows of three direction cosines and a length [m]."""

_HINT = (
    f"wanted: {','.join(MATRIX)}, or {','.join(POSITION)}, also with an orientation beside it such as "
    f"{','.join(TURNS['quaternion'])} or {','.join(TURNS['rpy'])}, as fk --in writes them"
)


def pose_blocks(
    path: str, bad: list[Problem] | None = None, *, whole: bool = True
) -> Iterator[tuple[NDArray[np.float64], list[int]]]:
    """Poses of a file, or positions where it has no more.

    Args:
        path: The file; its suffix says what it is, and what comes from standard input, `-`, is CSV or JSON Lines.
        bad: Where rows that are no pose are noted and left out; without it the first of them is an error.
        whole: Whether what stands beside a position must be known, so that no orientation is left out unseen.

    Yields:
        Poses (N, 4, 4) or positions (N, 3), and where each stands: its line from 1, its row in an array from 0.

    Raises:
        FileError: The file cannot be read, or a row is no pose.
    """
    if path.lower().endswith(".npy"):
        yield from _of_array(path)
        return
    with _opened(path) as stream:
        first = stream.readline()
        if not first:
            raise FileError(Problem("is empty", Place(source_of(path)), _HINT))
        if "\0" in first:
            raise FileError(Problem("is written in UTF-16, or no text", Place(source_of(path)), "save it as UTF-8"))
        if first.lstrip().startswith("{"):
            yield from _of_json(chain((first,), stream), source_of(path), bad, whole=whole)
        else:
            yield from _of_csv(first, stream, source_of(path), bad, whole=whole)


@contextmanager
def _opened(path: str) -> Iterator[TextIO]:
    if path == "-":
        yield sys.stdin
        return
    try:
        # what is not UTF-8 is no number either, and is told as a bad cell
        stream = open(path, encoding="utf-8-sig", errors="replace", newline="")  # noqa: SIM115  closed below
    except OSError as error:
        raise FileError(explain(error, path, path)) from None
    with stream:
        yield stream


def _of_array(path: str) -> Iterator[tuple[NDArray[np.float64], list[int]]]:
    try:
        table = np.load(path, mmap_mode="r", allow_pickle=False)
    except (OSError, ValueError) as error:
        raise FileError(Problem(f"is no array of numbers: {error}", Place(path))) from None
    if table.shape[1:] not in {(4, 4), (3,)} or table.dtype.kind not in "fiu":
        raise FileError(
            Problem(f"has the shape {table.shape} of {table.dtype}", Place(path), "wanted: (N, 4, 4) or (N, 3)")
        )
    for first in range(0, len(table), BLOCK):
        block = np.array(table[first : first + BLOCK], dtype=np.float64)
        yield block, list(range(first, first + len(block)))


def _gathered(rows: Iterator[tuple[int, list[float]]]) -> Iterator[tuple[NDArray[np.float64], list[int]]]:
    """Rows in blocks, each of one kind."""
    values, places = list[list[float]](), list[int]()
    for place, row in rows:
        if values and (len(values) == BLOCK or len(row) != len(values[0])):
            yield _as_poses(np.array(values)), places
            values, places = [], []
        values.append(row)
        places.append(place)
    if values:
        yield _as_poses(np.array(values)), places


def _as_poses(table: NDArray[np.float64]) -> NDArray[np.float64]:
    if table.shape[1] == len(POSITION):
        return table
    poses = np.tile(np.eye(4), (len(table), 1, 1))
    poses[:, :3] = table.reshape(-1, 3, 4)
    return poses


def _of_csv(
    first: str, stream: TextIO, path: str, bad: list[Problem] | None, *, whole: bool
) -> Iterator[tuple[NDArray[np.float64], list[int]]]:
    line, sign = 2, next((sign for sign in SIGNS if sign in first), ",")
    if declared := DECLARED.fullmatch(first.strip()):
        line, sign, first = 3, declared["sign"], next(stream, "")
    heads, units = heads_of(next(csv.reader([first], delimiter=sign), []), Place(path, line - 1))
    has_commas = sign in DECIMAL_BETWEEN
    form, wanted = "", MATRIX
    if not all(head in heads for head in MATRIX):
        form = next((form for form, turns in TURNS.items() if all(head in heads for head in turns)), "")
        wanted = (*POSITION, *TURNS.get(form, ()))
    if missing := [head for head in wanted if head not in heads]:
        raise FileError(Problem(f"no column is called {', '.join(missing)}", Place(path, line - 1), _HINT))
    if whole and wanted == POSITION:
        check_alone([head for head in heads if head not in POSITION], Place(path, line - 1))
    columns = [heads.index(head) for head in wanted]
    times, over = factors_of(wanted, [units[k] for k in columns], Place(path, line - 1))

    def by_cells(lines: Iterable[str], begun: int) -> Iterator[tuple[int, list[float]]]:
        for line, cells in enumerate(csv.reader(lines, delimiter=sign), begun):
            if not any(cell.strip() for cell in cells):
                continue
            with _noting(bad):
                row = [cells[k] if k < len(cells) else "" for k in columns]
                read = partial(read_cell, decimals=decimals_in(cells, sign, text), units_in_header=False)
                numbers = np.array(_numbers(row, wanted, Place(path, line), read)) * times / over
                yield line, posed(form, numbers.tolist(), Place(path, line))

    for lines in _lines(stream):
        text = "".join(lines).removesuffix("\n") + "\n"
        plain = text.replace(",", ".") if has_commas and "." not in text else text
        table = plain_table(plain.replace("\r\n", "\n"), sign, len(heads))
        if table is not None and len(table) == len(lines) and not form and np.isfinite(table).all():
            yield _as_poses(table[:, columns] * times / over), list(range(line, line + len(lines)))
        elif '"' in text:  # what is quoted may go on in the next line
            yield from _gathered(by_cells(chain(lines, stream), line))
        else:
            yield from _gathered(by_cells(lines, line))
        line += len(lines)


def _numbers(values: Sequence[T], heads: Sequence[str], place: Place, read: Callable[[T], float]) -> list[float]:
    """The numbers of a row, each by what reads one.

    Raises:
        FileError: One of them is none.
    """
    found = []
    for value, head in zip(values, heads, strict=True):
        try:
            found.append(read(value))
        except CellError as error:
            raise FileError(cell_problem(head, error, place)) from None
    return found


def _lines(stream: Iterable[str]) -> Iterator[list[str]]:
    """Lines in blocks. At a keyboard it is their end that ends them, once: nothing is asked for again."""
    lines = [""] * BLOCK
    while len(lines) == BLOCK:
        lines = list(islice(stream, BLOCK))
        if lines:
            yield lines


def _of_json(
    stream: Iterator[str], path: str, bad: list[Problem] | None, *, whole: bool
) -> Iterator[tuple[NDArray[np.float64], list[int]]]:
    line = 1
    for lines in _lines(stream):
        table = _objects_at_once([each.rstrip("\r\n") for each in lines])
        if table is not None:
            yield _as_poses(table), list(range(line, line + len(lines)))
        else:
            yield from _gathered(_line_by_line(lines, line, path, bad, whole=whole))
        line += len(lines)


def _objects_at_once(lines: list[str]) -> NDArray[np.float64] | None:
    """The poses of some lines, a row of numbers each; None if there is anything to say about one of them.

    Parsed as one list, lines could pass for other objects than they are. So each begins and ends as an object does and
    has no bracket of another one in it, and nothing in them is text.
    """
    text = ",".join(lines)
    if not (
        all(line.startswith("{") and line.endswith("}") for line in lines)
        and text.count("{") == text.count("}") == len(lines)
        and "true" not in text
        and "false" not in text
    ):
        return None
    try:
        rows = read_json(f"[{text}]")
        key = "matrix" if "matrix" in rows[0] else "position"
        table = np.array([row[key] for row in rows], dtype=np.float64)
    except (ValueError, TypeError, KeyError, OverflowError, RecursionError):
        return None
    if (
        len(rows) != len(lines)
        or text.count('"') != 2 * sum(map(len, rows))
        or not np.isfinite(table).all()
        or (key == "position" and any(len(row) > 1 for row in rows))
    ):
        return None
    if key == "matrix":
        return table[:, :3].reshape(-1, len(MATRIX)) if table.shape[1:] in {(3, 4), (4, 4)} else None
    return table if table.shape[1:] == (len(POSITION),) else None


def _line_by_line(
    lines: Iterable[str], begun: int, path: str, bad: list[Problem] | None, *, whole: bool
) -> Iterator[tuple[int, list[float]]]:
    for line, text in enumerate(lines, begun):
        if text.strip():
            with _noting(bad):
                yield line, _pose_of(text, Place(path, line), whole=whole)


@contextmanager
def _noting(bad: list[Problem] | None) -> Iterator[None]:
    """Note what is wrong with a row, where rows may be left out."""
    try:
        yield
    except FileError as error:
        if bad is None:
            raise
        bad += error.problems


def _pose_of(text: str, place: Place, *, whole: bool) -> list[float]:
    try:
        content = json.loads(text)
        if "matrix" in content:
            return _numbers([entry for row in content["matrix"][:3] for entry in row], MATRIX, place, json_number)
        form = next((key for key in content if key in TURNS), "")
        if whole and not form:
            check_alone([key for key in content if key != "position"], place)
        cells = [*content["position"], *(flat(content[form]) if form else ())]
        return posed(form, _numbers(cells, (*POSITION, *TURNS.get(form, ())), place, json_number), place)
    except (ValueError, KeyError, TypeError, IndexError, RecursionError):
        hint = '{"matrix": [[...], ...]} or {"position": [x, y, z]}, also with "quaternion": {"w": ...} and the like'
        raise FileError(Problem("is no pose", place, f"wanted: {hint}")) from None
