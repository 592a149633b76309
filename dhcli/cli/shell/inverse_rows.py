"""`dhcli ik --in`: the solutions of each pose of a file, as they come, however many there are."""

from __future__ import annotations

import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, cast

from dhcli.cli.shell.console import say
from dhcli.cli.shell.given import settings_of
from dhcli.cli.shell.goal import Goal, task_of
from dhcli.cli.shell.rows import RowDelivery
from dhcli.cli.shell.solutions import held_of, near_of
from dhcli.errors import (
    DhcliError,
    ExitStatus,
    FileError,
    Place,
    Problem,
    RobotError,
    UnknownNameError,
    did_you_mean,
    plural,
)
from dhcli.files.rows.poses import pose_blocks
from dhcli.files.yaml.robots import load_robot
from dhcli.kinematics.frames import ends
from dhcli.kinematics.inverse.batch import inverse_batch, numbered
from dhcli.kinematics.robot import Robot, Value
from dhcli.kinematics.values import parameter_values
from dhcli.render.code.pose_rows import INDEX
from dhcli.render.code.rows import Group, Layout
from dhcli.render.paper import Paper
from dhcli.render.text.problems import warning_line
from dhcli.render.text.progress import row_progress

if TYPE_CHECKING:
    from dhcli.kinematics.inverse.batch import Each
    from dhcli.kinematics.inverse.tasks import TaskName


@dataclass(frozen=True, slots=True)
class Wanted:
    """What is wanted of each pose.

    Attributes:
        robot: The robot.
        task: What of it counts; None for all that a row has.
        each: Which solutions.
        near: Joint values that they should be near to.
        hold: Joints that are not computed.
        within_limits: Whether only solutions inside the limits are wanted.
        start: The frame they are seen from.
        end: The frame that is placed.
        lengths: Values of lengths and constant angles.
    """

    robot: Robot
    task: TaskName | None
    each: Each
    near: Sequence[float] | None
    hold: Mapping[str, float]
    within_limits: bool
    start: str
    end: str
    lengths: Mapping[str, Value]


def check_rows(typed: str, path: str, others: Mapping[str, object]) -> None:
    """Make sure that nothing is asked for that a row cannot have.

    Raises:
        DhcliError: One of the others is given, or robot and rows both come from standard input.
    """
    if path == typed == "-":
        raise DhcliError("the robot and the rows cannot both come from standard input", "save one of them in a file")
    if given := [option for option, value in others.items() if value]:
        verb = "does" if len(given) == 1 else "do"
        raise DhcliError(f"{' and '.join(given)} {verb} not go with --in", "each row is a pose")


def inverse_rows(wanted: Wanted, path: str, delivery: RowDelivery) -> int:
    """Solve each pose of a file, and hand the joint values over as they come.

    Returns:
        How many poses have no solution.

    Raises:
        FileError: The file cannot be read, or a row is no pose.
    """
    joints = Group.named("q", {name: name for name in wanted.robot.variables})
    total = lost = 0
    with delivery.open(Layout((INDEX, joints))) as sink, row_progress(sys.stderr, wanted=True) as tell:
        for poses, places in pose_blocks(path):
            task = wanted.task or ("pose" if poses.ndim == 3 else "position")  # noqa: PLR2004  matrices
            try:
                q, index = inverse_batch(
                    wanted.robot,
                    poses,
                    task=task,
                    each=wanted.each,
                    near=wanted.near,
                    hold=wanted.hold,
                    within_limits=wanted.within_limits,
                    start=wanted.start,
                    end=wanted.end,
                    parameters=wanted.lengths,
                )
            except RobotError as error:
                where = Place(path, places[0])
                raise FileError([Problem(p.message, where, p.hint) for p in error.problems]) from None
            total += len(poses)
            lost += len(poses) - len(set(index.tolist()))
            if len(q):
                sink.write(numbered(places, index, q))
            if not sink.wanted:
                return lost
            tell(total, None)
    if lost:
        paper = Paper.of(sys.stderr)
        say(warning_line(f"{lost} of {plural(total, 'pose')} have no solution, and no row", paper))
    return lost


@dataclass(frozen=True, slots=True)
class RowWish:
    """The options about many poses, as they were typed; see `ik`."""

    path: str | None
    each: str | None
    task: str | None
    near: str | None
    hold: Sequence[str]
    settings: Sequence[str]
    start: str | None
    end: str | None
    within_limits: bool
    degrees: bool
    base: str | None = None
    tip: str | None = None
    as_typed: bool = False


def solve_rows(
    typed: str,
    wish: RowWish,
    others: Mapping[str, object],
    format_: str | None,
    output: str | None,
    *,
    force: bool,
) -> ExitStatus:
    """Solve each pose of a file.

    Raises:
        DhcliError: There is no file, an option does not go with it, or a row is no pose.
    """
    if wish.path is None:
        raise DhcliError("--each is for many poses", "name their file with --in FILE")
    each = wish.each or "all"
    if each not in {"all", "nearest", "first"}:
        hint = did_you_mean(each, ("all", "nearest", "first")) or "all, nearest or first"
        raise UnknownNameError(Problem(f"there is no {each} of solutions", Place("--each"), hint))
    if each == "nearest" and wish.near is None:
        raise DhcliError("nearest to what?", "give --near VALUES")
    check_rows(typed, wish.path, others)
    delivery = RowDelivery(format_, output, force)
    delivery.chosen()
    robot = load_robot(typed, base=wish.base, tip=wish.tip, as_typed=wish.as_typed)
    task = None if wish.task is None else task_of(Goal(None, None, None, None, None, None, None, wish.task))
    low, high = ends(robot, wish.start, wish.end)
    lengths = parameter_values(robot, settings_of(wish.settings), Place("--set", text=" ".join(wish.settings)))
    near = near_of(robot, wish.near, degrees=wish.degrees)
    held = held_of(robot, wish.hold, degrees=wish.degrees)
    wanted = Wanted(
        robot, cast("TaskName | None", task), cast("Each", each), near, held, wish.within_limits, low, high, lengths
    )
    return ExitStatus.NOT_RIGHT if inverse_rows(wanted, wish.path, delivery) else ExitStatus.DONE
