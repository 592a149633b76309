"""`cell`: one cell of the robot's DH table."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from functools import partial
from typing import Any, ClassVar, Self

from dhcli.checking.diagnosis.alternatives import Alternative, AlternativesQuestion
from dhcli.checking.diagnosis.result import Slip
from dhcli.checking.exercise import Case, Exercise
from dhcli.checking.kinds.linked import link_of, needed, read_number
from dhcli.checking.pasted import UnreadableError
from dhcli.checking.returned import Reading, Shown
from dhcli.checking.values import Quantity, TypedValue, is_right_value, mark_value, read_typed_value, spelled_value
from dhcli.checking.verdicts import Mark, Verdict
from dhcli.errors import DhcliError, NotationError, Place, Problem, RobotError
from dhcli.frozen import frozen
from dhcli.kinematics.conventions import COLUMNS, Row
from dhcli.kinematics.frames import place_of
from dhcli.kinematics.robot import Robot, Value
from dhcli.notation.scope import Scope
from dhcli.notation.tree import multiply

LENGTHS = ("a", "d")
"""Columns of lengths; the others are angles."""


@frozen
class CellQuestion(AlternativesQuestion[TypedValue]):
    """One cell of the robot's DH table."""

    column: str
    link: str

    words: ClassVar = ("cell",)
    examples: ClassVar = ("cell alpha 2",)
    is_in_table: ClassVar = True
    has_one_name: ClassVar = False

    @classmethod
    def asked(cls, text: str, _scope: Scope, place: Place | None) -> Self:
        """`cell alpha 2`."""
        column, _, link = text.removeprefix("cell").strip().partition(" ")
        if column not in COLUMNS:
            hint = "columns: " + ", ".join(COLUMNS)
            raise NotationError(Problem(f"a DH table has no column '{column}'", place, hint))
        return cls(column, read_number(link, place))

    def check(self, robot: Robot | None) -> None:
        if link_of(robot, self.link).row is None:
            raise RobotError(f"{needed(robot).name} is given as products and has no table")

    def describe(self, _exercise: Exercise) -> str:
        return f"{self.column} of link {self.link}"

    def expected(self, case: Case, _style: str = "short") -> str:
        return spelled_value(
            self._quantity(getattr(link_of(case.exercise.robot, self.link).row, self.column)), case.exercise
        )

    def steps(self, case: Case) -> Iterable[Shown]:
        from dhcli.checking.tables.steps import MEANINGS, cell_lines

        robot = needed(case.exercise.robot)
        if robot.convention in MEANINGS:
            yield Shown(f"What is measured is {MEANINGS[robot.convention][COLUMNS.index(self.column)]}")
            yield from cell_lines(robot, self.column, int(self.link), case.exercise)

    def read(self, case: Case, text: str, place: Place | None = None) -> TypedValue:
        return read_typed_value(case.exercise, text.strip().removesuffix("*"), place)

    def mark(self, case: Case, reading: Reading[TypedValue]) -> Mark:
        row = link_of(case.exercise.robot, self.link).row
        if row is None:
            raise RobotError(f"{case.exercise.id} asks for a cell, and its robot has no table")
        return self._mark(case, getattr(row, self.column), reading.value)

    def _mark(self, case: Case, right: Value, typed: TypedValue) -> Mark:
        exercise = case.memo.of("of table", lambda: _of_table(case.exercise))
        return mark_value(exercise, self._quantity(right), typed, case.tolerance)

    def _accepts(self, case: Case, right: Value, typed: TypedValue) -> bool:
        exercise = case.memo.of("of table", lambda: _of_table(case.exercise))
        return is_right_value(exercise, self._quantity(right), typed, case.tolerance)

    def _quantity(self, value: Value) -> Quantity:
        """A cell: a length with the unit of the sheet, or an angle."""
        return Quantity(value, is_length=self.column in LENGTHS, is_angle=self.column not in LENGTHS)

    def alternatives(self, case: Case, name: str = "") -> Iterator[Alternative[TypedValue]]:
        """A slip in the row, or the same column of the row before or behind."""
        from dhcli.checking.diagnosis.mistakes.changes import scale_of
        from dhcli.checking.diagnosis.slips import setting_of, table_candidates, table_slips

        robot = needed(case.exercise.robot)
        index = place_of(robot, self.link)
        right = robot.links[index].row

        def asked(slip: Slip, row: Row | None) -> Iterator[Alternative[TypedValue]]:
            if row is None:
                return
            value: Value = getattr(row, self.column)
            if right is None or value != getattr(right, self.column):  # most slips leave this cell alone
                yield Alternative(
                    slip, spelled_value(self._quantity(value), case.exercise), partial(self._accepts, case, value)
                )

        named = table_candidates(case.exercise, robot.convention, name) if name else None
        for one in table_slips(case.memo, robot.convention) if named is None else named:
            if one.mistake.alone:  # a cell does not show what has happened in several rows
                continue
            yield from asked(one.slips[0], one.work.steps[index].row)
        for other in (index - 1, index + 1):
            if 0 <= other < len(robot.links):
                number = robot.links[other].number
                words = f"this is {self.column} of row {number}"
                hint = f"which row holds this {self.column} in this convention?"
                yield from asked(Slip(f"neighbour {number}", words, hint), robot.links[other].row)
        factor = scale_of(setting_of(case.exercise))
        if right is not None and factor is not None and self.column in LENGTHS:
            slip = Slip("in-mm", "the unit is another, mm for m", "look at the unit of the sheet")
            a, d = (multiply(factor, length) for length in (right.a, right.d))
            yield from asked(slip, replace(right, a=a, d=d))

    def follows(self, case: Case, reading: Reading[TypedValue], earlier: Mapping[str, Reading[Any]]) -> tuple[str, ...]:
        place = place_of(needed(case.exercise.robot), self.link)
        for other in case.exercise.before(case.part):
            if other.id not in earlier:
                continue
            try:
                rows = other.question.rows(Case(other, case.memo), earlier[other.id])
                if not rows:
                    continue
                value = getattr(rows[place], self.column)
                if self._mark(case, value, reading.value).verdict is Verdict.RIGHT:
                    return (other.id,)
            except (UnreadableError, DhcliError):
                continue
        return ()


def _of_table(exercise: Exercise) -> Exercise:
    """The exercise as a cell of a table is judged: the robot's lengths may be in numbers, its joints may not."""
    from dhcli.checking.tables.cells import own_values

    variables = exercise.robot.variables if exercise.robot else ()
    return replace(exercise, given={name: v for name, v in own_values(exercise).items() if name not in variables})
