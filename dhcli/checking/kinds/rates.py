"""`joint rates for (0.1, 0, 0)`: how fast the joints must move for a velocity of the end."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import ClassVar, Self

from dhcli.checking.diagnosis.result import Rank, Slip
from dhcli.checking.exercise import Case, Exercise
from dhcli.checking.motion.asked import Motion, in_units, read_motion, three
from dhcli.checking.motion.columns import Columns, columns_of, combined, plain
from dhcli.checking.motion.from_columns import ColumnsQuestion, axes_step
from dhcli.checking.motion.grid import Grid, floats_in, over
from dhcli.checking.motion.reading import SPEED, TURNING
from dhcli.checking.motion.task import jacobian_step
from dhcli.checking.named import Naming
from dhcli.checking.returned import Shown
from dhcli.checking.wanted import NotAskedError
from dhcli.errors import Place, RobotError
from dhcli.frozen import frozen
from dhcli.geometry.linear import solution
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.singular.finding import neat_determinant
from dhcli.kinematics.velocity.cramer import LARGEST, solved
from dhcli.kinematics.velocity.form import Form, Which, part_of
from dhcli.notation.scope import Scope
from dhcli.notation.tree import PI, Expr, multiply, number, power
from dhcli.notation.walk import symbols_in
from dhcli.regex import regex

_HEAD = regex(
    r"joint\s+rates\s+for\s*(?P<linear>\([^()]*(?:\([^()]*\)[^()]*)*\))?(?:\s*angular\s*(?P<angular>\(.*\)))?"
)


@frozen
class RatesQuestion(ColumnsQuestion):
    """The joint rates for a velocity, an angular velocity or both, of an arm with as many joints as they have rows.

    Attributes:
        motion: Of which frame and point, along which axes.
        linear: The velocity [m/s]; None where any will do.
        angular: The angular velocity [rad/s]; None where any will do.
    """

    motion: Motion
    linear: tuple[Expr, Expr, Expr] | None
    angular: tuple[Expr, Expr, Expr] | None = None

    words: ClassVar = ("joint rates",)
    examples: ClassVar = (
        "joint rates for (0.1, 0, 0) of 0..3",
        "joint rates for (v_x, v_y, 0) angular (0, 0, 1) of 0..6",
    )

    @classmethod
    def asked(cls, text: str, scope: Scope, place: Place | None) -> Self:
        """`joint rates for (0.1, 0, 0) of 0..3`."""
        motion = read_motion(text, scope, place)
        match = _HEAD.fullmatch(motion.head)
        if match is None or motion.rates is not None or not (match["linear"] or match["angular"]):
            raise NotAskedError(text)
        linear, angular = (three(match[part], scope, place) if match[part] else None for part in ("linear", "angular"))
        return cls(motion, linear, angular)

    def check(self, robot: Robot | None) -> None:
        robot, view = self.motion.check(robot)
        kept, joints = self._kept(columns_of(robot, view)), self.motion.joints(robot)
        if len(kept) != len(joints):
            raise RobotError(
                f"{len(joints)} joints cannot make every velocity of {len(kept)} numbers, or in more than one way",
                "ask for the velocity or the angular velocity alone",
            )

    @property
    def _part(self) -> Which:
        return part_of(self.linear, self.angular)

    def _kept(self, columns: Columns) -> tuple[int, ...]:
        return tuple(k for k in columns.moved if k in Form(self._part).rows)

    def _asked(self, kept: Sequence[int]) -> list[Expr]:
        six = (*(self.linear or (number(0),) * 3), *(self.angular or (number(0),) * 3))
        return [six[k] for k in kept]

    def size(self, robot: Robot) -> tuple[int, int]:
        return len(self.motion.joints(robot)), 1

    @property
    def names(self) -> frozenset[str]:
        return symbols_in((*(self.linear or ()), *(self.angular or ())))

    def named(self, case: Case) -> frozenset[str]:
        return self.columns(case).names | self.names

    def describe(self, exercise: Exercise) -> str:
        said = []
        for name, vector, unit in (("velocity", self.linear, SPEED), ("angular velocity", self.angular, TURNING)):
            if vector is not None:
                said.append(f"the {name} {in_units(vector, (unit,) * 3, exercise)}")
        units = self._units(exercise) if exercise.numeric else ""
        return f"the joint rates{units} for {' and '.join(said)} {self.motion.where(exercise)}, one for each joint"

    def _units(self, exercise: Exercise) -> str:
        """In which units the answer is, in brackets; a length of a sheet without units has none."""
        joints = exercise.robot.joints if exercise.robot else ()
        kinds = {joint.kind for joint in joints if joint.name in self.motion.joints(exercise.robot)}
        slide = "" if exercise.unit == "none" else f"{exercise.unit}/s"
        if kinds == {"revolute"}:
            return f" [{TURNING}]"
        if kinds == {"prismatic"}:
            return f" [{slide}]" if slide else ""
        return f" [{TURNING}, of a slide {slide}]" if slide else f" [{TURNING} where a joint turns]"

    def measured(self, exercise: Exercise) -> Iterable[tuple[Sequence[Expr], Sequence[str]]]:
        return (*ColumnsQuestion.measured(self, exercise), (self.linear or (), (SPEED,) * len(self.linear or ())))

    def units(self, case: Case) -> tuple[str, ...]:
        return tuple(TURNING if one.turns else SPEED for one in self.columns(case).each)

    def numbers_named(self, case: Case) -> Naming:
        return self.motion.joints(case.exercise.robot)

    def of_columns(self, case: Case, columns: Columns) -> Grid:
        exercise, kept = case.exercise, self._kept(self.columns(case))
        rows, asked = columns.cut(kept), self._asked(kept)
        if exercise.numeric:
            arithmetic = floats_in(case.memo)
            return self._column(
                columns, plain(solution(over(rows, arithmetic), [arithmetic.value(one) for one in asked]))
            )
        if len(kept) > LARGEST:
            raise RobotError(f"rates of {len(kept)} joints are too long in symbols", "numeric: true")
        is_right = columns == self.columns(case)
        whole = neat_determinant(columns.robot, columns.view, self._part, {}, rows) if is_right else None
        return self._column(columns, solved(rows, asked, whole))

    @staticmethod
    def _column(columns: Columns, entries: Iterable[Expr]) -> Grid:
        return Grid(tuple((one,) for one in entries), tuple((int(not one.turns),) for one in columns.each))

    def besides(self, case: Case, columns: Columns) -> Iterator[tuple[Slip, Grid]]:
        kept = self._kept(self.columns(case))
        rows, asked = columns.cut(kept), self._asked(kept)
        hint = "does the matrix lead from rates to velocities, or back?"
        transposed = (combined(column, asked) for column in zip(*rows, strict=True))
        words = "this is Jᵀ v; the rates are J⁻¹ v"
        yield Slip("transpose-for-inverse", words, hint, Rank.WHOLE), self._column(columns, transposed)
        multiplied = (combined(row, asked) for row in rows)
        words = "this is J v; the rates are J⁻¹ v"
        yield Slip("inverse-forgotten", words, hint, Rank.WHOLE), self._column(columns, multiplied)
        if case.exercise.numeric:
            factor = multiply(number(180), power(PI, -1))
            pairs = zip(columns.each, self.of_columns(case, columns).rows, strict=True)
            degrees = (multiply(factor, row[0]) if one.turns else row[0] for one, row in pairs)
            slip = Slip(
                "degrees", "the rates are in degrees a second", "in which unit are angular rates asked for?", Rank.WHOLE
            )
            yield slip, self._column(columns, degrees)

    def steps(self, case: Case) -> Iterable[Shown]:
        yield axes_step(case, self.columns(case))
        yield jacobian_step(self, case, self._part)
        yield Shown("Solve J q' = v for the rates q', leaving rows out that no joint moves")
