"""Marks for answers about motion: entry by entry, in symbols by proof, in numbers within what is near enough."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import partial

from dhcli.algebra.floats import Floats
from dhcli.checking.entries import Entries, Entry, entries_text
from dhcli.checking.exercise import Case, Exercise
from dhcli.checking.motion.grid import Grid, Numbers, scale_of, typed
from dhcli.checking.motion.reading import as_read
from dhcli.checking.pasted import UnreadableError
from dhcli.checking.symbolic import about_equal, counterexample, has_decimals, same
from dhcli.checking.tolerance import is_rounding_of, judge, typed_decimals, without_unit
from dhcli.checking.verdicts import CellMark, Mark, Verdict, worst
from dhcli.kinematics.values import numbers
from dhcli.notation.quantity import LENGTH_UNITS
from dhcli.notation.walk import symbols
from dhcli.notation.writer import write

PASSED = (Verdict.RIGHT, Verdict.ROUNDED)


def mark_grid(case: Case, right: Grid, entries: Entries) -> Mark:
    """Judge an answer against the right one.

    Raises:
        UnreadableError: An entry has no finite value, or all lengths are right in another unit.
    """
    exercise = case.exercise
    cells = _in_numbers(case, right, entries) if exercise.numeric else _in_symbols(exercise, right, entries)
    verdict = worst(cell.verdict for cell in cells)
    remarks: tuple[str, ...] = ()
    if verdict is Verdict.ROUNDED:
        remarks = (
            "right to the digits typed; more digits are wanted"
            if exercise.numeric
            else "right approximately: decimals stand where an exact value is",
        )
    width = right.shape[1]
    reading = _in_rows([write(entry.typed, "short", exercise.writing) for row in entries for entry in row], width)
    expected = _in_rows([cell.expected for cell in cells], width)
    return Mark(verdict, reading, cells, remarks, _earned(cells), expected)


def values_of(entries: Entries, exercise: Exercise) -> Numbers:
    """What was typed in floats, lengths in metres.

    Raises:
        UnreadableError: An entry holds a name without a value, or is not finite.
    """
    arithmetic, found = Floats(numbers(exercise.values)), []
    for r, row in enumerate(entries):
        for c, entry in enumerate(row):
            if missing := sorted(symbols(entry.expr) - exercise.values.keys()):
                raise UnreadableError(f"entry ({r + 1},{c + 1}) holds {', '.join(missing)}, and a number was asked")
            if not math.isfinite(arithmetic.value(entry.expr)):
                raise UnreadableError(f"entry ({r + 1},{c + 1}), {entry.text}, is not a finite number")
        found.append(tuple(arithmetic.value(entry.expr) for entry in row))
    return tuple(found)


def _in_rows(cells: Sequence[str], width: int) -> str:
    return entries_text([tuple(cells[k : k + width]) for k in range(0, len(cells), width)])


def _in_symbols(exercise: Exercise, right: Grid, entries: Entries) -> tuple[CellMark, ...]:
    def cell(entry: Entry, r: int, c: int) -> CellMark:
        truth, counted = right.rows[r][c], not right.is_same_for_all(r, c)
        expected, note = write(truth, "short", exercise.writing), ""
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


def _in_numbers(case: Case, right: Grid, entries: Entries) -> tuple[CellMark, ...]:
    exercise, tolerance = case.exercise, case.tolerance
    found, truth = values_of(entries, exercise), right.numbers(exercise)
    limits = right.limits(exercise, tolerance.position, tolerance.rotation)

    def cell(entry: Entry, r: int, c: int) -> CellMark:
        scale = scale_of(exercise, right.powers[r][c])
        verdict = judge(found[r][c], truth[r][c], limits[r][c])
        number, unit = without_unit(entry.typed, scale)
        enough = tolerance.decimals is not None and (typed_decimals(number) or 0) >= tolerance.decimals
        if verdict is not Verdict.RIGHT and enough and is_rounding_of(number, truth[r][c] / unit, least=0):
            verdict = Verdict.RIGHT
        elif verdict is not Verdict.RIGHT and is_rounding_of(number, truth[r][c] / unit):
            verdict = Verdict.ROUNDED
        counted = not right.is_same_for_all(r, c)
        return CellMark(r, c, verdict, entry.text, typed(truth[r][c], scale, limits[r][c]), counted=counted)

    cells = tuple(cell(entry, r, c) for r, row in enumerate(entries) for c, entry in enumerate(row))
    if any(one.verdict not in PASSED for one in cells):
        _check_units(exercise, right, (found, truth, limits))
    return cells


def _check_units(exercise: Exercise, right: Grid, three: tuple[Numbers, Numbers, Numbers]) -> None:
    """Refuse an answer whose lengths would all be right in another unit, and whose rest is right."""
    for other in ("mm", "cm", "m") if exercise.unit != "none" else ():
        factor = float(LENGTH_UNITS[other] / exercise.metres)
        rows = zip(right.powers, *three, strict=True)
        if factor != 1 and all(
            judge(value * factor**power, truth, limit) is Verdict.RIGHT
            for row in rows
            for power, value, truth, limit in zip(*row, strict=True)
        ):
            raise UnreadableError(f"right in {other}; this sheet is in {exercise.unit}")


def _earned(cells: Sequence[CellMark]) -> float:
    """Share of the credit: that of the entries which are not the same for everybody."""
    counted = [cell for cell in cells if cell.counted] or list(cells)
    right = sum(cell.verdict in PASSED for cell in counted)
    spoiled = sum(not cell.counted and cell.verdict not in PASSED for cell in cells)
    return max(0, right - spoiled) / len(counted)
