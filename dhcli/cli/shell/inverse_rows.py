"""`dhcli ik --in`: the solutions of each pose of a file, as they come, however many there are."""

from __future__ import annotations

import sys
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, cast

from dhcli.cli.shell.chosen import Chosen
from dhcli.cli.shell.console import say
from dhcli.cli.shell.given import lengths_of, robot_of
from dhcli.cli.shell.goal import Goal, task_of
from dhcli.cli.shell.pose_wish import PoseWish, rotations
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
from dhcli.files.reading import source_of
from dhcli.files.rows.poses import pose_blocks
from dhcli.frozen import frozen
from dhcli.kinematics.frames import ends
from dhcli.kinematics.inverse.batch import inverse_batch, numbered
from dhcli.render.code.pose_rows import INDEX
from dhcli.render.code.rows import Group, Layout
from dhcli.render.paper import Paper
from dhcli.render.text.problems import warning_line
from dhcli.render.text.progress import row_progress

if TYPE_CHECKING:
    from dhcli.kinematics.inverse.batch import Each
    from dhcli.kinematics.inverse.tasks import TaskName


MOST_BAD = 8
"""Rows left out that are named; of more, it is told how many."""


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


def inverse_rows(wanted: PoseWish, path: str, delivery: RowDelivery, bad: list[Problem] | None = None) -> int:
    """Solve each pose of a file, and hand the joint values over as they come.

    Args:
        wanted: What is wanted of each pose.
        path: The file; `-` for standard input.
        delivery: Where the joint values go.
        bad: Where rows that are no pose are noted and left out; without it the first of them is an error.

    Returns:
        How many poses have no solution.

    Raises:
        FileError: The file cannot be read, or a row is no pose.
    """
    joints = Group.named("q", {name: name for name in wanted.robot.variables})
    total = lost = 0
    with delivery.open(Layout((INDEX, joints))) as sink, row_progress(sys.stderr, wanted=delivery.is_away) as tell:
        for poses, places in pose_blocks(path, bad, whole=wanted.task is None):
            task = wanted.task or ("pose" if poses.ndim == 3 else "position")  # noqa: PLR2004  matrices
            if bad is not None:
                poses, places = rotations(poses, places, path, bad)  # noqa: PLW2901  those that are poses
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
                where = Place(source_of(path), places[0])
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


@frozen
class RowWish:
    """The options about many poses, as they were typed; see `ik`."""

    path: str | None
    each: str | None
    task: str | None
    near: str | None
    hold: Sequence[str]
    within_limits: bool
    follow: bool
    skip_bad: bool


def _check_follow(wish: RowWish) -> None:
    """Make sure that a path can be followed as asked."""
    if wish.each is not None or wish.within_limits:
        other = "--each" if wish.each is not None else "--within-limits"
        raise DhcliError(f"--follow gives one solution of each row, whatever {other} says", f"leave {other} out")
    if wish.near is None:
        raise DhcliError("a path needs joint values to begin near to", "give --near VALUES; they choose the branch")


def solve_rows(
    chosen: Chosen,
    wish: RowWish,
    others: Mapping[str, object],
    format_: str | None,
    output: str | None,
    *,
    overwrite: bool,
) -> ExitStatus:
    """Solve each pose of a file.

    Raises:
        DhcliError: There is no file, an option does not go with it, or a row is no pose.
    """
    if wish.path is None:
        raise DhcliError("--each, --follow and --skip-bad are for many poses", "name their file with --in FILE")
    if wish.follow:
        _check_follow(wish)
    each = wish.each or "all"
    if each not in {"all", "nearest", "first"}:
        hint = did_you_mean(each, ("all", "nearest", "first")) or "all, nearest or first"
        raise UnknownNameError(Problem(f"there is no {each} of solutions", Place("--each"), hint))
    if each == "nearest" and wish.near is None:
        raise DhcliError("nearest to what?", "give --near VALUES")
    check_rows(chosen.robot, wish.path, others)
    delivery = RowDelivery(format_, output, overwrite)
    delivery.chosen()
    robot = robot_of(chosen)
    task = None if wish.task is None else task_of(Goal(task=wish.task))
    low, high = ends(robot, chosen.from_, chosen.end)
    lengths = lengths_of(robot, chosen)
    near = near_of(robot, wish.near, chosen.bare)
    held = held_of(robot, wish.hold, chosen.bare)
    wanted = PoseWish(
        robot, cast("TaskName | None", task), cast("Each", each), near, held, wish.within_limits, low, high, lengths
    )
    bad: list[Problem] | None = [] if wish.skip_bad else None
    solve = inverse_rows
    if wish.follow:
        from dhcli.cli.shell.follow_rows import follow_rows as solve  # few follow a path
    lost = solve(wanted, wish.path, delivery, bad)
    for problem in (bad or [])[:MOST_BAD]:
        say(warning_line(f"skipped {problem}", Paper.of(sys.stderr)))
    if bad and len(bad) > MOST_BAD:
        say(warning_line(f"skipped {len(bad)} rows in all", Paper.of(sys.stderr)))
    return ExitStatus.NOT_RIGHT if lost else ExitStatus.DONE
