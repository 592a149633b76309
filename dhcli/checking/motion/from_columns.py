"""Questions whose answer follows from the columns of a Jacobian: wrong columns, two slips, columns of one's own."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from itertools import chain, combinations
from typing import Any, TypeAlias, cast

from dhcli.algebra.floats import Floats
from dhcli.checking.diagnosis.chance import Evidence, is_chance
from dhcli.checking.diagnosis.plausible import HALF, at_a_point, has_name, is_trivial
from dhcli.checking.diagnosis.result import Slip
from dhcli.checking.entries import Entries
from dhcli.checking.exercise import Case
from dhcli.checking.motion.angles import at_other_angles
from dhcli.checking.motion.columns import Columns, columns_for, columns_of
from dhcli.checking.motion.differentiated import slopes
from dhcli.checking.motion.digits import Digits
from dhcli.checking.motion.grid import Grid, Numbers, alike, scale_of, within
from dhcli.checking.motion.mistakes import made, then
from dhcli.checking.motion.question import MotionQuestion
from dhcli.checking.pasted import UnreadableError
from dhcli.checking.returned import Causes, Judged, Reading, Shown
from dhcli.errors import DhcliError
from dhcli.frozen import frozen
from dhcli.kinematics.entries import rounded
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.values import numbers
from dhcli.kinematics.velocity.view import MotionView
from dhcli.notation.tree import Expr
from dhcli.notation.walk import symbols_in
from dhcli.notation.writer import write

Typed: TypeAlias = Mapping[tuple[int, int], Expr]
"""Entries that somebody has typed: by the row of the six, v above ω, and the column."""

Twice: TypeAlias = tuple[Slip, Columns, tuple[tuple[Slip, Columns], ...]]
"""A slip, the columns with it, and each second slip with the columns that have both."""

MOST_WORK = 40_000
"""Pairs of slips, times the entries of an answer, that are worked out: about those of six joints."""

NOTHING_FOLLOWS = (DhcliError, ZeroDivisionError, KeyError)
"""What becomes of wrong columns that lead nowhere: to no answer, or to a joint that has no value here."""

TINY = 1e-12

MOST_EARLIER = 6
"""Earlier parts of which every choice is tried."""

MOST_CAUSES = 6


@frozen
class Pair:
    """Two slips, and the answer of whoever has made both.

    Attributes:
        slips: The slips, in the order in which they are made.
        grid: The answer.
        seen: Its entries at the values given, or in symbols at one point that has nothing special about it.
    """

    slips: tuple[Slip, Slip]
    grid: Grid
    seen: Numbers


class ColumnsQuestion(MotionQuestion):
    """A question whose answer follows from the columns of a Jacobian, as does that of somebody with wrong columns."""

    __slots__ = ()

    def columns(self, case: Case) -> Columns:
        """The right columns."""
        return columns_for(case, self.motion)

    @abstractmethod
    def of_columns(self, case: Case, columns: Columns) -> Grid:
        """The answer that follows from columns.

        Raises:
            DhcliError: None does.
        """

    def besides(self, _case: Case, _columns: Columns) -> Iterable[tuple[Slip, Grid]]:
        """Slips on the way from the columns to the answer."""
        return ()

    def typed_entries(self, _case: Case, _reading: Reading[Entries]) -> tuple[MotionView, Typed] | None:
        """The entries of a Jacobian in an answer, and which Jacobian that is; None where it is no piece of one."""
        return None

    def computed(self, case: Case) -> Grid:
        """What follows from the right columns."""
        return self.of_columns(case, self.columns(case))

    def wrong(self, case: Case) -> Iterator[tuple[Slip, Grid]]:
        """What follows from wrong columns, and what follows wrongly from right ones."""
        columns = self.columns(case)
        yield from self.besides(case, columns)
        for slip, changed in chain(_slipped(case, columns), at_other_angles(case, columns)):
            with suppress(*NOTHING_FOLLOWS):
                yield slip, self.of_columns(case, changed)

    # --- Two slips ----------------------------------------------------------------------------------------------

    def pairs(self, case: Case) -> tuple[Pair, ...]:
        """Two slips at once, worked out once; none where they are too many."""
        return case.memo.of(("motion pairs", self, case.tolerance), lambda: tuple(self._paired(case)))

    def _paired(self, case: Case) -> Iterator[Pair]:
        rows, width = self.right(case).shape
        columns = self.columns(case)
        if len(_slipped(case, columns)) ** 2 / 2 * rows * width > MOST_WORK:
            return
        singles = [self._seen(case, grid) for grid in (self.right(case), *self.single_grids(case))]
        known = set(map(_rounded, singles))
        for one, changed, twice in _slipped_twice(case, columns):
            for two, grid in self._after(case, changed, twice):
                with suppress(DhcliError, KeyError, ZeroDivisionError, OverflowError):
                    seen = self._seen(case, grid)
                    if _rounded(seen) not in known:  # else one of the two has left no trace
                        yield Pair((one, two), grid, seen)

    def _after(
        self, case: Case, changed: Columns, twice: Iterable[tuple[Slip, Columns]]
    ) -> Iterator[tuple[Slip, Grid]]:
        """What follows when a second slip is made behind a first, in the columns or after them."""
        for slip, columns in twice:
            with suppress(*NOTHING_FOLLOWS):
                yield slip, self.of_columns(case, columns)
        with suppress(*NOTHING_FOLLOWS):
            yield from self.besides(case, changed)

    def _seen(self, case: Case, grid: Grid) -> Numbers:
        return grid.numbers_in(case.memo) if case.exercise.numeric else self.at_points(case.memo, grid)[0]

    def paired_causes(self, case: Case, entries: Entries) -> Causes:
        """Pairs of slips that give just this answer, where it says enough for that not to be chance."""
        every = self.pairs(case)
        given = self.given(self.right(case), entries)
        try:
            if not case.exercise.numeric:
                seen = self._seen(case, given)
                likely = [one for one in every if alike((one.seen,), (seen,))]
                return _plainest([one for one in likely if self.gives(case, one.grid, entries)])
            typed, (right, limits) = Digits.of(case.exercise, given, entries), self.right_numbers(case)
        except (KeyError, UnreadableError):
            return ()
        lengths = [bool(power) or not given.cosines for row in given.powers for power in row]
        for slack in (typed.within(limits), limits):  # as it was typed, then as near as counts as the same
            found = [one for one in every if within(typed.values, one.seen, slack)]
            if found:
                evidence = Evidence(_flat(typed.values), _flat(slack), _flat(right), lengths)
                return () if is_chance("pairs", [_flat(one.seen) for one in every], evidence) else _plainest(found)
        return ()

    # --- Follow-through -----------------------------------------------------------------------------------------

    def follows(self, case: Case, reading: Reading[Entries], earlier: Mapping[str, Reading[Any]]) -> tuple[str, ...]:
        """The earlier table, frames or position, and pieces of the Jacobian, from which an answer follows rightly."""
        columns, own, drawn = self.columns(case), [], []
        for other in case.exercise.before(case.part):
            if other.id not in earlier:
                continue
            there = Case(other, case.memo)
            if isinstance(other.question, ColumnsQuestion):
                found = other.question.typed_entries(there, earlier[other.id])
                if found is not None and found[0] == columns.view:
                    own.append((other.id, found[1]))
            elif not case.exercise.numeric and (rates := slopes(columns, other.question, earlier[other.id].value)):
                own.append((other.id, rates))
            elif (arm := other.question.arm(there, earlier[other.id])) is not None:
                drawn.append((other.id, arm))
        for names, start in (((), columns), *_drawn(columns, drawn)):
            for some in _choices(own[-MOST_EARLIER:], least=not names):
                changed = start
                for _, typed in some:
                    changed = _overlaid(changed, typed)
                try:
                    if self.gives(case, self.of_columns(case, changed), reading.value):
                        return (*names, *(name for name, _ in some))
                except (DhcliError, UnreadableError, KeyError, ZeroDivisionError, OverflowError):
                    continue
        return ()

    def is_plausible(self, case: Case, judged: Judged[Entries]) -> bool:
        """No zeros, and in numbers half right or wrong by a known slip."""
        if judged.reading is None or is_trivial(at_a_point(judged.reading.value, case.exercise.values)):
            return False
        return not case.exercise.numeric or judged.mark.earned >= HALF or has_name(judged.mark)


def _drawn(columns: Columns, arms: Sequence[tuple[str, Robot]]) -> Iterator[tuple[tuple[str, ...], Columns]]:
    """The columns of the arms that somebody has drawn, each with the part where it was."""
    for name, arm in arms:
        with suppress(*NOTHING_FOLLOWS):
            yield (name,), columns_of(arm, columns.view)


def _choices(own: Sequence[tuple[str, Typed]], *, least: bool) -> Iterator[tuple[tuple[str, Typed], ...]]:
    """Every choice of earlier pieces, from a number of them on."""
    for count in range(int(least), len(own) + 1):
        yield from combinations(own, count)


def _flat(table: Numbers) -> list[float]:
    return [value for row in table for value in row]


def _rounded(seen: Numbers) -> tuple[str, ...]:
    """Entries as they are told apart from others."""
    return tuple(f"{value:.9g}" if abs(value) > TINY else "0" for row in seen for value in row)


def _slipped(case: Case, columns: Columns) -> Sequence[tuple[Slip, Columns]]:
    """Columns with one slip, made once for an exercise, whatever its numbers."""
    kept, key = case.memo.lasting, ("slips in columns", columns.robot.name, columns.view)
    if key not in kept:
        kept[key] = tuple(made(columns))
    return cast("Sequence[tuple[Slip, Columns]]", kept[key])


def _slipped_twice(case: Case, columns: Columns) -> Sequence[Twice]:
    """The same with what a second slip makes of them."""
    kept, key = case.memo.lasting, ("two slips in columns", columns.robot.name, columns.view)
    if key not in kept:
        kept[key] = tuple((one, changed, tuple(then(changed, one))) for one, changed in _slipped(case, columns))
    return cast("Sequence[Twice]", kept[key])


def _plainest(found: Sequence[Pair]) -> Causes:
    """Those of the plainest kind."""
    least = min((sum(slip.rank for slip in one.slips) for one in found), default=0)
    return tuple(one.slips for one in found if sum(slip.rank for slip in one.slips) == least)[:MOST_CAUSES]


def _overlaid(columns: Columns, typed: Typed) -> Columns:
    """Columns with the entries that somebody has typed."""
    each = []
    for k, one in enumerate(columns.each):
        a, b, c, d, e, f = (typed.get((row, k), entry) for row, entry in enumerate((*one.linear, *one.angular)))
        each.append(replace(one, linear=(a, b, c), angular=(d, e, f)))
    return replace(columns, each=tuple(each))


def axes_step(case: Case, columns: Columns) -> Shown:
    """Axis and origin of each joint, and the point, in words."""
    exercise = case.exercise

    def vector(entries: Iterable[Expr], power: int) -> str:
        entries = tuple(entries)
        if exercise.numeric and not symbols_in(entries) - exercise.values.keys():
            arithmetic = Floats(numbers(exercise.values))
            return ", ".join(rounded(arithmetic.value(one) / scale_of(exercise, power)) for one in entries)
        shown = map(exercise.on_sheet, entries) if power == 1 else entries
        return ", ".join(write(one, "short", exercise.writing) for one in shown)

    lines = [f"Vectors along the axes of frame {columns.view.axes}; p = ({vector(columns.point, 1)})"]
    for one in columns.each:
        what = f"{one.joint} {'turns about' if one.turns else 'slides along'} ({vector(one.axis, 0)})"
        lines.append(what + (f" through ({vector(one.origin, 1)})" if one.turns else ""))
    lines.append("A joint that turns moves the point by axis x (p - o), one that slides along its axis")
    return Shown("\n".join(lines))
