"""Velocities from joint rates, and joint rates from velocities: least squares, damped on request, never infinite."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, TypeAlias, Unpack

import numpy as np

from dhcli.errors import RobotError, plural
from dhcli.frozen import frozen
from dhcli.geometry.rank import decided, rank_of
from dhcli.kinematics.forward import Given
from dhcli.kinematics.given import real
from dhcli.kinematics.robot import Robot, check_robot
from dhcli.kinematics.values import JointInput, Values, joint_values, parameter_values, size
from dhcli.kinematics.velocity.form import Form, Which, part_of
from dhcli.kinematics.velocity.jacobian import numeric_jacobian
from dhcli.kinematics.velocity.statics import three_numbers
from dhcli.kinematics.velocity.view import MotionView, Viewing, check_rates

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Table: TypeAlias = NDArray[np.float64]

REACHED = 1e-9
"""A velocity is reached if what is left of it is below this share of its size."""


@frozen
class Rates:
    """Joint rates and the velocity that they give.

    Attributes:
        values: For each joint its rate [rad/s, or m/s of a slide].
        joints: Their names.
        wanted: The velocity asked for, v above ω [m/s, rad/s], as many of the six as were given.
        reached: The velocity that the rates give.
        labels: What each row of the two is.
        rank: The rank of the Jacobian.
        full: The rank that a Jacobian of this shape can have.
        damping: The damping λ that was asked for, 0 for none.
        idle: Rates that leave all those rows at rest, rows of unit length: self-motions of a redundant arm.
        view: Of which frame and point, along which axes.
    """

    values: tuple[float, ...]
    joints: tuple[str, ...]
    wanted: tuple[float, ...]
    reached: tuple[float, ...]
    labels: tuple[str, ...]
    rank: int
    full: int
    damping: float
    idle: tuple[tuple[float, ...], ...]
    view: MotionView

    def __repr__(self) -> str:
        """One line, as the prompt shows it: radians and metres a second."""
        rates = ", ".join(
            f"{name}' = {round(rate, 4) + 0:g}" for name, rate in zip(self.joints, self.values, strict=True)
        )
        return f"<Rates {rates}{'' if self.is_reached else '; the velocity is not reached'}>"

    @property
    def is_reached(self) -> bool:
        """Whether the rates give the velocity that was asked for."""
        left = max(abs(a - b) for a, b in zip(self.wanted, self.reached, strict=True))
        return left <= REACHED * max(map(abs, self.wanted), default=0.0)

    @property
    def warnings(self) -> tuple[str, ...]:
        """What a person should know of them."""
        if self.damping:
            return (f"damped by {self.damping:g}: the velocity is reached only in part",)
        if self.is_reached:
            return ()
        if self.rank < self.full:
            here = f"the arm is singular here (rank {self.rank} of {self.full})"
            return (f"{here}: near this pose the velocity takes rates without bound, at it none give it",)
        joints = len(self.joints)
        return (f"{plural(joints, 'joint')} cannot make every velocity; these rates come nearest",)


def joint_rates(
    robot: Robot,
    q: JointInput = None,
    velocity: Iterable[float] | None = None,
    angular: Iterable[float] | None = None,
    *,
    damping: float = 0.0,
    parameters: Given | None = None,
    **viewing: Unpack[Viewing],
) -> Rates:
    """The joint rates for a velocity of the end, the smallest that come nearest to it.

    Args:
        robot: The robot.
        q: Joint values in any form that `forward` takes.
        velocity: The velocity of the point, shape (3,) [m/s]; without it any will do.
        angular: The angular velocity of the end, shape (3,) [rad/s]; without it any will do.
        damping: λ of damped least squares, (JᵀJ + λ²)⁻¹ Jᵀ v, which keeps rates small near singular poses; 0 for none.
        parameters: Lengths and angles to use instead of the robot's own.
        **viewing: Between which frames, along which axes, of which point; see `Viewing`.

    Returns:
        The rates, the velocity they give, and self-motions. At a singular pose they are finite, and `warnings` says
        that the velocity is not reached.

    Raises:
        RobotError: A value is missing or no number, or no velocity is given.
        UnknownNameError: The robot has no such frame, joint or length.

    Source: Y. Nakamura and H. Hanafusa, Inverse kinematic solutions with singularity robustness, 1986.
    """
    check_robot(robot)
    view = MotionView.of(robot, **viewing)
    values = {**parameter_values(robot, parameters), **joint_values(robot, q)}
    return rates_at(robot, values, view, velocity, angular, damping)


def rates_at(
    robot: Robot,
    values: Values,
    view: MotionView,
    velocity: Iterable[float] | None,
    angular: Iterable[float] | None,
    damping: float,
) -> Rates:
    """The same at known values; see `joint_rates`."""
    if velocity is None and angular is None:
        raise RobotError("rates of the joints need a velocity, or an angular velocity", "velocity=(0.1, 0, 0)")
    damping = size(damping, "damping")
    part = part_of(velocity, angular)
    found = numeric_jacobian(robot, values, view, Form(part))
    wanted = [
        *(three_numbers(velocity, "a velocity") if velocity is not None else ()),
        *(three_numbers(angular, "an angular velocity") if angular is not None else ()),
    ]
    matrix = found.matrix
    left, sizes, right = np.linalg.svd(matrix)
    rank = decided(sizes).rank
    kept = sizes[:rank]
    factors = kept / (kept**2 + damping**2)
    rates = right[:rank].T @ (factors * (left[:, :rank].T @ np.array(wanted)))
    return Rates(
        tuple(map(float, rates + 0.0)),
        found.joints,
        tuple(wanted),
        tuple(map(float, matrix @ rates)),
        found.labels,
        rank,
        _full_rank(matrix, robot, values, view, part),
        damping,
        tuple(tuple(map(float, row)) for row in _fewest(right[rank:])),
        view,
    )


def _fewest(rows: Table) -> Table:
    """Rows of unit length that span the same, each of them with a joint that none of the others moves."""
    rows = rows.copy()
    pivots: list[int] = []
    for k in range(len(rows)):
        pivots.append(int(np.abs(rows[k]).argmax()))
        shares = rows[:, pivots[k]] / rows[k, pivots[k]]
        shares[k] = 0
        rows -= shares[:, None] * rows[k]
    signs = np.sign(rows[np.arange(len(rows)), pivots])[:, None]
    rows = rows[np.argsort(pivots)] * signs[np.argsort(pivots)]
    return np.asarray(rows / np.linalg.norm(rows, axis=1, keepdims=True))


def _full_rank(matrix: Table, robot: Robot, values: Values, view: MotionView, part: Which) -> int:
    """The rank at almost all joint values, by two that have nothing special about them."""
    from dhcli.notation.angle import Angle
    from dhcli.notation.tree import number

    ranks = [rank_of(matrix).rank]
    for seed in (1, 2):
        other = dict(values)
        for k, name in enumerate(robot.variables):
            other[name] = Angle.in_degrees(37 * seed + 53 * k) if name in robot.angles else number(seed + k)
        elsewhere = numeric_jacobian(robot, other, view, Form(part)).matrix
        ranks.append(rank_of(elsewhere).rank)
    return max(ranks)


def velocity_of(
    robot: Robot,
    q: JointInput,
    rates: Iterable[float],
    *,
    parameters: Given | None = None,
    **viewing: Unpack[Viewing],
) -> tuple[float, ...]:
    """The velocity of a point and of a frame for joint rates: v above ω, J q'.

    Args:
        robot: The robot.
        q: Joint values in any form that `forward` takes.
        rates: The rate of each joint between the two frames [rad/s, or m/s of a slide].
        parameters: Lengths and angles to use instead of the robot's own.
        **viewing: Between which frames, along which axes, of which point; see `Viewing`.

    Returns:
        Three numbers [m/s] and three [rad/s].

    Raises:
        RobotError: A value is missing or no number, or there are too many or too few rates.
    """
    check_robot(robot)
    view = MotionView.of(robot, **viewing)
    values = {**parameter_values(robot, parameters), **joint_values(robot, q)}
    found = numeric_jacobian(robot, values, view)
    return moved(found.rows, found.joints, rates)


def moved(rows: Sequence[Sequence[float]], joints: Sequence[str], rates: Iterable[float]) -> tuple[float, ...]:
    """Rows of a Jacobian times joint rates.

    Raises:
        RobotError: There are too many or too few rates, or one is no real number.
    """
    try:
        given = [*map(real, rates)]
    except (TypeError, ValueError):
        raise RobotError(f"rates are numbers, not {rates!r:.60}") from None
    check_rates(given, joints)
    if not np.isfinite(given).all():
        raise RobotError("a rate is not a real number")
    return tuple(float(np.dot(row, given)) for row in rows)
