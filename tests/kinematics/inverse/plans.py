"""The plans that are shipped: `python tests/kinematics/inverse/plans.py` finds and writes them all."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[3]))

from dhcli import list_robots, load_robot
from dhcli.errors import RobotError
from dhcli.kinematics.inverse.arm import Arm
from dhcli.kinematics.inverse.choosing import chosen
from dhcli.kinematics.inverse.keeping import SHIPPED, content_of, name_of, written
from dhcli.kinematics.inverse.question import ask
from dhcli.kinematics.inverse.tasks import TASKS, Task


def asked() -> Iterator[tuple[Arm, Task]]:
    """Every robot of the library with each task that it can be asked; not those without joints or lengths."""
    for name in list_robots():
        for task in TASKS.values():
            try:
                ready = ask(load_robot(f"builtin:{name}"), task.name)[0].ready
            except RobotError:
                continue
            yield ready.arm, ready.task


def line(arm: Arm, task: Task) -> str:
    """The line of an arm and a task, its plan found anew."""
    content = content_of(arm, task, ())
    return f"{name_of(content)} {written(chosen(arm, task, ()), content)}\n"


if __name__ == "__main__":
    SHIPPED.write_text("".join(dict.fromkeys(line(arm, task) for arm, task in asked())), encoding="utf-8")
