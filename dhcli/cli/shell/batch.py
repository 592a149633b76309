"""`fk --rows` and `jacobian --rows`: a result for each row of a file, as they come, however many there are."""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING

from dhcli.cli.shell.chosen import Chosen
from dhcli.cli.shell.console import say
from dhcli.cli.shell.joints import typed_joints
from dhcli.cli.shell.many import Many
from dhcli.cli.shell.options import workers
from dhcli.cli.shell.rows import RowDelivery
from dhcli.errors import DhcliError, FileError, Place, Problem, plural
from dhcli.files.reading import source_of
from dhcli.files.rows.blocks import MOST, Block
from dhcli.files.rows.columns import JointTable
from dhcli.files.rows.formats import Rows, joint_rows
from dhcli.files.rows.source import Source, open_source
from dhcli.frozen import frozen
from dhcli.kinematics.derived import in_floats
from dhcli.kinematics.many import is_real, numbered
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.tally import Tally
from dhcli.render.code.rows import Layout
from dhcli.render.paper import Paper
from dhcli.render.text.problems import gathered, others_text, warning_line
from dhcli.render.text.progress import row_progress

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

_BYTES = 1 << 24
"""Bytes of a file that are worth one more thread: some hundred thousand rows of an array."""


@frozen
class Work:
    """What is computed of each row of joint values.

    Attributes:
        robot: The robot.
        layout: The columns of the results.
        computed: Results of joint values, shape (N, ...), by so many threads; NaN where one is not real.
        said: The numbers of results as they stand in their columns.
        unreal: What to say of a result that is not real.
        locked: For each form of three angles that is asked for, in how many results only two of them can be told.
    """

    robot: Robot
    layout: Layout
    computed: Callable[[NDArray[np.float64], int], NDArray[np.float64]]
    said: Callable[[NDArray[np.float64]], NDArray[np.float64]]
    unreal: str
    locked: Callable[[NDArray[np.float64]], Mapping[str, int]] = lambda _: {}


def joint_table(robot: Robot, chosen: Chosen, many: Many) -> JointTable:
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
        raise DhcliError("--q gives all joints", "leave --rows out, or a joint to the file")
    return JointTable(robot, chosen.deg, held, many.ignore_columns)


def compute_rows(work: Work, table: JointTable, path: str, delivery: RowDelivery, many: Many) -> None:
    """Compute a result for each row of a file, and hand the results over as they come.

    Args:
        work: What is computed.
        table: What the file is read for.
        path: The file with the joint values; `-` for standard input.
        delivery: Where the results go.
        many: Whether to go on without bad rows, whether each result says where its row stands, and how many threads
            share the computing; by default as many as a file of this size is worth.

    Raises:
        FileError: The file is no table for this robot, a row is bad, or the result cannot be written.
    """
    delivery.chosen()
    tally, bad = Tally(work.robot), BadRows(path, skip=many.skip_bad)
    with open_source(path) as source:
        threads = threads_for(source, many.jobs)
        rows = joint_rows(source, table, threads)
        with delivery.open(work.layout) as sink, row_progress(sys.stderr, wanted=delivery.is_away) as tell:
            for block in rows.blocks():
                bad.take(block.bad, block.bad_rows)
                results = work.computed(block.values, threads)
                real = _real(block, results, work.unreal, rows, bad)
                results = results[real]
                tally.take(block.values[real], block.in_radians, locked=work.locked(results))
                said = work.said(results)
                sink.write(numbered(block.rows, real, said) if many.index else said)
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
        for problem, places in gathered(self.problems):
            more = f", the same {others_text(places)}" if places else ""
            lines.append(f"  {paper.spell(f'{problem.place}: {problem.message}{more}')}\n")
        listed = len({(problem.place.source, problem.place.line) for problem in self.problems if problem.place})
        if self.count > listed:
            lines.append(f"  and {plural(self.count - listed, 'row')} more\n")
        say("".join(lines))


def _real(
    block: Block, results: NDArray[np.float64], unreal: str, rows: Rows, bad: BadRows
) -> NDArray[np.bool_] | slice:
    """The rows whose result is one."""
    real = is_real(results)
    if real.all():
        return slice(None)
    where = (~real).nonzero()[0].tolist()
    bad.take([Problem(unreal, rows.place_of(block.rows[i])) for i in where[:MOST]], len(where))
    return real
