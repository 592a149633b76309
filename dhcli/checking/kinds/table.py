"""`table`: the DH table of the robot in one of the conventions."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import TYPE_CHECKING, ClassVar, Self

from dhcli.checking.diagnosis.result import Slip
from dhcli.checking.exercise import Case, Exercise, Question
from dhcli.checking.kinds.linked import needed
from dhcli.checking.returned import Causes, Judged, Matrices, Overlaid, Points, Reading, Shown
from dhcli.checking.tables.typed_rows import TypedRow, read_table
from dhcli.checking.verdicts import Mark
from dhcli.checking.whole import ends_in_bracket, is_closed
from dhcli.errors import NotationError, Place, Problem, RobotError
from dhcli.frozen import frozen
from dhcli.kinematics.conventions import COLUMNS, TABLES, Convention, Row, moves_of
from dhcli.kinematics.coupling import is_coupled
from dhcli.kinematics.fold import fold
from dhcli.kinematics.moves import names
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.validity import Finding, InvalidRobotError
from dhcli.notation.scope import Scope

if TYPE_CHECKING:
    from dhcli.checking.tables.answer import TableAnswer
    from dhcli.kinematics.values import Values

FIRST = 1
"""Index of frame 0, behind the base."""


@frozen
class TableQuestion(Question[tuple[TypedRow, ...]]):
    """The DH table of the robot in one of the conventions.

    Attributes:
        convention: The convention.
        note: What is told beside every verdict, of a table that was made on the spot.
    """

    convention: Convention
    note: str = ""

    words: ClassVar = ("table",)
    examples: ClassVar = ("table standard",)
    keys: ClassVar = ("compare",)
    is_in_table: ClassVar = True
    is_overlaid: ClassVar = True
    earns_by_row: ClassVar = True

    @classmethod
    def asked(cls, text: str, _scope: Scope, place: Place | None) -> Self:
        """`table standard` or `table modified`."""
        rest = text.removeprefix("table").strip()
        if rest not in TABLES:
            hint = "write table standard or table modified"
            raise NotationError(Problem(f"there is no table '{rest:.60}'" if rest else "which table?", place, hint))
        return cls(Convention(rest))

    def check(self, robot: Robot | None) -> None:
        if is_coupled(needed(robot)):
            message = "its rows share a joint, and in an answer each joint has one cell: its table cannot be asked for"
            raise RobotError(message, "ask for a cell, or for a matrix")

    def describe(self, _exercise: Exercise) -> str:
        return f"the {self.convention.value} DH table"

    def blank(self, exercise: Exercise) -> tuple[int, int]:
        return len(needed(exercise.robot).links), len(COLUMNS)

    def notes(self, exercise: Exercise) -> Iterable[str]:
        robot = needed(exercise.robot)
        yield "columns: " + "  ".join(robot.columns) + "; angles in degrees"
        if exercise.numeric and robot.variables:
            yield f"in the cell that a joint changes stands its variable: {', '.join(robot.variables)}"

    def is_whole(self, text: str, _blank: tuple[int, int]) -> bool:
        *_, last = text.strip().splitlines() or [""]
        is_bracketed = text.strip().startswith("[") or ends_in_bracket(text)
        return is_closed(text) and (is_bracketed or "\\end" in text or ";" in last.rstrip("; "))

    def expected(self, case: Case, _style: str = "short") -> str:
        from dhcli.checking.tables.marking import write_table

        return write_table(case.exercise, self.convention)

    def steps(self, case: Case) -> Iterable[Shown]:
        from dhcli.checking.tables.answer import own_rows
        from dhcli.checking.tables.steps import MEANINGS, process_lines, table_lines

        exercise, own = case.exercise, needed(case.exercise.robot)
        for robot in (own, exercise.also and exercise.also[0]):
            if robot is not None and robot.convention is self.convention:
                yield from process_lines(robot, exercise)
                yield Shown("4  Each row leads from one frame to the next:\n" + "\n".join(MEANINGS[self.convention]))
                lines = table_lines(own_rows(robot), own.columns, robot.first, exercise)
                yield Shown("Row by row:\n" + "\n".join(lines))
                return

    def findings(self, case: Case, where: tuple[str | int, ...]) -> Iterable[Finding]:
        from dhcli.checking.tables.comparing import SAME_MOTION, SAME_ROBOT, compare_of, unstated

        name, compare, missing = case.part.id, case.part.compare, unstated(case.exercise.task)
        if not compare:
            wanted = compare_of(case)
            fixes = f"the task does not state: {', '.join(missing)}" if missing else "the task fixes all that it needs"
            yield Finding(where, f"{name}: does not say how tables are compared", f"compare: {wanted}; {fixes}")
        if compare == SAME_MOTION and missing:
            message = f"{name}: same-motion wants one table, and the task does not state: {', '.join(missing)}"
            yield Finding((*where, "compare"), message, "state it, or compare: same-robot")
        if compare == SAME_ROBOT and not missing:
            message = f"{name}: same-robot leaves frames, zeros and senses free, and the task fixes them all"
            yield Finding((*where, "compare"), message, "compare: same-motion")

    def read(self, case: Case, text: str, place: Place | None = None) -> tuple[TypedRow, ...]:
        from dhcli.checking.tables.answer import robot_of

        exercise, robot = case.exercise, robot_of(case.exercise)
        return read_table(text, robot, exercise.scope, robot.columns, exercise.unit, place)

    def mark(self, case: Case, reading: Reading[tuple[TypedRow, ...]]) -> Mark:
        from dhcli.checking.tables.marking import mark_table

        mark = mark_table(self._answer(case, reading))
        return replace(mark, remarks=(*mark.remarks, self.note)) if self.note else mark

    def _answer(self, case: Case, reading: Reading[tuple[TypedRow, ...]]) -> TableAnswer:
        """The table with all that it is judged by."""
        from dhcli.checking.tables.comparing import compare_of
        from dhcli.checking.tables.marking import answer_of

        return answer_of(case.memo, self.convention, reading.value, compare_of(case), case.tolerance)

    def slips(self, case: Case) -> Iterable[Slip]:
        from dhcli.checking.diagnosis.slips import table_slips

        return (one.slips[0] for one in table_slips(case.memo, self.convention))

    def answer_with(self, case: Case, name: str) -> str | None:
        from dhcli.checking.diagnosis.slips import table_candidates
        from dhcli.checking.tables.cells import dh_table_text, on_sheet

        robot = needed(case.exercise.robot)
        for one in table_candidates(case.exercise, self.convention, name):
            if one.slips[0].name == name:
                rows = tuple(step.row for step in one.work.steps if step.row is not None)
                return dh_table_text(on_sheet(rows, case.exercise), robot.columns, case.exercise.writing)
        return None

    def causes(self, case: Case, reading: Reading[tuple[TypedRow, ...]]) -> Causes:
        from dhcli.checking.diagnosis.table_causes import table_causes
        from dhcli.checking.tables.comparing import LITERAL
        from dhcli.checking.tables.reasons import is_of_other_convention, reason_of

        answer = self._answer(case, reading)
        if not is_of_other_convention(answer):
            causes = table_causes(case, self.convention, _settled(case, reading))
            if causes or answer.misfit or answer.compare == LITERAL:
                return causes
        slip = reason_of(answer).slip
        return ((slip,),) if slip else ()

    def differs(self, mark: Mark) -> bool:
        return mark.verdict.passed is True and bool(mark.remarks)

    def is_plausible(self, case: Case, judged: Judged[tuple[TypedRow, ...]]) -> bool:
        from dhcli.checking.diagnosis.plausible import has_right_joints

        robot = needed(case.exercise.robot)
        if judged.reading is None:
            return False
        right = [link.row for link in robot.links if link.row is not None]
        return has_right_joints(_settled(case, judged.reading), right, robot.variables)

    def rows(self, case: Case, reading: Reading[tuple[TypedRow, ...]]) -> tuple[Row, ...]:
        robot = case.exercise.robot
        return _settled(case, reading) if robot and len(reading.value) == len(robot.links) else ()

    def leads(
        self, case: Case, reading: Reading[tuple[TypedRow, ...]], span: tuple[int, int], points: Points
    ) -> tuple[int, int, Matrices] | None:
        """From the first frame asked about to the last that the table reaches.

        A table is one drawing: its rows are never mixed with those of the right one.
        """
        return leads_of(self.rows(case, reading), self.convention, span, points)

    def arm(self, case: Case, reading: Reading[tuple[TypedRow, ...]]) -> Robot | None:
        return arm_of(case.exercise.robot, self.rows(case, reading), self.convention)

    def overlaid(self, case: Case, reading: Reading[tuple[TypedRow, ...]], values: Values) -> Overlaid:
        from dhcli.checking.tables.answer import robot_of
        from dhcli.kinematics.values import numbers
        from dhcli.scene.traced import paired, traced

        own, robot = robot_of(case.exercise), self.robot_drawn(case.exercise)
        rows = [moves_of(row, self.convention) for row in _settled(case, reading)]
        segments = [(str(own.first + k - 1), moves) for k, moves in enumerate((own.base, *rows))]
        pairs = paired(robot.frames[1:-1], [name for name, _ in segments], alike=robot.convention is self.convention)
        return Overlaid(robot, traced("your table", segments, numbers(values), pairs), values)

    def robot_drawn(self, exercise: Exercise) -> Robot:
        """The arm, with the table of this convention where the exercise has one."""
        from dhcli.checking.tables.answer import robot_of

        own = robot_of(exercise)
        also = exercise.also[0] if exercise.also else own
        return also if own.convention is not self.convention and also.convention is self.convention else own


def leads_of(
    rows: tuple[Row, ...], convention: Convention, span: tuple[int, int], points: Points
) -> tuple[int, int, Matrices] | None:
    """From which frame to which rows lead within a span of frames, and the matrices at some points."""
    start, end = max(span[0], FIRST), min(span[1], FIRST + len(rows))
    if start >= end:
        return None
    chain = tuple(move for row in rows[start - FIRST : end - FIRST] for move in moves_of(row, convention))
    if not names(chain) <= points.names:
        return None
    return start, end, tuple(fold(chain, over) for over in points.at)


def arm_of(robot: Robot | None, rows: tuple[Row, ...], convention: Convention) -> Robot | None:
    """A robot with other rows in its table; None where it has none in this convention, or they make no robot."""
    if robot is None or robot.convention is not convention or not rows:
        return None
    pairs = zip(robot.links, rows, strict=True)
    try:
        return replace(
            robot, links=tuple(replace(link, moves=moves_of(row, convention), row=row) for link, row in pairs)
        )
    except InvalidRobotError:
        return None


def _settled(case: Case, reading: Reading[tuple[TypedRow, ...]]) -> tuple[Row, ...]:
    from dhcli.checking.tables.cells import settled

    return tuple(settled(typed.row, case.tolerance) for typed in reading.value)
