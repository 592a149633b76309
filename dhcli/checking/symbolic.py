"""Symbolic answers: every form of the right expression is right, and a wrong one gets numbers to think about."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction
from itertools import islice

from dhcli.algebra.equality import equal
from dhcli.algebra.floats import Floats
from dhcli.algebra.points import general
from dhcli.checking.entries import Entries, Entry
from dhcli.checking.exercise import Exercise
from dhcli.checking.truth import Truth
from dhcli.checking.verdicts import CellMark, Mark, Verdict
from dhcli.checking.wanted import Wanted
from dhcli.kinematics.robot import Value
from dhcli.notation.angle import Angle
from dhcli.notation.tree import Expr, Number
from dhcli.notation.walk import rebuild, substitute, symbols, walk
from dhcli.notation.writer import write

POINTS = 6
SEED = 7


def mark_symbols(question: Wanted, truth: Truth, entries: Entries, exercise: Exercise) -> Mark:
    """Judge an answer in expressions, entry by entry.

    Args:
        question: The question.
        truth: The right answer.
        entries: The answer as read, in the shape of the question.
        exercise: The exercise, for its values and its way of writing.
    """
    cells = tuple(_cell(truth, entry, (r, c), exercise) for r, row in enumerate(entries) for c, entry in enumerate(row))
    bad = [cell for cell in cells if cell.verdict is not Verdict.RIGHT]
    verdict = Verdict.RIGHT
    if bad:
        approximate = all(cell.verdict is Verdict.ROUNDED for cell in bad)
        verdict = Verdict.ROUNDED if approximate else Verdict.WRONG
    remarks: tuple[str, ...] = ()
    if verdict is Verdict.ROUNDED:
        remarks = ("right approximately: decimals stand where an exact value is",)
    if verdict is Verdict.WRONG and question.piece == "pose":
        remarks = _half_right(cells)
    counted = [cell for cell in cells if cell.counted] or list(cells)
    right = sum(cell.verdict in (Verdict.RIGHT, Verdict.ROUNDED) for cell in counted)
    spoiled = sum(not cell.counted for cell in bad)  # a zero that is no zero costs what an entry earns
    earned = max(0, right - spoiled) / len(counted)
    if verdict is Verdict.WRONG and question.piece == "pose" and _is_identity(entries):
        earned = 0.0
    return Mark(verdict, cells=cells, remarks=remarks, earned=earned)


def same(first: Expr, second: Expr, values: Mapping[str, Value]) -> bool:
    """Whether two expressions are equal, for all values or at the values given."""
    if equal(first, second):
        return True
    return bool(values) and equal(put(first, values), put(second, values))


def put(expr: Expr, values: Mapping[str, Value]) -> Expr:
    """An expression with given values in the place of their names."""
    lengths = {name: value for name, value in values.items() if isinstance(value, Expr)}
    angles = {name: value for name, value in values.items() if isinstance(value, Angle)}
    return substitute(expr, lengths, angles)


def _cell(truth: Truth, entry: Entry, place: tuple[int, int], exercise: Exercise) -> CellMark:
    row, column = place
    right = truth.rows[row][column]
    counted = not truth.is_structural(row, column)
    expected = write(right, "short", exercise.writing)
    if same(entry.expr, right, exercise.values):
        return CellMark(row, column, Verdict.RIGHT, entry.text, expected, counted=counted)
    if has_decimals(entry.expr) and _about_equal(entry.expr, right, exercise.values):
        return CellMark(row, column, Verdict.ROUNDED, entry.text, expected, counted=counted)
    note = counterexample(entry.expr, right, exercise)
    return CellMark(row, column, Verdict.WRONG, entry.text, expected, note, counted)


def has_decimals(expr: Expr) -> bool:
    """Whether a decimal with a fraction stands in an expression, as 0.866 does for sqrt(3)/2."""
    return any(isinstance(n, Number) and n.places is not None and n.value.denominator != 1 for n in walk(expr))


def _about_equal(typed: Expr, right: Expr, given: Mapping[str, Value]) -> bool:
    """Whether an answer agrees at several points when each decimal may be off by half a unit of its last digit."""
    typed, right = put(typed, given), put(right, given)
    shifted = [_shifted(typed, index) for index in range(sum(_is_decimal(node) for node in walk(typed)))]
    for values in islice(general(symbols(typed) | symbols(right), SEED), POINTS):
        point = Floats(values)
        value, slack = point.value(typed), 1e-12
        slack += sum(abs(point.value(other) - value) for other in shifted)
        if not abs(value - point.value(right)) <= slack:
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
    """A point where the answer differs from the truth, with both numbers."""
    typed, right = put(typed, exercise.values), put(right, exercise.values)
    for drawn in islice(general(symbols(typed) | symbols(right), SEED), POINTS):
        values = {name: round(value, 1) for name, value in drawn.items()}
        over = Floats(values)
        one, other = over.value(typed), over.value(right)
        if abs(one - other) > 1e-6:  # noqa: PLR2004
            where = ", ".join(f"{name} = {value:g}" for name, value in values.items())
            at = f"at {where}: " if where else ""
            return f"{at}yours gives {one:.4g}, the right one {other:.4g}"
    return ""


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
