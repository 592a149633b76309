"""The rigid maps that fit the joints of two robots so far, and how the next joint cuts them down."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import field
from itertools import pairwise

from dhcli.frozen import frozen
from dhcli.geometry.rigid import Rigid
from dhcli.geometry.vectors import (
    ORIGIN,
    UNITS,
    Vector,
    across,
    angle_about,
    cross,
    dot,
    length,
    minus,
    plus,
    scaled,
    within,
)
from dhcli.kinematics.axes import Screw

ALONG = 1e-3
"""What is left of a unit vector that counts as lying in a span."""

AMPLY = 10
"""How many times more than one axis two together may be off, where they are only looked at first."""


@frozen
class Limits:
    """When two axes agree.

    Attributes:
        turn: Largest difference of a direction cosine.
        shift: Largest distance [m].
        parallel: Largest sine between axes that count as parallel.
        coincident: Largest distance between parallel lines that count as one [m].
    """

    turn: float
    shift: float
    parallel: float
    coincident: float

    @classmethod
    def exact(cls, size: float) -> Limits:
        """For cells without rounding; what remains is the error of floats."""
        return cls(1e-7, 1e-7 * size, 1e-8, 1e-9 * size)

    @classmethod
    def rounded(cls, turn: float, shift: float, times: float = 1.0) -> Limits:
        """For numbers with tolerances."""
        return cls(turn * times, shift * times, 3 * turn, 1e-3 * shift)


@frozen
class Fit:
    """The rigid maps that fit so far: `T(v) · R(line, t) · g`, v in the span of `spread`.

    Attributes:
        g: One of them.
        line: Direction and a point of the line they may turn about; None where they may not.
        spread: Perpendicular unit vectors they may be shifted along.
        anything: Whether every rigid map fits, as before the first joint.
    """

    g: Rigid = field(default_factory=Rigid)
    line: tuple[Vector, Vector] | None = None
    spread: tuple[Vector, ...] = UNITS
    anything: bool = True


def held_by(fit: Fit, one: Screw, other: Screw, limits: Limits) -> Fit | None:
    """Those maps that bring one axis onto another, in a given sense."""
    aimed = _aimed(fit, one.direction, other.direction, limits)
    if aimed is None or not one.turns:
        return aimed
    if aimed.line is not None and len(aimed.spread) < len(UNITS):
        axis, through = aimed.line
        here = across(minus(aimed.g.moved(one.point), through), axis)
        there = across(minus(other.point, through), axis)
        if min(length(here), length(there)) > limits.coincident:
            turn = Rigid.turn(axis, angle_about(axis, here, there), through)
            aimed = Fit(turn @ aimed.g, None, aimed.spread, aimed.anything)
    gap = across(minus(other.point, aimed.g.moved(one.point)), other.direction)
    step, left = _solved(gap, aimed.spread, other.direction)
    if length(left) > limits.shift:
        return None
    slides = length(minus(other.direction, within(other.direction, aimed.spread))) <= limits.parallel
    line = None if aimed.line is None else (other.direction, other.point)
    return Fit(Rigid.shift(step) @ aimed.g, line, (other.direction,) if slides else (), aimed.anything)


def may_be_alike(one: Sequence[Screw], other: Sequence[Screw], limits: Limits) -> bool:
    """Whether each two joints that follow one another lie alike, in whichever sense they count: a cheap look first.

    Robots that are the same have the same angle between such axes and, where both turn, the same distance.
    """
    if [(screw.name, screw.turns) for screw in one] != [(screw.name, screw.turns) for screw in other]:
        return False
    return all(
        abs(first - second) <= AMPLY * (limits.shift if is_length else limits.turn)
        for (a, b), (c, d) in zip(pairwise(one), pairwise(other), strict=True)
        for first, second, is_length in zip(_between(a, b), _between(c, d), (False, True), strict=True)
    )


def _between(one: Screw, other: Screw) -> tuple[float, float]:
    """The cosine of the angle between two axes whose sense does not count, and their distance, 0 for a slide."""
    normal = cross(one.direction, other.direction)
    sine = length(normal)
    gap = minus(other.point, one.point)
    away = abs(dot(gap, normal)) / sine if sine > ALONG else length(across(gap, one.direction))
    return abs(dot(one.direction, other.direction)), away if one.turns and other.turns else 0.0


def _aimed(fit: Fit, one: Vector, other: Vector, limits: Limits) -> Fit | None:
    """Those maps that turn one direction into another."""
    here = fit.g.turned(one)
    if fit.anything:
        axis = cross(here, other)
        sine = length(axis)
        if sine <= limits.parallel:
            axis = next(a for unit in UNITS if length(a := cross(here, unit)) > 0.5)  # noqa: PLR2004  any will do
        turn = Rigid.turn(scaled(axis, 1 / length(axis)), math.atan2(sine, dot(here, other)))
        return Fit(turn @ fit.g, (other, ORIGIN), fit.spread, anything=False)
    if fit.line is not None and length(cross(here, fit.line[0])) > limits.parallel:
        axis, through = fit.line
        turn = Rigid.turn(axis, angle_about(axis, here, other), through)
        fit = Fit(turn @ fit.g, None, fit.spread, fit.anything)
        here = turn.turned(here)
    return fit if length(minus(here, other)) <= limits.turn else None


def released(held: Fit, screw: Screw) -> Fit:
    """The maps behind a joint: its zero is free."""
    if screw.turns:
        return Fit(held.g, (screw.direction, screw.point), held.spread, held.anything)
    new = minus(screw.direction, within(screw.direction, held.spread))
    if length(new) <= ALONG:  # it slides along it already
        return held
    return Fit(held.g, held.line, (*held.spread, scaled(new, 1 / length(new))), held.anything)


def slid(g: Rigid, held: Fit, screw: Screw) -> float:
    """How far a sliding joint has to go from a map that fits before it to one behind it."""
    new = minus(screw.direction, within(screw.direction, held.spread))
    if length(new) <= ALONG:  # it could as well be the base
        return 0.0
    through = ORIGIN if held.line is None else held.line[1]
    way = minus((g @ held.g.inverse()).moved(through), through)
    return dot(way, new) / dot(new, new)


def _solved(gap: Vector, spread: tuple[Vector, ...], along: Vector) -> tuple[Vector, Vector]:
    """A step in a span that closes a gap as seen along a direction, and what it leaves open."""
    step = ORIGIN
    pairs: list[tuple[Vector, Vector]] = []
    for unit in spread:
        seen, true = across(unit, along), unit
        for seen_before, true_before in pairs:
            share = dot(seen, seen_before)
            seen, true = plus(seen, seen_before, -share), plus(true, true_before, -share)
        size = length(seen)
        if size > 1e-6:  # noqa: PLR2004  else it only moves along the direction
            pairs.append((scaled(seen, 1 / size), scaled(true, 1 / size)))
    for seen, true in pairs:
        share = dot(gap, seen)
        step, gap = plus(step, true, share), plus(gap, seen, -share)
    return step, gap
