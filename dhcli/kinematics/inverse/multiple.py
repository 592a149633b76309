"""Solutions that come several times, led to where they are exactly: Newton's steps find half of their digits, or fewer.

Where roots meet, the arm can begin to move in some way v while its end stands still: J v = 0. Both conditions together,
the pose and this one, determine the joints and v as well as a pose alone does elsewhere.

Source: T. Ojika, S. Watanabe and T. Mitsui, Deflation algorithm for the multiple roots of a system of nonlinear
equations, J. Mathematical Analysis and Applications 96, 1983.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from dhcli.kinematics.inverse.polishing import ENOUGH, ROUNDING, extent, jacobian, left_to_do, residuals

if TYPE_CHECKING:
    from dhcli.kinematics.inverse.arm import Arm, Array
    from dhcli.kinematics.inverse.tasks import Task

_STEPS = 25
"""Steps at most; a double root needs a few, one that comes more often gains a digit in three."""

_AT_REST = 1e-10
"""A step that moves no joint by more is the last one [rad, reaches]."""

_LONGEST = 0.02
"""No step moves a joint by more [rad, reaches]."""

_FAR = 1e-2
"""A solution does not stand farther away than this from where it was found."""

_FAINT = 1e-4
"""A singular value of the Jacobian that is larger is that of a root which meets no other."""

_ASIDE = 1e-5
"""How far joints are moved to see how the Jacobian changes."""

_RANK = 1e-11
"""Singular values below this share of the largest are not divided by."""


def sharpened(arm: Arm, task: Task, motions: Array, goal: Array, held: tuple[int, ...] = ()) -> tuple[Array, Array]:
    """Solutions beside which roots meet, led to where they do; those that do not meet as they are.

    Args:
        arm: The arm.
        task: What is wanted.
        motions: Motions of the joints, shape (N, n), near to a solution.
        goal: What the product of the motions has to be, shape (N, 4, 4).
        held: Joints that keep their values.

    Returns:
        The motions, shape (N, n), and for each how certain it is that no more than two roots meet there, shape (N,):
        the less, the nearer it is to where more do; infinite where none meet.
    """
    _, slope = jacobian(arm, task, motions)
    slope[:, :, list(held)] = 0
    _, sizes, rows = np.linalg.svd(slope, full_matrices=True)
    last = arm.joints - len(held) - 1
    sizes = np.pad(sizes, ((0, 0), (0, max(0, last + 1 - sizes.shape[1]))))
    meeting = np.flatnonzero(sizes[:, last] < _FAINT)
    result, alone = motions.copy(), np.full(len(motions), np.inf)
    result[meeting], alone[meeting] = _led(arm, task, motions[meeting], goal[meeting], held, rows[meeting, last])
    return result, alone


def _led(arm: Arm, task: Task, motions: Array, goal: Array, held: tuple[int, ...], way: Array) -> tuple[Array, Array]:
    """Where roots meet, from places beside and the ways in which the arm can begin to move there, shapes (N, n)."""
    now, way, best, least = motions.copy(), way.copy(), motions.copy(), np.full(len(motions), np.inf)
    active = np.arange(len(motions))
    for _ in range(_STEPS):
        if not len(active):
            break
        x, v = now[active], way[active]
        total, slopes = jacobian(arm, task, np.concatenate([x, x + _ASIDE * v, x - _ASIDE * v]))
        slopes[:, :, list(held)] = 0
        slope, ahead, behind = slopes.reshape(3, len(active), *slopes.shape[1:])
        total, stays = total[: len(active)], (slope @ v[:, :, None])[:, :, 0]
        error = np.concatenate([left_to_do(task, total @ arm.home, goal[active] @ arm.home), -stays], axis=1)
        step, alone = _step(slope, (ahead - behind) / (2 * _ASIDE), v, error, len(held))
        worst = np.maximum(residuals(task, arm.home, total, goal[active]), np.abs(stays).max(axis=1))
        there = worst <= np.maximum(10 * ENOUGH, ROUNDING * extent(arm, x))
        # where many roots meet, no residual tells how near they are
        better = there & (alone < least[active]) & (np.abs(x - motions[active]).max(axis=1) < _FAR)
        best[active[better]], least[active[better]] = x[better], alone[better]
        now[active], way[active] = x + step[:, : arm.joints], v + step[:, arm.joints :]
        active = active[~there | (np.abs(step[:, : arm.joints]).max(axis=1) > _AT_REST)]
    return best, least


def _step(slope: Array, bent: Array, way: Array, error: Array, held: int) -> tuple[Array, Array]:
    """Newton's step of the joints and of the way that they begin to move in.

    Args:
        slope: The Jacobian, shape (N, m, n).
        bent: How it changes along the way, shape (N, m, n).
        way: The way, shape (N, n).
        error: What is left of the pose, and of the end that should stand still, shape (N, 2 m).
        held: How many joints do not move.

    Returns:
        The step, shape (N, 2 n), and the least singular value of the system, shape (N,).
    """
    count, joints = way.shape
    upper = np.concatenate([slope, np.zeros_like(slope)], axis=2)
    lower = np.concatenate([bent, slope], axis=2)
    scale = np.concatenate([np.zeros_like(way), way], axis=1)[:, None]
    left, sizes, right = np.linalg.svd(np.concatenate([upper, lower, scale], axis=1), full_matrices=False)
    parts = np.einsum("nij,ni->nj", left, np.concatenate([error, np.zeros((count, 1))], axis=1))
    small = sizes <= _RANK * sizes[:, :1]
    parts = np.where(small, 0, parts) / np.where(small, 1, sizes)
    step = np.einsum("nj,njk->nk", parts, right)
    longest = np.abs(step).max(axis=1, keepdims=True)
    step = step * np.minimum(1, _LONGEST / np.maximum(longest, _LONGEST))
    return np.asarray(step), np.asarray(sizes[:, 2 * (joints - held) - 1])
