"""The worked solution of a part, step by step, as a lecturer would write it on the board."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from dhcli.algebra.terms import TERMS
from dhcli.checking.describe import coordinates
from dhcli.checking.exercise import Exercise, Part
from dhcli.checking.questions import (
    CellQuestion,
    ChoiceQuestion,
    Composed,
    CountQuestion,
    FactorsQuestion,
    MatrixQuestion,
    ScalarQuestion,
    Span,
    TableQuestion,
)
from dhcli.checking.tables.answer import rows_of
from dhcli.checking.truth import chain_of
from dhcli.checking.workings import Rows, answer_text, product_lines, table_lines
from dhcli.kinematics.conventions import COLUMNS, ORDER, Convention
from dhcli.kinematics.fold import fold
from dhcli.kinematics.forward import in_numbers, put_in, spelled, textbook_form
from dhcli.kinematics.frames import between, frame
from dhcli.kinematics.moves import Chain, names
from dhcli.kinematics.robot import Robot
from dhcli.notation.names import natural_key
from dhcli.notation.quantity import value_text

MEANINGS = {
    Convention.STANDARD: (
        "a_i: from z_{i-1} to z_i along x_i",
        "alpha_i: from z_{i-1} to z_i about x_i",
        "d_i: from x_{i-1} to x_i along z_{i-1}",
        "theta_i: from x_{i-1} to x_i about z_{i-1}",
    ),
    Convention.MODIFIED: (
        "a_{i-1}: from z_{i-1} to z_i along x_{i-1}",
        "alpha_{i-1}: from z_{i-1} to z_i about x_{i-1}",
        "d_i: from x_{i-1} to x_i along z_i",
        "theta_i: from x_{i-1} to x_i about z_i",
    ),
}
"""What the four parameters of a row measure, in the order of `COLUMNS`."""


@dataclass(frozen=True, slots=True)
class Step:
    """One step of a solution.

    Attributes:
        text: What is done, in words; each line on its own.
        rows: The matrix it gives, if it gives one; lengths of numbers in the unit of the sheet.
    """

    text: str
    rows: Rows = ()


def solution(exercise: Exercise, part: Part) -> tuple[Step, ...]:
    """The steps that lead to the right answer; the last one holds it as it may be typed."""
    answer = answer_text(exercise, part)
    match part.question:
        case MatrixQuestion():
            steps = tuple(_matrix(exercise, part.question))
        case TableQuestion(convention):
            steps = tuple(_table(exercise, convention))
        case CellQuestion(column, _) if exercise.robot is not None and exercise.robot.convention in MEANINGS:
            meanings = MEANINGS[exercise.robot.convention]
            steps = (Step(f"What is measured is {meanings[COLUMNS.index(column)]}"),)
        case FactorsQuestion() if exercise.robot is not None:
            steps = (Step(ORDER[exercise.robot.convention]),)
        case ScalarQuestion(_, text) if exercise.given or exercise.numeric:
            steps = (Step(f"What is asked for is {text}"),)
        case CountQuestion():
            steps = _count(part.question)
        case ChoiceQuestion(options, right):
            return (Step(f"The answer is {right}: {options[right - 1]}"),)
        case _:
            steps = ()
    return (*steps, Step(f"So the answer is {answer}" if steps else f"The answer is {answer}"))


def _matrix(exercise: Exercise, question: MatrixQuestion) -> Iterator[Step]:
    """The matrices and their product, then the piece of it that is asked for."""
    if isinstance(question.source, Span) and exercise.robot is not None:
        yield from _links(exercise, exercise.robot, question.source)
    elif isinstance(question.source, Composed):
        yield from _moves(exercise, question.source.chain)
    if question.inverse:
        back = "The inverse: the moves undone in the opposite order, R transposed and -R^T p"
        yield Step(back, _product(exercise, chain_of(question, exercise.robot)))
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
        yield Step(pieces[question.piece])
    if question.piece in ("point", "vector"):
        rows = _product(exercise, chain_of(question, exercise.robot))
        yield Step("\n".join(("The matrix times this column:", *product_lines(question, rows, exercise))))


def _table(exercise: Exercise, convention: Convention) -> Iterator[Step]:
    """What the four parameters measure, then the rows."""
    yield Step("Each row leads from one frame to the next:\n" + "\n".join(MEANINGS[convention]))
    robots = (exercise.robot, exercise.also and exercise.also[0])
    for robot in robots:
        if robot is not None and exercise.robot is not None and robot.convention is convention:
            lines = table_lines(rows_of(robot), exercise.robot.columns, robot.first, exercise)
            yield Step("Row by row:\n" + "\n".join(lines))
            return


def _links(exercise: Exercise, robot: Robot, span: Span) -> Iterator[Step]:
    """Each link matrix, then the products from right to left, which keep the brackets small."""
    first, last = (robot.frames.index(frame(robot, name)) for name in (span.start, span.end))
    low, high = min(first, last), max(first, last)
    yield Step(ORDER[robot.convention] + _unit(exercise))
    for i in range(low, high):
        before, after = robot.frames[i], robot.frames[i + 1]
        chain = between(robot, before, after)
        yield Step(f"From frame {before} to frame {after}{_values(exercise, chain)}", _product(exercise, chain))
    for i in range(high - 2, low - 1, -1):
        start, middle, end = robot.frames[i], robot.frames[i + 1], robot.frames[high]
        chain = between(robot, start, end)
        yield Step(f"T_{start}{end} = T_{start}{middle} T_{middle}{end}", _product(exercise, chain))
    if first > last:
        start, end = robot.frames[high], robot.frames[low]
        yield Step(f"T_{start}{end} is its inverse", _product(exercise, between(robot, start, end)))


def _moves(exercise: Exercise, chain: Chain) -> Iterator[Step]:
    """The frame after each move, from left to right."""
    for count, move in enumerate(chain, 1):
        reached = chain[:count]
        rows = _product(exercise, reached) if exercise.numeric else fold(reached, TERMS)
        yield Step(f"Move {count}: {spelled(move)}", rows)


def _count(question: CountQuestion) -> tuple[Step, ...]:
    """What is counted, and the formula if it is asked for."""
    from dhcli.mobility.counting import Counts
    from dhcli.mobility.linkage import Linkage

    if question.found is None:
        return ()
    is_linkage = isinstance(question.found, Linkage)
    counts = Counts.of(question.found) if isinstance(question.found, Linkage) else question.found
    counted = f"n = {counts.n} links with the ground, j = {counts.j} joints, Σf = {counts.sum_f}, ΣC = {counts.sum_c}"
    steps = [Step(counted + f", λ = {counts.space.lambda_}")]
    if question.what in ("mobility", "gruebler"):
        steps.append(Step(counts.formulas[0]))
    if question.what == "mobility" and is_linkage:
        steps.append(Step(f"Whether that is the truth, and why: dhcli dof {question.linkage}"))
    return tuple(steps)


def _product(exercise: Exercise, chain: Chain) -> Rows:
    """The product of a chain with what the task gives: in textbook form, or in numbers in the unit of the sheet."""
    if not exercise.numeric:
        return textbook_form(put_in(chain, exercise.given))
    unit = float(exercise.metres)
    *upper, bottom = in_numbers(chain, exercise.values)
    return (*((*row[:3], row[3] / unit) for row in upper), bottom)


def _values(exercise: Exercise, chain: Chain) -> str:
    """The values that go into a matrix of numbers."""
    if not exercise.numeric:
        return ""
    unit = "" if exercise.unit == "none" else exercise.unit
    wanted = sorted(names(chain) & exercise.values.keys(), key=natural_key)
    listed = ", ".join(f"{name} = {value_text(exercise.values[name], unit)}" for name in wanted)
    return f", with {listed}" if listed else ""


def _unit(exercise: Exercise) -> str:
    return f", lengths in {exercise.unit}" if exercise.numeric and exercise.unit != "none" else ""
