"""Follow-through: a part that is right from a student's own earlier answers earns its credit."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from dhcli.checking.diagnosis.search import Entries, matches
from dhcli.checking.diagnosis.typed import Typed, typed_answer
from dhcli.checking.diagnosis.work import inverse, product
from dhcli.checking.exercise import Exercise, Part
from dhcli.checking.marking import mark_cell
from dhcli.checking.pasted import UnreadableError
from dhcli.checking.questions import CellQuestion, MatrixQuestion, Span, TableQuestion
from dhcli.checking.tables.cells import settled
from dhcli.checking.tables.reading import read_table
from dhcli.checking.truth import piece_of
from dhcli.checking.verdicts import Verdict
from dhcli.errors import DhcliError
from dhcli.kinematics.conventions import Row, moves_of
from dhcli.kinematics.fold import fold
from dhcli.kinematics.frames import between, frame
from dhcli.kinematics.moves import names

MOST_WAYS = 64
FIRST = 1
"""Index of frame 0, behind the base."""

Ways = dict[int, list[tuple[int, str, tuple[Entries, ...]]]]
"""From the index of a frame: matrices that lead on, to which frame, from which part (empty for the right one)."""


def follows(exercise: Exercise, part: Part, answers: Mapping[str, str]) -> tuple[str, ...]:
    """The earlier parts from whose answers a wrong one is right; none if there are none.

    Args:
        exercise: The exercise.
        part: The part whose answer is wrong.
        answers: Its answer, and the answers to earlier parts that differ from the solution, by part.
    """
    question, robot = part.question, exercise.robot
    if isinstance(question, CellQuestion):
        return _from_own_cell(exercise, part, question, answers)
    if robot is None or not isinstance(question, MatrixQuestion) or not isinstance(question.source, Span):
        return ()
    first, last = (robot.frames.index(frame(robot, name)) for name in (question.source.start, question.source.end))
    try:
        typed = typed_answer(exercise, part, question, answers[part.id])
        if typed is None or first >= last:
            return ()
        ways: Ways = {}
        for k in range(first, last):
            chain = between(robot, robot.frames[k], robot.frames[k + 1])
            ways[k] = [(k + 1, "", tuple(fold(chain, over) for over in typed.search.points))]
        for other in _earlier(exercise, part):
            if other.id in answers:
                _add(ways, exercise, other, answers[other.id])
                _add_table(ways, exercise, other, answers[other.id], typed, last)
    except (UnreadableError, DhcliError):
        return ()
    for count, (used, matrices) in enumerate(_paths(ways, first, last)):
        if count >= MOST_WAYS:
            break
        finished = (inverse(m) if question.inverse else m for m in matrices)
        pieces = (piece_of(m, question, over) for m, over in zip(finished, typed.search.points, strict=True))
        if used and all(matches(v, p, typed.slacks[-1]) for v, p in zip(typed.values, pieces, strict=True)):
            return used
    return ()


def _earlier(exercise: Exercise, part: Part) -> tuple[Part, ...]:
    """The parts that a part builds on, directly or through others."""
    wanted, found = list(part.depends), []
    while wanted:
        one = exercise.part(wanted.pop())
        if one not in found:
            found.append(one)
            wanted += one.depends
    return tuple(found)


def _add(ways: Ways, exercise: Exercise, part: Part, answer: str) -> None:
    """A student's own matrix as a way from frame to frame."""
    question, robot = part.question, exercise.robot
    if robot is None or not isinstance(question, MatrixQuestion) or not isinstance(question.source, Span):
        return
    if question.piece != "pose" or question.inverse:
        return
    start, end = (robot.frames.index(frame(robot, name)) for name in (question.source.start, question.source.end))
    typed = typed_answer(exercise, part, question, answer)
    if typed is not None and start in ways and start < end:
        ways[start].insert(0, (end, part.id, typed.values))


def _add_table(ways: Ways, exercise: Exercise, part: Part, answer: str, typed: Typed, last: int) -> None:
    """The frames of a student's own table: from the first one asked about to the last that the table reaches.

    A table is one drawing: its rows are never mixed with those of the right one.
    """
    rows = _own_rows(exercise, part, answer)
    start, end = max(min(ways), FIRST), min(last, FIRST + len(rows))
    if not isinstance(part.question, TableQuestion) or start >= end:
        return
    convention = part.question.convention
    chain = tuple(move for row in rows[start - FIRST : end - FIRST] for move in moves_of(row, convention))
    if names(chain) <= typed.search.names:
        matrices = tuple(fold(chain, over) for over in typed.search.points)
        ways[start].insert(0, (end, part.id, matrices))


def _own_rows(exercise: Exercise, part: Part, answer: str) -> tuple[Row, ...]:
    """The rows of a student's own table; none where it has not one for each link of the robot."""
    robot = exercise.robot
    if robot is None or not isinstance(part.question, TableQuestion):
        return ()
    rows = read_table(answer, robot, exercise.scope, robot.columns, exercise.unit)
    tolerance = part.tolerance or exercise.tolerance
    return tuple(settled(typed.row, tolerance) for typed in rows) if len(rows) == len(robot.links) else ()


def _from_own_cell(
    exercise: Exercise, part: Part, question: CellQuestion, answers: Mapping[str, str]
) -> tuple[str, ...]:
    """The table in which a cell stands just as it is answered."""
    for other in _earlier(exercise, part):
        if other.id not in answers:
            continue
        try:
            rows = _own_rows(exercise, other, answers[other.id])
            numbers = [str(link.number) for link in exercise.robot.links] if exercise.robot else []
            if rows and question.link in numbers:
                value = getattr(rows[numbers.index(question.link)], question.column)
                judged = mark_cell(exercise, value, answers[part.id], part.tolerance or exercise.tolerance)
                if judged.verdict is Verdict.RIGHT:
                    return (other.id,)
        except (UnreadableError, DhcliError):
            continue
    return ()


def _paths(ways: Ways, here: int, last: int) -> Iterator[tuple[tuple[str, ...], tuple[Entries, ...]]]:
    """Every way from a frame to the last: the parts used, and the product at each point."""
    for end, name, matrices in ways.get(here, ()):
        used = (name,) if name else ()
        if end == last:
            yield used, matrices
        for more, rest in _paths(ways, end, last) if end < last else ():
            yield (*used, *more), tuple(product(a, b) for a, b in zip(matrices, rest, strict=True))
