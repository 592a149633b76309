"""Poses a row each, as `fk --in` writes them: CSV, JSON Lines or .npy, block by block."""

from __future__ import annotations

import csv
import json
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from itertools import chain
from typing import TYPE_CHECKING, TextIO

import numpy as np

from dhcli.errors import FileError, Place, Problem
from dhcli.files.reading import explain

if TYPE_CHECKING:
    from numpy.typing import NDArray

BLOCK = 2048
"""Poses at a time."""

MATRIX = tuple(head for i in (1, 2, 3) for head in (*(f"r{i}{k}" for k in (1, 2, 3)), f"p_{'xyz'[i - 1]}"))
"""The columns of a pose: three rows of three direction cosines and a length [m]."""

POSITION = ("p_x", "p_y", "p_z")


def pose_blocks(path: str, bad: list[Problem] | None = None) -> Iterator[tuple[NDArray[np.float64], list[int]]]:
    """Poses of a file, or positions where it has no more.

    Args:
        path: The file; its suffix says what it is, and what comes from standard input, `-`, is CSV or JSON Lines.
        bad: Where rows that are no pose are noted and left out; without it the first of them is an error.

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
        if first.lstrip().startswith("{"):
            yield from _gathered(_of_json(first, stream, path, bad))
        else:
            yield from _gathered(_of_csv(first, stream, path, bad))


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
    """Rows in blocks."""
    values, places = list[list[float]](), list[int]()
    for place, row in rows:
        values.append(row)
        places.append(place)
        if len(values) == BLOCK:
            yield _as_poses(values), places
            values, places = [], []
    if values:
        yield _as_poses(values), places


def _as_poses(values: list[list[float]]) -> NDArray[np.float64]:
    table = np.array(values, dtype=np.float64)
    if table.shape[1] == len(POSITION):
        return table
    poses = np.tile(np.eye(4), (len(table), 1, 1))
    poses[:, :3] = table.reshape(-1, 3, 4)
    return poses


def _of_csv(first: str, stream: TextIO, path: str, bad: list[Problem] | None) -> Iterator[tuple[int, list[float]]]:
    heads = [head.strip() for head in next(csv.reader([first]), [])]
    wanted = MATRIX if all(head in heads for head in MATRIX) else POSITION
    if missing := [head for head in wanted if head not in heads]:
        hint = f"wanted: {','.join(MATRIX)}, or {','.join(POSITION)}, as fk --in writes them"
        raise FileError(Problem(f"no column is called {', '.join(missing)}", Place(path, 1), hint))
    columns = [heads.index(head) for head in wanted]
    for line, cells in enumerate(csv.reader(stream), 2):
        if not cells:
            continue
        with _noting(bad):
            yield line, _numbers([cells[k] if k < len(cells) else "" for k in columns], wanted, Place(path, line))


def _numbers(cells: Sequence[object], heads: Sequence[str], place: Place) -> list[float]:
    found = []
    for cell, head in zip(cells, heads, strict=True):
        try:
            found.append(float(cell))  # type: ignore[arg-type]
        except (TypeError, ValueError):
            raise FileError(Problem(f"{head} is {cell!r:.40}, which is no number", place)) from None
    return found


def _of_json(first: str, stream: TextIO, path: str, bad: list[Problem] | None) -> Iterator[tuple[int, list[float]]]:
    for line, text in enumerate(chain((first,), stream), 1):
        if text.strip():
            with _noting(bad):
                yield line, _pose_of(text, Place(path, line))


@contextmanager
def _noting(bad: list[Problem] | None) -> Iterator[None]:
    """Note what is wrong with a row, where rows may be left out."""
    try:
        yield
    except FileError as error:
        if bad is None:
            raise
        bad += error.problems


def _pose_of(text: str, place: Place) -> list[float]:
    try:
        content = json.loads(text)
        if "matrix" in content:
            return _numbers([entry for row in content["matrix"][:3] for entry in row], MATRIX, place)
        return _numbers(content["position"], POSITION, place)
    except (ValueError, KeyError, TypeError, IndexError):
        hint = '{"matrix": [[...], ...]} or {"position": [x, y, z]}'
        raise FileError(Problem("is no pose", place, f"wanted: {hint}")) from None
