"""The answer where nothing reaches the pose: reasons, the part that can be reached, and the nearest pose."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from dhcli.errors import plural
from dhcli.kinematics.inverse.arm import nearest_turn
from dhcli.kinematics.inverse.choosing import rank
from dhcli.kinematics.inverse.matrices import value_of
from dhcli.kinematics.inverse.polishing import jacobian, spread
from dhcli.kinematics.inverse.prepared import Prepared, kept_plan
from dhcli.kinematics.inverse.reasons import nearest_reachable, too_far, what_never_changes
from dhcli.kinematics.inverse.rows import Rows
from dhcli.kinematics.inverse.rule_one import read_off
from dhcli.kinematics.inverse.running import run
from dhcli.kinematics.inverse.solutions import Solutions
from dhcli.kinematics.inverse.solving import tries
from dhcli.kinematics.inverse.steps import One
from dhcli.kinematics.inverse.tasks import TASKS, for_task

if TYPE_CHECKING:
    from dhcli.kinematics.inverse.arm import Array

_SMALL = 1e-9
"""Coefficients below this say nothing of a joint."""

LEAST = 1e-5
"""Less than this of a metre, or of a degree, is nothing to a reader."""

_PLACES = 5
"""Joint values at which it is looked whether a joint moves the end."""

FAR = 20
"""Reaches from which on nobody can mean metres, and up to a hundred times as far may well mean millimetres."""


def why_not(
    ready: Prepared,
    answer: Solutions,
    pose: Array,
    held: dict[int, float],
    nearest: tuple[Array, float, float],
    values: Callable[[Array], Array],
) -> Solutions:
    """The answer that there is no solution, with what keeps the arm from the pose.

    Args:
        ready: The robot made ready.
        answer: The answer without a solution.
        pose: The pose asked for, shape (4, 4) [m].
        held: Motions of the joints held.
        nearest: Motions that come nearest, and what is left: a distance [m] and an angle.
        values: Joint values of the robot from motions of the arm.
    """
    arm = ready.arm
    goal = arm.goal(pose[None])[0]
    motions, apart, angle = nearest
    motions = nearest_turn(arm.turning, motions)
    reasons = list(what_never_changes(arm, ready.task, pose))
    if not reasons:
        reasons = too_far(arm, ready.task, goal) or _not_real(ready, goal, held)
    parts = list(_parts(ready, goal, held)) if ready.task.name in {"pose", "axis"} else []
    # where all of it is that small, it is what the typed digits leave, and is told
    least = LEAST if max(apart, angle) > LEAST else 0.0
    left = [f"{_shown(apart, least):.4g} m"] if ready.task.place else []
    left += [f"{_shown(float(np.degrees(angle)), least):.4g}°"] if ready.task.directions else []
    said = f"the nearest pose reached is {' and '.join(left)} away"
    chosen = sorted(set(ready.plan.held) - set(held))
    if not least and chosen and _moved(ready, chosen):
        said = f"other values of {', '.join(arm.axes[j].name for j in chosen)} reach it"
    elif not least:
        said += ", which more digits of the pose would mend"
    if FAR * arm.reach < apart < 100 * FAR * arm.reach:
        said += ": bare lengths are metres, did you mean mm?"
    why = "; ".join((*reasons, *parts, said))
    return replace(answer, reachable=False, why=why, closest=values(motions))


def _shown(left: float, least: float) -> float:
    """What is left of a distance or an angle, without what the search for the nearest pose leaves."""
    return 0.0 if left < least else left


def _not_real(ready: Prepared, goal: Array, held: dict[int, float]) -> list[str]:
    """The joint at which all candidates end, because a cosine in its equation would be beyond 1."""
    arm, plan = ready.arm, ready.plan
    chosen = [j for j in plan.held if j not in held]
    if chosen and _moved(ready, chosen):  # many values of a joint were tried
        return []
    held = {**held, **dict.fromkeys(chosen, 0.0)}
    fixed = {j: value_of(np.array([value]), turns=arm.axes[j].turns) for j, value in held.items()}
    rows = Rows.start(plan.actions, goal[None], fixed, plan.slack)
    draws = tries(ready, np.zeros(arm.joints))
    for step in plan.steps:
        if not isinstance(step, One):
            return []
        equation = rows.coefficients(step.equations[0], step.joint)
        e, a, b = (np.broadcast_to(part, len(rows)) for part in equation)
        rows = read_off(rows, step, draws[step.joint])
        if not len(rows):
            least = float((np.abs(e) / np.maximum(np.hypot(a, b), _SMALL)).min())
            said = f"{arm.axes[step.joint].name} has no real value: a cosine in its equation would be {least:.4g}"
            return [said] if step.kind == "pair" and least < 1 / _SMALL else []
    return []


def _moved(ready: Prepared, joints: list[int]) -> bool:
    """Whether any of some joints moves what the task asks for; those of a wrist leave its centre where it is."""
    _, slope = jacobian(ready.arm, ready.task, spread(_PLACES, ready.arm.joints, 5) * 2 - 1)
    return bool(np.abs(slope[:, :, joints]).max() > _SMALL)


def _parts(ready: Prepared, goal: Array, held: dict[int, float]) -> list[str]:
    """Which part of the pose can be reached by itself, and in how many ways."""
    said = []
    for name in ("position", "orientation"):
        task = TASKS[name]
        if name == "orientation" and len(ready.task.directions) < 3:  # noqa: PLR2004  the axis alone is asked for
            task = TASKS["direction"]
        arm = for_task(ready.arm, task)
        label = f"the {'direction' if task.name == 'direction' else name} alone"
        if too_far(arm, task, goal):
            said.append(f"{label}: not")
            continue
        if rank(arm, task, tuple(held)) < arm.joints - len(held):
            # more joints than this part needs: the nearest pose tells whether it can be reached
            part = Prepared(ready.plan, task, 0, False, ready.parts)  # noqa: FBT003
            _, apart, angle = nearest_reachable(part, goal, held)
            near = apart < 1e-6 * ready.arm.reach and angle < 1e-6  # noqa: PLR2004
            said.append(f"{label}: {'in many ways' if near else 'not'}")
            continue
        plan = kept_plan(arm, task, tuple(held)).plan
        part = Prepared(plan, task, 0, False, ready.parts)  # noqa: FBT003
        fixed = {j: np.array([value]) for j, value in held.items()}
        found = run(plan, task, goal[None], tries(part, np.zeros(arm.joints)), fixed)
        count = len(found.index)
        said.append(f"{label}: {plural(count, 'solution') if count else 'not'}")
    return said
