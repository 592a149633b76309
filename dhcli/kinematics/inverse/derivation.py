"""What a derivation is: the steps from a pose to the joint values."""

from __future__ import annotations

import math

from dhcli.frozen import frozen
from dhcli.kinematics.inverse.derive_levels import Equation
from dhcli.kinematics.inverse.derive_rules import Step
from dhcli.kinematics.inverse.derive_terms import name_of
from dhcli.kinematics.robot import Robot


@frozen
class Derivation:
    """The steps from a pose to the joint values.

    Attributes:
        robot: The robot.
        start: The frame the pose is seen from.
        end: The frame it describes.
        place_only: Whether the position alone is given.
        steps: The steps in order.
        proved: At how many random poses, with random lengths, the formulas were found to be right: every combination of
            signs that is real reaches the pose, and one of them is where it came from.
        left: Entries of the pose that are to be checked besides, where the joints are too few to reach every pose.
        strangers: Whether some combinations of signs are told from solutions by those entries alone.
    """

    robot: Robot
    start: str
    end: str
    place_only: bool
    steps: tuple[Step, ...]
    proved: int = 0
    left: tuple[Equation, ...] = ()
    strangers: bool = False

    @property
    def joints(self) -> tuple[str, ...]:
        """The joints that are found, in joint order."""
        found = {name_of(step.atom) for step in self.steps}
        return tuple(name for name in self.robot.variables if name in found)

    @property
    def branches(self) -> int:
        """How many combinations of signs there are."""
        return math.prod(2 if step.two else 1 for step in self.steps)
