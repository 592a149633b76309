"""Which pose shows a robot best, and from where: by score, so that a figure needs no hand."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise

from dhcli.geometry.vectors import cross, dot, length, minus, plus
from dhcli.kinematics.derived import in_floats
from dhcli.kinematics.robot import Joint, Robot, Value
from dhcli.kinematics.values import Values, parameter_values
from dhcli.notation.angle import Angle
from dhcli.notation.tree import Number
from dhcli.scene.bodies import body_of
from dhcli.scene.camera import Camera
from dhcli.scene.primitives import Arrow, Hand, Scene
from dhcli.scene.skeleton import Skeleton
from dhcli.scene.vectors import Frame, unit

SEEN_FROM = tuple(
    (az, el) for el in (26.0, 18.0, 34.0) for az in (37.0, 25.0, 52.0, -37.0, -52.0, 128.0, 143.0, -143.0)
)
"""The views that are tried, the best known first: it wins where others are hardly better."""

BIAS = 0.006
LOOKED_AT, HIDDEN = 8, 3.5
"""How many views are tried for what hides what, which costs more, and the weight of that."""

EXAMPLE_ANGLES = (35, 50, -70, 40, 55, 30)
"""An example pose for robots without a good one of their own [deg]."""


def with_examples(robot: Robot, values: Values) -> tuple[dict[str, Value], list[str]]:
    """The values of all lengths and constant angles; where one has none, an example, and which those are."""
    full, made = {**parameter_values(robot, {}), **values}, []
    count = 0
    for name, value in robot.parameters.items():
        if value is None and name not in full:
            if name in robot.angles:
                full[name] = Angle.in_degrees(60)
            else:
                full[name] = Number(Fraction(40 - 10 * (count % 2), 100), 2)
                count += 1
            made.append(name)
    return full, made


def best_pose(robot: Robot, parameters: Values) -> tuple[str, dict[str, Value]]:
    """The pose that shows a robot best: one of its own, or an example.

    Returns:
        Its name, empty for an example, and a value for each joint.
    """
    best: tuple[float, str, dict[str, Value]] = (-math.inf, "", {})
    for name, values in poses(robot, parameters):
        score = pose_score(Skeleton.of(robot, {**parameters, **values})) - (0.0 if name else 0.8)
        if score > best[0] + 1e-9:
            best = score, name, values
    return best[1], best[2]


def pose_score(skeleton: Skeleton) -> float:
    """How well a pose tells the parts of a robot apart: bends, oblique links, joints and frames apart."""
    directions = []
    for leg in skeleton.legs:
        start, end = skeleton.ends(leg)
        if length(minus(end, start)) > 0:
            directions.append(unit(minus(end, start)))
        else:
            directions.append((0.0, 0.0, 0.0))  # a slider at its zero shows nothing
    pairs = list(pairwise(directions))
    bends = _mean([1 - abs(dot(a, b)) ** 4 for a, b in pairs])
    oblique = _mean([min(1.0, 2 * (1 - max(map(abs, d)))) if any(d) else -1.0 for d in directions])
    places = [frame.origin for _, frame in _frames(skeleton)]
    distinct = len({tuple(round(x, 9) for x in place) for place in places}) / max(len(places), 1)
    axes = [frame.z for _, frame in _frames(skeleton)]
    turned = _mean([1 - abs(dot(a, b)) ** 4 for a, b in zip(axes, axes[2:], strict=False)])
    spread = _extent(skeleton)
    return bends + 0.6 * oblique + 1.5 * distinct + 0.5 * turned + 0.3 * spread


def best_view(scene: Scene) -> tuple[float, float]:
    """The view with least foreshortening and the joints apart."""
    cheap = [(view_score(scene, Camera.at(*view)) - BIAS * i, view) for i, view in enumerate(SEEN_FROM)]
    hopeful = sorted(cheap, key=lambda each: -each[0])[:LOOKED_AT]
    hidden = hiding(scene)
    return max(hopeful, key=lambda each: each[0] - HIDDEN * hidden(Camera.at(*each[1])))[1]


def view_score(scene: Scene, camera: Camera) -> float:
    """How much of the lengths and axes of a scene a view shows, and how far apart its bodies look."""
    shown = []
    for dimension in scene.dimensions:
        way = minus(scene.point(dimension.end), scene.point(dimension.start))
        size = length(way)
        if size > 0:
            seen = math.hypot(*camera.flat_direction(way)) / size
            shown.append(min(seen, 0.75))
    axes = [math.hypot(*camera.flat_direction(scene.direction(a.start.state, a.direction))) for a in scene.arrows]
    clear = [min(seen, 0.5) for seen in axes]
    middles = [scene.point(body.centre) for body in scene.solids if hasattr(body, "centre")]
    apart = []
    for i, one in enumerate(middles):
        for other in middles[i + 1 :]:
            seen = math.hypot(*camera.flat_direction(minus(other, one)))
            apart.append(min(1.0, seen / (3 * scene.unit)))
    clearness = _mean(clear) + 0.5 * min(clear, default=0.5)
    return 1.5 * _mean(shown) + clearness + 2.5 * _mean(apart) + _tips(scene, camera) + _corners(scene, camera)


def hiding(scene: Scene) -> Callable[[Camera], float]:
    """What tells of a view which part of all bodies and rods is hidden by bodies in front of them."""
    bodies = [body_of(scene, solid) for solid in scene.solids]
    points = [(i, point) for i, body in enumerate(bodies) for point in body.samples()[::3]]
    for rod in scene.rods:
        start, end = scene.point(rod.start), scene.point(rod.end)
        points += [(-1, plus(start, minus(end, start), t / 6)) for t in range(1, 6)]

    def hidden(camera: Camera) -> float:
        found = 0
        for owner, point in points:
            for number, body in enumerate(bodies):
                span = None if number == owner else body.span(point, camera.towards)
                if span and span[0] > 0:
                    found += 1
                    break
        return found / max(len(points), 1)

    return hidden


def _corners(scene: Scene, camera: Camera) -> float:
    """How well corners between links look like corners; one that looks straight is a trap."""
    ways = [minus(scene.point(rod.end), scene.point(rod.start)) for rod in scene.rods]
    seen = []
    for one, other in pairwise(ways):
        if length(cross(unit(one), unit(other))) > 0.3:  # noqa: PLR2004  a corner in space
            (a, b), (c, d) = camera.flat_direction(one), camera.flat_direction(other)
            lengths = math.hypot(a, b) * math.hypot(c, d)
            seen.append(min(1.0, 2 * abs(a * d - b * c) / lengths) if lengths > 0 else 0.0)
    return _mean(seen)


def _tips(scene: Scene, camera: Camera) -> float:
    """How far apart the tips of arrows at one origin look; two that fall together cannot be told apart."""
    worst = 1.0
    by_state: dict[tuple[float, ...], list[Arrow]] = {}
    for arrow in scene.arrows:
        place = tuple(round(x / scene.unit, 6) for x in scene.point(arrow.start))
        by_state.setdefault(place, []).append(arrow)
    for group in by_state.values():
        tips = [camera.flat_direction(scene.direction(a.start.state, a.direction)) for a in group]
        for i, one in enumerate(tips):
            for other in tips[i + 1 :]:
                worst = min(worst, math.dist(one, other) * 2)
    return 0.6 * worst


def poses(robot: Robot, parameters: Values) -> Iterator[tuple[str, dict[str, Value]]]:
    """The poses of a robot by name, and an example without one, at which no angle is special."""
    for name, values in robot.poses.items():
        yield name, dict(zip(robot.variables, values, strict=True))
    yield "", {joint.name: _example(robot, joint, i, parameters) for i, joint in enumerate(robot.joints)}


def _example(robot: Robot, joint: Joint, number: int, parameters: Values) -> Value:
    """A value for one joint of the example pose, within its limits."""
    name = joint.name
    low, high = (in_floats(limit) for limit in robot.limits[name]) if name in robot.limits else (-math.inf, math.inf)
    if joint.kind == "revolute":
        wanted = EXAMPLE_ANGLES[number % len(EXAMPLE_ANGLES)]
        if low <= math.radians(wanted) <= high:
            return Angle.in_degrees(wanted)
        return Angle.in_degrees(round(math.degrees((low + high) / 2)))
    lengths = [in_floats(v) for n, v in parameters.items() if n not in robot.angles and not isinstance(v, Angle)]
    size = max((abs(x) for x in lengths if x), default=0.5)
    wanted_length = min(max(size, low), high)
    return Number(Fraction(repr(round(wanted_length, 4))), 4)


def _frames(skeleton: Skeleton) -> list[tuple[str, Frame]]:
    return [(name, skeleton.states[state]) for name, state in skeleton.numbered]


def _extent(skeleton: Skeleton) -> float:
    """How much the arm fills the space around it: the least of its sides that is not the least, by the largest."""
    origins = [frame.origin for frame in skeleton.states]
    sides = sorted(max(o[i] for o in origins) - min(o[i] for o in origins) for i in range(3))
    return sides[1] / sides[2] if sides[2] > 0 else 0.0


def _mean(numbers: list[float]) -> float:
    return sum(numbers) / len(numbers) if numbers else 0.0


EDGE_ON = 0.25
"""Of a hand's width, what must be seen: a fork seen less wide passes for a stick."""


def broadside(scene: Scene, camera: Camera) -> Hand | None:
    """The hand, opening along its other axis where a reader would see it as one line."""
    hand = scene.hand
    if hand is None:
        return None
    other = cross(hand.forward, hand.across)
    seen, turned = (
        abs(dot(cross(*(scene.direction(hand.wrist.state, d) for d in (hand.forward, side))), camera.towards))
        for side in (hand.across, other)
    )
    return replace(hand, across=other) if seen < EDGE_ON < turned else hand
