"""What a lecturer writes beside the matrices of a solution: a product coordinate by coordinate, a table row by row."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TypeAlias

from dhcli.algebra.floats import Floats
from dhcli.checking.exercise import Exercise, Part
from dhcli.checking.expected import expected
from dhcli.checking.marking import mark
from dhcli.checking.questions import MatrixQuestion
from dhcli.checking.truth import is_length, truth_of
from dhcli.checking.verdicts import Verdict
from dhcli.kinematics.conventions import Row
from dhcli.kinematics.pose import DIGITS, rounded
from dhcli.kinematics.values import numbers
from dhcli.notation.angle import Angle
from dhcli.notation.matrix import bracketed
from dhcli.notation.tree import Expr, Sum
from dhcli.notation.writer import write, write_angle

Rows: TypeAlias = tuple[tuple[Expr | float, ...], ...]

MOST_DECIMALS = 6
"""Decimals of an answer that is shown to be copied, if it is right with them."""


def answer_text(exercise: Exercise, part: Part) -> str:
    """The right answer as it may be typed: a column in one pair of brackets, numbers with as few digits as will do."""
    question = part.question
    if not isinstance(question, MatrixQuestion):
        return expected(exercise, part)
    truth = truth_of(question, exercise)
    if not exercise.numeric or truth.numbers is None:
        return _matrix([[write(entry, "short", exercise.writing) for entry in row] for row in truth.rows])
    for digits in (MOST_DECIMALS, 2 * MOST_DECIMALS):
        cells = [
            [rounded(value / _unit(question, exercise, r, c), digits) for c, value in enumerate(row)]
            for r, row in enumerate(truth.numbers)
        ]
        if mark(exercise, part, _matrix(cells)).verdict is Verdict.RIGHT:
            return _matrix(cells)
    return expected(exercise, part)


def product_lines(question: MatrixQuestion, rows: Rows, exercise: Exercise) -> Iterator[str]:
    """A matrix times the column of a point or a vector, a line for each coordinate; what is zero is left out.

    Args:
        question: Asks for a point or a vector.
        rows: The matrix, shape (4, 4); lengths of numbers in the unit of the sheet.
        exercise: The exercise, for its unit and how it writes angles.
    """
    truth = truth_of(question, exercise)
    scale = float(exercise.metres) if exercise.numeric else 1.0
    over = Floats(numbers(exercise.values))
    column: list[Expr | float] = [over.value(v) / scale if exercise.numeric else v for v in question.point]
    column.append(float(question.piece == "point"))
    for k, name in enumerate("xyz"):
        terms = [
            _times(_text(entry, exercise), _text(factor, exercise))
            for entry, factor in zip(rows[k], column, strict=True)
        ]
        total = " + ".join(term for term in terms if term) or "0"
        value: Expr | float = truth.rows[k][0]
        if truth.numbers is not None and exercise.numeric:
            value = truth.numbers[k][0] / scale
        result = rounded(value, DIGITS) if isinstance(value, float) else write(value, "short", exercise.writing)
        left = total.replace("+ -", "- ")
        yield f"{name} = {left}" if left == result else f"{name} = {left} = {result}"


def table_lines(rows: Sequence[Row], columns: Sequence[str], first: int, exercise: Exercise) -> Iterator[str]:
    """A DH table, a line for each row with its values by name, below each other.

    Args:
        rows: The rows.
        columns: The columns in the robot's order.
        first: Number of the first row.
        exercise: The exercise, for how it writes angles.
    """
    cells = [[f"{column} = {_value(getattr(row, column), exercise)}" for column in columns] for row in rows]
    widths = [max(map(len, column)) for column in zip(*cells, strict=True)]
    for number, row in enumerate(cells, first):
        texts = (text.ljust(width) for text, width in zip(row, widths, strict=True))
        yield f"row {number}:  {'   '.join(texts)}".rstrip()


def _matrix(cells: Sequence[Sequence[str]]) -> str:
    if all(len(row) == 1 for row in cells):
        return cells[0][0] if len(cells) == 1 else "[" + ", ".join(row[0] for row in cells) + "]"
    return bracketed(cells)


def _unit(question: MatrixQuestion, exercise: Exercise, row: int, column: int) -> float:
    return float(exercise.metres) if is_length(question, row, column) else 1.0


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


def _value(value: Expr | Angle, exercise: Exercise) -> str:
    if isinstance(value, Angle):
        return write_angle(value, "short", exercise.writing)
    return write(value, "short", exercise.writing)
