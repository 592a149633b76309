"""Poses at which three joints at once do not follow from their equations: other three are taken there.

At some poses at right angles the equations left for three joints depend on each other, whatever the joints are. Carried
by other joints, the same axis or another one gives equations that do not.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from dhcli.kinematics.inverse.polishing import SINGULAR, jacobian, spread
from dhcli.kinematics.inverse.rows import Rows
from dhcli.kinematics.inverse.rule_all import degenerate
from dhcli.kinematics.inverse.steps import All, Plan
from dhcli.kinematics.inverse.tasks import Task
from dhcli.kinematics.inverse.trying import Found, candidates, confirmed, once, tried

if TYPE_CHECKING:
    from dhcli.kinematics.inverse.arm import Array, Flags

_STARTS = 64
"""Places to begin at where no equations help."""

_KEPT = 64
"""Plans by other three joints that are remembered."""


def elsewhere(  # noqa: PLR0913, PLR0917  what a plan is tried with
    plan: Plan,
    task: Task,
    goal: Array,
    draws: Array,
    held: Mapping[int, Array],
    tolerance: float,
    found: Found,
) -> Found:
    """What was found, and what other three joints lead to at poses where those of the plan say nothing.

    Args:
        plan: A plan that takes three joints at once.
        task: What is wanted.
        goal: What the product of the joint motions has to be, shape (P, 4, 4).
        draws: Motions to try for a joint that is free, for each joint, shape (n, k).
        held: Motions of the joints that are held, each (P,).
        tolerance: Residual up to which a candidate is a solution.
        found: What the plan has found.
    """
    begun, step = _parted(plan)
    left = np.flatnonzero(_blind(begun, step, goal, draws, held))
    if not len(left):
        return found
    for other in _other_three(plan):
        completed = _completed(begun, other)
        if completed is None:
            continue
        seen = ~_blind(*_parted(completed), goal[left], draws, {j: value[left] for j, value in held.items()})
        at, left = left[seen], left[~seen]
        if len(at):
            more = tried(completed, task, goal[at], draws, {j: value[at] for j, value in held.items()}, tolerance)
            found = found.joined(replace(more, index=at[more.index]))
        if not len(left):
            break
    if len(left):
        more = _led(plan, task, goal[left], {j: value[left] for j, value in held.items()}, tolerance)
        found = found.joined(replace(more, index=left[more.index]))
    return once(plan, task, goal, found)


def _led(plan: Plan, task: Task, goal: Array, held: Mapping[int, Array], tolerance: float) -> Found:
    """What Newton's steps from many places lead to, where no three joints follow from their equations.

    Those that can move without moving the end are left out: they would be many of one family.
    """
    index = np.repeat(np.arange(len(goal)), _STARTS)
    begun = np.tile(np.pi * (2 * spread(_STARTS, plan.actions.arm.joints, 3) - 1), (len(goal), 1))
    for j, value in held.items():
        begun[:, j] = value[index]
    found = confirmed(plan, task, Rows.start(plan.actions, goal[index], {}), tolerance, begun)
    slope = np.delete(jacobian(plan.actions.arm, task, found.motions)[1], list(plan.held), axis=2)
    regular = np.linalg.svd(slope, compute_uv=False)[:, -1] > SINGULAR
    return replace(found, index=index[found.index]).take(regular)


def _parted(plan: Plan) -> tuple[Plan, All]:
    """What a plan does before it takes three joints at once, and that step."""
    place, step = next((k, step) for k, step in enumerate(plan.steps) if isinstance(step, All))
    return replace(plan, steps=plan.steps[:place], meant=None), step


def _blind(begun: Plan, step: All, goal: Array, draws: Array, held: Mapping[int, Array]) -> Flags:
    """The poses at which a step says nothing of its joints, shape (P,)."""
    rows = candidates(begun, goal, draws, held)
    blind = np.zeros(len(goal), dtype=bool)
    if len(rows):
        blind[rows.index[degenerate(rows, step)]] = True
    return blind


def _other_three(plan: Plan) -> Iterator[All]:
    from dhcli.kinematics.inverse.planning_all import other_three  # few poses need one

    begun, step = _parted(plan)
    unknown = [j for j in range(len(plan.actions.arm.axes)) if j not in begun.known]
    return other_three(plan.actions, unknown, step)


@lru_cache(maxsize=_KEPT)
def _completed(begun: Plan, step: All) -> Plan | None:
    from dhcli.kinematics.inverse.planning import with_three  # few poses need one

    return with_three(begun, step)
