"""Numeric answers: rotation cells and lengths each with their own tolerance, and the digits a student typed."""

from __future__ import annotations

import math
from dataclasses import replace

from dhcli.checking.entries import Entries, Entry, in_unit_of, values_of
from dhcli.checking.exercise import Exercise, Memo
from dhcli.checking.orientations import (
    LEAST_SLACK,
    Matrix,
    angle_between,
    is_inverse,
    near,
    not_orthonormal,
    transposed,
    turned,
)
from dhcli.checking.other_unit import InUnit, judged_in, plainly_in
from dhcli.checking.symbolic import is_exactly
from dhcli.checking.tolerance import (
    NOT_EXACT,
    ZERO,
    Place,
    Tolerance,
    agreeing,
    is_rounding_of,
    judge,
    typed_decimals,
    without_unit,
)
from dhcli.checking.truth import Truth, is_length, unit_of
from dhcli.checking.verdicts import (
    AGREEING,
    INVERSE,
    TO_DIGITS,
    TRANSPOSED,
    UNSOLVED,
    CellMark,
    Mark,
    Verdict,
    too_few,
    worst,
)
from dhcli.checking.wanted import Wanted
from dhcli.kinematics.entries import rounded
from dhcli.notation.tree import Expr

LEAST_TURN = 0.1
"""Turn below which entries that are wrong have too few digits and no wrong direction [deg]."""

RELATIVE = 1e-3
"""Tolerance of a length where none is declared, as a share of the robot's size."""


def mark_measured(question: Wanted, truth: Truth, entries: Entries, memo: Memo, tolerance: Tolerance) -> Mark:
    """Judge an answer in numbers, whatever unit its lengths are in.

    Raises:
        UnreadableError: An entry has no finite value, or the answer is right in another unit.
    """
    own = mark_numbers(question, truth, entries, memo.exercise, tolerance)
    other = in_other_unit(question, truth, entries, memo, tolerance, own) if own.verdict in UNSOLVED else None
    return own if other is None else judged_in(other, own, memo.exercise.unit)


def in_other_unit(
    question: Wanted, truth: Truth, entries: Entries, memo: Memo, tolerance: Tolerance, own: Mark | None = None
) -> InUnit | None:
    """A wrong answer whose lengths are plainly in another unit; asked when judging and when explaining."""
    right = truth.numbers
    if right is None:
        return None

    def read(unit: str) -> InUnit:
        there = memo.in_unit(unit).exercise
        moved = in_unit_of(question, entries, there)
        return InUnit(unit, moved, mark_numbers(question, truth, moved, there, tolerance))

    def found() -> InUnit | None:
        cells = (own or mark_numbers(question, truth, entries, memo.exercise, tolerance)).cells
        limits, places = limits_of(question, truth, tolerance), [(cell.row, cell.column) for cell in cells]
        lengths = [(right[r][c], limits[r][c]) if is_length(question, r, c) else (0.0, 0.0) for r, c in places]
        return plainly_in(map(read, memo.exercise.other_units), cells, lengths)

    return memo.recent(("plain unit", question, tolerance), entries, found)


def mark_numbers(
    question: Wanted,
    truth: Truth,
    entries: Entries,
    exercise: Exercise,
    tolerance: Tolerance,
) -> Mark:
    """Judge an answer in numbers, its bare lengths in the unit of the sheet.

    Raises:
        UnreadableError: An entry has no finite value.
    """
    assert truth.numbers is not None  # noqa: S101  the caller has looked
    typed = values_of(entries, exercise)
    limits = limits_of(question, truth, tolerance)
    cells = tuple(
        _cell(question, truth, entries[r][c], typed[r][c], limits[r][c], tolerance, (r, c), exercise)
        for r in range(len(typed))
        for c in range(len(typed[r]))
    )
    agree = _agreeing(question, truth, entries, exercise)
    is_short = all(cell.verdict is Verdict.RIGHT or (cell.row, cell.column) in agree for cell in cells)
    cells = tuple(
        replace(cell, verdict=Verdict.ROUNDED)
        if cell.verdict is not Verdict.RIGHT and agree.get((cell.row, cell.column))
        else cell
        for cell in cells
    )
    verdict = worst(cell.verdict for cell in cells)
    if verdict is Verdict.ROUNDED:
        remarks: tuple[str, ...] = (TO_DIGITS,)
    elif verdict in UNSOLVED and is_short:
        remarks = (too_few(tolerance.decimals),)  # no more is wrong: no angle, no distance
    else:
        remarks = _remarks(question, truth.numbers, typed, cells, exercise, _slack(entries))
    if tolerance.exact and verdict is Verdict.RIGHT and not _is_exact(truth, entries, exercise):
        verdict, remarks = Verdict.ROUNDED, (NOT_EXACT, *remarks)
    return Mark(verdict, cells=cells, remarks=remarks, earned=_earned(question, cells, typed, verdict))


def limits_of(question: Wanted, truth: Truth, tolerance: Tolerance) -> list[list[float]]:
    """What each entry may be off: a length by a share of the robot, a direction cosine by its own tolerance."""
    position = tolerance.position if tolerance.position is not None else max(RELATIVE * truth.size, ZERO)
    if question.piece == "vector" and not is_length(question, 0, 0):  # a direction of any length
        position = tolerance.rotation
        longest = max((abs(row[0]) for row in truth.numbers or ()), default=1.0)
        return [[position * max(1.0, longest)] for _ in truth.rows]
    return [
        [position if is_length(question, r, c) else tolerance.rotation for c in range(len(row))]
        for r, row in enumerate(truth.rows)
    ]


