"""A plan tried on poses: candidates, then only those that the robot confirms, each of them once."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from dhcli.frozen import frozen
from dhcli.kinematics.inverse.arm import nearest_turn
from dhcli.kinematics.inverse.matrices import value_of
from dhcli.kinematics.inverse.motions import DIRECTION, POINT
from dhcli.kinematics.inverse.polishing import (
    ROUNDING,
    SINGULAR,
    extent,
    jacobian,
    polished,
    product,
    residuals,
    spread,
)
from dhcli.kinematics.inverse.rows import Rows
from dhcli.kinematics.inverse.rule_one import read_off
from dhcli.kinematics.inverse.steps import All, Plan, Two
from dhcli.kinematics.inverse.tasks import Task

if TYPE_CHECKING:
    from dhcli.kinematics.inverse.arm import Array, Flags, Ints

CONFIRMED = 1e-12
"""A residual below this is a solution [reaches, and of direction cosines], or one that rounding leaves of slides that
stand far out."""

_POLISH = 2e-14
"""Candidates above this are led nearer by Newton's steps."""

_STARTS = 64
"""Places that Newton's steps begin at where no equations help."""

_CLOSE = 1e-3
"""Solutions closer than this may be one that rounding has split [rad, reaches]."""

_SAME = 1e-9
"""Solutions closer than this are one; so are closer ones whose middle is a solution as good as they are."""


@frozen
class Found:
    """Solutions of many poses, sorted by pose.

    Attributes:
        index: The pose of each solution, shape (M,).
        motions: Motions of the joints, shape (M, n).
        residual: How far each is from its pose.
        path: The choices among roots that led to it.
        free: The joints that may take any value, as bits.
        draw: Which of the values tried for them.
    """

    index: Ints
    motions: Array
    residual: Array
    path: Ints
    free: Ints
    draw: Ints

    def take(self, at: Ints | Flags) -> Found:
        """Some of them."""
        path, free, draw = self.path[at], self.free[at], self.draw[at]
        return Found(self.index[at], self.motions[at], self.residual[at], path, free, draw)

    def joined(self, other: Found) -> Found:
        """These and others, sorted by pose."""
        index = np.concatenate([self.index, other.index])
        both = Found(
            index,
            np.concatenate([self.motions, other.motions]),
            np.concatenate([self.residual, other.residual]),
            np.concatenate([self.path, other.path]),
            np.concatenate([self.free, other.free]),
            np.concatenate([self.draw, other.draw]),
        )
        return both.take(np.argsort(index, kind="stable"))


def tried(plan: Plan, task: Task, goal: Array, draws: Array, held: Mapping[int, Array], tolerance: float) -> Found:
    """The solutions that a plan finds, each once.

    Where equations say nothing of a joint it may be free, or follow together with others only: where no value tried for
    it leads to an arm that can move, Newton's steps find what there is.
    """
    tried_at = np.zeros(len(goal), dtype=bool)
    found = confirmed(plan, task, candidates(plan, goal, draws, held, tried_at), tolerance)
    if tried_at.any():
        free = found.take(found.free != 0)
        tried_at[free.index[~_regular(plan, task, free.motions)]] = False
    if (at := np.flatnonzero(tried_at)).size:
        more = led(plan, task, goal[at], {j: value[at] for j, value in held.items()}, tolerance)
        found = found.joined(replace(more, index=at[more.index]))
    return once(plan, task, goal, found)


def led(plan: Plan, task: Task, goal: Array, held: Mapping[int, Array], tolerance: float) -> Found:
    """What Newton's steps from many places lead to, where no equations help.

    Those that can move without moving the end are left out: they would be many of one family.
    """
    index = np.repeat(np.arange(len(goal)), _STARTS)
    begun = np.tile(np.pi * (2 * spread(_STARTS, plan.actions.arm.joints, 3) - 1), (len(goal), 1))
    for j, value in held.items():
        begun[:, j] = value[index]
    found = confirmed(plan, task, Rows.start(plan.actions, goal[index], {}), tolerance, begun)
    return replace(found, index=index[found.index]).take(_regular(plan, task, found.motions))


def _regular(plan: Plan, task: Task, motions: Array) -> Flags:
    """Where an arm, motions (M, n), cannot move without moving its end, shape (M,)."""
    slope = np.delete(jacobian(plan.actions.arm, task, motions)[1], list(plan.held), axis=2)
    if slope.shape[1] < slope.shape[2] or not slope.shape[2]:
        return np.zeros(len(motions), dtype=bool)
    return np.asarray(np.linalg.svd(slope, compute_uv=False)[:, -1] > SINGULAR)


