"""What every question about motion does with its table of entries: reads, marks, shows and explains answers."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import islice

from dhcli.algebra.floats import Floats
from dhcli.algebra.points import general
from dhcli.checking.diagnosis.result import Slip
from dhcli.checking.entries import Entries, entries_text
from dhcli.checking.exercise import Case, Causes, Exercise, Question, Reading, Shown
from dhcli.checking.motion.columns import Columns
from dhcli.checking.motion.grid import Grid, Numbers, over, scale_of
from dhcli.checking.motion.marking import in_other_unit, mark_grid, mark_numbers, values_of
from dhcli.checking.motion.reading import read_cells
from dhcli.checking.pasted import UnreadableError
from dhcli.checking.symbolic import same
from dhcli.checking.verdicts import Mark
from dhcli.errors import DhcliError, Place, RobotError
from dhcli.kinematics.pose import rounded
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.values import numbers
from dhcli.notation.names import natural_key
from dhcli.notation.tree import Expr
from dhcli.notation.walk import symbols
from dhcli.notation.writer import write

SEED = 31
POINTS = 2
CLOSE = 1e-9


@dataclass(frozen=True, slots=True)
class Wrong:
    """A mistake, and the answer of whoever has made it.

    Attributes:
        slip: The mistake.
        grid: The answer.
        seen: Its entries at the values given, where the answer is in numbers.
        limits: How far from them an answer may be.
        general: Its entries at points that have nothing special about them.
    """

    slip: Slip
    grid: Grid
    seen: Numbers
    limits: Numbers
    general: tuple[Numbers, ...]


class MotionQuestion(Question[Entries]):
    """A question whose answer is a table of entries, computed from the columns of a robot."""

    __slots__ = ()

    @abstractmethod
    def size(self, robot: Robot) -> tuple[int, int]:
        """Rows and columns of the answer."""

    @abstractmethod
    def computed(self, case: Case) -> Grid:
        """The right answer."""

    @abstractmethod
    def wrong(self, case: Case) -> Iterable[tuple[Slip, Grid]]:
        """Every mistake with the answer that it leads to."""

    def right(self, case: Case) -> Grid:
        """The right answer, computed once."""
        return case.memo.of(("motion", self), lambda: self.computed(case))

    @property
    def needs_table(self) -> bool:
        """A student looks at it for the axes."""
        return True

    @property
    def has_cosines(self) -> bool:
        """As every formula of a robot."""
        return True

    def blank(self, exercise: Exercise) -> tuple[int, int]:
        """A blank for each entry; those of a column in one row."""
        if exercise.robot is None:
            return 1, 1
        rows, columns = self.size(exercise.robot)
        return (1, rows) if columns == 1 else (rows, columns)

    @property
    def in_rows(self) -> bool:
        """Several entries, as a rule."""
        return True

    def unvalued(self, exercise: Exercise) -> tuple[str, ...]:
        """Names of the answer without a value."""
        from dhcli.checking.exercise import Memo, Part

        named = self.right(Case(Part("", self), Memo(exercise))).names
        return tuple(sorted(named - exercise.values.keys(), key=natural_key))

    def expected(self, case: Case, style: str = "short") -> str:
        """The entries as a matrix; a column in a row."""
        return self._text(case, self._valued(case), style)

    def _text(self, case: Case, grid: Grid, style: str = "short") -> str:
        tolerance, (rows, width) = case.tolerance, grid.shape
        cells = grid.text(case.exercise, tolerance.position, tolerance.rotation, style)
        if width == 1 and rows > 1:
            return "[" + ", ".join(cells) + "]"
        return entries_text([tuple(cells[k : k + width]) for k in range(0, len(cells), width)])

    def _valued(self, case: Case) -> Grid:
        """The right answer, for which every name has a value where numbers are wanted."""
        right, exercise = self.right(case), case.exercise
        missing = sorted(right.names - exercise.values.keys(), key=natural_key) if exercise.numeric else []
        if missing:
            hint = f"--set {missing[0]}=..., or given: in the file of an exercise"
            raise RobotError(f"{exercise.id} asks for numbers, and has no value for {', '.join(missing)}", hint)
        return right

    def read(self, case: Case, text: str, place: Place | None = None) -> Entries:
        """The entries in the shape of the right answer."""
        return read_cells(case.exercise, self.right(case).powers, text, place)

    def mark(self, case: Case, reading: Reading[Entries]) -> Mark:
        """Entry by entry."""
        return mark_grid(case, self._valued(case), reading.value)

    # --- Mistakes -----------------------------------------------------------------------------------------------

    def slips(self, case: Case) -> Iterable[Slip]:
        """Mistakes whose answer is wrong here."""
        return (one.slip for one in self._wrong(case) if not self._is_right(case, one))

    def answer_with(self, case: Case, name: str) -> str | None:
        """The answer of a mistake, of those too that another one names."""
        right = self._at_points(case.exercise, self._valued(case))
        for slip, grid in self.wrong(case):
            if slip.name == name and not _alike(self._at_points(case.exercise, grid), right):
                return self._text(case, grid)
        return None

    def hidden(self, case: Case) -> Iterable[Slip]:
        """Mistakes that the values given do not show."""
        return (one.slip for one in self._wrong(case) if case.exercise.numeric and self._is_right(case, one))

    def causes(self, case: Case, reading: Reading[Entries]) -> Causes:
        """Mistakes that give just this answer, the plainest first; zeros in numbers have too many reasons."""
        if case.exercise.numeric and not any(any(row) for row in values_of(reading.value, case.exercise)):
            return ()
        found = [one for one in self._wrong(case) if self._gives(case, one, self._in_unit(case, reading.value))]
        return tuple((one.slip,) for one in sorted(found, key=lambda one: one.slip.rank))

    def _in_unit(self, case: Case, entries: Entries) -> Entries:
        """An answer in metres, its bare lengths in the unit in which they plainly are."""
        if not case.exercise.numeric:
            return entries
        right = self._valued(case)
        other = in_other_unit(case, right, entries, mark_numbers(case, case.exercise, right, entries))
        return other.entries if other else entries

    def _wrong(self, case: Case) -> tuple[Wrong, ...]:
        """The mistakes that change the answer at general values; of those that are the same the first."""
        return case.memo.of(("motion mistakes", self), lambda: tuple(self._made(case)))

    def _made(self, case: Case) -> Iterator[Wrong]:
        exercise, right = case.exercise, self._valued(case)
        known = [self._at_points(exercise, right)]
        for slip, grid in self.wrong(case):
            try:
                seen = grid.numbers(exercise) if exercise.numeric else ()
                limits = self._limits(case, grid) if exercise.numeric else ()
                points = self._at_points(exercise, grid)
            except (DhcliError, KeyError, ZeroDivisionError, OverflowError):
                continue
            if not any(_alike(points, other) for other in known):
                known.append(points)
                yield Wrong(slip, grid, seen, limits, points)

    def _at_points(self, exercise: Exercise, grid: Grid) -> tuple[Numbers, ...]:
        """Entries at general points; at the values given, in symbols."""
        named = grid.names | frozenset(exercise.scope.names) | frozenset(exercise.names)
        known = {} if exercise.numeric else numbers(exercise.values)
        return tuple(over(grid.rows, Floats(point | known)) for point in islice(general(named, SEED), POINTS))

    def _is_right(self, case: Case, one: Wrong) -> bool:
        """Whether a mistake cannot be seen at the values given."""
        if not case.exercise.numeric:
            return False
        right, limits = case.memo.of(("motion numbers", self), lambda: self._right_numbers(case))
        return _within(one.seen, right, limits)

    def _right_numbers(self, case: Case) -> tuple[Numbers, Numbers]:
        right = self.right(case)
        return right.numbers(case.exercise), self._limits(case, right)

    @staticmethod
    def _limits(case: Case, grid: Grid) -> Numbers:
        tolerance = case.tolerance
        return grid.limits(case.exercise, tolerance.position, tolerance.rotation)

    def _gives(self, case: Case, one: Wrong, entries: Entries) -> bool:
        """Whether an answer is that of a mistake: near it in numbers, proved equal in symbols."""
        exercise = case.exercise
        if exercise.numeric:
            typed = values_of(entries, exercise)
            return _within(typed, one.seen, one.limits) and not self._is_right(case, one)
        given = Grid(tuple(tuple(entry.expr for entry in row) for row in entries), one.grid.powers)
        try:
            if not _alike(self._at_points(exercise, given), one.general):
                return False
        except (KeyError, UnreadableError):
            return False
        pairs = zip(given.rows, one.grid.rows, strict=True)
        return all(same(a, b, exercise.values) for row, other in pairs for a, b in zip(row, other, strict=True))

    # --- Solutions ----------------------------------------------------------------------------------------------

    def shown(self, case: Case, text: str, grid: Grid) -> Shown:
        """A step with a table: in numbers in the unit of the sheet."""
        exercise = case.exercise
        if not exercise.numeric or grid.names - exercise.values.keys():
            return Shown(text, grid.rows)
        pairs = zip(grid.numbers(exercise), grid.powers, strict=True)
        return Shown(
            text,
            tuple(tuple(v / scale_of(exercise, p) for v, p in zip(values, row, strict=True)) for values, row in pairs),
        )


class OneNumberQuestion(MotionQuestion):
    """A question about motion whose answer is one number or one expression."""

    __slots__ = ()

    def size(self, _robot: Robot) -> tuple[int, int]:
        """One entry."""
        return 1, 1

    @property
    def in_rows(self) -> bool:
        """There is but one."""
        return False


def axes_step(case: Case, columns: Columns) -> Shown:
    """Axis and origin of each joint, and the point, in words."""
    exercise = case.exercise

    def vector(entries: Iterable[Expr], power: int) -> str:
        entries = tuple(entries)
        if exercise.numeric and not frozenset().union(*map(symbols, entries)) - exercise.values.keys():
            arithmetic = Floats(numbers(exercise.values))
            return ", ".join(rounded(arithmetic.value(one) / scale_of(exercise, power)) for one in entries)
        return ", ".join(write(one, "short", exercise.writing) for one in entries)

    lines = [f"Vectors along the axes of frame {columns.view.axes}; p = ({vector(columns.point, 1)})"]
    for one in columns.each:
        what = f"{one.joint} {'turns about' if one.turns else 'slides along'} ({vector(one.axis, 0)})"
        lines.append(what + (f" through ({vector(one.origin, 1)})" if one.turns else ""))
    lines.append("A joint that turns moves the point by axis x (p - o), one that slides along its axis")
    return Shown("\n".join(lines))


def _alike(first: tuple[Numbers, ...], second: tuple[Numbers, ...]) -> bool:
    pairs = [
        (a, b)
        for one, other in zip(first, second, strict=True)
        for row, line in zip(one, other, strict=True)
        for a, b in zip(row, line, strict=True)
    ]
    return all(abs(a - b) <= CLOSE * max(1.0, abs(a), abs(b)) for a, b in pairs)


def _within(first: Numbers, second: Numbers, limits: Numbers) -> bool:
    rows = zip(first, second, limits, strict=True)
    return all(abs(a - b) <= limit for row in rows for a, b, limit in zip(*row, strict=True))