def _cell(  # noqa: PLR0913, PLR0917  everything an entry is judged by
    question: Wanted,
    truth: Truth,
    entry: Entry,
    typed: float,
    limit: float,
    tolerance: Tolerance,
    place: tuple[int, int],
    exercise: Exercise,
) -> CellMark:
    row, column = place
    assert truth.numbers is not None  # noqa: S101
    right = truth.numbers[row][column]
    verdict = judge(typed, right, limit)
    scale = unit_of(question, row, column, exercise)
    if verdict is not Verdict.RIGHT and tolerance.decimals is not None:
        number, unit = without_unit(entry.typed, scale)
        enough = (typed_decimals(number) or 0) >= tolerance.decimals
        if enough and is_rounding_of(number, right / unit, least=0):
            verdict = Verdict.RIGHT
    is_zero = is_length(question, row, column) and judge(0.0, right, limit) is Verdict.RIGHT  # at the values given
    counted = not (is_zero or truth.is_structural(row, column))
    return CellMark(row, column, verdict, entry.text, rounded(right / scale), counted=counted)


def _agreeing(question: Wanted, truth: Truth, entries: Entries, exercise: Exercise) -> dict[Place, bool]:
    """Where entries are the truth with fewer decimals, and whether they have enough of these."""
    assert truth.numbers is not None  # noqa: S101
    numbers: dict[Place, tuple[Expr, float]] = {}
    for r, row in enumerate(entries):
        for c, entry in enumerate(row):
            if not truth.is_structural(r, c):
                number, scale = without_unit(entry.typed, unit_of(question, r, c, exercise))
                numbers[r, c] = number, truth.numbers[r][c] / scale
    return agreeing(numbers)


def _is_exact(truth: Truth, entries: Entries, exercise: Exercise) -> bool:
    """Whether every entry is the truth itself."""
    return all(
        is_exactly(entry.expr, right, exercise)
        for row, rights in zip(entries, truth.rows, strict=True)
        for entry, right in zip(row, rights, strict=True)
    )


def _matters(cell: CellMark) -> bool:
    """Whether an entry counts: zeros and what is the same for everybody only where they are wrong."""
    return cell.counted or cell.verdict is not Verdict.RIGHT


def _earned(question: Wanted, cells: tuple[CellMark, ...], typed: Matrix, verdict: Verdict) -> float:
    """Share of the credit: the rotation is one item, each length is one; the identity earns nothing."""
    if verdict in AGREEING:
        return 1.0
    if question.piece == "pose" and all(
        abs(value - (r == c)) < RELATIVE for r, row in enumerate(typed) for c, value in enumerate(row)
    ):
        return 0.0
    cosines = [cell for cell in cells if not is_length(question, cell.row, cell.column)]
    lengths = [cell for cell in cells if is_length(question, cell.row, cell.column)]
    items: list[bool] = []
    if any(_matters(cell) for cell in cosines):
        items.append(all(cell.verdict in AGREEING for cell in cosines))
    items += [cell.verdict in AGREEING for cell in lengths if _matters(cell)]
    return sum(items) / len(items) if items else 0.0


def _slack(entries: Entries) -> float:
    """What the digits typed allow a length or a dot product to be off: four half units of the commonest digits."""
    places = [p for row in entries[:3] for entry in row[:3] if (p := typed_decimals(entry.typed)) is not None]
    return max(2 * 10.0 ** -max(places, key=places.count), LEAST_SLACK) if places else LEAST_SLACK


def _remarks(
    question: Wanted, right: Matrix, typed: Matrix, cells: tuple[CellMark, ...], exercise: Exercise, slack: float
) -> tuple[str, ...]:
    """What geometry says: not a rotation, transposed, inverse, or by which angle the orientation is off."""
    wrong = [cell for cell in cells if cell.verdict is not Verdict.RIGHT]
    if not wrong or question.piece not in ("pose", "rotation"):
        return ()
    rotation = [row[:3] for row in typed[:3]]
    unsharp = [cell for cell in wrong if not is_length(question, cell.row, cell.column)]
    is_turned = any(cell.verdict in UNSOLVED for cell in unsharp)
    fault = not_orthonormal(rotation, slack) if is_turned else None
    if fault:
        return (fault,)
    truth = [row[:3] for row in right[:3]]
    if is_turned and not near(rotation, truth) and math.degrees(angle_between(rotation, truth)) >= LEAST_TURN:
        if not near(transposed(rotation), truth):
            return (turned(rotation, truth),)
        if question.piece == "pose" and is_inverse(typed, right):
            return (INVERSE,)
        return (TRANSPOSED,)
    said = ("the axes point the right way, but their direction cosines need more digits",) if unsharp else ()
    displaced = [cell.row for cell in wrong if is_length(question, cell.row, cell.column) and cell.verdict in UNSOLVED]
    offsets = [(k, exercise.about(typed[k][3] - right[k][3])) for k in displaced]
    off = ", ".join(f"{offset} along {'xyz'[k]}" for k, offset in offsets if offset.split()[0] != "0")
    if not off:
        return said
    return (*said, f"{'' if said else 'the rotation is right; '}the position is off by {off}")
