"""How a row of a DH table is changed, and lengths and angles in it: what the makers of mistakes share."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from typing import TypeAlias

from dhcli.checking.diagnosis.record import Catalogue
from dhcli.checking.diagnosis.result import Rank
from dhcli.checking.diagnosis.work import Factor, Made, Maker, Setting, Work
from dhcli.kinematics.conventions import Convention, Row, moves_of
from dhcli.kinematics.values import symbols_of
from dhcli.notation.angle import Angle
from dhcli.notation.tree import ZERO, Expr, Number, Sum, add

Change: TypeAlias = Callable[[Row, Setting], Row | None]

OFFSETS = (90, -90, 180)
"""Offsets that people see in a drawing and add, in degrees."""
MILLI = Fraction(1, 1000)
RIGHT_ANGLE = Angle.in_degrees(90)

CALCULATOR = "is your calculator in degrees or in radians?"
LENGTHS = "look at the units of the lengths"
"""Where to look when a number is in another unit."""


def each(change: Change) -> Maker:
    """A mistake that may be made in any one row."""

    def made(work: Work, setting: Setting) -> Made:
        for index, step in enumerate(work.steps):
            changed = _changed(step, change, setting)
            if changed is not None:
                yield step.name, work.with_step(index, changed)

    return made


def all_rows(change: Change) -> Maker:
    """A mistake that is made in every row, where that is more than one."""

    def made(work: Work, setting: Setting) -> Made:
        steps = tuple(_changed(step, change, setting) or step for step in work.steps)
        if sum(step is not other for step, other in zip(steps, work.steps, strict=True)) > 1:
            yield "", replace(work, steps=steps)

    return made


class InRows(Catalogue[Maker]):
    """Mistakes in rows of a table."""

    def in_each(self, *record: str, of_values: bool = False, rank: Rank = Rank.PLACE) -> Callable[[Change], Change]:
        """A mistake that may be made in any one row: its name, its words and its hint; of what changes the row."""

        def taken(change: Change) -> Change:
            self(*record, of_values=of_values, rank=rank)(each(change))
            return change

        return taken


def _changed(step: Factor, change: Change, setting: Setting) -> Factor | None:
    """The factor with its row changed; None where it has none, or would not change."""

    def made() -> Factor | None:
        row = change(step.row, setting) if step.row is not None else None
        return None if row is None or row == step.row else in_row(step, row, setting.convention)

    return setting.factor((change, step), made)


def in_row(step: Factor, row: Row, convention: Convention) -> Factor:
    """The factor with another row."""
    return Factor(step.name, moves_of(row, convention), row)


def other_unit(angle: Angle, setting: Setting) -> Angle | None:
    """A known angle with its number in the other unit; None where that changes nothing, or it is no number."""
    if not setting.numeric:
        return None
    value = angle.substitute(setting.values)
    if value.terms or bool(value.degrees) is bool(value.radians):
        return None
    return Angle(degrees=value.radians, radians=value.degrees)


def scale_of(setting: Setting) -> Expr | None:
    """What makes millimetres on a sheet in metres, or metres on one in millimetres; None where no unit is written."""
    if not setting.numeric or not setting.unit:
        return None
    return Number(MILLI if setting.unit == MILLI else 1 / MILLI)


def moving_and_fixed(expr: Expr, setting: Setting) -> tuple[Expr, Expr]:
    """The terms of a length that move, and those that do not."""
    terms = expr.terms if isinstance(expr, Sum) else (expr,)
    moving = [term for term in terms if symbols_of(term) & set(setting.variables)]
    if not moving:
        return expr, ZERO
    return add(*moving), add(*(term for term in terms if term not in moving))
