"""Mistakes in several rows of a DH table at once: cells in each other's row, columns one row too far, other joints.

None of them is made in a pair: there are many, and with a second slip they could explain anything. Where a slip in one
row gives the same, that is named.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
from itertools import combinations, pairwise

from dhcli.checking.diagnosis.mistakes.changes import all_rows, in_row
from dhcli.checking.diagnosis.mistakes.rows import a_sign, d_sign, theta_sign
from dhcli.checking.diagnosis.record import Catalogue
from dhcli.checking.diagnosis.result import Rank
from dhcli.checking.diagnosis.work import Factor, Level, Made, Maker, Setting, Work
from dhcli.kinematics.conventions import Row
from dhcli.notation.angle import Angle
from dhcli.notation.names import natural_key
from dhcli.notation.tree import ZERO
from dhcli.notation.walk import symbols

BETWEEN_ROWS: Catalogue[Maker] = Catalogue(Level.TABLE)

SHIFTED = {"alpha": ("alpha",), "a": ("a",), "a+alpha": ("a", "alpha")}
"""Columns that are written one row too far, by how that is called."""

MANY = 12
"""With more rows than these only neighbours are taken for each other: the pairs of rows would be too many."""


BETWEEN_ROWS(
    "theta-signs",
    "every joint angle counts the other way",
    "look at the positive sense of the angles",
    rank=Rank.SYMPTOM,
    alone=True,
)(all_rows(theta_sign))

BETWEEN_ROWS(
    "a-signs", "the sign of a is turned round in every row", "look at the lengths a", rank=Rank.SYMPTOM, alone=True
)(all_rows(a_sign))

BETWEEN_ROWS(
    "d-signs", "the sign of each fixed d is turned round", "look at the offsets d", rank=Rank.SYMPTOM, alone=True
)(all_rows(lambda row, setting: None if symbols(row.d) & set(setting.variables) else d_sign(row, setting)))


@BETWEEN_ROWS(
    "theta-other",
    "{term} stands in row {entry}, and is the angle of another row",
    "which joint angle belongs to row {row}?",
    rank=Rank.SYMPTOM,
    of_values=True,
    alone=True,
)
def theta_other(work: Work, setting: Setting) -> Made:
    """The angle of another joint, the offset as it was; in numbers, which agree by chance, that of a neighbour."""
    every = sorted(_angles(setting), key=natural_key)
    for index, step in enumerate(work.steps):
        own = step.row.theta.terms if step.row is not None else ()
        if step.row is None or len(own) != 1 or own[0][0] not in every:
            continue
        near = every.index(own[0][0])
        for other in every[max(0, near - 1) : near + 2] if setting.numeric or len(every) > MANY else every:
            factor = setting.factor((theta_other, other, step), partial(_with_angle, step, other, setting))
            if factor is not None:
                yield f"{step.name} {other}", work.with_step(index, factor)


def _with_angle(step: Factor, name: str, setting: Setting) -> Factor | None:
    """The factor with another joint angle in its row; None where that is hardly another angle."""
    assert step.row is not None  # noqa: S101
    row = replace(step.row, theta=replace(step.row.theta, terms=((name, step.row.theta.terms[0][1]),)))
    return None if _hardly_differ(row.theta, step.row.theta, setting) else in_row(step, row, setting.convention)


@BETWEEN_ROWS(
    "theta-zero",
    "the value of the joint angle in row {where} is left out, as if it were 0",
    "look at the value of the joint angle in row {where}",
    rank=Rank.WHOLE,
    of_values=True,
    alone=True,
)
def theta_zero(work: Work, setting: Setting) -> Made:
    """A joint angle that is given, or drawn, is not put in."""
    for index, step in enumerate(work.steps):
        if step.row is None or not setting.numeric or not step.row.theta.names & set(setting.variables):
            continue
        factor = setting.factor((theta_zero, step), partial(_at_zero, step, setting))
        if factor is not None:
            yield step.name, work.with_step(index, factor)


def _at_zero(step: Factor, setting: Setting) -> Factor | None:
    """The factor without the joint angle of its row; None where that is 0."""
    assert step.row is not None  # noqa: S101
    row = replace(step.row, theta=replace(step.row.theta, terms=()))
    return None if step.row.theta.substitute(setting.values) == row.theta else in_row(step, row, setting.convention)


@BETWEEN_ROWS(
    "a-swapped", "a of rows {where} have changed places", "which a belongs to which row?", rank=Rank.SYMPTOM, alone=True
)
def a_swapped(work: Work, setting: Setting) -> Made:
    """Two lengths in each other's row; one that is 0 leaves the other in a wrong row."""
    return _swapped(work, setting, "a", lambda row: row.a != ZERO)


