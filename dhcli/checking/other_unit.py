"""Numbers in another unit than that of the sheet: seen where lengths are plainly in it, with what else is wrong."""

from __future__ import annotations

from dataclasses import replace

from dhcli.checking.entries import Entries, in_unit_of
from dhcli.checking.exercise import Memo
from dhcli.checking.numeric import limits_of, mark_numbers
from dhcli.checking.pasted import WrongUnitError
from dhcli.checking.tolerance import CLEAR, Tolerance
from dhcli.checking.truth import Truth, is_length
from dhcli.checking.verdicts import AGREEING, IN_OTHER_UNIT, UNSOLVED, Mark, Verdict
from dhcli.checking.wanted import Wanted


def mark_measured(question: Wanted, truth: Truth, entries: Entries, memo: Memo, tolerance: Tolerance) -> Mark:
    """Judge an answer in numbers, whatever unit its lengths are in.

    Raises:
        UnreadableError: An entry has no finite value, or the answer is right in another unit.
    """
    exercise = memo.exercise
    judged = mark_numbers(question, truth, entries, exercise, tolerance)
    if judged.verdict in UNSOLVED:
        return _in_other_unit(question, truth, entries, memo, tolerance, judged) or judged
    return judged


def _in_other_unit(
    question: Wanted, truth: Truth, entries: Entries, memo: Memo, tolerance: Tolerance, own: Mark
) -> Mark | None:
    """The judgement of a wrong answer whose lengths are plainly in another unit: what else is wrong is said in that.

    Raises:
        UnreadableError: Nothing else is wrong.
    """
    unit, other = _plain_unit(question, truth, entries, memo, tolerance, own)
    exercise = memo.exercise
    if other is None:
        return None
    if other.verdict in AGREEING:
        digits = ", to the digits typed" if other.verdict is Verdict.ROUNDED else ""
        raise WrongUnitError(unit, f"this sheet is in {exercise.unit}", digits)
    cells = tuple(replace(cell, expected=one.expected) for cell, one in zip(other.cells, own.cells, strict=True))
    remark = f"{IN_OTHER_UNIT}{unit}; this sheet is in {exercise.unit}: the rest is judged in {unit}"
    return Mark(Verdict.WRONG, cells=cells, remarks=(remark, *other.remarks), earned=own.earned)


def plain_unit(question: Wanted, truth: Truth, entries: Entries, memo: Memo, tolerance: Tolerance) -> str:
    """The unit, not that of the sheet, in which the lengths of a wrong answer plainly are; empty if there is none."""
    if truth.numbers is None:
        return ""
    return _plain_unit(question, truth, entries, memo, tolerance)[0]


def _plain_unit(
    question: Wanted, truth: Truth, entries: Entries, memo: Memo, tolerance: Tolerance, own: Mark | None = None
) -> tuple[str, Mark | None]:
    """The unit in which the lengths plainly are, and the judgement in it; asked when judging and when explaining."""
    exercise = memo.exercise

    def found() -> tuple[str, Mark | None]:
        here = own or mark_numbers(question, truth, entries, exercise, tolerance)
        for unit in exercise.other_units:
            there = memo.in_unit(unit).exercise
            other = mark_numbers(question, truth, in_unit_of(question, entries, there), there, tolerance)
            if _is_plainly(question, truth, here, other, tolerance):
                return unit, other
        return "", None

    return memo.recent(("plain unit", question, tolerance), entries, found)


def _is_plainly(question: Wanted, truth: Truth, own: Mark, other: Mark, tolerance: Tolerance) -> bool:
    """Whether lengths that are not near zero are right in another unit, and none in that of the sheet."""
    assert truth.numbers is not None  # noqa: S101
    limits, found = limits_of(question, truth, tolerance), False
    for here, there in zip(own.cells, other.cells, strict=True):
        r, c = here.row, here.column
        if not is_length(question, r, c) or abs(truth.numbers[r][c]) <= limits[r][c]:
            continue
        if here.verdict in AGREEING and there.verdict not in AGREEING:
            return False
        is_clear = abs(truth.numbers[r][c]) > CLEAR * limits[r][c]
        found = found or (is_clear and there.verdict in AGREEING and here.verdict not in AGREEING)
    return found
