"""`dhcli ik --rows`: the solutions of each pose of a file, as they come, however many there are."""

from __future__ import annotations

import sys
from collections.abc import Callable, Generator, Iterator, Mapping, Sequence
from contextlib import closing
from functools import partial
from itertools import islice
from typing import TYPE_CHECKING, cast

from dhcli.cli.shell.batch import BadRows
from dhcli.cli.shell.chosen import Chosen
from dhcli.cli.shell.console import say
from dhcli.cli.shell.given import lengths_of, robot_of
from dhcli.cli.shell.goal import task_of
from dhcli.cli.shell.many import ManyPoses
from dhcli.cli.shell.pose_wish import PoseWish
from dhcli.cli.shell.rows import RowDelivery
from dhcli.cli.shell.solutions import held_of, near_of
from dhcli.cli.shell.wishes import Goal, Which
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
from dhcli.files.rows.source import Source, open_source
from dhcli.frozen import frozen
from dhcli.kinematics.frames import ends
from dhcli.kinematics.inverse.batch import numbered
from dhcli.render.code.layouts import joint_layout
from dhcli.render.paper import Paper
from dhcli.render.text.problems import warning_line
from dhcli.render.text.progress import row_progress

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from dhcli.kinematics.inverse.batch import Each
    from dhcli.kinematics.inverse.tasks import TaskName

    Poses = tuple[NDArray[np.float64], Sequence[int]]


def inverse_rows(wanted: PoseWish, source: Source, delivery: RowDelivery, bad: BadRows) -> int:
    """Solve each pose of a file, and hand the joint values over as they come.

    Args:
        wanted: What is wanted of each pose.
        source: The file.
        delivery: Where the joint values go.
        bad: Takes rows that are no pose.

    Returns:
        How many poses have no solution.

    Raises:
        FileError: The file cannot be read, or a row is no pose.
    """
    poses, jobs = wanted.poses(source, bad), wanted.workers(source)
    total, lost, said = 0, 0, ""
    with (
        delivery.open(joint_layout(wanted.robot.variables)) as sink,
        row_progress(sys.stderr, wanted=delivery.is_away) as tell,
        closing(_shared(partial(_solved, wanted, source.name, sink.spell), poses, jobs)) as outcomes,
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
            tell(total, source.share)
        if bad.count and not total:
            raise bad.error("no row can be read", "")
    bad.tell(total)
    paper = Paper.of(sys.stderr)
    if said:
        say(warning_line(said, paper))
    if lost:
        have = "has" if lost == 1 else "have"
        say(warning_line(f"{lost} of {plural(total, 'pose')} {have} no solution, and no row", paper))
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
        q, index, said = wanted.solutions(poses)
    except RobotError as error:
        return [Problem(p.message, Place(source, places[0]), p.hint) for p in error.problems]
    lost = len(poses) - len(set(index.tolist()))
    return _Rows(len(poses), lost, len(q), spell(numbered(places, index, q)), said)


def _check_follow(which: Which, many: ManyPoses) -> None:
    """Make sure that a path can be followed as asked."""
    if many.each is not None or which.within_limits:
        other = "--each" if many.each is not None else "--within-limits"
        raise DhcliError(f"--follow gives one solution of each row, whatever {other} says", f"leave {other} out")
    if many.jobs is not None and many.jobs > 1:
        raise DhcliError("--follow goes from row to row, so that nobody can share them", "leave --jobs out")
    if which.near is None:
        raise DhcliError("a path needs joint values to begin near to", "give --near VALUES; they choose the branch")


def _each(which: Which, many: ManyPoses) -> Each:
    """Which solutions of each pose are wanted."""
    each = many.each or "all"
    if each not in {"all", "nearest", "first"}:
        hint = did_you_mean(each, ("all", "nearest", "first"))
        raise UnknownNameError(Problem(f"there is no {each} of solutions", Place("--each"), hint))
    if each == "nearest" and which.near is None:
        raise DhcliError("nearest to what?", "give --near VALUES")
    return cast("Each", each)


def solve_rows(
    chosen: Chosen,
    task: str | None,
    which: Which,
    many: ManyPoses,
    others: Mapping[str, object],
    delivery: RowDelivery,
) -> ExitStatus:
    """Solve each pose of a file.

    Raises:
        DhcliError: There is no file, an option does not go with it, or a row is no pose.
    """
    path = many.file(chosen.robot, others, "each row is a pose")
    if many.follow:
        _check_follow(which, many)
    each = _each(which, many)
    delivery.chosen()
    robot = robot_of(chosen)
    wanted_task = None if task is None else task_of(Goal(task=task))
    low, high = ends(robot, chosen.from_, chosen.end)
    lengths = lengths_of(robot, chosen)
    near = near_of(robot, which.near, chosen.bare)
    held = held_of(robot, which.hold or [], chosen.bare)
    wanted = PoseWish(
        robot,
        cast("TaskName | None", wanted_task),
        each,
        near,
        held,
        which.within_limits,
        low,
        high,
        lengths,
        many.jobs,
    )
    solve = inverse_rows
    if many.follow:
        from dhcli.cli.shell.follow_rows import follow_rows as solve  # few follow a path
    with open_source(path) as source:
        lost = solve(wanted, source, delivery, BadRows(path, skip=many.skip_bad))
    return ExitStatus.NOT_RIGHT if lost else ExitStatus.DONE