@BETWEEN_ROWS(
    "d-swapped", "d of rows {where} have changed places", "which d belongs to which row?", rank=Rank.SYMPTOM, alone=True
)
def d_swapped(work: Work, setting: Setting) -> Made:
    """Two offsets in each other's row; a joint that slides stays where it is."""
    moving = set(setting.variables)
    fixed = [step.row is not None and not symbols(step.row.d) & moving for step in work.steps]
    return _swapped(work, setting, "d", lambda row: row.d != ZERO, fixed)


@BETWEEN_ROWS(
    "alpha-swapped",
    "alpha of rows {where} have changed places",
    "which alpha belongs to which row?",
    rank=Rank.SYMPTOM,
    alone=True,
)
def alpha_swapped(work: Work, setting: Setting) -> Made:
    """Two twists in each other's row; one that is 0 leaves the other in a wrong row."""
    return _swapped(work, setting, "alpha", lambda row: not row.alpha.is_zero)


@BETWEEN_ROWS(
    "shifted",
    "{entry} stands one row further {term} everywhere",
    "which row does each {entry} belong to in this convention?",
    rank=Rank.SYMPTOM,
    alone=True,
)
def shifted(work: Work, setting: Setting) -> Made:
    """A column, or two, one row too low or too high: what belongs to i stands in i+1, as in the other convention.

    A single cell that is filled is one that has changed places with an empty one.
    """
    rows = [step.row for step in work.steps if step.row is not None]
    if len(rows) < 2:  # noqa: PLR2004
        return
    empty = Row(ZERO, Angle(), ZERO, Angle())
    filled = {"a": sum(row.a != ZERO for row in rows), "alpha": sum(not row.alpha.is_zero for row in rows)}
    for name, columns in SHIFTED.items():
        if sum(filled[column] for column in columns) < 2 or not all(filled[column] for column in columns):  # noqa: PLR2004
            continue
        for where, others in (("down", [empty, *rows[:-1]]), ("up", [*rows[1:], empty])):
            taken = [{column: getattr(other, column) for column in columns} for other in others]
            changed = [replace(row, **cells) for row, cells in zip(rows, taken, strict=True)]
            if changed != rows:
                yield f"{name} {where}", _with_rows(work, setting, changed)


def _swapped(
    work: Work, setting: Setting, column: str, is_there: Callable[[Row], bool], free: Sequence[bool] = ()
) -> Made:
    """Every two cells of a column that differ, in each other's row."""
    places = [k for k, step in enumerate(work.steps) if step.row is not None and (not free or free[k])]
    for k, m in combinations(places, 2) if len(places) <= MANY else pairwise(places):
        one, two = work.steps[k], work.steps[m]
        if one.row is None or two.row is None:
            continue
        first, second = getattr(one.row, column), getattr(two.row, column)
        if first == second or not (is_there(one.row) or is_there(two.row)):
            continue
        changed = work
        for index, step, row, value in ((k, one, one.row, second), (m, two, two.row, first)):
            made = partial(in_row, step, replace(row, **{column: value}), setting.convention)
            changed = changed.with_step(index, setting.factor((column, value, step), made) or step)
        yield f"{one.name} and {two.name}", changed


def _hardly_differ(first: Angle, second: Angle, setting: Setting) -> bool:
    """Whether two angles are the same, or in numbers complements, whose sine and cosine have changed places."""
    one, two = first.substitute(setting.values), second.substitute(setting.values)
    return one == two or (setting.numeric and (one + two).quarter_turns() == 1)


def _with_rows(work: Work, setting: Setting, rows: Sequence[Row]) -> Work:
    """The work with other rows, one for each that it has."""
    left = iter(rows)
    steps = (step if step.row is None else in_row(step, next(left), setting.convention) for step in work.steps)
    return replace(work, steps=tuple(steps))


def _angles(setting: Setting) -> frozenset[str]:
    """The joint angles of the robot."""
    links = setting.robot.links if setting.robot is not None else ()
    held = (link.row.theta.names for link in links if link.row is not None)
    return frozenset[str]().union(*held) & frozenset(setting.variables)
