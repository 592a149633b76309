"""How well an arm moves at some joint values: rank with its singular values, manipulability, condition, ellipsoid."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, TypeAlias, Unpack

import numpy as np

from dhcli.frozen import frozen
from dhcli.geometry.rank import decided
from dhcli.kinematics.robot import Robot, check_robot
from dhcli.kinematics.velocity.form import Which, check_part
from dhcli.kinematics.velocity.many import jacobian
from dhcli.kinematics.velocity.view import MotionView, Viewing

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from dhcli.kinematics.forward import Given
    from dhcli.kinematics.values import JointInput

    Table: TypeAlias = NDArray[np.float64]

NEAR_AXIS = 1e-6
"""A direction this close to an axis is said to be along it."""


@frozen
class Measures:
    """How well an arm moves.

    Attributes:
        rank: Singular values that are not zero.
        values: Singular values, largest first; they mix metres and radians where v and ω are both asked for.
        manipulability: Their product, Yoshikawa's w; for as many joints as rows the size of the determinant.
        condition: The largest over the least, or None where that is zero.
        directions: For each singular value the direction of the velocity it belongs to, a unit vector of the rows.
    """

    rank: int
    values: tuple[float, ...]
    manipulability: float
    condition: float | None
    directions: tuple[tuple[float, ...], ...]

    @property
    def least(self) -> float:
        """The least singular value: the slowest the end moves for joint rates of size 1."""
        return self.values[-1] if self.values else 0.0


def measures_of(matrix: ArrayLike, rows: Sequence[int] | None = None) -> Measures:
    """The measures of one Jacobian.

    Args:
        matrix: The Jacobian, shape (rows, joints).
        rows: The rows that count; those which no joint can ever move, such as the one that leads out of the plane of a
            planar arm, would make every volume 0. All by default.

    Source: T. Yoshikawa, Manipulability of robotic mechanisms, IJRR 4, 1985.
    """
    table = np.asarray(matrix, dtype=np.float64)
    kept = list(range(len(table)) if rows is None else rows)
    left, values, _ = np.linalg.svd(table[kept], full_matrices=False)
    directions = np.zeros((len(values), len(table)))
    directions[:, kept] = left.T
    largest = float(values[0]) if len(values) else 0.0
    rank = decided(values).rank
    full = 0 < rank == len(values)
    return Measures(
        rank,
        tuple(map(float, values)),
        float(np.prod(values)) if full else 0.0,
        largest / float(values[-1]) if full else None,
        tuple(tuple(map(float, _pointed(row))) for row in directions),
    )


def _pointed(direction: Table) -> Table:
    """A direction and its opposite are one: the sense in which its largest component is positive, nothing for noise."""
    largest = direction[np.argmax(np.abs(direction))]
    clean = np.where(np.abs(direction) < NEAR_AXIS, 0.0, direction)
    turned: Table = clean * np.sign(largest) + 0.0
    return turned


def manipulability(
    robot: Robot,
    q: JointInput | ArrayLike = None,
    *,
    part: Which | None = None,
    parameters: Given | None = None,
    **viewing: Unpack[Viewing],
) -> float | Table:
    """Yoshikawa's manipulability √det(J Jᵀ): the volume that joint rates of size 1 fill, up to a constant.

    Args:
        robot: The robot.
        q: Joint values in any form that `forward` takes; or many, shape (N, n), a row for each [rad and m].
        part: The rows: `all`, `linear` or `angular`; by default those that `singularities` takes for the task.
        parameters: Lengths and angles to use instead of the robot's own.
        **viewing: Between which frames, of which point; see `Viewing`.

    Returns:
        A number, or shape (N,), NaN where a joint value is: with fewer joints than rows √det(Jᵀ J). Rows that no joint
        can ever move are left aside, and for as many joints as rows it is the size of the determinant. In m for each
        joint that moves the point.

    Raises:
        RobotError: A value is missing or no number, or no joint moves `end`.
        UnknownNameError: The robot has no such frame, joint or length.
    """
    from dhcli.kinematics.singular.task import task_at

    check_robot(robot)
    if part is not None:
        check_part(part)
    rows, kept = task_at(robot, MotionView.of(robot, **viewing), part)
    found = jacobian(robot, q, part=rows, parameters=parameters, **viewing)
    if found.ndim == 2:  # noqa: PLR2004  one matrix
        return measures_of(found, kept).manipulability
    good = np.isfinite(found).all(axis=(1, 2))
    volumes = np.full(len(found), np.nan)
    volumes[good] = np.prod(np.linalg.svd(found[good][:, kept], compute_uv=False), axis=-1)
    return volumes
