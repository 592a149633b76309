"""The mistakes that dhcli knows, each a record: how it is made, what it is called, and where a student should look.

To add one is to add a record to `MISTAKES`. In a pair the earlier level is made first. Of two mistakes that are the
same wherever one looks, such as the transpose of a plain turn and the turn the other way, the earlier has the name.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from enum import IntEnum
from typing import TypeAlias

from dhcli.checking.diagnosis import matrices, moves, products, rows
from dhcli.checking.diagnosis.result import Rank
from dhcli.checking.diagnosis.work import Setting, Work

Made: TypeAlias = Iterator[tuple[str, Work]]
"""Where a mistake is made, such as `2` or `2 1`, and the work that holds it."""


class Level(IntEnum):
    """At what stage of the work a mistake is made."""

    TABLE = 1
    PRODUCT = 2
    MATRIX = 3


@dataclass(frozen=True, slots=True)
class Mistake:
    """A kind of mistake.

    Attributes:
        id: The name under which exercises ask for it.
        level: At what stage it is made.
        words: What has happened, `{where}` for the place.
        hint: Where to look, without the answer.
        made: Every way to make it in a work.
        rank: How soon it is named.
        of_values: Whether the values given go into how it is made, not only into what comes of it.
    """

    id: str
    level: Level
    words: str
    hint: str
    made: Callable[[Work, Setting], Made]
    rank: Rank = Rank.PLACE
    of_values: bool = False


T, P, M = Level.TABLE, Level.PRODUCT, Level.MATRIX

MISTAKES = (
    Mistake(
        "transposed",
        M,
        "the rotation is transposed: its columns, not its rows, are the axes of the frame described",
        "which frame do the columns of the rotation belong to?",
        matrices.transposed,
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
    # --- one row of the table ---
    Mistake(
        "alpha-sign",
        T,
        "the sign of alpha in row {where} is turned round",
        "look at the sense of the twist in row {where}",
        rows.each(rows.alpha_sign),
    ),
    Mistake(
        "alpha-forgotten",
        T,
        "alpha of row {where} is forgotten",
        "look at the twist in row {where}",
        rows.each(rows.alpha_forgotten),
    ),
    Mistake(
        "theta-sign",
        T,
        "the angle theta of row {where} counts the other way",
        "look at the positive sense of the angle in row {where}",
        rows.each(rows.theta_sign),
    ),
    Mistake(
        "offset-forgotten",
        T,
        "the offset in row {where} is forgotten",
        "look at where joint {where} is at zero",
        rows.each(rows.offset_forgotten),
    ),
    Mistake(
        "offset-sign",
        T,
        "the sign of the offset in row {where} is turned round",
        "look at where joint {where} is at zero",
        rows.each(rows.offset_sign),
    ),
    Mistake(
        "offset-added",
        T,
        "row {where} is added to theta, which has no offset",
        "look at where joint {row} is at zero",
        rows.offset_added,
    ),
    Mistake(
        "a-sign",
        T,
        "the sign of a in row {where} is turned round",
        "look at the length a in row {where}",
        rows.each(rows.a_sign),
    ),
    Mistake(
        "d-sign",
        T,
        "the sign of d in row {where} is turned round",
        "look at the offset d in row {where}",
        rows.each(rows.d_sign),
    ),
    Mistake(
        "a-forgotten",
        T,
        "a of row {where} is forgotten",
        "look at the length a in row {where}",
        rows.each(rows.a_forgotten),
    ),
    Mistake(
        "d-forgotten",
        T,
        "d of row {where} is forgotten",
        "look at the offset d in row {where}",
        rows.each(rows.d_forgotten),
    ),
    Mistake(
        "a-d-swapped",
        T,
        "a and d of row {where} have changed places",
        "look at a and d in row {where}: which is along x, which along z?",
        rows.each(rows.a_d_swapped),
    ),
    Mistake(
        "moves-reversed",
        T,
        "the four moves of row {where} are made in the order of the other convention",
        "look at the order of the four moves in row {where}",
        rows.moves_reversed,
    ),
    Mistake(
        "convention",
        T,
        "the rows are read in the other convention",
        "which convention has this table, standard or modified?",
        rows.convention,
    ),
    Mistake(
        "sin-cos",
        T,
        "sine and cosine of the angle in row {where} have changed places",
        "look at sine and cosine in row {where}",
        rows.each(rows.sine_cosine),
    ),
    Mistake(
        "theta-unit",
        T,
        "the joint angle of row {where} is taken in the wrong unit, degrees for radians or the other way round",
        "is your calculator in degrees or in radians?",
        rows.each(rows.theta_unit),
        of_values=True,
    ),
    Mistake(
        "alpha-unit",
        T,
        "alpha of row {where} is taken in the wrong unit, degrees for radians or the other way round",
        "is your calculator in degrees or in radians?",
        rows.each(rows.alpha_unit),
        of_values=True,
    ),
    Mistake(
        "angles-unit",
        T,
        "every angle is taken in the wrong unit, degrees for radians or the other way round",
        "is your calculator in degrees or in radians?",
        rows.angles_unit,
        of_values=True,
    ),
    Mistake(
        "a-in-mm",
        T,
        "a of row {where} is in another unit than the other lengths, mm for m",
        "look at the units of the lengths",
        rows.each(rows.a_unit),
    ),
    Mistake(
        "d-in-mm",
        T,
        "d of row {where} is in another unit than the other lengths, mm for m",
        "look at the units of the lengths",
        rows.each(rows.d_unit),
    ),
    # --- one move of a product ---
    Mistake(
        "turn-sign",
        T,
        "the turn in move {where} goes the other way",
        "look at the sense of the turn in move {where}",
        moves.turn_sign,
    ),
    Mistake(
        "turn-sin-cos",
        T,
        "sine and cosine of the turn in move {where} have changed places",
        "look at sine and cosine of the turn in move {where}",
        moves.turn_sine_cosine,
    ),
    Mistake(
        "turn-unit",
        T,
        "the turn in move {where} is taken in the wrong unit, degrees for radians or the other way round",
        "is your calculator in degrees or in radians?",
        moves.turn_unit,
        of_values=True,
    ),
    Mistake(
        "shift-sign",
        T,
        "the sign of the shift {where} is turned round",
        "look at the sense of the shift in move {row}",
        moves.shift_sign,
    ),
    Mistake(
        "shift-in-mm",
        T,
        "the shift {where} is in another unit than the other lengths, mm for m",
        "look at the units of the lengths",
        moves.shift_unit,
    ),
    Mistake("move-missing", T, "move {where} is left out", "count the moves of link {row}", moves.missing),
    # --- the product ---
    Mistake(
        "order-reversed",
        P,
        "the factors are multiplied in the reverse order",
        "in which order are the factors multiplied?",
        products.reversed_order,
        Rank.WHOLE,
    ),
    Mistake(
        "last-first",
        P,
        "the last factor is multiplied from the left, as for a move about the fixed axes",
        "from which side is each new factor multiplied?",
        products.last_first,
    ),
    Mistake(
        "factor-missing",
        P,
        "factor {where} is missing in the product",
        "count the factors of the product",
        products.missing,
    ),
    Mistake(
        "factor-twice",
        P,
        "factor {where} stands twice in the product",
        "count the factors of the product",
        products.twice,
    ),
    Mistake(
        "translation-not-rotated",
        P,
        "the positions are added without turning them into the reference frame",
        "in which frame is each shift measured?",
        products.unrotated,
    ),
    Mistake(
        "element-wise",
        P,
        "the matrices are multiplied entry by entry, not rows by columns",
        "how are two matrices multiplied?",
        products.elementwise,
    ),
    # --- the finished matrix ---
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
        "position-as-row",
        M,
        "the position stands in the bottom row; it belongs in the last column",
        "where does the position stand in a homogeneous matrix?",
        matrices.position_as_row,
        Rank.WHOLE,
    ),
)
"""Every mistake about a matrix or a table; those about counts stand beside what they count, in `mobility.slips`."""

BY_ID = {mistake.id: mistake for mistake in MISTAKES}
