"""`rank of jacobian`: how many independent motions an arm has where it stands."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import ClassVar

from dhcli.checking.diagnosis.result import Rank, Slip
from dhcli.checking.entries import Entries
from dhcli.checking.exercise import Case, Exercise
from dhcli.checking.motion.columns import columns_for
from dhcli.checking.motion.grid import Grid
from dhcli.checking.motion.question import MotionQuestion, OneNumberQuestion
from dhcli.checking.motion.task import JacobianTask, jacobian_step, values_in
from dhcli.checking.pasted import UnreadableError, without_number_word
from dhcli.checking.returned import Shown
from dhcli.errors import Place
from dhcli.frozen import frozen
from dhcli.geometry.linear import rank
from dhcli.notation.tree import Number, number


@frozen
class RankQuestion(JacobianTask, OneNumberQuestion):
    """The rank of a Jacobian, at the values given or at almost all."""

    words: ClassVar = ("rank",)
    examples: ClassVar = ("rank of jacobian of 0..6",)
    is_plain: ClassVar = True

    def named(self, case: Case) -> frozenset[str]:
        return columns_for(case, self.motion).names

    def describe(self, exercise: Exercise) -> str:
        where = "at the values given" if exercise.numeric else "at almost all joint values"
        rows = ", ".join(self.form.labels)
        return f"the rank of the Jacobian {self.motion.where(exercise)}, rows {rows}, {where}: a whole number"

    def read(self, case: Case, text: str, place: Place | None = None) -> Entries:
        entries = MotionQuestion.read(self, case, without_number_word(text, ()), place)
        typed = entries[0][0].expr
        if not isinstance(typed, Number) or typed.value.denominator != 1:
            raise UnreadableError("a rank is a whole number")
        return entries

    def computed(self, case: Case) -> Grid:
        return _one(rank(values_in(case, columns_for(case, self.motion), self.form.rows)))

    def wrong(self, case: Case) -> Iterator[tuple[Slip, Grid]]:
        columns, rows = columns_for(case, self.motion), self.form.rows
        full = min(len(columns.each), sum(k in rows for k in columns.moved))
        right = rank(values_in(case, columns, rows))
        hint = "count the columns that cannot be made of the others"
        yield Slip("full-rank", "this is the rank away from singular poses", hint, Rank.WHOLE), _one(full)
        yield Slip("rows-counted", "this counts the rows", hint, Rank.WHOLE), _one(len(rows))
        yield Slip("joints-counted", "this counts the joints", hint, Rank.WHOLE), _one(len(columns.each))
        yield Slip("loss-counted", "this counts the motions that are lost", hint, Rank.WHOLE), _one(full - right)

    def steps(self, case: Case) -> Iterable[Shown]:
        yield jacobian_step(self, case, self.form.part)
        yield Shown("The rank is the number of columns of which none can be made of the others")


def _one(value: int) -> Grid:
    return Grid(((number(value),),), ((0,),))
