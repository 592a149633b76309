"""Judging an answer to a part: the gates in their order, then the values."""

from __future__ import annotations

import re
from dataclasses import replace

from dhcli.algebra.floats import Floats
from dhcli.algebra.terms import TERMS
from dhcli.checking.counts import mark_count
from dhcli.checking.exercise import Exercise, Part
from dhcli.checking.expected import constant_of, entries_text, link_of, quantity_of, spelled_moves, spelled_value
from dhcli.checking.misprints import misprint_remarks
from dhcli.checking.numeric import mark_numbers
from dhcli.checking.pasted import UnreadableError, refuse_blanks, without_label
from dhcli.checking.questions import (
    CellQuestion,
    ChoiceQuestion,
    CountQuestion,
    FactorsQuestion,
    MatrixQuestion,
    ScalarQuestion,
    TableQuestion,
)
from dhcli.checking.reading import check_names, read_entries
from dhcli.checking.symbolic import mark_symbols, put, same
from dhcli.checking.tables.cells import own_values
from dhcli.checking.tolerance import Tolerance, is_rounding_of, judge
from dhcli.checking.truth import truth_of, unvalued
from dhcli.checking.verdicts import CellMark, Mark, Verdict
from dhcli.errors import NotationError, Place, RobotError
from dhcli.kinematics.fold import fold
from dhcli.kinematics.forward import spelled
from dhcli.kinematics.moves import Chain, Fixed, Rot, Trans, along, read_chain
from dhcli.kinematics.robot import Value
from dhcli.kinematics.values import numbers
from dhcli.notation.angle import Angle
from dhcli.notation.factors import AXES
from dhcli.notation.parser import parse
from dhcli.notation.quantity import DimensionError, to_angle, to_length
from dhcli.notation.tree import ZERO, Expr
from dhcli.notation.walk import symbols
from dhcli.notation.writer import write

_CHOICE = re.compile(r"[(\[]?([0-9]{1,3}|[a-z])[)\].:]{0,2}(?: (.+))?")
BLANK = re.compile(r"[\s\[\](){},;.…_?–-]*")  # noqa: RUF001


def mark(exercise: Exercise, part: Part, answer: str, place: Place | None = None) -> Mark:
    """Judge an answer to one part.

    Args:
        exercise: The exercise.
        part: The part that is answered.
        answer: What the student typed; blank is skipped.
        place: Where it stands, for errors.

    Returns:
        The judgement. An answer that cannot be read gets one too: CAN'T READ, with what would be read.
    """
    if BLANK.fullmatch(answer):
        return Mark(Verdict.SKIPPED)
    judged = _read_and_judged(exercise, part, answer, place)
    if part.printed is not None and judged.verdict.passed is not True and not isinstance(part.question, MatrixQuestion):
        shown = _read_and_judged(exercise, part, part.printed.text, None)
        if shown.reading == judged.reading:
            return replace(judged, remarks=("this is what the document prints; it is a misprint", *judged.remarks))
    return judged


def _read_and_judged(exercise: Exercise, part: Part, answer: str, place: Place | None) -> Mark:
    try:
        return _judged(exercise, part, answer, place)
    except UnreadableError as error:
        remarks = error.remarks
    except NotationError as error:
        remarks = tuple(str(problem) for problem in error.problems)
    return Mark(Verdict.CANNOT_READ, answer.strip(), remarks=remarks)


def check(exercise: Exercise, part: str, answer: str) -> Mark:
    """Judge an answer to one part of an exercise, named by its id, and say why where it is wrong.

    Args:
        exercise: The exercise, from `load_exercise`.
        part: Name of the part.
        answer: What the student typed.

    Raises:
        UnknownNameError: There is no such part; the hint lists those there are.
    """
    from dhcli.checking.diagnosis.diagnosis import diagnosed

    found = exercise.part(part)
    return diagnosed(exercise, found, answer, mark(exercise, found, answer))


