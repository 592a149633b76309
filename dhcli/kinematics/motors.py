"""A robot by its motor values: the same arm, each joint in the rows replaced by what drives it."""

from __future__ import annotations

from dataclasses import replace

from dhcli.errors import RobotError
from dhcli.kinematics.actuators import Actuators
from dhcli.kinematics.forward import link_with
from dhcli.kinematics.robot import Robot, Value


def in_motors(robot: Robot) -> Robot:
    """The robot whose variables are the motors; all that holds for joints then holds for them.

    A Jacobian has a column for each motor, so torques are those of the motors, by the transpose.

    Raises:
        RobotError: Its motors are not known.
    """
    driven = robot.actuators
    if driven is None:
        hint = "its file says so under actuators: motors: {m2: [-60°, 76°]}, theta2: m2"
        raise RobotError(f"of {robot.name} it is not known which motors drive it", hint)
    formulas = driven.formulas
    own = {motor: robot.limits[motor] for motor in driven.motors if motor in robot.limits and motor in driven.joints}
    return replace(
        robot,
        variables=driven.motors,
        links=tuple(link_with(link, formulas, robot.convention) for link in robot.links),
        limits={**own, **driven.limits},
        poses={name: _motors(driven, robot, values) for name, values in robot.poses.items()},
        actuators=None,
        drives=robot,
    )


def _motors(driven: Actuators, robot: Robot, values: tuple[Value, ...]) -> tuple[Value, ...]:
    found = driven.motor_values(dict(zip(robot.variables, values, strict=True)))
    return tuple(found[motor] for motor in driven.motors)
