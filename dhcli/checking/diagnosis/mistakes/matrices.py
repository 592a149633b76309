"""Mistakes in what is written down of a finished matrix."""

from __future__ import annotations

from dataclasses import replace
from itertools import combinations

from dhcli.checking.diagnosis.bench import inverse
from dhcli.checking.diagnosis.mistakes.rewritings import (
    Negated,
    Negative,
    Swapped,
    with_position_below,
    with_position_negated,
    with_transpose,
    without_rotation,
)
from dhcli.checking.diagnosis.record import Catalogue
from dhcli.checking.diagnosis.result import Rank
from dhcli.checking.diagnosis.work import Level, Made, Maker, Rewriting, Setting, Work
from dhcli.checking.verdicts import INVERSE, TRANSPOSED
from dhcli.notation.factors import AXES
from dhcli.notation.tree import ZERO, negate

_WITH_POSITION = ("pose", "position", "point", "entry")

IN_THE_WHOLE: Catalogue[Maker] = Catalogue(Level.MATRIX)
"""Of the whole matrix: these have the name before a slip in a row that happens to give the same."""

IN_WRITING: Catalogue[Maker] = Catalogue(Level.MATRIX)
"""Of an entry, a row or a column."""


@IN_THE_WHOLE(
    "transposed",
    TRANSPOSED,
    "which frame do the columns of the rotation belong to?",
    rank=Rank.WHOLE,
)
def transposed(work: Work, _setting: Setting) -> Made:
    """Rows and columns of the rotation have changed places."""
    if work.question.piece not in ("position", "point", "vector"):
        yield "", _rewritten(work, with_transpose)


@IN_THE_WHOLE("turned-back", "it is turned the other way", "which way is a positive turn?", rank=Rank.WHOLE)
def turned_back(work: Work, _setting: Setting) -> Made:
    """A point or a vector turned the other way, which is by the transposed rotation."""
    if work.question.piece in ("point", "vector"):
        yield "", _rewritten(work, with_transpose)


@IN_THE_WHOLE(
    "inverse",
    INVERSE,
    "which of the two frames is seen from which?",
    rank=Rank.WHOLE,
)
def inverted(work: Work, _setting: Setting) -> Made:
    """The inverse where the matrix was asked; without its position that is the transpose."""
    if not work.inverted and work.question.piece in _WITH_POSITION:
        yield "", _rewritten(work, inverse)


@IN_THE_WHOLE("not-inverted", "this is the matrix itself, not its inverse", "the inverse was asked", rank=Rank.WHOLE)
def not_inverted(work: Work, _setting: Setting) -> Made:
    """The matrix where its inverse was asked."""
    if work.inverted:
        yield "", _rewritten(work, inverse)


@IN_THE_WHOLE(
    "inverse-position",
    "the position is only negated; in the inverse it is -R^T p",
    "look at the position of the inverse",
)
def position_negated(work: Work, _setting: Setting) -> Made:
    """-p where -R^T p is right."""
    if work.inverted and work.question.piece in _WITH_POSITION:
        yield "", _rewritten(work, with_position_negated)


@IN_WRITING("other-axis", "this is the {where} axis", "which axis of the frame was asked?", rank=Rank.WHOLE)
def other_axis(work: Work, _setting: Setting) -> Made:
    """Another axis of the same frame."""
    if work.question.piece == "axis":
        for k, axis in enumerate(AXES):
            if k != work.question.index[0]:
                yield axis, replace(work, question=replace(work.question, index=(k, 0)))


@IN_WRITING(
    "point-forgotten",
    "this is the position of the frame; the point in it is not taken into account",
    "where in the frame does the point lie?",
    rank=Rank.WHOLE,
)
def point_forgotten(work: Work, _setting: Setting) -> Made:
    """The origin of the frame for a point in it."""
    if work.question.piece == "point" and any(coordinate != ZERO for coordinate in work.question.point):
        yield "", replace(work, question=replace(work.question, point=(ZERO, ZERO, ZERO)))


@IN_WRITING(
    "point-as-vector",
    "the point is only turned: the position of the frame is not added",
    "a point has a fourth coordinate 1",
)
def point_as_vector(work: Work, _setting: Setting) -> Made:
    """R p for R p + d."""
    if work.question.piece == "point":
        yield "", replace(work, question=replace(work.question, piece="vector"))


@IN_WRITING(
    "vector-as-point",
    "the position of the frame is added, which a vector does not feel",
    "a vector has a fourth coordinate 0",
)
def vector_as_point(work: Work, _setting: Setting) -> Made:
    """R p + d for R p."""
    if work.question.piece == "vector":
        yield "", replace(work, question=replace(work.question, piece="point"))


