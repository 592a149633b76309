"""Values with their units for people, and in radians and metres for programs."""

from __future__ import annotations

from collections.abc import Iterator

from dhcli.kinematics.robot import Robot, Value
from dhcli.kinematics.values import Values
from dhcli.notation.angle import Angle
from dhcli.notation.tree import Expr, Number
from dhcli.notation.writer import write, write_angle


def value_text(value: Value) -> str:
    """A value with its unit, as a person would write it: `30°`, `0.3 rad`, `0.4 m`."""
    if isinstance(value, Expr):
        return f"{float(value.value):.10g} m" if isinstance(value, Number) else f"{write(value)} m"
    if value.terms or (value.degrees and value.radians):
        return write_angle(value)
    if value.radians:
        return f"{float(value.radians):.10g} rad"
    return f"{float(value.degrees):.10g}°"


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
