"""What the questions about the joint values that reach a given pose share, and which values are asked for."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING, ClassVar, Self, TypeVar

from dhcli.checking.exercise import Case, Exercise, Question
from dhcli.checking.kinds.linked import needed
from dhcli.checking.solving.goal import Target, of_robot, solutions
from dhcli.checking.solving.reading import Vector, spelled
from dhcli.checking.solving.vectors import Range, chain_of
from dhcli.frozen import frozen
from dhcli.kinematics.robot import Robot
from dhcli.notation.angle import Angle
from dhcli.notation.scope import Scope

if TYPE_CHECKING:
    from dhcli.kinematics.inverse.solutions import Solutions

Vectors = tuple[Vector, ...]
T = TypeVar("T")


@frozen
class GoalQuestion(Question[T]):
    """A question about the joint values that reach a pose."""

    target: Target

    needs_table: ClassVar = True  # for the joints

    def in_unit(self, unit: Fraction, scope: Scope) -> Self:
        """With the bare lengths of the pose in metres."""
        return replace(self, target=self.target.in_unit(unit, scope))

    def check(self, robot: Robot | None) -> None:
        """Make sure that the robot has the frames."""
        self.target.ends(robot)

    @property
    def names(self) -> frozenset[str]:
        """Those of the pose."""
        return self.target.names

    def unvalued(self, exercise: Exercise) -> tuple[str, ...]:
        """Those of the pose and of the robot: joint values are numbers, whatever the other parts are."""
        return tuple(sorted((self.target.names | set(needed(exercise.robot).parameters)) - exercise.known.keys()))


@frozen
class WantedJoints(GoalQuestion[Vectors]):
    """A question about joint values that take a frame to a pose.

    Attributes:
        which: Whether all solutions are asked for, or one: any, or that of a branch.
        branch: The words of the branch asked for.
        within_limits: Whether they must be inside the limits of the joints.
    """

    which: str = "any"
    branch: tuple[str, ...] = ()
    within_limits: bool = False

    def wanted(self, case: Case) -> list[int]:
        """The numbers of the solutions that are asked for, those within the limits first."""
        found = solutions(case, self.target)
        inside = found.within_limits
        kept = [k for k in range(len(found)) if inside[k] or not self.within_limits]
        kept = [k for k in kept if self._is_branch(found, k)]
        return sorted(kept, key=lambda k: not inside[k])

    def range_of(self, case: Case) -> Range:
        """What a vector is judged against."""
        return case.memo.of(("range", self.target), lambda: self._made_range(case))

    def text_of(self, case: Case, rows: Iterable[tuple[float, ...]]) -> str:
        """Joint vectors as a person would type them."""
        texts = [self.spelled(self.range_of(case), row) for row in rows]
        return f"[{'; '.join(texts)}]" if self.which == "all" else texts[0]

    def spelled(self, field: Range, values: Iterable[float]) -> str:
        """A joint vector as a person would type it."""
        pairs = zip(field.joints, values, strict=True)
        return ", ".join(spelled(field.exercise, field.robot, name, value) for name, value in pairs)

    def joints_of(self, exercise: Exercise) -> tuple[str, ...]:
        """The joints whose values are asked for."""
        from dhcli.checking.solving.derived import moving_joints

        return moving_joints(needed(exercise.robot), self.target)

    def _is_branch(self, found: Solutions, k: int) -> bool:
        own = found.branches[k].split(", ") if found.branches else ()
        return all(word in own for word in self.branch)

    def _made_range(self, case: Case) -> Range:
        from dhcli.algebra.floats import Floats
        from dhcli.kinematics.values import numbers

        exercise = case.exercise
        known = exercise.known
        robot, found = needed(exercise.robot), solutions(case, self.target)
        joints = self.joints_of(exercise)
        at = [robot.variables.index(name) for name in joints]
        rows = self.target.rows(known)
        over = Floats(numbers(known))
        lengths = [abs(over.length(v)) for n, v in known.items() if n in robot.parameters and not isinstance(v, Angle)]
        return Range(
            robot,
            joints,
            self.target,
            rows,
            tuple(tuple(float(row[k]) for k in at) for row in found.q),
            tuple(frozenset(name for way in ways for name in way.joints) for ways in found.free),
            exercise,
            sum(lengths) or max((abs(row[3]) for row in rows[:3]), default=1.0),
            chain_of(robot, self.target, exercise),
            numbers(of_robot(robot, known)),
        )
