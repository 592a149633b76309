"""`dhcli fk --in`: a pose for each row of a file, as they come, however many there are."""

from __future__ import annotations

import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from dhcli.cli.console import say
from dhcli.cli.given import forms_of, settings_of
from dhcli.cli.rows import RowDelivery
from dhcli.errors import DhcliError, FileError, Place, Problem, plural
from dhcli.files.reading import source_of
from dhcli.files.robots import load_robot
from dhcli.files.rows.blocks import MOST, Block
from dhcli.files.rows.reading import Rows, rows_of
from dhcli.files.rows.source import open_source
from dhcli.kinematics.many import PoseRows, frames_wanted, is_real
from dhcli.kinematics.tally import Tally
from dhcli.kinematics.values import parameter_values
from dhcli.render.paper import Paper
from dhcli.render.pose_rows import pose_layout
from dhcli.render.problems import warning_line
from dhcli.render.progress import row_progress

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray


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
        raise DhcliError("--skip-bad is for many poses", "name their file with --in FILE")
    if path == robot == "-":
        raise DhcliError("the robot and the rows cannot both come from standard input", "save one of them in a file")
    if given := [option for option, value in others.items() if value is not None and value is not False]:
        verb = "does" if len(given) == 1 else "do"
        hint = "with --in go --deg --set --from --to --inverse --frames --as --skip-bad --format -o --force"
        raise DhcliError(f"{' and '.join(given)} {verb} not go with --in", hint)
    return path


def rows_wanted(
    robot: str,
    start: str | None,
    end: str | None,
    settings: Sequence[str],
    forms: Sequence[str],
    *,
    inverse: bool,
    every: bool,
) -> PoseRows:
    """What the options ask of each row; see `fk`.

    Raises:
        DhcliError: There is no such robot, frame or form, or a length has no value.
    """
    arm = load_robot(robot)
    frames = frames_wanted(arm, start, end, inverse=inverse, every=every)
    lengths = parameter_values(arm, settings_of(settings), Place("--set", text=" ".join(settings)))
    return PoseRows(arm, frames, lengths, forms_of(forms) or ("matrix",), every)


def fk_rows(wanted: PoseRows, path: str, delivery: RowDelivery, *, degrees: bool, skip_bad: bool) -> None:
    """Compute a pose for each row of a file, and hand the poses over as they come.

    Args:
        wanted: What is wanted of each row.
        path: The file with the joint values; `-` for standard input.
        delivery: Where the poses go.
        degrees: Whether numbers of revolute joints without a unit are degrees.
        skip_bad: Whether to go on without the rows that are bad.

    Raises:
        FileError: The file is no table for this robot, a row is bad, or the result cannot be written.
    """
    layout = pose_layout(wanted.forms, wanted.frames if wanted.every else ())
    whole = delivery.chosen() == "npy" and wanted.forms == ("matrix",)  # with the last row of each matrix
    tally, bad = Tally(wanted.robot), BadRows(path, skip=skip_bad)
    to_file = delivery.output is not None or not sys.stdout.isatty()
    with open_source(path) as source:
        rows = rows_of(source, wanted.robot, degrees=degrees)
        with delivery.open(layout) as sink, row_progress(sys.stderr, wanted=to_file) as tell:
            for block in rows.blocks():
                bad.take(block.bad, block.bad_rows)
                q, poses = _real(block, wanted.poses(block.q), rows, bad)
                tally.take(q, block.in_radians, locked=wanted.locked(poses))
                sink.write(poses if whole else wanted.said(poses))
                if not sink.wanted:
                    return
                tell(sink.count + bad.count, source.share)
            if bad.count and not sink.count:
                raise bad.error("no row can be read", "")
    bad.tell(sink.count)
    paper = Paper.of(sys.stderr)
    say("".join(warning_line(message, paper) for message in tally.warnings()))


@dataclass(slots=True)
class BadRows:
    """The rows that are left out.

    Attributes:
        path: The file they stand in.
        skip: Whether to go on without them.
        count: How many there are so far.
        problems: What is wrong with the first of them.
    """

    path: str
    skip: bool
    count: int = 0
    problems: list[Problem] = field(default_factory=list)

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


def _real(
    block: Block, poses: NDArray[np.float64], rows: Rows, bad: BadRows
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Joint values and poses without the rows whose pose is none."""
    real = is_real(poses)
    if real.all():
        return block.q, poses
    where = (~real).nonzero()[0].tolist()
    message = "the pose has an entry that is not a real number"
    bad.take([Problem(message, rows.place_of(block.rows[i])) for i in where[:MOST]], len(where))
    return block.q[real], poses[real]
