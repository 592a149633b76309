"""From a robot to its figure: the pose, the view, the scene, and everything in its place on paper."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from dhcli.errors import RobotError
from dhcli.frozen import frozen
from dhcli.geometry.vectors import UNITS, Vector, plus
from dhcli.kinematics.conventions import NAMES
from dhcli.kinematics.derived import in_floats
from dhcli.kinematics.robot import Robot, Value
from dhcli.kinematics.values import JointInput, Values, joint_values, require
from dhcli.notation.angle import Angle
from dhcli.notation.quantity import Bare
from dhcli.scene.arm import arm_scene, is_planar
from dhcli.scene.camera import VIEWS, Camera
from dhcli.scene.choice import best_pose, best_view, broadside, with_examples
from dhcli.scene.ink import Ink
from dhcli.scene.labels import PRINT, Lettering, Rect, Wish, placed
from dhcli.scene.overlay import dimensions, frames, joint_axes, pins, turn_wishes
from dhcli.scene.painter import grip, painted
from dhcli.scene.primitives import Ball, Box, Drum, Face, Scene
from dhcli.scene.shapes import Figure, Shape, Text
from dhcli.scene.skeleton import Skeleton
from dhcli.scene.words import Run, in_line

WIDTH, HEIGHT = 820.0, 640.0
MARGIN, FOOT = 62.0, 34.0
LARGEST_DRUM = 36.0
"""The largest radius of a drum on paper [px]."""

LARGEST_OF_LINKAGE = 62.0
"""The same where no frames and lengths stand around it."""


@frozen
class Staged:
    """A robot or a linkage, ready to be drawn.

    Attributes:
        scene: What it looks like in space.
        view: Azimuth and elevation [deg].
        title: What it is called.
        caption: What is shown: convention, pose, example lengths.
        first: Number of the first joint; None where joints have no numbers.
    """

    scene: Scene
    view: tuple[float, float]
    title: str
    caption: str
    first: int | None = 1


@frozen
class Paper:
    """What a figure is drawn on.

    Attributes:
        width: Of the paper [px].
        height: Of the paper [px].
        lettering: How large its letters are.
        margin: Room for labels around the bodies [px].
        foot: Height of the caption [px]; 0 leaves it out.
    """

    width: float = WIDTH
    height: float = HEIGHT
    lettering: Lettering = PRINT
    margin: float = MARGIN
    foot: float = FOOT

    @property
    def room(self) -> Rect:
        """Where labels may stand."""
        return Rect(3, 3, self.width - 3, self.height - max(self.foot, 3))


@frozen
class ArmAt:
    """A robot at joint values, at one of its poses, or at the pose that shows it best.

    Attributes:
        robot: The robot.
        q: Joint values, as `forward` takes them.
        pose: The name of a pose instead.
        view: Azimuth and elevation [deg]; the best view by default.
        parameters: Lengths and angles instead of the robot's own.
        bare: What a number without a unit means for a joint that turns.
    """

    robot: Robot
    q: JointInput = None
    pose: str | None = None
    view: tuple[float, float] | None = None
    parameters: Values | None = None
    bare: Bare = "rad"

    def values(self) -> dict[str, Value]:
        """Values of all joints and lengths, examples included."""
        full, _ = with_examples(self.robot, self.parameters or {})
        return {**full, **posed(self.robot, self.q, self.pose, full, self.bare)[1]}

    def staged(self) -> Staged:
        """The scene, ready to be drawn.

        Raises:
            RobotError: A joint has no value; the pose is not known.
        """
        robot, view = self.robot, self.view
        full, made = with_examples(robot, self.parameters or {})
        shown, values = posed(robot, self.q, self.pose, full, self.bare)
        every = {**full, **values}
        require(robot, robot.chain, every)
        scene = arm_scene(robot, every)
        if view is None:
            view = VIEWS["top"] if is_planar(Skeleton.of(robot, every)) else best_view(scene)
        scene = replace(scene, hand=broadside(scene, Camera.at(*view)))
        examples = ", ".join(f"{in_line(name)} = {value_words(every[name])}" for name in made)
        name = robot.name * (robot.name != robot.title)
        caption = " · ".join(
            part for part in (name, NAMES[robot.convention], shown, f"example: {examples}" * bool(made)) if part
        )
        return Staged(scene, view, robot.title, caption, robot.first)


def figure_of(staged: Staged, paper: Paper | None = None, *, worksheet: bool = False) -> Figure:
    """The figure of a staged scene.

    Args:
        staged: The scene and its view.
        paper: What it is drawn on.
        worksheet: Whether the frames are left to the student: only bodies, axes and numbers of the joints.
    """
    paper = paper or Paper()
    camera = fitted(staged.scene, staged.view, paper)
    scene = staged.scene
    shapes = [*pins(scene, camera, scene.pinned), *painted(scene, camera, turns=bool(scene.arrows) and not worksheet)]
    ink = Ink(paper.width, paper.height)
    ink.add([*shapes, grip(scene, scene.hand, camera)] if scene.hand else shapes)
    wishes: list[Wish] = []
    over: list[Shape] = []
    if worksheet:
        over, wishes = joint_axes(scene, camera, staged.first)
        ink.add(over)
    else:
        axes, names = frames(scene, camera)
        ink.add(axes)
        lines, lengths = dimensions(scene, camera, ink)
        turns = turn_wishes(scene, camera) if scene.arrows else ()
        over, wishes = [*lines, *axes], [*names, *lengths, *turns]
        wishes += [Wish((camera.flat(scene.point(mark.at)),), mark.words, "mark") for mark in scene.marks]
    leaders, texts = placed(wishes, ink, paper.room, paper.lettering)
    azimuth, elevation = staged.view
    caption = " · ".join(filter(None, (staged.caption, f"az {azimuth:.4g}°, el {elevation:.4g}°")))
    texts += foot(staged.title, caption, paper)
    return Figure(paper.width, paper.height, (*shapes, *leaders, *over), tuple(texts), staged.title, caption)


def fitted(scene: Scene, view: tuple[float, float], paper: Paper, more: Sequence[Vector] = ()) -> Camera:
    """The camera that has everything of a scene on paper; the same for a figure and its worksheet."""
    room = (
        paper.margin,
        paper.margin * 0.8,
        paper.width - paper.margin,
        paper.height - paper.foot - paper.margin * 0.7,
    )
    largest = LARGEST_DRUM if scene.arrows else LARGEST_OF_LINKAGE
    most = largest / scene.unit * min(paper.width / WIDTH, paper.height / HEIGHT)
    return Camera.at(*view).fitted([*extent(scene), *more], room, most)


def extent(scene: Scene) -> list[Vector]:
    """Points that span a scene."""
    points = [scene.point(end) for rod in scene.rods for end in (rod.start, rod.end)]
    for solid in scene.solids:
        if isinstance(solid, Face):
            points += [scene.point(corner) for corner in solid.corners]
            continue
        centre = scene.point(solid.centre)
        size = solid.radius * 1.5 if isinstance(solid, Drum | Ball) else solid.half
        points += [plus(centre, axis, sign * size) for axis in UNITS for sign in (1, -1)]
        if isinstance(solid, Drum | Box):
            axis = scene.direction(solid.centre.state, solid.axis)
            points += [plus(centre, axis, sign * 2.0 * scene.unit) for sign in (1, -1)]
    for arrow in scene.arrows:
        direction = scene.direction(arrow.start.state, arrow.direction)
        points += [scene.point(arrow.start), plus(scene.point(arrow.start), direction, arrow.length)]
    if scene.plate is not None:
        centre = scene.point(scene.plate.centre)
        size = scene.plate.size
        points += [add_flat(centre, s * size, t * size) for s in (1, -1) for t in (1, -1)]
    if scene.hand is not None:
        wrist, hand = scene.point(scene.hand.wrist), scene.hand
        points.append(plus(wrist, scene.direction(hand.wrist.state, hand.forward), hand.size))
    points += [scene.point(mark.at) for mark in scene.marks]
    return points


def add_flat(point: Vector, x: float, y: float) -> Vector:
    """A point moved in the plane of x and y."""
    return point[0] + x, point[1] + y, point[2]


def posed(robot: Robot, q: JointInput, pose: str | None, full: Values, bare: Bare) -> tuple[str, Mapping[str, Value]]:
    """The pose to draw, and how a caption says it."""
    if q is not None and pose is not None:
        raise RobotError("joint values and a pose are two answers to one question", "give one of the two")
    if pose is not None:
        if pose not in tuple(robot.poses):  # a list is no key
            known = ", ".join(robot.poses) or "it has none"
            raise RobotError(f"{robot.name} has no pose called {pose}", f"poses: {known}")
        return f"pose {pose}", dict(zip(robot.variables, robot.poses[pose], strict=True))
    if q is not None:
        values = joint_values(robot, q, bare=bare)
        named_so = [name for name, own in robot.poses.items() if tuple(values.get(v) for v in robot.variables) == own]
        return (f"pose {named_so[0]}" if named_so else _listed(values)), values
    name, values = best_pose(robot, full)
    return (f"pose {name}" if name else _listed(values)), values


def _listed(values: Mapping[str, Value]) -> str:
    return ", ".join(f"{in_line(name)} = {value_words(value)}" for name, value in values.items())


def value_words(value: Value) -> str:
    """A joint value under a figure: degrees or metres, four digits."""
    if isinstance(value, Angle):
        return f"{value.constant() * 57.29577951308232:.4g}°"
    return f"{in_floats(value):.4g} m"


MOST_LINES = 2
"""Lines of a caption; what is longer ends in three dots."""


def foot(title: str, caption: str, paper: Paper) -> list[Text]:
    """The line under a figure; two of them where one is too short."""
    if not paper.foot:
        return []
    text = " · ".join(filter(None, (title, caption)))
    text = "".join(letter if letter.isprintable() else " " for letter in text)
    size = 12.5
    most = int((paper.width - 32) / (0.53 * size))
    lines = [""]
    for piece in text.split(" · "):
        longer = f"{lines[-1]} · {piece}" if lines[-1] else piece
        if len(longer) > most and lines[-1] and len(lines) < MOST_LINES:
            lines.append(piece)
        else:
            lines[-1] = longer
    lines = [line if len(line) <= most else f"{line[: most - 1]}…" for line in lines]
    low = paper.height - 14.0
    return [
        Text((16.0, low - 1.25 * size * up), (Run(line),), "caption", size) for up, line in enumerate(reversed(lines))
    ][::-1]
