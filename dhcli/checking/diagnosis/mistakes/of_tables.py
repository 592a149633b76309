"""Mistakes in one row of a table or in all of them, or in one move of a product."""

from __future__ import annotations

from dhcli.checking.diagnosis import moves, rows
from dhcli.checking.diagnosis.mistakes.record import Level, Mistake

T = Level.TABLE

IN_ROWS = (
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
        "look at the zero of joint {where}",
        rows.each(rows.offset_forgotten),
    ),
    Mistake(
        "theta-forgotten",
        T,
        "theta of row {where}, which stands still, is forgotten",
        "look at the angle from x to x in row {where}",
        rows.each(rows.theta_forgotten),
    ),
    Mistake(
        "offset-sign",
        T,
        "the sign of the offset in row {where} is turned round",
        "look at the zero of joint {where}",
        rows.each(rows.offset_sign),
    ),
    Mistake(
        "offset-added",
        T,
        "theta of row {entry}, which has no offset, has {term} added",
        "look at the zero of joint {row}",
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
        "thetas-unit",
        T,
        "the joint angles are taken in the wrong unit, degrees for radians or the other way round",
        "is your calculator in degrees or in radians?",
        rows.all_rows(rows.theta_unit),
        of_values=True,
    ),
    Mistake(
        "thetas-swapped",
        T,
        "the joint angles of rows {where} have changed places",
        "which joint angle belongs to which row?",
        rows.thetas_swapped,
        of_values=True,
        alone=True,
    ),
    Mistake(
        "alpha-signs",
        T,
        "the sign of alpha is turned round in every row",
        "look at the sense of the twist",
        rows.all_rows(rows.alpha_sign),
    ),
    Mistake(
        "a-d-swaps",
        T,
        "a and d have changed places in every row",
        "look at a and d: which is along x, which along z?",
        rows.all_rows(rows.a_d_swapped),
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
)
"""In a row of a DH table."""

IN_MOVES = (
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
        "the sign of the shift along {term} in move {entry} is turned round",
        "look at the sense of the shift in move {row}",
        moves.shift_sign,
    ),
    Mistake(
        "shift-in-mm",
        T,
        "the shift along {term} in move {entry} is in another unit than the other lengths, mm for m",
        "look at the units of the lengths",
        moves.shift_unit,
    ),
    Mistake("move-missing", T, "move {where} is left out", "count the moves of link {row}", moves.missing),
)
"""In a move, where a link is a product of moves and has no row."""
