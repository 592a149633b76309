"""Mistakes in one row of a DH table or in all of them. A row that would not change is None, or the row itself."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from functools import partial
from itertools import pairwise

from dhcli.checking.diagnosis.mistakes.changes import (
    OFFSETS,
    RIGHT_ANGLE,
    InRows,
    all_rows,
    in_row,
    moving_and_fixed,
)
from dhcli.checking.diagnosis.result import Rank
from dhcli.checking.diagnosis.work import Factor, Level, Made, Setting, Work
from dhcli.kinematics.conventions import OTHER, Row, moves_of
from dhcli.notation.angle import Angle
from dhcli.notation.tree import ZERO, add, negate
from dhcli.notation.walk import symbols

IN_ROWS = InRows(Level.TABLE)
"""In the order in which they are tried and named."""


@IN_ROWS.in_each(
    "alpha-sign", "the sign of alpha in row {where} is turned round", "look at the sense of the twist in row {where}"
)
def alpha_sign(row: Row, _setting: Setting) -> Row | None:
    """The twist the other way; half a turn has no sense."""
    return None if row.alpha.quarter_turns() in (0, 2) else replace(row, alpha=-row.alpha)


@IN_ROWS.in_each("alpha-forgotten", "alpha of row {where} is forgotten", "look at the twist in row {where}")
def alpha_forgotten(row: Row, _setting: Setting) -> Row:
    """No twist."""
    return replace(row, alpha=Angle())


@IN_ROWS.in_each(
    "theta-sign",
    "the angle theta of row {where} counts the other way",
    "look at the positive sense of the angle in row {where}",
)
def theta_sign(row: Row, _setting: Setting) -> Row | None:
    """The joint angle the other way, its offset kept."""
    offset = replace(row.theta, terms=())
    moving = row.theta - offset
    return replace(row, theta=offset - moving) if moving.terms else None


@IN_ROWS.in_each("offset-forgotten", "the offset in row {where} is forgotten", "look at the zero of joint {where}")
def offset_forgotten(row: Row, setting: Setting) -> Row:
    """The variable alone, of an angle or of a length."""
    if row.theta.names & set(setting.variables):
        return replace(row, theta=replace(row.theta, degrees=Fraction(0), radians=Fraction(0)))
    return replace(row, d=moving_and_fixed(row.d, setting)[0])


@IN_ROWS.in_each(
    "theta-forgotten",
    "theta of row {where}, which stands still, is forgotten",
    "look at the angle from x to x in row {where}",
)
def theta_forgotten(row: Row, setting: Setting) -> Row | None:
    """No turn in a row whose theta stands still; an angle that moves would be missed."""
    return None if row.theta.names & set(setting.variables) else replace(row, theta=Angle())


@IN_ROWS.in_each(
    "offset-sign", "the sign of the offset in row {where} is turned round", "look at the zero of joint {where}"
)
def offset_sign(row: Row, setting: Setting) -> Row | None:
    """The offset taken away instead of added; half a turn has no sense."""
    if row.theta.names & set(setting.variables):
        offset = replace(row.theta, terms=())
        return None if offset.quarter_turns() in (0, 2) else replace(row, theta=row.theta - offset * 2)
    moving, constant = moving_and_fixed(row.d, setting)
    return replace(row, d=add(moving, negate(constant)))


@IN_ROWS(
    "offset-added", "theta of row {entry}, which has no offset, has {term} added", "look at the zero of joint {row}"
)
def offset_added(work: Work, setting: Setting) -> Made:
    """An angle of the drawing added to a variable that has no offset."""
    for index, step in enumerate(work.steps):
        row = step.row
        if row is None or row.theta.degrees or row.theta.radians or not row.theta.names & set(setting.variables):
            continue
        for degrees in OFFSETS:
            changed = replace(row, theta=row.theta + Angle.in_degrees(degrees))
            factor = setting.factor((degrees, step), partial(in_row, step, changed, setting.convention))
            if factor is not None:
                yield f"{step.name} {degrees}°", work.with_step(index, factor)


@IN_ROWS.in_each("a-sign", "the sign of a in row {where} is turned round", "look at the length a in row {where}")
def a_sign(row: Row, _setting: Setting) -> Row:
    """The length the other way."""
    return replace(row, a=negate(row.a))


@IN_ROWS.in_each("d-sign", "the sign of d in row {where} is turned round", "look at the offset d in row {where}")
def d_sign(row: Row, _setting: Setting) -> Row:
    """The offset the other way."""
    return replace(row, d=negate(row.d))


@IN_ROWS.in_each("a-forgotten", "a of row {where} is forgotten", "look at the length a in row {where}")
def a_forgotten(row: Row, _setting: Setting) -> Row:
    """No length."""
    return replace(row, a=ZERO)


@IN_ROWS.in_each("d-forgotten", "d of row {where} is forgotten", "look at the offset d in row {where}")
def d_forgotten(row: Row, setting: Setting) -> Row | None:
    """No offset; a joint variable is not forgotten, it would be missed."""
    return None if symbols(row.d) & set(setting.variables) else replace(row, d=ZERO)


@IN_ROWS.in_each(
    "a-d-swapped",
    "a and d of row {where} have changed places",
    "look at a and d in row {where}: which is along x, which along z?",
)
def a_d_swapped(row: Row, _setting: Setting) -> Row:
    """The two lengths in each other's place."""
    return replace(row, a=row.d, d=row.a)


