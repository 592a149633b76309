"""The product of the joint motions, how far it is from the pose asked for, and Newton's steps towards it."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from dhcli.geometry.twists import cross

if TYPE_CHECKING:
    from dhcli.kinematics.inverse.arm import Arm, Array, Ints
    from dhcli.kinematics.inverse.tasks import Task

STEPS = 12
"""Newton's steps at most; a candidate from a good equation needs none, one beside a double root some."""

ENOUGH = 4e-15
"""A residual that no further step makes smaller."""

POLISH = 2e-14
"""Candidates above this are led nearer by Newton's steps."""

SINGULAR = 1e-6
"""Singular values of the Jacobian below this may be zero; a finite motion then decides."""

ROUNDING = 1e-14
"""What rounding leaves of a length, as a share of it, when all joints have moved it."""

DONE = 1e-13
"""A residual below which a step that makes it no smaller is the last one."""

_ASTRAY = 3
"""How many steps in turn may lead further away."""

_RANK = 1e-11
"""Singular values of the Jacobian below this share of the largest are not divided by."""

_LONGEST = 0.5
"""No step moves a joint by more [rad, reaches]."""


_ROOTS = np.sqrt([2.0, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53])


def spread(count: int, width: int, seed: int = 0) -> Array:
    """Numbers from 0 to 1 without a pattern, shape (count, width): always the same, and without numpy's generators,
    whose import takes as long as a plan.
    """  # noqa: D205  one sentence
    steps = np.arange(1 + seed, 1 + seed + count)[:, None]
    return np.asarray((steps * _ROOTS[np.arange(width) % len(_ROOTS)] * (1 + np.arange(width) // len(_ROOTS))) % 1)


def motions(arm: Arm, values: Array) -> Array:
    """The motion of each axis by itself, for values (N, n) of the first n, shape (n, N, 4, 4)."""
    count = values.shape[1]
    along, across, around = (part[:count] for part in arm.turns)
    point = arm.lines[1][:count]
    slides = [k for k in arm.slides if k < count]
    angles = values.T[:, :, None, None].copy()
    angles[slides] = 0
    turn = np.cos(angles) * across
    turn += along
    turn += np.sin(angles) * around
    result = np.zeros((*values.T.shape, 4, 4))
    result[:, :, :3, :3] = turn
    result[:, :, :3, 3] = (point - turn @ point)[..., 0]
    result[:, :, 3, 3] = 1
    for k in slides:
        result[k, :, :3, :3] = np.eye(3)
        result[k, :, :3, 3] = values[:, k, None] * arm.lines[0][k, :, :, 0]
    return result


def products(arm: Arm, values: Array) -> Array:
    """The products of the motions before each axis, and of all, for values (N, n), shape (n + 1, N, 4, 4)."""
    moved = motions(arm, values)
    found = np.empty((len(moved) + 1, *moved.shape[1:]))
    found[0] = np.eye(4)
    for k, one in enumerate(moved):
        np.matmul(found[k], one, out=found[k + 1])
    return found


def product(arm: Arm, values: Array) -> Array:
    """The product of the motions of all axes, for values (N, axes), shape (N, 4, 4)."""
    total = np.broadcast_to(np.eye(4), (len(values), 4, 4))
    for one in motions(arm, values):
        total = total @ one
    return np.array(total)


def lines(arm: Arm, before: Array) -> tuple[Array, Array]:
    """Directions of the axes and a point on each, when those before have moved as in `products`, each (n, N, 3)."""
    along, point = (part[: len(before) - 1] for part in arm.lines)
    turn, place = before[:-1, :, :3, :3], before[:-1, :, :3, 3]
    return (turn @ along)[..., 0], (turn @ point)[..., 0] + place


def extent(arm: Arm, values: Array) -> Array:
    """How far out the slides of motions (N, n) stand, at least 1 [reaches], shape (N,).

    Two slides may make up for each other thousands of reaches out; lengths are then rounded by that size, not by the
    arm's.
    """
    slides = np.flatnonzero(~arm.turning[: values.shape[1]])
    return np.asarray(np.abs(values[:, slides]).max(axis=1, initial=1.0))


def residuals(task: Task, home: Array, reached: Array, goal: Array) -> Array:
    """How far motions (N, 4, 4) are from those wanted, in what the task asks for, shape (N,)."""
    gap = (reached - goal) @ home
    wanted = [*task.directions, *([3] if task.place else [])]
    return np.asarray(np.abs(gap[:, :3, wanted]).max(axis=(1, 2)))


def jacobian(arm: Arm, task: Task, values: Array) -> tuple[Array, Array]:
    """How the end moves with each joint, in what the task asks for, at some motions of the joints, shape (N, n).

    Returns:
        The product of the motions, shape (N, 4, 4), and the Jacobian, shape (N, m, n).
    """
    before = products(arm, values)
    along, point = lines(arm, before)
    turning, moving = along.copy(), cross(point, along)
    for k in arm.slides:
        if k < len(along):
            turning[k], moving[k] = 0, along[k]
    omega, v = (np.ascontiguousarray(part.transpose(1, 2, 0)) for part in (turning, moving))
    total = before[-1]
    end = total @ arm.home
    rows = []
    if task.place:
        turned = cross(omega.transpose(0, 2, 1), end[:, None, :3, 3])
        rows.append(v + turned.transpose(0, 2, 1))
    if task.directions == (2,):
        z = end[:, :3, 2, None]
        rows.append(omega - z * (z * omega).sum(axis=1, keepdims=True))
    elif task.directions:
        rows.append(omega)
    return total, np.concatenate(rows, axis=1)


def polished(
    arm: Arm, task: Task, values: Array, goal: Array, still: tuple[int, ...] = (), mix: Array | None = None
) -> tuple[Array, Array]:
    """Joint motions led to the pose by Newton's steps.

    Args:
        arm: The arm.
        task: What is wanted.
        values: Motions of the joints to begin with, shape (N, n).
        goal: What the product of the motions should be, shape (N, 4, 4).
        still: Joints that keep their values; where motions are mixed, variables that do.
        mix: Motions for each unit of variables that move them together, shape (n, k); by default each moves alone.

    Returns:
        The motions, and the residual of each row, shape (N,).
    """
    best, now = values.copy(), values.copy()
    least, astray = np.full(len(values), np.inf), np.zeros(len(values), dtype=int)
    active = np.arange(len(values))
    turning = arm.turning[: values.shape[1]]
    slides = np.flatnonzero(~turning if mix is None else ~(mix[turning] != 0).any(axis=0))
    for _ in range(STEPS):
        total, slope = jacobian(arm, task, now[active])
        found = residuals(task, arm.home, total, goal[active])
        better = found < least[active]
        rows = active[better]
        best[rows], least[rows] = now[rows], found[better]
        astray[active] = np.where(better, 0, astray[active] + 1)
        # beside a singular pose a step in the right direction may lead away at first
        going = (found > ENOUGH) & (better | (least[active] > DONE) & (astray[active] <= _ASTRAY))
        active, total, slope = active[going], total[going], slope[going]
        if not len(active):
            break
        slope = slope if mix is None else slope @ mix
        slope[:, :, list(still)] = 0
        error = left_to_do(task, total @ arm.home, goal[active] @ arm.home)
        step = _step(slides, task, slope, error, extent(arm, now[active]))
        now[active] += step if mix is None else step @ mix.T
    return best, least


def _step(slides: Ints, task: Task, slope: Array, error: Array, unit: Array) -> Array:
    """Newton's step, shape (N, n), computed with lengths in units (N,) that make them like angles in size."""
    if len(slides):
        slope[:, :, slides] *= unit[:, None, None]
        if task.place:
            slope[:, :3] /= unit[:, None, None]
            error[:, :3] /= unit[:, None]
    step = (np.linalg.pinv(slope, rcond=_RANK) @ error[:, :, None])[:, :, 0]
    longest = np.abs(step).max(axis=1, keepdims=True)
    step *= np.minimum(1, _LONGEST / np.maximum(longest, _LONGEST))
    step[:, slides] *= unit[:, None]
    return np.asarray(step)


def left_to_do(task: Task, end: Array, goal: Array) -> Array:
    """The motion that is left to do, as the Jacobian counts it, shape (N, m)."""
    parts = []
    if task.place:
        parts.append(goal[:, :3, 3] - end[:, :3, 3])
    if task.directions:
        turn = sum(cross(end[:, :3, k], goal[:, :3, k]) for k in task.directions)
        parts.append(np.asarray(turn) / min(len(task.directions), 2))
    return np.concatenate(parts, axis=1)
