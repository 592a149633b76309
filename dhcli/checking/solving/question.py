"""What the questions about the joint values that reach a given pose share."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Self, TypeVar

from dhcli.checking.exercise import Exercise, Question
from dhcli.checking.kinds.linked import needed
from dhcli.checking.solving.goal import Target
from dhcli.frozen import frozen
from dhcli.kinematics.robot import Robot
from dhcli.notation.scope import Scope

T = TypeVar("T")


@frozen
class GoalQuestion(Question[T]):
    """A question about the joint values that reach a pose."""

    target: Target

    def in_unit(self, unit: Fraction, scope: Scope) -> Self:
        """With the bare lengths of the pose in metres."""
        return replace(self, target=self.target.in_unit(unit, scope))

    def check(self, robot: Robot | None) -> None:
        """Make sure that the robot has the frames."""
        self.target.ends(robot)

    @property
    def needs_table(self) -> bool:
        """The joints stand in the table."""
        return True

    @property
    def names(self) -> frozenset[str]:
        """Those of the pose."""
        return self.target.names

    def unvalued(self, exercise: Exercise) -> tuple[str, ...]:
        """Those of the pose and of the robot: joint values are numbers, whatever the other parts are."""
        return tuple(sorted((self.target.names | set(needed(exercise.robot).parameters)) - exercise.known.keys()))
