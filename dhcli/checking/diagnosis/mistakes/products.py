"""Mistakes in putting factors together."""

from __future__ import annotations

from dataclasses import replace
from itertools import combinations, pairwise

from dhcli.checking.diagnosis.record import Catalogue
from dhcli.checking.diagnosis.result import Rank
from dhcli.checking.diagnosis.work import Factor, Level, Made, Maker, Multiplied, Setting, Work, steps_between
from dhcli.kinematics.conventions import Row
from dhcli.kinematics.frames import View, span_of
from dhcli.notation.tree import ZERO

IN_PRODUCTS: Catalogue[Maker] = Catalogue(Level.PRODUCT)
OF_FRAMES: Catalogue[Maker] = Catalogue(Level.PRODUCT)


@IN_PRODUCTS(
    "order-reversed",
    "the factors are multiplied in the reverse order",
    "in which order are the factors multiplied?",
    rank=Rank.WHOLE,
)
def reversed_order(work: Work, _setting: Setting) -> Made:
    """All factors from right to left; in a single row that is the other convention's order."""
    if len(work.steps) > 1:
        yield "", replace(work, steps=work.steps[::-1])


@IN_PRODUCTS(
    "last-first",
    "the last factor is multiplied from the left, as for a move about the fixed axes",
    "from which side is each new factor multiplied?",
)
def last_first(work: Work, _setting: Setting) -> Made:
    """The newest factor on the left of all others; with two factors that is the reverse order."""
    if len(work.steps) > 2:  # noqa: PLR2004
        yield "", replace(work, steps=(work.steps[-1], *work.steps[:-1]))


@IN_PRODUCTS(
    "first-last",
    "the first factor is multiplied from the right, behind all others",
    "from which side is each new factor multiplied?",
)
def first_last(work: Work, _setting: Setting) -> Made:
    """The first factor behind all others, such as a shift that is made in the turned frame."""
    if len(work.steps) > 2:  # noqa: PLR2004  with two it is the reverse order
        yield "", replace(work, steps=(*work.steps[1:], work.steps[0]))


@IN_PRODUCTS("factors-swapped", "factors {where} have changed places", "in which order are the factors multiplied?")
def swapped(work: Work, _setting: Setting) -> Made:
    """Two neighbours of three or more moves or matrices; the rows of a table have numbers that keep them in order."""
    steps = work.steps
    if len(steps) > 2:  # noqa: PLR2004
        for k, (one, other) in enumerate(pairwise(steps)):
            if one.row is None and other.row is None:
                changed = (*steps[:k], other, one, *steps[k + 2 :])
                yield f"{one.name} and {other.name}", replace(work, steps=changed)


@IN_PRODUCTS("factor-missing", "factor {where} is missing in the product", "count the factors of the product")
def missing(work: Work, _setting: Setting) -> Made:
    """A factor left out: a link, the base, the tool; a row with a single cell has that cell forgotten."""
    if len(work.steps) > 1:
        for index, step in enumerate(work.steps):
            if step.row is None or _filled(step.row) > 1:
                yield step.name, replace(work, steps=(*work.steps[:index], *work.steps[index + 1 :]))


@IN_PRODUCTS("factor-twice", "factor {where} stands twice in the product", "count the factors of the product")
def twice(work: Work, _setting: Setting) -> Made:
    """A factor multiplied in twice."""
    if len(work.steps) > 1:
        for index, step in enumerate(work.steps):
            yield step.name, replace(work, steps=(*work.steps[: index + 1], step, *work.steps[index + 1 :]))


@IN_PRODUCTS(
    "translation-not-rotated",
    "the positions are added without turning them into the reference frame",
    "in which frame is each shift measured?",
    rank=Rank.SYMPTOM,  # of a planar arm the position of somebody who takes every angle from x0
)
def unrotated(work: Work, _setting: Setting) -> Made:
    """Positions added as they stand."""
    yield "", replace(_factored(work), multiplied=Multiplied.UNROTATED)


@IN_PRODUCTS(
    "element-wise",
    "the matrices are multiplied entry by entry, not rows by columns",
    "how are two matrices multiplied?",
)
def elementwise(work: Work, _setting: Setting) -> Made:
    """Entries multiplied one by one."""
    yield "", replace(_factored(work), multiplied=Multiplied.ELEMENTWISE)


def _factored(work: Work) -> Work:
    """The work with the moves of a single link as its factors."""
    if len(work.steps) > 1:
        return work
    moves = tuple(Factor(f"{step.name}.{k}", (move,)) for step in work.steps for k, move in enumerate(step.chain, 1))
    return replace(work, steps=moves)


def _filled(row: Row) -> int:
    """Cells of a row that are not zero."""
    return sum((row.a != ZERO, not row.alpha.is_zero, row.d != ZERO, not row.theta.is_zero))


@OF_FRAMES(
    "tool-forgotten",
    "the tool is forgotten: this ends at the frame of the last link",
    "where does the arm end: at the frame of its last link, or at its tool?",
)
def tool_forgotten(work: Work, _setting: Setting) -> Made:
    """The pose of frame n where that of the tool is asked."""
    if len(work.steps) > 1 and work.steps[-1].name == "tool":
        yield "", replace(work, steps=work.steps[:-1])


@OF_FRAMES(
    "base-forgotten",
    "the base is forgotten: this is seen from the frame of the first joint",
    "from where is it seen: from the base, or from the frame of the first joint?",
)
def base_forgotten(work: Work, _setting: Setting) -> Made:
    """The pose seen from frame 0 where the base is asked."""
    if len(work.steps) > 1 and work.steps[0].name == "base":
        yield "", replace(work, steps=work.steps[1:])


@OF_FRAMES(
    "other-frames",
    "this is the pose of frame {term} seen from frame {entry}",
    "from which frame to which is it asked?",
    rank=Rank.SYMPTOM,
    alone=True,
)
def other_frames(work: Work, setting: Setting) -> Made:
    """The pose of another frame, or seen from another, T_16 or T_03 for T_06; or the next link, A_2 for A_1."""
    robot, source = setting.robot, work.question.source
    if robot is None or not isinstance(source, View):
        return
    asked = sorted(span_of(robot, source))
    for first, last in combinations(range(len(robot.frames)), 2):
        shared = (first == asked[0]) + (last == asked[1])
        is_next = last - first == asked[1] - asked[0] == 1 and abs(first - asked[0]) == 1
        steps = steps_between(robot, setting, first, last) if shared == 1 or is_next else ()
        if steps:
            yield f"{robot.frames[first]} {robot.frames[last]}", replace(work, steps=steps)
