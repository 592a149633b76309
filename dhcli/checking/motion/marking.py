"""Marks for answers about motion: entry by entry, in symbols by proof, in numbers within what is near enough."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import partial

from dhcli.checking.entries import Entries, Entry, entries_text, values_of
from dhcli.checking.exercise import Case, Exercise
from dhcli.checking.motion.grid import Grid, scale_of, typed
from dhcli.checking.motion.reading import as_read
from dhcli.checking.other_unit import InUnit, judged_in, plainly_in
from dhcli.checking.symbolic import about_equal, counterexample, has_decimals, same
from dhcli.checking.tolerance import Place, agreeing, is_rounding_of, judge, typed_decimals, without_unit
from dhcli.checking.verdicts import AGREEING, APPROXIMATE, TO_DIGITS, UNSOLVED, CellMark, Mark, Verdict, too_few, worst
from dhcli.notation.tree import Expr
from dhcli.notation.writer import write


def mark_grid(case: Case, right: Grid, entries: Entries) -> Mark:
    """Judge an answer against the right one.

    Raises:
        UnreadableError: An entry has no finite value, or all of the answer is right in another unit.
    """
    exercise = case.exercise
    if not exercise.numeric:
        return _marked(exercise, entries, _in_symbols(exercise, right, entries))
    mark = _marked(exercise, entries, mark_numbers(case, exercise, right, entries))
    other = None if mark.verdict in AGREEING else in_other_unit(case, right, entries, mark.cells)
    if other is None:
        agree = _agreeing(exercise, right, entries)
        is_short = all(cell.verdict in AGREEING or (cell.row, cell.column) in agree for cell in mark.cells)
        is_told = is_short and mark.verdict in UNSOLVED
        return replace(mark, remarks=(too_few(case.tolerance.decimals),)) if is_told else mark
    power = {power for row in right.powers for power in row if power}
    return judged_in(other, mark, exercise.unit, {2: "²", 3: "³"}.get(power.pop(), "") if len(power) == 1 else "")


def _marked(exercise: Exercise, entries: Entries, cells: tuple[CellMark, ...]) -> Mark:
    """The mark that follows from those of the entries."""
    verdict = worst(cell.verdict for cell in cells)
    remarks: tuple[str, ...] = ()
    if verdict is Verdict.ROUNDED:
        remarks = (TO_DIGITS if exercise.numeric else APPROXIMATE,)
    width = len(entries[0])
    reading = _in_rows([write(entry.typed, "short", exercise.writing) for row in entries for entry in row], width)
    expected = _in_rows([cell.expected for cell in cells], width)
    return Mark(verdict, reading, cells, remarks, _earned(cells, numeric=exercise.numeric), expected)


def in_other_unit(case: Case, right: Grid, entries: Entries, own: Sequence[CellMark]) -> InUnit | None:
    """A wrong answer whose lengths are plainly in another unit than that of the sheet, read in that one."""
    exercise, tolerance = case.exercise, case.tolerance
    truth = right.numbers(exercise)
    limits = right.limits(truth, tolerance.position, tolerance.rotation)

    def read(unit: str) -> InUnit:
        there = case.memo.in_unit(unit).exercise
        moved = tuple(
            tuple(
                replace(entry, expr=as_read(there, power, entry.typed))
                for entry, power in zip(row, powers, strict=True)
            )
            for row, powers in zip(entries, right.powers, strict=True)
        )
        return InUnit(unit, moved, _marked(exercise, entries, mark_numbers(case, there, right, moved)))

    lengths = [
        (value, limit) if power else (0.0, 0.0)
        for row in zip(truth, limits, right.powers, strict=True)
        for value, limit, power in zip(*row, strict=True)
    ]
    return plainly_in(map(read, exercise.other_units), own, lengths)


def _agreeing(exercise: Exercise, right: Grid, entries: Entries) -> dict[Place, bool]:
    """Where entries are the right ones with fewer decimals, and whether they have enough of these."""
    truth = right.numbers(exercise)
    numbers: dict[Place, tuple[Expr, float]] = {}
    for r, row in enumerate(entries):
        for c, entry in enumerate(row):
            if not right.only_costs(r, c):
                number, unit = without_unit(entry.typed, scale_of(exercise, right.powers[r][c]))
                numbers[r, c] = number, truth[r][c] / unit
    return agreeing(numbers)


def _in_rows(cells: Sequence[str], width: int) -> str:
    return entries_text([tuple(cells[k : k + width]) for k in range(0, len(cells), width)])


def _in_symbols(exercise: Exercise, right: Grid, entries: Entries) -> tuple[CellMark, ...]:
    shown = right.on_sheet(exercise)

    def cell(entry: Entry, r: int, c: int) -> CellMark:
        truth, counted = right.rows[r][c], not right.only_costs(r, c)
        expected, note = write(shown[r][c], "short", exercise.writing), ""
        verdict = Verdict.WRONG
        read = partial(as_read, exercise, right.powers[r][c])
        if same(entry.expr, truth, exercise.values, exercise):
            verdict = Verdict.RIGHT
        elif has_decimals(entry.typed) and about_equal(entry.typed, truth, exercise, read):
            verdict = Verdict.ROUNDED
        else:
            note = counterexample(entry.expr, truth, exercise)
        return CellMark(r, c, verdict, entry.text, expected, note, counted)

    return tuple(cell(entry, r, c) for r, row in enumerate(entries) for c, entry in enumerate(row))


def mark_numbers(case: Case, exercise: Exercise, right: Grid, entries: Entries) -> tuple[CellMark, ...]:
    """Each entry of an answer in numbers; the exercise says the unit in which it was read."""
    tolerance = case.tolerance
    found, truth = values_of(entries, exercise), right.numbers(exercise)
    limits, agree = right.limits(truth, tolerance.position, tolerance.rotation), _agreeing(exercise, right, entries)

    def cell(entry: Entry, r: int, c: int) -> CellMark:
        scale = scale_of(exercise, right.powers[r][c])
        verdict = judge(found[r][c], truth[r][c], limits[r][c])
        number, unit = without_unit(entry.typed, scale)
        enough = tolerance.decimals is not None and (typed_decimals(number) or 0) >= tolerance.decimals
        if verdict is not Verdict.RIGHT and enough and is_rounding_of(number, truth[r][c] / unit, least=0):
            verdict = Verdict.RIGHT
        elif verdict is not Verdict.RIGHT and agree.get((r, c)):
            verdict = Verdict.ROUNDED
        is_zero = judge(0.0, truth[r][c], limits[r][c]) is Verdict.RIGHT  # at these values, if not at all
        counted = not (is_zero or right.only_costs(r, c))
        return CellMark(r, c, verdict, entry.text, typed(truth[r][c], scale, limits[r][c]), counted=counted)

    return tuple(cell(entry, r, c) for r, row in enumerate(entries) for c, entry in enumerate(row))


def _earned(cells: Sequence[CellMark], *, numeric: bool) -> float:
    """Share of the credit: that of the entries which show work; others only cost something."""
    right = sum(cell.counted and cell.verdict in AGREEING for cell in cells)
    counted = sum(cell.counted for cell in cells)
    spoiled = sum(not cell.counted and cell.verdict not in AGREEING for cell in cells)
    if not counted:
        return float(not spoiled)
    return right / (counted + spoiled) if numeric else max(0, right - spoiled) / counted
