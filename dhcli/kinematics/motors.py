"""A robot by its motor values: the same arm, each joint in the rows replaced by what drives it."""

from __future__ import annotations

from dataclasses import replace

from dhcli.errors import RobotError
from dhcli.kinematics.actuators import Actuators
from dhcli.kinematics.robot import Robot, Value, check_robot


def in_motors(robot: Robot) -> Robot:
    """The robot whose variables are the motors; all that holds for joints then holds for them.

    A Jacobian has a column for each motor, so torques are those of the motors, by the transpose.

    Raises:
        RobotError: Its motors are not known.
    """
    from dhcli.kinematics.forward import link_with  # few robots are asked by their motors

    motors = driven(robot).actuators
    assert motors is not None  # noqa: S101  that is what has just been looked for
    formulas = motors.formulas
    own = {motor: robot.limits[motor] for motor in motors.motors if motor in robot.limits and motor in motors.joints}
    return replace(
        robot,
        variables=motors.motors,
        links=tuple(link_with(link, formulas, robot.convention) for link in robot.links),
        limits={**own, **motors.limits},
        poses={name: _motors(motors, robot, values) for name, values in robot.poses.items()},
        actuators=None,
        drives=robot,
        called={},
    )


def driven(robot: Robot) -> Robot:
    """The robot, if it is known which motors drive it.

    Raises:
        RobotError: It is not, or is no robot.
    """
    check_robot(robot)
    if robot.actuators is None:
        hint = "its file says so under actuators: motors: {m2: [-60°, 76°]}, theta2: m2"
        raise RobotError(f"of {robot.name} it is not known which motors drive it", hint)
    return robot


def _motors(driven: Actuators, robot: Robot, values: tuple[Value, ...]) -> tuple[Value, ...]:
    found = driven.motor_values(dict(zip(robot.variables, values, strict=True)))
    return tuple(found[motor] for motor in driven.motors)
