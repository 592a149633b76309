"""Whether joints can stand at their values, and what a person should know of those all the same."""

from __future__ import annotations

import math
from collections.abc import Iterator

from dhcli.kinematics.derived import in_floats
from dhcli.kinematics.description import Description
from dhcli.kinematics.farlimits import far_limits
from dhcli.kinematics.values import Values, symbols_of
from dhcli.notation.angle import Angle

SLACK = 1e-9
"""By how much a value may be beyond a limit and still be at it [rad or m]: limits in degrees are no floats."""


def warnings(robot: Description, values: Values) -> Iterator[str]:
    """What a person should know of a robot and of joint values that can be computed all the same."""
    yield from robot.remarks
    for joint in robot.joints:
        value = values.get(joint.name)
        if value is None:
            continue
        if joint.kind == "revolute" and isinstance(value, Angle) and abs(float(value.radians)) > math.tau:
            typed = float(value.radians)
            yield f"{joint.name} = {typed:g} rad is more than a turn; did you mean {typed:g}°, or --deg?"
        if joint.name in robot.limits and not symbols_of(value):
            low, high = (in_floats(limit) for limit in robot.limits[joint.name])
            number = in_floats(value)
            if not is_within_limits(robot, joint.name, number):
                shown, lowest, highest = _apart(number, low, high, joint.kind)
                yield f"{joint.name} = {shown} is outside its limits, {lowest} to {highest}"
    yield from _far(robot, values)


def _far(robot: Description, values: Values) -> Iterator[str]:
    """What is outside its limits on the other side of the drives: motors at joint values, joints at motor values."""
    far = far_limits(robot)
    given = [values.get(name) for name in robot.variables]
    q = [in_floats(value) for value in given if value is not None and not symbols_of(value)]
    if far is None or len(q) < len(given):
        return
    bounds = dict(zip(far.names, far.bounds, strict=True))
    for name, at, _ in far.beyond(q, SLACK):
        kind = "revolute" if name in far.turning else "prismatic"
        shown, low, high = _apart(at, *bounds[name], kind)
        yield f"{name} is then {shown}, outside its limits, {low} to {high}"


def is_within_limits(robot: Description, name: str, number: float) -> bool:
    """Whether a joint can stand at a value [rad or m]; where it has no limits, at any."""
    if name not in robot.limits:
        return True
    low, high = map(in_floats, robot.limits[name])
    return low - SLACK <= number <= high + SLACK


def _apart(number: float, low: float, high: float, kind: str) -> tuple[str, str, str]:
    """A value and the limits that it is outside of, with so many digits that it is to be seen that it is."""
    factor, unit = (math.degrees(1), "°") if kind == "revolute" else (1.0, " m")
    for digits in range(4, 18):
        shown, lowest, highest = (f"{each * factor:.{digits}g}{unit}" for each in (number, low, high))
        if shown not in {lowest, highest}:
            break
    return shown, lowest, highest
