"""An arm as it was built: its solutions are beside those of the arm that it was meant to be.

Newton's steps lead from one to the other where the pose is an ordinary one. Where the drawn arm could nearly move
without moving its end, they may lead anywhere; its whole way of moving is then walked along, and where the end of the
built arm comes nearest to the pose Newton's steps begin anew.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from dhcli.kinematics.inverse.arm import nearest_turn
from dhcli.kinematics.inverse.found import Found, once
from dhcli.kinematics.inverse.idealised import NEARLY
from dhcli.kinematics.inverse.polishing import jacobian, left_to_do
from dhcli.kinematics.inverse.steps import Plan
from dhcli.kinematics.inverse.tasks import Task
from dhcli.kinematics.inverse.trying import candidates, confirmed, missed

if TYPE_CHECKING:
    from dhcli.kinematics.inverse.arm import Array, Flags, Ints
    from dhcli.kinematics.inverse.rows import Rows

_CURVED = 0.01
"""Newton's steps are trusted where the least singular value of the Jacobian squared is more than so many residuals."""

_STRIDE = 0.2
"""How far the joints move from one place of a walk to the next [rad, reaches]; near its start, where solutions are to
be expected, they move by twice as much each time."""

_STRIDES = 22
"""How many times they do so, each way."""

_BACK = 3
"""How many times the places of a walk are led back to it before any is compared with another."""

_FLOOR = 1e-3
"""Singular values below this are not divided by on the way."""


def beside(  # noqa: PLR0913, PLR0917  what a plan is run with
    plan: Plan, task: Task, goal: Array, draws: Array, held: Mapping[int, Array], tolerance: float, found: Found
) -> Found:
    """The solutions found, and those beside the solutions of the arm that this one was meant to be.

    Args:
        plan: The plan of the arm.
        task: What is wanted.
        goal: What the product of the joint motions has to be, shape (P, 4, 4).
        draws: Motions to try for a joint that is free.
        held: Motions of the joints that are held, each (P,).
        tolerance: Residual up to which a candidate is a solution.
        found: The solutions that the plan of the arm itself finds.
    """
    meant = plan if plan.meant is None else replace(plan.meant, slack=max(plan.meant.slack, NEARLY))
    rows = candidates(meant, goal, draws, held)
    rows.actions = plan.actions
    rows = rows.take(np.arange(len(rows)))  # with nothing of the other arm in it
    if plan.meant is not None:
        found = once(plan, task, goal, found.joined(confirmed(plan, task, rows, tolerance)))
    starts = rows.take(_curved(plan, task, rows))
    if not len(starts):
        return found
    near, which = _walked(plan, task, starts)
    more = confirmed(plan, task, starts.take(which), tolerance, near)
    return once(plan, task, goal, found.joined(more))


def _curved(plan: Plan, task: Task, rows: Rows) -> Flags:
    """From which candidates Newton's steps lead further than they can be trusted."""
    if not len(rows):
        return np.zeros(0, dtype=bool)
    _, slope = jacobian(plan.actions.arm, task, rows.motions(plan.actions.arm.joints))
    least = np.linalg.svd(np.delete(slope, plan.held, axis=2), compute_uv=False)[:, -1]
    return np.asarray(least**2 < _CURVED * missed(rows, task))


def _walked(plan: Plan, task: Task, starts: Rows) -> tuple[Array, Ints]:
    """Where the end is nearest to the pose on the ways that the arm can nearly move without moving it.

    Returns:
        Motions of the joints there, shape (M, n), and the start of the way of each, shape (M,).
    """
    count = len(starts)
    now, goal = starts.motions(plan.actions.arm.joints), starts.poses()
    stride = np.tile(np.sqrt(missed(starts, task)), 2)[:, None]
    now, _, way = _led_back(plan, task, now, goal, np.zeros_like(now))
    now, goal, way = np.tile(now, (2, 1)), np.tile(goal, (2, 1, 1)), np.concatenate([way, -way])
    places, ways = list["Array"](), list["Array"]()
    for _ in range(_STRIDES):
        now, _, way = _led_back(plan, task, now, goal, way)
        places.append(now)
        ways.append(way)
        now = now + np.minimum(stride, _STRIDE) * way
        stride *= 2
    there = np.stack(places).reshape(_STRIDES, 2, count, -1)
    kept = _apart(plan, starts, there)
    now, way = (part[:, :, kept].reshape(-1, now.shape[1]) for part in (there, np.stack(ways).reshape(there.shape)))
    goal = np.tile(starts.poses()[kept], (2 * _STRIDES, 1, 1))
    for _ in range(_BACK):
        now, gap, way = _led_back(plan, task, now, goal, way)
    strides, column = np.nonzero(_nearest(gap.reshape(_STRIDES, -1)))
    return now[strides * 2 * len(kept) + column], kept[column % len(kept)]


def _apart(plan: Plan, starts: Rows, there: Array) -> Ints:
    """Which ways are no other way once more: their starts are at none of its places, shape (strides, 2, N, n)."""
    turning, index = plan.actions.arm.turning, starts.index
    dropped = np.zeros(len(index), dtype=bool)
    for k in range(len(index)):
        others = np.flatnonzero((index == index[k]) & ~dropped)
        others = others[others > k]
        if dropped[k] or not len(others):
            continue
        gap = there[:, :, k, None] - there[0, 0, others]
        gap = nearest_turn(turning, gap)
        dropped[others] = np.linalg.norm(gap, axis=3).min(axis=(0, 1)) < _STRIDE
    return np.flatnonzero(~dropped)


def _led_back(plan: Plan, task: Task, now: Array, goal: Array, way: Array) -> tuple[Array, Array, Array]:
    """Motions (N, n) led back to where all but one condition is met, how far that one is from being met, and how the
    joints move on from there, shape (N, n): not against the way that they moved before.
    """  # noqa: D205  one sentence
    arm = plan.actions.arm
    total, slope = jacobian(arm, task, now)
    slope[:, :, list(plan.held)] = 0
    error = left_to_do(task, total @ arm.home, goal @ arm.home)
    left, sizes, right = np.linalg.svd(slope, full_matrices=False)
    last = arm.joints - len(plan.held) - 1
    parts = (left * error[:, :, None]).sum(axis=1)
    back = ((parts / np.maximum(sizes, _FLOOR))[:, :last, None] * right[:, :last]).sum(axis=1)
    sign = np.where((right[:, last] * way).sum(axis=1) < 0, -1.0, 1.0)
    return now + back, parts[:, last] * sign, right[:, last] * sign[:, None]


def _nearest(gaps: Array) -> Flags:
    """Where along each column numbers are nearest to zero: the nearer side of a zero, or nearer than both sides."""
    size = np.pad(np.abs(gaps), ((1, 1), (0, 0)), constant_values=np.inf)
    least = (size[1:-1] <= size[:-2]) & (size[1:-1] <= size[2:])
    crossed = gaps[1:] * gaps[:-1] < 0
    later = size[2:-1] < size[1:-2]
    least[1:] |= crossed & later
    least[:-1] |= crossed & ~later
    return np.asarray(least)
