"""Poses at which two or three joints do not follow from their equations: other three are taken there.

At some poses at right angles the equations left for three joints depend on each other, whatever the joints are. Carried
by other joints, the same axis or another one gives equations that do not. Where no three are left, or none help,
Newton's steps lead to the solutions from many places.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from dhcli.kinematics.inverse.rule_all import degenerate
from dhcli.kinematics.inverse.rule_two import silent
from dhcli.kinematics.inverse.steps import All, One, Plan, Two
from dhcli.kinematics.inverse.tasks import Task
from dhcli.kinematics.inverse.trying import Found, candidates, led, once, tried

if TYPE_CHECKING:
    from dhcli.kinematics.inverse.arm import Array, Flags

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
        plan: A plan that takes two or three joints at once.
        task: What is wanted.
        goal: What the product of the joint motions has to be, shape (P, 4, 4).
        draws: Motions to try for a joint that is free, for each joint, shape (n, k).
        held: Motions of the joints that are held, each (P,).
        tolerance: Residual up to which a candidate is a solution.
        found: What the plan has found.
    """
    left = np.flatnonzero(_blind(*_parted(plan), goal, draws, held))
    if not len(left):
        return found
    for other in _other_three(plan):
        completed = _completed(_parted(plan)[0], other)
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
        more = led(plan, task, goal[left], {j: value[left] for j, value in held.items()}, tolerance)
        found = found.joined(replace(more, index=left[more.index]))
    return once(plan, task, goal, found)


def _parted(plan: Plan) -> tuple[Plan, Two | All]:
    """What a plan does before it takes joints at once, and that step."""
    place, step = next((k, step) for k, step in enumerate(plan.steps) if not isinstance(step, One))
    return replace(plan, steps=plan.steps[:place], meant=None), step


def _blind(begun: Plan, step: Two | All, goal: Array, draws: Array, held: Mapping[int, Array]) -> Flags:
    """The poses at which a step says nothing of its joints, shape (P,)."""
    rows = candidates(begun, goal, draws, held)
    blind = np.zeros(len(goal), dtype=bool)
    if len(rows):
        blind[rows.index[silent(rows, step) if isinstance(step, Two) else degenerate(rows, step)]] = True
    return blind


def _other_three(plan: Plan) -> Iterator[All]:
    from dhcli.kinematics.inverse.planning_all import other_three  # few poses need one

    begun, step = _parted(plan)
    if isinstance(step, Two):
        return
    unknown = [j for j in range(len(plan.actions.arm.axes)) if j not in begun.known]
    yield from other_three(plan.actions, unknown, step)


@lru_cache(maxsize=_KEPT)
def _completed(begun: Plan, step: All) -> Plan | None:
    from dhcli.kinematics.inverse.planning import with_three  # few poses need one

    return with_three(begun, step)
