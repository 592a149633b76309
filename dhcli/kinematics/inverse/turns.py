"""Limits and turns: an angle is the same after a turn, and only some turns are inside a joint's limits."""

from __future__ import annotations

from dataclasses import replace
from itertools import islice, product
from typing import TYPE_CHECKING

import numpy as np

from dhcli.errors import plural
from dhcli.kinematics.derived import in_floats
from dhcli.kinematics.inverse.solutions import Beyond, Solutions, shown_beyond, turning_joints
from dhcli.kinematics.limits import SLACK, far_limits
from dhcli.kinematics.robot import Robot, check_robot

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from dhcli.kinematics.inverse.arm import Array

MOST_TURNS = 4096
"""Solutions at most that one becomes in all its turns."""


def limits_of(robot: Robot) -> Array:
    """The limits of the joints in radians and metres.

    >>> from dhcli import limits_of, load_robot
    >>> limits_of(load_robot("puma560")).round(4)[:2].tolist()
    [[-2.7925, 2.7925], [-3.927, 0.7854]]

    Args:
        robot: The robot.

    Returns:
        Lowest and highest value of each variable, shape (n, 2) [rad, or m of a slide]; infinite where it has none.

    Raises:
        RobotError: It is no robot.
    """
    check_robot(robot)
    result = np.tile([-np.inf, np.inf], (len(robot.variables), 1))
    for k, name in enumerate(robot.variables):
        if name in robot.limits:
            result[k] = [in_floats(limit) for limit in robot.limits[name]]
    return result


def at_rest(robot: Robot) -> Array:
    """Where joints that may be chosen stand if nothing is said: at 0, or in the middle of their limits, shape (n,)."""
    low, high = limits_of(robot).T
    with np.errstate(invalid="ignore"):
        return np.nan_to_num(np.where((low <= 0) & (high >= 0), 0.0, (low + high) / 2))


def placed(
    answer: Solutions,
    near: Array | None,
    *,
    within_limits: bool,
    all_turns: bool,
    periodic: NDArray[np.bool_] | None = None,
) -> Solutions:
    """Solutions with each angle in the turn that its limits allow, nearest first.

    Args:
        answer: The solutions, angles from -180° to 180°.
        near: Joint values that they should be near to; without them the order stays.
        within_limits: Whether those outside are left out.
        all_turns: Whether each is given in every turn that the limits allow.
        periodic: Which values may change by a turn; by default those of all joints that turn.
    """
    robot = answer.robot
    limits = limits_of(robot)
    turning = turning_joints(robot) if periodic is None else periodic
    rows, origin = list["Array"](), list[int]()
    for k, q in enumerate(answer.q):
        choices = [
            _turns(x, limits[j], turns=bool(turning[j]), near=near if near is None else near[j])
            for j, x in enumerate(q)
        ]
        many = islice(product(*choices), MOST_TURNS) if all_turns else [tuple(values[0] for values in choices)]
        for values in many:
            rows.append(np.array(values))
            origin.append(k)
    table = np.array(rows).reshape(-1, len(robot.variables))
    beyond = [outside(robot, row, limits) for row in table]
    order = list(range(len(table)))
    if near is not None:
        order.sort(key=lambda k: round(float(np.linalg.norm(table[k] - near)), 9))
    at = [origin[k] for k in order]
    residual = np.zeros(len(answer)) if answer.residual is None else answer.residual
    every = replace(
        answer,
        q=table[order],
        branches=tuple(answer.branches[k] for k in at),
        residual=residual[at],
        beyond=tuple(beyond[k] for k in order),
        free=tuple(answer.free[k] for k in at),
        factors=answer.factors if len(at) == len(answer) else (),
    )
    return inside_only(every) if within_limits else every


def inside_only(every: Solutions) -> Solutions:
    """The solutions inside the limits; with what keeps the others out, if they are all."""
    inside = np.flatnonzero(every.within_limits).tolist()
    out = np.flatnonzero(~every.within_limits).tolist()
    why = "" if inside else _all_outside(every.robot, list(every.beyond))
    return replace(every.take(inside), why=why, left_out=every.take(out) if out else None)


def _turns(x: float, limits: Array, *, turns: bool, near: float | None) -> list[float]:
    """A value in each turn inside the limits, the nearest first; outside, the one that is least so."""
    low, high = limits
    if not turns:
        return [float(x)]
    aim = 0.0 if near is None else near
    if not (np.isfinite(low) and np.isfinite(high)):
        return [float(x + 2 * np.pi * np.round((aim - x) / (2 * np.pi)))]
    first = int(np.ceil((low - SLACK - x) / (2 * np.pi)))
    last = int(np.floor((high + SLACK - x) / (2 * np.pi)))
    found = [float(x + 2 * np.pi * k) for k in range(first, last + 1)]
    if found:
        return sorted(found, key=lambda value: (round(abs(value - aim), 9), value))
    around = [float(x + 2 * np.pi * k) for k in (last, first)]
    return [min(around, key=lambda value: max(low - value, value - high))]


def outside(robot: Robot, q: Array, limits: Array) -> tuple[Beyond, ...]:
    """What is outside its limits at some values, on either side of the drives."""
    found = []
    for name, x, (low, high) in zip(robot.variables, q.tolist(), limits.tolist(), strict=True):
        if x > high + SLACK:
            found.append(Beyond(name, x - high))
        elif x < low - SLACK:
            found.append(Beyond(name, x - low))
    far = far_limits(robot)
    if far is not None:
        found += [Beyond(name, by) for name, _, by in far.beyond(q.tolist(), SLACK)]
    return tuple(found)


def _all_outside(robot: Robot, beyond: list[tuple[Beyond, ...]]) -> str:
    """What keeps every solution from being inside the limits, by the one that is least outside."""
    least = min(beyond, key=lambda outside: (len(outside), sum(abs(each.by) for each in outside)))
    words = ", ".join(shown_beyond(robot, outside) for outside in least)
    count = f"{plural(len(beyond), 'solution')} {'is' if len(beyond) == 1 else 'are all'}"
    return f"{count} outside the limits, the nearest to them with {words}"


def in_turn(robot: Robot, q: Array, near: Array | None) -> Array:
    """Joint values (M, n) with angles in the turn that the limits allow, or the nearest one to what is wanted."""
    turning = turning_joints(robot)
    if near is not None:
        q = np.where(turning, q - 2 * np.pi * np.round((q - near) / (2 * np.pi)), q)
    if not robot.limits:
        return q
    low, high = limits_of(robot).T
    with np.errstate(invalid="ignore"):
        up = np.where(q < low - SLACK, np.ceil((low - SLACK - q) / (2 * np.pi)), 0.0)
        down = np.where(q > high + SLACK, np.floor((high + SLACK - q) / (2 * np.pi)), 0.0)
    moved = np.where(turning, q + 2 * np.pi * (up + down), q)
    inside = (moved >= low - SLACK) & (moved <= high + SLACK)
    return np.where(inside, moved, q)


def are_inside(robot: Robot, q: Array) -> NDArray[np.bool_]:
    """Which joint values (M, n) are inside all limits, shape (M,)."""
    low, high = limits_of(robot).T
    return np.asarray(((q >= low - SLACK) & (q <= high + SLACK)).all(axis=1))
