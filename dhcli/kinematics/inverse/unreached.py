"""The answer where nothing reaches the pose: reasons, the part that can be reached, and the nearest pose."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from dhcli.errors import plural
from dhcli.kinematics.inverse.planning import NoPlanError, find_plan
from dhcli.kinematics.inverse.prepared import Prepared
from dhcli.kinematics.inverse.reasons import nearest_reachable, what_never_changes
from dhcli.kinematics.inverse.running import run
from dhcli.kinematics.inverse.solutions import Solutions
from dhcli.kinematics.inverse.solving import tries
from dhcli.kinematics.inverse.tasks import TASKS, for_task

if TYPE_CHECKING:
    from dhcli.kinematics.inverse.arm import Array


FAR = 20
"""Reaches from which on nobody can mean metres, and up to a hundred times as far may well mean millimetres."""


def why_not(
    ready: Prepared,
    answer: Solutions,
    pose: Array,
    held: dict[int, float],
    values: Callable[[Array], Array],
) -> Solutions:
    """The answer that there is no solution, with what keeps the arm from the pose.

    Args:
        ready: The robot made ready.
        answer: The answer without a solution.
        pose: The pose asked for, shape (4, 4) [m].
        held: Motions of the joints held.
        values: Joint values of the robot from motions of the arm.
    """
    arm = ready.arm
    goal = arm.goal(pose[None])[0]
    motions, apart, angle = nearest_reachable(ready, goal, held)
    motions = np.where(arm.turning, motions - 2 * np.pi * np.round(motions / (2 * np.pi)), motions)
    reasons = list(what_never_changes(arm, ready.task, pose))
    if not reasons:
        reasons = list(_too_far(ready, goal))
    parts = list(_parts(ready, goal, held)) if ready.task.name in {"pose", "axis"} else []
    left = [f"{apart:.4g} m"] if ready.task.place else []
    left += [f"{np.degrees(angle):.4g}°"] if ready.task.directions else []
    nearest = f"the nearest pose reached is {' and '.join(left)} away"
    if FAR * arm.reach < apart < 100 * FAR * arm.reach:
        nearest += ": bare lengths are metres, did you mean mm?"
    why = "; ".join((*reasons, *parts, nearest))
    return replace(answer, reachable=False, why=why, closest=values(motions))


def _too_far(ready: Prepared, goal: Array) -> list[str]:
    """How far the point is from the first axis, and how far the arm can stretch from there at most."""
    arm = ready.arm
    if not ready.task.place or not arm.turning[0]:
        return []
    first = np.array(arm.axes[0].point)
    end = (goal @ arm.home)[:3, 3]
    points = [first] + [np.array(axis.point) for axis in arm.axes[1 : arm.joints] if axis.turns] + [arm.home[:3, 3]]
    if not arm.turning.all():
        return []
    longest = sum(float(np.linalg.norm(b - a)) for a, b in pairwise(points)) * arm.reach
    distance = float(np.linalg.norm(end - first)) * arm.reach
    if distance <= longest:
        return []
    return [f"the point is {distance:.4g} m from the first joint, and the links laid end to end are {longest:.4g} m"]


def _parts(ready: Prepared, goal: Array, held: dict[int, float]) -> list[str]:
    """Which part of the pose can be reached by itself, and in how many ways."""
    said = []
    for name in ("position", "orientation"):
        task = TASKS[name]
        if name == "orientation" and len(ready.task.directions) < 3:  # noqa: PLR2004  the axis alone is asked for
            task = TASKS["direction"]
        arm = for_task(ready.arm, task)
        label = f"the {'direction' if task.name == 'direction' else name} alone"
        try:
            plan = find_plan(arm, tuple(held))
        except NoPlanError:
            # more joints than this part needs: the nearest pose tells whether it can be reached
            part = Prepared(ready.plan, task, 0, False, ready.parts)  # noqa: FBT003
            _, apart, angle = nearest_reachable(part, goal, held)
            near = apart < 1e-6 * ready.arm.reach and angle < 1e-6  # noqa: PLR2004
            said.append(f"{label}: {'in many ways' if near else 'not'}")
            continue
        part = Prepared(plan, task, 0, False, ready.parts)  # noqa: FBT003
        fixed = {j: np.array([value]) for j, value in held.items()}
        found = run(plan, task, goal[None], tries(part, np.zeros(arm.joints)), fixed)
        count = len(found.index)
        said.append(f"{label}: {plural(count, 'solution') if count else 'not'}")
    return said


__all__ = ["why_not"]
