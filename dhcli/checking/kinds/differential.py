"""`differential motion (d) turn (δ) of 0..3`: how a small motion changes a pose, dT = Δ T."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import ClassVar, Self

from dhcli.checking.diagnosis.result import Rank, Slip
from dhcli.checking.exercise import Case, Exercise
from dhcli.checking.kinds.linked import needed
from dhcli.checking.motion.asked import Motion, in_units, read_motion, three
from dhcli.checking.motion.columns import combined
from dhcli.checking.motion.grid import Grid, Rows
from dhcli.checking.motion.question import MotionQuestion
from dhcli.checking.returned import Shown
from dhcli.checking.wanted import NotAskedError
from dhcli.errors import Place, RobotError
from dhcli.frozen import frozen
from dhcli.kinematics.forward import textbook_form
from dhcli.kinematics.frames import ORIGIN, between, ends
from dhcli.kinematics.robot import Robot
from dhcli.notation.scope import Scope
from dhcli.notation.tree import ZERO, Expr, add, negate
from dhcli.notation.walk import symbols_in
from dhcli.regex import regex

_HEAD = regex(r"differential\s+motion\s*(?P<moved>\([^()]*\))(?:\s+turn\s*(?P<turned>\([^()]*\)))?")
POWERS = ((0, 0, 0, 1),) * 3 + ((0, 0, 0, 0),)


@frozen
class DifferentialQuestion(MotionQuestion):
    """The change of a pose by a small displacement and a small turn.

    Attributes:
        motion: Of which frame; along the axes of its reference, or of the frame itself.
        moved: The displacement d [m].
        turned: The turn δ [rad].
    """

    motion: Motion
    moved: tuple[Expr, Expr, Expr]
    turned: tuple[Expr, Expr, Expr] = ORIGIN

    words: ClassVar = ("differential",)
    examples: ClassVar = ("differential motion (0.001, 0, 0) turn (0, 0, 0.01) of 0..3",)

    @classmethod
    def asked(cls, text: str, scope: Scope, place: Place | None) -> Self:
        """`differential motion (0.001, 0, 0) turn (0, 0, 0.01) of 0..3 in frame 3`."""
        motion = read_motion(text, scope, place)
        match = _HEAD.fullmatch(motion.head)
        if match is None or motion.rates is not None or motion.point != ORIGIN:
            raise NotAskedError(text)
        turned = three(match["turned"], scope, place) if match["turned"] else ORIGIN
        return cls(motion, three(match["moved"], scope, place), turned)

    def check(self, robot: Robot | None) -> None:
        start, end = ends(needed(robot), self.motion.start or None, self.motion.end or None)
        if self.motion.axes not in ("", start, end):
            raise RobotError("a small motion is given along the axes of one of the two frames", f"in frame {end}")

    def size(self, _robot: Robot) -> tuple[int, int]:
        return 4, 4

    @property
    def names(self) -> frozenset[str]:
        return symbols_in((*self.moved, *self.turned))

    def describe(self, exercise: Exercise) -> str:
        moved, turned = (
            in_units(one, (unit,) * 3, exercise) for one, unit in ((self.moved, "m"), (self.turned, "rad"))
        )
        small = f"{moved} and the small turn {turned}"
        return (
            f"the change dT of the pose, for the small displacement {small} {self.motion.where(exercise)}: a 4x4 matrix"
        )

    def measured(self, _exercise: Exercise) -> Iterable[tuple[Sequence[Expr], Sequence[str]]]:
        return ((self.moved, ("m",) * 3),)

    def _pose(self, case: Case) -> tuple[Rows, bool]:
        robot = needed(case.exercise.robot)
        start, end = ends(robot, self.motion.start or None, self.motion.end or None)
        return textbook_form(between(robot, start, end)), self.motion.axes in ("", start)

    def named(self, case: Case) -> frozenset[str]:
        pose, _ = self._pose(case)
        return Grid(pose, POWERS).names | self.names

    def computed(self, case: Case) -> Grid:
        pose, in_reference = self._pose(case)
        return _changed(pose, self._delta(), in_reference)

    def _delta(self) -> Rows:
        (dx, dy, dz), (x, y, z) = self.moved, self.turned
        return (
            (ZERO, negate(z), y, dx),
            (z, ZERO, negate(x), dy),
            (negate(y), x, ZERO, dz),
            (ZERO, ZERO, ZERO, ZERO),
        )

    def wrong(self, case: Case) -> Iterator[tuple[Slip, Grid]]:
        pose, in_reference = self._pose(case)
        delta = self._delta()
        hint = "along whose axes is the small motion given?"
        words = "Δ stands on the other side of T" if in_reference else "Δ stands in front of T, not behind it"
        yield Slip("other-side", words, hint, Rank.WHOLE), _changed(pose, delta, not in_reference)
        turned = tuple(tuple(negate(e) if c < 3 else e for c, e in enumerate(row)) for row in delta)  # noqa: PLR2004
        words = "the turn has the wrong sign: rows and columns of its part of Δ are exchanged"
        yield (
            Slip("turn-sign", words, "which sign has δz in the first row of Δ?", Rank.WHOLE),
            _changed(pose, turned, in_reference),
        )
        new = tuple(
            tuple(add(a, b) for a, b in zip(row, line, strict=True))
            for row, line in zip(pose, _changed(pose, delta, in_reference).rows, strict=True)
        )
        slip = Slip(
            "new-pose", "this is the new pose T + dT; its change dT is asked for", "is a change asked for?", Rank.WHOLE
        )
        yield slip, Grid(new, POWERS)
        yield (
            Slip("delta-alone", "this is Δ; dT is Δ times T", "what is Δ multiplied with?", Rank.WHOLE),
            Grid(delta, POWERS),
        )

    def steps(self, case: Case) -> Iterable[Shown]:
        pose, in_reference = self._pose(case)
        yield self.shown(case, "The pose T", Grid(pose, POWERS))
        yield self.shown(case, "The small motion Δ", Grid(self._delta(), POWERS))
        yield Shown("dT = Δ T, for the motion is given in the reference" if in_reference else "dT = T Δ")


def _changed(pose: Rows, delta: Rows, in_reference: bool) -> Grid:  # noqa: FBT001
    first, second = (delta, pose) if in_reference else (pose, delta)
    columns = tuple(zip(*second, strict=True))
    return Grid(tuple(tuple(combined(row, column) for column in columns) for row in first), POWERS)
