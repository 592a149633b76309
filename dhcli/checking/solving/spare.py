"""Joints to spare: where one of them moves what is asked of a pose, there are solutions without number."""

from __future__ import annotations

from collections.abc import Iterator

from dhcli.algebra.floats import Floats
from dhcli.checking.exercise import Case
from dhcli.checking.solving.goal import Rows, Target, of_robot, solutions
from dhcli.kinematics.fold import fold
from dhcli.kinematics.frames import between
from dhcli.kinematics.validity import Finding
from dhcli.kinematics.values import numbers

STEP = 0.1
"""By how much a joint is moved, to see whether anything follows it [rad or m]."""
STILL = 1e-9


def spare_joints(case: Case, target: Target) -> tuple[str, ...]:
    """Joints that were held to find solutions, although what is asked for moves with them; none where there are none.

    Those of a wrist that turns about the point asked for were held too, and change nothing.
    """
    found = solutions(case, target)
    if not len(found) or not found.held:
        return ()
    robot = found.robot
    chain = between(robot, *target.ends(robot))
    known = numbers(of_robot(robot, case.exercise.known))
    at = dict(zip(robot.variables, map(float, found.q[0]), strict=True))

    def seen(moved: dict[str, float]) -> list[float]:
        return _asked(target.task, fold(chain, Floats({**known, **at, **moved})))

    first = seen({})
    held = [name for name, _ in found.held if name in at]
    away = {name: seen({name: at[name] + STEP}) for name in held}
    moving = {name for name in held if max(abs(a - b) for a, b in zip(first, away[name], strict=True)) > STILL}
    return tuple(name for name in robot.variables if name in moving)


def without_number(case: Case, target: Target, where: tuple[str | int, ...]) -> Iterator[Finding]:
    """What an author should mend who asks for all solutions, or how many there are, of an arm with joints to spare."""
    if free := spare_joints(case, target):
        message = f"{case.part.id}: with {' and '.join(free)} to spare there are solutions without number"
        yield Finding((*where, "ask"), message, "ask for one solution, or for more of the pose")


def _asked(task: str, rows: Rows) -> list[float]:
    """The entries of a pose, shape (4, 4), that a task is about."""
    place, along = [row[3] for row in rows[:3]], [row[2] for row in rows[:3]]
    turn = [entry for row in rows[:3] for entry in row[:3]]
    return {"position": place, "direction": along, "axis": [*place, *along], "orientation": turn}.get(
        task, [*place, *turn]
    )
