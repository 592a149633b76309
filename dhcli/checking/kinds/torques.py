"""`torques for (0, 0, 10)`: what the joints bear while the end presses with a force and a moment."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction
from typing import ClassVar, Self

from dhcli.checking.diagnosis.result import Rank, Slip
from dhcli.checking.exercise import Case, Exercise
from dhcli.checking.motion.asked import Motion, read_motion, three
from dhcli.checking.motion.columns import Columns, combined, jacobian_grid
from dhcli.checking.motion.from_columns import ColumnsQuestion, axes_step
from dhcli.checking.motion.grid import Grid
from dhcli.checking.motion.reading import FORCE, TORQUE
from dhcli.checking.named import Naming
from dhcli.checking.returned import Shown
from dhcli.checking.wanted import NotAskedError
from dhcli.errors import Place, RobotError
from dhcli.frozen import frozen
from dhcli.kinematics.frames import ORIGIN
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.velocity.cramer import LARGEST, solved
from dhcli.kinematics.velocity.form import GEOMETRIC
from dhcli.notation.scope import Scope
from dhcli.notation.tree import Expr, multiply, negate, number
from dhcli.notation.walk import symbols_in
from dhcli.notation.writer import write
from dhcli.regex import regex

_HEAD = regex(r"torques\s+for\s*(?P<force>\(.*?\))(?:\s+moment\s*(?P<moment>\(.*?\)))?")

MILLI = number(1000)


@frozen
class TorquesQuestion(ColumnsQuestion):
    """Joint torques for a wrench that the end exerts: tau = Jᵀ F.

    Attributes:
        motion: At which point, along which axes.
        force: The force [N].
        moment: The moment [N m].
    """

    motion: Motion
    force: tuple[Expr, Expr, Expr]
    moment: tuple[Expr, Expr, Expr] = ORIGIN

    words: ClassVar = ("torques",)
    examples: ClassVar = ("torques for (f_x, f_y, 0) of 0..3", "torques for (0, 0, 10) moment (0, 1, 0) in frame 3")

    @classmethod
    def asked(cls, text: str, scope: Scope, place: Place | None) -> Self:
        """`torques for (0, 0, 10) moment (0, 1, 0) of 0..3 in frame 3`."""
        motion = read_motion(text, scope, place)
        match = _HEAD.fullmatch(motion.head)
        if match is None or motion.rates is not None:
            raise NotAskedError(text)
        moment = three(match["moment"], scope, place) if match["moment"] else ORIGIN
        return cls(motion, three(match["force"], scope, place), moment)

    def check(self, robot: Robot | None) -> None:
        self.motion.check(robot)

    def size(self, robot: Robot) -> tuple[int, int]:
        return len(self.motion.joints(robot)), 1

    @property
    def names(self) -> frozenset[str]:
        return symbols_in((*self.force, *self.moment))

    def describe(self, exercise: Exercise) -> str:
        wrench = f"({', '.join(map(write, self.force))}) N"
        if self.moment != ORIGIN:
            wrench += f" and the moment ({', '.join(map(write, self.moment))}) N m"
        kinds = {joint.kind for joint in exercise.robot.joints} if exercise.robot else {"revolute"}
        what = " and ".join(
            name for kind, name in (("revolute", "torques [N m]"), ("prismatic", "forces [N]")) if kind in kinds
        )
        return f"the joint {what} with which the end exerts the force {wrench}, {self.motion.where(exercise)}"

    def units(self, case: Case) -> tuple[str, ...]:
        return tuple(TORQUE if one.turns else FORCE for one in self.columns(case).each)

    def numbers_named(self, case: Case) -> Naming:
        return self.motion.joints(case.exercise.robot)

    def of_columns(self, _case: Case, columns: Columns) -> Grid:
        six = (*self.force, *self.moment)
        return _column([combined((*one.linear, *one.angular), six) for one in columns.each])

    def besides(self, case: Case, columns: Columns) -> Iterator[tuple[Slip, Grid]]:
        right = self.of_columns(case, columns)
        hint = "who presses on whom: the end on the load, or the load on the end?"
        yield (
            Slip("sign", "all signs are turned round", hint, Rank.WHOLE),
            _column([negate(row[0]) for row in right.rows]),
        )
        if not self.names:
            words = "the load is taken in kilograms, times 9.81 m/s²"
            slip = Slip("kilograms", words, "is the load given in newtons or in kilograms?", Rank.WHOLE)
            yield slip, _column([multiply(number(Fraction(981, 100)), row[0]) for row in right.rows])
        six = (*self.force, *self.moment)
        slip = Slip("millimetres", "lengths are taken in millimetres: this is in N mm", "in which unit are lengths?")
        in_mm = (tuple(multiply(MILLI, x) if one.turns else x for x in one.linear) for one in columns.each)
        pairs = zip(in_mm, columns.each, strict=True)
        yield slip, _column([combined((*linear, *one.angular), six) for linear, one in pairs])
        kept = [k for k in columns.moved if k < 3 or self.moment != ORIGIN]  # noqa: PLR2004  the rows of v
        rows = columns.cut(kept)
        if len(kept) != len(columns.each):
            return
        hint = "does the matrix lead from torques to forces, or back?"
        slip = Slip("transpose-forgotten", "this is J F; the torques are Jᵀ F", hint, Rank.WHOLE)
        yield slip, _column([combined(row, [six[k] for k in kept]) for row in rows])
        if len(kept) <= LARGEST:
            slip = Slip("inverse-for-transpose", "this is J⁻¹ F; the torques are Jᵀ F", hint, Rank.WHOLE)
            try:
                yield slip, _column(solved(rows, [six[k] for k in kept]))
            except (RobotError, ZeroDivisionError):
                return

    def steps(self, case: Case) -> Iterable[Shown]:
        columns = self.columns(case)
        yield axes_step(case, columns)
        yield self.shown(case, "The Jacobian, rows v above ω", jacobian_grid(case, columns, GEOMETRIC))
        yield Shown("A joint bears its column times the force, its lower half times the moment: tau = Jᵀ F")


def _column(entries: Iterable[Expr]) -> Grid:
    rows = tuple((entry,) for entry in entries)
    return Grid(rows, ((0,),) * len(rows))
