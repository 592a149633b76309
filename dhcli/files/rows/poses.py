"""Poses a row each, as `fk --rows` writes them: CSV, JSON Lines or .npy, block by block."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import numpy as np

from dhcli.errors import FileError, Place, Problem
from dhcli.files.rows import MATRIX, POSITION, TURNS
from dhcli.files.rows.blocks import Block, Sieve, cell_problem
from dhcli.files.rows.cells import CellError, json_number
from dhcli.files.rows.csvrows import CsvRows
from dhcli.files.rows.formats import Rows, format_of
from dhcli.files.rows.jsonrows import parsed_at_once
from dhcli.files.rows.npyrows import NpyArray, place_in_array
from dhcli.files.rows.posecolumns import PoseTable, check_alone, directions, posed
from dhcli.files.rows.source import Source, parted, text_blocks

if TYPE_CHECKING:
    from numpy.typing import NDArray

BLOCK = 2048
"""Poses at a time."""


def pose_rows(source: Source, *, whole: bool = True) -> Rows:
    """Poses of a file, or positions where it has no more; each block is of one kind.

    Args:
        source: Where they stand.
        whole: Whether what stands beside a position must be known, so that no orientation is left out unseen.

    Raises:
        FileError: It is called .npy and is something else.
    """
    match format_of(source):
        case "npy":
            return PoseArray(source)
        case "csv":
            return CsvRows(source, PoseTable(whole), BLOCK)
        case _:
            return PoseLines(source, whole=whole)


class PoseArray:
    """Reads the poses of an array, shape (N, 4, 4), or positions, shape (N, 3)."""

    def __init__(self, source: Source) -> None:
        """Read an array."""
        self._source = source

    def place_of(self, row: int) -> Place:
        """Where a row stands, as numpy counts: from 0."""
        return place_in_array(self._source, row)

    def blocks(self) -> Iterator[Block]:
        """The poses.

        Raises:
            FileError: It is no array of numbers of either shape, or it is cut off.
        """
        array = NpyArray(self._source)
        array.check(is_wanted=array.shape[1:] in {(4, 4), (3,)}, wanted="(N, 4, 4) or (N, 3) is wanted")
        for first, rows in array.pieces(BLOCK):
            yield Block(rows, range(first, first + len(rows)))


class PoseLines:
    """Reads the poses of a JSON Lines file, `{"matrix": [[...], ...]}` or `{"position": [x, y, z], "rpy": {...}}`."""

    def __init__(self, source: Source, *, whole: bool) -> None:
        """Read poses; `whole` as for `pose_rows`."""
        self._source = source
        self._whole = whole

    def place_of(self, row: int) -> Place:
        """Where a row stands."""
        return Place(self._source.name, row)

    def blocks(self) -> Iterator[Block]:
        """The poses.

        Raises:
            FileError: The source cannot be read.
        """
        for first, text in text_blocks(self._source):
            for start, part in parted(first, text, BLOCK):
                yield from self._block(start, part.split("\n")[:-1])

    def _block(self, first: int, lines: list[str]) -> Iterator[Block]:
        table = _objects_at_once(lines)
        if table is not None:
            yield Block(posed("", table), range(first, first + len(lines)))
            return
        sieve, kind = Sieve(), ""
        for line, text in enumerate(lines, first):
            if not text.strip():
                continue
            try:
                form, numbers = _pose_of(text, self.place_of(line), whole=self._whole)
            except FileError as error:
                sieve.refuse(error.problems)
                continue
            if sieve.values and (form, len(numbers)) != (kind, len(sieve.values[0])):
                yield _gathered(kind, sieve)
                sieve = Sieve()
            kind = form
            sieve.good(line, numbers)
        if sieve.values or sieve.bad_rows:
            yield _gathered(kind, sieve)


def _gathered(form: str, sieve: Sieve) -> Block:
    """A block of rows of one kind."""
    numbers = np.array(sieve.values, dtype=np.float64).reshape(len(sieve.rows), -1) if sieve.rows else np.empty((0, 3))
    return Block(posed(form, numbers), sieve.rows, (), tuple(sieve.bad), sieve.bad_rows)


def _objects_at_once(lines: list[str]) -> NDArray[np.float64] | None:
    """The poses of some lines, a row of numbers each; None if there is anything to say about one of them."""
    rows = parsed_at_once(lines, "{")
    if rows is None:
        return None
    try:
        key = "matrix" if "matrix" in rows[0] else "position"
        table = np.array([row[key] for row in rows], dtype=np.float64)
    except (ValueError, TypeError, KeyError, OverflowError):
        return None
    if not np.isfinite(table).all() or (key == "position" and any(len(row) > 1 for row in rows)):
        return None
    if key == "matrix":
        return table[:, :3].reshape(-1, len(MATRIX)) if table.shape[1:] in {(3, 4), (4, 4)} else None
    return table if table.shape[1:] == (len(POSITION),) else None


def _pose_of(text: str, place: Place, *, whole: bool) -> tuple[str, list[float]]:
    """The numbers of a pose, and how its orientation is said beside the position.

    Raises:
        FileError: It is none.
    """
    try:
        content = json.loads(text)
        if "matrix" in content:
            return "", _numbers([entry for row in content["matrix"][:3] for entry in row], MATRIX, place)
        form = next((key for key in content if key in TURNS), "")
        if whole and not form:
            check_alone([key for key in content if key != "position"], place)
        cells = [*content["position"], *(flat(content[form]) if form else ())]
        numbers = _numbers(cells, (*POSITION, *TURNS.get(form, ())), place)
    except (ValueError, KeyError, TypeError, IndexError, RecursionError):
        hint = '{"matrix": [[...], ...]} or {"position": [x, y, z]}, also with "quaternion": {"w": ...} and the like'
        raise FileError(Problem("is no pose", place, f"wanted: {hint}")) from None
    parts = directions(form, np.array([numbers[3:]]))
    if parts.size and not parts.any():
        raise FileError(Problem(f"{', '.join(TURNS[form])} are all 0: that is no {form}", place))
    return form, numbers


def _numbers(values: Sequence[object], heads: Sequence[str], place: Place) -> list[float]:
    """The numbers of a row.

    Raises:
        FileError: One of them is none.
    """
    found = []
    for value, head in zip(values, heads, strict=True):
        try:
            found.append(json_number(value))
        except CellError as error:
            raise FileError(cell_problem(head, error, place)) from None
    return found


def flat(value: object) -> list[object]:
    """The numbers of an orientation, nested as JSON has them: `{"axis": [x, y, z], "angle": t}` is four."""
    if isinstance(value, dict):
        value = [value[key] for key in ("w", "x", "y", "z", "roll", "pitch", "yaw", "axis", "angle") if key in value]
    return [one for part in value for one in flat(part)] if isinstance(value, list) else [value]
