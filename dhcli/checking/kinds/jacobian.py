"""`jacobian`, `column 2 of jacobian`, `entry 1 2 of jacobian`: how joint rates move a frame."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from typing import ClassVar, Self

from dhcli.checking.diagnosis.result import Rank, Slip
from dhcli.checking.entries import Entries
from dhcli.checking.exercise import Case, Exercise
from dhcli.checking.motion.asked import Motion, form_of, read_motion
from dhcli.checking.motion.columns import Columns, columns_of, jacobian_grid
from dhcli.checking.motion.from_columns import ColumnsQuestion, Typed, axes_step
from dhcli.checking.motion.grid import Grid
from dhcli.checking.motion.in_entries import column_signs
from dhcli.checking.motion.question import MotionQuestion
from dhcli.checking.motion.reading import unit_of_rates
from dhcli.checking.named import Naming
from dhcli.checking.returned import Reading, Shown
from dhcli.checking.verdicts import Mark
from dhcli.checking.wanted import NotAskedError
from dhcli.errors import Place, RobotError, plural
from dhcli.frozen import frozen
from dhcli.kinematics.frames import between
from dhcli.kinematics.moves import names
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.velocity.form import GEOMETRIC, Form
from dhcli.kinematics.velocity.jacobian import textbook_jacobian
from dhcli.kinematics.velocity.view import MotionView
from dhcli.notation.scope import Scope
from dhcli.regex import regex

_HEAD = regex(
    r"(?:column\s+(?P<alone>\d{1,2})\s+of\s+|entry\s+(?P<row>\d{1,2})\s+(?P<column>\d{1,2})\s+of\s+)?"
    r"jacobian(?:\s+(?P<form>[a-z ]+))?"
)


@frozen
class JacobianQuestion(ColumnsQuestion):
    """A Jacobian, a column of it or an entry.

    Attributes:
        motion: Of which frame and point, along which axes.
        form: Its rows.
        twist: `space` or `body`, which say point and axes as well; or empty.
        row: The row asked for, from 1; 0 for all.
        column: The column asked for, from 1; 0 for all.
    """

    motion: Motion
    form: Form = GEOMETRIC
    twist: str = ""
    row: int = 0
    column: int = 0

    words: ClassVar = ("jacobian", "column", "entry")
    examples: ClassVar = (
        "jacobian of 0..3",
        "jacobian linear of 0..3 in frame 3",
        "column 2 of jacobian of 0..3",
        "entry 1 2 of jacobian of 0..3",
    )

    @classmethod
    def asked(cls, text: str, scope: Scope, place: Place | None) -> Self:
        """`jacobian linear of 0..3 in frame 3 at (0, 0, c)`."""
        if "jacobian" not in text:
            raise NotAskedError(text)
        motion = read_motion(text, scope, place)
        match = _HEAD.fullmatch(motion.head)
        if match is None or motion.rates is not None:
            raise NotAskedError(text)
        form, twist = form_of(match["form"] or "")
        if twist and (motion.axes or any(str(one) != "0" for one in motion.point)):
            raise NotAskedError(text)
        return cls(motion, form, twist, int(match["row"] or 0), int(match["column"] or match["alone"] or 0))

    def check(self, robot: Robot | None) -> None:
        robot, view = self.motion.check(robot, self.twist)
        columns, rows = len(self.motion.joints(robot)), len(self.form.labels)
        if self.row > rows or self.column > columns:
            raise RobotError(f"this Jacobian has {plural(rows, 'row')} and {plural(columns, 'column')}")
        if self.form.analytic and view.axes != view.start:
            raise RobotError("rates of angles are asked along no other axes", "leave in frame out")

    def size(self, robot: Robot) -> tuple[int, int]:
        columns = len(self.motion.joints(robot))
        return 1 if self.row else len(self.form.labels), 1 if self.column else columns

    def describe(self, exercise: Exercise) -> str:
        rows = ", ".join(self.form.labels)
        named = f"the {self.twist} Jacobian" if self.twist else "the Jacobian"
        whole = f"{named} {self.motion.where(exercise)}, rows {rows}"
        if self.row:
            return f"entry ({self.row},{self.column}) of {whole}"
        if self.column:
            return f"column {self.column} of {whole}"
        shape = "" if exercise.robot is None else " ({}x{})".format(*self.size(exercise.robot))
        return whole + shape

    def mark(self, case: Case, reading: Reading[Entries]) -> Mark:
        mark, unit = ColumnsQuestion.mark(self, case, reading), unit_of_rates(reading.text)
        if self.row or self.column or not unit or not mark.verdict.passed:
            return mark
        said = f"{unit} is no unit of a Jacobian: its columns of joints that turn hold lengths, those of slides numbers"
        return replace(mark, remarks=(*mark.remarks, f"{said}; times the rates of the joints it gives {unit}"))

    def numbers_named(self, _case: Case) -> Naming:
        return () if self.row else self.form.labels

    def columns(self, case: Case) -> Columns:
        robot, view = self.motion.check(case.exercise.robot, self.twist)
        return columns_of(robot, view)

    def computed(self, case: Case) -> Grid:
        columns = self.columns(case)
        found = self.of_columns(case, columns)
        if not self.form.analytic or case.exercise.numeric:
            return found
        rows = textbook_jacobian(columns.robot, {}, columns.view, self.form).rows  # the same, and shorter
        return replace(found, rows=self.piece(replace(self._grid(case, columns), rows=rows)).rows)

    def named(self, case: Case) -> frozenset[str]:
        columns = self.columns(case)
        if not self.form.analytic:
            return self.right(case).names
        return columns.names | names(between(columns.robot, columns.view.start, columns.view.end))

    def of_columns(self, case: Case, columns: Columns) -> Grid:
        return self.piece(self._grid(case, columns))

    def _grid(self, case: Case, columns: Columns, form: Form | None = None) -> Grid:
        return jacobian_grid(case, columns, form or self.form)

    def piece(self, grid: Grid) -> Grid:
        """The rows and columns that are asked for."""
        rows = slice(self.row - 1, self.row) if self.row else slice(None)
        columns = slice(self.column - 1, self.column) if self.column else slice(None)
        return Grid(
            tuple(line[columns] for line in grid.rows[rows]),
            tuple(line[columns] for line in grid.powers[rows]),
            cosines=True,
        )

    def besides(self, case: Case, columns: Columns) -> Iterator[tuple[Slip, Grid]]:
        if self.form.part == "all" and not self.row:
            above, below = ("v", "ω") if self.form.angular_first else ("ω", "v")
            slip = Slip("rows-swapped", f"{above} stands above {below}", "which rows stand above?", Rank.WHOLE)
            grid = self._grid(case, columns, replace(self.form, angular_first=not self.form.angular_first))
            yield slip, self.piece(Grid(grid.rows, self._grid(case, columns).powers, cosines=True))
        if self.form.analytic:
            words = f"the lower rows are the angular velocity, and not rates of {self.form.analytic}"
            slip = Slip("geometric", words, "are rates of angles asked for, or an angular velocity?", Rank.WHOLE)
            yield slip, self.piece(self._grid(case, columns, replace(self.form, analytic="")))
        if self.column:
            yield from self._neighbours(self._grid(case, columns))

    def every(self, case: Case, right: Grid) -> Iterator[tuple[Slip, Grid]]:
        yield from ColumnsQuestion.every(self, case, right)
        yield from column_signs(right)

    def place(self, row: int, column: int) -> str:
        return f"{self.row},{self.column}" if self.row else MotionQuestion.place(self, row, column)

    def _neighbours(self, grid: Grid) -> Iterator[tuple[Slip, Grid]]:
        """Another column than that asked for."""
        for k in range(1, grid.shape[1] + 1):
            if k != self.column:
                slip = Slip(f"other-column {k}", f"this is column {k}", "which column is asked for?")
                yield slip, replace(self, column=k).piece(grid)

    def typed_entries(self, case: Case, reading: Reading[Entries]) -> tuple[MotionView, Typed] | None:
        if self.form.analytic:
            return None
        rows = self.form.rows[self.row - 1 : self.row] if self.row else self.form.rows
        count = len(self.columns(case).each)
        columns = (self.column - 1,) if self.column else range(count)
        typed = {
            (r, c): entry.expr
            for r, line in zip(rows, reading.value, strict=True)
            for c, entry in zip(columns, line, strict=True)
        }
        return self.columns(case).view, typed

    def steps(self, case: Case) -> Iterable[Shown]:
        columns = self.columns(case)
        yield axes_step(case, columns)
        if self.form.analytic:
            yield self.shown(case, "The rows of v and ω", self._grid(case, columns, replace(self.form, analytic="")))
        yield self.shown(case, f"The Jacobian, rows {', '.join(self.form.labels)}", self._grid(case, columns))
