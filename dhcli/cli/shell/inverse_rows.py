"""`dhcli ik --in`: the solutions of each pose of a file, as they come, however many there are."""

from __future__ import annotations

import sys
from collections.abc import Callable, Generator, Iterator, Mapping, Sequence
from contextlib import closing
from functools import partial
from itertools import islice
from typing import TYPE_CHECKING, cast

from dhcli.cli.shell.chosen import Chosen
from dhcli.cli.shell.console import say
from dhcli.cli.shell.given import lengths_of, robot_of
from dhcli.cli.shell.goal import Goal, task_of
from dhcli.cli.shell.pose_wish import PoseWish
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
from dhcli.frozen import frozen
from dhcli.kinematics.frames import ends
from dhcli.kinematics.inverse.batch import numbered
from dhcli.render.code.pose_rows import INDEX
from dhcli.render.code.rows import Group, Layout
from dhcli.render.paper import Paper
from dhcli.render.text.problems import warning_line
from dhcli.render.text.progress import row_progress

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from dhcli.kinematics.inverse.batch import Each
    from dhcli.kinematics.inverse.tasks import TaskName

    Poses = tuple[NDArray[np.float64], list[int]]


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
    blocks, jobs = wanted.blocks(path, bad), wanted.workers(path)
    total, lost, said = 0, 0, ""
    with (
        delivery.open(Layout((INDEX, joints))) as sink,
        row_progress(sys.stderr, wanted=delivery.is_away) as tell,
        closing(_shared(partial(_solved, wanted, source_of(path), sink.spell), blocks, jobs)) as outcomes,
    ):
        for outcome in outcomes:
            if not isinstance(outcome, _Rows):
                raise FileError(outcome)
            total += outcome.poses
            lost += outcome.lost
            said = said or outcome.said
            if outcome.count:
                sink.take(outcome.spelled, outcome.count)
            if not sink.wanted:
                return lost
            tell(total, None)
    paper = Paper.of(sys.stderr)
    if said:
        say(warning_line(said, paper))
    if lost:
        say(warning_line(f"{lost} of {plural(total, 'pose')} have no solution, and no row", paper))
    return lost


@frozen
class _Rows:
    """The solutions of a block of poses.

    Attributes:
        poses: How many poses there are.
        lost: How many of them have none.
        count: How many rows there are of the others.
        spelled: The rows as they are written.
        said: What a reader should know of them, if anything.
    """

    poses: int
    lost: int
    count: int
    spelled: str | NDArray[np.float64]
    said: str


def _shared(
    work: Callable[[Poses], _Rows | list[Problem]], blocks: Iterator[Poses], jobs: int
) -> Generator[_Rows | list[Problem], None, None]:
    """What becomes of each block, in their order, by so many processes."""
    if jobs == 1:
        yield from map(work, blocks)
        return
    from dhcli.classroom.pool import in_turn  # short files need none

    yield from map(work, islice(blocks, 1))  # here, for with it the plan is found, and kept for all
    yield from in_turn(work, blocks, jobs=jobs)


def _solved(
    wanted: PoseWish,
    source: str,
    spell: Callable[[NDArray[np.float64]], str | NDArray[np.float64]],
    block: Poses,
) -> _Rows | list[Problem]:
    """The rows of a block, or why there are none; in whichever process."""
    poses, places = block
    try:
        q, index = wanted.solutions(poses)
    except RobotError as error:
        return [Problem(p.message, Place(source, places[0]), p.hint) for p in error.problems]
    lost = len(poses) - len(set(index.tolist()))
    return _Rows(len(poses), lost, len(q), spell(numbered(places, index, q)), wanted.said(poses))


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
    jobs: int | None


def _check_follow(wish: RowWish) -> None:
    """Make sure that a path can be followed as asked."""
    if wish.each is not None or wish.within_limits:
        other = "--each" if wish.each is not None else "--within-limits"
        raise DhcliError(f"--follow gives one solution of each row, whatever {other} says", f"leave {other} out")
    if wish.jobs is not None and wish.jobs > 1:
        raise DhcliError("--follow goes from row to row, so that nobody can share them", "leave --jobs out")
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
        raise DhcliError("--each, --follow, --skip-bad and --jobs are for many poses", "name their file with --in FILE")
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
        robot,
        cast("TaskName | None", task),
        cast("Each", each),
        near,
        held,
        wish.within_limits,
        low,
        high,
        lengths,
        wish.jobs,
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
