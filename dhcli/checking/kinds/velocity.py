"""`velocity of point`, `angular velocity`: how fast a frame moves for rates of its joints."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import ClassVar, Self

from dhcli.checking.diagnosis.result import Rank, Slip
from dhcli.checking.exercise import Case, Exercise
from dhcli.checking.motion.asked import Motion, in_units, read_motion, three
from dhcli.checking.motion.columns import Columns, combined
from dhcli.checking.motion.from_columns import ColumnsQuestion, axes_step
from dhcli.checking.motion.grid import Grid
from dhcli.checking.motion.reading import SPEED, TURNING
from dhcli.checking.motion.task import jacobian_step
from dhcli.checking.named import XYZ, Naming
from dhcli.checking.returned import Shown
from dhcli.checking.wanted import NotAskedError
from dhcli.errors import Place
from dhcli.frozen import frozen
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.velocity.view import check_rates
from dhcli.notation.scope import Scope
from dhcli.notation.tree import PI, Expr, Symbol, multiply, number, power
from dhcli.notation.walk import symbols_in
from dhcli.regex import regex

_HEAD = regex(r"(?P<angular>angular\s+)?velocity(?:\s+of\s+point\s*(?P<point>\(.*\)))?(?:\s+of\s+point)?")


@frozen
class VelocityQuestion(ColumnsQuestion):
    """The velocity of a point of a frame, or the angular velocity of the frame.

    Attributes:
        motion: Of which frame and point, along which axes, at which joint rates.
        angular: Whether the angular velocity is asked for.
    """

    motion: Motion
    angular: bool = False

    words: ClassVar = ("velocity", "angular")
    examples: ClassVar = (
        "velocity of point (0, 0, 0) of 0..3",
        "velocity of 0..2 with rates (0.5, -1)",
        "angular velocity of 0..3 in frame 3",
    )

    @classmethod
    def asked(cls, text: str, scope: Scope, place: Place | None) -> Self:
        """`velocity of point (0, 0, c) of 0..3 in frame 3 with rates (1, 0, 0.5)`."""
        motion = read_motion(text, scope, place)
        match = _HEAD.fullmatch(motion.head)
        if match is None:
            raise NotAskedError(text)
        if match["point"]:
            motion = replace(motion, point=three(match["point"], scope, place))
        return cls(motion, bool(match["angular"]))

    def check(self, robot: Robot | None) -> None:
        joints = self.motion.joints(robot)
        if self.motion.rates is not None:
            check_rates(self.motion.rates, joints)

    def size(self, _robot: Robot) -> tuple[int, int]:
        return 3, 1

    @property
    def names(self) -> frozenset[str]:
        return symbols_in(self.motion.rates or ())

    def rates(self, robot: Robot | None) -> frozenset[str]:
        if self.motion.rates is not None:
            return frozenset()
        return frozenset(map(_rate, self.motion.joints(robot)))

    def describe(self, exercise: Exercise) -> str:
        what = "the angular velocity [rad/s]" if self.angular else f"the velocity [{exercise.unit}/s]"
        if exercise.unit == "none" and not self.angular:
            what = "the velocity"
        return f"{what} {self.motion.where(exercise)}: three numbers{self._at_rates(exercise)}"

    def _at_rates(self, exercise: Exercise) -> str:
        """For which joint rates, in words; nothing where none are given."""
        return "".join(f", for the joint rates {in_units(*given, exercise)}" for given in self._given_rates(exercise))

    def _given_rates(self, exercise: Exercise) -> Iterator[tuple[Sequence[Expr], Sequence[str]]]:
        """The joint rates that are given, with their units."""
        robot, rates = exercise.robot, self.motion.rates
        if rates is not None and robot is not None:
            kinds = {joint.name: joint.kind for joint in robot.joints}
            yield rates, [TURNING if kinds[name] == "revolute" else SPEED for name in self.motion.joints(robot)]

    def measured(self, exercise: Exercise) -> Iterable[tuple[Sequence[Expr], Sequence[str]]]:
        return (*ColumnsQuestion.measured(self, exercise), *self._given_rates(exercise))

    def units(self, _case: Case) -> tuple[str, ...]:
        return (TURNING if self.angular else SPEED,) * 3

    def numbers_named(self, _case: Case) -> Naming:
        return XYZ

    def _rates(self, columns: Columns) -> tuple[Expr, ...]:
        if self.motion.rates is not None:
            return self.motion.rates
        return tuple(Symbol(_rate(one.joint)) for one in columns.each)

    def of_columns(self, _case: Case, columns: Columns) -> Grid:
        return self._moved(columns, self._rates(columns))

    def _moved(self, columns: Columns, rates: tuple[Expr, ...]) -> Grid:
        rows = columns.cut((3, 4, 5) if self.angular else (0, 1, 2))
        return Grid(tuple((combined(row, rates),) for row in rows), ((int(not self.angular),),) * 3)

    def besides(self, case: Case, columns: Columns) -> Iterator[tuple[Slip, Grid]]:
        rates = self._rates(columns)
        if case.exercise.numeric:
            hint = "in which unit is an angular rate multiplied?"
            half = number(180)
            for name, factor in (
                ("", multiply(half, power(PI, -1))),
                (" other", multiply(PI, number(Fraction(1, 180)))),
            ):
                turned = tuple(
                    multiply(factor, rate) if one.turns else rate for one, rate in zip(columns.each, rates, strict=True)
                )
                words = "the rates are taken in degrees a second for radians a second, or the other way round"
                yield Slip(f"degrees{name}", words, hint, Rank.WHOLE), self._moved(columns, turned)
        hint = "which rate belongs to which joint?"
        yield Slip("rates-reversed", "the rates stand in the reverse order", hint), self._moved(columns, rates[::-1])

    def steps(self, case: Case) -> Iterable[Shown]:
        yield axes_step(case, self.columns(case))
        yield jacobian_step(self, case, "angular" if self.angular else "linear")
        yield Shown("Each column times the rate of its joint, added up")


def _rate(joint: str) -> str:
    """The name of a joint's rate."""
    return f"d{joint}"
