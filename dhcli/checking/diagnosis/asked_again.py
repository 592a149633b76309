"""Mistakes in a value, a cell of a table or the moves of a link: the part asked again with the mistake.

Whoever has made the mistake answers another question rightly; so the answer is judged as an answer to that one, with
the same care for spelling, units and digits.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial

from dhcli.checking.diagnosis.mistakes import Level
from dhcli.checking.diagnosis.mistakes.of_values import IN_VALUES
from dhcli.checking.diagnosis.result import Slip
from dhcli.checking.diagnosis.rows import OTHER
from dhcli.checking.diagnosis.slips import candidates, setting_of, table_candidates
from dhcli.checking.diagnosis.work import Multiplied, Step, Work
from dhcli.checking.exercise import Exercise, Part
from dhcli.checking.expected import expected, spelled_moves, spelled_value
from dhcli.checking.marking import mark, mark_cell, mark_factors
from dhcli.checking.pasted import UnreadableError
from dhcli.checking.questions import CellQuestion, FactorsQuestion, MatrixQuestion, ScalarQuestion, Span, TableQuestion
from dhcli.checking.verdicts import Mark, Verdict
from dhcli.kinematics.conventions import Row, moves_of
from dhcli.kinematics.moves import Chain
from dhcli.kinematics.robot import Robot, Value


@dataclass(frozen=True, slots=True)
class Asked:
    """A mistake, and the question that it answers rightly.

    Attributes:
        slip: The mistake.
        answer: What a student with this mistake types.
        judge: Judges an answer to the other question.
    """

    slip: Slip
    answer: str
    judge: Callable[[str], Mark]

    def fits(self, answer: str) -> bool:
        """Whether an answer is right there."""
        try:
            return self.judge(answer).verdict in (Verdict.RIGHT, Verdict.ROUNDED)
        except UnreadableError:  # right in another unit
            return False


def asked_again(exercise: Exercise, part: Part, answer: str | None = None) -> tuple[Asked, ...]:
    """Every mistake that changes the answer to a part; none where it asks for something else.

    Args:
        exercise: The exercise.
        part: The part.
        answer: Only those that lead to this answer; all by default.
    """
    match part.question:
        case ScalarQuestion():
            found = _values(exercise, part, part.question)
        case CellQuestion():
            found = _cells(exercise, part, part.question)
        case FactorsQuestion():
            found = _factors(exercise, part.question)
        case _:
            return ()
    right = expected(exercise, part)
    fitting = (asked for asked in found if answer is None or asked.fits(answer))
    wrong = (asked for asked in fitting if not asked.fits(right))
    is_same = not exercise.numeric and not isinstance(part.question, CellQuestion)
    return tuple(_distinct(wrong)) if is_same else tuple(wrong)


def _distinct(found: Iterator[Asked]) -> Iterator[Asked]:
    """Of mistakes that are the same in symbols the first; in numbers, and in one cell, they only happen to agree."""
    known: list[Asked] = []
    for asked in found:
        if not any(other.fits(asked.answer) for other in known):
            known.append(asked)
            yield asked


def _values(exercise: Exercise, part: Part, question: ScalarQuestion) -> Iterator[Asked]:
    for mistake in IN_VALUES:
        for where, expr in mistake.made(question.expr, exercise):
            slip = Slip(f"{mistake.id} {where}".strip(), mistake.words.format(where=where), mistake.hint)
            other = Part(part.id, ScalarQuestion(expr, question.text), tolerance=part.tolerance)
            yield Asked(slip, expected(exercise, other), partial(mark, exercise, other))


def _cells(exercise: Exercise, part: Part, question: CellQuestion) -> Iterator[Asked]:
    """A slip in the row, or the same column of the row before or behind."""
    robot = exercise.robot
    if robot is None:
        return
    tolerance = part.tolerance or exercise.tolerance

    def asked(slip: Slip, row: Row | None) -> Iterator[Asked]:
        if row is not None:
            value: Value = getattr(row, question.column)
            judge = partial(mark_cell, exercise, value, tolerance=tolerance)
            yield Asked(slip, spelled_value(value, exercise), judge)

    index = _index(robot, question.link)
    for one in table_candidates(exercise, TableQuestion(robot.convention)):
        yield from asked(one.slips[0], one.work.steps[index].row)
    for other in (index - 1, index + 1):
        if 0 <= other < len(robot.links):
            number = robot.links[other].number
            words = f"this is {question.column} of row {number}"
            hint = f"which row holds this {question.column} in this convention?"
            yield from asked(Slip(f"neighbour {number}", words, hint), robot.links[other].row)


def _factors(exercise: Exercise, question: FactorsQuestion) -> Iterator[Asked]:
    """Slips in the moves of a link, each move a factor of its own."""
    robot = exercise.robot
    if robot is None:
        return
    index = _index(robot, question.link)
    link = robot.links[index]

    def asked(slip: Slip, chain: Chain) -> Asked:
        return Asked(slip, spelled_moves(chain, exercise), partial(mark_factors, exercise, chain))

    if link.row is not None and robot.convention in OTHER:
        words = "the moves stand in the order of the other convention"
        slip = Slip("convention", words, "which convention has this robot, standard or modified?")
        yield asked(slip, moves_of(link.row, OTHER[robot.convention]))
    steps = tuple(Step(str(k), (move,)) for k, move in enumerate(link.moves, 1))
    work = Work(MatrixQuestion(Span(robot.frames[index + 1], robot.frames[index + 2])), steps)
    for one in candidates(work, setting_of(exercise)):
        is_product = one.mistake.level is not Level.MATRIX and one.work.multiplied is Multiplied.IN_ORDER
        if is_product and one.work.steps != steps:
            yield asked(one.slips[0], tuple(move for step in one.work.steps for move in step.chain))


def _index(robot: Robot, number: str) -> int:
    return next(k for k, link in enumerate(robot.links) if str(link.number) == number)
