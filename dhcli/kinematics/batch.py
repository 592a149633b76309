"""Forward kinematics of many poses at once: one fold over numpy columns, block by block."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from dhcli.algebra.columns import Columns
from dhcli.errors import RobotError
from dhcli.kinematics.fold import fold
from dhcli.kinematics.forward import Given
from dhcli.kinematics.frames import between, ends
from dhcli.kinematics.merge import merge
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.values import numbers, parameter_values, require
from dhcli.notation.angle import Angle

BLOCK = 4096
"""Poses at a time: so many that the overhead of numpy is spread, so few that all columns stay in the cache."""

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


def forward_batch(
    robot: Robot,
    Q: ArrayLike,  # noqa: N803  the field's name for a matrix of joint values
    *,
    start: str | int | None = None,
    end: str | int | None = None,
    parameters: Given | None = None,
    out: NDArray[np.float64] | None = None,
) -> NDArray[np.float64]:
    """Poses of a frame of a robot for many joint values, in numbers.

    Args:
        robot: The robot.
        Q: Joint values, shape (N, n), a row for each pose in joint order; radians and metres.
        start: The frame it is seen from; the first numbered one by default.
        end: The frame described; the last numbered one by default.
        parameters: Lengths and angles to use instead of the robot's own.
        out: Where to put the result, shape (N, 4, 4).

    Returns:
        The poses, shape (N, 4, 4), translation in metres; NaN where a joint value is no finite number.

    Raises:
        RobotError: Q or `out` has another shape, or a length has no value.
        UnknownNameError: The robot has no such frame or length.
    """
    q = np.asarray(Q, dtype=np.float64)
    wanted = len(robot.variables)
    if q.ndim != 2 or q.shape[1] != wanted:  # noqa: PLR2004  rows and columns
        raise RobotError(f"{robot.name} has {wanted} joints; Q has the shape {q.shape}, not (N, {wanted})")
    poses = np.empty((len(q), 4, 4)) if out is None else out
    if poses.shape != (len(q), 4, 4) or poses.dtype != np.float64:
        raise RobotError(f"out has the shape {poses.shape} of {poses.dtype}, not {(len(q), 4, 4)} of float64")
    chain = between(robot, *ends(robot, start, end))
    lengths = parameter_values(robot, parameters or {})
    require(robot, chain, {**lengths, **dict.fromkeys(robot.variables, Angle())})
    known = {n: v.constant() if isinstance(v, Angle) else v for n, v in numbers(lengths).items()}
    merged = merge(chain)  # parallel joints turn once: fewer sines, and far fewer products
    for first in range(0, len(q), BLOCK):
        block = np.ascontiguousarray(q[first : first + BLOCK].T)
        columns = dict(zip(robot.variables, block, strict=True))
        with np.errstate(invalid="ignore"):  # what is no number gives a pose that is none
            rows = fold(merged, Columns({**known, **columns}))
        for i, row in enumerate(rows):
            for k, entry in enumerate(row):
                poses[first : first + BLOCK, i, k] = entry
    return poses
