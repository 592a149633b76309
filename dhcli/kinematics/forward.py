"""Forward kinematics: the pose of one frame seen from another, in numbers or in symbols."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import cache
from typing import TYPE_CHECKING, cast

from dhcli.algebra.floats import Floats
from dhcli.algebra.sizes import SIZES
from dhcli.algebra.terms import TERMS
from dhcli.errors import RobotError
from dhcli.kinematics.conventions import Convention, Row, moves_of
from dhcli.kinematics.fold import fold
from dhcli.kinematics.frames import between, ends
from dhcli.kinematics.merge import merge
from dhcli.kinematics.moves import Chain, Trans, spelled, substituted
from dhcli.kinematics.pose import Pose, computed
from dhcli.kinematics.robot import Link, Robot, Value, check_robot
from dhcli.kinematics.values import (
    JointInput,
    Values,
    given_parameters,
    joint_values,
    numbers,
    parameter_values,
    require,
)
from dhcli.notation.tree import ZERO, Expr
from dhcli.notation.walk import parted, symbols

if TYPE_CHECKING:
    from dhcli.kinematics.recorded import Recording

LONGEST = 20_000
"""Symbols of the longest result that is written; Panda has about 2000."""

_PLAIN = {float, int}

Given = Mapping[str, float | str | Value]


def forward(
    robot: Robot,
    q: JointInput = None,
    *,
    start: str | int | None = None,
    end: str | int | None = None,
    parameters: Given | None = None,
) -> Pose[float]:
    """Pose of a frame of a robot, in numbers.

    Args:
        robot: The robot.
        q: Joint values in radians and metres: a list in joint order, a mapping by name, the name of a pose, or text
            with units such as `"30°, 0.5, 120mm"`.
        start: The frame it is seen from; the first numbered one by default.
        end: The frame described; the last numbered one by default.
        parameters: Lengths and angles to use instead of the robot's own.

    Returns:
        The pose, shape (4, 4), translation in metres.

    Raises:
        RobotError: A value is missing, or not a number.
        UnknownNameError: The robot has no such frame, joint or length.
    """
    check_robot(robot)
    if (floats := plain_floats(q, parameters)) is not None:
        frames = ends(robot, start, end)
        rows = _played(robot, floats, *frames)
        if rows is not None:
            return computed(rows, *frames, robot.writing)
    values = {**parameter_values(robot, parameters), **joint_values(robot, q)}
    return numeric_pose(robot, values, *ends(robot, start, end))


def symbolic(
    robot: Robot,
    q: JointInput = None,
    *,
    start: str | int | None = None,
    end: str | int | None = None,
    parameters: Given | None = None,
) -> Pose[Expr]:
    """Pose of a frame of a robot in textbook form, `c1*(a2*c2 + a3*c23 - d4*s23) - d3*s1`.

    Args:
        robot: The robot.
        q: Joint values to put in exactly; all others stay symbols.
        start: The frame it is seen from; the first numbered one by default.
        end: The frame described; the last numbered one by default.
        parameters: Lengths and angles to put in exactly; all others stay symbols.

    Returns:
        The pose, shape (4, 4), of expressions.

    Raises:
        UnknownNameError: The robot has no such frame, joint or length.
    """
    check_robot(robot)
    values = {**given_parameters(robot, parameters), **joint_values(robot, q)}
    return symbolic_pose(robot, values, *ends(robot, start, end))


def numeric_pose(robot: Robot, values: Values, start: str, end: str) -> Pose[float]:
    """The pose of one frame seen from another at known values; see `forward`."""
    chain = between(robot, start, end)
    require(robot, chain, values)
    return Pose(pose_rows(chain, values), start, end, joints=robot.writing)


def plain_floats(q: JointInput, parameters: Given | None) -> Sequence[float] | None:
    """Joint values that are plain numbers in joint order, as most programs give them.

    None for anything else, and where lengths are given besides.
    """
    has_lengths = parameters is not None and (not isinstance(parameters, Mapping) or len(parameters) > 0)  # type: ignore[redundant-expr]  # of a caller without types
    if has_lengths:
        return None
    if type(q) is not list and type(q) is not tuple:
        if getattr(q, "ndim", 0) != 1:
            return None
        q = q.tolist()  # type: ignore[union-attr]  # an array
    kinds = set(map(type, q))
    if kinds <= _PLAIN:
        return cast("Sequence[float]", q)
    return list(map(float, cast("Sequence[float]", q))) if all(issubclass(kind, float) for kind in kinds) else None


def _played(robot: Robot, q: Sequence[float], start: str, end: str) -> tuple[tuple[float, ...], ...] | None:
    """The pose by its recording, shape (4, 4); see `Recording.again`."""
    try:
        found = _recorder()(robot, start, end).again(q)
    except RobotError:
        return None
    return None if found is None else (found[:4], found[4:8], found[8:12], found[12:])


@cache
def _recorder() -> Callable[[Robot, str, str], Recording]:
    """What records a pose; a command has a robot once, and records nothing."""
    from dhcli.kinematics.recorded import recorded_pose

    return recorded_pose


def symbolic_pose(robot: Robot, values: Values, start: str, end: str) -> Pose[Expr]:
    """The pose of one frame seen from another with some values put in; see `symbolic`."""
    return Pose(textbook_form(put_in(between(robot, start, end), values)), start, end, joints=robot.writing)


def textbook_form(chain: Chain) -> tuple[tuple[Expr, ...], ...]:
    """The product of a chain in terms, shape (4, 4): parallel rotations merged, no bracket expanded.

    Raises:
        RobotError: It would be longer than anybody can read, or an exact number in it.
    """
    try:
        merged = merge(chain)
        refuse_long(sum(entry.count for row in fold(merged, SIZES) for entry in row))
        return fold(merged, TERMS)
    except OverflowError:
        raise RobotError("an exact number has too many digits", "compute in numbers, or put in simpler ones") from None


def refuse_long(size: int) -> None:
    """Refuse a result of more symbols than anybody can read.

    Raises:
        RobotError: It would have more.
    """
    if size > LONGEST:
        message = f"the result would be {size} symbols long, more than the {LONGEST} that are written"
        raise RobotError(message, "ask for fewer frames with --from and --to, or put values in")


def pose_rows(chain: Chain, values: Values) -> tuple[tuple[float, ...], ...]:
    """The product of a chain in floats, shape (4, 4).

    Raises:
        RobotError: An entry is not a real number, or beyond what a float can hold.
    """
    try:
        rows = fold(chain, Floats(numbers(values)))
    except OverflowError:
        raise RobotError("a value is too large to compute with") from None
    if not all(math.isfinite(entry) for row in rows for entry in row):
        raise RobotError("the pose has an entry that is not a real number")
    return rows


def put_in(chain: Chain, values: Values) -> Chain:
    """A chain with exact values in the place of names."""
    try:
        return substituted(chain, *parted(values))
    except (OverflowError, ZeroDivisionError):
        raise RobotError("with these values a length is divided by zero or becomes too large") from None


def link_with(link: Link, values: Values, convention: Convention) -> Link:
    """A link with exact values in the place of names."""
    moves = put_in(link.moves, values)
    if link.row is None:
        return Link(link.number, moves)
    lengths = put_in((Trans(link.row.a, link.row.d, ZERO),), values)[0]
    assert isinstance(lengths, Trans)  # noqa: S101  it keeps its kind
    row = Row(lengths.x, link.row.alpha.substitute(values), lengths.y, link.row.theta.substitute(values))
    return Link(link.number, moves_of(row, convention), row)


def factors(robot: Robot, link: Link, values: Values) -> tuple[Pose[Expr], ...]:
    """The elementary matrices of a link, in the order of its convention.

    Raises:
        RobotError: The robot is given as products, whose factors stand in the file.
    """
    if robot.convention is Convention.PRODUCT and not link.moves:
        raise RobotError(f"link {link.number} of {robot.name} has no moves")
    before = str(link.number - 1)
    return tuple(
        Pose(fold((move,), TERMS), before, str(link.number), spelled(move, robot.writing), robot.writing)
        for move in put_in(link.moves, values)
    )


def with_values(robot: Robot, values: Mapping[str, Value]) -> Robot:
    """The robot with exact values in the place of lengths and constant angles; they are no parameters of it."""
    base, tool = put_in(robot.base, values), put_in(robot.tool, values)
    links = tuple(link_with(link, values, robot.convention) for link in robot.links)
    tools = {name: put_in(chain, values) for name, chain in robot.tools.items()}
    left = {name: value for name, value in robot.parameters.items() if name not in values}
    derived = {name: how for name, how in robot.derived.items() if symbols(how.expr) | {name} <= left.keys()}
    return replace(robot, links=links, base=base, tool=tool, tools=tools, parameters=left, derived=derived)


def with_own_values(robot: Robot) -> Robot:
    """The robot with the values of its lengths in their place.

    Raises:
        RobotError: A length has no value.
    """
    if lacking := [name for name, value in robot.parameters.items() if value is None]:
        raise RobotError(
            f"{', '.join(lacking)} {'has' if len(lacking) == 1 else 'have'} no value",
            "numbers need one: --set NAME=VALUE",
        )
    return with_values(robot, robot.known)
