"""Whether joints can stand at their values, and what a person should know of those all the same."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from dhcli.frozen import frozen
from dhcli.kinematics.derived import in_floats
from dhcli.kinematics.description import Description
from dhcli.kinematics.values import Values, symbols_of
from dhcli.notation.angle import Angle
from dhcli.notation.quarters import Slight

SLACK = 1e-9
"""By how much a value may be beyond a limit and still be at it [rad or m]: limits in degrees are no floats."""


def warnings(robot: Description, values: Values) -> Iterator[str]:
    """What a person should know of a robot and of joint values that can be computed all the same."""
    yield from (remark for remark in robot.remarks if not isinstance(remark, Slight))
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


@frozen
class FarLimits:
    """Limits on the other side of a drive: of the motors for joint values, of the joints for motor values.

    Attributes:
        names: What is limited.
        turning: Which of them turn.
        slopes: How fast each goes with each variable of the robot, in radians and metres.
        offsets: Values where those of the robot are 0.
        bounds: Lowest and highest value of each.
    """

    names: tuple[str, ...]
    turning: frozenset[str]
    slopes: tuple[tuple[float, ...], ...]
    offsets: tuple[float, ...]
    bounds: tuple[tuple[float, float], ...]

    def beyond(self, q: Sequence[float], slack: float) -> Iterator[tuple[str, float, float]]:
        """What is outside at some values, with where it stands and by how much it is above, or below 0."""
        for name, row, offset, (low, high) in zip(self.names, self.slopes, self.offsets, self.bounds, strict=True):
            at = sum((slope * x for slope, x in zip(row, q, strict=True)), offset)
            if at > high + slack:
                yield name, at, at - high
            elif at < low - slack:
                yield name, at, at - low


def far_limits(robot: Description) -> FarLimits | None:
    """The limits that stand on the other side of a robot's drives; None where there are none.

    A box of motor values is a parallelogram of joint values, so that those of one side do not say those of the other.
    """
    arm = robot if robot.actuators is not None else robot.drives
    driven = arm.actuators if arm is not None else None
    if arm is None or driven is None:
        return None
    back = arm is robot
    limits = driven.limits if back else arm.limits
    names_ = driven.motors if back else driven.joints
    kept = [k for k, name in enumerate(names_) if name in limits and name not in robot.variables]
    if not kept:
        return None
    slopes, offsets = driven.slopes(back=back), driven.offsets(back=back)
    bounds = [tuple(map(in_floats, limits[names_[k]])) for k in kept]
    return FarLimits(
        tuple(names_[k] for k in kept),
        driven.turning,
        tuple(slopes[k] for k in kept),
        tuple(offsets[k] for k in kept),
        tuple((low, high) for low, high in bounds),
    )
