"""What is wanted of the end: all of its pose, or a part of it."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Literal

from dhcli.errors import UnknownNameError, did_you_mean
from dhcli.frozen import frozen
from dhcli.kinematics.inverse.arm import Arm, Axis

if TYPE_CHECKING:
    from dhcli.kinematics.inverse.arm import Array

TaskName = Literal["pose", "position", "orientation", "axis", "direction"]


@frozen
class Task:
    """What is wanted.

    Attributes:
        name: What it is called.
        place: Whether the origin of the end frame is given.
        directions: Which of the axes of the end frame are given.
        conditions: How many numbers it fixes.
        words: What is given, in words.
    """

    name: TaskName
    place: bool
    directions: tuple[int, ...]
    conditions: int
    words: str


TASKS = {
    task.name: task
    for task in (
        Task("pose", True, (0, 1, 2), 6, "position and orientation"),  # noqa: FBT003
        Task("position", True, (), 3, "position"),  # noqa: FBT003
        Task("orientation", False, (0, 1, 2), 3, "orientation"),  # noqa: FBT003
        Task("axis", True, (2,), 5, "position and direction of the z axis"),  # noqa: FBT003
        Task("direction", False, (2,), 2, "direction of the z axis"),  # noqa: FBT003
    )
}
"""The tasks by name; `axis` leaves the spin about the z axis of the end free, `direction` its place too."""


def task_called(name: object) -> Task:
    """The task of a name.

    Raises:
        UnknownNameError: There is none.
    """
    if not isinstance(name, str) or name not in TASKS:
        raise UnknownNameError(f"there is no task {name!s:.60}", did_you_mean(str(name), TASKS))
    return TASKS[name]


def for_task(arm: Arm, task: Task) -> Arm:
    """The arm with the motions that a task leaves free as further axes, which nobody solves for."""
    x, y, z = (_triple(arm.home[:3, k]) for k in range(3))
    tip = _triple(arm.home[:3, 3])
    free: list[Axis] = []
    if not task.directions:
        free = [Axis("", True, along, tip) for along in (x, y, z)]  # noqa: FBT003
    elif task.directions == (2,):
        free = [Axis("", True, z, tip)]  # noqa: FBT003
    if not task.place:
        free += [Axis("", False, along) for along in (x, y, z)]  # noqa: FBT003
    return replace(arm, axes=(*arm.axes[: arm.joints], *free))


def _triple(vector: Array) -> tuple[float, float, float]:
    x, y, z = (float(part) for part in vector)
    return x, y, z
