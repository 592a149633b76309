"""What can be asked of a robot in motion."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from dhcli.errors import RobotError, plural
from dhcli.kinematics.limits import warnings
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.values import Values
from dhcli.kinematics.velocity.answers import JacobianAnswer, SingularAnswer, TorquesAnswer, VelocityAnswer
from dhcli.kinematics.velocity.form import GEOMETRIC, Form, part_of
from dhcli.kinematics.velocity.jacobian import Jacobian, numeric_jacobian, textbook_jacobian
from dhcli.kinematics.velocity.statics import Wrench, numeric_torques, products, textbook_torques
from dhcli.kinematics.velocity.view import MotionView, check_rates
from dhcli.notation.tree import ZERO, Expr, Symbol
from dhcli.notation.walk import operations, symbols_in

if TYPE_CHECKING:  # what only some questions need is imported when they are asked
    from dhcli.kinematics.singular.result import Singularities

LONG = 40
"""Operations above which a shorter frame is looked for."""

MOST_JOINTS = 7
"""Joints up to which it is."""


def answer_jacobian(
    robot: Robot, values: Values, view: MotionView, form: Form, *, symbolic: bool, let: bool
) -> JacobianAnswer:
    """The Jacobian of a robot, in numbers or in symbols.

    Raises:
        RobotError: A value is missing, nothing moves, or the result would be too long.
    """
    said = tuple(warnings(robot, values))
    if not symbolic:
        return JacobianAnswer(robot, values, numeric_jacobian(robot, values, view, form), warnings=said)
    found = textbook_jacobian(robot, values, view, form)
    hint = _shorter(robot, values, found)
    if not let:
        return JacobianAnswer(robot, values, found, hint=hint, warnings=said)
    from dhcli.notation.let import name_parts

    definitions, rows = name_parts(found.rows)
    return JacobianAnswer(robot, values, replace(found, rows=rows), definitions, hint, said)


def _shorter(robot: Robot, values: Values, found: Jacobian[Expr]) -> str:
    """The frame in which a long result is shortest, in words."""
    here = _operations(found)
    if here <= LONG or found.form != GEOMETRIC or len(found.joints) > MOST_JOINTS:
        return ""
    others = {}
    for axes in robot.frames:
        if axes != found.view.axes:
            others[axes] = _operations(textbook_jacobian(robot, values, replace(found.view, axes=axes)))
    best = min(others, key=others.__getitem__)
    return f"{here} operations here, {others[best]} in frame {best}: --in {best}" if 2 * others[best] < here else ""


def _operations(found: Jacobian[Expr]) -> int:
    return sum(operations(entry) for row in found.rows for entry in row)


def answer_torques(
    robot: Robot, values: Values, view: MotionView, wrench: tuple[Sequence[Expr], Sequence[Expr]], *, symbolic: bool
) -> TorquesAnswer:
    """The joint torques for a force and a moment.

    Raises:
        RobotError: A value is missing, or the force holds a name where numbers are wanted.
    """
    said = tuple(warnings(robot, values))
    (fx, fy, fz), (mx, my, mz) = wrench
    given = Wrench((fx, fy, fz), (mx, my, mz))
    if symbolic:
        return TorquesAnswer(robot, values, textbook_torques(robot, values, view, given), said)
    fx_, fy_, fz_, mx_, my_, mz_ = in_numbers(given.six, "the force or moment")
    plain = Wrench((fx_, fy_, fz_), (mx_, my_, mz_))
    return TorquesAnswer(robot, values, numeric_torques(robot, values, view, plain), said)


def answer_velocity(
    robot: Robot, values: Values, view: MotionView, rates: Sequence[Expr] | None, *, symbolic: bool
) -> VelocityAnswer:
    """The velocity for joint rates; in symbols without rates for those called `dtheta1`.

    Raises:
        RobotError: A value is missing, or there are too many or too few rates.
    """
    said = tuple(warnings(robot, values))
    if symbolic:
        found = textbook_jacobian(robot, values, view)
        given = tuple(rates) if rates is not None else tuple(Symbol(f"d{joint}") for joint in found.joints)
        check_rates(given, found.joints)
        velocity = products(found.rows, given)
        return VelocityAnswer(robot, values, view, found.joints, given, found.labels, velocity, warnings=said)
    if rates is None:
        raise RobotError("rates of the joints, or a velocity, are wanted", "--rates 0.1,0.2 or --velocity 0.1,0,0")
    numbers = numeric_jacobian(robot, values, view)
    typed = in_numbers(rates, "a rate")
    check_rates(typed, numbers.joints)
    moved = tuple(sum(a * b for a, b in zip(row, typed, strict=True)) for row in numbers.rows)
    return VelocityAnswer(robot, values, view, numbers.joints, typed, numbers.labels, moved, warnings=said)


def answer_rates(
    robot: Robot,
    values: Values,
    view: MotionView,
    wanted: tuple[Sequence[Expr] | None, Sequence[Expr] | None],
    damping: float,
) -> VelocityAnswer:
    """The joint rates for a velocity, an angular velocity, or both; see `joint_rates`."""
    from dhcli.kinematics.velocity.rates import rates_at

    linear, angular = (None if part is None else in_numbers(part, "a velocity") for part in wanted)
    solved = rates_at(robot, values, view, linear, angular, damping)
    said = (*warnings(robot, values), *solved.warnings)
    return VelocityAnswer(
        robot,
        values,
        view,
        solved.joints,
        solved.values,
        solved.labels,
        solved.reached,
        solved,
        said,
        for_velocity=True,
    )


def answer_symbolic_rates(
    robot: Robot, values: Values, view: MotionView, linear: Sequence[Expr] | None, angular: Sequence[Expr] | None
) -> VelocityAnswer:
    """The joint rates for a velocity in symbols, of an arm with as many joints as rows that they can move.

    Raises:
        RobotError: It has more or fewer, or more than are written out, or is singular everywhere.
    """
    from dhcli.kinematics.singular.finding import neat_determinant
    from dhcli.kinematics.velocity.cramer import LARGEST, solved

    found = textbook_jacobian(robot, values, view)
    wanted = (*(linear or ()), *(angular or ()))
    form = Form(part_of(linear, angular))
    rows, labels = [found.rows[k] for k in form.rows], form.labels
    kept = [k for k, row in enumerate(rows) if any(entry != ZERO for entry in row)]
    joints = len(found.joints)
    if len(kept) != joints or joints > LARGEST:
        message = (
            f"{plural(joints, 'joint')} for {plural(len(kept), 'row')} that can move: "
            f"in letters as many joints as rows, up to {LARGEST}"
        )
        raise RobotError(message, "leave --symbolic out")
    for k in set(range(len(rows))) - set(kept):
        if wanted[k] != ZERO:
            raise RobotError(f"no joint gives {labels[k]}, which is to be {wanted[k]}", "write 0 for it")
    square = [rows[k] for k in kept]
    rates = solved(square, [wanted[k] for k in kept], neat_determinant(robot, view, form.part, values, square))
    said = tuple(warnings(robot, values))
    return VelocityAnswer(robot, values, view, found.joints, rates, labels, wanted, None, said, for_velocity=True)


def answer_singularities(
    robot: Robot, values: Values, view: MotionView, found: Singularities, *, at_values: bool
) -> SingularAnswer:
    """Where a robot is singular, with how it stands at joint values if these are given.

    Raises:
        RobotError: Values are given, and one is missing.
    """
    if not at_values:
        return SingularAnswer(robot, {}, view, found)
    from dhcli.kinematics.singular.standing import standing_at

    return SingularAnswer(
        robot, values, view, found, standing_at(robot, values, view, found), tuple(warnings(robot, values))
    )


def in_numbers(entries: Sequence[Expr], what: str) -> tuple[float, ...]:
    """Expressions as floats.

    Raises:
        RobotError: One holds a name.
    """
    from dhcli.algebra.floats import Floats

    if free := sorted(symbols_in(entries)):
        raise RobotError(f"{', '.join(free)} of {what} has no value", "write numbers, or ask with --symbolic")
    return tuple(Floats().value(entry) for entry in entries)