def _judged(exercise: Exercise, part: Part, answer: str, place: Place | None) -> Mark:
    refuse_blanks(answer)
    question = part.question
    tolerance = part.tolerance or exercise.tolerance
    match question:
        case MatrixQuestion():
            return _matrix(exercise, part, question, answer, tolerance, place)
        case TableQuestion():
            from dhcli.checking.tables.marking import mark_table

            return mark_table(question, exercise, answer, part.compare, tolerance, place=place)
        case CellQuestion(column, link):
            row = link_of(exercise, link).row
            if row is None:
                raise RobotError(f"{exercise.id} asks for a cell, and its robot has no table")
            return mark_cell(exercise, getattr(row, column), answer, tolerance, place)
        case ScalarQuestion(expr):
            return mark_value(exercise, quantity_of(expr, exercise), answer, tolerance, place)
        case FactorsQuestion(link):
            return mark_factors(exercise, link_of(exercise, link).moves, answer, place)
        case ChoiceQuestion(options, right):
            return _choice(options, right, answer)
        case CountQuestion():
            return mark_count(question, answer, place)


def _matrix(
    exercise: Exercise, part: Part, question: MatrixQuestion, answer: str, tolerance: Tolerance, place: Place | None
) -> Mark:
    truth = truth_of(question, exercise)
    entries = read_entries(question, exercise, answer, place)
    reading = entries_text(tuple(tuple(write(e.typed, "short", exercise.writing) for e in row) for row in entries))
    if exercise.numeric:
        if truth.numbers is None:
            missing = unvalued(question, exercise)
            hint = f"--set {missing[0]}=..., or given: in the file of an exercise"
            raise RobotError(f"{exercise.id} asks for numbers, and has no value for {', '.join(missing)}", hint)
        judged = mark_numbers(question, truth, entries, exercise, tolerance)
    else:
        judged = mark_symbols(question, truth, entries, exercise)
    remarks = judged.remarks
    if judged.verdict in (Verdict.WRONG, Verdict.CLOSE) and part.printed is not None:
        remarks = (*misprint_remarks(question, judged.cells, entries, exercise, part.printed), *remarks)
    columns = question.shape[1]
    shown = [cell.expected for cell in judged.cells]
    rows = tuple(tuple(shown[i : i + columns]) for i in range(0, len(shown), columns))
    return replace(judged, reading=reading, remarks=remarks, expected=entries_text(rows))


def mark_cell(exercise: Exercise, right: Value, answer: str, tolerance: Tolerance, place: Place | None = None) -> Mark:
    """Judge one cell of a table; the robot's lengths may be in numbers, and a star may mark a joint variable."""
    return mark_value(_of_table(exercise), right, _without_star(answer), tolerance, place)


def mark_value(exercise: Exercise, right: Value, answer: str, tolerance: Tolerance, place: Place | None = None) -> Mark:
    """Judge a single angle, length or number."""
    text = without_label(answer)
    typed_expr = parse(text, exercise.scope, place or Place("answer"))
    try:
        typed: Value = to_angle(typed_expr, bare="deg") if isinstance(right, Angle) else to_length(typed_expr)
    except DimensionError as error:
        raise UnreadableError(error.message + (f" ({error.hint})" if error.hint else "")) from None
    check_names(exercise, typed.names if isinstance(typed, Angle) else symbols(typed))
    reading, shown = spelled_value(typed, exercise), spelled_value(right, exercise)
    verdict = _verdict_of_value(exercise, typed, right, typed_expr, tolerance)
    if isinstance(right, Angle) and verdict is not Verdict.RIGHT:
        in_radians = to_angle(typed_expr)
        if _verdict_of_value(exercise, in_radians, right, typed_expr, tolerance) is Verdict.RIGHT:
            raise UnreadableError(f"right in radians; a bare angle is in degrees: write {shown} or {text.strip()} rad")
    cell = CellMark(0, 0, verdict, reading, shown)
    earned = float(verdict in (Verdict.RIGHT, Verdict.ROUNDED))
    return Mark(verdict, reading, (cell,), earned=earned, expected=shown)


