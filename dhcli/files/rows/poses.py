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
from dhcli.files.reading import explain, source_of
from dhcli.files.rows.turns import TURNS, flat, posed

if TYPE_CHECKING:
    from numpy.typing import NDArray

BLOCK = 2048
"""Poses at a time."""

MATRIX = tuple(head for i in (1, 2, 3) for head in (*(f"r{i}{k}" for k in (1, 2, 3)), f"p_{'xyz'[i - 1]}"))
"""The columns of a pose: three rows of three direction cosines and a length [m]."""

POSITION = ("p_x", "p_y", "p_z")

INDEX = "row"
"""A column of numbers of rows, which is no part of a pose."""


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
        rows = _of_json if first.lstrip().startswith("{") else _of_csv
        yield from _gathered(rows(first, stream, path, bad, whole=whole), source_of(path))


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


def _gathered(rows: Iterator[tuple[int, list[float]]], name: str) -> Iterator[tuple[NDArray[np.float64], list[int]]]:
    """Rows in blocks."""
    values, places = list[list[float]](), list[int]()
    width = 0
    for place, row in rows:
        width = width or len(row)
        if len(row) != width:
            words = (
                "a position" if len(row) < width else "a whole pose",
                "whole poses" if len(row) < width else "positions",
            )
            raise FileError(
                Problem(f"is {words[0]}, and the rows before it are {words[1]}", Place(name, place), "sort them")
            )
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


_HINT = (
    f"wanted: {','.join(MATRIX)}, or {','.join(POSITION)}, also with an orientation beside it such as "
    f"{','.join(TURNS['quaternion'])} or {','.join(TURNS['rpy'])}, as fk --in writes them"
)


def _of_csv(
    first: str, stream: TextIO, path: str, bad: list[Problem] | None, *, whole: bool
) -> Iterator[tuple[int, list[float]]]:
    heads = [head.strip() for head in next(csv.reader([first]), [])]
    form, wanted = "", MATRIX
    if not all(head in heads for head in MATRIX):
        form = next((form for form, turns in TURNS.items() if all(head in heads for head in turns)), "")
        wanted = (*POSITION, *TURNS.get(form, ()))
    place = Place(source_of(path), 1)
    if missing := [head for head in wanted if head not in heads]:
        raise FileError(Problem(f"no column is called {', '.join(missing)}", place, _HINT))
    if whole and wanted == POSITION:
        _check_alone([head for head in heads if head not in POSITION], place)
    columns = [heads.index(head) for head in wanted]
    for line, cells in enumerate(csv.reader(stream), 2):
        if not cells:
            continue
        with _noting(bad):
            place = Place(source_of(path), line)
            yield (
                line,
                posed(form, _numbers([cells[k] if k < len(cells) else "" for k in columns], wanted, place), place),
            )


def _check_alone(others: Sequence[str], place: Place) -> None:
    """Make sure that nothing beside a position says more of the pose.

    Raises:
        FileError: Something does, and it is not known what.
    """
    if unknown := [head for head in others if head not in (INDEX, "")]:
        known = f"an orientation is {','.join(TURNS['quaternion'])} or {','.join(TURNS['rpy'])} in radians"
        message = f"{', '.join(unknown)} beside a position: that says no orientation that is known"
        raise FileError(Problem(message, place, f"{known}; --task position leaves what else stands there aside"))


def _numbers(cells: Sequence[object], heads: Sequence[str], place: Place) -> list[float]:
    found = []
    for cell, head in zip(cells, heads, strict=True):
        try:
            found.append(float(cell))  # type: ignore[arg-type]
        except (TypeError, ValueError):
            raise FileError(Problem(f"{head} is {cell!r:.40}, which is no number", place)) from None
    return found


def _of_json(
    first: str, stream: TextIO, path: str, bad: list[Problem] | None, *, whole: bool
) -> Iterator[tuple[int, list[float]]]:
    for line, text in enumerate(chain((first,), stream), 1):
        if text.strip():
            with _noting(bad):
                yield line, _pose_of(text, Place(source_of(path), line), whole=whole)


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
            return _numbers([entry for row in content["matrix"][:3] for entry in row], MATRIX, place)
        form = next((key for key in content if key in TURNS), "")
        if whole and not form:
            _check_alone([key for key in content if key != "position"], place)
        cells = [*content["position"], *(flat(content[form]) if form else ())]
        return posed(form, _numbers(cells, (*POSITION, *TURNS.get(form, ())), place), place)
    except (ValueError, KeyError, TypeError, IndexError):
        hint = '{"matrix": [[...], ...]} or {"position": [x, y, z]}, also with "quaternion": {"w": ...} and the like'
        raise FileError(Problem("is no pose", place, f"wanted: {hint}")) from None
