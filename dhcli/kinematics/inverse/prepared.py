"""A robot made ready: its arm for a task, which joints to hold if it has more than the task needs, and the plan."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from itertools import combinations, islice
from typing import TypeAlias

import numpy as np

from dhcli.errors import RobotError, plural
from dhcli.kinematics.inverse.anatomy import NOTHING, Anatomy, anatomy
from dhcli.kinematics.inverse.arm import Arm, arm_of
from dhcli.kinematics.inverse.planning import NoPlanError, find_plan
from dhcli.kinematics.inverse.polishing import jacobian, spread
from dhcli.kinematics.inverse.steps import One, Plan
from dhcli.kinematics.inverse.tasks import Task, TaskName, for_task, task_called
from dhcli.kinematics.moves import Chain
from dhcli.notation.angle import Angle

Known: TypeAlias = tuple[tuple[str, Angle | float], ...]
"""Names and values of what is no joint: exact angles, metres."""

MOST_JOINTS = 10
"""Joints that an arm may have; its loop is planned in seconds at most."""

_CHOICES = 24
"""Sets of joints to hold that are tried."""

_RANK = 1e-8


@dataclass(frozen=True, slots=True)
class Prepared:
    """What inverse kinematics of a robot needs.

    Attributes:
        plan: The plan, with the arm in it.
        task: What is wanted.
        spare: How many joints are more than the task needs.
        chosen: Whether the joints held were chosen here and not asked for.
        parts: Shoulder, elbow and wrist.
    """

    plan: Plan
    task: Task
    spare: int
    chosen: bool
    parts: Anatomy

    @property
    def arm(self) -> Arm:
        """The arm."""
        return self.plan.actions.arm


@lru_cache(maxsize=64)
def prepare(
    chain: Chain, variables: tuple[str, ...], values: Known, task_name: TaskName, hold: tuple[str, ...] = ()
) -> Prepared:
    """The plan for a robot and a task; kept for when it is asked for again.

    Args:
        chain: The moves from the start frame to the end frame.
        variables: The joint variables.
        values: Values of what is no joint.
        task_name: What is wanted of the end.
        hold: Joints that are held; where the arm has more than the task needs, further ones are chosen.

    Raises:
        RobotError: The arm has no joint between the frames, or too many, or the joints held leave it short.
    """
    task = task_called(task_name)
    arm = for_task(arm_of(chain, variables, dict(values)), task)
    if not arm.joints:
        raise RobotError("no joint moves the end", "there is nothing to compute; fk says where it is")
    if arm.joints > MOST_JOINTS:
        raise RobotError(f"the arm has {arm.joints} joints", f"inverse kinematics takes at most {MOST_JOINTS}")
    names = [axis.name for axis in arm.axes[: arm.joints]]
    asked = tuple(names.index(name) for name in hold if name in names)
    spare = arm.joints - _rank(arm, task)
    plan = _plan(arm, task, asked, spare)
    parts = anatomy(arm) if names == [name for name in variables if name in names] else NOTHING
    return Prepared(plan, task, spare, len(plan.held) > len(asked), parts)


def _plan(arm: Arm, task: Task, asked: tuple[int, ...], spare: int) -> Plan:
    """The plan with the joints asked for held, and as many more as must be: the best choice of them."""
    fallback: Plan | None = None
    for more in islice(_choices(arm, task, asked, spare), _CHOICES):
        try:
            plan = find_plan(arm, (*asked, *more))
        except NoPlanError:
            continue
        if all(isinstance(step, One) for step in plan.steps):
            return plan
        fallback = fallback or plan
    if fallback is None:
        names = ", ".join(axis.name for axis in arm.axes[: arm.joints])
        hint = f"hold {plural(spare, 'joint')} more: hold={{name: value}}" if spare > 0 else ""
        raise RobotError(f"no way was found to compute {names} from the {task.words} of the end", hint)
    return fallback


def _choices(arm: Arm, task: Task, asked: tuple[int, ...], spare: int) -> Iterator[tuple[int, ...]]:
    """Which further joints to hold; none of the sets that leave the arm short of the task where the joints held are 0.

    Of an arm that only has to point, the first joints are held, for its wrist points; else the last ones.
    """
    missing = max(spare - len(asked), 0)
    others = [j for j in range(arm.joints) if j not in asked]
    if task.place:
        others.reverse()
    wanted = arm.joints - spare
    doubtful = []
    for more in combinations(others, missing):
        if len(asked) > spare or _rank(arm, task, (*asked, *more)) == wanted:
            yield more
        else:
            doubtful.append(more)
    yield from doubtful


def _rank(arm: Arm, task: Task, held: tuple[int, ...] = ()) -> int:
    """How many conditions the joints can meet in an ordinary pose, those held left out."""
    motions = 2.6 * spread(3, arm.joints, 7) - 1.3
    motions[:, list(held)] = 0
    _, slope = jacobian(arm, task, motions)
    slope[:, :, list(held)] = 0
    sizes = np.linalg.svd(slope, compute_uv=False)
    return int((sizes > _RANK).sum(axis=1).max())
