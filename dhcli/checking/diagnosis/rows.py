"""Mistakes in a row of a DH table. Each gives the row that holds it, or None where it would change nothing."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise
from typing import TypeAlias

from dhcli.checking.diagnosis.work import Factor, Setting, Work
from dhcli.kinematics.conventions import Convention, Row, moves_of
from dhcli.kinematics.values import symbols_of
from dhcli.notation.angle import Angle
from dhcli.notation.tree import ZERO, Expr, Number, Sum, add, multiply, negate
from dhcli.notation.walk import symbols

Change: TypeAlias = Callable[[Row, Setting], Row | None]

OTHER = {Convention.STANDARD: Convention.MODIFIED, Convention.MODIFIED: Convention.STANDARD}
OFFSETS = (90, -90, 180)
"""Offsets that people see in a drawing and add, in degrees."""
MILLI = Fraction(1, 1000)
RIGHT_ANGLE = Angle.in_degrees(90)


def each(change: Change) -> Callable[[Work, Setting], Iterator[tuple[str, Work]]]:
    """A mistake that may be made in any one row."""

    def made(work: Work, setting: Setting) -> Iterator[tuple[str, Work]]:
        for index, step in enumerate(work.steps):
            row = change(step.row, setting) if step.row is not None else None
            if row is not None and row != step.row:
                yield step.name, work.with_step(index, in_row(step, row, setting.convention))

    return made


def all_rows(change: Change) -> Callable[[Work, Setting], Iterator[tuple[str, Work]]]:
    """A mistake that is made in every row, where that is more than one."""

    def made(work: Work, setting: Setting) -> Iterator[tuple[str, Work]]:
        rows = [change(step.row, setting) if step.row is not None else None for step in work.steps]
        steps = tuple(
            step if row is None or row == step.row else in_row(step, row, setting.convention)
            for step, row in zip(work.steps, rows, strict=True)
        )
        if sum(step is not other for step, other in zip(steps, work.steps, strict=True)) > 1:
            yield "", replace(work, steps=steps)

    return made


def in_row(step: Factor, row: Row, convention: Convention) -> Factor:
    """The factor with another row."""
    return Factor(step.name, moves_of(row, convention), row)


def alpha_sign(row: Row, _setting: Setting) -> Row | None:
    """The twist the other way; half a turn has no sense."""
    return None if row.alpha.quarter_turns() in (0, 2) else replace(row, alpha=-row.alpha)


def alpha_forgotten(row: Row, _setting: Setting) -> Row:
    """No twist."""
    return replace(row, alpha=Angle())


def theta_sign(row: Row, _setting: Setting) -> Row | None:
    """The joint angle the other way, its offset kept."""
    offset = replace(row.theta, terms=())
    moving = row.theta - offset
    return replace(row, theta=offset - moving) if moving.terms else None


def offset_forgotten(row: Row, setting: Setting) -> Row:
    """The variable alone, of an angle or of a length."""
    if row.theta.names & set(setting.variables):
        return replace(row, theta=replace(row.theta, degrees=Fraction(0), radians=Fraction(0)))
    return replace(row, d=_parts(row.d, setting)[0])


def theta_forgotten(row: Row, setting: Setting) -> Row | None:
    """No turn in a row whose theta stands still; an angle that moves would be missed."""
    return None if row.theta.names & set(setting.variables) else replace(row, theta=Angle())


def offset_sign(row: Row, setting: Setting) -> Row | None:
    """The offset taken away instead of added; half a turn has no sense."""
    if row.theta.names & set(setting.variables):
        offset = replace(row.theta, terms=())
        return None if offset.quarter_turns() in (0, 2) else replace(row, theta=row.theta - offset * 2)
    moving, constant = _parts(row.d, setting)
    return replace(row, d=add(moving, negate(constant)))


def offset_added(work: Work, setting: Setting) -> Iterator[tuple[str, Work]]:
    """An angle of the drawing added to a variable that has no offset."""
    for index, step in enumerate(work.steps):
        row = step.row
        if row is None or row.theta.degrees or row.theta.radians or not row.theta.names & set(setting.variables):
            continue
        for degrees in OFFSETS:
            changed = replace(row, theta=row.theta + Angle.in_degrees(degrees))
            yield f"{step.name} {degrees}°", work.with_step(index, in_row(step, changed, setting.convention))


def a_sign(row: Row, _setting: Setting) -> Row:
    """The length the other way."""
    return replace(row, a=negate(row.a))


def d_sign(row: Row, _setting: Setting) -> Row:
    """The offset the other way."""
    return replace(row, d=negate(row.d))


def a_forgotten(row: Row, _setting: Setting) -> Row:
    """No length."""
    return replace(row, a=ZERO)


def d_forgotten(row: Row, setting: Setting) -> Row | None:
    """No offset; a joint variable is not forgotten, it would be missed."""
    return None if symbols(row.d) & set(setting.variables) else replace(row, d=ZERO)


def a_d_swapped(row: Row, _setting: Setting) -> Row:
    """The two lengths in each other's place."""
    return replace(row, a=row.d, d=row.a)


