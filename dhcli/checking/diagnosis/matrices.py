"""Mistakes in what is written down of a finished matrix."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import combinations
from typing import TypeVar

from dhcli.checking.diagnosis.work import Matrix, Rewriting, Setting, Work, inverse
from dhcli.notation.factors import AXES
from dhcli.notation.tree import ZERO, negate

N = TypeVar("N")

_WITH_POSITION = ("pose", "position", "point", "entry")


def transposed(work: Work, _setting: Setting) -> Iterator[tuple[str, Work]]:
    """Rows and columns of the rotation have changed places."""
    if work.question.piece not in ("position", "point", "vector"):
        yield "", _rewritten(work, _transposed)


def turned_back(work: Work, _setting: Setting) -> Iterator[tuple[str, Work]]:
    """A point or a vector turned the other way, which is by the transposed rotation."""
    if work.question.piece in ("point", "vector"):
        yield "", _rewritten(work, _transposed)


def inverted(work: Work, _setting: Setting) -> Iterator[tuple[str, Work]]:
    """The inverse where the matrix was asked; without its position that is the transpose."""
    if not work.inverted and work.question.piece in _WITH_POSITION:
        yield "", _rewritten(work, inverse)


def not_inverted(work: Work, _setting: Setting) -> Iterator[tuple[str, Work]]:
    """The matrix where its inverse was asked."""
    if work.inverted:
        yield "", _rewritten(work, inverse)


def position_negated(work: Work, _setting: Setting) -> Iterator[tuple[str, Work]]:
    """-p where -R^T p is right."""
    if work.inverted and work.question.piece in _WITH_POSITION:
        yield "", _rewritten(work, _with_position_negated)


def point_as_vector(work: Work, _setting: Setting) -> Iterator[tuple[str, Work]]:
    """R p for R p + d."""
    if work.question.piece == "point":
        yield "", replace(work, question=replace(work.question, piece="vector"))


def vector_as_point(work: Work, _setting: Setting) -> Iterator[tuple[str, Work]]:
    """R p + d for R p."""
    if work.question.piece == "vector":
        yield "", replace(work, question=replace(work.question, piece="point"))


def point_not_rotated(work: Work, _setting: Setting) -> Iterator[tuple[str, Work]]:
    """P + d for R p + d."""
    if work.question.piece in ("point", "vector"):
        yield "", _rewritten(work, _without_rotation)


def point_forgotten(work: Work, _setting: Setting) -> Iterator[tuple[str, Work]]:
    """The origin of the frame for a point in it."""
    if work.question.piece == "point" and any(coordinate != ZERO for coordinate in work.question.point):
        yield "", replace(work, question=replace(work.question, point=(ZERO, ZERO, ZERO)))


def other_axis(work: Work, _setting: Setting) -> Iterator[tuple[str, Work]]:
    """Another axis of the same frame."""
    if work.question.piece == "axis":
        for k, axis in enumerate(AXES):
            if k != work.question.index[0]:
                yield axis, replace(work, question=replace(work.question, index=(k, 0)))


def columns_swapped(work: Work, _setting: Setting) -> Iterator[tuple[str, Work]]:
    """Two axes of the frame have changed places."""
    if work.question.piece in ("pose", "rotation", "axis"):
        for first, second in combinations(range(3), 2):
            yield f"{first + 1} and {second + 1}", _rewritten(work, _Swapped(first, second, rows=False))


def rows_swapped(work: Work, _setting: Setting) -> Iterator[tuple[str, Work]]:
    """Two coordinates have changed places."""
    if work.question.piece != "entry":
        for first, second in combinations(range(3), 2):
            yield f"{first + 1} and {second + 1}", _rewritten(work, _Swapped(first, second, rows=True))


def entry_sign(work: Work, _setting: Setting) -> Iterator[tuple[str, Work]]:
    """One entry has the wrong sign."""
    question = work.question
    rows, columns = question.shape
    if question.piece in ("pose", "rotation", "position", "entry"):
        for r in range(min(rows, 3)):
            for c in range(columns):
                row, column = question.index if question.piece == "entry" else (r, 3 if columns == 1 else c)
                where = f"{r + 1},{c + 1}"
                yield where, _rewritten(work, _Negated(row, column))


def given_sign(work: Work, _setting: Setting) -> Iterator[tuple[str, Work]]:
    """One coordinate of the point or vector in the task with the other sign."""
    for k, coordinate in enumerate(work.question.point):
        if coordinate != ZERO:
            point = (*work.question.point[:k], negate(coordinate), *work.question.point[k + 1 :])
            yield AXES[k], replace(work, question=replace(work.question, point=point))


def coordinate_sign(work: Work, _setting: Setting) -> Iterator[tuple[str, Work]]:
    """One coordinate of the answer with the other sign."""
    if work.question.piece in ("point", "vector", "axis"):
        for k, axis in enumerate(AXES):
            yield axis, _rewritten(work, _Negative((k,)))


def direction(work: Work, _setting: Setting) -> Iterator[tuple[str, Work]]:
    """All coordinates of the answer with the other sign."""
    if work.question.shape == (3, 1):
        yield "", _rewritten(work, _Negative((0, 1, 2)))


def position_as_row(work: Work, _setting: Setting) -> Iterator[tuple[str, Work]]:
    """The last column written as the last row."""
    if work.question.piece == "pose":
        yield "", _rewritten(work, _with_position_below)


class _Swapped:
    """Two rows, or two columns of the rotation, in each other's place."""

    def __init__(self, first: int, second: int, *, rows: bool) -> None:
        self._order = [0, 1, 2, 3]
        self._order[first], self._order[second] = second, first
        self._rows = rows

    def __call__(self, matrix: Matrix[N]) -> Matrix[N]:
        if self._rows:
            return tuple(matrix[k] for k in self._order)
        return tuple(tuple(row[k] for k in self._order) for row in matrix)


