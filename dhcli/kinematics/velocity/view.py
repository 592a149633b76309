"""Whose velocity is asked for, of which point, in whose axes; and the chains from which its columns follow."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence, Sized
from typing import TypedDict, Unpack

from dhcli.algebra.sizes import SIZES
from dhcli.errors import Place, Problem, RobotError, plural
from dhcli.frozen import frozen
from dhcli.kinematics.forward import put_in, refuse_long
from dhcli.kinematics.frames import ORIGIN, Point, between, ends, frame
from dhcli.kinematics.given import three_coordinates
from dhcli.kinematics.merge import merge
from dhcli.kinematics.moves import Chain, Trans, inverse_of, names, substituted
from dhcli.kinematics.robot import Robot, Value
from dhcli.kinematics.values import Values
from dhcli.kinematics.velocity.steps import Step, fold_columns, steps_of
from dhcli.notation.angle import Angle
from dhcli.notation.tree import ZERO, Expr, Symbol

VIRTUAL = "ε"
"""A small turn or slide besides that of a joint, where the joint itself occurs on the way back as well."""


class Viewing(TypedDict, total=False):
    """What a caller may say of a view; all of it has a default.

    Attributes:
        start: The frame that is held still; the first numbered one by default.
        end: The frame that moves; the last numbered one by default. Joints between the two have a column each.
        axes: The frame along whose axes vectors are written; `start` by default.
        place: The frame at whose origin the velocity is taken, or a force acts, as if that origin were fixed to `end`;
            `end` by default.
        point: A point of `place` that is taken instead of its origin, shape (3,) [m]; text may hold names.
    """

    start: str | int | None
    end: str | int | None
    axes: str | int | None
    place: str | int | None
    point: Iterable[float | str] | None


@frozen
class MotionView:
    """What a Jacobian is of.

    Attributes:
        start: The frame that is held still.
        end: The frame that moves; the joints between the two have a column each.
        axes: The frame along whose axes the rows are written.
        place: The frame at whose origin the moving body's velocity is taken, as if that origin were fixed to it.
        point: A point of `place` that is taken instead of the origin [m].
    """

    start: str
    end: str
    axes: str
    place: str
    point: Point = ORIGIN

    @classmethod
    def of(cls, robot: Robot, **viewing: Unpack[Viewing]) -> MotionView:
        """A view by the names that a person gives.

        Raises:
            RobotError: The point is none.
            UnknownNameError: The robot has no such frame.
        """
        first, last = ends(robot, viewing.get("start"), viewing.get("end"))
        axes, place = viewing.get("axes"), viewing.get("place")
        return cls(
            first,
            last,
            first if axes is None else frame(robot, axes),
            last if place is None else frame(robot, place),
            offset_of(viewing.get("point")),
        )


def check_rates(rates: Sized, joints: Sequence[str], place: Place | None = None) -> None:
    """Make sure that there is a rate for each joint.

    Raises:
        RobotError: There are too many or too few.
    """
    if len(rates) != len(joints):
        message = f"{plural(len(rates), 'rate')} for {plural(len(joints), 'joint')}"
        raise RobotError(Problem(message, place, f"one for each of {', '.join(joints)}"))


def offset_of(point: Iterable[float | str] | None) -> Point:
    """A point that a person gives, in numbers [m] or names; the origin if they give none.

    Raises:
        RobotError: It has not three coordinates, or one is no number.
        NotationError: A text cannot be read.
    """
    return ORIGIN if point is None else three_coordinates(point)


def joints_between(robot: Robot, start: str, end: str) -> tuple[str, ...]:
    """The joints that move one frame against another, in joint order."""
    first, last = sorted((robot.frames.index(start), robot.frames.index(end)))
    inside = frozenset(robot.frames[first + 1 : last + 1])
    moving = frozenset[str]().union(*(found for link, found in robot.movers.items() if str(link) in inside))
    return tuple(name for name in robot.variables if name in moving)


@frozen
class Part:
    """A chain from which some columns of a Jacobian follow in one fold.

    Attributes:
        joints: The joints whose columns they are, by their places among all columns.
        steps: The moves, with how those joints change them.
        chain: The moves, without that.
    """

    joints: tuple[int, ...]
    steps: tuple[Step, ...]
    chain: Chain


def parts(
    robot: Robot, view: MotionView, joints: tuple[str, ...], *, merged: bool, values: Values | None = None
) -> Iterator[Part]:
    """The chains from the axes to the point, in which each joint occurs once as the one that moves.

    Joints that stand on no way back share one chain, and one fold gives the columns of all of them. A joint that does,
    or has a value, is turned by a virtual angle besides, in the place where it moves the end, and what stands on both
    sides of it and cancels is left out: merged, this gives the shortest form in any frame.

    Args:
        robot: The robot.
        view: What is asked.
        joints: Names of the joints in question.
        merged: Whether parallel joints are merged, as a textbook does.
        values: Exact values to put in.

    Raises:
        RobotError: A value cannot be put in.
    """
    behind = between(robot, view.end, view.place)
    if view.point != ORIGIN:
        behind = (*behind, Trans(*view.point))
    way = Way(between(robot, view.axes, view.start), between(robot, view.start, view.end), behind)
    return way.parts(joints, robot.angles, merged=merged, values=values)


@frozen
class Way:
    """A path in three pieces, of which joints move the middle one.

    Attributes:
        ahead: From the axes that the rows are written along to where the motion starts.
        moving: From there to the body that moves.
        behind: From that body to the point whose velocity it is.
    """

    ahead: Chain
    moving: Chain
    behind: Chain = ()

    def parts(
        self, joints: Sequence[str], angles: Collection[str], *, merged: bool, values: Values | None = None
    ) -> Iterator[Part]:
        """The chains from which the columns of some joints follow; see `parts`.

        Args:
            joints: Names of the joints in question.
            angles: Names that stand for angles.
            merged: Whether parallel joints are merged.
            values: Exact values to put in.
        """
        values = values or {}
        ahead, behind = (put_in(chain, values) if values else chain for chain in (self.ahead, self.behind))
        taken = (names(self.ahead) | names(self.behind)) | values.keys() if ahead or behind or values else frozenset()
        alone = {name: k for k, name in enumerate(name for name in joints if name not in taken)}
        if alone:
            path = _without_detours(ahead, put_in(self.moving, values) if values else self.moving, behind, alone)
            whole = merge(path) if merged else path
            yield Part(tuple(k for k, name in enumerate(joints) if name in alone), steps_of(whole, alone), whole)
        for k, name in enumerate(joints):
            if name in taken:
                turned = put_in(self.moving, {**values, name: _besides(name, values.get(name), name in angles)})
                path = _without_detours(ahead, turned, behind, (VIRTUAL,))
                whole = merge(path) if merged else path
                steps = tuple(map(_settled, steps_of(whole, {VIRTUAL: 0})))
                yield Part((k,), steps, tuple(step.move for step in steps))


def _besides(name: str, value: Value | None, turns: bool) -> Value:  # noqa: FBT001  turns or slides
    """The value of a joint, or its name, and a virtual turn or slide."""
    if turns:
        return (value if isinstance(value, Angle) else Angle.of(name)) + Angle.of(VIRTUAL)
    return (value if isinstance(value, Expr) else Symbol(name)) + Symbol(VIRTUAL)


def _settled(step: Step) -> Step:
    """A step with the virtual turn gone, once it is known what it changes."""
    nothing = {VIRTUAL: ZERO}, {VIRTUAL: Angle()}
    (move,) = substituted((step.move,), *nothing)
    if not step.sliding:
        return Step(move, step.turning)
    still = [(column, substituted((Trans(*offset),), *nothing)[0]) for column, offset in step.sliding]
    return Step(move, step.turning, tuple((column, trans.offset) for column, trans in still))  # type: ignore[union-attr]


def _without_detours(ahead: Chain, moving: Chain, behind: Chain, joints: Iterable[str]) -> Chain:
    """A path without moves that are undone at once; those that hold a joint which moves are not."""
    if not ahead and not behind:
        return moving
    kept = frozenset(joints)
    path = list(ahead)
    for move in moving:
        if path and type(path[-1]) is type(move) and not kept & names((move,)) and path[-1] == inverse_of(move):
            path.pop()
        else:
            path.append(move)
    for move in behind:
        if path and type(path[-1]) is type(move) and not kept & names((path[-1],)) and path[-1] == inverse_of(move):
            path.pop()
        else:
            path.append(move)
    return tuple(path)


def check_size(made: Iterable[Part]) -> None:
    """Make sure that columns in terms would not be longer than anybody can read.

    Raises:
        RobotError: They would be.
    """
    size = 0
    for part in made:
        columns = fold_columns(part.steps, len(part.joints), SIZES)
        vectors = (*columns.linear, *columns.angular)
        size += sum(1 if isinstance(entry, int) else entry.count for vector in vectors for entry in vector)
    refuse_long(size)
