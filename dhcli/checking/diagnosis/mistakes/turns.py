"""Mistakes in what the turns of rows are: about which axis, from which direction, by which function.

None of them is made in a pair, as those between rows are not.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from itertools import pairwise

from dhcli.checking.diagnosis.mistakes.changes import all_rows, each, in_row
from dhcli.checking.diagnosis.mistakes.rows import sine_cosine
from dhcli.checking.diagnosis.record import Catalogue
from dhcli.checking.diagnosis.result import Rank
from dhcli.checking.diagnosis.work import Factor, Level, Made, Maker, Setting, Work
from dhcli.kinematics.conventions import Convention, Row
from dhcli.notation.angle import Angle

IN_TURNS: Catalogue[Maker] = Catalogue(Level.TABLE)

IN_TURNS(
    "sin-cos-all",
    "sine and cosine of the joint angles have changed places in every row",
    "look at sine and cosine of the joint angles",
    rank=Rank.SYMPTOM,
    alone=True,
)(all_rows(sine_cosine))


def turns_swapped(row: Row, _setting: Setting) -> Row:
    """The two angles in each other's place: the turn about z made about x, and that about x about z."""
    return replace(row, alpha=row.theta, theta=row.alpha)


IN_TURNS(
    "theta-alpha-swapped",
    "theta and alpha of row {where} have changed places",
    "look at theta and alpha in row {where}: which turns about x, which about z?",
    alone=True,
)(each(turns_swapped))

IN_TURNS(
    "theta-alpha-swaps",
    "theta and alpha have changed places in every row",
    "look at theta and alpha: which turns about x, which about z?",
    alone=True,
)(all_rows(turns_swapped))


@IN_TURNS(
    "theta-absolute",
    "the angle of row {where} is counted as if the link before had not turned",
    "from which direction is the angle of row {where} counted?",
    alone=True,
)
def theta_absolute(work: Work, setting: Setting) -> Made:
    """C2 for c12: the direction of a link itself, in the place of its angle to the link before."""
    for index, factor in _absolute(work, setting):
        yield factor.name, work.with_step(index, factor)


@IN_TURNS(
    "thetas-absolute",
    "the angles of parallel joints are counted as if no link had turned before",
    "from which direction is the angle of each link counted?",
    alone=True,
)
def thetas_absolute(work: Work, setting: Setting) -> Made:
    """C3 for c123, too."""
    changed = dict(_absolute(work, setting))
    if len(changed) > 1:
        yield "", replace(work, steps=tuple(changed.get(index, step) for index, step in enumerate(work.steps)))


def are_parallel(before: Row, row: Row, convention: Convention) -> bool:
    """Whether the axes of two rows, one behind the other, point the same way."""
    return (before if convention is Convention.STANDARD else row).alpha.quarter_turns() == 0


def _absolute(work: Work, setting: Setting) -> Iterator[tuple[int, Factor]]:
    """The rows that turn about an axis parallel to the one before, each with its angle counted from where that is."""
    moving = set(setting.variables)
    for index, (before, step) in enumerate(pairwise(work.steps), 1):
        if before.row is None or step.row is None:
            continue
        both = before.row.theta.names & moving and step.row.theta.names & moving
        if both and are_parallel(before.row, step.row, setting.convention):
            turned = Angle(before.row.theta.terms)
            row = replace(step.row, theta=step.row.theta - turned)
            factor = setting.factor((_absolute, before, step), partial(in_row, step, row, setting.convention))
            if factor is not None:
                yield index, factor
