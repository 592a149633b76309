"""A plan tried on poses: candidates, then only those that the robot confirms, each of them once."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from dhcli.kinematics.inverse.found import Found, once, regular
from dhcli.kinematics.inverse.matrices import value_of
from dhcli.kinematics.inverse.motions import DIRECTION, POINT
from dhcli.kinematics.inverse.polishing import (
    POLISH,
    ROUNDING,
    extent,
    polished,
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

_STARTS, _ROUNDS = 64, 6
"""Places that Newton's steps begin at where no equations help, and how often at others while these lead to more."""

_SLOWLY = 1e-2
"""Where Newton's steps have left less than this, further ones may lead to a solution."""


def tried(plan: Plan, task: Task, goal: Array, draws: Array, held: Mapping[int, Array], tolerance: float) -> Found:
    """The solutions that a plan finds, each once.

    Where equations say nothing of a joint it may be free, or follow together with others only: where no value tried for
    it leads to an arm that can move, Newton's steps find what there is.
    """
    tried_at = np.zeros(len(goal), dtype=bool)
    found = confirmed(plan, task, candidates(plan, goal, draws, held, tried_at), tolerance)
    if tried_at.any():
        free = found.take(found.free != 0)
        tried_at[free.index[~regular(plan, task, free.motions)]] = False
    if (at := np.flatnonzero(tried_at)).size:
        found = led(plan, task, goal, at, held, tolerance, found)
    return once(plan, task, goal, found)


def led(  # noqa: PLR0913, PLR0917  what a plan is tried with
    plan: Plan, task: Task, goal: Array, at: Ints, held: Mapping[int, Array], tolerance: float, found: Found
) -> Found:
    """What was found, and at some poses what Newton's steps from many places lead to; of each family one."""
    for begun in range(_ROUNDS):
        count = np.bincount(found.index, minlength=len(goal))
        more = _arrived(plan, task, goal, at, held, tolerance, begun * _STARTS)
        found = once(plan, task, goal, found.joined(_further(plan, task, found, more)))
        at = at[np.bincount(found.index, minlength=len(goal))[at] > count[at]]
        if not len(at):
            break
    return found


def _arrived(  # noqa: PLR0913, PLR0917  what a plan is tried with, and where steps begin
    plan: Plan, task: Task, goal: Array, at: Ints, held: Mapping[int, Array], tolerance: float, begun: int
) -> Found:
    """What Newton's steps lead to at some poses from places by their number, also many members of a family."""
    arm = plan.actions.arm
    index = np.repeat(at, _STARTS)
    motions = np.tile(np.pi * (2 * spread(_STARTS, arm.joints, 3 + begun) - 1), (len(at), 1))
    for j, value in held.items():
        motions[:, j] = value[index]
    motions, left = polished(arm, task, motions, goal[index], plan.held)
    slow = np.flatnonzero((left > tolerance) & (left < _SLOWLY))  # as beside roots that meet
    motions[slow], _ = polished(arm, task, motions[slow], goal[index[slow]], plan.held)
    found = confirmed(plan, task, Rows.start(plan.actions, goal[index], {}), tolerance, motions)
    return once(plan, task, goal, replace(found, index=index[found.index]))


def _further(plan: Plan, task: Task, found: Found, more: Found) -> Found:
    """Of solutions those at which the arm cannot move, and one of each family that no other solution is in."""
    from dhcli.kinematics.inverse.families import one_of_each, standing_still  # few poses need it

    arm, others = plan.actions.arm, found.take(np.isin(found.index, more.index))
    both = others.joined(more)
    order = np.argsort(np.concatenate([others.index, more.index]), kind="stable")
    is_new, kept, free = order >= len(others.index), regular(plan, task, both.motions), both.free.copy()
    loose = np.flatnonzero(~kept)
    if arm.joints - len(plan.held) > task.conditions:
        loose = loose[:0]
    rates = dict(zip(loose.tolist(), standing_still(arm, task, both.motions[loose], plan.held), strict=True))
    for pose in np.unique(both.index[loose]):
        own = loose[both.index[loose] == pose].tolist()
        shown = one_of_each(
            arm, task, both.motions[own], np.zeros(len(own), dtype=int), [rates[k] for k in own], plan.held
        )
        for k, ways in shown.items():
            kept[own[k]], free[own[k]] = True, sum(1 << way.parameter for way in ways)
    return replace(both, free=free).take(kept & is_new)


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
    rough = np.flatnonzero(~(residual <= POLISH))
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
