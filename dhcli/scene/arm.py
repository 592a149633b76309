"""A robot at a pose as a scene: drums and boxes at its joints, rods between, frames and dimensions over them."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from itertools import pairwise

from dhcli.geometry.vectors import ORIGIN, Vector, cross, dot, length, minus, plus, scaled
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.values import Values
from dhcli.scene.bodies import body_of
from dhcli.scene.fan import HALF, NEAR, Slid, fanned
from dhcli.scene.primitives import Anchor, Arrow, Box, Dimension, Drum, Hand, Plate, Rod, Scene, Solid
from dhcli.scene.skeleton import Axis, Skeleton
from dhcli.scene.vectors import Frame, sideways, unit
from dhcli.scene.words import Run, Words, joined

DRUM, LEAST_DRUM = 0.07, 0.045
"""Radius of a drum in parts of the extent of the arm, and the least one that keeps near joints apart."""

NEAR_JOINTS = 0.11
"""Joints nearer than this part of the extent are not kept apart by smaller drums; they fan out."""

BOX, ROD, ARROW, STAND = 1.0, 0.17, 3.0, 0.7
"""Half of a box, half of a rod, an axis of a frame, the stand under the first body, in radii of a drum."""

SAME = 1e-7
PARALLEL = 0.999


def arm_scene(robot: Robot, values: Values, size: float | None = None) -> Scene:
    """The scene of a robot.

    Args:
        robot: The robot.
        values: Value of each joint, length and constant angle.
        size: The radius of its drums [m]; by its extent at this pose unless another pose has set it.
    """
    skeleton = Skeleton.of(robot, values)
    size = size or drum_radius(skeleton)
    slid = fanned(skeleton, size)
    solids = tuple(_body(each, size) for each in slid)
    flat = is_planar(skeleton)
    plate = None if flat else _plate(skeleton, solids, slid, size)
    scene = Scene(
        states=skeleton.states,
        unit=size,
        solids=solids,
        rods=(*_rods(skeleton, slid, size), *_stand(plate, size)),
        arrows=tuple(arrows(skeleton.states, skeleton.numbered, size)),
        dimensions=tuple(_dimensions(skeleton)),
        plate=plate,
        pinned=(Anchor(0, ORIGIN),) if flat and robot.first == 1 else (),
    )
    return _with_hand(scene, skeleton, slid)


def drum_radius(skeleton: Skeleton) -> float:
    """The radius of the drums, by the extent of the arm and the distance between its joints [m]."""
    origins = [frame.origin for frame in skeleton.states]
    sides = [max(o[i] for o in origins) - min(o[i] for o in origins) for i in range(3)]
    extent = math.hypot(*sides)
    if extent <= 0:
        return DRUM
    places = [skeleton.place(axis)[0] for axis in skeleton.axes]
    gaps = [length(minus(b, a)) for a, b in pairwise(places)]
    wide = [gap for gap in gaps if gap > NEAR_JOINTS * extent]
    return min(DRUM * extent, max(min(wide, default=extent) * 0.45, LEAST_DRUM * extent))


def is_planar(skeleton: Skeleton) -> bool:
    """Whether the arm moves in the plane of x and y of its base: then it is seen from above."""
    turning = all(axis.kind == "revolute" for axis in skeleton.axes) and bool(skeleton.axes)
    level = all(abs(skeleton.place(axis)[1][2]) > PARALLEL for axis in skeleton.axes)
    heights = [frame.origin[2] for frame in skeleton.states]
    return turning and level and max(heights) - min(heights) < SAME * drum_radius(skeleton)


def _body(slid: Slid, size: float) -> Solid:
    axis = slid.axis
    centre = Anchor(axis.state, scaled(axis.direction, slid.shift))
    if axis.kind == "revolute":
        return Drum(axis.name, centre, axis.direction, size, HALF * size)
    return Box(axis.name, centre, axis.direction, sideways(axis.direction), BOX * size)


def _rods(skeleton: Skeleton, slid: tuple[Slid, ...], size: float) -> Iterator[Rod]:
    """Links along the moves, straight where one move goes along several axes; stubs to bodies that stand aside."""
    by_state: dict[int, list[Anchor]] = {}
    for leg in skeleton.legs:
        ends = by_state.setdefault(leg.state, [Anchor(leg.state, leg.start)])
        ends.append(Anchor(leg.state, leg.end))
    for state, ends in by_state.items():
        varies = any(leg.state == state and leg.variable for leg in skeleton.legs)
        yield Rod(ends[0], Anchor(state + 1, ORIGIN) if varies else ends[-1], (ROD * 0.8 if varies else ROD) * size)
    for each in slid:
        if each.stub:
            axis = each.axis
            yield Rod(Anchor(axis.state, scaled(axis.direction, each.shift)), Anchor(axis.state, ORIGIN), ROD * size)


def _plate(skeleton: Skeleton, solids: tuple[Solid, ...], slid: tuple[Slid, ...], size: float) -> Plate | None:
    """Where the arm stands: at its base, or under the body of its first joint if that reaches below it."""
    if skeleton.robot.first > 1 and slid:
        axis = slid[0].axis
        depth = abs(slid[0].shift) + (HALF + STAND) * size
        side = -1.0 if slid[0].shift <= 0 else 1.0
        away = scaled(axis.direction, side)
        return Plate(Anchor(axis.state, scaled(away, depth)), scaled(away, -1), size, broken=True)
    base = skeleton.states[0]
    depth = 0.0
    for body, each in zip(solids, slid, strict=True):
        point, direction = skeleton.place(each.axis)
        middle = plus(point, scaled(direction, each.shift))
        if isinstance(body, Drum):
            cosine = abs(dot(direction, base.z))
            below = body.half * cosine + body.radius * math.sqrt(max(0.0, 1 - cosine * cosine))
        else:
            below = getattr(body, "half", size)
        level = dot(minus(middle, base.origin), base.z)
        aside = minus(minus(middle, base.origin), scaled(base.z, level))
        if length(aside) < PLATE * size and level - below < SAME * size:
            depth = max(depth, below - level + STAND * size)
    if not skeleton.legs and not depth:
        depth = size
    return Plate(Anchor(0, (0.0, 0.0, -depth)), (0.0, 0.0, 1.0), PLATE * size)


PLATE = 2.9
"""Half of the side of the ground, in radii of a drum."""


def _stand(plate: Plate | None, size: float) -> Iterator[Rod]:
    """The piece between the ground and the place of the first joint."""
    if plate is not None and length(plate.centre.at) > 0:
        yield Rod(plate.centre, Anchor(plate.centre.state, ORIGIN), ROD * size)


def _with_hand(scene: Scene, skeleton: Skeleton, slid: tuple[Slid, ...]) -> Scene:
    """The same scene with a fork at the end of the arm, along its last piece or out of its last body."""
    if not skeleton.axes:
        return scene
    end, frame = len(skeleton.states) - 1, skeleton.states[-1]
    forward = _forward(skeleton, slid[-1])
    reach = 0.0
    for solid in scene.solids:
        span = body_of(scene, solid).span(frame.origin, forward)
        if span and span[1] > 0 and span[0] < NEAR * scene.unit:
            reach = max(reach, span[1])
    local = _local(frame, forward)
    wrist = scaled(local, reach + 0.5 * scene.unit if reach else 0.0)
    stem = (Rod(Anchor(end, ORIGIN), Anchor(end, wrist), ROD * scene.unit),) if reach else ()
    side: Vector = (0.0, 1.0, 0.0) if abs(local[1]) < 0.9 else (1.0, 0.0, 0.0)  # noqa: PLR2004  not along y
    if scene.plate is None and abs(local[2]) < 0.1:  # noqa: PLR2004  in the plane
        side = cross((0.0, 0.0, 1.0), local)
    side = unit(minus(side, scaled(local, dot(side, local))))
    return replace(scene, rods=(*scene.rods, *stem), hand=Hand(Anchor(end, wrist), local, side, HAND * scene.unit))


def _forward(skeleton: Skeleton, last: Slid) -> Vector:
    """Where the fingers point in the world."""
    for leg in reversed(skeleton.legs):
        start, stop = skeleton.ends(leg)
        if leg.state >= last.axis.state and length(minus(stop, start)) > 0:
            return unit(minus(stop, start))
    if _is_in_row(skeleton) and not last.shift:
        return skeleton.states[-1].x
    return scaled(skeleton.place(last.axis)[1], 1.0 if last.shift >= 0 else -1.0)


HAND = 1.5


def _is_in_row(skeleton: Skeleton) -> bool:
    """Whether the last joint turns as the one before does, so that its hand lies in their plane."""
    axes: list[Axis] = [axis for axis in skeleton.axes if axis.kind == "revolute"]
    if len(axes) < 2:  # noqa: PLR2004  two to compare
        return False
    last, before = (skeleton.place(axis)[1] for axis in axes[:-3:-1])
    return abs(dot(last, before)) > PARALLEL


def _local(frame: Frame, direction: Vector) -> Vector:
    return dot(direction, frame.x), dot(direction, frame.y), dot(direction, frame.z)


def arrows(states: tuple[Frame, ...], numbered: tuple[tuple[str, int], ...], size: float) -> Iterator[Arrow]:
    """The x and z axes of all frames; what is the same arrow stands once, with all of its names."""
    merged: list[tuple[Vector, Vector, str, int, list[Words]]] = []
    for name, state in numbered:
        frame = states[state]
        for letter, direction in (("x", frame.x), ("z", frame.z)):
            words = (Run(letter), Run(name, below=True))
            for origin, known, kind, _, names in merged:
                is_same = length(minus(direction, known)) < SAME and length(minus(frame.origin, origin)) < SAME * size
                if kind == letter and is_same:
                    names.append(words)
                    break
            else:
                merged.append((frame.origin, direction, letter, state, [words]))
    for origin, direction, letter, state, names in merged:
        local: Vector = (1.0, 0.0, 0.0) if letter == "x" else (0.0, 0.0, 1.0)
        under = letter == "x" and any(
            kind == "z" and length(minus(direction, other)) < SAME and length(minus(origin, start)) < SAME * size
            for start, other, kind, _, _ in merged
        )  # an x axis along a z axis is shorter, so that both heads are seen
        reach = ARROW * size * (0.62 if under else 1.0)
        yield Arrow(Anchor(state, ORIGIN), local, "x" if letter == "x" else "z", joined(names), reach)


def _dimensions(skeleton: Skeleton) -> Iterator[Dimension]:
    states = [leg.state for leg in skeleton.legs]
    for leg in skeleton.legs:
        varies, alone = bool(leg.variable), states.count(leg.state) == 1
        end = Anchor(leg.state + 1, ORIGIN) if varies and alone else Anchor(leg.state, leg.end)
        yield Dimension(Anchor(leg.state, leg.start), end, leg.words, variable=varies, direct=not alone)
