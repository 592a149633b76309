"""`dhcli fk --in`: a pose for each row of a file, as they come, however many there are."""

from __future__ import annotations

import sys
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from dhcli.cli.shell.chosen import Chosen
from dhcli.cli.shell.console import say
from dhcli.cli.shell.given import forms_of, lengths_of, open_scope, point_of
from dhcli.cli.shell.joints import typed_joints
from dhcli.cli.shell.options import workers
from dhcli.cli.shell.rows import RowDelivery
from dhcli.errors import DhcliError, FileError, Place, Problem, plural
from dhcli.files.reading import source_of
from dhcli.files.rows.blocks import MOST, Block
from dhcli.files.rows.columns import JointTable
from dhcli.files.rows.formats import Rows, joint_rows
from dhcli.files.rows.source import Source, open_source
from dhcli.kinematics.derived import in_floats
from dhcli.kinematics.frames import View
from dhcli.kinematics.many import PoseRows, is_real, numbered
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.tally import Tally
from dhcli.render.code.pose_rows import pose_layout
from dhcli.render.paper import Paper
from dhcli.render.text.problems import warning_line
from dhcli.render.text.progress import row_progress

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

_BYTES = 1 << 24
"""Bytes of a file that are worth one more thread: some hundred thousand rows of an array."""


def check_options(path: str | None, robot: str, others: Mapping[str, object]) -> str:
    """The file with the rows, if nothing else is asked for that a row cannot have.

    Args:
        path: What `--in` says.
        robot: The robot as it was typed.
        others: Options that do not go with rows, and their values.

    Raises:
        DhcliError: There is no file, or one of the others is given.
    """
    if path is None:
        raise DhcliError(
            "--skip-bad, --ignore-columns, --index and --jobs are for many poses", "name their file with --in FILE"
        )
    if path == robot == "-":
        raise DhcliError("the robot and the rows cannot both come from standard input", "save one of them in a file")
    if given := [option for option, value in others.items() if value is not None and value is not False]:
        verb = "does" if len(given) == 1 else "do"
        hint = "with --in go --q NAME=VALUE --deg --set --from --to --tool --inverse --frames --point --as --skip-bad "
        hint += "--ignore-columns --index --jobs --format -o --overwrite"
        raise DhcliError(f"{' and '.join(given)} {verb} not go with --in", hint)
    return path


def rows_wanted(
    arm: Robot,
    chosen: Chosen,
    forms: Sequence[str],
    point: str | None,
    *,
    inverse: bool,
    every: bool,
) -> PoseRows:
    """What the options ask of each row; see `fk`.

    Raises:
        DhcliError: There is no such frame or form, a length has no value, or the point is none.
    """
    if point is not None and (forms or every):
        raise DhcliError(f"--point and {'--as' if forms else '--frames'} ask for different things", "use one of them")
    view = View.of(arm, chosen.from_, chosen.end, inverse=inverse)
    lengths = lengths_of(arm, chosen)
    if point is None:
        views = view.on_the_way(arm) if every else (view,)
        return PoseRows(arm, views, lengths, forms_of(forms) or ("matrix",), every)
    from dhcli.kinematics.sweep.target import target_of

    target = target_of(arm, replace(view, point=point_of(point, "--point", open_scope(arm))), lengths)
    return PoseRows(arm, (target.view,), lengths, ("position",))


def asked_of_rows(robot: Robot, chosen: Chosen, *, ignores: bool) -> JointTable:
    """What the columns of a file are read for; a joint that `--q` gives has none.

    Raises:
        DhcliError: `--q` gives all joints, or cannot be read.
    """
    q = chosen.q
    if q is not None and "=" not in q and not q.startswith("@"):
        message = "--q gives all joints, and so does the file"
        raise DhcliError(message, "--q d3=0.1 is for a joint that has no column")
    held = {name: in_floats(value) for name, value in typed_joints(robot, q, chosen.bare).items()}
    if held and len(held) == len(robot.variables):
        raise DhcliError("--q gives all joints", "leave --in out, or a joint to the file")
    return JointTable(robot, chosen.deg, held, ignores)