@IN_WRITING(
    "point-not-rotated",
    "the coordinates are added to the position without being turned",
    "in which frame are the coordinates given?",
)
def point_not_rotated(work: Work, _setting: Setting) -> Made:
    """P + d for R p + d."""
    if work.question.piece in ("point", "vector"):
        yield "", _rewritten(work, without_rotation)


@IN_WRITING(
    "columns-swapped", "columns {where} have changed places", "which column belongs to which axis?", rank=Rank.SYMPTOM
)
def columns_swapped(work: Work, _setting: Setting) -> Made:
    """Two axes of the frame have changed places."""
    if work.question.piece in ("pose", "rotation", "axis"):
        for first, second in combinations(range(3), 2):
            yield f"{first + 1} and {second + 1}", _rewritten(work, Swapped(first, second, rows=False))


@IN_WRITING(
    "rows-swapped", "rows {where} have changed places", "which row belongs to which coordinate?", rank=Rank.SYMPTOM
)
def rows_swapped(work: Work, _setting: Setting) -> Made:
    """Two coordinates have changed places."""
    if work.question.piece != "entry":
        for first, second in combinations(range(3), 2):
            yield f"{first + 1} and {second + 1}", _rewritten(work, Swapped(first, second, rows=True))


@IN_WRITING(
    "entry-sign", "the sign of entry ({where}) is turned round", "look at the signs in row {row}", rank=Rank.SYMPTOM
)
def entry_sign(work: Work, _setting: Setting) -> Made:
    """One entry has the wrong sign."""
    question = work.question
    rows, columns = question.shape
    if question.piece in ("pose", "rotation", "position", "entry"):
        for r in range(min(rows, 3)):
            for c in range(columns):
                row, column = question.index if question.piece == "entry" else (r, 3 if columns == 1 else c)
                where = f"{r + 1},{c + 1}"
                yield where, _rewritten(work, Negated(row, column))


@IN_WRITING(
    "row-sign",
    "all signs in row {where} are turned round",
    "look at the signs in row {where}",
    rank=Rank.SYMPTOM,
    alone=True,
)
def row_sign(work: Work, _setting: Setting) -> Made:
    """One coordinate of all axes, and of the position, with the other sign."""
    if work.question.piece in ("pose", "rotation"):
        for k in range(3):
            yield f"{k + 1}", _rewritten(work, Negative((k,)))


@IN_WRITING(
    "column-sign",
    "all signs in column {where} are turned round",
    "look at the signs in column {where}",
    rank=Rank.SYMPTOM,
    alone=True,
)
def column_sign(work: Work, _setting: Setting) -> Made:
    """One axis, or the position, with the other sign."""
    if work.question.piece in ("pose", "rotation"):
        for k in range(work.question.shape[1]):
            yield f"{k + 1}", _rewritten(work, Negative(column=k))


@IN_WRITING(
    "given-sign",
    "the sign of the {where} coordinate that was given is turned round",
    "look at the signs of the coordinates that were given",
)
def given_sign(work: Work, _setting: Setting) -> Made:
    """One coordinate of the point or vector in the task with the other sign."""
    for k, coordinate in enumerate(work.question.point):
        if coordinate != ZERO:
            point = (*work.question.point[:k], negate(coordinate), *work.question.point[k + 1 :])
            yield AXES[k], replace(work, question=replace(work.question, point=point))


@IN_WRITING(
    "coordinate-sign",
    "the sign of the {where} coordinate is turned round",
    "look at the signs of the coordinates",
    rank=Rank.SYMPTOM,
)
def coordinate_sign(work: Work, _setting: Setting) -> Made:
    """One coordinate of the answer with the other sign."""
    if work.question.piece in ("point", "vector", "axis"):
        for k, axis in enumerate(AXES):
            yield axis, _rewritten(work, Negative((k,)))


@IN_WRITING(
    "direction", "every coordinate has the other sign: it points the other way", "from where to where does it point?"
)
def direction(work: Work, _setting: Setting) -> Made:
    """All coordinates of the answer with the other sign."""
    if work.question.shape == (3, 1):
        yield "", _rewritten(work, Negative((0, 1, 2)))


@IN_WRITING(
    "position-as-row",
    "the position stands in the bottom row; it belongs in the last column",
    "where does the position stand in a homogeneous matrix?",
    rank=Rank.WHOLE,
)
def position_as_row(work: Work, _setting: Setting) -> Made:
    """The last column written as the last row."""
    if work.question.piece == "pose":
        yield "", _rewritten(work, with_position_below)


def _rewritten(work: Work, rewriting: Rewriting[float]) -> Work:
    return replace(work, rewritten=(*work.rewritten, rewriting))
