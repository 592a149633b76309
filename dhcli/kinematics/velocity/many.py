"""Jacobians for people who compute: one or many, as numpy arrays."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Unpack, cast

import numpy as np

from dhcli.algebra.arrays import Array, library_of
from dhcli.algebra.tape import Number, Tape
from dhcli.errors import DhcliError
from dhcli.kinematics.batch import joint_rows, room
from dhcli.kinematics.fold import fold_rows
from dhcli.kinematics.forward import Given, plain_floats
from dhcli.kinematics.frames import between
from dhcli.kinematics.merge import merge
from dhcli.kinematics.playing import play
from dhcli.kinematics.recorded import Recording, kept
from dhcli.kinematics.robot import Robot, check_robot
from dhcli.kinematics.traced import shaped, trace
from dhcli.kinematics.values import JointInput, given_parameters, joint_values, numbers, parameter_values
from dhcli.kinematics.velocity.form import TINY, Form, Triple, Which, check_part
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

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import ArrayLike, DTypeLike, NDArray


def jacobian(  # noqa: PLR0913  each by its name
    robot: Robot,
    q: JointInput | ArrayLike = None,
    *,
    part: Which = "all",
    angular_first: bool = False,
    analytic: str = "",
    parameters: Given | None = None,
    dtype: DTypeLike | None = None,
    threads: int = 1,
    **viewing: Unpack[Viewing],
) -> NDArray[Any]:
    """The Jacobian of a robot in numbers: velocity of a point and of a frame for each joint's own.

    Args:
        robot: The robot.
        q: Joint values in radians and metres, in any form that `forward` takes; or many, shape (N, n), a row for each.
            An array of JAX, PyTorch or another library of the array API may have any shape (..., n), and gives one of
            its own.
        part: `all` six rows, or the three of v, `linear`, or of ω, `angular`.
        angular_first: Whether ω stands above v.
        analytic: Angles whose rates are wanted in the place of ω: `rpy`, or three axes such as `zyz`.
        parameters: Lengths and angles to use instead of the robot's own.
        dtype: Of many, float64 by default; with float32 each entry is worked out in double precision and rounded at the
            end, to 6e-8 of itself.
        threads: Of many, how many threads share the work.
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
    library = library_of(q)
    if not library and (floats := plain_floats(cast("JointInput", q), parameters)) is not None:
        played = _played(robot, floats, (part, angular_first, analytic), viewing)
        if played is not None:
            return played
    view = MotionView.of(robot, **viewing)
    form = form_of(part, angular_first, analytic)
    if library:
        only = {"dtype": dtype, "threads": None if threads == 1 else threads}
        return cast("NDArray[Any]", traced_jacobian(robot, q, view, form, parameters, (library, only)))
    if _is_many(q):
        return jacobians(robot, cast("ArrayLike", q), view, form, parameters, dtype=dtype, threads=threads)
    values = {**parameter_values(robot, parameters), **joint_values(robot, cast("JointInput", q))}
    return numeric_jacobian(robot, values, view, form).matrix


def _played(
    robot: Robot, q: Sequence[float], rows: tuple[Which, bool, str], viewing: Viewing
) -> NDArray[np.float64] | None:
    """One Jacobian by its recording, the same as by the fold; None where only that can tell what is wrong."""

    def record() -> tuple[Recording, tuple[int, int]]:
        part, angular_first, analytic = rows
        view, form = MotionView.of(robot, **viewing), form_of(part, angular_first, analytic)
        shape = len(form.labels), len(moving_joints(robot, view))
        return recorded_jacobian(robot, view, form), shape

    try:
        recording, shape = kept(robot, (rows, *viewing.items()), record)
        found = recording.again(q)
    except (TypeError, DhcliError):  # a point in a list is no key
        return None
    if found is None or (rows[2] and found[-1] < TINY**2):
        return None
    return np.array(found[:-1] if rows[2] else found).reshape(shape)


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
    form = form_of(part, angular_first, analytic)
    values = {**given_parameters(robot, parameters), **joint_values(robot, q)}
    return textbook_jacobian(robot, values, view, form)


