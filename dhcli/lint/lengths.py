"""Rules for lengths: a number in millimetres that lacks its unit is longer than any arm, wherever it stands."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from dhcli.algebra.floats import Floats
from dhcli.frozen import frozen
from dhcli.kinematics.derived import Value, in_floats
from dhcli.kinematics.description import Description, Link
from dhcli.kinematics.limits import is_within_limits
from dhcli.kinematics.moves import Chain, Fixed, Trans
from dhcli.kinematics.validity import Finding
from dhcli.kinematics.values import symbols_of
from dhcli.notation.names import is_greek
from dhcli.notation.tree import Expr
from dhcli.notation.walk import symbols

if TYPE_CHECKING:
    from dhcli.checking.exercise import Exercise
    from dhcli.mobility.linkage import Linkage

LONGEST = 10.0
"""Metres; an arm with a longer link was measured in millimetres."""

LONGEST_BAR = 100.0
"""Metres; a linkage that is larger was, too."""

_LONG = "is longer than any arm"

SHORTEST = 0.002
"""Metres; an arm whose longest length is shorter was measured in metres, and read in millimetres."""


@frozen
class _Length:
    """A length that a file gives.

    Attributes:
        where: Path to it.
        what: What stands before it in a message.
        value: Its constant part, without sign [m].
    """

    where: tuple[str | int, ...]
    what: str
    value: float


def of_robot(robot: Description) -> Iterator[Finding]:
    """Lengths that no arm has: each that is too long, or all of them if they are too short."""
    if robot.variables:  # blocks that are put together have any size
        lengths = tuple(_of_robot(robot))
        yield from _too_long(lengths, "units: mm makes all of them so")
        yield from _too_short(robot, lengths)


def told_once(robot: Description, hint: str = "") -> tuple[str, ...]:
    """What is said of lengths that no arm has, in a sentence; nothing where it was said when the robot was read.

    Args:
        robot: The robot.
        hint: What to do where they are too long; by default what an author would write.
    """
    found = [*of_robot(robot)]
    if not found or any(_LONG in remark for remark in robot.remarks):
        return ()
    first = found[0]
    more = f", and {len(found) - 1} more" if found[1:] else ""
    return (f"{first.message}{more}; {hint if hint and _LONG in first.message else first.hint}",)


def of_exercise(exercise: Exercise) -> Iterator[Finding]:
    """Values of the robot's lengths, given or drawn, that no arm has; without a unit they are what one likes."""
    robot = exercise.robot
    if robot is None or exercise.unit == "none":
        return
    given = {("given", name): (value,) for name, value in exercise.given.items() if name not in exercise.variants}
    drawn = {("variants", name): range_.values for name, range_ in exercise.variants.items()}
    yield from _too_long(
        _Length(where, f"{where[1]}:", max(map(_constant, values)))
        for where, values in {**given, **drawn}.items()
        if where[1] in robot.scope.names and where[1] not in robot.angles
    )


def of_linkage(linkage: Linkage) -> Iterator[Finding]:
    """The point that lies farthest out, if it is farther than in any linkage."""
    named = {point.at: point.name for point in linkage.points}
    placed = [*named, *(at for joint in linkage.joints for at in (joint.point, joint.other) if at is not None)]
    far = max(placed, key=lambda at: max(map(abs, at)), default=None)
    if far is None or (size := max(map(abs, far))) <= LONGEST_BAR:
        return
    name = named.get(far, "")
    message = f"{name or 'a point'}: a coordinate of {size:g} m is larger than any linkage"
    yield Finding(("points", name) if name else ("joints",), message, _meant(size), is_warning=True)


def _of_robot(robot: Description) -> Iterator[_Length]:
    """Every length that stands in the file of a robot."""
    for name, value in robot.parameters.items():
        formula = robot.derived.get(name)
        yield _Length(("parameters", name), f"{name}:", _constant(value if formula is None else formula.expr))
    for index, link in enumerate(robot.links):
        yield from _of_link(link, index)
    tools = ((("tools", name), chain) for name, chain in robot.tools.items())
    for where, chain in ((("base",), robot.base), (("tool",), robot.tool), *tools):
        yield _Length(where, f"{where[-1]}:", _farthest(chain))
    slides = {name for name in robot.variables if not is_greek(name)}  # theta2 of a row that has been refused turns
    for name, values in robot.limits.items():
        if name not in slides:
            continue
        yield _Length(("limits", name), f"{name}:", max(map(_constant, values)))
    motors = robot.actuators.limits if robot.actuators else {}
    for name, values in motors.items():
        yield _Length(("actuators", "motors", name), f"{name}:", max(map(_constant, values)))
    for pose, joints in robot.poses.items():
        for name, value in zip(robot.variables, joints, strict=False):
            if name not in slides:
                continue
            if symbols_of(value) or is_within_limits(robot, name, in_floats(value)):  # else that is told
                yield _Length(("poses", pose), f"{pose}: {name} =", _constant(value))


def _of_link(link: Link, index: int) -> Iterator[_Length]:
    """The lengths of a row, or the longest of a product."""
    if link.row is None:
        yield _Length(("links", index), f"row {index + 1}:", _farthest(link.moves))
        return
    for column, value in (("a", link.row.a), ("d", link.row.d)):
        yield _Length(("links", index, column), f"{column} of row {index + 1}:", _constant(value))


def _farthest(chain: Chain) -> float:
    """The longest length in moves [m]."""
    moved = (move.offset for move in chain if isinstance(move, Trans))
    placed = (tuple(row[3] for row in move.rows) for move in chain if isinstance(move, Fixed))
    return max((_constant(length) for lengths in (*moved, *placed) for length in lengths), default=0.0)


def _constant(value: Value | None) -> float:
    """What is left of a length with every name in it at 0, without its sign [m]; 0 of an angle, and of nothing."""
    if not isinstance(value, Expr):
        return 0.0
    try:
        size = abs(Floats(dict.fromkeys(symbols(value), 0.0)).value(value))
    except (ZeroDivisionError, OverflowError):
        return 0.0
    return size if math.isfinite(size) else 0.0


def _too_long(lengths: Iterable[_Length], of_many: str = "") -> Iterator[Finding]:
    """Each that is longer than an arm; of many it is said how all can be mended at once."""
    found = [length for length in lengths if length.value > LONGEST]
    for one in found:
        message = f"{one.what} {one.value:g} m {_LONG}"
        yield Finding(one.where, message, _meant(one.value, of_many if len(found) > 1 else ""), is_warning=True)


def _too_short(robot: Description, lengths: Iterable[_Length]) -> Iterator[Finding]:
    """The longest, if all are far too short; nothing while one is left open."""
    is_open = any(value is None for name, value in robot.parameters.items() if name not in robot.angles)
    longest = max(lengths, key=lambda length: length.value, default=None)
    if longest is not None and 0 < longest.value < SHORTEST and not is_open:
        size = longest.value * 1000
        message = f"{longest.what} the longest of all lengths is {size:g} mm"
        yield Finding(longest.where, message, f"did you mean {size:g} m?", is_warning=True)


def _meant(size: float, of_many: str = "") -> str:
    """What was meant by a number of metres."""
    if size > LONGEST * 1000:
        return "is its unit right?"
    return f"bare lengths are metres: did you mean {size:g} mm? {of_many}".rstrip()
