"""What a joint is swept over, as people write it: `theta1=-90°..90° step 5°`, `d3=0..0.2 n 11`, `theta2`."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Literal

from dhcli.errors import NotationError, Place, Problem, RobotError
from dhcli.frozen import frozen
from dhcli.kinematics.derived import in_floats
from dhcli.kinematics.ranges import Piece, difference, read_count, split_range, steps_between, times, total, units_in
from dhcli.kinematics.robot import Robot, Value
from dhcli.kinematics.values import joint_called, read_named
from dhcli.notation.angle import Angle
from dhcli.notation.parser import parse
from dhcli.notation.quantity import Bare
from dhcli.notation.scope import Scope
from dhcli.notation.tree import Constant, Number
from dhcli.notation.walk import walk
from dhcli.regex import regex

MOST_VALUES = 1_000_000
"""Values of one joint; they are the only numbers of a grid that are held."""

HAIR = Fraction(1, 1_000_000)
"""Part of a step by which the last one may miss the end of a range, and still be meant to meet it."""

_OF_LIMITS = regex(r"(?P<name>\S+)\s+n\s+(?P<count>\S+)")
"""A joint over its own limits in so many values."""


@frozen
class Over:
    """What is said of one joint.

    Attributes:
        name: The joint variable.
        first: Where it begins; None for the joint's own limits.
        last: Where it ends; None likewise.
        count: How many values it takes; None leaves that open.
    """

    name: str
    first: Value | None = None
    last: Value | None = None
    count: int | None = None


def read_over(robot: Robot, text: str, *, bare: Literal["rad", "deg"] = "rad", place: Place | None = None) -> Over:
    """Read what one joint is swept over.

    Args:
        robot: The robot.
        text: `NAME=FROM..TO step S`, `NAME=FROM..TO n COUNT`, `NAME=FROM..TO`, `NAME=VALUE`, `NAME n COUNT` or `NAME`.
        bare: What a number without a unit means for a revolute joint; prismatic ones are metres.
        place: Where the text comes from, for errors.

    Raises:
        RobotError: An unknown joint; or a range without a value, with too many, or whose step leads away from its end.
        NotationError: A value that cannot be read, with its column.
    """
    whole = Place(place.source if place else "range", text=text)
    head, equals, _ = text.partition("=")
    before = len(head) - len(head.lstrip())
    name = Piece(head.strip(), _at(before, whole))
    if not name.text:
        raise NotationError(Problem("a joint is missing here", whole, "write theta1=-90°..90° step 5°"))
    if not equals and ".." in name.text:
        raise NotationError(Problem("there is no = in this range", whole, "write theta1=-90°..90° step 5°"))
    if not equals and (of_limits := _OF_LIMITS.fullmatch(name.text)):
        joint = joint_called(robot, of_limits["name"], name.place)
        return Over(
            joint, count=_count(joint, Piece(of_limits["count"], _at(before + of_limits.start("count"), whole)))
        )
    joint = joint_called(robot, name.text, name.place)
    if not equals:
        return Over(joint)
    written = split_range(text, lambda at: _at(at, whole), len(head) + 1)
    low, high, more = written.low, written.high, written.more
    if high is None:
        value = _value(robot, joint, low, bare)
        return Over(joint, value, value, 1)
    pieces = [low, high, more] if more is not None and written.word == "step" else [low, high]
    values = [_value(robot, joint, piece, bare) for piece in pieces]
    _check_units(pieces)
    if difference(values[0], values[1]) in (Angle(), Number(Fraction(0))):
        hint = f"one value is written {joint}={low.text}"
        raise RobotError(Problem(f"{joint} begins and ends at {low.text}", low.place, hint))
    if more is None:
        return Over(joint, values[0], values[1])
    if len(pieces) == 2:  # noqa: PLR2004  the ends alone
        return Over(joint, values[0], values[1], _count(joint, more))
    return _in_steps(joint, pieces, values)


def counted(count: int) -> str:
    """A number of poses or values as a person reads it."""
    digits = len(str(count))
    return f"{count:,}" if digits <= 18 else f"about 10^{digits - 1}"  # noqa: PLR2004  a quintillion is read


def _at(offset: int, whole: Place) -> Place:
    """The place of one character of a range."""
    return Place(whole.source, None, offset + 1, whole.text)


def _value(robot: Robot, joint: str, piece: Piece, bare: Bare) -> Value:
    example = f"{joint}=-90°..90° step 5°" if joint in robot.angles else f"{joint}=0..0.2 n 11"
    if not piece.text:
        raise NotationError(Problem("a value is missing here", piece.place, f"write {example}"))
    try:
        parse(piece.text, Scope(), piece.place)
    except NotationError as error:  # what is no value may well be a range in another notation
        raise NotationError(
            replace(problem, hint=f"a range looks like {example}") for problem in error.problems
        ) from None
    value = read_named(robot, joint, piece.text, bare=bare, place=piece.place)
    try:
        is_number = math.isfinite(in_floats(value))
    except OverflowError:
        is_number = False
    if not is_number:
        raise RobotError(Problem(f"{piece.text} is not a number that a joint can have", piece.place))
    return value


def _count(joint: str, piece: Piece) -> int:
    count = read_count(piece.text, piece.place, f"{joint}=...")
    return _checked(joint, count, piece.place)


def _in_steps(joint: str, pieces: Sequence[Piece], values: Sequence[Value]) -> Over:
    """The values from the first in steps, as far as they stay in the range; its end is one if a step ends there."""
    first, last, step = values
    low, high, by = (piece.text for piece in pieces)
    where = pieces[2].place
    if not in_floats(step):
        raise RobotError(Problem(f"the step of {joint} is {by}", where, "a step leads from one value to the next"))
    steps = steps_between(first, last, step)
    if steps < 0:
        hint = f"write step {by.removeprefix('-') if by.startswith('-') else f'-{by}'}"
        raise RobotError(Problem(f"a step of {by} leads from {low} away from {high}", where, hint))
    whole = round(steps)
    if abs(steps - whole) <= HAIR:
        return Over(joint, first, last, _checked(joint, whole + 1, where))
    whole = steps.numerator // steps.denominator
    if not whole:
        message = f"a step of {by} is longer than the way from {low} to {high}"
        raise RobotError(Problem(message, where, "make it shorter"))
    return Over(joint, first, total(first, times(step, whole)), _checked(joint, whole + 1, where))


def _checked(joint: str, count: int, where: Place) -> int:
    if count > MOST_VALUES:
        message = f"{joint} takes {counted(count)} values, more than the {MOST_VALUES:,} that one joint may take"
        raise RobotError(Problem(message, where, "make the step longer, or n smaller"))
    return count


def _check_units(pieces: Sequence[Piece]) -> None:
    """Refuse `-90..90°` and `0°..90`: nobody knows what the bare number was meant in. 0 is 0, and π is radians."""
    with_unit = {piece for piece in pieces if units_in(piece.text)}
    if not with_unit:
        return
    for piece in pieces:
        found = tuple(walk(parse(piece.text, Scope())))
        is_clear = found == (Number(Fraction(0)),) or any(isinstance(node, Constant) for node in found)
        if piece not in with_unit and not is_clear:
            message = f"{piece.text} has no unit, and others in this range have"
            raise RobotError(Problem(message, piece.place, "write the unit at every value of the range"))