def fk_rows(
    wanted: PoseRows,
    asked: JointTable,
    path: str,
    delivery: RowDelivery,
    *,
    skip_bad: bool,
    index: bool,
    jobs: int | None,
) -> None:
    """Compute a pose for each row of a file, and hand the poses over as they come.

    Args:
        wanted: What is wanted of each row.
        asked: What the file is read for.
        path: The file with the joint values; `-` for standard input.
        delivery: Where the poses go.
        skip_bad: Whether to go on without the rows that are bad.
        index: Whether each pose says where its joint values stand.
        jobs: How many threads share the computing; by default as many as a file of this size is worth.

    Raises:
        FileError: The file is no table for this robot, a row is bad, or the result cannot be written.
    """
    layout = pose_layout(wanted.forms, wanted.views if wanted.every else (), index=index)
    # With the last row of each matrix.
    whole = delivery.chosen() == "npy" and wanted.forms == ("matrix",) and not index
    tally, bad = Tally(wanted.robot), BadRows(path, skip=skip_bad)
    with open_source(path) as source:
        threads = threads_for(source, jobs)
        rows = joint_rows(source, asked, threads)
        with delivery.open(layout) as sink, row_progress(sys.stderr, wanted=delivery.is_away) as tell:
            for block in rows.blocks():
                bad.take(block.bad, block.bad_rows)
                poses = wanted.poses(block.q, threads)
                real = _real(block, poses, rows, bad)
                poses = poses[real]
                tally.take(block.q[real], block.in_radians, locked=wanted.locked(poses))
                said = poses if whole else wanted.said(poses)
                sink.write(numbered(block.rows, real, said) if index else said)
                if not sink.wanted:
                    return
                tell(sink.count + bad.count, source.share)
            if bad.count and not sink.count:
                raise bad.error("no row can be read", "")
    bad.tell(sink.count)
    paper = Paper.of(sys.stderr)
    say("".join(warning_line(message, paper) for message in tally.warnings()))


def threads_for(source: Source, jobs: int | None) -> int:
    """How many threads share the computing: as many as `--jobs` says, else as a file of this size is worth."""
    return workers(jobs, 1 + (source.size or 0) // _BYTES)


class BadRows:
    """The rows that are left out.

    Attributes:
        path: The file they stand in.
        skip: Whether to go on without them.
        count: How many there are so far.
        problems: What is wrong with the first of them.
    """

    def __init__(self, path: str, *, skip: bool) -> None:
        """None is left out yet."""
        self.path, self.skip = path, skip
        self.count = 0
        self.problems: list[Problem] = []

    def take(self, problems: Sequence[Problem], count: int) -> None:
        """Leave rows out.

        Raises:
            FileError: They may not be left out.
        """
        self.count += count
        self.problems += problems[: MOST - len(self.problems)]
        if count and not self.skip:
            raise self.error(f"{plural(count, 'row')} cannot be read", "--skip-bad goes on without them")

    def error(self, message: str, hint: str) -> FileError:
        """All that is known of them, and a last word."""
        return FileError([*self.problems, Problem(message, Place(source_of(self.path)), hint)])

    def tell(self, good: int) -> None:
        """Say how many were left out, and which."""
        if not self.count:
            return
        paper = Paper.of(sys.stderr)
        lines = [warning_line(f"left out {self.count} of {plural(good + self.count, 'row')}:", paper)]
        lines += [f"  {paper.spell(f'{problem.place}: {problem.message}')}\n" for problem in self.problems]
        listed = len({(problem.place.source, problem.place.line) for problem in self.problems if problem.place})
        if self.count > listed:
            lines.append(f"  and {plural(self.count - listed, 'row')} more\n")
        say("".join(lines))


def _real(block: Block, poses: NDArray[np.float64], rows: Rows, bad: BadRows) -> NDArray[np.bool_] | slice:
    """The rows whose pose is one."""
    real = is_real(poses)
    if real.all():
        return slice(None)
    where = (~real).nonzero()[0].tolist()
    message = "the pose has an entry that is not a real number"
    bad.take([Problem(message, rows.place_of(block.rows[i])) for i in where[:MOST]], len(where))
    return real
