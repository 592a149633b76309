"""Many poses said in other ways, a row of numbers for each; the formulas are those of one pose, over numpy columns."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

from dhcli.errors import RobotError
from dhcli.geometry.euler import Order, RollPitchYaw
from dhcli.geometry.real_arrays import real_numbers
from dhcli.geometry.rotations import AxisAngle, Quaternion, RotationVector

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from dhcli.geometry.rotations import Rotation

    Column: TypeAlias = NDArray[np.float64]
    Table: TypeAlias = NDArray[np.float64]
    Form: TypeAlias = RollPitchYaw[Any] | Quaternion[Any] | AxisAngle[Any] | RotationVector[Any]


def roll_pitch_yaw(poses: Table) -> Table:
    """Roll, pitch and yaw of many poses [rad]: `R = Rz(yaw) Ry(pitch) Rx(roll)`, pitch in [-π/2, π/2].

    Args:
        poses: Matrices, shape (N, 4, 4), as `forward_batch` gives them.

    Returns:
        A row for each, shape (N, 3); at pitch ±π/2, where only one of roll and yaw can be told, roll is 0.

    Raises:
        RobotError: They have another shape; so for the other two.
    """
    return table(RollPitchYaw, poses)


def quaternions(poses: Table) -> Table:
    """Unit quaternions w, x, y, z with w >= 0 of many poses, shape (N, 4, 4): a row for each, shape (N, 4)."""
    return table(Quaternion, poses)


def axis_angles(poses: Table) -> Table:
    """A unit axis and an angle in [0, π] [rad] of many poses, shape (N, 4, 4): rows x, y, z, angle, shape (N, 4)."""
    return table(AxisAngle, poses)


def table(form: type[Form] | Order, poses: Table) -> Table:
    """The numbers of one form of rotation for many poses, shape (N, width)."""
    return np.stack(form.of(rotations(poses)).numbers, axis=1)


def rotations(poses: Table) -> Rotation[Column]:
    """The direction cosines of many poses, a column for each of the nine; the poses may be a list.

    Raises:
        RobotError: They have another shape, or something is no number.
    """
    table = real_numbers(poses, RobotError("poses are no array of numbers", "wanted: the shape (N, 4, 4)"))
    if table.ndim != 3 or table.shape[1:] != (4, 4):  # noqa: PLR2004  rows of matrices
        raise RobotError(
            f"poses have the shape (N, 4, 4), not {table.shape}", "one Pose has rpy, quaternion, axis_angle"
        )
    return [[table[:, i, k] for k in range(3)] for i in range(3)]
