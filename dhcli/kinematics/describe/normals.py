"""The common normal of two lines: skew, meeting, parallel or the same; and where a sliding axis is put."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from enum import StrEnum

from dhcli.frozen import frozen
from dhcli.geometry.vectors import Vector, across, cross, dot, length, scaled
from dhcli.kinematics.describe.drawn import Drawing, Frame, Line, same_direction
from dhcli.kinematics.describe.exact import CLOSE
from dhcli.kinematics.describe.linear import Form, LettersError, Point, Ruler, along, mapped, moved, shifted
from dhcli.notation.tree import ONE

FAR = 450.0
"""Sizes of the robot from which on a common normal is told to be far away."""


class Lie(StrEnum):
    """How two lines lie to each other."""

    SKEW = "skew"
    MEET = "meet"
    PARALLEL = "parallel"
    SAME = "the same line"


@frozen
class Normal:
    """The common normal of two lines, or the one chosen where there are many.

    Attributes:
        lie: How the lines lie to each other.
        x: Unit vector along it, from the first to the second where they are apart.
        start: Its foot on the first line.
        end: Its foot on the second line.
        apart: How far it leads along x.
        same: 1 for lines in the same direction, -1 for opposite ones, 0 where they are not parallel.
    """

    lie: Lie
    x: Vector
    start: Point
    end: Point
    apart: Form
    same: int


def normal(first: Line, second: Line, near: Frame, ruler: Ruler, *, is_signed: bool = False) -> Normal:
    """The common normal of two lines.

    Args:
        first: The line one stands on, with a point.
        second: The next line, with a point.
        near: A frame whose x axis and whose origin, on the first line, decide what is free.
        ruler: What decides about lengths.
        is_signed: Whether x is to lie on the side of the x near, so that it may lead from the second line to the first.

    Raises:
        LettersError: The direction of the normal depends on how long letters are.
    """
    u, v = first.direction, second.direction
    between = ruler.cleaned_point(moved(_through(second), _through(first), -1))
    same = same_direction(u, v)
    if same:
        return _signed(_of_parallel(u, between, near, ruler, same), near, is_signed=is_signed)
    n = _across(u, v)
    n = scaled(n, 1 / length(n))
    start, end = _feet(first, second, ruler)
    apart = ruler.cleaned(along(between, n))
    if apart:
        if not ruler.is_positive(apart):
            n, apart = scaled(n, -1), {letter: -value for letter, value in apart.items()}
        return _signed(Normal(Lie.SKEW, n, start, end, apart, 0), near, is_signed=is_signed)
    return _signed(Normal(Lie.MEET, n, start, end, {}, 0), near, is_signed=True)


def through_end(found: Normal, end: Frame, ruler: Ruler) -> Normal:
    """The last normal, with the end frame's x axis and origin where the rules allow them."""
    if found.lie is Lie.SAME:
        return replace(found, x=end.x, start=end.origin, end=end.origin)
    if found.lie is Lie.PARALLEL:
        back = {letter: -value for letter, value in found.apart.items()}
        return replace(found, start=ruler.cleaned_point(shifted(end.origin, found.x, back)), end=end.origin)
    return _signed(found, end, is_signed=found.lie is Lie.MEET)


def placed(drawing: Drawing, base: Frame) -> tuple[Line, ...]:
    """All lines from the base z to the end z, sliding ones with a point.

    A sliding axis lies on a parallel neighbour, else it passes through the origin of the next frame.
    """
    ruler = drawing.ruler
    lines = [
        Line("base", base.z, base.origin),
        *_clustered(drawing.lines, base.z, drawing.end.z),
        Line("end", drawing.end.z, drawing.end.origin),
    ]
    lines[-1] = replace(
        lines[-1], direction=_clustered((lines[-1],), base.z, *(line.direction for line in lines))[0].direction
    )
    for k in range(len(lines) - 2, 0, -1):
        if lines[k].through is not None:
            continue
        after, before = lines[k + 1], lines[k - 1]
        if same_direction(lines[k].direction, after.direction):
            point = _through(after)
        elif before.through is not None and same_direction(lines[k].direction, before.direction):
            point = before.through
        else:
            point = origin_on(lines, k + 1, ruler)
        lines[k] = replace(lines[k], through=point)
    return tuple(lines)


