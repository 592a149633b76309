"""`dhcli ik --rows --follow`: a path of poses on one branch, with its jumps and singular passages told."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from typing import TYPE_CHECKING

from dhcli.cli.shell.batch import BadRows
from dhcli.cli.shell.console import say
from dhcli.cli.shell.pose_wish import PoseWish
from dhcli.cli.shell.rows import RowDelivery
from dhcli.errors import FileError, Place, Problem, RobotError
from dhcli.files.rows.source import Source
from dhcli.kinematics.inverse.path import follow, joined
from dhcli.render.code.layouts import joint_layout
from dhcli.render.paper import Paper
from dhcli.render.text.problems import warning_line

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

MOST_TOLD = 8
"""Rows that a warning names; of more, it tells how many."""


def follow_rows(wanted: PoseWish, source: Source, delivery: RowDelivery, bad: BadRows) -> int:
    """Follow the poses of a file, each by the joint values nearest to those before it.

    Args:
        wanted: What is wanted of each pose.
        source: The file.
        delivery: Where the joint values go.
        bad: Takes rows that are no pose.

    Returns:
        How many poses are out of reach.

    Raises:
        FileError: The file cannot be read, or a row is no pose.
    """
    table, places = _read(wanted, source, bad)
    try:
        found = follow(
            wanted.robot,
            table,
            None if wanted.near is None else list(wanted.near),
            task=wanted.task_of(table),
            hold=wanted.hold,
            start=wanted.start,
            end=wanted.end,
            parameters=wanted.lengths,
        )
    except RobotError as error:
        raise FileError([Problem(p.message, Place(source.name), p.hint) for p in error.problems]) from None
    with delivery.open(joint_layout(wanted.robot.variables)) as sink:
        sink.write(found.numbered(places))
    bad.tell(len(places))
    _tell(places, found.jumps, "the arm jumps to another branch before")
    _tell(places, found.singular, "the arm is singular, or nearly, at")
    _tell(places, found.lost, "out of reach, and without a row:")
    return len(found.lost)


def _read(wanted: PoseWish, source: Source, bad: BadRows) -> tuple[NDArray[np.float64], list[int]]:
    """All poses of a file, or all positions, and where each stands.

    Raises:
        FileError: There are none, or some of either.
    """
    blocks, places = list["NDArray[np.float64]"](), list[int]()
    for poses, where in wanted.poses(source, bad):
        if blocks and poses.ndim != blocks[0].ndim:
            message = "is a position among poses, or a pose among positions: a path is of one or the other"
            raise FileError(Problem(message, Place(source.name, where[0])))
        blocks.append(poses)
        places += where
    if not blocks and bad.count:
        raise bad.error("no row can be read", "")
    if not blocks:
        raise FileError(Problem("holds no poses", Place(source.name)))
    return joined(blocks), places


def _tell(places: Sequence[int], at: Sequence[int], words: str) -> None:
    if at:
        rows = ", ".join(str(places[k]) for k in at[:MOST_TOLD])
        more = f" and {len(at) - MOST_TOLD} more" if len(at) > MOST_TOLD else ""
        say(warning_line(f"{words} row {rows}{more}", Paper.of(sys.stderr)))
