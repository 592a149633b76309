"""`manipulability of`: Yoshikawa's w = √det(J Jᵀ) where an arm stands."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from typing import ClassVar

from dhcli.checking.diagnosis.result import Rank, Slip
from dhcli.checking.exercise import Case, Exercise
from dhcli.checking.motion.columns import Columns
from dhcli.checking.motion.from_columns import ColumnsQuestion
from dhcli.checking.motion.grid import Grid, exact
from dhcli.checking.motion.question import OneNumberQuestion
from dhcli.checking.motion.task import JacobianTask, found_for, jacobian_step, kept_rows, values_in
from dhcli.checking.returned import Shown
from dhcli.errors import RobotError
from dhcli.frozen import frozen
from dhcli.geometry.linear import determinant_of

LEAST = 1e-6
"""A volume below this share of the right one is none."""


@frozen
class ManipulabilityQuestion(JacobianTask, OneNumberQuestion, ColumnsQuestion):
    """The manipulability of an arm where it stands, in numbers."""

    words: ClassVar = ("manipulability",)
    examples: ClassVar = ("manipulability of jacobian linear of 0..3",)

    def named(self, case: Case) -> frozenset[str]:
        return self.columns(case).names

    def describe(self, exercise: Exercise) -> str:
        part = {"all": "", "linear": ", rows v", "angular": ", rows ω"}[self.form.part]
        return f"the manipulability w = √det(J Jᵀ) {self.motion.where(exercise)}{part}, a number"

    def computed(self, case: Case) -> Grid:
        if not case.exercise.numeric:
            raise RobotError("manipulability is asked in numbers", "numeric: true")
        return self._one(case, self._volume(case, self.columns(case)))

    def of_columns(self, case: Case, columns: Columns) -> Grid:
        value = self._volume(case, columns)
        if value <= LEAST * self._volume(case, self.columns(case)):  # 0 has many reasons
            raise RobotError("the manipulability is 0")
        return self._one(case, value)

    def _kept(self, case: Case) -> tuple[int, ...]:
        return kept_rows(found_for(case, self.motion, self.form))

    def _one(self, case: Case, value: float) -> Grid:
        columns, kept = self.columns(case), self._kept(case)
        lengths = min(len(kept), len(columns.each)) - sum(not column.turns for column in columns.each)
        lengths = 0 if kept[0] > 2 else min(lengths, sum(k < 3 for k in kept))  # noqa: PLR2004  the rows of v
        return Grid(((exact(value),),), ((max(0, lengths),),))

    def _volume(self, case: Case, columns: Columns) -> float:
        rows = values_in(case, columns, self._kept(case))
        if len(rows) > len(rows[0]):
            rows = tuple(zip(*rows, strict=True))
        squares = [[sum(a * b for a, b in zip(one, other, strict=True)) for other in rows] for one in rows]
        return math.sqrt(max(0.0, determinant_of(squares)))

    def besides(self, case: Case, columns: Columns) -> Iterator[tuple[Slip, Grid]]:
        right = self._volume(case, columns)
        powers = self.right(case).powers
        slip = Slip("root-forgotten", "this is det(J Jᵀ), without the root", "w is a root", Rank.WHOLE)
        yield slip, Grid(((exact(right**2),),), powers)
        slip = Slip("reciprocal", "this is 1/w", "is it large or small near a singular pose?", Rank.WHOLE)
        if right:
            yield slip, Grid(((exact(1 / right),),), powers)

    def steps(self, case: Case) -> Iterable[Shown]:
        found = found_for(case, self.motion, self.form)
        yield jacobian_step(self, case, found.part)
        if len(found.rows) == len(found.joints):
            yield Shown("With as many joints as rows w is the size of the determinant")
