"""How a matrix is worked out and written: its factors, their products, a coordinate term by term, the answer."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from typing import TypeAlias

from dhcli.algebra.floats import Floats
from dhcli.algebra.terms import TERMS
from dhcli.checking.entries import entries_text
from dhcli.checking.exercise import Case, Exercise
from dhcli.checking.returned import Rows, Shown
from dhcli.checking.tolerance import ZERO as NOTHING
from dhcli.checking.truth import chain_of, entries_on_sheet, is_length, truth_of, unit_of
from dhcli.checking.units import on_sheet
from dhcli.checking.wanted import Composed, Wanted
from dhcli.kinematics.conventions import ORDER
from dhcli.kinematics.entries import DIGITS, rounded
from dhcli.kinematics.fold import fold
from dhcli.kinematics.forward import pose_rows, put_in, textbook_form
from dhcli.kinematics.frames import View, between, span_of
from dhcli.kinematics.moves import Chain, names, spelled
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.values import numbers
from dhcli.notation.matrix import bracketed
from dhcli.notation.names import natural_key
from dhcli.notation.quantity import value_text
from dhcli.notation.tree import Expr, Sum
from dhcli.notation.writer import write

Entries: TypeAlias = tuple[tuple[Expr, ...], ...]

MOST_DECIMALS = 6
"""Decimals of an answer that is shown to be copied, if it is right with them."""


def matrix_steps(case: Case, question: Wanted) -> Iterator[Shown]:
    """The matrices and their product, then the piece of it that is asked for."""
    exercise = case.exercise
    if isinstance(question.source, View) and exercise.robot is not None:
        yield from _links(exercise, exercise.robot, question.source)
    elif isinstance(question.source, Composed):
        yield from _moves(exercise, question.source.chain)
    if question.inverse:
        back = "The inverse: the moves undone in the opposite order, R transposed and -R^T p"
        yield Shown(back, _product(exercise, chain_of(question, exercise.robot)))
    row, column = question.index
    point = coordinates(question, exercise)
    pieces = {
        "rotation": "The rotation is its upper left 3x3",
        "position": "The position is its last column, without the 1",
        "entry": f"Entry ({row + 1},{column + 1}) is in row {row + 1}, column {column + 1}",
        "axis": f"The {'xyz'[row]} axis is column {row + 1}, without the 0",
        "point": f"A point is multiplied with a 1 below it: ({point}, 1)",
        "vector": f"A vector is only turned, so it is multiplied with a 0 below it: ({point}, 0)",
    }
    if question.piece in pieces:
        yield Shown(pieces[question.piece])
    if question.piece in ("point", "vector"):
        rows = _product(exercise, chain_of(question, exercise.robot))
        yield Shown("\n".join(("The matrix times this column:", *product_lines(case, question, rows))))


def _links(exercise: Exercise, robot: Robot, span: View) -> Iterator[Shown]:
    """Each link matrix, then the products from right to left, which keep the brackets small."""
    first, last = span_of(robot, span)
    low, high = min(first, last), max(first, last)
    yield Shown(ORDER[robot.convention] + _in_unit(exercise))
    for i in range(low, high):
        before, after = robot.frames[i], robot.frames[i + 1]
        chain = between(robot, before, after)
        yield Shown(f"From frame {before} to frame {after}{_values(exercise, chain)}", _product(exercise, chain))
    for i in range(high - 2, low - 1, -1):
        start, middle, end = robot.frames[i], robot.frames[i + 1], robot.frames[high]
        chain = between(robot, start, end)
        yield Shown(f"T_{start}{end} = T_{start}{middle} T_{middle}{end}", _product(exercise, chain))
    if first > last:
        start, end = robot.frames[high], robot.frames[low]
        yield Shown(f"T_{start}{end} is its inverse", _product(exercise, between(robot, start, end)))


def _moves(exercise: Exercise, chain: Chain) -> Iterator[Shown]:
    """The frame after each move, from left to right."""
    for count, move in enumerate(chain, 1):
        reached = chain[:count]
        rows = _product(exercise, reached) if exercise.numeric else _in_unit_of_sheet(fold(reached, TERMS), exercise)
        yield Shown(f"Move {count}: {spelled(move)}", rows)


def _product(exercise: Exercise, chain: Chain) -> Rows:
    """The product of a chain with what the task gives: in textbook form, or in numbers in the unit of the sheet."""
    if not exercise.numeric:
        rows = textbook_form(put_in(chain, exercise.given))
        return _in_unit_of_sheet(rows, exercise)
    unit = float(exercise.metres)
    *upper, bottom = pose_rows(chain, exercise.values)
    return (*((*row[:3], row[3] / unit) for row in upper), bottom)


def _in_unit_of_sheet(rows: Entries, exercise: Exercise) -> Entries:
    """A matrix in symbols with the numbers in its lengths in the unit of the sheet."""
    *upper, bottom = rows
    return (*((*row[:3], exercise.on_sheet(row[3])) for row in upper), bottom)


def _values(exercise: Exercise, chain: Chain) -> str:
    """The values that go into a matrix of numbers."""
    if not exercise.numeric:
        return ""
    unit = exercise.behind.strip()
    wanted = sorted(names(chain) & exercise.values.keys(), key=natural_key)
    listed = ", ".join(f"{name} = {value_text(exercise.values[name], unit)}" for name in wanted)
    return f", with {listed}" if listed else ""


def _in_unit(exercise: Exercise) -> str:
    return f", lengths in {exercise.unit}" if exercise.numeric and exercise.unit != "none" else ""


def as_text(case: Case, question: Wanted, style: str = "short") -> str:
    """The right answer as text; numbers in the unit of the sheet."""
    exercise, truth = case.exercise, truth_of(question, case)
    if exercise.numeric and truth.numbers is not None:
        return entries_text(
            tuple(
                tuple(_decimal(value / unit_of(question, r, c, exercise)) for c, value in enumerate(row))
                for r, row in enumerate(truth.numbers)
            )
        )
    return entries_text(_written(question, truth.rows, exercise, style))


def _written(question: Wanted, rows: tuple[tuple[Expr, ...], ...], exercise: Exercise, style: str) -> list[list[str]]:
    """Entries in symbols as they are typed, the numbers in lengths in the unit of the sheet."""
    entries = entries_on_sheet(question, rows, exercise)
    return [[write(entry, style, exercise.writing) for entry in row] for row in entries]


def shortest(case: Case, question: Wanted, is_right: Callable[[str], bool]) -> str:
    """The right answer as it may be typed: a column in one pair of brackets, numbers with as few digits as will do."""
    exercise, truth = case.exercise, truth_of(question, case)
    if not exercise.numeric or truth.numbers is None:
        return _matrix(_written(question, truth.rows, exercise, "short"))
    for digits in (MOST_DECIMALS, 2 * MOST_DECIMALS):
        cells = [
            [rounded(value / unit_of(question, r, c, exercise), digits) for c, value in enumerate(row)]
            for r, row in enumerate(truth.numbers)
        ]
        if is_right(_matrix(cells)):
            return _matrix(cells)
    return as_text(case, question)


def product_lines(case: Case, question: Wanted, rows: Rows) -> Iterator[str]:
    """A matrix times the column of a point or a vector, a line for each coordinate; what is zero is left out.

    Args:
        case: Where it is asked, for its unit and how it writes angles.
        question: Asks for a point or a vector.
        rows: The matrix, shape (4, 4); lengths of numbers in the unit of the sheet.
    """
    exercise, truth = case.exercise, truth_of(question, case)
    unit = exercise.metres if is_length(question, 0, 0) else Fraction(1)
    scale = float(unit) if exercise.numeric else 1.0
    over = Floats(numbers(exercise.values))
    column: list[Expr | float] = [
        over.value(v) / scale if exercise.numeric else on_sheet(v, unit, exercise.scope) for v in question.point
    ]
    column.append(float(question.piece == "point"))
    for k, name in enumerate("xyz"):
        terms = [
            _times(_text(entry, exercise), _text(factor, exercise))
            for entry, factor in zip(rows[k], column, strict=True)
        ]
        total = " + ".join(term for term in terms if term) or "0"
        value: Expr | float = on_sheet(truth.rows[k][0], unit, exercise.scope)
        if truth.numbers is not None and exercise.numeric:
            value = truth.numbers[k][0] / scale
        result = rounded(value, DIGITS) if isinstance(value, float) else write(value, "short", exercise.writing)
        left = total.replace("+ -", "- ")
        yield f"{name} = {left}" if left == result else f"{name} = {left} = {result}"


def coordinates(question: Wanted, exercise: Exercise) -> str:
    """The point or the vector of a question, in the unit of the sheet: `20, -30, 50`."""
    unit = exercise.metres if is_length(question, 0, 0) else Fraction(1)
    shown = [on_sheet(value, unit, exercise.scope) for value in question.point]
    return ", ".join(write(value, "short", exercise.writing) for value in shown)


def _matrix(cells: Sequence[Sequence[str]]) -> str:
    if all(len(row) == 1 for row in cells):
        return cells[0][0] if len(cells) == 1 else "[" + ", ".join(row[0] for row in cells) + "]"
    return bracketed(cells)


def _times(entry: str, factor: str) -> str:
    """One product; empty if it is zero, and 1 is not written."""
    if "0" in (entry, factor):
        return ""
    if factor == "1":
        return entry
    if entry in ("1", "-1"):
        return factor if entry == "1" else f"-{factor}" if not factor.startswith("-") else factor[1:]
    return f"{entry}*{factor}" if not factor.startswith("-") else f"{entry}*({factor})"


def _text(value: Expr | float, exercise: Exercise) -> str:
    """A factor; a sum in brackets."""
    if isinstance(value, float | int):
        return rounded(value, DIGITS)
    text = write(value, "short", exercise.writing)
    return f"({text})" if isinstance(value, Sum) else text


def _decimal(value: float) -> str:
    """A number in digits that can be typed; what is nothing but rounding of floats is 0."""
    return "0" if abs(value) < NOTHING else f"{value:.10g}"
