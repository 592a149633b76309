"""What every question about motion does with its table of entries: reads, marks, shows and explains answers."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from functools import partial
from typing import ClassVar

from dhcli.checking.diagnosis.result import Rank, Slip
from dhcli.checking.entries import Entries, entries_text, values_of
from dhcli.checking.exercise import Case, Exercise, Memo, Part, Question
from dhcli.checking.motion.asked import Motion, beyond_any_arm
from dhcli.checking.motion.digits import Digits
from dhcli.checking.motion.grid import Grid, Numbers, alike, general_floats_in, over, scale_of, within
from dhcli.checking.motion.in_entries import sign_causes, signs, swapped, term_causes
from dhcli.checking.motion.marking import in_other_unit, mark_grid, mark_numbers
from dhcli.checking.motion.reading import read_cells
from dhcli.checking.named import Naming
from dhcli.checking.pasted import UnreadableError
from dhcli.checking.returned import Causes, Reading, Shown
from dhcli.checking.symbolic import same
from dhcli.checking.verdicts import Mark
from dhcli.checking.whole import is_whole_matrix
from dhcli.errors import DhcliError, Place
from dhcli.frozen import frozen
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.validity import Finding
from dhcli.notation.tree import Expr


@frozen
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

    motion: Motion

    needs_table: ClassVar = True  # for the axes
    has_cosines: ClassVar = True
    in_rows: ClassVar = True

    @abstractmethod
    def size(self, robot: Robot) -> tuple[int, int]:
        """Rows and columns of the answer."""

    @abstractmethod
    def computed(self, case: Case) -> Grid:
        """The right answer."""

    @abstractmethod
    def wrong(self, case: Case) -> Iterable[tuple[Slip, Grid]]:
        """Every mistake with the answer that it leads to."""

    def measured(self, _exercise: Exercise) -> Iterable[tuple[Sequence[Expr], Sequence[str]]]:
        """The numbers of the question, each with its unit."""
        return ((self.motion.point, ("m",) * 3),)

    def findings(self, case: Case, where: tuple[str | int, ...]) -> Iterable[Finding]:
        """Numbers that no arm has."""
        for found, units in self.measured(case.exercise):
            yield from beyond_any_arm(case, where, found, units)

    def right(self, case: Case) -> Grid:
        """The right answer, computed once."""
        return case.memo.of(("motion", self), lambda: self.computed(case))

    def blank(self, exercise: Exercise) -> tuple[int, int]:
        """A blank for each entry; those of a column in one row."""
        if exercise.robot is None:
            return 1, 1
        rows, columns = self.size(exercise.robot)
        return (1, rows) if columns == 1 else (rows, columns)

    def unvalued(self, exercise: Exercise) -> tuple[str, ...]:
        """Names of the answer without a value; where all that it may hold have one, it is not worked out for that."""
        if not exercise.numeric:
            return ()
        if not exercise.unvalued(frozenset(exercise.scope.names) | self.names | self.rates(exercise.robot)):
            return ()
        return exercise.unvalued(self.named(Case(Part("", self), Memo(exercise))))

    def rates(self, _robot: Robot | None) -> frozenset[str]:
        """Names of joint rates that stand in the answer."""
        return frozenset()

    def named(self, case: Case) -> frozenset[str]:
        """Names whose values the answer in numbers needs."""
        return self.right(case).names

    def expected(self, case: Case, style: str = "short") -> str:
        """The entries as a matrix; a column in a row."""
        return self.text(case, self.right(case), style)

    def text(self, case: Case, grid: Grid, style: str = "short") -> str:
        """A grid as an answer that may be typed."""
        tolerance, (rows, width) = case.tolerance, grid.shape
        cells = grid.text(case.exercise, tolerance.position, tolerance.rotation, style)
        if width == 1 and rows > 1:
            return "[" + ", ".join(cells) + "]"
        return entries_text([tuple(cells[k : k + width]) for k in range(0, len(cells), width)])

    def read(self, case: Case, text: str, place: Place | None = None) -> Entries:
        """The entries in the shape of the right answer."""
        names = self.numbers_named(case)
        return read_cells(case.exercise, self.right(case).powers, text, place, self.units(case), names)

    def is_whole(self, text: str, blank: tuple[int, int]) -> bool:
        """All rows, or all numbers of a column."""
        return is_whole_matrix(text, blank)

    def units(self, _case: Case) -> tuple[str, ...]:
        """The unit of each number, for a list of rates or forces."""
        return ()

    def numbers_named(self, _case: Case) -> Naming:
        """What the rows are called, those of a list or of a Jacobian."""
        return ()

    def mark(self, case: Case, reading: Reading[Entries]) -> Mark:
        """Entry by entry."""
        return mark_grid(case, self.right(case), reading.value)

    # --- Mistakes -----------------------------------------------------------------------------------------------

    def slips(self, case: Case) -> Iterable[Slip]:
        """Mistakes whose answer is wrong here."""
        return (one.slip for one in self._wrong(case) if not self._is_right(case, one))

    def answer_with(self, case: Case, name: str) -> str | None:
        """The answer of a mistake, of those too that another one names."""
        right = self.at_points(case.memo, self.right(case))
        for slip, grid in self.every(case, self.right(case)):
            if slip.name == name and not alike(self.at_points(case.memo, grid), right):
                return self.text(case, grid)
        return None

    def hidden(self, case: Case) -> Iterable[Slip]:
        """Mistakes that the values given do not show."""
        return (one.slip for one in self._wrong(case) if case.exercise.numeric and self._is_right(case, one))

    def causes(self, case: Case, reading: Reading[Entries]) -> Causes:
        """Mistakes that give just this answer, the plainest first; zeros in numbers have too many reasons."""
        if case.exercise.numeric and not any(any(row) for row in values_of(reading.value, case.exercise)):
            return ()
        entries = self._in_unit(case, reading.value)
        found = self._makers(case, entries) or self._by_digits(case, entries)
        plain = [one for one in found if one.slip.rank < Rank.SYMPTOM] or found
        if plain:
            return tuple((one.slip,) for one in sorted(plain, key=lambda one: one.slip.rank))
        right, exercise = self.right(case), case.exercise
        at = partial(self.at_points, case.memo)
        given = self.given(right, entries)
        in_signs = () if exercise.numeric else sign_causes(right, given, at, self.place)
        in_terms = term_causes(exercise, right, given, at, self.place)
        return in_signs or in_terms.one or self.paired_causes(case, entries) or in_terms.more

    def place(self, row: int, column: int) -> str:
        """Row and column of an entry as they are told."""
        return f"{row + 1},{column + 1}"

    def paired_causes(self, _case: Case, _entries: Entries) -> Causes:
        """Two mistakes that give just this answer together."""
        return ()

    def _in_unit(self, case: Case, entries: Entries) -> Entries:
        """An answer in metres, its bare lengths in the unit in which they plainly are."""
        if not case.exercise.numeric:
            return entries
        right = self.right(case)
        other = in_other_unit(case, right, entries, mark_numbers(case, case.exercise, right, entries))
        return other.entries if other else entries

    def _wrong(self, case: Case) -> tuple[Wrong, ...]:
        """The mistakes that change the answer at general values; of those that are the same the first."""
        return case.memo.of(("motion mistakes", self, case.tolerance), lambda: tuple(self._made(case)))

    def single_grids(self, case: Case) -> Iterator[Grid]:
        """The answers that single mistakes lead to."""
        return (one.grid for one in self._wrong(case))

    def _made(self, case: Case) -> Iterator[Wrong]:
        exercise, right = case.exercise, self.right(case)
        known = [self.at_points(case.memo, right)]
        for slip, grid in self.every(case, right):
            try:
                seen = grid.numbers_in(case.memo) if exercise.numeric else ()
                limits = self._limits(case, grid, seen) if exercise.numeric else ()
                points = self.at_points(case.memo, grid)
            except (DhcliError, KeyError, ZeroDivisionError, OverflowError):
                continue
            if not any(alike(points, other) for other in known):
                known.append(points)
                yield Wrong(slip, grid, seen, limits, points)

    def every(self, case: Case, right: Grid) -> Iterator[tuple[Slip, Grid]]:
        """Mistakes in the work, then those in one entry."""
        yield from self.wrong(case)
        yield from signs(right, self.place)
        yield from swapped(right)

    def at_points(self, memo: Memo, grid: Grid) -> tuple[Numbers, ...]:
        """Entries at general points; at the values given, in symbols."""
        own = memo.of("own names", lambda: frozenset(memo.exercise.scope.names) | frozenset(memo.exercise.names))
        try:
            return tuple(over(grid.rows, floats) for floats in general_floats_in(memo, own))
        except KeyError:  # a name that is none of the exercise's, such as that of an angle of the hand
            return tuple(over(grid.rows, floats) for floats in general_floats_in(memo, grid.names | own))

    def _is_right(self, case: Case, one: Wrong) -> bool:
        """Whether a mistake cannot be seen at the values given."""
        if not case.exercise.numeric:
            return False
        right, limits = case.memo.of(("motion numbers", self, case.tolerance), lambda: self.right_numbers(case))
        return within(one.seen, right, limits)

    def right_numbers(self, case: Case) -> tuple[Numbers, Numbers]:
        """The right entries at the values given, and how far from them an answer may be."""
        right = self.right(case)
        found = right.numbers(case.exercise)
        return found, self._limits(case, right, found)

    @staticmethod
    def _limits(case: Case, grid: Grid, found: Numbers) -> Numbers:
        return grid.limits(found, case.tolerance.position, case.tolerance.rotation)

    def _makers(self, case: Case, entries: Entries) -> list[Wrong]:
        """The mistakes that an answer is that of: near it in numbers, proved equal in symbols."""
        every = self._wrong(case)
        if not case.exercise.numeric:
            return [one for one in every if self._equals(case, one.grid, one.general, entries)]
        typed = values_of(entries, case.exercise)
        return [one for one in every if within(typed, one.seen, one.limits) and not self._is_right(case, one)]

    def _by_digits(self, case: Case, entries: Entries) -> list[Wrong]:
        """Mistakes that give an answer to the digits typed, where these are enough for that not to be chance."""
        if not case.exercise.numeric:
            return []
        typed, every = Digits.of(case.exercise, self.right(case), entries), self._wrong(case)
        found = [one for one in every if typed.are_those_of(one.seen) and not self._is_right(case, one)]
        is_known = found and typed.say_enough(*self.right_numbers(case), [one.seen for one in every])
        return found if is_known else []

    def gives(self, case: Case, grid: Grid, entries: Entries) -> bool:
        """Whether an answer is that of a grid."""
        if case.exercise.numeric:
            typed = values_of(entries, case.exercise)
            found = grid.numbers(case.exercise)
            return within(typed, found, self._limits(case, grid, found))
        return self._equals(case, grid, self.at_points(case.memo, grid), entries)

    def _equals(self, case: Case, grid: Grid, points: Sequence[Numbers], entries: Entries) -> bool:
        """Whether expressions are proved equal; those that differ at a point need no proof."""
        given = self.given(grid, entries)
        try:
            if not alike(self.at_points(case.memo, given), points):
                return False
        except (KeyError, UnreadableError):
            return False
        pairs = zip(given.rows, grid.rows, strict=True)
        values = case.exercise.values
        return all(same(a, b, values) for row, other in pairs for a, b in zip(row, other, strict=True))

    @staticmethod
    def given(like: Grid, entries: Entries) -> Grid:
        """An answer as a grid that measures the same."""
        return replace(like, rows=tuple(tuple(entry.expr for entry in row) for row in entries))

    # --- Solutions ----------------------------------------------------------------------------------------------

    def shown(self, case: Case, text: str, grid: Grid) -> Shown:
        """A step with a table: in numbers in the unit of the sheet."""
        exercise = case.exercise
        if not exercise.numeric or grid.names - exercise.values.keys():
            return Shown(text, grid.on_sheet(exercise))
        pairs = zip(grid.numbers(exercise), grid.powers, strict=True)
        return Shown(
            text,
            tuple(tuple(v / scale_of(exercise, p) for v, p in zip(values, row, strict=True)) for values, row in pairs),
        )


class OneNumberQuestion(MotionQuestion):
    """A question about motion whose answer is one number or one expression."""

    __slots__ = ()

    in_rows: ClassVar = False

    def size(self, _robot: Robot) -> tuple[int, int]:
        """One entry."""
        return 1, 1

    def place(self, _row: int, _column: int) -> str:
        """There is but one."""
        return ""
