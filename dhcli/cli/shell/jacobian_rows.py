"""`dhcli jacobian --rows`: a Jacobian for each row of a file, as they come, however many there are."""

from __future__ import annotations

import sys
from collections.abc import Mapping

from dhcli.cli.shell.batch import BadRows, threads_for
from dhcli.cli.shell.console import say
from dhcli.cli.shell.rows import RowDelivery
from dhcli.errors import DhcliError, Problem
from dhcli.files.rows.blocks import MOST
from dhcli.files.rows.columns import JointTable
from dhcli.files.rows.formats import joint_rows
from dhcli.files.rows.source import open_source
from dhcli.kinematics.many import is_real, numbered
from dhcli.kinematics.tally import Tally
from dhcli.kinematics.velocity.rows import JacobianRows
from dhcli.render.code.pose_rows import INDEX
from dhcli.render.code.rows import Group, Layout
from dhcli.render.paper import Paper
from dhcli.render.text.problems import warning_line
from dhcli.render.text.progress import row_progress


def check_options(path: str | None, robot: str, others: Mapping[str, object]) -> None:
    """Make sure that nothing is asked for that a row cannot have.

    Raises:
        DhcliError: There is no file, or one of the others is given.
    """
    if path is None:
        hint = "name their file with --rows FILE"
        raise DhcliError("--skip-bad, --ignore-columns, --index and --jobs are for many joint values", hint)
    if path == robot == "-":
        raise DhcliError("the robot and the rows cannot both come from standard input", "save one of them in a file")
    if given := [option for option, value in others.items() if value is not None and value is not False]:
        verb = "does" if len(given) == 1 else "do"
        raise DhcliError(f"{' and '.join(given)} {verb} not go with --rows", "rows are numbers, csv, jsonl or npy")


def jacobian_layout(wanted: JacobianRows, *, index: bool) -> Layout:
    """The columns: row by row, `v_x_theta1`, `v_x_theta2`; JSON Lines nests them."""
    labels, joints = wanted.layout
    heads = tuple(f"{label.replace('ω', 'w')}_{joint}".replace("'", "") for label in labels for joint in joints)
    row = f"[{', '.join(['%s'] * len(joints))}]"
    group = Group("matrix", heads, f"[{', '.join([row] * len(labels))}]")
    return Layout((INDEX, group)) if index else Layout((group,), (len(labels), len(joints)))


def jacobian_rows(
    wanted: JacobianRows,
    asked: JointTable,
    path: str,
    delivery: RowDelivery,
    *,
    skip_bad: bool,
    index: bool,
    jobs: int | None,
) -> None:
    """Compute a Jacobian for each row of a file, and hand them over as they come; see `fk_rows`.

    Raises:
        FileError: The file is no table for this robot, a row is bad, or the result cannot be written.
    """
    layout = jacobian_layout(wanted, index=index)
    whole = delivery.chosen() == "npy" and not index
    tally, bad = Tally(wanted.robot), BadRows(path, skip=skip_bad)
    with open_source(path) as source:
        threads = threads_for(source, jobs)
        rows = joint_rows(source, asked, threads)
        with delivery.open(layout) as sink, row_progress(sys.stderr, wanted=delivery.is_away) as tell:
            for block in rows.blocks():
                bad.take(block.bad, block.bad_rows)
                found = wanted.jacobians(block.q, threads)
                real = is_real(found)
                if not real.all():
                    where = (~real).nonzero()[0].tolist()
                    message = "the Jacobian has an entry that is not a real number here"
                    bad.take([Problem(message, rows.place_of(block.rows[i])) for i in where[:MOST]], len(where))
                tally.take(block.q[real], block.in_radians)
                said = found[real] if whole else found[real].reshape(int(real.sum()), -1)
                sink.write(numbered(block.rows, real, said) if index else said)
                if not sink.wanted:
                    return
                tell(sink.count + bad.count, source.share)
            if bad.count and not sink.count:
                raise bad.error("no row can be read", "")
    bad.tell(sink.count)
    paper = Paper.of(sys.stderr)
    say("".join(warning_line(message, paper) for message in tally.warnings()))
