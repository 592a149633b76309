"""Two tables of one arm in one picture: the right one drawn, the other beside it, the first difference marked.

The axes of the other are wide and pale under those of the arm, so that both are seen where they are the same.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

from dhcli.errors import RobotError
from dhcli.geometry.vectors import Vector, dot, length, minus, plus
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.values import Values, numbers, require
from dhcli.scene.arm import ARROW, arrows
from dhcli.scene.camera import Camera
from dhcli.scene.choice import with_examples
from dhcli.scene.ink import Ink
from dhcli.scene.labels import Wish, placed
from dhcli.scene.overlay import END_ON, HEAD, frames, pins
from dhcli.scene.painter import painted
from dhcli.scene.primitives import Arrow
from dhcli.scene.shapes import Figure, Shape, arrowhead, ring
from dhcli.scene.skeleton import Skeleton
from dhcli.scene.staging import ArmAt, Paper, fitted, foot
from dhcli.scene.traced import Traced, paired, traced
from dhcli.scene.vectors import Flat, Frame
from dhcli.scene.words import Run, Words

FAR = 4.0
"""How far from the base a picture reaches, in parts of the farthest frame of the arm."""

RIM = 3.5
"""How far an axis of the other is seen around the same axis of the arm [px]."""


def beside_figure(arm: ArmAt, other: Robot | Traced, paper: Paper | None = None) -> Figure:
    """The figure of a robot with another table of it over it, at the same joint values.

    Args:
        arm: The robot that is right.
        other: The other table, whose lengths are those of the robot where they have the same names; or frames at
            these joint values.
        paper: What it is drawn on.

    Raises:
        RobotError: The two have not the same joints; a length has no value.
    """
    robot, paper = arm.robot, paper or Paper()
    staged, values = arm.staged(), arm.values()
    skeleton = Skeleton.of(robot, values)
    theirs = other if isinstance(other, Traced) else traced_robot(other, robot, values)
    number, size = first_difference(skeleton, theirs), staged.scene.unit
    camera = fitted(staged.scene, staged.view, paper, _near_points(theirs, skeleton, size))
    shapes = [*pins(staged.scene, camera, staged.scene.pinned), *painted(staged.scene, camera, turns=False)]
    axes, wishes = frames(staged.scene, camera)
    under = [Shape(tuple(map(camera.flat, theirs.line)), "theirs")] if len(theirs.line) > 1 else []
    for drawn, wish in _their_axes(theirs, skeleton, size, camera):
        under += drawn
        wishes += [wish] if any(run.below and run.text == f"{number}′" for run in wish.words) else []
    wrong = None if number is None else dict(theirs.frames)[number].origin
    is_near = wrong is None or _is_near(wrong, skeleton)
    mark = []
    if wrong is not None and is_near:
        mark.append(Shape(ring(camera.flat(wrong), 18.0, 28), "theirs-mark", closed=True))
    ink = Ink(paper.width, paper.height)
    ink.add([*shapes, *under, *axes, *mark])
    leaders, texts = placed(wishes, ink, paper.room, paper.lettering)
    does = "differs" if theirs.pairs else "breaks a rule"
    told = f"no frame {does}" if number is None else f"frame {number} is the first that {does}{theirs.note}"
    caption = f"{staged.caption} · over it {theirs.name}: {told}{'' if is_near else ', far outside the picture'}"
    everything, words = (*shapes, *under, *leaders, *axes, *mark), (*texts, *foot(robot.title, caption, paper))
    return Figure(paper.width, paper.height, everything, words, robot.title, caption)


def _near_points(theirs: Traced, skeleton: Skeleton, size: float) -> list[Vector]:
    """What of the other is on the paper of the arm: its joints, and the tips of its axes."""
    near = [frame for _, frame in theirs.frames if _is_near(frame.origin, skeleton)]
    tips = [plus(frame.origin, axis, ARROW * size) for frame in near for axis in (frame.x, frame.z)]
    return [*(point for point in theirs.line if _is_near(point, skeleton)), *tips]


def _their_axes(theirs: Traced, skeleton: Skeleton, size: float, camera: Camera) -> Iterator[tuple[list[Shape], Wish]]:
    """The axes of the other that are on the paper of the arm, each with its name."""
    numbered = tuple((name, k) for k, (name, _) in enumerate(theirs.frames))
    for arrow in arrows(tuple(frame for _, frame in theirs.frames), numbered, size):
        frame = theirs.frames[arrow.start.state][1]
        if _is_near(frame.origin, skeleton):
            yield _their_arrow(arrow, frame, camera)


def first_difference(right: Skeleton, theirs: Traced) -> str | None:
    """The first frame of the other that does not stand where it should.

    Args:
        right: The robot that is right, at a pose.
        theirs: The other's frames at the same pose.
    """
    if theirs.wrong is not None:
        return theirs.wrong
    ours, found = dict(right.numbered), dict(theirs.frames)
    near = theirs.close * _size(right)
    for one, name in theirs.pairs:
        frame, other = right.states[ours[one]], found[name]
        turned = max(length(minus(a, b)) for a, b in zip(frame[:3], other[:3], strict=True))
        if turned > theirs.close or length(minus(frame.origin, other.origin)) > near:
            return name
    return None


def traced_robot(other: Robot, robot: Robot, values: Values) -> Traced:
    """The frames of another table of the same arm: joints in their order, lengths by their names.

    Raises:
        RobotError: The two have not the same joints; a length has no value.
    """
    if robot.pattern != other.pattern:
        counts = (
            f"{robot.name} is {robot.pattern or 'without joints'}, {other.name} {other.pattern or 'without joints'}"
        )
        raise RobotError(f"the two arms have not the same joints: {counts}")
    joints = [values[name] for name in robot.variables]
    named = {name: values[name] for name in other.parameters if name in values}
    full, _ = with_examples(other, named)
    given = {**full, **dict(zip(other.variables, joints, strict=True))}
    require(other, other.chain, given)
    segments = [(str(other.first - 1), other.base), *((str(link.number), link.moves) for link in other.links)]
    segments = [*[("base", ())] * bool(other.base), *segments, *[("tool", other.tool)] * bool(other.tool)]
    ours = [name for name, _ in Skeleton.of(robot, values).numbered]
    pairs = paired(ours, [name for name, _ in segments], alike=robot.convention is other.convention)
    return traced(other.name, segments, numbers(given), pairs)


def _is_near(point: Vector, skeleton: Skeleton) -> bool:
    """Whether a point is on the paper of the arm; one in another unit would make the arm a dot."""
    return length(minus(point, skeleton.states[0].origin)) <= FAR * _size(skeleton)


def _size(skeleton: Skeleton) -> float:
    """How far from the base the farthest frame is [m]; 1 where all are in one place."""
    base = skeleton.states[0].origin
    return max(length(minus(frame.origin, base)) for frame in skeleton.states) or 1.0


def _their_arrow(arrow: Arrow, frame: Frame, camera: Camera) -> tuple[list[Shape], Wish]:
    tail = camera.flat(frame.origin)
    tip = camera.flat(plus(frame.origin, frame.direction(arrow.direction), arrow.length))
    words: Words = tuple(Run(run.text + "′", below=True) if run.below else run for run in arrow.words)
    wish = Wish((tip,), words, "theirs", (tip[0] - tail[0], tip[1] - tail[1]))
    if math.dist(tail, tip) < END_ON * arrow.length * camera.scale:
        return _their_end(tail, towards=dot(frame.direction(arrow.direction), camera.towards) > 0), wish
    dx, dy = ((b - a) / math.dist(tail, tip) for a, b in zip(tail, tip, strict=True))
    head = arrowhead((tip[0] + RIM * dx, tip[1] + RIM * dy), tail, HEAD + 2.2 * RIM)
    neck = (head[1][0] + head[2][0]) / 2, (head[1][1] + head[2][1]) / 2
    return [Shape((tail, neck), "theirs-axis"), Shape(head, "theirs-axis-head", closed=True)], wish


def _their_end(at: Flat, *, towards: bool) -> list[Shape]:
    """⊙ or ⊗ around that of the arm, whose circle leaves a rim of it: its cross goes on past the circle."""
    x, y = at
    circle = Shape(ring(at, 6.5 + RIM / 2 + 1.0, 24), "theirs-ring", closed=True)
    if towards:
        return [circle, Shape(ring(at, 3.0, 12), "theirs-axis-head", closed=True)]
    return [circle, *(Shape(((x - s * 11, y - 11), (x + s * 11, y + 11)), "theirs-ring") for s in (1, -1))]
