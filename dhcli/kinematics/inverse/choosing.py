"""Which joints of an arm are held where it has more than its task needs, and the plan for the others."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations, islice

import numpy as np

from dhcli.errors import RobotError, plural
from dhcli.kinematics.inverse.arm import Arm
from dhcli.kinematics.inverse.keeping import Kept
from dhcli.kinematics.inverse.planning import NoPlanError, find_plan
from dhcli.kinematics.inverse.polishing import jacobian, spread
from dhcli.kinematics.inverse.steps import One
from dhcli.kinematics.inverse.tasks import Task

_CHOICES = 24
"""Sets of joints to hold that are tried."""

_RANK = 1e-8


def chosen(arm: Arm, task: Task, asked: tuple[int, ...]) -> Kept:
    """The plan with the joints asked for held, and as many more as must be: the best choice of them.

    Raises:
        RobotError: No choice leaves joints that can be computed.
    """
    spare = arm.joints - rank(arm, task)
    fallback: Kept | None = None
    missing = arm.joints - len(asked) - rank(arm, task, asked, at_zero=False)
    for more in islice(_choices(arm, task, asked, missing), _CHOICES):
        try:
            plan = find_plan(arm, (*asked, *more))
        except NoPlanError:
            continue
        if all(isinstance(step, One) for step in plan.steps):
            return Kept(plan, spare)
        fallback = fallback or Kept(plan, spare)
    if fallback is None:
        names = ", ".join(axis.name for axis in arm.axes[: arm.joints])
        hint = f"hold {plural(missing, 'joint')} more of them" if missing else ""
        raise RobotError(f"no way was found to compute {names} from the {task.words} of the end", hint)
    return fallback


def _choices(arm: Arm, task: Task, asked: tuple[int, ...], missing: int) -> Iterator[tuple[int, ...]]:
    """Which further joints to hold; none of the sets that leave the arm short of the task where the joints held are 0.

    Of an arm that only has to point, the first joints are held, for its wrist points; else the last ones.
    """
    others = [j for j in range(arm.joints) if j not in asked]
    if task.place:
        others.reverse()
    wanted = arm.joints - len(asked) - missing
    doubtful = []
    for more in combinations(others, missing):
        if not more or rank(arm, task, (*asked, *more)) == wanted:
            yield more
        else:
            doubtful.append(more)
    yield from doubtful


def rank(arm: Arm, task: Task, held: tuple[int, ...] = (), *, at_zero: bool = True) -> int:
    """How many conditions the joints can meet in an ordinary pose, those held left out: at 0, or anywhere."""
    motions = 2.6 * spread(3, arm.joints, 7) - 1.3
    motions[:, list(held)] *= not at_zero
    _, slope = jacobian(arm, task, motions)
    slope[:, :, list(held)] = 0
    sizes = np.linalg.svd(slope, compute_uv=False)
    return int((sizes > _RANK).sum(axis=1).max())
