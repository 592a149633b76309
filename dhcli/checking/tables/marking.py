"""Judging a DH table: by its cells, or by the motion it describes, because two tables are often both right."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from dhcli.checking.exercise import Exercise
from dhcli.checking.tables.answer import TableAnswer, ends_on_axis, own_rows
from dhcli.checking.tables.cells import table_text
from dhcli.checking.tables.comparing import LITERAL, SAME_MOTION, SAME_ROBOT, gives
from dhcli.checking.tables.differences import end_rows, first_difference
from dhcli.checking.tables.freedoms import end_freedoms
from dhcli.checking.tables.motions import Outcome, oddity
from dhcli.checking.tables.typed_rows import TypedRow
from dhcli.checking.tolerance import Tolerance
from dhcli.checking.verdicts import CellMark, Mark, Verdict, worst
from dhcli.errors import RobotError
from dhcli.kinematics.conventions import NAMES, Convention
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.same_robot import Match
from dhcli.notation.tree import ZERO

FIXES = "fixes base, end frame, zeros and senses"
OTHERS = {Convention.STANDARD: Convention.MODIFIED, Convention.MODIFIED: Convention.STANDARD}


def mark_table(
    exercise: Exercise,
    convention: Convention,
    rows: tuple[TypedRow, ...],
    compare: str = SAME_ROBOT,
    tolerance: Tolerance | None = None,
    *,
    end_free: bool | None = None,
) -> Mark:
    """Judge a DH table.

    Args:
        exercise: The exercise, with its robot and what it gives.
        convention: Which convention was asked.
        rows: The rows as read.
        compare: `literal`, `same-motion` or `same-robot`.
        tolerance: How near numbers must be; the exercise's own by default.
        end_free: Whether the task leaves the end frame free; by default only where no table of this convention
            reaches the robot's own end frame.

    Returns:
        RIGHT for the robot's own cells, and for other frames of the same robot where the task leaves them open;
        EQUIVALENT for what is right in another way, with the freedom that was used; CLOSE or WRONG with the first
        joint that differs.

    Raises:
        UnreadableError: Only the unit of the table is wrong.
        RobotError: There is no robot, or nothing to compare the cells with.
    """
    robot = robot_of(exercise)
    if end_free is None:
        end_free = convention is Convention.MODIFIED and not ends_on_axis(robot)
    tolerance = tolerance or exercise.tolerance
    answer = TableAnswer(rows, exercise, robot, convention, tolerance, compare, end_free)
    cells = answer.cells
    if cells and worst(cell.verdict for cell in cells) is Verdict.RIGHT:
        mark = Mark(Verdict.RIGHT, cells=cells, earned=1.0)
    else:
        mark = _by_cells(answer, cells) if compare == LITERAL else _by_motion(answer, cells)
    reading = table_text(answer.plain, robot.columns, exercise.writing)
    return replace(mark, reading=reading, expected=_own_table(exercise, convention))


def robot_of(exercise: Exercise) -> Robot:
    """The robot whose table is asked for.

    Raises:
        RobotError: There is none.
    """
    if exercise.robot is None:
        raise RobotError(f"{exercise.id} asks for a table and names no robot")
    return exercise.robot


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
            return table_text(own_rows(robot), robots[0].columns, exercise.writing)
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
        remarks = (f"your table has {len(answer.rows)} rows, the right one has {len(answer.table)}",)
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
    remarks = _why(answer, cells, outcome)
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
    others = [answer.exercise.also] if answer.exercise.also else []
    if answer.robot.tool and answer.compare != LITERAL:
        last = answer.robot.links[-1]
        links = (*answer.robot.links[:-1], replace(last, moves=(*last.moves, *answer.robot.tool), row=None))
        others.append((replace(answer.robot, links=links, tool=()), "the table goes on to the tool frame"))
    for robot, note in others:
        second = replace(answer, robot=robot, exercise=replace(answer.exercise, robot=robot, also=None))
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


def _why(answer: TableAnswer, cells: tuple[CellMark, ...], outcome: Outcome) -> tuple[str, ...]:
    """What can be said of a wrong table: the other convention, the end frame, or the first wrong joint."""
    if answer.is_oversized(outcome):
        return ("your lengths are a million times those of the robot: look for one with a digit or a unit too many",)
    convention = OTHERS[answer.convention]
    robot = replace(answer, compare=SAME_ROBOT)
    if _starts_like(answer, convention) and robot.judged(None, convention, end_free=True).verdict is Verdict.RIGHT:
        return (f"right for {NAMES[convention]}; this exercise uses {answer.convention.value}",)
    free = robot.judged(end_free=True)
    if answer.compare == SAME_MOTION:
        outcome = robot.judged()
        if outcome.verdict is Verdict.RIGHT and not _is_plainer(free, outcome):
            frames, joints = robot.freedoms(outcome)
            return f"the same robot, but {answer.asker} {FIXES}", *frames, *joints
    if outcome.verdict is Verdict.CLOSE:
        return ()
    if free.verdict is Verdict.RIGHT and free.match is not None:
        return *_at_the_end(answer, free, free.match), *_notes(cells)
    return *first_difference(robot, outcome), *_notes(cells)


def _is_plainer(free: Outcome, outcome: Outcome) -> bool:
    """Whether a table is the robot in a plainer way if its end frame may be another."""
    if free.verdict is not Verdict.RIGHT or free.match is None or outcome.match is None:
        return False
    return oddity(free.match) < oddity(outcome.match)


def _at_the_end(answer: TableAnswer, free: Outcome, match: Match) -> tuple[str, ...]:
    """What is said where all axes are right; where the task fixes more than them, that too."""
    slack = answer.slack(free)
    is_along = abs(match.tool.offset[2]) > slack.length
    rows = f"look at {end_rows(answer, free, is_along=is_along)}"
    end = (end_freedoms("end", match.tool, slack) or ("your end frame is another",))[0]
    if answer.compare == SAME_MOTION:
        base = end_freedoms("base", match.base.inverse(), slack)
        used = (*base, *answer.freedoms(free)[1])
        if used:
            return f"all axes are right, but {answer.asker} {FIXES}", *used, end
    return f"all joints are right; {end}", rows


def _starts_like(answer: TableAnswer, convention: Convention) -> bool:
    """Whether a table may be meant in a convention: its a and alpha are zero where there is nothing before or behind.

    One joint alone, and a last length that only the other convention drops, would be right in it by accident.
    """
    outer = answer.plain[0 if convention is Convention.MODIFIED else -1]
    return len(answer.robot.variables) > 1 and outer.a == ZERO and outer.alpha.is_zero


def _notes(cells: Sequence[CellMark]) -> tuple[str, ...]:
    return tuple(dict.fromkeys(cell.note for cell in cells if cell.note))


def _earned(cells: Sequence[CellMark]) -> float:
    counted = [cell for cell in cells if cell.counted or cell.verdict is Verdict.WRONG]
    return sum(cell.verdict is Verdict.RIGHT for cell in counted) / len(counted) if counted else 0.0
