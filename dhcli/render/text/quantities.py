"""Values with their units for people, and in radians and metres for programs."""

from __future__ import annotations

import math
from collections.abc import Iterator

from dhcli.kinematics.entries import DIGITS, rounded
from dhcli.kinematics.robot import Robot, Value
from dhcli.kinematics.values import Values, symbols_of
from dhcli.notation.angle import Angle
from dhcli.notation.quantity import value_text
from dhcli.notation.tree import Number
from dhcli.notation.writer import write, write_angle


def in_units(value: Value) -> float | str:
    """A value for a program: radians and metres; text where it holds names."""
    if isinstance(value, Angle):
        return write_angle(value, "sympy") if value.terms else value.constant()
    return float(value.value) if isinstance(value, Number) else write(value, "sympy")


def in_degrees(value: Value) -> str:
    """A value for people who compare it with others: an angle in degrees, however it was written, and rounded."""
    if isinstance(value, Angle) and value.radians and not value.terms:
        return f"{rounded(math.degrees(value.constant()), DIGITS)}°"
    return value_text(value)


def value_lines(robot: Robot, values: Values) -> Iterator[str]:
    """The values used, joints first: `theta1 = 30°`; behind those of motors the joints that they make."""
    driven = _driven(robot, values)
    for name in (*robot.variables, *driven, *robot.parameters):
        if (value := values.get(name, driven.get(name))) is not None:
            yield f"{name} = {value_text(value)}"


def _driven(robot: Robot, values: Values) -> Values:
    """Values of the joints that motors make together, where each motor has a number."""
    motors = robot.drives.actuators if robot.drives is not None else None
    if motors is None or any(name not in values or symbols_of(values[name]) for name in robot.variables):
        return {}
    return {joint: value for joint, value in motors.joint_values(values).items() if joint not in motors.motors}
