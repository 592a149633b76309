"""Judging a DH table: by its cells, or by the motion it describes, because two tables are often both right."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from dhcli.checking.exercise import Exercise, Memo
from dhcli.checking.tables.answer import TableAnswer, ends_on_axis, own_rows, robot_of
from dhcli.checking.tables.cells import dh_table_text, on_sheet
from dhcli.checking.tables.comparing import LITERAL, SAME_ROBOT, gives
from dhcli.checking.tables.motions import Outcome
from dhcli.checking.tables.reasons import reason_of
from dhcli.checking.tables.typed_rows import TypedRow
from dhcli.checking.tolerance import Tolerance
from dhcli.checking.verdicts import CellMark, Mark, Verdict, worst
from dhcli.errors import RobotError, plural
from dhcli.kinematics.conventions import NAMES, Convention


def mark_table(answer: TableAnswer) -> Mark:
    """Judge a DH table.

    Returns:
        RIGHT for the robot's own cells, and for other frames of the same robot where the task leaves them open;
        EQUIVALENT for what is right in another way, with the freedom that was used; CLOSE or WRONG with the first
        joint that differs.

    Raises:
        UnreadableError: Only the unit of the table is wrong.
        RobotError: There is nothing to compare the cells with.
    """
    cells = answer.cells
    if cells and worst(cell.verdict for cell in cells) is Verdict.RIGHT:
        mark = Mark(Verdict.RIGHT, cells=cells, earned=1.0)
    else:
        mark = _by_cells(answer, cells) if answer.compare == LITERAL else _by_motion(answer, cells)
    reading = dh_table_text(on_sheet(answer.plain, answer.exercise), answer.robot.columns, answer.exercise.writing)
    return replace(mark, reading=reading, expected=_own_table(answer.exercise, answer.convention))


def answer_of(
    memo: Memo,
    convention: Convention,
    rows: tuple[TypedRow, ...],
    compare: str = SAME_ROBOT,
    tolerance: Tolerance | None = None,
    *,
    end_free: bool | None = None,
) -> TableAnswer:
    """The table with all that it is judged by.

    Args:
        memo: The exercise, with its robot and what it gives, and what was worked out for it.
        convention: Which convention was asked.
        rows: The rows as read.
        compare: `literal`, `same-motion` or `same-robot`.
        tolerance: How near numbers must be; the exercise's own by default.
        end_free: Whether the task leaves the end frame free; by default only where no table of this convention
            reaches the robot's own end frame.

    Raises:
        RobotError: There is no robot.
    """
    robot = robot_of(memo.exercise)
    if end_free is None:
        end_free = convention is Convention.MODIFIED and not ends_on_axis(robot)
    return TableAnswer(rows, memo, convention, tolerance or memo.exercise.tolerance, compare, end_free)


def write_table(exercise: Exercise, convention: Convention) -> str:
    """The right table as a person would type it, columns in the robot's order.

    Raises:
        RobotError: The robot has no table in this convention.
    """
    text = _own_table(exercise, convention)
    if not text:
        name = exercise.robot.name if exercise.robot else exercise.id
        raise RobotError(f"{name} has no table in {NAMES[convention]}", "give one as a second robot, under also:")
    return text


def _own_table(exercise: Exercise, convention: Convention) -> str:
    robots = [robot for robot in (exercise.robot, exercise.also and exercise.also[0]) if robot is not None]
    for robot in robots:
        if robot.convention is convention:
            return dh_table_text(on_sheet(own_rows(robot), exercise), robots[0].columns, exercise.writing)
    return ""


def _by_cells(answer: TableAnswer, cells: tuple[CellMark, ...]) -> Mark:
    """Judge by the cells alone; another right table is named as such."""
    if not answer.table:
        raise RobotError(f"{answer.robot.name} has no table in {NAMES[answer.convention]} to compare cells with")
    second = _second_truth(answer)
    if second is not None:
        return second
    answer.check_units()
    remarks = _notes(cells)
    if not cells:
        remarks = (f"your table has {plural(len(answer.rows), 'row')}, the right one has {len(answer.table)}",)
    if not answer.misfit and replace(answer, compare=SAME_ROBOT).judged().verdict is Verdict.RIGHT:
        asks = f"a right table of the same robot, but {answer.asker} asks for the one of the document"
        remarks = (asks, *remarks)
    return Mark(
        worst(cell.verdict for cell in cells) if cells else Verdict.WRONG,
        cells=cells,
        remarks=remarks,
        earned=_earned(cells),
    )


def _by_motion(answer: TableAnswer, cells: tuple[CellMark, ...]) -> Mark:
    if answer.misfit:
        return Mark(Verdict.WRONG, cells=cells, remarks=(answer.misfit,), earned=_earned(cells))
    outcome = answer.judged()
    if outcome.verdict is Verdict.RIGHT:
        return _accepted(answer, cells, outcome)
    second = _second_truth(answer)
    if second is not None:
        return second
    answer.check_units()
    remarks = (*reason_of(answer, outcome).remarks, *_notes(cells))
    return Mark(outcome.verdict, cells=cells, remarks=remarks, earned=_earned(cells))


def _accepted(answer: TableAnswer, cells: tuple[CellMark, ...], outcome: Outcome) -> Mark:
    """RIGHT if the task gave the freedom that was used, or none was; else EQUIVALENT. It is named in any case."""
    frames, joints = answer.freedoms(outcome)
    if outcome.is_free:
        own = outcome.match is not None and gives(answer.exercise.task, outcome.match, answer.slack(outcome))
    else:  # the same motion of all joints; only frames in between may differ
        is_free = answer.compare == SAME_ROBOT and bool(answer.exercise.task.strip())
        own = not answer.table or (is_free and bool(frames))
    remarks = (*frames, *joints) or (() if own else ("another table of the same motion",))
    shown = tuple(c if c.verdict is Verdict.RIGHT else replace(c, verdict=Verdict.EQUIVALENT, note="") for c in cells)
    return Mark(Verdict.RIGHT if own else Verdict.EQUIVALENT, cells=shown, remarks=remarks, earned=1.0)


def _second_truth(answer: TableAnswer) -> Mark | None:
    """EQUIVALENT if the answer is the exercise's other robot, or goes on to the robot's tool."""
    for memo, note in answer.memo.of(("second truths", answer.compare), lambda: _second_truths(answer)):
        second = replace(answer, memo=memo)
        cells = second.cells
        if cells and worst(cell.verdict for cell in cells) is Verdict.RIGHT:
            return Mark(Verdict.EQUIVALENT, cells=cells, remarks=(note,), earned=1.0)
        if answer.compare == LITERAL or second.misfit:
            continue
        outcome = second.judged()
        if outcome.verdict is Verdict.RIGHT:
            mark = _accepted(second, cells, outcome)
            return replace(mark, verdict=Verdict.EQUIVALENT, remarks=(note, *(mark.remarks if cells else ())))
    return None


def _second_truths(answer: TableAnswer) -> tuple[tuple[Memo, str], ...]:
    """The exercise with its other robot, and with its own one to the tool, each with what is said of it."""
    robot = answer.robot
    others = [answer.exercise.also] if answer.exercise.also else []
    if robot.tool and answer.compare != LITERAL:
        last = robot.links[-1]
        links = (*robot.links[:-1], replace(last, moves=(*last.moves, *robot.tool), row=None))
        others.append((replace(robot, links=links, tool=()), "the table goes on to the tool frame"))
    return tuple((Memo(replace(answer.exercise, robot=other, also=None)), note) for other, note in others)


def _notes(cells: Sequence[CellMark]) -> tuple[str, ...]:
    return tuple(dict.fromkeys(cell.note for cell in cells if cell.note))


def _earned(cells: Sequence[CellMark]) -> float:
    counted = [cell for cell in cells if cell.counted or cell.verdict is Verdict.WRONG]
    return sum(cell.verdict is Verdict.RIGHT for cell in counted) / len(counted) if counted else 0.0
