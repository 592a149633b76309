"""A spatial linkage as a scene: drums, balls and boxes at its joints, rods and plates for its links."""

from __future__ import annotations

from collections.abc import Iterator

from dhcli.geometry.vectors import Vector, plus
from dhcli.mobility.linkage import Joint, Linkage
from dhcli.scene.fan import HALF, STEP
from dhcli.scene.places import Places, corners, farthest, is_straight
from dhcli.scene.primitives import Anchor, Ball, Box, Drum, Face, Mark, Rod, Scene, Solid
from dhcli.scene.vectors import WORLD, sideways, unit
from dhcli.scene.words import named

SIZE, ROD = 0.036, 0.2
"""Radius of a drum in parts of the extent; half of a rod in radii of a drum."""

TURNING = frozenset({"revolute", "cylindrical", "helical"})
SHAFT = 5.0


def space_scene(linkage: Linkage) -> Scene:
    """The scene of a linkage in space that is placed; each link is a state, so that what it holds moves with it."""
    places = Places(linkage)
    state = {link: number for number, link in enumerate(linkage.links)}
    size = SIZE * places.size if len({tuple(p) for p in places.at}) > 1 else 0.09
    slid = [_shift(places, i, size) for i in range(len(linkage.joints))]
    solids = [
        body
        for joint, at, shift in zip(linkage.joints, places.at, slid, strict=True)
        for body in _bodies(joint, at, shift, size, state[joint.links[0]])
    ]
    rods: list[Rod] = []
    for joint, at, shift in zip(linkage.joints, places.at, slid, strict=True):
        if shift and joint.axis:
            rods.append(_rod(at, plus(at, unit(joint.axis), shift), size, state[joint.links[0]]))
        rods += _arms(joint, at, size, state)
    for link, points in places.links.items():
        made, faces = _link(linkage, state[link], points, places.size, size)
        rods += made
        solids += faces
    rods += list(_shafts(places, slid, size, state))
    marks = tuple(Mark(Anchor(state[holder(places, at)], at), named(name)) for name, at in places.named())
    return Scene((WORLD,) * len(state), size, tuple(solids), tuple(rods), marks=marks)


def holder(places: Places, at: Vector) -> str:
    """The link that holds a point: one that may move, if there is one."""
    ground = places.linkage.ground
    holders = [link for link, held in places.links.items() if any(places.same(at, point) for point in held)]
    return next((link for link in holders if link != ground), holders[0] if holders else ground)


def _shift(places: Places, number: int, size: float) -> float:
    """How far the body of a joint slides along its axis because others share its place."""
    joint, at = places.linkage.joints[number], places.at[number]
    if joint.pair.name not in TURNING:
        return 0.0
    sharing = [i for i, other in enumerate(places.at) if places.same(at, other)]
    if len(sharing) == 1:
        return 0.0
    return STEP * size * (-1 if number == sharing[0] else 1)


def _bodies(joint: Joint, at: Vector, shift: float, size: float, state: int) -> Iterator[Solid]:
    if joint.pair.name in TURNING and joint.axis:
        axis = unit(joint.axis)
        yield Drum(joint.name, Anchor(state, plus(at, axis, shift)), axis, size, HALF * size)
    elif joint.pair.name == "prismatic" and joint.axis:
        yield Box(joint.name, Anchor(state, at), unit(joint.axis), sideways(joint.axis), size)
    elif joint.pair.name in ("spherical", "universal"):
        yield Ball(Anchor(state, at), 0.8 * size)


def _arms(joint: Joint, at: Vector, size: float, state: dict[str, int]) -> Iterator[Rod]:
    """The cross of a universal joint, each arm in the bearings of its link."""
    if joint.pair.name == "universal" and joint.axis and joint.axis2:
        for link, axis in zip(joint.links, (joint.axis, joint.axis2), strict=True):
            ends = [Anchor(state[link], plus(at, unit(axis), s * 1.7 * size)) for s in (-1, 1)]
            yield Rod(ends[0], ends[1], 0.12 * size)


def _link(
    linkage: Linkage, state: int, points: list[Vector], extent: float, size: float
) -> tuple[list[Rod], list[Face]]:
    """A rod between two points, a plate through three and more."""
    is_ground = linkage.links[state] == linkage.ground
    if len(points) < 2:  # noqa: PLR2004  nothing between
        return [], []
    if len(points) > 2 and not is_straight(points, extent):  # noqa: PLR2004  a plate
        around = corners(points)
        return [], [Face(tuple(Anchor(state, p) for p in around), ground=is_ground)]
    a, b = farthest(points)
    return [Rod(Anchor(state, a), Anchor(state, b), ROD * size, ground=is_ground)], []


def _shafts(places: Places, slid: list[float], size: float, state: dict[str, int]) -> Iterator[Rod]:
    """Shafts of links that have but one place: out of the drum along its axis."""
    for joint, at, shift in zip(places.linkage.joints, places.at, slid, strict=True):
        if not shift or not joint.axis:
            continue
        axis, side = unit(joint.axis), 1 if shift > 0 else -1
        short = [link for link in joint.links if len(places.links[link]) < 2]  # noqa: PLR2004  one place
        if short:
            held = state[short[0]]
            start, end = plus(at, axis, shift), plus(at, axis, shift + side * SHAFT * 0.6 * size)
            yield Rod(Anchor(held, start), Anchor(held, end), ROD * size, ground=places.linkage.ground in joint.links)


def _rod(start: Vector, end: Vector, size: float, state: int) -> Rod:
    return Rod(Anchor(state, start), Anchor(state, end), ROD * size)
