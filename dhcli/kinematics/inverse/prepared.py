"""A robot made ready: its arm for a task, which joints to hold if it has more than the task needs, and the plan."""

from __future__ import annotations

from functools import lru_cache
from typing import TypeAlias

from dhcli.errors import RobotError
from dhcli.frozen import frozen
from dhcli.kinematics.frames import check_moves
from dhcli.kinematics.inverse.anatomy import NOTHING, Anatomy, anatomy
from dhcli.kinematics.inverse.arm import Arm, arm_of
from dhcli.kinematics.inverse.keeping import Kept, recalled, remember
from dhcli.kinematics.inverse.steps import Plan
from dhcli.kinematics.inverse.tasks import Task, TaskName, for_task, task_called
from dhcli.kinematics.moves import Chain
from dhcli.notation.angle import Angle

Known: TypeAlias = tuple[tuple[str, Angle | float], ...]
"""Names and values of what is no joint: exact angles, metres."""

MOST_JOINTS = 10
"""Joints that an arm may have; its loop is planned in seconds at most."""


@frozen
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


def kept_plan(arm: Arm, task: Task, asked: tuple[int, ...]) -> Kept:
    """The plan that was found before with some joints held, else one that is found now and kept.

    Raises:
        RobotError: No choice of further joints to hold leaves joints that can be computed.
    """
    kept = recalled(arm, task, asked)
    if kept is None:
        from dhcli.kinematics.inverse.choosing import chosen  # not for a plan that was found before

        kept = chosen(arm, task, asked)
        remember(kept, task, asked)
    return kept


@lru_cache(maxsize=64)
def prepare(
    chain: Chain, variables: tuple[str, ...], values: Known, task_name: TaskName, hold: tuple[str, ...]
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
    check_moves(arm.joints)
    if arm.joints > MOST_JOINTS:
        raise RobotError(f"the arm has {arm.joints} joints", f"inverse kinematics takes at most {MOST_JOINTS}")
    names = [axis.name for axis in arm.axes[: arm.joints]]
    asked = tuple(names.index(name) for name in hold if name in names)
    kept = kept_plan(arm, task, asked)
    plan, spare = kept.plan, kept.spare
    parts = anatomy(arm) if names == [name for name in variables if name in names] else NOTHING
    return Prepared(plan, task, spare, len(plan.held) > len(asked), parts)
