"""What is followed through a grid, and which joints move it."""

from __future__ import annotations

from collections.abc import Mapping

from dhcli.algebra.floats import Floats
from dhcli.errors import RobotError
from dhcli.frozen import FrozenDict, frozen
from dhcli.kinematics.forward import pose_rows, put_in, textbook_form
from dhcli.kinematics.frames import View
from dhcli.kinematics.moves import Chain
from dhcli.kinematics.recorded import kept
from dhcli.kinematics.robot import Robot, Value
from dhcli.kinematics.values import Values, numbers, parameter_values, require
from dhcli.notation.angle import Angle
from dhcli.notation.walk import symbols_in


@frozen
class Target:
    """A point of a robot, seen from one of its frames.

    Attributes:
        robot: The robot.
        view: The frame it is fixed in, the frame it is seen from, and the point.
        lengths: Values of the robot's lengths and constant angles.
    """

    robot: Robot
    view: View
    lengths: Mapping[str, Value]

    @property
    def chain(self) -> Chain:
        """The moves that lead to it."""
        return self.view.chain_to_point(self.robot)

    @property
    def coordinates(self) -> tuple[float, ...]:
        """The point in numbers [m]."""
        floats = Floats(numbers(self.lengths))
        return tuple(float(floats.length(coordinate)) for coordinate in self.view.coordinates)

    def at(self, q: Values) -> tuple[float, float, float]:
        """Where it is [m] for joint values, by the fold of a single pose: exact angles have exact cosines."""
        rows = pose_rows(self.chain, {**self.lengths, **q})
        x, y, z = (float(row[3]) + 0.0 for row in rows[:3])  # no minus zero
        return x, y, z

    def movers(self) -> frozenset[str]:
        """The joints that it moves with."""
        return kept(self.robot, ("movers", self.view, tuple(self.lengths.items())), self._movers)

    def _movers(self) -> frozenset[str]:
        joints = frozenset(self.robot.variables)
        try:
            rows = textbook_form(put_in(self.chain, self.lengths))
        except RobotError:  # too long to be written, so it is not known that any joint is idle
            return joints
        return joints & symbols_in(row[3] for row in rows[:3])


def target_of(robot: Robot, view: View | None = None, values: Values | None = None) -> Target:
    """The point that is asked about.

    Args:
        robot: The robot.
        view: The frame it is fixed in, the frame it is seen from, and the point; by default the origin of the last
            numbered frame, seen from the first.
        values: Values of the robot's lengths and constant angles, its own by default; those of joints are left to the
            grid.

    Raises:
        RobotError: A length has no value, or the point holds a name without one.
    """
    known = parameter_values(robot, {}) if values is None else values
    lengths = FrozenDict((name, value) for name, value in known.items() if name not in robot.variables)
    target = Target(robot, view or View.of(robot), lengths)
    if free := sorted(symbols_in(target.view.coordinates) - lengths.keys()):
        raise RobotError(f"{', '.join(free)} of the point has no value", "write numbers: --point 0,0,0.1")
    require(robot, target.chain, {**lengths, **dict.fromkeys(robot.variables, Angle())})
    return target