def form_of(part: object, angular_first: bool, analytic: object) -> Form:  # noqa: FBT001  in the order of `Form`
    """The form that is meant.

    Raises:
        RobotError: There is no such part.
        UnknownNameError: There are no such angles.
    """
    check_part(part)
    if not isinstance(analytic, str) or analytic:
        Triple.called(str(analytic))
    return Form(cast("Which", part), angular_first, str(analytic))


def _is_many(q: object) -> bool:
    """Whether joint values are rows of them."""
    if isinstance(q, str | dict) or q is None:
        return False
    if hasattr(q, "ndim"):
        return bool(q.ndim != 1)
    return isinstance(q, list | tuple) and bool(q) and not isinstance(q[0], str) and hasattr(q[0], "__len__")


def jacobians(  # noqa: PLR0913  each by its name
    robot: Robot,
    Q: ArrayLike,  # noqa: N803
    view: MotionView,
    form: Form,
    parameters: Given | None,
    *,
    dtype: DTypeLike | None = None,
    threads: int = 1,
) -> NDArray[Any]:
    """The Jacobians for many joint values, shape (N, n): shape (N, rows, joints); see `jacobian`."""
    q = joint_rows(robot, Q)
    recording = recorded_jacobian(robot, view, form, parameters)
    shape = len(q), len(form.labels), len(moving_joints(robot, view))
    found = room(None, shape, dtype)
    if form.analytic:
        entries = np.empty((len(q), shape[1] * shape[2] + 1))
        play(recording, q, entries, threads)
        found[...] = entries[:, :-1].reshape(shape)
        found[entries[:, -1] < TINY**2] = np.nan
    else:
        play(recording, q, found, threads)
    with np.errstate(all="ignore"):
        is_finite = np.isfinite(q.sum())  # much sooner had than a look at every row
    if not is_finite:
        found[~np.isfinite(q).all(axis=1)] = np.nan
    return found


def traced_jacobian(
    robot: Robot,
    q: Array,
    view: MotionView,
    form: Form,
    parameters: Given | None,
    library: tuple[str, Mapping[str, object]],
) -> Array:
    """The Jacobians for an array of another library, shape (..., n): shape (..., rows, joints); see `trace`."""
    shape = len(form.labels), len(moving_joints(robot, view))
    found, q, xp = trace(robot, recorded_jacobian(robot, view, form, parameters), q, *library)
    is_there = xp.all(xp.isfinite(q), axis=-1)
    if form.analytic:
        found, square = found[..., :-1], found[..., -1]
        is_there = is_there & (square >= TINY**2)
    return shaped(xp.where(is_there[..., None], found, xp.full_like(found, xp.nan)), q, xp, shape)


def recorded_jacobian(robot: Robot, view: MotionView, form: Form, parameters: Given | None = None) -> Recording:
    """The entries of a Jacobian, row by row, kept with the robot.

    For rates of angles one number follows: the square of what vanishes where there are none.

    Raises:
        RobotError: A name has no value, or nothing moves.
    """
    values = None if parameters is None else numbers(parameter_values(robot, parameters))

    def record() -> Recording:
        known = numbers(parameter_values(robot, {})) if values is None else values
        joints = moving_joints(robot, view)
        check_values(robot, view, form, {**known, **dict.fromkeys(robot.variables, Angle())})

        def entries(tape: Tape, merged: bool) -> list[Number]:  # noqa: FBT001  called by `Recording` alone
            linear, angular = six_rows(tuple(parts(robot, view, joints, merged=merged)), len(joints), tape)
            results: list[Number] = []
            if form.analytic:
                chain = between(robot, view.start, view.end)
                angular, square = rates_by(form, fold_rows(merge(chain) if merged else chain, tape), angular, tape)
                results = [square]
            return [entry for row in form.chosen(linear, angular) for entry in row] + results

        return Recording(robot.variables, known, entries)

    return kept(robot, (view, form, None if values is None else tuple(values.items())), record)