def _verdict_of_value(
    exercise: Exercise, typed: Value, right: Value, typed_expr: Expr, tolerance: Tolerance
) -> Verdict:
    if isinstance(right, Angle) or isinstance(typed, Angle):
        difference = constant_of(typed, exercise) - constant_of(right, exercise)
        if difference.terms:
            return Verdict.WRONG
        off = abs((float(difference.degrees) + float(difference.radians) * 57.29577951308232 + 180) % 360 - 180)
        return judge(off, 0.0, tolerance.angle)
    if same(typed, right, exercise.values):
        return Verdict.RIGHT
    typed, right = put(typed, exercise.values), put(right, exercise.values)
    if symbols(typed) or symbols(right):
        return Verdict.WRONG
    over = Floats(numbers(exercise.values))
    truth = over.value(right)
    limit = tolerance.position if tolerance.position is not None else 1e-3 * max(abs(truth), 1e-9)
    verdict = judge(over.value(typed), truth, limit)
    if verdict is not Verdict.RIGHT and is_rounding_of(typed_expr, truth):
        return Verdict.ROUNDED
    return verdict


def mark_factors(exercise: Exercise, right: Chain, answer: str, place: Place | None = None) -> Mark:
    """Judge the elementary moves of a link: the same moves in the same order, up to pairs that commute."""
    typed = read_chain(without_label(answer), exercise.scope, place or Place("answer"))
    moving, wanted = _elementary(typed), _elementary(right)
    same_moves = sorted(moving) == sorted(wanted)
    remarks: tuple[str, ...] = ()
    verdict = Verdict.RIGHT if same_moves and _same_product(typed, right) else Verdict.WRONG
    if verdict is Verdict.WRONG and same_moves:
        remarks = ("the moves are right, their order is not",)
    elif verdict is Verdict.WRONG:
        remarks = (f"{len(set(moving) & set(wanted))} of {len(set(wanted))} moves are right",)
    earned = float(verdict is Verdict.RIGHT)
    shown = spelled_moves(right, exercise)
    return Mark(verdict, spelled_moves(typed, exercise), remarks=remarks, earned=earned, expected=shown)


def _elementary(chain: Chain) -> list[str]:
    """The moves about and along single axes that move anything, as text."""
    found: list[str] = []
    for move in chain:
        if isinstance(move, Rot) and not move.angle.is_zero:
            found.append(spelled(move))
        elif isinstance(move, Trans):
            pairs = zip(AXES, move.offset, strict=True)
            found += [spelled(along(axis, length)) for axis, length in pairs if not same(length, ZERO, {})]
        elif isinstance(move, Fixed):
            found.append(spelled(move))
    return found


def _same_product(first: Chain, second: Chain) -> bool:
    rows = zip(fold(first, TERMS), fold(second, TERMS), strict=True)
    return all(same(a, b, {}) for one, other in rows for a, b in zip(one, other, strict=True))


def _choice(options: tuple[str, ...], right: int, answer: str) -> Mark:
    chosen = _chosen(options, answer)
    if not 1 <= chosen <= len(options):
        raise UnreadableError(f"choose a number from 1 to {len(options)}")
    verdict = Verdict.RIGHT if chosen == right else Verdict.WRONG
    earned = float(verdict is Verdict.RIGHT)
    return Mark(verdict, f"{chosen}: {options[chosen - 1]}", earned=earned, expected=f"{right}: {options[right - 1]}")


def _chosen(options: tuple[str, ...], answer: str) -> int:
    """The number of the option meant: by its number, its letter, its text, or number and text; 0 for none."""
    plain = [" ".join(option.split()).casefold() for option in options]
    text = " ".join(answer.split()).casefold()
    if text in plain:
        return plain.index(text) + 1
    label = _CHOICE.fullmatch(text)
    if label is None:
        return 0
    chosen = int(label[1]) if label[1].isdigit() else ord(label[1]) - ord("a") + 1
    return chosen if not label[2] or plain[chosen - 1 : chosen] == [label[2]] else 0


def _of_table(exercise: Exercise) -> Exercise:
    """The exercise as a cell of a table is judged: the robot's lengths may be in numbers, its joints may not."""
    variables = exercise.robot.variables if exercise.robot else ()
    return replace(exercise, given={name: v for name, v in own_values(exercise).items() if name not in variables})


def _without_star(answer: str) -> str:
    """The cell without the star that marks a joint variable."""
    return answer.strip().removesuffix("*")