def candidates(plan: Plan, goal: Array, draws: Array, held: Mapping[int, Array], tried_at: Flags | None = None) -> Rows:
    """What the steps of a plan make of poses.

    Args:
        plan: The plan.
        goal: What the product of the joint motions has to be, shape (P, 4, 4).
        draws: Motions to try for a joint that is free, for each joint, shape (n, k).
        held: Motions of the joints that are held, each (P,).
        tried_at: Takes at which poses values were tried for a joint, shape (P,).
    """
    arm = plan.actions.arm
    known = {j: value_of(value, turns=arm.axes[j].turns) for j, value in held.items()}
    rows = Rows.start(plan.actions, goal, known, plan.slack)
    for step in plan.steps:
        if isinstance(step, Two):
            from dhcli.kinematics.inverse.rule_two import eliminated  # most arms need neither of the two

            rows = eliminated(rows, step)
        elif isinstance(step, All):
            from dhcli.kinematics.inverse.rule_all import all_at_once

            rows = all_at_once(rows, step)
        else:
            rows = read_off(rows, step, draws[step.joint])
        if tried_at is not None:
            tried_at[rows.index[rows.free != 0]] = True
    return rows


def confirmed(plan: Plan, task: Task, rows: Rows, tolerance: float, begun: Array | None = None) -> Found:
    """The candidates that reach their pose, if need be after some of Newton's steps.

    Args:
        plan: The plan.
        task: What is wanted.
        rows: The candidates.
        tolerance: Residual up to which one is a solution.
        begun: Motions to begin with in place of the candidates' own, shape (N, n).
    """
    arm = plan.actions.arm
    if begun is None:
        motions, residual = rows.motions(arm.joints), missed(rows, task)
    else:
        motions, residual = begun.copy(), np.full(len(begun), np.inf)
    rough = np.flatnonzero(~(residual <= _POLISH))
    if len(rough):
        goal = rows.take(rough).poses()
        led, left = polished(arm, task, motions[rough], goal, plan.held)
        better = ~(residual[rough] <= left)
        motions[rough[better]], residual[rough[better]] = led[better], left[better]
    kept = np.flatnonzero(residual <= np.maximum(tolerance, ROUNDING * extent(arm, motions)))
    kept = kept[np.argsort(rows.index[kept], kind="stable")]
    return Found(rows.index, _wrapped(motions, arm.turning), residual, rows.path, rows.free, rows.draw).take(kept)


def _wrapped(motions: Array, turning: Flags) -> Array:
    """The same angles from -π to π."""
    wrapped = motions - 2 * np.pi * np.round(motions / (2 * np.pi))
    return np.where(turning & (np.abs(motions) > np.pi), wrapped, motions)


def missed(rows: Rows, task: Task) -> Array:
    """How far each candidate is from its pose, computed with the cosines and sines at hand."""
    arm = rows.actions.arm
    walk = range(arm.joints - 1, -1, -1)
    worst = np.zeros(len(rows))
    goal = rows.goal[:, rows.index]
    if task.place:
        p = arm.home[:3, 3].tolist()
        there = rows.carry(POINT, (1.0, *p, 0.0), walk)
        for i in range(3):
            wanted = goal[3 * i] * p[0] + goal[3 * i + 1] * p[1] + goal[3 * i + 2] * p[2] + goal[9 + i]
            worst = np.maximum(worst, np.abs(there[1 + i] - wanted))
    for k in task.directions[:2]:  # the third follows from two
        e = arm.home[:3, k].tolist()
        there = rows.carry(DIRECTION, tuple(e), walk)
        for i in range(3):
            wanted = goal[3 * i] * e[0] + goal[3 * i + 1] * e[1] + goal[3 * i + 2] * e[2]
            worst = np.maximum(worst, np.abs(there[i] - wanted))
    return worst


def once(plan: Plan, task: Task, goal: Array, found: Found) -> Found:
    """Each solution once: those that rounding has split are put together."""
    if len(found.index) < 2:  # noqa: PLR2004
        return found
    dropped = np.zeros(len(found.index), dtype=bool)
    arm = plan.actions.arm
    turning, out = arm.turning, extent(arm, found.motions)
    for apart in range(1, int(np.bincount(found.index).max(initial=1))):
        first, second = np.arange(len(dropped) - apart), np.arange(apart, len(dropped))
        together = (found.index[first] == found.index[second]) & ~dropped[first] & ~dropped[second]
        gap = found.motions[second] - found.motions[first]
        gap = nearest_turn(turning, gap)
        distance = np.abs(np.where(turning, gap, gap / out[first, None])).max(axis=1, initial=0.0)
        close = np.flatnonzero(together & (distance < _CLOSE))
        if not len(close):
            continue
        middle = found.motions[close] + gap[close] / 2
        between = residuals(task, arm.home, product(arm, middle), goal[found.index[close]])
        best = np.maximum(found.residual[close], found.residual[close + apart])
        rounded = np.maximum(_POLISH, ROUNDING * out[close])
        same = (distance[close] < _SAME) | (between <= np.maximum(best, rounded))
        worse = found.residual[close] > found.residual[close + apart]
        dropped[close[same & worse]] = True
        dropped[close[same & ~worse] + apart] = True
    return found.take(~dropped)
