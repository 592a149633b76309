"""Limits on both sides of a drive: motors keep theirs, and so do the joints that they move together."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from dhcli.frozen import frozen
from dhcli.kinematics.derived import in_floats
from dhcli.kinematics.description import Description


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
