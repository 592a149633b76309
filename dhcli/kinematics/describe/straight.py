"""A robot whose axes are parallel, or meet, where they nearly do: on request only, and it says what that changes.

Each axis is compared with its neighbour before it. A direction within the angle of the neighbour's becomes that one,
turned about the point of the axis that is nearest to the arm; an axis that then passes its neighbour, or the point
where its neighbours meet, by less than that angle seen from the size of the robot is shifted onto it.

How far the tip can move is bounded, for all values of turning joints. Where axis k is turned by δ and shifted by s, a
rotation about it moves a point at the distance r from it by at most 2 δ r + 2 s elsewhere; r is at most the way
from axis to axis to the tip.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import field, replace

from dhcli.errors import RobotError
from dhcli.frozen import frozen
from dhcli.geometry.vectors import ORIGIN, UNITS, Vector, across, cross, dot, length, minus, plus, scaled
from dhcli.kinematics.derived import in_floats
from dhcli.kinematics.describe.drawn import Drawing, Frame, Line, same_direction
from dhcli.kinematics.describe.exact import CLOSE
from dhcli.kinematics.entries import small_length
from dhcli.kinematics.robot import Value
from dhcli.notation.tree import ONE

END = "end"

MOST = math.radians(5)
"""Axes farther than this from parallel were never meant to be."""


@frozen
class Change:
    """What became of one axis.

    Attributes:
        joint: Its joint variable; `end` for the z axis of the end frame.
        turned: By how much [rad].
        shifted: By how much, at the point nearest to the arm [m].
        said: To which end, in words.
    """

    joint: str
    turned: float
    shifted: float
    said: str

    def __str__(self) -> str:
        """In words, with its amounts."""
        amounts = [f"turned by {math.degrees(self.turned):.2g}°"] if self.turned else []
        amounts += [f"shifted by {small_length(self.shifted)}"] if self.shifted else []
        return f"{self.joint} is {' and '.join(amounts)}: {self.said}"


@frozen
class Straightened:
    """What straightening has changed.

    Attributes:
        within: Axes this near to parallel, or to meeting, were taken as such [rad].
        changes: What became of each axis that is changed, from base to end.
        tip: How far the origin of the end frame moves at most, over the whole workspace [m].
        turn: By how much the end frame turns at most [rad].
        strokes: What a joint without limits was taken to slide at most [m].
    """

    within: float
    changes: tuple[Change, ...]
    tip: float
    turn: float
    strokes: Mapping[str, float] = field(default_factory=dict)

    def lines(self) -> tuple[str, ...]:
        """What was changed, in words."""
        if not self.changes:
            return (f"no axes are nearly parallel, or nearly meet, within {self.within:g} rad: nothing is changed",)
        known = "".join(f", {name} sliding {small_length(most)} at most" for name, most in self.strokes.items())
        head = (
            f"straightened within {self.within:g} rad, so not the same robot: over the whole workspace its tip is at "
            f"most {small_length(self.tip)} off, turned by at most {math.degrees(self.turn):.2g}°{known}"
        )
        return (head, *map(str, self.changes))


def check_within(within: float) -> float:
    """The angle within which axes are straightened [rad].

    Raises:
        RobotError: It is none of a near miss.
    """
    if not 0 < within <= MOST:
        raise RobotError("axes are straightened within an angle above 0 and up to 5°", "write 1e-4, or 0.01°")
    return within


def straightened(
    drawing: Drawing, within: float, limits: Mapping[str, tuple[Value, Value]]
) -> tuple[Drawing, Straightened]:
    """A drawing with axes that nearly are parallel, or nearly meet, taken as such.

    Args:
        drawing: A robot in numbers.
        within: Up to which angle [rad]; a gap counts as seen from the size of the robot.
        limits: Limits of joints, for how far those that slide do.

    Raises:
        RobotError: The angle is none of a near miss.
    """
    straight = _Straight(drawing, check_within(within))
    lines = tuple(straight.line(k) for k in range(len(drawing.lines)))
    end = straight.end()
    tip, strokes = straight.bound(end, limits)
    changes = tuple(straight.changes)
    turn = sum(change.turned * (2 if change.joint in straight.turning else change.joint == END) for change in changes)
    told = Straightened(within, changes, tip, turn, strokes if changes else {})
    return replace(drawing, lines=lines, end=end), told


class _Straight:
    """Goes from the base to the end, one axis after the other."""

    def __init__(self, drawing: Drawing, within: float) -> None:
        self.drawing = drawing
        self.within = within
        self.pivots = _pivots(drawing)
        tip = drawing.end.origin.get(ONE, ORIGIN)
        self.size = max(map(length, (*self.pivots, tip))) or 1.0
        self.close = within * self.size
        self.kept = [Line("base", UNITS[2], {})]
        self.hub: Vector | None = None  # where the two axes before meet
        self.changes: list[Change] = []
        self.turning = frozenset(line.name for line in drawing.lines if line.turns)

    def line(self, k: int) -> Line:
        """The axis of one joint, straightened."""
        line, point = self.drawing.lines[k], self.pivots[k]
        direction, said = self.direction(line)
        turned = _between(line.direction, direction)
        gap = ORIGIN
        if line.turns:
            gap, met = self.gap(point, direction)
            said = " and ".join(part for part in (said, met) if part)
        if turned or length(gap):
            self.changes.append(Change(line.name, turned, length(gap), said))
        self.pivots[k] = plus(point, gap)
        found = replace(line, direction=direction, through={ONE: self.pivots[k]} if line.turns else None)
        self.kept.append(found)
        return found

    def direction(self, line: Line) -> tuple[Vector, str]:
        """Its direction, and what it is parallel to now: its neighbour, or one behind neighbours that only slide."""
        for other in reversed(self.kept):
            if same := same_direction(other.direction, line.direction, self.within):
                exact = scaled(other.direction, same)
                turned = _between(line.direction, exact)
                return exact, f"parallel to {_named(other)}" if turned else ""
            if other.turns:  # how axes beyond lie to this one changes with the pose
                break
        return line.direction, ""

    def gap(self, point: Vector, direction: Vector) -> tuple[Vector, str]:
        """How an axis is to be shifted, and what it meets then."""
        before, hub = self.kept[-1], self.hub
        self.hub = None
        if before.through is None:
            return ORIGIN, ""
        between = minus(before.through.get(ONE, ORIGIN), point)
        if same_direction(before.direction, direction):
            shift = across(between, direction)
            return self.shifted(shift, f"on one line with {_named(before)}")
        if hub is not None:
            shift = across(minus(hub, point), direction)
            if length(shift) <= self.close:
                self.hub = hub
                return self.shifted(shift, f"through the point where {_named(self.kept[-2])} and {_named(before)} meet")
        normal = cross(before.direction, direction)
        shift = scaled(normal, dot(between, normal) / dot(normal, normal))
        if length(shift) > self.close:
            return ORIGIN, ""
        way = dot(cross(between, before.direction), normal) / dot(normal, normal)
        self.hub = plus(plus(point, shift), direction, -way)
        return self.shifted(shift, f"meeting {_named(before)}")

    def shifted(self, shift: Vector, said: str) -> tuple[Vector, str]:
        """A shift, if it is one and small enough."""
        return (shift, said) if CLOSE * self.size < length(shift) <= self.close else (ORIGIN, "")

    def end(self) -> Frame:
        """The end frame: its z parallel to an axis that it nearly is parallel to, on one line with the last one."""
        end, last = self.drawing.end, self.kept[-1]
        z, said = self.direction(Line(END, end.z, end.origin))
        turned, gap, here = _between(end.z, z), ORIGIN, end.origin.get(ONE, ORIGIN)
        if last.through is not None and same_direction(last.direction, z):
            shift = across(minus(last.through.get(ONE, ORIGIN), here), z)
            gap, met = self.shifted(shift, f"on one line with {_named(last)}")
            said = " and ".join(part for part in (said, met) if part)
        if turned or length(gap):
            self.changes.append(Change(END, turned, length(gap), said))
        x = plus(end.x, plus(end.z, z), -dot(end.x, z) / (1 + dot(end.z, z))) if turned else end.x
        return Frame(scaled(x, 1 / length(x)) if turned else x, z, {ONE: plus(here, gap)})

    def bound(self, end: Frame, limits: Mapping[str, tuple[Value, Value]]) -> tuple[float, dict[str, float]]:
        """How far the tip moves at most, and the strokes that were taken for those of joints without limits."""
        amounts = {change.joint: change for change in self.changes}
        strokes: dict[str, float] = {}
        tip = amounts[END].shifted if END in amounts else 0.0
        reach, after = 0.0, end.origin.get(ONE, ORIGIN)
        for line, point in zip(reversed(self.drawing.lines), reversed(self.pivots), strict=True):
            reach, after = reach + length(minus(after, point)), point
            stroke = self.stroke(line, limits.get(line.name), strokes)
            if change := amounts.get(line.name):
                tip += change.turned * stroke
                tip += 2 * (change.turned * reach + change.shifted) if line.turns else 0.0
            reach += stroke
        return tip, strokes

    def stroke(self, line: Line, limits: tuple[Value, Value] | None, strokes: dict[str, float]) -> float:
        """How far a joint slides at most from where it is drawn; nothing where it only turns."""
        rate = line.pitch.get(ONE, 0.0) if line.turns else float(line.rate)
        if not rate:
            return 0.0
        if limits is None:
            strokes[line.name] = abs(2 * math.pi * rate) if line.turns else self.size
            return strokes[line.name]
        drawn, *ends = (in_floats(value) for value in (line.drawn, *limits))
        return abs(rate) * max(abs(end - drawn) for end in ends)


def _pivots(drawing: Drawing) -> list[Vector]:
    """The point of each axis that is nearest to that of the axis before; sliding axes keep that one."""
    found, here = [], ORIGIN
    for line in drawing.lines:
        if line.through is not None:
            start = line.through.get(ONE, ORIGIN)
            here = plus(start, line.direction, dot(minus(here, start), line.direction))
        found.append(here)
    return found


def _between(u: Vector, v: Vector) -> float:
    """The angle between directions that are nearly the same; 0 where it is a rounding [rad]."""
    angle = math.asin(min(1.0, length(cross(u, minus(v, u)))))
    return angle if angle > CLOSE else 0.0


def _named(line: Line) -> str:
    return "the base's z" if line.name == "base" else line.name
