"""Mistakes in the units of one row or of all: degrees for radians, millimetres for metres."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

from dhcli.checking.diagnosis.mistakes.changes import (
    CALCULATOR,
    LENGTHS,
    InRows,
    all_rows,
    other_unit,
    scale_of,
)
from dhcli.checking.diagnosis.work import Factor, Level, Made, Setting, Work
from dhcli.kinematics.conventions import Row, moves_of
from dhcli.notation.tree import multiply

IN_UNITS = InRows(Level.TABLE)


@IN_UNITS.in_each(
    "theta-unit",
    "the joint angle of row {where} is taken in the wrong unit, degrees for radians or the other way round",
    CALCULATOR,
    of_values=True,
)
def theta_unit(row: Row, setting: Setting) -> Row | None:
    """The joint's value in the other unit."""
    theta = other_unit(row.theta, setting)
    return None if theta is None else replace(row, theta=theta)


@IN_UNITS.in_each(
    "alpha-unit",
    "alpha of row {where} is taken in the wrong unit, degrees for radians or the other way round",
    CALCULATOR,
    of_values=True,
)
def alpha_unit(row: Row, setting: Setting) -> Row | None:
    """The twist in the other unit."""
    alpha = other_unit(row.alpha, setting)
    return None if alpha is None else replace(row, alpha=alpha)


@IN_UNITS(
    "angles-unit",
    "every angle is taken in the wrong unit, degrees for radians or the other way round",
    CALCULATOR,
    of_values=True,
)
def angles_unit(work: Work, setting: Setting) -> Made:
    """All angles in the other unit, as on a calculator in the wrong mode."""

    def changed(step: Factor) -> Factor | None:
        if step.row is None:
            return step
        alpha, theta = (other_unit(angle, setting) or angle for angle in (step.row.alpha, step.row.theta))
        chain = moves_of(replace(step.row, alpha=alpha, theta=theta), setting.convention)
        return Factor(step.name, chain, step.row)

    if setting.numeric and sum(step.row is not None for step in work.steps) > 1:
        steps = (setting.factor((angles_unit, step), partial(changed, step)) or step for step in work.steps)
        yield "", replace(work, steps=tuple(steps))


IN_UNITS(
    "thetas-unit",
    "the joint angles are taken in the wrong unit, degrees for radians or the other way round",
    CALCULATOR,
    of_values=True,
)(all_rows(theta_unit))


@IN_UNITS.in_each(
    "a-in-mm",
    "a of row {where} is in another unit than the other lengths, mm for m",
    LENGTHS,
)
def a_unit(row: Row, setting: Setting) -> Row | None:
    """The number of another unit in the place of a length."""
    factor = scale_of(setting)
    return None if factor is None else replace(row, a=multiply(factor, row.a))


@IN_UNITS.in_each(
    "d-in-mm",
    "d of row {where} is in another unit than the other lengths, mm for m",
    LENGTHS,
)
def d_unit(row: Row, setting: Setting) -> Row | None:
    """The number of another unit in the place of an offset."""
    factor = scale_of(setting)
    return None if factor is None else replace(row, d=multiply(factor, row.d))
