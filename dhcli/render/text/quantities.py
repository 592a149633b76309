"""Values with their units for people, and in radians and metres for programs."""

from __future__ import annotations

from collections.abc import Iterator

from dhcli.kinematics.robot import Robot, Value
from dhcli.kinematics.values import Values
from dhcli.notation.angle import Angle
from dhcli.notation.quantity import value_text
from dhcli.notation.tree import Number
from dhcli.notation.writer import write, write_angle


def in_units(value: Value) -> float | str:
    """A value for a program: radians and metres; text where it holds names."""
    if isinstance(value, Angle):
        return write_angle(value, "sympy") if value.terms else value.constant()
    return float(value.value) if isinstance(value, Number) else write(value, "sympy")


def value_lines(robot: Robot, values: Values) -> Iterator[str]:
    """The values used, joints first: `theta1 = 30°`."""
    for name in (*robot.variables, *robot.parameters):
        if name in values:
            yield f"{name} = {value_text(values[name])}"
