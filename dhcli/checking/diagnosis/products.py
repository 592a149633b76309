"""Mistakes in putting factors together."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from dhcli.checking.diagnosis.work import Factor, Multiplied, Setting, Work
from dhcli.kinematics.conventions import Row
from dhcli.notation.tree import ZERO


def reversed_order(work: Work, _setting: Setting) -> Iterator[tuple[str, Work]]:
    """All factors from right to left; in a single row that is the other convention's order."""
    if len(work.steps) > 1:
        yield "", replace(work, steps=work.steps[::-1])


def last_first(work: Work, _setting: Setting) -> Iterator[tuple[str, Work]]:
    """The newest factor on the left of all others; with two factors that is the reverse order."""
    if len(work.steps) > 2:  # noqa: PLR2004
        yield "", replace(work, steps=(work.steps[-1], *work.steps[:-1]))


def missing(work: Work, _setting: Setting) -> Iterator[tuple[str, Work]]:
    """A factor left out: a link, the base, the tool; a row with a single cell has that cell forgotten."""
    if len(work.steps) > 1:
        for index, step in enumerate(work.steps):
            if step.row is None or _filled(step.row) > 1:
                yield step.name, replace(work, steps=(*work.steps[:index], *work.steps[index + 1 :]))


def twice(work: Work, _setting: Setting) -> Iterator[tuple[str, Work]]:
    """A factor multiplied in twice."""
    if len(work.steps) > 1:
        for index, step in enumerate(work.steps):
            yield step.name, replace(work, steps=(*work.steps[: index + 1], step, *work.steps[index + 1 :]))


def unrotated(work: Work, _setting: Setting) -> Iterator[tuple[str, Work]]:
    """Positions added as they stand."""
    yield "", replace(_factored(work), multiplied=Multiplied.UNROTATED)


def elementwise(work: Work, _setting: Setting) -> Iterator[tuple[str, Work]]:
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
