"""A robot as the method sees it: joint axes in the zero pose, and the zero pose itself."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from dhcli.algebra.floats import Floats
from dhcli.errors import RobotError
from dhcli.frozen import frozen
from dhcli.kinematics.fold import fold
from dhcli.kinematics.moves import Chain, Fixed, Rot, Trans, names
from dhcli.notation.angle import Angle
from dhcli.notation.factors import AXES

if TYPE_CHECKING:
    from numpy.typing import NDArray

Array: TypeAlias = "NDArray[np.float64]"
Ints: TypeAlias = "NDArray[np.int64]"
Flags: TypeAlias = "NDArray[np.bool_]"

_COMMUTE = 1e-12


@frozen
class Axis:
    """A joint in the zero pose, lengths in units of the arm's reach.

    Attributes:
        name: The joint variable; empty for a motion that the task leaves free.
        turns: Whether it turns; otherwise it slides.
        direction: Unit vector of the axis.
        point: A point on it; the origin for a slide.
        factor: Motion for each unit of the variable, such as -1 where a table has `-d3`.
    """

    name: str
    turns: bool
    direction: tuple[float, float, float]
    point: tuple[float, float, float] = (0.0, 0.0, 0.0)
    factor: float = 1.0


@frozen
class Arm:
    """Joint axes, and where the end is in the zero pose.

    Attributes:
        axes: The joints in order, then the motions that the task leaves free.
        joints: How many of them are joints.
        before: Pose of the frame in which the axes are given, seen from the start frame, shape (4, 4) [m].
        home: Pose of the end in the zero pose, in that frame, shape (4, 4), lengths in units of the reach.
        reach: The unit of length [m].
    """

    axes: tuple[Axis, ...]
    joints: int
    before: Array
    home: Array
    reach: float

    @cached_property
    def factors(self) -> Array:
        """Motion for each unit of each joint variable, metres in units of the reach, shape (n,)."""
        own = self.axes[: self.joints]
        return np.array([axis.factor if axis.turns else axis.factor / self.reach for axis in own])

    @cached_property
    def lines(self) -> tuple[Array, Array]:
        """Directions of all axes, and a point on each, shape (n, 1, 3, 1)."""
        parts = ([axis.direction for axis in self.axes], [axis.point for axis in self.axes])
        along, point = (np.array(part, dtype=float).reshape(-1, 1, 3, 1) for part in parts)
        return along, point

    @cached_property
    def turns(self) -> tuple[Array, Array, Array]:
        """What a turn about each axis leaves, what it has of its cosine and what of its sine, each (n, 1, 3, 3).

        Source: Rodrigues' formula.
        """
        along = self.lines[0] * self.lines[0].transpose(0, 1, 3, 2)
        around = [[[0, -z, y], [z, 0, -x], [-y, x, 0]] for x, y, z in (axis.direction for axis in self.axes)]
        return along, np.eye(3) - along, np.array(around, dtype=float).reshape(-1, 1, 3, 3)

    @cached_property
    def slides(self) -> tuple[int, ...]:
        """Which axes slide."""
        return tuple(k for k, axis in enumerate(self.axes) if not axis.turns)

    @cached_property
    def turning(self) -> NDArray[np.bool_]:
        """Which joints turn, shape (n,)."""
        return np.array([axis.turns for axis in self.axes[: self.joints]], dtype=bool)

    def goal(self, poses: Array) -> Array:
        """What the product of the joint motions has to be, for poses (N, 4, 4) of the end in the start frame [m]."""
        inner = inverse_pose(self.before) @ poses
        inner[:, :3, 3] /= self.reach
        return np.asarray(inner @ inverse_pose(self.home))


def inverse_pose(pose: Array) -> Array:
    """The inverse of a rigid motion, shape (4, 4)."""
    turn = pose[:3, :3].T
    back = np.eye(4)
    back[:3, :3] = turn
    back[:3, 3] = -turn @ pose[:3, 3]
    return back


def arm_of(chain: Chain, variables: tuple[str, ...], values: Mapping[str, Angle | float]) -> Arm:
    """The joint axes of a chain of moves.

    Raises:
        RobotError: A joint does not move about or along one axis, or the zero pose is not a pose.
    """
    still = {**values, **dict.fromkeys(variables, 0.0)}
    moving = {name: tuple(k for k, move in enumerate(chain) if name in names((move,))) for name in variables}
    order = sorted((name for name, at in moving.items() if at), key=lambda name: moving[name])
    first = min((at[0] for at in moving.values() if at), default=len(chain))
    before = np.array(fold(chain[:first], Floats(still)), dtype=float)
    found = [_axis(chain, name, moving[name], still, first) for name in order]
    home = np.array(fold(chain[first:], Floats(still)), dtype=float)
    if not np.isfinite(home).all() or not np.isfinite(before).all():
        raise RobotError("the zero pose of the robot has an entry that is not a real number")
    points = [np.array(axis.point) for axis in found] + [home[:3, 3]]
    reach = float(max((np.linalg.norm(p - q) for p in points for q in points), default=0.0)) or 1.0
    home[:3, 3] /= reach
    return Arm(tuple(_scaled(axis, reach) for axis in found), len(found), before, home, reach)


def _scaled(axis: Axis, reach: float) -> Axis:
    x, y, z = axis.point
    return Axis(axis.name, axis.turns, axis.direction, (x / reach, y / reach, z / reach), axis.factor)


def _axis(chain: Chain, name: str, at: tuple[int, ...], still: Mapping[str, Angle | float], first: int) -> Axis:
    """The axis of one joint; several moves by the same variable must be about the same axis."""
    found = [axis_of_move(chain, name, k, still, first) for k in at]
    head = found[0]
    if not all(same_axis(head, other) for other in found[1:]):
        raise RobotError(f"{name} moves about more than one axis", "inverse kinematics takes joints with one axis each")
    factor = sum(axis.factor * float(np.dot(axis.direction, head.direction)) for axis in found)
    if not factor:
        raise RobotError(f"{name} does not move the robot", "its moves undo each other")
    return Axis(name, head.turns, head.direction, head.point, factor)


def nearest_turn(turning: NDArray[np.bool_], motions: Array) -> Array:
    """Motions of which the angles, shape (..., n), are in the turn nearest to 0."""
    return np.where(turning, motions - 2 * np.pi * np.round(motions / (2 * np.pi)), motions)


def parallel(one: Axis, other: Axis) -> bool:
    """Whether the axes of two joints have one direction, or opposite ones."""
    return bool(np.abs(np.cross(one.direction, other.direction)).max() <= _COMMUTE)


def same_axis(one: Axis, other: Axis) -> bool:
    """Whether two joints turn about one line, or slide along one direction."""
    if one.turns != other.turns or not parallel(one, other):
        return False
    apart = np.cross(np.subtract(one.point, other.point), one.direction)
    return bool(np.abs(apart).max() <= _COMMUTE)


def axis_of_move(chain: Chain, name: str, k: int, still: Mapping[str, Angle | float], first: int) -> Axis:
    """The axis of one move by a variable, in the frame of the first move that moves."""
    frame = np.array(fold(chain[first:k], Floats(still)), dtype=float)
    match chain[k]:
        case Rot(letter, angle):
            column = frame[:3, AXES.index(letter)]
            factor = float(dict(angle.terms)[name])
            return Axis(name, True, _triple(column), _triple(frame[:3, 3]), factor)  # noqa: FBT003
        case Trans() as move:
            ends = [[float(Floats({**still, name: at}).length(part)) for part in move.offset] for at in (0.0, 1.0)]
            along = np.subtract(ends[1], ends[0])
            factor = float(np.linalg.norm(along))
            lead = along[np.argmax(np.abs(along))] if factor else 1.0
            factor = -factor if lead < 0 else factor
            return Axis(name, False, _triple(frame[:3, :3] @ (along / (factor or 1.0))), factor=factor)  # noqa: FBT003
        case Fixed():
            raise RobotError(f"{name} stands in a matrix", "write the joint as Rot(axis, variable) or Trans(...)")


def _triple(vector: Array) -> tuple[float, float, float]:
    x, y, z = (float(part) + 0.0 for part in vector)
    return x, y, z
