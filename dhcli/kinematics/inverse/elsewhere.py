"""Poses at which two or three joints may not follow from their equations: others are taken there.

At some poses at right angles the equations left for joints depend on each other, whatever the joints are. Those left
for other joints, or of another axis carried by other joints, may not. What none of them tell, as that the arm can move
there, Newton's steps from many places find. Where roots meet, one way to take joints may lose what another one finds.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from dhcli.kinematics.inverse.found import Found, once, regular
from dhcli.kinematics.inverse.rule_all import degenerate
from dhcli.kinematics.inverse.rule_two import silent
from dhcli.kinematics.inverse.steps import All, One, Plan, Two
from dhcli.kinematics.inverse.tasks import Task
from dhcli.kinematics.inverse.trying import candidates, led, tried

if TYPE_CHECKING:
    from dhcli.kinematics.inverse.arm import Array, Flags

_KEPT = 16
"""Plans whose other ways are remembered."""


def elsewhere(  # noqa: PLR0913, PLR0917  what a plan is tried with
    plan: Plan,
    task: Task,
    goal: Array,
    draws: Array,
    held: Mapping[int, Array],
    tolerance: float,
    found: Found,
) -> Found:
    """What was found, and what other joints at once lead to where those of the plan say nothing, or roots meet.

    Args:
        plan: A plan that takes two or three joints at once.
        task: What is wanted.
        goal: What the product of the joint motions has to be, shape (P, 4, 4).
        draws: Motions to try for a joint that is free, for each joint, shape (n, k).
        held: Motions of the joints that are held, each (P,).
        tolerance: Residual up to which a candidate is a solution.
        found: What the plan has found.
    """
    blind = _blind(plan, goal, draws, held)
    special = blind.copy()
    special[found.index[~regular(plan, task, found.motions)]] = True
    at = np.flatnonzero(special)
    if not len(at):
        return found
    there = {j: value[at] for j, value in held.items()}
    for other in _others(plan):  # of those that see something each may still miss what another one finds
        seen = ~_blind(other, goal[at], draws, there)
        if seen.any():
            own = {j: value[seen] for j, value in there.items()}
            more = tried(other, task, goal[at[seen]], draws, own, tolerance)
            found = found.joined(replace(more, index=at[seen][more.index]))
    if blind.any():
        found = led(plan, task, goal, np.flatnonzero(blind), held, tolerance, found)
    return once(plan, task, goal, found)


def _parted(plan: Plan) -> tuple[Plan, Two | All]:
    """What a plan does before it takes joints at once, and that step."""
    place, step = next((k, step) for k, step in enumerate(plan.steps) if not isinstance(step, One))
    return replace(plan, steps=plan.steps[:place], meant=None), step


def _blind(plan: Plan, goal: Array, draws: Array, held: Mapping[int, Array]) -> Flags:
    """The poses at which a plan's step for several joints says nothing of them, shape (P,)."""
    begun, step = _parted(plan)
    rows = candidates(begun, goal, draws, held)
    blind = np.zeros(len(goal), dtype=bool)
    if len(rows):
        blind[rows.index[silent(rows, step) if isinstance(step, Two) else degenerate(rows, step)]] = True
    return blind


@lru_cache(maxsize=_KEPT)
def _others(plan: Plan) -> tuple[Plan, ...]:
    """The same plan with other two or three joints for those that it takes at once, in every way there is."""
    from dhcli.kinematics.inverse.planning import otherwise  # few poses need one

    return tuple(otherwise(*_parted(plan)))
