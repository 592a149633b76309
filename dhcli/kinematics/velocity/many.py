"""Jacobians for people who compute: one or many, as numpy arrays."""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING, TypeAlias, Unpack, cast

import numpy as np

from dhcli.algebra.columns import Columns
from dhcli.algebra.program import Program, assemble
from dhcli.algebra.tape import Number, Tape
from dhcli.errors import RobotError
from dhcli.kinematics.batch import MODEST, Known, joint_rows
from dhcli.kinematics.fold import fold_rows
from dhcli.kinematics.forward import Given
from dhcli.kinematics.frames import between
from dhcli.kinematics.merge import merge
from dhcli.kinematics.robot import Robot, check_robot
from dhcli.kinematics.values import JointInput, given_parameters, joint_values, numbers, parameter_values
from dhcli.kinematics.velocity.analytic import TINY
from dhcli.kinematics.velocity.form import Form, Which
from dhcli.kinematics.velocity.jacobian import (
    Jacobian,
    check_values,
    moving_joints,
    numeric_jacobian,
    rates_by,
    six_rows,
    textbook_jacobian,
)
from dhcli.kinematics.velocity.view import MotionView, Viewing, parts
from dhcli.notation.angle import Angle
from dhcli.notation.tree import Expr

BLOCK = 4040
"""Jacobians at a time. Columns of a power of two would lie on the same few lines of a cache, and to turn their up to 42
entries into rows takes three times as long then."""

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    Table: TypeAlias = NDArray[np.float64]


def jacobian(
    robot: Robot,
    q: JointInput | ArrayLike = None,
    *,
    part: Which = "all",
    angular_first: bool = False,
    analytic: str = "",
    parameters: Given | None = None,
    **viewing: Unpack[Viewing],
) -> Table:
    """The Jacobian of a robot in numbers: velocity of a point and of a frame for each joint's own.

    Args:
        robot: The robot.
        q: Joint values in radians and metres, in any form that `forward` takes; or many, shape (N, n), a row for each.
        part: `all` six rows, or the three of v, `linear`, or of ω, `angular`.
        angular_first: Whether ω stands above v.
        analytic: Angles whose rates are wanted in the place of ω: `rpy`, or three axes such as `zyz`.
        parameters: Lengths and angles to use instead of the robot's own.
        **viewing: Between which frames, along which axes, of which point; see `Viewing`.

    Returns:
        Shape (6, n), or (3, n) of one part; for many rows with N in front. Rows v [m/s] above ω [rad/s] for joint
        rates in rad/s and m/s. The space Jacobian of Lynch and Park is `place=start, angular_first=True`, the body
        Jacobian `axes=end, angular_first=True`. Of many, a row is NaN where its values, or rates of angles, are none.

    Raises:
        RobotError: A value is missing or no number, no joint moves `end`, or there are no rates of the angles.
        UnknownNameError: The robot has no such frame, joint or length.
    """
    check_robot(robot)
    view = MotionView.of(robot, **viewing)
    form = Form(checked_part(part), angular_first, analytic)
    if _is_many(q):
        return jacobians(robot, cast("ArrayLike", q), view, form, parameters or {})
    values = {**parameter_values(robot, parameters or {}), **joint_values(robot, cast("JointInput", q))}
    return numeric_jacobian(robot, values, view, form).matrix


def symbolic_jacobian(
    robot: Robot,
    q: JointInput = None,
    *,
    part: Which = "all",
    angular_first: bool = False,
    analytic: str = "",
    parameters: Given | None = None,
    **viewing: Unpack[Viewing],
) -> Jacobian[Expr]:
    """The Jacobian of a robot in textbook form, `-a1*s1 - a2*s12`.

    Args:
        robot: The robot.
        q: Joint values to put in exactly; all others stay symbols, and every joint keeps its column.
        part: `all`, `linear` or `angular`.
        angular_first: Whether ω stands above v.
        analytic: Angles whose rates are wanted; they stand in the result by name, `roll`, `pitch` and `yaw`.
        parameters: Lengths and angles to put in exactly; all others stay symbols.
        **viewing: Between which frames, along which axes, of which point; see `Viewing`.

    Returns:
        The Jacobian, of expressions.

    Raises:
        RobotError: It would be longer than anybody can read.
        UnknownNameError: The robot has no such frame, joint or length.
    """
    check_robot(robot)
    view = MotionView.of(robot, **viewing)
    form = Form(checked_part(part), angular_first, analytic)
    values = {**given_parameters(robot, parameters or {}), **joint_values(robot, q)}
    return textbook_jacobian(robot, values, view, form)


def checked_part(part: str) -> Which:
    """The rows that are meant.

    Raises:
        RobotError: There is no such part.
    """
    if part not in {"all", "linear", "angular"}:
        raise RobotError(f"a Jacobian has no part {part}", "parts: all, linear, angular")
    return cast("Which", part)


def _is_many(q: object) -> bool:
    """Whether joint values are rows of them."""
    if isinstance(q, str | dict) or q is None:
        return False
    if hasattr(q, "ndim"):
        return bool(q.ndim != 1)
    return isinstance(q, list | tuple) and bool(q) and not isinstance(q[0], str) and hasattr(q[0], "__len__")


def jacobians(robot: Robot, Q: ArrayLike, view: MotionView, form: Form, parameters: Given) -> Table:  # noqa: N803
    """The Jacobians for many joint values, shape (N, n): shape (N, rows, joints); see `jacobian`."""
    q = joint_rows(robot, Q)
    lengths = parameter_values(robot, parameters)
    joints = moving_joints(robot, view)
    check_values(robot, view, form, {**lengths, **dict.fromkeys(robot.variables, Angle())})
    values = tuple(numbers(lengths).items())
    rows, columns = len(form.labels), len(joints)
    found = np.empty((len(q), rows, columns))
    players: dict[tuple[bool, int], Columns] = {}
    for first in range(0, len(q), BLOCK):
        block = q[first : first + BLOCK]
        kind = bool(np.abs(block).max(initial=0.0) <= MODEST), len(block)
        if kind not in players:
            players[kind] = Columns(recorded(robot, view, form, values, merged=kind[0]), len(block))
        played = players[kind].play(block.T)
        found[first : first + BLOCK] = played[: rows * columns].reshape(rows, columns, -1).transpose(2, 0, 1)
        if form.analytic:
            found[first : first + BLOCK][played[-1] < TINY**2] = np.nan
    found[~np.isfinite(q).all(axis=1)] = np.nan
    return found


@lru_cache(maxsize=32)
def recorded(robot: Robot, view: MotionView, form: Form, values: Known, *, merged: bool) -> Program:
    """The steps from joint values to the entries of a Jacobian, row by row.

    For rates of angles one number follows: the square of what vanishes where there are none.
    """
    joints = moving_joints(robot, view)
    tape = Tape(robot.variables, dict(values))
    linear, angular = six_rows(tuple(parts(robot, view, joints, merged=merged)), len(joints), tape)
    results: list[Number] = []
    if form.analytic:
        chain = between(robot, view.start, view.end)
        angular, square = rates_by(form, fold_rows(merge(chain) if merged else chain, tape), angular, tape)
        results = [square]
    return assemble(tape, [entry for row in form.chosen(linear, angular) for entry in row] + results)
