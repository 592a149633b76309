"""A motion as a film strip: the arm at a few moments between two poses, side by side, with the way of its end."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction

from dhcli.kinematics.robot import Robot, Value
from dhcli.kinematics.validity import in_floats
from dhcli.kinematics.values import JointInput, Values
from dhcli.notation.angle import Angle
from dhcli.notation.quantity import Bare
from dhcli.notation.tree import Number
from dhcli.scene.arm import arm_scene
from dhcli.scene.camera import Camera
from dhcli.scene.overlay import pins
from dhcli.scene.painter import painted
from dhcli.scene.panels import moved
from dhcli.scene.primitives import Scene
from dhcli.scene.shapes import Figure, Shape, Text
from dhcli.scene.staging import LARGEST_DRUM, Paper, extent, foot, posed, stage_arm, values_at
from dhcli.scene.words import Run

MOMENTS = 5
"""Pictures of a strip."""

WAY = 24
"""Pieces in which the way of the end is drawn."""

CELL, HIGH = 250.0, 300.0
SHRUNK = 0.55
"""The largest radius of a drum in a strip, in parts of that in a figure."""


def strip_figure(
    robot: Robot,
    start: tuple[JointInput, str | None],
    end: JointInput,
    *,
    view: tuple[float, float] | None = None,
    parameters: Values | None = None,
    bare: Bare = "rad",
) -> Figure:
    """The film strip of a motion in which every joint goes evenly from one pose to another.

    Args:
        robot: The robot.
        start: Joint values, or the name of a pose, where it starts; the best pose if neither is given.
        end: Joint values or the name of a pose where it ends.
        view: Azimuth and elevation [deg]; the best view of the start by default.
        parameters: Lengths and angles instead of the robot's own.
        bare: What a number without a unit means for a joint that turns.
    """
    first = stage_arm(robot, start[0], pose=start[1], view=view, parameters=parameters, bare=bare)
    full = values_at(robot, start[0], start[1], parameters, bare)
    from_, (told, to) = {name: full[name] for name in robot.variables}, posed(robot, end, None, full, bare)
    scenes = [
        arm_scene(robot, {**full, **between(from_, to, k / WAY)}, first.scene.unit)  # drums as large as at the start
        for k in range(WAY + 1)
    ]
    shown = [scenes[round(k * WAY / (MOMENTS - 1))] for k in range(MOMENTS)]
    paper = Paper(CELL * MOMENTS, HIGH)
    camera = _camera(shown, first.view, paper)
    way = [camera.flat(scene.states[-1].origin) for scene in scenes]
    shapes: list[Shape] = []
    texts: list[Text] = []
    for k, scene in enumerate(shown):
        drawn = [*pins(scene, camera, scene.pinned), *painted(scene, camera, turns=False)]
        done = way[: round(k * WAY / (MOMENTS - 1)) + 1]
        drawn += [Shape(tuple(done), "trace")] if len(done) > 1 else []
        shapes += [moved(shape, (k * CELL, 0.0)) for shape in drawn]
        texts.append(Text(((k + 0.5) * CELL, 22.0), (Run(str(k + 1)),), "number", 15.0))
    shapes += [Shape(((k * CELL, 8.0), (k * CELL, HIGH - paper.foot)), "extension") for k in range(1, MOMENTS)]
    caption = f"{first.caption} to {told}"
    texts += foot(robot.title, caption, paper)
    return Figure(paper.width, paper.height, tuple(shapes), tuple(texts), robot.title, caption)


def between(start: Mapping[str, Value], end: Mapping[str, Value], part: float) -> dict[str, Value]:
    """Joint values on the straight way between two; exactly those at its ends."""
    if part in (0.0, 1.0):
        return dict(end if part else start)
    found: dict[str, Value] = {}
    for name, low in start.items():
        value = in_floats(low) + part * (in_floats(end[name]) - in_floats(low))
        exact = Fraction(value).limit_denominator(10**12)
        found[name] = Angle(radians=exact) if isinstance(low, Angle) else Number(exact)
    return found


def _camera(scenes: list[Scene], view: tuple[float, float], paper: Paper) -> Camera:
    """One camera for all moments, so that what stands still does."""
    points = [point for scene in scenes for point in extent(replace(scene, arrows=()))]
    room = (14.0, 34.0, CELL - 14.0, HIGH - paper.foot - 12.0)
    return Camera.at(*view).fitted(points, room, LARGEST_DRUM * SHRUNK / scenes[0].unit)