def sine_cosine(row: Row, _setting: Setting) -> Row | None:
    """Cos for sin: the complement of the angle."""
    return replace(row, theta=RIGHT_ANGLE - row.theta) if row.theta.names else None


def thetas_swapped(work: Work, setting: Setting) -> Iterator[tuple[str, Work]]:
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
        changed = work
        for index, theta in ((k, first + (two.theta - second)), (m, second + (one.theta - first))):
            step = work.steps[index]
            assert step.row is not None  # noqa: S101  it has been looked at
            changed = changed.with_step(index, in_row(step, replace(step.row, theta=theta), setting.convention))
        yield f"{work.steps[k].name} and {work.steps[m].name}", changed


def theta_unit(row: Row, setting: Setting) -> Row | None:
    """The joint's value in the other unit."""
    theta = other_unit(row.theta, setting)
    return None if theta is None else replace(row, theta=theta)


def alpha_unit(row: Row, setting: Setting) -> Row | None:
    """The twist in the other unit."""
    alpha = other_unit(row.alpha, setting)
    return None if alpha is None else replace(row, alpha=alpha)


def a_unit(row: Row, setting: Setting) -> Row | None:
    """The number of another unit in the place of a length."""
    factor = scale_of(setting)
    return None if factor is None else replace(row, a=multiply(factor, row.a))


def d_unit(row: Row, setting: Setting) -> Row | None:
    """The number of another unit in the place of an offset."""
    factor = scale_of(setting)
    return None if factor is None else replace(row, d=multiply(factor, row.d))


def moves_reversed(work: Work, setting: Setting) -> Iterator[tuple[str, Work]]:
    """One row multiplied out as the other convention does it."""
    for index, step in enumerate(work.steps):
        if step.row is not None and (len(work.steps) > 1 or setting.convention in OTHER):
            chain = moves_of(step.row, OTHER[setting.convention])
            yield step.name, work.with_step(index, Factor(step.name, chain, step.row))


def convention(work: Work, setting: Setting) -> Iterator[tuple[str, Work]]:
    """All rows multiplied out as the other convention does it."""
    rows = [step for step in work.steps if step.row is not None]
    if len(rows) > 1:
        yield "", _every(work, lambda row: moves_of(row, OTHER[setting.convention]))


def angles_unit(work: Work, setting: Setting) -> Iterator[tuple[str, Work]]:
    """All angles in the other unit, as on a calculator in the wrong mode."""

    def changed(row: Row) -> Row:
        alpha, theta = (other_unit(angle, setting) or angle for angle in (row.alpha, row.theta))
        return replace(row, alpha=alpha, theta=theta)

    if setting.numeric and sum(step.row is not None for step in work.steps) > 1:
        yield "", _every(work, lambda row: moves_of(changed(row), setting.convention))


def other_unit(angle: Angle, setting: Setting) -> Angle | None:
    """A known angle with its number in the other unit; None where that changes nothing, or it is no number."""
    if not setting.numeric:
        return None
    value = _value(angle, setting)
    if value.terms or bool(value.degrees) is bool(value.radians):
        return None
    return Angle(degrees=value.radians, radians=value.degrees)


def _moved(row: Row, setting: Setting) -> Angle:
    """What the joint of a row adds to theta."""
    return _value(row.theta - replace(row.theta, terms=()), setting)


def _value(angle: Angle, setting: Setting) -> Angle:
    """An angle with the values that the task gives."""
    return angle.substitute({name: value for name, value in setting.values.items() if isinstance(value, Angle)})


def scale_of(setting: Setting) -> Expr | None:
    """What makes millimetres on a sheet in metres, or metres on one in millimetres; None where no unit is written."""
    if not setting.numeric or not setting.unit:
        return None
    return Number(MILLI if setting.unit == MILLI else 1 / MILLI)


def _every(work: Work, moves: Callable[[Row], object]) -> Work:
    steps = tuple(
        step if step.row is None else Factor(step.name, moves(step.row), step.row)  # type: ignore[arg-type]
        for step in work.steps
    )
    return replace(work, steps=steps)


def _parts(expr: Expr, setting: Setting) -> tuple[Expr, Expr]:
    """The terms of a length that move, and those that do not."""
    terms = expr.terms if isinstance(expr, Sum) else (expr,)
    moving = [term for term in terms if symbols_of(term) & set(setting.variables)]
    if not moving:
        return expr, ZERO
    return add(*moving), add(*(term for term in terms if term not in moving))
