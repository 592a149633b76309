"""Two tables of one arm in one picture: the right one drawn, the other a line over it, the first difference marked."""

from __future__ import annotations

import math

from dhcli.errors import RobotError
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.values import JointInput, Values, require
from dhcli.notation.quantity import Bare
from dhcli.scene.arm import arrows
from dhcli.scene.camera import Camera
from dhcli.scene.choice import with_examples
from dhcli.scene.ink import Ink
from dhcli.scene.labels import Rect, Wish, placed
from dhcli.scene.overlay import frames
from dhcli.scene.painter import painted
from dhcli.scene.primitives import Arrow
from dhcli.scene.shapes import Figure, Shape, arrowhead, ring
from dhcli.scene.skeleton import Skeleton
from dhcli.scene.staging import Paper, fitted, foot, stage_arm, values_at
from dhcli.scene.vectors import Frame, along, norm, sub
from dhcli.scene.words import Run, Words

CLOSE = 1e-6
"""Frames nearer than this are the same: directions, and positions in parts of a drum's radius."""


def beside_figure(  # noqa: PLR0913  what a figure of one robot takes, and the other
    robot: Robot,
    other: Robot,
    q: JointInput = None,
    *,
    pose: str | None = None,
    view: tuple[float, float] | None = None,
    parameters: Values | None = None,
    bare: Bare = "rad",
    paper: Paper | None = None,
) -> Figure:
    """The figure of a robot with another table of it over it, at the same joint values.

    Args:
        robot: The robot that is right.
        other: The other table; its lengths are those of the robot where they have the same names.
        q: Joint values, as `forward` takes them; by default the pose that shows the robot best.
        pose: The name of a pose instead.
        view: Azimuth and elevation [deg].
        parameters: Lengths and angles instead of the robot's own.
        bare: What a number without a unit means for a joint that turns.
        paper: What it is drawn on.

    Raises:
        RobotError: The two have not the same joints; a length has no value.
    """
    paper = paper or Paper()
    if robot.pattern != other.pattern:
        counts = (
            f"{robot.name} is {robot.pattern or 'without joints'}, {other.name} {other.pattern or 'without joints'}"
        )
        raise RobotError(f"the two arms have not the same joints: {counts}")
    staged = stage_arm(robot, q, pose=pose, view=view, parameters=parameters, bare=bare)
    values = values_at(robot, q, pose, parameters, bare)
    theirs = _values(other, robot, values)
    skeleton = Skeleton.of(other, theirs)
    number = first_difference(Skeleton.of(robot, values), skeleton, staged.scene.unit)
    camera = fitted(staged.scene, staged.view, paper, [frame.origin for frame in skeleton.states])
    shapes = painted(staged.scene, camera, turns=False)
    axes, wishes = frames(staged.scene, camera)
    line = [camera.flat(point) for leg in skeleton.legs for point in skeleton.ends(leg)]
    lines = [Shape(tuple(line), "theirs")] if line else []
    for arrow in arrows(skeleton, 0.8 * staged.scene.unit):
        drawn, wish = _their_arrow(arrow, skeleton.states[arrow.start.state], camera)
        lines += drawn
        if number is not None and any(run.text == number for run in arrow.words if run.below):
            wishes.append(wish)
    if number is not None:
        at = camera.flat(skeleton.states[dict(skeleton.numbered)[number]].origin)
        lines.append(Shape(ring(at, 13.0, 28), "theirs-mark", closed=True))
    ink = Ink(paper.width, paper.height)
    ink.add([*shapes, *axes, *lines])
    leaders, texts = placed(
        wishes, ink, Rect(3, 3, paper.width - 3, paper.height - max(paper.foot, 3)), paper.lettering
    )
    told = "no frame differs" if number is None else f"frame {number} is the first that differs"
    caption = f"{staged.caption} · over it {other.name}: {told}"
    everything = (*shapes, *leaders, *axes, *lines)
    return Figure(
        paper.width, paper.height, everything, (*texts, *foot(robot.title, caption, paper)), robot.title, caption
    )


def first_difference(right: Skeleton, other: Skeleton, unit: float) -> str | None:
    """The first numbered frame in which two tables differ; of two conventions, and of tables of two lengths, the last.

    Args:
        right: The robot that is right, at a pose.
        other: The other, at the same pose.
        unit: The length against which a distance is small [m].
    """
    ours, theirs = right.numbered, other.numbered
    pairs = list(zip(ours, theirs, strict=False))
    if right.robot.convention is not other.robot.convention or len(ours) != len(theirs):
        pairs = [(ours[-1], theirs[-1])]
    for (_, one), (name, two) in pairs:
        if not same(right.states[one], other.states[two], unit):
            return name
    return None


def same(one: Frame, other: Frame, unit: float) -> bool:
    """Whether two frames are in one place with the same directions."""
    turned = max(norm(sub(a, b)) for a, b in zip(one[:3], other[:3], strict=True))
    return turned < CLOSE and norm(sub(one.origin, other.origin)) < CLOSE * max(unit, 1e-300)


def _values(other: Robot, robot: Robot, values: Values) -> Values:
    """The other table's values: joints in their order, lengths by their names."""
    joints = [values[name] for name in robot.variables]
    named = {name: values[name] for name in other.parameters if name in values}
    full, _ = with_examples(other, named)
    given = {**full, **dict(zip(other.variables, joints, strict=True))}
    require(other, other.chain, given)
    return given


def _their_arrow(arrow: Arrow, frame: Frame, camera: Camera) -> tuple[list[Shape], Wish]:
    tail = camera.flat(frame.origin)
    tip = camera.flat(along(frame.origin, frame.direction(arrow.direction), arrow.length))
    words: Words = tuple(Run(run.text + "′", below=True) if run.below else run for run in arrow.words)
    wish = Wish((tip,), words, "theirs", (tip[0] - tail[0], tip[1] - tail[1]))
    if math.dist(tail, tip) < 1:
        return [], wish
    return [Shape((tail, tip), "theirs"), Shape(arrowhead(tip, tail, 8.0), "theirs-head", closed=True)], wish