def _clustered(lines: tuple[Line, ...], *known: Vector) -> tuple[Line, ...]:
    """Lines with one direction for all that are parallel, so that roundings do not add up."""
    kept = list(known)
    found = []
    for line in lines:
        for direction in kept:
            if same := same_direction(direction, line.direction):
                found.append(replace(line, direction=scaled(direction, same)))
                break
        else:
            kept.append(line.direction)
            found.append(line)
    return tuple(found)


def origin_on(lines: Sequence[Line], k: int, ruler: Ruler) -> Point:
    """Where the next frame stands on a line: where the line after it meets it, else at the point that is given."""
    line = lines[k]
    if k + 1 < len(lines) and not same_direction(line.direction, lines[k + 1].direction):
        return _feet(line, lines[k + 1], ruler)[0]
    return _through(line)


def _signed(found: Normal, near: Frame, *, is_signed: bool) -> Normal:
    """The normal with its x on the side of the x near, if it is to be."""
    if not is_signed or dot(found.x, near.x) >= -CLOSE:
        return found
    return replace(found, x=scaled(found.x, -1), apart={letter: -value for letter, value in found.apart.items()})


def _of_parallel(u: Vector, between: Point, near: Frame, ruler: Ruler, same: int) -> Normal:
    wide = ruler.cleaned_point({letter: across(vector, u) for letter, vector in between.items()})
    if not wide:
        return Normal(Lie.SAME, near.x, near.origin, near.origin, {}, same)
    longest = max(wide.values(), key=length)
    x = scaled(longest, 1 / length(longest))
    if any(length(cross(x, vector)) > CLOSE * length(vector) for vector in wide.values()):
        letters = ", ".join(str(letter) for letter in wide if letter != ONE)
        raise LettersError(f"the direction of a common normal depends on the ratio of {letters}", "ask in numbers")
    apart = ruler.cleaned(along(wide, x))
    if not ruler.is_positive(apart):
        x, apart = scaled(x, -1), {letter: -value for letter, value in apart.items()}
    end = ruler.cleaned_point(moved(near.origin, wide))
    return Normal(Lie.PARALLEL, x, near.origin, end, apart, same)


def _feet(first: Line, second: Line, ruler: Ruler) -> tuple[Point, Point]:
    """The feet of the common normal of lines that are not parallel; a second round starts from those of the first."""
    u, v = first.direction, second.direction
    n = _across(u, v)
    square = dot(n, n)
    start, end = _through(first), _through(second)
    for _ in range(2):
        w = moved(end, start, -1)
        s = mapped(w, lambda vector: dot(cross(vector, v), n) / square)
        t = mapped(w, lambda vector: dot(cross(vector, u), n) / square)
        start, end = shifted(start, u, s), shifted(end, v, t)
    return ruler.cleaned_point(start), ruler.cleaned_point(end)


def _across(u: Vector, v: Vector) -> Vector:
    """Across two directions; by their difference, of which more digits are right where they are nearly parallel."""
    sign = 1.0 if dot(u, v) >= 0 else -1.0
    return cross(u, (v[0] - sign * u[0], v[1] - sign * u[1], v[2] - sign * u[2]))


def _through(line: Line) -> Point:
    assert line.through is not None, line.name  # noqa: S101  `placed` has put it somewhere
    return line.through


def how_far(found: Normal, ruler: Ruler) -> float:
    """How far the feet of a normal are from the base, in sizes of the robot; letters do not count."""
    feet = (vector for point in (found.start, found.end) for letter, vector in point.items() if letter == ONE)
    return max(map(length, feet), default=0.0) / ruler.size


def far_feet(found: Normal, first: Line, second: Line, ruler: Ruler) -> str:
    """A warning where two axes are nearly parallel, so that their normal lies far away; empty where they are not."""
    far = how_far(found, ruler)
    if far <= FAR or found.same:
        return ""
    angle = math.degrees(math.asin(min(1.0, length(cross(first.direction, second.direction)))))
    return (
        f"the axes {first.name} and {second.name} are {angle:.2g}° from parallel: their common normal is "
        f"{far * ruler.size:.4g} m away, {far:.0f} times the size of the robot; --straighten takes them as parallel"
    )
