"""How a DH table is worked out: what its parameters measure, and its rows below each other."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from dhcli.checking.exercise import Exercise
from dhcli.checking.returned import Shown
from dhcli.checking.tables.cells import on_sheet, spelled
from dhcli.errors import RobotError
from dhcli.kinematics.conventions import Convention, Row
from dhcli.kinematics.robot import Robot

if TYPE_CHECKING:
    from dhcli.kinematics.describe.words import Step

MEANINGS = {
    Convention.STANDARD: (
        "a_i: from z_{i-1} to z_i along x_i",
        "alpha_i: from z_{i-1} to z_i about x_i",
        "d_i: from x_{i-1} to x_i along z_{i-1}",
        "theta_i: from x_{i-1} to x_i about z_{i-1}",
    ),
    Convention.MODIFIED: (
        "a_{i-1}: from z_{i-1} to z_i along x_{i-1}",
        "alpha_{i-1}: from z_{i-1} to z_i about x_{i-1}",
        "d_i: from x_{i-1} to x_i along z_i",
        "theta_i: from x_{i-1} to x_i about z_i",
    ),
}
"""What the four parameters of a row measure, in the order of `COLUMNS`."""


def process_lines(robot: Robot, exercise: Exercise) -> Iterator[Shown]:
    """The first three steps of the process, in words: the z axes, frame 0, and each x axis with its four cells.

    They are told with all joints at 0, and every free choice as the table makes it. Nothing is told of a table with a
    row without a joint, nor where a twist is a letter.
    """
    from dhcli.kinematics.describe.words import written

    yield from map(Shown, written(_steps(robot, exercise)))


def cell_lines(robot: Robot, column: str, number: int, exercise: Exercise) -> Iterator[Shown]:
    """The step of the process in which one cell of a table is found."""
    is_before = robot.convention is Convention.MODIFIED and column in ("a", "alpha")
    subject = f"x{number - is_before}"
    for step in _steps(robot, exercise):
        if step.subject == subject:
            yield Shown("\n".join(step.lines()))


def _steps(robot: Robot, exercise: Exercise) -> tuple[Step, ...]:
    """The process as a robot's own table has gone it, up to the y axes; nothing where it cannot be told."""
    from dhcli.kinematics.describe.retold import retold
    from dhcli.kinematics.describe.words import Speaker

    try:
        walked = retold(robot)
    except RobotError:
        return ()
    return tuple(Speaker(walked, robot.convention, robot.first, robot.writing, exercise.on_sheet).drawn())


def table_lines(rows: Sequence[Row], columns: Sequence[str], first: int, exercise: Exercise) -> Iterator[str]:
    """A DH table, a line for each row with its values by name, below each other."""
    cells = [
        [f"{column} = {spelled(getattr(row, column), exercise.writing)}" for column in columns]
        for row in on_sheet(rows, exercise)
    ]
    widths = [max(map(len, column)) for column in zip(*cells, strict=True)]
    for number, row in enumerate(cells, first):
        texts = (text.ljust(width) for text, width in zip(row, widths, strict=True))
        yield f"row {number}:  {'   '.join(texts)}".rstrip()