class _Negated:
    """One entry with the other sign."""

    def __init__(self, row: int, column: int) -> None:
        self._row, self._column = row, column

    def __call__(self, matrix: Matrix[N]) -> Matrix[N]:
        row = list(matrix[self._row])
        row[self._column] = -row[self._column]  # type: ignore[operator]
        return (*matrix[: self._row], tuple(row), *matrix[self._row + 1 :])


class _Negative:
    """Some rows with the other sign, so that whatever is computed from them has it."""

    def __init__(self, rows: tuple[int, ...]) -> None:
        self._rows = rows

    def __call__(self, matrix: Matrix[N]) -> Matrix[N]:
        return tuple(
            tuple(-entry for entry in row) if r in self._rows else row  # type: ignore[operator]
            for r, row in enumerate(matrix)
        )


def _rewritten(work: Work, rewriting: Rewriting[float]) -> Work:
    return replace(work, rewritten=(*work.rewritten, rewriting))


def _transposed(matrix: Matrix[N]) -> Matrix[N]:
    rows = ((*(matrix[c][r] for c in range(3)), matrix[r][3]) for r in range(3))
    return (*rows, matrix[3])


def _with_position_negated(matrix: Matrix[N]) -> Matrix[N]:
    """For an inverse, the position of the matrix itself with the other sign."""
    right = inverse(matrix)
    rows = ((*matrix[k][:3], -right[k][3]) for k in range(3))  # type: ignore[operator]
    return (*rows, matrix[3])


def _without_rotation(matrix: Matrix[N]) -> Matrix[N]:
    zero, one = matrix[3][0], matrix[3][3]
    return (*((*(one if r == c else zero for c in range(3)), matrix[r][3]) for r in range(3)), matrix[3])


def _with_position_below(matrix: Matrix[N]) -> Matrix[N]:
    zero, one = matrix[3][0], matrix[3][3]
    return (*((*matrix[r][:3], zero) for r in range(3)), (*(matrix[r][3] for r in range(3)), one))
