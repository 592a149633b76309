"""Mistakes in what is written down of a finished matrix."""

from __future__ import annotations

from dhcli.checking.diagnosis import matrices, terms
from dhcli.checking.diagnosis.mistakes.record import Level, Mistake
from dhcli.checking.diagnosis.result import Rank

M = Level.MATRIX

IN_THE_WHOLE = (
    Mistake(
        "transposed",
        M,
        "the rotation is transposed: its columns, not its rows, are the axes of the frame described",
        "which frame do the columns of the rotation belong to?",
        matrices.transposed,
        Rank.WHOLE,
    ),
    Mistake(
        "turned-back",
        M,
        "it is turned the other way",
        "which way is a positive turn?",
        matrices.turned_back,
        Rank.WHOLE,
    ),
    Mistake(
        "inverse",
        M,
        "this is the inverse: it shows the reference from the frame",
        "which of the two frames is seen from which?",
        matrices.inverted,
        Rank.WHOLE,
    ),
    Mistake(
        "not-inverted",
        M,
        "this is the matrix itself, not its inverse",
        "the inverse was asked",
        matrices.not_inverted,
        Rank.WHOLE,
    ),
    Mistake(
        "inverse-position",
        M,
        "the position is only negated; in the inverse it is -R^T p",
        "look at the position of the inverse",
        matrices.position_negated,
    ),
)
"""Of the whole matrix: these have the name before a slip in a row that happens to give the same."""

IN_WRITING = (
    Mistake(
        "other-axis",
        M,
        "this is the {where} axis",
        "which axis of the frame was asked?",
        matrices.other_axis,
        Rank.WHOLE,
    ),
    Mistake(
        "point-forgotten",
        M,
        "this is the position of the frame; the point in it is not taken into account",
        "where in the frame does the point lie?",
        matrices.point_forgotten,
        Rank.WHOLE,
    ),
    Mistake(
        "point-as-vector",
        M,
        "the point is only turned: the position of the frame is not added",
        "a point has a fourth coordinate 1",
        matrices.point_as_vector,
    ),
    Mistake(
        "vector-as-point",
        M,
        "the position of the frame is added, which a vector does not feel",
        "a vector has a fourth coordinate 0",
        matrices.vector_as_point,
    ),
    Mistake(
        "point-not-rotated",
        M,
        "the coordinates are added to the position without being turned",
        "in which frame are the coordinates given?",
        matrices.point_not_rotated,
    ),
    Mistake(
        "columns-swapped",
        M,
        "columns {where} have changed places",
        "which column belongs to which axis?",
        matrices.columns_swapped,
        Rank.SYMPTOM,
    ),
    Mistake(
        "rows-swapped",
        M,
        "rows {where} have changed places",
        "which row belongs to which coordinate?",
        matrices.rows_swapped,
        Rank.SYMPTOM,
    ),
    Mistake(
        "entry-sign",
        M,
        "the sign of entry ({where}) is turned round",
        "look at the signs in row {row}",
        matrices.entry_sign,
        Rank.SYMPTOM,
    ),
    Mistake(
        "given-sign",
        M,
        "the sign of the {where} coordinate that was given is turned round",
        "look at the signs of the coordinates that were given",
        matrices.given_sign,
    ),
    Mistake(
        "coordinate-sign",
        M,
        "the sign of the {where} coordinate is turned round",
        "look at the signs of the coordinates",
        matrices.coordinate_sign,
        Rank.SYMPTOM,
    ),
    Mistake(
        "direction",
        M,
        "every coordinate has the other sign: it points the other way",
        "from where to where does it point?",
        matrices.direction,
    ),
    Mistake(
        "term-sign",
        M,
        "the sign of {term} in entry ({entry}) is turned round",
        "look at the signs of the terms in row {row}",
        terms.term_sign,
        Rank.SYMPTOM,
        alone=True,
    ),
    Mistake(
        "position-as-row",
        M,
        "the position stands in the bottom row; it belongs in the last column",
        "where does the position stand in a homogeneous matrix?",
        matrices.position_as_row,
        Rank.WHOLE,
    ),
)
"""Of an entry, a row or a column."""
