"""Forward kinematics of many poses at once: the fold is recorded once and played over all rows."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, cast

import numpy as np

from dhcli.algebra.arrays import library_of
from dhcli.errors import RobotError, plural
from dhcli.geometry.real_arrays import real_numbers
from dhcli.kinematics.forward import Given
from dhcli.kinematics.frames import ends
from dhcli.kinematics.playing import play
from dhcli.kinematics.recorded import recorded_pose
from dhcli.kinematics.robot import Robot, check_robot
from dhcli.kinematics.traced import shaped, trace
from dhcli.kinematics.values import numbers, parameter_values

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, DTypeLike, NDArray

KINDS = (np.dtype(np.float64), np.dtype(np.float32))
"""Numbers in which results are given."""


def forward_batch(  # noqa: PLR0913  each by its name
    robot: Robot,
    Q: ArrayLike,  # noqa: N803  the field's name for a matrix of joint values
    *,
    start: str | int | None = None,
    end: str | int | None = None,
    parameters: Given | None = None,
    out: NDArray[Any] | None = None,
    dtype: DTypeLike | None = None,
    threads: int = 1,
) -> NDArray[Any]:
    """Poses of a frame of a robot for many joint values, in numbers.

    Args:
        robot: The robot.
        Q: Joint values, shape (N, n), a row for each pose in joint order; radians and metres. An array of JAX, PyTorch
            or another library of the array API may have any shape (..., n), and is only computed with, never looked at.
        start: The frame it is seen from; the first numbered one by default.
        end: The frame described; the last numbered one by default.
        parameters: Lengths and angles to use instead of the robot's own.
        out: Where to put the result, shape (N, 4, 4), of float64 or float32.
        dtype: float64 by default; with float32, or an `out` of it, each entry is worked out in double precision and
            rounded at the end, to 6e-8 of itself.
        threads: How many threads share the work.

    Returns:
        The poses, shape (N, 4, 4), translation in metres; NaN or infinite where a joint value is. For an array of
        another library one of that library, of its kind and on its device, shape (..., 4, 4).

    Raises:
        RobotError: Q or `out` has another shape, Q holds something else than real numbers, `out` cannot be written
            to, there is no such dtype or number of threads, or a length has no value.
        UnknownNameError: The robot has no such frame or length.
    """
    check_robot(robot)
    frames = ends(robot, start, end)
    values = None if parameters is None else numbers(parameter_values(robot, parameters))
    recording = recorded_pose(robot, *frames, values)
    if library := library_of(Q):
        only = {"out": out, "dtype": dtype, "threads": None if threads == 1 else threads}
        return cast("NDArray[Any]", shaped(*trace(robot, recording, Q, library, only), (4, 4)))
    q = joint_rows(robot, Q)
    poses = room(out, (len(q), 4, 4), dtype)
    play(recording, q, poses, threads)
    return poses


def joint_rows(robot: Robot, Q: ArrayLike) -> NDArray[np.float64]:  # noqa: N803
    """Joint values of many poses as an array, shape (N, n).

    Raises:
        RobotError: They have another shape, or something is no real number.
    """
    wanted = len(robot.variables)
    none = RobotError("Q is no array of numbers", f"wanted: rows of {plural(wanted, 'number')}, all as long")
    q = real_numbers(Q, none)
    if q.ndim != 2 or q.shape[1] != wanted:  # noqa: PLR2004  rows and columns
        raise RobotError(f"{robot.name} has {plural(wanted, 'joint')}; Q has the shape {q.shape}, not (N, {wanted})")
    return q


def room(out: object, shape: tuple[int, ...], dtype: DTypeLike | None) -> NDArray[Any]:
    """Where a result goes: new memory, or what a caller gives, if it fits.

    Raises:
        RobotError: That is no array, or one of another shape or kind, or one that nobody may write to; or there is no
            such kind of number.
    """
    try:
        kind = np.dtype(np.float64 if dtype is None else dtype)
    except (ValueError, TypeError):
        raise RobotError(f"dtype is no kind of number: {dtype!r:.60}", "float64 or float32") from None
    if kind not in KINDS:
        raise RobotError(f"results are no numbers of {kind}", "float64 or float32")
    if out is None:
        return np.empty(shape, kind)
    if not isinstance(out, np.ndarray):
        raise RobotError(f"out is no numpy array but {type(out).__name__}", f"np.empty({shape}) makes one")
    kinds = KINDS if dtype is None else (kind,)
    if out.shape != shape or out.dtype not in kinds:
        wanted = " or ".join(map(str, kinds))
        raise RobotError(f"out has the shape {out.shape} of {out.dtype}, not {shape} of {wanted}")
    if not out.flags.writeable:
        raise RobotError("out is read-only", "give an array of your own, or leave out= out")
    return out
