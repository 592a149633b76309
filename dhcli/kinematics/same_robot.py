"""Whether two chains are the same robot: `T'(q) = B · T(σq + q0) · E` for all q.

In the zero pose a robot is its joint axes and its end frame: `T(q) = exp(ξ1 q1) ... exp(ξn qn) M`, and setting all but
one variable to zero shows that T determines every ξ and M. So the two are the same exactly if rigid maps g0 = B, g1,
..., gn exist with `σ_i g_{i-1} ξ_i = ξ'_i` and `g_i = g_{i-1} exp(ξ_i q0_i)`. The maps that fit joints 1 to i form a
set `{T(v) · R(line, t) · g}`: translations in a subspace, rotations about one line or none. Each joint cuts it down:
a revolute axis must fall on its line, a prismatic one on its direction; then its own zero sets it free again. Only the
senses σ are searched; everything else is solved in closed form, and the result is checked on the chains themselves.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from enum import Enum
from itertools import islice

from dhcli.algebra.points import draws
from dhcli.frozen import frozen
from dhcli.geometry.rigid import Rigid
from dhcli.geometry.vectors import length, minus, scaled, within
from dhcli.kinematics.axes import Arm, Point
from dhcli.kinematics.fits import Fit, Limits, held_by, released, slid

POSES = 4
SEED = 11
MOST_LEAVES = 64
RATE = 1e-9


@frozen
class Match:
    """How one robot is another: `T'(q) = B · T(σq + q0) · E`.

    Attributes:
        base: B.
        senses: σ of each joint.
        zeros: q0 of each joint [rad or m].
        tool: E.
        maps: g0 to gn, from the zero pose of the right robot to that of the other.
    """

    base: Rigid
    senses: tuple[int, ...]
    zeros: tuple[float, ...]
    tool: Rigid
    maps: tuple[Rigid, ...]


class Miss(Enum):
    """What keeps the first axis that differs from agreeing."""

    MOTION = "it turns where the other slides, or moves by another amount"
    DIRECTION = "it points another way"
    PLACE = "it lies elsewhere"


class Registration:
    """The search for the maps between two robots at one point.

    Attributes:
        deepest: How many joints from the first one agree.
        miss: What keeps the next one from agreeing.
    """

    def __init__(self, truth: Arm, other: Arm, point: Point, limits: Limits, *, end_free: bool = False) -> None:
        """Compare `other` with `truth`; `end_free` leaves the last frame out of it."""
        self.truth, self.end = truth.screws(point)
        self.other, self.other_end = other.screws(point)
        self.limits = limits
        self.end_free = end_free
        self.deepest = 0
        self.miss = Miss.MOTION

    def matches(self) -> Iterator[Match]:
        """Every way to register the two, senses unchanged first."""
        names = [screw.name for screw in self.truth]
        if names == [screw.name for screw in self.other]:
            yield from self._search(Fit(), (), ())

    def _search(self, fit: Fit, trail: tuple[Fit, ...], senses: tuple[int, ...]) -> Iterator[Match]:
        index = len(trail)
        if index > self.deepest:
            self.deepest, self.miss = index, Miss.MOTION
        if index == len(self.truth):
            ended = self._ended(fit)
            if ended is not None:
                yield self._match(ended, trail, senses)
            return
        one, other = self.truth[index], self.other[index]
        if one.turns is not other.turns or abs(one.rate - other.rate) > RATE * one.rate or not one.rate:
            return
        for sense in (1, -1):
            aim = scaled(other.direction, sense)
            held = held_by(fit, one, replace(other, direction=aim), self.limits)
            if held is not None:
                yield from self._search(released(held, other), (*trail, held), (*senses, sense))
            elif index == self.deepest and self.miss is not Miss.PLACE:
                aimed = held_by(fit, replace(one, turns=False), replace(other, direction=aim), self.limits)
                self.miss = Miss.DIRECTION if aimed is None else Miss.PLACE

    def _ended(self, fit: Fit) -> Fit | None:
        """The map that also brings the end frames together, as far as may be."""
        if fit.anything:
            return replace(fit, g=self.other_end @ self.end.inverse())
        found = self._brought(fit)
        if fit.line is not None:
            axis, through = fit.line
            apart = self.other_end @ (fit.g @ self.end).inverse()
            turn = Rigid.turn(axis, apart.angle_about(axis), through)
            turned = self._brought(replace(fit, g=turn @ fit.g))
            if self._is_together(turned) or not self.end_free:
                found = turned
        return found if self.end_free or self._is_together(found) else None

    def _brought(self, fit: Fit) -> Fit:
        """The map moved as its translations allow, until the end frames are nearest."""
        gap = minus(self.other_end.offset, (fit.g @ self.end).offset)
        return replace(fit, g=Rigid.shift(within(gap, fit.spread)) @ fit.g)

    def _is_together(self, fit: Fit) -> bool:
        apart = (fit.g @ self.end).inverse() @ self.other_end
        return apart.tilt() <= self.limits.turn and length(apart.offset) <= self.limits.shift

    def _match(self, fit: Fit, trail: tuple[Fit, ...], senses: tuple[int, ...]) -> Match:
        """Go back from the last map to the first; what each joint undoes is its zero."""
        maps = [fit.g]
        zeros: list[float] = []
        for index in range(len(trail) - 1, -1, -1):
            held, screw, g = trail[index], self.other[index], maps[-1]
            if screw.turns:
                way = g if index == 0 else g @ held.g.inverse()
                by = way.angle_about(screw.direction) if index == 0 or held.line is None else 0.0
                g = Rigid.turn(screw.direction, -by, screw.point) @ g
            else:
                by = slid(g, held, screw)
                g = Rigid.shift(scaled(screw.direction, -by)) @ g
            maps.append(g)
            zeros.append(senses[index] * by / screw.rate)
        tool = (fit.g @ self.end).inverse() @ self.other_end
        return Match(maps[-1], senses, tuple(reversed(zeros)), tool, tuple(reversed(maps)))


def error_of(
    match: Match, truth: Arm, other: Arm, point: Point, size: float, enough: tuple[float, float]
) -> tuple[float, float]:
    """Largest difference between `T'(q)` and `B T(σq + q0) E` at seeded poses: of a direction cosine, and [m].

    No more poses are looked at once the differences are larger than is `enough`.
    """
    turn = shift = 0.0
    reach = {screw.name: math.pi if screw.turns else size for screw in truth.screws(point)[0]}
    for q in islice(draws({name: (-far, far) for name, far in reach.items()}, SEED), POSES):
        there = {
            name: sense * q[name] + zero
            for name, sense, zero in zip(truth.variables, match.senses, match.zeros, strict=True)
        }
        one = match.base @ truth.pose(point, there) @ match.tool
        two = other.pose(point, q)
        turn = max(
            turn, *(abs(x - y) for r, s in zip(one.rows, two.rows, strict=True) for x, y in zip(r, s, strict=True))
        )
        shift = max(shift, length(minus(one.offset, two.offset)))
        if not all(math.isfinite(x) for pose in (one, two) for row in pose.motion for x in row):
            return math.inf, math.inf  # what is no number agrees with nothing
        if turn > enough[0] or shift > enough[1]:
            break
    return turn, shift


def identity(truth: Arm) -> Match:
    """The claim that two robots have the same motion between the same frames."""
    count = len(truth.variables)
    return Match(Rigid(), (1,) * count, (0.0,) * count, Rigid(), (Rigid(),) * (count + 1))
