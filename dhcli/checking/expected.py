"""The right answer to a part, as a person would type it."""

from __future__ import annotations

from collections.abc import Sequence

from dhcli.checking.counts import right_count
from dhcli.checking.exercise import Exercise, Part
from dhcli.checking.questions import (
    CellQuestion,
    ChoiceQuestion,
    CountQuestion,
    FactorsQuestion,
    MatrixQuestion,
    ScalarQuestion,
    TableQuestion,
)
from dhcli.checking.tolerance import ZERO as NOTHING
from dhcli.checking.truth import Truth, is_length, truth_of
from dhcli.errors import RobotError
from dhcli.kinematics.forward import spelled
from dhcli.kinematics.moves import Chain
from dhcli.kinematics.robot import Link, Robot, Value
from dhcli.notation.angle import Angle
from dhcli.notation.matrix import bracketed
from dhcli.notation.quantity import DimensionError, has_angle_unit, to_angle, to_length
from dhcli.notation.tree import Expr
from dhcli.notation.walk import symbols
from dhcli.notation.writer import write, write_angle


def expected(exercise: Exercise, part: Part, style: str = "short") -> str:
    """The right answer to a part as a person would type it."""
    match part.question:
        case MatrixQuestion():
            truth = truth_of(part.question, exercise)
            return _as_text(part.question, truth, exercise, style)
        case TableQuestion(convention):
            from dhcli.checking.tables.marking import write_table

            return write_table(exercise, convention)
        case CellQuestion(column, link):
            row = link_of(exercise, link).row
            return spelled_value(getattr(row, column), exercise)
        case ScalarQuestion(expr):
            return spelled_value(quantity_of(expr, exercise), exercise)
        case FactorsQuestion(link):
            return spelled_moves(link_of(exercise, link).moves, exercise)
        case ChoiceQuestion(_, right):
            return str(right)
        case CountQuestion():
            return str(right_count(part.question))
    raise TypeError(part.question)


def _as_text(question: MatrixQuestion, truth: Truth, exercise: Exercise, style: str) -> str:
    """The right answer as text; numbers in the unit of the sheet."""
    if exercise.numeric and truth.numbers is not None:
        unit = float(exercise.metres)
        return entries_text(
            tuple(
                tuple(_decimal(value / unit if is_length(question, r, c) else value) for c, value in enumerate(row))
                for r, row in enumerate(truth.numbers)
            )
        )
    return entries_text(tuple(tuple(write(entry, style, exercise.writing) for entry in row) for row in truth.rows))


def spelled_value(value: Value, exercise: Exercise) -> str:
    """A value as a person would type it."""
    if isinstance(value, Angle):
        return write_angle(value, "short", exercise.writing)
    return write(value, "short", exercise.writing)


def spelled_moves(chain: Chain, exercise: Exercise) -> str:
    """Moves as a person would type them."""
    return " ".join(spelled(move, exercise.writing) for move in chain)


def entries_text(rows: Sequence[Sequence[str]]) -> str:
    """Entries as a matrix that can be read again; a single one by itself."""
    if len(rows) == 1 and len(rows[0]) == 1:
        return rows[0][0]
    return bracketed(rows)


def _decimal(value: float) -> str:
    """A number in digits that can be typed; what is nothing but rounding of floats is 0."""
    return "0" if abs(value) < NOTHING else f"{value:.10g}"


def link_of(exercise: Exercise, number: str) -> Link:
    """A link of the exercise's robot by its number.

    Raises:
        RobotError: There is no robot, or no such link.
    """
    robot = _robot(exercise)
    for link in robot.links:
        if str(link.number) == number:
            return link
    numbered = ", ".join(str(link.number) for link in robot.links)
    raise RobotError(f"{robot.name} has no link {number}", f"links: {numbered}")


def _robot(exercise: Exercise) -> Robot:
    if exercise.robot is None:
        raise RobotError(f"{exercise.id} asks about a robot and names none")
    return exercise.robot


def quantity_of(expr: Expr, exercise: Exercise) -> Value:
    """An expression as an angle if its units or its names say so, else as a length or number; exact in numbers."""
    inside = symbols(expr)
    if has_angle_unit(expr) or (inside and all(exercise.scope.is_angle(name) for name in inside)):
        try:
            angle = to_angle(expr)
            return constant_of(angle, exercise) if exercise.numeric else angle
        except DimensionError:
            pass  # a cosine of an angle is a number
    return to_length(expr)


def constant_of(value: Value, exercise: Exercise) -> Angle:
    """An angle with the values that the task gives; zero for a length."""
    if not isinstance(value, Angle):
        return Angle()
    return value.substitute({name: v for name, v in exercise.given.items() if isinstance(v, Angle)})
