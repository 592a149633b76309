"""A motion as scenes: an arm on its way from one pose to another, or through the rows of a file."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any, TypeAlias

from dhcli.errors import plural
from dhcli.frozen import frozen
from dhcli.geometry.vectors import Vector
from dhcli.kinematics.derived import in_floats
from dhcli.kinematics.robot import Robot, Value
from dhcli.kinematics.values import JointInput
from dhcli.notation.angle import Angle
from dhcli.notation.tree import Number
from dhcli.scene.arm import arm_scene
from dhcli.scene.camera import Camera
from dhcli.scene.overlay import pins
from dhcli.scene.painter import painted
from dhcli.scene.primitives import Scene
from dhcli.scene.shapes import Figure, Shape
from dhcli.scene.skeleton import Skeleton
from dhcli.scene.staging import (
    LARGEST_DRUM,
    MARGIN,
    ArmAt,
    Paper,
    extent,
    foot,
    posed,
    value_words,
)
from dhcli.scene.vectors import Flat

Path: TypeAlias = Sequence[Sequence[float]]
"""Joint values of each moment, radians and metres in joint order, shape (N, n)."""

WAY = 24
"""Pieces in which the way from one pose to another is drawn."""

MOST_SCENES = 48
"""Moments of a longer path that are drawn, evenly among its rows."""

SHRUNK = 0.55
"""The largest radius of a drum in a motion, in parts of that in a figure."""


@frozen
class Motion:
    """An arm on its way.

    Attributes:
        robot: The arm.
        scenes: The arm at each moment; its drums are everywhere as large as at the first.
        places: Where its end is at every step of the way, moments and those between them [m].
        steps: The step at which each moment is.
        view: Azimuth and elevation [deg].
        caption: What is shown.
        values: The joint values of each moment, in joint order.
    """

    robot: Robot
    scenes: tuple[Scene, ...]
    places: tuple[Vector, ...]
    steps: tuple[int, ...]
    view: tuple[float, float]
    caption: str
    values: tuple[str, ...] = ()

    def shapes(self, moment: int, camera: Camera) -> list[Shape]:
        """The arm at a moment, with the way of its end so far."""
        scene = self.scenes[moment]
        drawn = [*pins(scene, camera, scene.pinned), *painted(scene, camera, turns=False)]
        way: tuple[Flat, ...] = tuple(map(camera.flat, self.places[: self.steps[moment] + 1]))
        return [*drawn, Shape(way, "trace")] if len(way) > 1 else drawn

    def camera(self, room: tuple[float, float, float, float], largest: float) -> Camera:
        """One camera for all moments, so that what stands still does.

        Args:
            room: Left, top, right and bottom of where the arm may be [px].
            largest: The largest radius of a drum [px].
        """
        points = [point for scene in self.scenes for point in extent(replace(scene, arrows=()))]
        return Camera.at(*self.view).fitted([*points, *self.places], room, largest / self.scenes[0].unit)


def motion_of(arm: ArmAt, to: JointInput = None, rows: Path = ()) -> Motion:
    """The motion of an arm to another pose, every joint evenly, or through rows of joint values.

    Args:
        arm: The arm where it starts, for rows at no joint values.
        to: Joint values or the name of a pose where it ends.
        rows: Joint values of each moment instead of all of these.
    """
    robot = arm.robot
    path = [joints_of(robot, row) for row in rows]
    start: Any = path[0] if path else arm.q
    arm = replace(arm, q=start)
    first, full = arm.staged(), arm.values()
    told = plural(len(path), "row")
    if not path:
        from_ = {name: full[name] for name in robot.variables}
        told, end = posed(robot, to, None, full, arm.bare)
        path = [between(from_, end, k / WAY) for k in range(WAY + 1)]
    count = min(len(path), MOST_SCENES + 1)
    steps = tuple(round(k * (len(path) - 1) / max(count - 1, 1)) for k in range(count))
    scenes = [arm_scene(robot, {**full, **path[step]}, first.scene.unit) for step in steps]
    if (hand := first.scene.hand) is not None:  # one way for all moments
        scenes = [replace(one, hand=replace(one.hand, across=hand.across)) if one.hand else one for one in scenes]
    places = [scene.states[-1].origin for scene in scenes]
    if count < len(path):
        places = [Skeleton.of(robot, {**full, **row}).states[-1].origin for row in path]
    values = tuple(", ".join(value_words(path[step][name]) for name in robot.variables) for step in steps)
    return Motion(robot, tuple(scenes), tuple(places), steps, first.view, f"{first.caption} to {told}", values)


def moments(motion: Motion) -> list[Figure]:
    """A figure of each moment, all in one place on paper: what an animation shows one after the other."""
    paper, title = Paper(), motion.robot.title
    room = (MARGIN * 0.5, MARGIN * 0.5, paper.width - MARGIN * 0.5, paper.height - paper.foot - MARGIN * 0.3)
    camera = motion.camera(room, LARGEST_DRUM)
    texts = tuple(foot(title, motion.caption, paper))
    drawn = (tuple(motion.shapes(k, camera)) for k in range(len(motion.scenes)))
    return [Figure(paper.width, paper.height, shapes, texts, title, motion.caption) for shapes in drawn]


def between(start: Mapping[str, Value], end: Mapping[str, Value], part: float) -> dict[str, Value]:
    """Joint values on the straight way between two; exactly those at its ends."""
    if part in (0.0, 1.0):
        return dict(end if part else start)
    return {
        name: _like(low, in_floats(low) + part * (in_floats(end[name]) - in_floats(low))) for name, low in start.items()
    }


def joints_of(robot: Robot, row: Sequence[float]) -> dict[str, Value]:
    """Joint values of a row as exact ones."""
    kinds = {joint.name: Angle() if joint.kind == "revolute" else Number(Fraction(0)) for joint in robot.joints}
    return {name: _like(kinds[name], value) for name, value in zip(robot.variables, row, strict=True)}


def _like(value: Value, number: float) -> Value:
    exact = Fraction(number).limit_denominator(10**12)
    return Angle(radians=exact) if isinstance(value, Angle) else Number(exact)
