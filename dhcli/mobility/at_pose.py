"""The freedoms of a robot's end frame at some joint values, beside those of its joints."""

from __future__ import annotations

from dhcli.frozen import frozen
from dhcli.kinematics.limits import warnings
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.singular.finding import find
from dhcli.kinematics.singular.result import Factor, Singularities
from dhcli.kinematics.singular.standing import Standing, standing_at
from dhcli.kinematics.values import Values
from dhcli.kinematics.velocity.view import MotionView
from dhcli.mobility.result import Mobility

VANISHED = 1e-9
"""Nearer than this a factor is zero [rad and m]."""


@frozen
class MobilityAtPose:
    """A robot's mobility, and what its end frame can do at some joint values.

    Attributes:
        mobility: The freedoms of the joints.
        robot: The robot.
        values: The values used.
        found: Where the robot is singular.
        standing: How it stands.
        warnings: What a person should know all the same.
    """

    mobility: Mobility
    robot: Robot
    values: Values
    found: Singularities
    standing: Standing
    warnings: tuple[str, ...] = ()

    @property
    def lost(self) -> int:
        """Freedoms that the end frame has nearly everywhere, and not here."""
        return max(0, self.found.rank - self.standing.measures.rank)

    @property
    def reasons(self) -> tuple[Factor, ...]:
        """The factors that are zero here."""
        return tuple(self.found.factors[one.factor] for one in self.standing.distances if one.distance < VANISHED)


def at_pose(robot: Robot, values: Values, mobility: Mobility) -> MobilityAtPose:
    """What the end frame of a robot can do at joint values.

    Raises:
        RobotError: A value is missing, or the robot has no joint.
    """
    view = MotionView.of(robot)
    found = find(robot, view, None, {})
    return MobilityAtPose(
        mobility, robot, values, found, standing_at(robot, values, view, found), tuple(warnings(robot, values))
    )
