"""Symbolic answers: every form of the right expression is right, and a wrong one gets numbers to think about."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from fractions import Fraction
from functools import partial

from dhcli.algebra.equality import equal_in_floats, equal_in_residues
from dhcli.algebra.floats import Floats
from dhcli.algebra.points import all_round
from dhcli.checking.entries import Entries, Entry, as_read
from dhcli.checking.exercise import Exercise, Memo
from dhcli.checking.reach import reach_of
from dhcli.checking.truth import Truth, is_length
from dhcli.checking.verdicts import AGREEING, APPROXIMATE, CellMark, Mark, Verdict
from dhcli.checking.wanted import Wanted
from dhcli.kinematics.robot import Value
from dhcli.notation.tree import Expr, Number
from dhcli.notation.walk import parted, rebuild, substitute, walk
from dhcli.notation.writer import write

MOST_OFF = 0.05
"""What decimals in the place of exact values may be off in all, as a share of the size of the truth: that of 0.10."""

REST = 1e-12


def mark_symbols(question: Wanted, truth: Truth, entries: Entries, memo: Memo) -> Mark:
    """Judge an answer in expressions, entry by entry; what stands in many answers of a class is judged once."""

    def judged(entry: Entry, place: tuple[int, int]) -> CellMark:
        made = partial(_cell, question, truth, entry, place, memo.exercise)
        return memo.recent(("cells", question), (place, entry), made)

    cells = tuple(judged(entry, (r, c)) for r, row in enumerate(entries) for c, entry in enumerate(row))
    bad = [cell for cell in cells if cell.verdict is not Verdict.RIGHT]
    verdict = Verdict.RIGHT
    if bad:
        approximate = all(cell.verdict is Verdict.ROUNDED for cell in bad)
        verdict = Verdict.ROUNDED if approximate else Verdict.WRONG
    remarks: tuple[str, ...] = ()
    if verdict is Verdict.ROUNDED:
        remarks = (APPROXIMATE,)
    if verdict is Verdict.WRONG and question.piece == "pose":
        remarks = _half_right(cells)
    counted = [cell for cell in cells if cell.counted]
    right = sum(cell.verdict in AGREEING for cell in counted)
    spoiled = sum(not cell.counted for cell in bad)  # a zero that is no zero costs what an entry earns
    earned = max(0, right - spoiled) / len(counted) if counted else float(not spoiled)
    if verdict is Verdict.WRONG and question.piece == "pose" and _is_identity(entries):
        earned = 0.0
    return Mark(verdict, cells=cells, remarks=remarks, earned=earned)


def same(first: Expr, second: Expr, values: Mapping[str, Value], exercise: Exercise | None = None) -> bool:
    """Whether two expressions are equal, for all values or at the values given.

    Args:
        first: An expression.
        second: Another.
        values: Values that may stand for their names.
        exercise: Says which values the other names have, where residues cannot decide.
    """
    if _are_equal(first, second, exercise):
        return True
    return bool(values) and _are_equal(put(first, values), put(second, values), exercise)


def _are_equal(first: Expr, second: Expr, exercise: Exercise | None) -> bool:
    known = equal_in_residues(first, second)
    if known is None:
        return equal_in_floats(first, second, reach_of(exercise) if exercise is not None else None)
    return known


def is_exactly(typed: Expr, right: Expr, exercise: Exercise) -> bool:
    """Whether an expression is the right one itself, as 0.5 is cos 60°, and 0.8660 or 13/15 is not cos 30°."""
    exact, truth = put(typed, exercise.values), put(right, exercise.values)
    known = equal_in_residues(exact, truth)
    if known is None:  # floats tell only what is no exact number: it has digits
        return not has_decimals(typed) and same(exact, truth, {}, exercise)
    return known


def put(expr: Expr, values: Mapping[str, Value]) -> Expr:
    """An expression with given values in the place of their names."""
    return substitute(expr, *parted(values))


def _cell(question: Wanted, truth: Truth, entry: Entry, place: tuple[int, int], exercise: Exercise) -> CellMark:
    row, column = place
    right = truth.rows[row][column]
    counted = not truth.is_structural(row, column)
    expected = write(_on_sheet(question, right, place, exercise), "short", exercise.writing)
    if same(entry.expr, right, exercise.values, exercise):
        return CellMark(row, column, Verdict.RIGHT, entry.text, expected, counted=counted)
    read = partial(as_read, question, row, column, exercise)
    if has_decimals(entry.typed) and about_equal(entry.typed, right, exercise, read):
        return CellMark(row, column, Verdict.ROUNDED, entry.text, expected, counted=counted)
    note = counterexample(entry.expr, right, exercise)
    return CellMark(row, column, Verdict.WRONG, entry.text, expected, note, counted)


def _on_sheet(question: Wanted, right: Expr, place: tuple[int, int], exercise: Exercise) -> Expr:
    """A right entry as it is written on the sheet."""
    return exercise.on_sheet(right) if is_length(question, *place) else right


def has_decimals(expr: Expr) -> bool:
    """Whether a decimal with a fraction stands in an expression, as 0.866 does for sqrt(3)/2."""
    return any(isinstance(n, Number) and n.places is not None and n.value.denominator != 1 for n in walk(expr))


def about_equal(typed: Expr, right: Expr, exercise: Exercise, read: Callable[[Expr], Expr]) -> bool:
    """Whether an answer agrees at forty points when each decimal may be off by half a unit of its last digit.

    However often a decimal stands in it, all together are never worth more than a share of the truth: a zero that is
    made of decimals is not half of everything.

    Args:
        typed: The answer as it was typed, for its digits.
        right: The truth.
        exercise: For its values, whose own digits do not matter.
        read: What was typed, in metres.
    """
    reach, values = reach_of(exercise), exercise.values
    others = (_shifted(typed, index) for index in range(sum(_is_decimal(node) for node in walk(typed))))
    shifted = [put(read(other), values) for other in others]
    typed, right = put(read(typed), values), put(right, values)
    points = [Floats(drawn) for drawn in all_round((typed, right), reach)]
    truths = [over.value(right) for over in points]
    most = MOST_OFF * max((abs(truth) for truth in truths), default=0.0)
    for over, truth in zip(points, truths, strict=True):
        value = over.value(typed)
        slack = min(most, sum(abs(over.value(other) - value) for other in shifted))
        if not abs(value - truth) <= slack + REST:
            return False
    return True


def _is_decimal(node: Expr) -> bool:
    return isinstance(node, Number) and node.places is not None and node.value.denominator != 1


def _shifted(expr: Expr, index: int) -> Expr:
    """The expression with one of its decimals moved by half a unit of its last digit."""
    seen = -1

    def leaf(node: Expr) -> Expr:
        nonlocal seen
        if not _is_decimal(node):
            return node
        seen += 1
        if seen != index or not isinstance(node, Number) or node.places is None:
            return node
        return replace(node, value=node.value + Fraction(1, 2 * 10**node.places))

    return rebuild(expr, leaf)


def counterexample(typed: Expr, right: Expr, exercise: Exercise) -> str:
    """Where an answer holds, if it does anywhere, and a point where it differs from the truth, with both numbers."""
    from dhcli.checking.branches import explained

    typed, right = put(typed, exercise.values), put(right, exercise.values)
    return explained(typed, right, reach_of(exercise), writing=exercise.writing)


def _half_right(cells: tuple[CellMark, ...]) -> tuple[str, ...]:
    """Which half of a pose is right, where one is."""
    wrong = [cell for cell in cells if cell.verdict is Verdict.WRONG]
    in_position = sum(cell.column == 3 for cell in wrong)  # noqa: PLR2004  the fourth column
    if in_position == len(wrong):
        return ("the rotation is right; the position is not",)
    return () if in_position else ("the position is right; the rotation is not",)


def _is_identity(entries: Entries) -> bool:
    return all(
        isinstance(entry.expr, Number) and entry.expr.value == (r == c)
        for r, row in enumerate(entries)
        for c, entry in enumerate(row)
    )