@IN_ROWS(
    "moves-reversed",
    "the four moves of row {where} are made in the order of the other convention",
    "look at the order of the four moves in row {where}",
)
def moves_reversed(work: Work, setting: Setting) -> Made:
    """One row multiplied out as the other convention does it."""
    for index, step in enumerate(work.steps):
        if step.row is not None and (len(work.steps) > 1 or setting.convention in OTHER):
            yield step.name, work.with_step(index, _reversed(step, setting))


@IN_ROWS(
    "convention", "the rows are read in the other convention", "which convention has this table, standard or modified?"
)
def convention(work: Work, setting: Setting) -> Made:
    """All rows multiplied out as the other convention does it."""
    rows = [step for step in work.steps if step.row is not None]
    if len(rows) > 1:
        yield "", replace(work, steps=tuple(_reversed(step, setting) for step in work.steps))


@IN_ROWS.in_each(
    "sin-cos",
    "sine and cosine of the angle in row {where} have changed places",
    "look at sine and cosine in row {where}",
    rank=Rank.SYMPTOM,
)
def sine_cosine(row: Row, _setting: Setting) -> Row | None:
    """Cos for sin: the complement of the angle."""
    return replace(row, theta=RIGHT_ANGLE - row.theta) if row.theta.names else None


@IN_ROWS(
    "thetas-swapped",
    "the joint angles of rows {where} have changed places",
    "which joint angle belongs to which row?",
    of_values=True,
    alone=True,
)
def thetas_swapped(work: Work, setting: Setting) -> Made:
    """The values of two joints next to each other in each other's row, each row with the offset it had."""
    turning = [
        (k, step.row)
        for k, step in enumerate(work.steps)
        if step.row is not None and step.row.theta.names & set(setting.variables)
    ]
    for (k, one), (m, two) in pairwise(turning):
        if setting.numeric and _moved(one, setting) == _moved(two, setting):  # nobody could see it
            continue
        first, second = (replace(row.theta, terms=()) for row in (one, two))
        changed, pair = work, (work.steps[k], work.steps[m])
        for index, row, theta in ((k, one, first + (two.theta - second)), (m, two, second + (one.theta - first))):
            made = partial(in_row, work.steps[index], replace(row, theta=theta), setting.convention)
            changed = changed.with_step(index, setting.factor((thetas_swapped, index == k, *pair), made) or pair[0])
        yield f"{pair[0].name} and {pair[1].name}", changed


IN_ROWS("alpha-signs", "the sign of alpha is turned round in every row", "look at the sense of the twist")(
    all_rows(alpha_sign)
)


IN_ROWS("a-d-swaps", "a and d have changed places in every row", "look at a and d: which is along x, which along z?")(
    all_rows(a_d_swapped)
)


def _moved(row: Row, setting: Setting) -> Angle:
    """What the joint of a row adds to theta."""
    return (row.theta - replace(row.theta, terms=())).substitute(setting.values)


def _reversed(step: Factor, setting: Setting) -> Factor:
    """The factor with its row multiplied out as the other convention does it."""

    def made() -> Factor | None:
        row = step.row
        return None if row is None else Factor(step.name, moves_of(row, OTHER[setting.convention]), row)

    return setting.factor(("reversed", step), made) or step
