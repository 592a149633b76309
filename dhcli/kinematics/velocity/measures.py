"""How well an arm moves at some joint values: rank with its singular values, manipulability, condition, ellipsoid."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeAlias, Unpack

import numpy as np

from dhcli.errors import RobotError
from dhcli.kinematics.velocity.many import jacobian
from dhcli.kinematics.velocity.view import View, Viewing

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from dhcli.kinematics.forward import Given
    from dhcli.kinematics.robot import Robot
    from dhcli.kinematics.values import JointInput
    from dhcli.kinematics.velocity.jacobian import Which

    Table: TypeAlias = NDArray[np.float64]

TIGHT = 1e-9
"""Relative to the largest, below this a singular value counts as zero."""

NEAR_AXIS = 1e-6
"""A direction this close to an axis is said to be along it."""


@dataclass(frozen=True, slots=True)
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


def measures_of(matrix: ArrayLike) -> Measures:
    """The measures of one Jacobian, shape (rows, joints).

    Rows of zeros only, such as those of a planar arm that lead out of its plane, are left aside.

    Source: T. Yoshikawa, Manipulability of robotic mechanisms, IJRR 4, 1985.
    """
    table = np.asarray(matrix, dtype=np.float64)
    filled = np.abs(table).max(axis=1, initial=0.0) > TIGHT * np.abs(table).max(initial=0.0)
    directions = np.zeros((0, len(table)))
    values = np.zeros(0)
    if filled.any():
        left, values, _ = np.linalg.svd(table[filled], full_matrices=False)
        directions = np.zeros((len(values), len(table)))
        directions[:, filled] = left.T
    largest = float(values[0]) if len(values) else 0.0
    rank = int(np.count_nonzero(values > TIGHT * largest)) if largest > 0 else 0
    full = 0 < rank == len(values)
    return Measures(
        rank,
        tuple(map(float, values)),
        float(np.prod(values)) if len(values) else 0.0,
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
        A number, or shape (N,): with fewer joints than rows √det(Jᵀ J). Rows that no joint moves are left aside, and
        for as many joints as rows it is the size of the determinant. In m for each joint that moves the point.

    Raises:
        RobotError: A value is missing or no number, or no joint moves `end`.
        UnknownNameError: The robot has no such frame, joint or length.
    """
    from dhcli.kinematics.singular.finding import task_by_default

    rows = part or task_by_default(robot, View.of(robot, **viewing))
    found = jacobian(robot, q, part=rows, parameters=parameters, **viewing)
    if found.ndim == 2:  # noqa: PLR2004  one matrix
        return measures_of(found).manipulability
    filled = (np.abs(np.nan_to_num(found)).max(axis=(0, 2), initial=0.0)) > TIGHT
    chosen = found[:, filled]
    if not chosen.size:
        return np.zeros(len(found))
    good = np.isfinite(chosen).all(axis=(1, 2))
    volumes = np.full(len(found), np.nan)
    volumes[good] = np.prod(np.linalg.svd(chosen[good], compute_uv=False), axis=-1)
    return volumes


def check_real(values: Table, what: str) -> None:
    """Make sure that all numbers are real ones.

    Raises:
        RobotError: One is not.
    """
    if not np.isfinite(values).all():
        raise RobotError(f"{what} holds something that is not a real number")
