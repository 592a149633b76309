"""A plan run on poses, and once more in another way where a solution must be missing."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from dhcli.kinematics.inverse.found import Found, once
from dhcli.kinematics.inverse.rows import ROUNDED
from dhcli.kinematics.inverse.steps import All, One, Plan, Step
from dhcli.kinematics.inverse.tasks import Task
from dhcli.kinematics.inverse.trying import CONFIRMED, tried

if TYPE_CHECKING:
    from dhcli.kinematics.inverse.arm import Array

FULL = 6
"""Joints and free motions of an arm that is neither short of its task nor has any to spare."""

OTHER_TURN = (-2.3519, 0.4127, -0.9061)
"""Where angles are counted from at a second try."""


def run(
    plan: Plan,
    task: Task,
    goal: Array,
    draws: Array,
    held: Mapping[int, Array] | None = None,
    tolerance: float = CONFIRMED,
) -> Found:
    """All solutions of some poses.

    Args:
        plan: The plan for the arm and the task.
        task: What is wanted.
        goal: What the product of the joint motions has to be, shape (P, 4, 4).
        draws: Motions to try for a joint that is free, for each joint, shape (n, k).
        held: Motions of the joints that are held, each (P,).
        tolerance: Residual up to which a candidate is a solution.
    """
    held = held or {}
    found = tried(plan, task, goal, draws, held, tolerance)
    if plan.meant is not None or plan.slack > ROUNDED:
        from dhcli.kinematics.inverse.measured import beside  # an arm as it is drawn needs none of it

        found = beside(plan, task, goal, draws, held, tolerance, found)
    if all(isinstance(step, One) for step in plan.steps):
        return found
    from dhcli.kinematics.inverse.elsewhere import elsewhere  # most arms need it nowhere

    found = elsewhere(plan, task, goal, draws, held, tolerance, found)
    if not any(isinstance(step, All) for step in plan.steps):
        return found
    if len(plan.actions.arm.axes) != FULL:
        return found
    # roots of six joints come in pairs: where one is alone, or there is none, angles are counted from another zero
    count = np.bincount(found.index, minlength=len(goal))
    doubtful = np.flatnonzero((count % 2 == 1) | (count == 0))
    if not len(doubtful):
        return found
    values = {j: value[doubtful] for j, value in held.items()}
    other = replace(plan, steps=tuple(_turned(step) for step in plan.steps))
    more = tried(other, task, goal[doubtful], draws, values, tolerance)
    return once(plan, task, goal, found.joined(replace(more, index=doubtful[more.index])))


def _turned(step: Step) -> Step:
    return replace(step, turn=OTHER_TURN) if isinstance(step, All) else step
