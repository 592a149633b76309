"""`determinant of jacobian`: where it is zero the arm loses a motion."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import ClassVar

from dhcli.algebra.equality import equal
from dhcli.checking.diagnosis.result import Rank, Slip
from dhcli.checking.exercise import Case, Exercise
from dhcli.checking.motion.columns import Columns
from dhcli.checking.motion.from_columns import ColumnsQuestion
from dhcli.checking.motion.grid import Grid, exact
from dhcli.checking.motion.question import OneNumberQuestion
from dhcli.checking.motion.task import JacobianTask, found_for, jacobian_step, kept_rows, square, values_in
from dhcli.checking.returned import Shown
from dhcli.errors import RobotError
from dhcli.frozen import frozen
from dhcli.geometry.linear import determinant_of
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.velocity.cramer import LARGEST, determinant
from dhcli.kinematics.velocity.form import Form
from dhcli.notation.tree import ZERO, Expr, Number, Power, Product, multiply, negate, power
from dhcli.notation.writer import write


@frozen
class DeterminantQuestion(JacobianTask, OneNumberQuestion, ColumnsQuestion):
    """The determinant of a Jacobian, of the rows that the joints can move."""

    words: ClassVar = ("determinant",)
    examples: ClassVar = ("determinant of jacobian linear of 0..3",)

    def check(self, robot: Robot | None) -> None:
        square(*self.motion.check(robot), self.form)

    def describe(self, exercise: Exercise) -> str:
        rows = ", ".join(square(*self.motion.check(exercise.robot), self.form).rows)
        return f"the determinant of the Jacobian {self.motion.where(exercise)}, rows {rows}"

    def computed(self, case: Case) -> Grid:
        return self._one(case, found_for(case, self.motion, self.form).determinant or ZERO)

    def of_columns(self, case: Case, columns: Columns) -> Grid:
        kept = kept_rows(found_for(case, self.motion, self.form))
        if len(kept) > LARGEST and not case.exercise.numeric:
            raise RobotError(f"a determinant of {len(kept)} rows is not written out")
        is_short = len(kept) <= LARGEST
        value = determinant(columns.cut(kept)) if is_short else exact(determinant_of(values_in(case, columns, kept)))
        if equal(value, ZERO):  # to which many mistakes lead
            raise RobotError("the determinant is 0")
        return self._one(case, value)

    def _one(self, case: Case, value: Expr) -> Grid:
        columns, kept = self.columns(case), kept_rows(found_for(case, self.motion, self.form))
        slides = sum(not column.turns for column in columns.each)
        lengths = sum(k < 3 for k in kept) - slides  # noqa: PLR2004  the rows of v
        return Grid(((value,),), ((max(0, lengths),),))

    def besides(self, case: Case, columns: Columns) -> Iterator[tuple[Slip, Grid]]:
        found = found_for(case, self.motion, self.form)
        kept, is_right = kept_rows(found), columns == self.columns(case)
        right = (found.determinant or ZERO) if is_right else self.of_columns(case, columns).rows[0][0]
        yield Slip("sign", "the sign is turned round", "look at the sign", Rank.WHOLE), self._one(case, negate(right))
        for factor in _factors(right) if is_right else ():
            text = write(factor, "short", found.writing)
            slip = Slip(f"factor-forgotten {text}", f"the factor {text} is missing", "go through the factors")
            yield slip, self._one(case, multiply(right, power(factor, -1)))
        if len(kept) > LARGEST:
            return
        words = "every second product is added instead of taken away"
        slip = Slip("signs-of-minors", words, "which signs have the products of a determinant?", Rank.WHOLE)
        yield slip, self._one(case, determinant(columns.cut(kept), signed=False))

    def steps(self, case: Case) -> Iterable[Shown]:
        found = found_for(case, self.motion, self.form)
        yield jacobian_step(self, case, found.part)
        if len(found.rows) < len(Form(found.part).rows):
            yield Shown(f"No joint moves the other rows, so that {', '.join(found.rows)} are left")
        if found.determinant is not None and case.exercise.numeric:
            yield Shown(f"In symbols it is {write(found.determinant, 'short', found.writing)}")


def _factors(whole: Expr) -> Iterator[Expr]:
    """The factors of a product, of a power its base as well: d3² lacks d3, or all of it."""
    for factor in whole.factors if isinstance(whole, Product) else ():
        if not isinstance(factor, Number):
            yield factor
        if isinstance(factor, Power):
            yield factor.base
