"""Many poses said in other ways: the formulas of `orientation`, over columns."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from dhcli.errors import RobotError, UnknownNameError, did_you_mean
from dhcli.kinematics.orientation import TINY

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Table: TypeAlias = NDArray[np.float64]


def matrices(poses: Table) -> Table:
    """The upper three rows, row by row, shape (N, 12); the last one is always 0 0 0 1."""
    return poses[:, :3, :].reshape(len(poses), 12)


def positions(poses: Table) -> Table:
    """Where the origin is [m], shape (N, 3)."""
    return poses[:, :3, 3]


def roll_pitch_yaw(poses: Table) -> Table:
    """Roll, pitch and yaw of many poses [rad]: `R = Rz(yaw) Ry(pitch) Rx(roll)`, pitch in [-π/2, π/2].

    Args:
        poses: Matrices, shape (N, 4, 4), as `forward_batch` gives them.

    Returns:
        A row for each, shape (N, 3); at pitch ±π/2, where only one of roll and yaw can be told, roll is 0.

    Raises:
        RobotError: They have another shape; so for the other two.
    """
    poses = _checked(poses)
    r = poses[:, :3, :3]
    free = locked(poses)
    roll = np.where(free, 0.0, np.arctan2(r[:, 2, 1], r[:, 2, 2]))
    pitch = np.arctan2(-r[:, 2, 0], np.hypot(r[:, 0, 0], r[:, 1, 0]))
    yaw = np.where(free, np.arctan2(-r[:, 0, 1], r[:, 1, 1]), np.arctan2(r[:, 1, 0], r[:, 0, 0]))
    return np.stack([roll, pitch, yaw], axis=1)


def locked(poses: Table) -> NDArray[np.bool_]:
    """Where pitch is ±90° and only the sum or the difference of roll and yaw counts, shape (N,)."""
    return np.hypot(poses[:, 0, 0], poses[:, 1, 0]) < TINY


def quaternions(poses: Table) -> Table:
    """Unit quaternions w, x, y, z with w >= 0 of many poses, shape (N, 4, 4): a row for each, shape (N, 4)."""
    poses = _checked(poses)
    (r11, r12, r13), (r21, r22, r23), (r31, r32, r33) = np.moveaxis(poses[:, :3, :3], 0, -1)
    squares = (1 + r11 + r22 + r33, 1 + r11 - r22 - r33, 1 - r11 + r22 - r33, 1 - r11 - r22 + r33)
    choices = np.stack(
        [
            np.stack([squares[0], r32 - r23, r13 - r31, r21 - r12]),
            np.stack([r32 - r23, squares[1], r12 + r21, r31 + r13]),
            np.stack([r13 - r31, r12 + r21, squares[2], r23 + r32]),
            np.stack([r21 - r12, r31 + r13, r23 + r32, squares[3]]),
        ]
    )
    largest = np.argmax(np.stack(squares), axis=0)
    parts = choices[largest, :, np.arange(len(poses))]
    length = np.copysign(np.sqrt(np.sum(parts * parts, axis=1)), parts[:, 0])
    half = np.abs(parts[:, 0]) < TINY * np.abs(length)  # half a turn: the first part that is not zero is positive
    first = np.argmax(np.abs(parts[:, 1:]) > TINY, axis=1)
    leading = np.take_along_axis(parts[:, 1:], first[:, None], axis=1)[:, 0]
    turns: Table = parts / np.where(half, np.copysign(length, leading), length)[:, None]
    turns[:, 0] = np.abs(turns[:, 0])
    return turns


def axis_angles(poses: Table) -> Table:
    """A unit axis and an angle in [0, π] [rad] of many poses, shape (N, 4, 4): rows x, y, z, angle, shape (N, 4)."""
    turns = quaternions(poses)
    sine = np.sqrt(np.sum(turns[:, 1:] ** 2, axis=1))
    still = sine < TINY
    axes = np.where(still[:, None], (0.0, 0.0, 1.0), turns[:, 1:] / np.where(still, 1.0, sine)[:, None])
    angles = np.where(still, 0.0, 2 * np.arctan2(sine, turns[:, 0]))
    turned: Table = np.concatenate([axes, angles[:, None]], axis=1)
    return turned


FORMS: dict[str, Callable[[Table], Table]] = {
    "matrix": matrices,
    "position": positions,
    "rpy": roll_pitch_yaw,
    "quaternion": quaternions,
    "axis-angle": axis_angles,
}
"""Ways to say where a frame is, by the names a user gives them; each takes poses, shape (N, 4, 4)."""


def check_forms(forms: Iterable[str]) -> None:
    """Make sure that poses can be said in these ways.

    Raises:
        UnknownNameError: There is no such form.
    """
    for form in forms:
        if form not in FORMS:
            raise UnknownNameError(f"there is no way to say a pose as {form}", did_you_mean(form, FORMS))


def _checked(poses: Table) -> Table:
    """Poses in an array of the right shape; they may be a list of them."""
    table = np.asarray(poses, dtype=np.float64)
    if table.ndim != 3 or table.shape[1:] != (4, 4):  # noqa: PLR2004  rows of matrices
        raise RobotError(
            f"poses have the shape (N, 4, 4), not {table.shape}", "one Pose has rpy, quaternion, axis_angle"
        )
    return table
