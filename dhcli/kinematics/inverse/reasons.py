"""Why a pose cannot be reached: which part of it can, what keeps the rest, and how near the arm comes."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from dhcli.geometry.twists import cross
from dhcli.kinematics.inverse.polishing import lines, product, products
from dhcli.kinematics.inverse.prepared import Prepared

if TYPE_CHECKING:
    from dhcli.kinematics.inverse.arm import Arm, Array
    from dhcli.kinematics.inverse.tasks import Task

_SAMPLES = 40
_CONSTANT = 1e-9
"""What varies by less over random poses of the arm is always the same."""

_STARTS = 24
"""Joint values from which the nearest reachable pose is looked for."""

_ROUNDS = 60

_REACHED = 1e-30
"""Half a sum of squares below which the pose itself is reached."""

_SETTLED, _STUCK = 1e-9, 1e3
"""By which share a sum of squares shrinks at most where it is the least one there; how strongly a step is held back
where none makes it smaller."""


def what_never_changes(
    arm: Arm, task: Task, pose: Array, mix: Array | None = None, zero: Array | None = None
) -> Iterator[str]:
    """What is the same in every pose of the end, and is not so in the pose asked for, in words.

    Args:
        arm: The arm.
        task: What is wanted.
        pose: The pose asked for, in the start frame, shape (4, 4) [m].
        mix: Motions for each unit of the variables that make them, shape (m, n); by default each joint has its own.
        zero: Motions where those are 0, shape (m,).
    """
    mix = np.eye(arm.joints) if mix is None else mix
    drawn = np.random.default_rng(11).uniform(-2, 2, (_SAMPLES, mix.shape[1]))
    reached = _ends(arm, drawn @ mix.T + (0.0 if zero is None else zero))
    if task.place:
        for i, name in enumerate("xyz"):
            values = reached[:, i, 3]
            if np.ptp(values) < _CONSTANT * arm.reach and abs(values[0] - pose[i, 3]) > _CONSTANT * arm.reach:
                yield f"{name} must be {values[0] + 0.0:.6g} m, is {pose[i, 3]:.6g} m"
    for k in task.directions:
        column = reached[:, :3, k]
        axis = "xyz"[k]
        if np.ptp(column, axis=0).max() < _CONSTANT:
            if np.abs(column[0] - pose[:3, k]).max() > _CONSTANT:
                off = _tilt(column[0], pose[:3, k])
                yield f"the last {axis} axis always points along {_along(column[0])}, yours is {off} off"
            continue
        for i, name in enumerate("xyz"):
            values = column[:, i]
            if np.ptp(values) < _CONSTANT and abs(values[0] - pose[i, k]) > _CONSTANT:
                yield _slant(axis, name, float(values[0]), float(pose[i, k]))


def _slant(axis: str, name: str, wanted: float, given: float) -> str:
    """What is said of an axis that keeps its angle with an axis of the start frame."""
    angle, yours = (float(np.degrees(np.arccos(np.clip(value, -1, 1)))) for value in (wanted, given))
    if abs(wanted) < _CONSTANT:
        how = "level" if name == "z" else f"square to {name}"
        return f"the last {axis} axis of this arm is always {how}, yours is tilted by {abs(90 - yours):.4g}°"
    return f"the last {axis} axis always makes {angle:.4g}° with {name}, yours makes {yours:.4g}°"


def _along(direction: Array) -> str:
    k = int(np.argmax(np.abs(direction)))
    if abs(abs(direction[k]) - 1) < _CONSTANT:
        return ("-" if direction[k] < 0 else "+") + "xyz"[k]
    return "(" + ", ".join(f"{part + 0.0:.4g}" for part in direction) + ")"


def _tilt(one: Array, other: Array) -> str:
    return f"{np.degrees(np.arctan2(np.linalg.norm(np.cross(one, other)), one @ other)):.4g}°"


def _ends(arm: Arm, motions: Array) -> Array:
    """Poses of the end in the start frame [m]."""
    inner = product(arm, motions) @ arm.home
    inner[:, :3, 3] *= arm.reach
    return np.asarray(arm.before @ inner)


def too_far(arm: Arm, task: Task, goal: Array) -> list[str]:
    """How far the point is from the first axis, and how far the arm can stretch from there at most."""
    if not task.place or not arm.turning.all():
        return []
    first = np.array(arm.axes[0].point)
    end = (goal @ arm.home)[:3, 3]
    points = [first] + [np.array(axis.point) for axis in arm.axes[1 : arm.joints] if axis.turns] + [arm.home[:3, 3]]
    longest = sum(float(np.linalg.norm(b - a)) for a, b in pairwise(points)) * arm.reach
    distance = float(np.linalg.norm(end - first)) * arm.reach
    if distance <= longest:
        return []
    return [f"the point is {distance:.4g} m from the first joint, and the links laid end to end are {longest:.4g} m"]


def nearest_reachable(ready: Prepared, goal: Array, held: dict[int, float]) -> tuple[Array, float, float]:
    """Joint motions that come nearest to a pose, by the sum of squares of distance in reaches and of angle.

    Args:
        ready: The robot made ready.
        goal: What the product of the joint motions has to be, shape (4, 4).
        held: Motions of the joints that are held.

    Returns:
        The motions, shape (n,), the distance that is left [m], and the angle [rad].
    """
    arm, task = ready.arm, ready.task
    rng = np.random.default_rng(13)
    motions = rng.uniform(-np.pi, np.pi, (_STARTS, arm.joints))
    for j, value in held.items():
        motions[:, j] = value
    wanted = np.repeat(goal[None], _STARTS, axis=0)
    damping = np.full(_STARTS, 1e-2)
    cost, slope, error = _cost(arm, task, motions, wanted)
    slope[:, :, list(held)] = 0
    for _ in range(_ROUNDS):
        if cost.min() < _REACHED:
            break
        square = slope.transpose(0, 2, 1) @ slope + damping[:, None, None] * np.eye(arm.joints)
        step = np.linalg.solve(square, (slope.transpose(0, 2, 1) @ error[:, :, None]))[:, :, 0]
        trial = motions + np.clip(step, -1, 1)
        less, other, left = _cost(arm, task, trial, wanted)
        other[:, :, list(held)] = 0
        better = less < cost
        settled = np.where(better, cost - less <= _SETTLED * cost, damping >= _STUCK).all()
        motions[better], cost[better], slope[better], error[better] = (
            trial[better],
            less[better],
            other[better],
            left[better],
        )
        damping = np.where(better, damping * 0.3, damping * 4).clip(1e-12, 1e6)
        if settled:
            break
    best = int(np.argmin(cost))
    end, target = product(arm, motions[best : best + 1])[0] @ arm.home, goal @ arm.home
    apart = float(np.linalg.norm(end[:3, 3] - target[:3, 3])) * arm.reach if task.place else 0.0
    return motions[best], apart, _angle(task, end, target)


def _angle(task: Task, end: Array, target: Array) -> float:
    if not task.directions:
        return 0.0
    if len(task.directions) == 1:
        one, other = end[:3, 2], target[:3, 2]
        return float(np.arctan2(np.linalg.norm(np.cross(one, other)), one @ other))
    turn = end[:3, :3].T @ target[:3, :3]
    sine = np.linalg.norm([turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]])
    return float(np.arctan2(sine, np.trace(turn) - 1))


def _cost(arm: Arm, task: Task, motions: Array, goal: Array) -> tuple[Array, Array, Array]:
    """Half the sum of squares that is left, the slope of what is reached, and the error."""
    before = products(arm, motions)
    end, wanted = before[-1] @ arm.home, goal @ arm.home
    columns = [*task.directions, *([3] if task.place else [])]
    error = np.concatenate([(wanted - end)[:, :3, k] for k in columns], axis=1)
    along, point = (np.ascontiguousarray(part.transpose(1, 0, 2)) for part in lines(arm, before))
    turns = arm.turning[:, None]
    # how each column of the end pose changes with each joint, shape (N, n, 3)
    moved = [
        np.where(turns, cross(along, end[:, None, :3, 3] - point), along)
        if k == 3  # noqa: PLR2004  the place
        else np.where(turns, cross(along, end[:, None, :3, k]), 0.0)
        for k in columns
    ]
    slope = np.concatenate(moved, axis=2).transpose(0, 2, 1).copy()
    return 0.5 * (error**2).sum(axis=1), slope, error
