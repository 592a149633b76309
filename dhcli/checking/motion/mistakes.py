"""Mistakes in the columns of a Jacobian, each beside what makes it.

Whoever has made one goes on rightly with wrong columns; so the same mistakes serve the Jacobian, its determinant,
torques, velocities and rates.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from enum import IntEnum
from functools import lru_cache, partial
from typing import TypeAlias

from dhcli.checking.diagnosis.record import Catalogue
from dhcli.checking.diagnosis.result import Rank, Slip
from dhcli.checking.motion.columns import (
    MOST_VECTORS,
    NOTHING,
    Column,
    Columns,
    Vector,
    axis_z,
    cross,
    minus,
    origin_of,
)
from dhcli.checking.motion.differentiated import differentiated
from dhcli.kinematics.conventions import Convention
from dhcli.kinematics.frames import ORIGIN
from dhcli.notation.angle import Angle
from dhcli.notation.derivative import derivative
from dhcli.notation.tree import Expr, Trig, negate, number
from dhcli.notation.trig import swapped
from dhcli.notation.walk import rebuild, substitute

Made: TypeAlias = Iterator[tuple[str, Columns]]


class Level(IntEnum):
    """At what stage of the work a mistake is made."""

    FRAMES = 0
    COLUMNS = 1
    SIGNS = 2
    WRITING = 3
    ORDER = 4


IN_COLUMNS: Catalogue[Callable[[Columns], Made]] = Catalogue(Level.COLUMNS, Rank.WHOLE)
"""In the order in which they are tried and named."""


def made(columns: Columns, kind: str = "") -> Iterator[tuple[Slip, Columns]]:
    """Every mistake, with the columns that it leads to.

    Args:
        columns: The right columns.
        kind: Only mistakes of this name; all by default.
    """
    for mistake in IN_COLUMNS:
        if kind in ("", mistake.id):
            for where, changed in mistake.made(columns):
                yield mistake.slip(where), changed


def then(columns: Columns, first: Slip) -> Iterator[tuple[Slip, Columns]]:
    """Every mistake that is made after another one, or of the same kind behind it."""
    place = {mistake.id: mistake for mistake in IN_COLUMNS}
    before = place[first.name.partition(" ")[0]]
    for mistake in IN_COLUMNS:
        is_again = mistake is before and mistake.rank is Rank.PLACE
        if mistake.level > before.level or is_again or (mistake, before) == (place["reference"], place["in-frame"]):
            for slip, changed in made(columns, mistake.id):
                if not is_again or slip.name > first.name:
                    yield slip, changed


def _each(columns: Columns, change: Callable[[Column], Column]) -> Columns:
    return replace(columns, each=tuple(map(change, columns.each)))


def _instead(columns: Columns, one: Column, changed: Column) -> Columns:
    """One column changed."""
    return _each(columns, lambda column: changed if column is one else column)


def rewritten(columns: Columns, change: Callable[[Expr], Expr]) -> Columns:
    """Every entry of every column changed."""

    def changed(vector: Vector) -> Vector:
        x, y, z = map(change, vector)
        return x, y, z

    return _each(columns, lambda one: replace(one, linear=changed(one.linear), angular=changed(one.angular)))


@lru_cache(MOST_VECTORS)
def _from_other_zero(entry: Expr, joint: str, quarter: int) -> Expr:
    return substitute(entry, {}, {joint: Angle.of(joint) + Angle.in_degrees(quarter)})


@lru_cache(MOST_VECTORS)
def _with_functions_swapped(entry: Expr) -> Expr:
    return rebuild(entry, swapped)


def _turned(columns: Columns, arm: Callable[[Column], Vector]) -> Columns:
    """The velocity that each revolute joint gives, with another arm than from its axis to the point."""
    return _each(columns, lambda one: replace(one, linear=cross(one.axis, arm(one))) if one.turns else one)


@IN_COLUMNS(
    "in-frame",
    "the vectors are written along the axes of frame {where}",
    "along the axes of which frame are the vectors asked for?",
    level=Level.FRAMES,
)
def in_frame(columns: Columns) -> Made:
    """All vectors in another frame, such as the end frame for the base frame."""
    for name in columns.robot.frames:
        if name not in (columns.view.axes, *_elsewhere(columns)):
            yield name, columns.along(name)


def _elsewhere(columns: Columns) -> tuple[str, ...]:
    """The frames of a base and a tool that are those next to them, or are not asked about."""
    robot = columns.robot
    return tuple(name for name, moves in (("base", robot.base), ("tool", robot.tool)) if not moves)


@IN_COLUMNS(
    "joint-kind",
    "the column of joint {where} is that of the other kind of joint, turning for sliding",
    "which joints turn, and which slide?",
    rank=Rank.PLACE,
)
def joint_kind(columns: Columns) -> Made:
    """For a slide z x (p - o) above z, for a turn z above 0."""
    for one in columns.each:
        arm = minus(columns.point, one.origin)
        linear, angular = (one.axis, NOTHING) if one.turns else (cross(one.axis, arm), one.axis)
        yield one.joint, _instead(columns, one, replace(one, linear=linear, angular=angular))


@IN_COLUMNS(
    "axis-shifted",
    "each joint has the z axis of its neighbour's frame",
    "about which z does joint 1 turn in this convention?",
)
def axis_shifted(columns: Columns) -> Made:
    """z_i for z_{i-1} in a standard table, z_{i-1} for z_i in a modified one; o as it is."""
    robot = columns.robot
    if robot.convention is Convention.PRODUCT:
        return
    links = {joint.name: str(joint.link) for joint in robot.joints}

    def shifted(one: Column) -> Column:
        index = robot.frames.index(links[one.joint])
        name = robot.frames[index if robot.convention is Convention.STANDARD else index - 1]
        axis = axis_z(robot, columns.view.axes, name)
        if one.turns:
            return replace(one, linear=cross(axis, minus(columns.point, one.origin)), angular=axis)
        return replace(one, linear=axis)

    yield "", _each(columns, shifted)


@IN_COLUMNS(
    "slide-turns",
    "the column of the slide {where} has an angular part, and a slide turns nothing",
    "what does a slide turn?",
    rank=Rank.PLACE,
)
def slide_turns(columns: Columns) -> Made:
    """Z above z, where 0 belongs below."""
    for one in columns.each:
        if not one.turns:
            yield one.joint, _instead(columns, one, replace(one, angular=one.axis))


@IN_COLUMNS(
    "one-axis", "all joints turn about the axis of the first one", "along what does the axis of each joint lie?"
)
def one_axis(columns: Columns) -> Made:
    """The z0 of a planar arm for every joint."""
    axis = columns.each[0].axis

    def changed(one: Column) -> Column:
        arm = minus(columns.point, one.origin)
        return replace(one, axis=axis, linear=cross(axis, arm), angular=axis) if one.turns else one

    yield "", _each(columns, changed)


@IN_COLUMNS(
    "zero-turned",
    "the angle {where} counts from another zero, a quarter turn away",
    "where does the arm point when its angles are 0?",
    rank=Rank.PLACE,
    level=Level.WRITING,
)
def zero_turned(columns: Columns) -> Made:
    """Links along x0 that lie along y0 at zero, or the other way round."""
    first = columns.each[0]
    for quarter in (90, -90) if first.turns else ():
        change = partial(_from_other_zero, joint=first.joint, quarter=quarter)
        yield f"{first.joint} {quarter:+}°", rewritten(columns, change)


@IN_COLUMNS(
    "joint-left-out",
    "joint {where} is left out: its column is 0",
    "does every joint have a column?",
    rank=Rank.PLACE,
    level=Level.WRITING,
)
def joint_left_out(columns: Columns) -> Made:
    """A column of zeros, such as where z_0 is forgotten."""
    for one in columns.each:
        yield one.joint, _instead(columns, one, replace(one, linear=NOTHING, angular=NOTHING))


@IN_COLUMNS(
    "cross-reversed",
    "the cross product is taken the wrong way round",
    "which vector comes first in z x (p - o)?",
    level=Level.SIGNS,
)
def cross_reversed(columns: Columns) -> Made:
    """(p - o) x z."""

    def turned(one: Column) -> Column:
        x, y, z = map(negate, one.linear)
        return replace(one, linear=(x, y, z)) if one.turns else one

    yield "", _each(columns, turned)


@IN_COLUMNS(
    "own-angle-only",
    "a cosine or sine of a sum of angles is differentiated by its last angle alone",
    "on which joint angles does c12 depend?",
)
def own_angle_only(columns: Columns) -> Made:
    """c12 by theta2 alone."""
    yield from differentiated(columns, _by_the_last)


def _by_the_last(trig: Trig, name: str, joints: tuple[str, ...]) -> Expr:
    inside = [joint for joint in joints if joint in trig.angle.names]
    return derivative(trig, name) if inside and inside[-1] == name else number(0)


@IN_COLUMNS("cosine-sign", "the derivative of a cosine has the wrong sign", "what is the derivative of a cosine?")
def cosine_sign(columns: Columns) -> Made:
    """Plus sine for the derivative of a cosine."""
    yield from differentiated(columns, _with_plus)


def _with_plus(trig: Trig, name: str, _joints: tuple[str, ...]) -> Expr:
    found = derivative(trig, name)
    return negate(found) if trig.function == "cos" else found


@IN_COLUMNS(
    "origin-not-subtracted",
    "the origin of each joint is not subtracted: z x p for z x (p - o)",
    "from where does the arm of each joint reach?",
)
def origin_not_subtracted(columns: Columns) -> Made:
    """Every joint turns the point about the base."""
    yield "", _turned(columns, lambda _one: columns.point)


@IN_COLUMNS(
    "sums-from-base",
    "each column has the links before its joint, and not those behind",
    "which part of the arm does a joint move?",
)
def sums_from_base(columns: Columns) -> Made:
    """What stands before the joint instead of what it moves, from the first axis to the next."""
    first, ends = columns.each[0].origin, [*(one.origin for one in columns.each[1:]), columns.point]
    reached = {one.joint: minus(end, first) for one, end in zip(columns.each, ends, strict=True)}
    yield "", _turned(columns, lambda one: reached[one.joint])


@IN_COLUMNS(
    "reference",
    "the velocity is that of the origin of frame {where}",
    "whose velocity is asked for: which point moves?",
    level=Level.FRAMES,
)
def reference(columns: Columns) -> Made:
    """Another reference point, such as the origin one frame short of the end."""
    view, robot = columns.view, columns.robot
    if view.point != ORIGIN:
        yield view.end, _about(columns, origin_of(robot, view.axes, view.end))
    for name in robot.frames:
        if name != view.place and name not in _elsewhere(columns):
            yield name, _about(columns, origin_of(robot, view.axes, name))


def _about(columns: Columns, point: Vector) -> Columns:
    return replace(_turned(columns, lambda one: minus(point, one.origin)), point=point)


@IN_COLUMNS(
    "angular-dropped", "the angular velocities are 0", "how does each joint turn the end frame?", level=Level.WRITING
)
def angular_dropped(columns: Columns) -> Made:
    """Zeros in the place of ω."""
    yield "", _each(columns, lambda one: replace(one, angular=NOTHING))


@IN_COLUMNS(
    "columns-reversed", "the columns stand in the reverse order", "which joint has the first column?", level=Level.ORDER
)
def columns_reversed(columns: Columns) -> Made:
    """The last joint first."""
    values = [(one.linear, one.angular) for one in reversed(columns.each)]
    pairs = zip(columns.each, values, strict=True)
    yield "", replace(columns, each=tuple(replace(one, linear=v, angular=w) for one, (v, w) in pairs))


@IN_COLUMNS(
    "sin-cos",
    "sines and cosines have changed places",
    "from which axis are the angles measured?",
    rank=Rank.SYMPTOM,
    level=Level.WRITING,
)
def sine_cosine(columns: Columns) -> Made:
    """Sine for cosine and back, everywhere."""
    yield "", rewritten(columns, _with_functions_swapped)
