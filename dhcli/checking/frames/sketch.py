"""What frames are put on: the axes of the joints in the pose drawn, what the task fixes, and frames that are right."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from typing import TypeAlias

from dhcli.algebra.floats import Floats
from dhcli.checking.exercise import Exercise
from dhcli.checking.tables.comparing import STATED, unstated
from dhcli.errors import RobotError, UnknownNameError, did_you_mean
from dhcli.frozen import frozen
from dhcli.geometry.vectors import Vector, length, plus, scaled
from dhcli.kinematics.conventions import Convention
from dhcli.kinematics.derived import replaced
from dhcli.kinematics.describe.asked import DRAWN
from dhcli.kinematics.describe.description import known_values
from dhcli.kinematics.describe.drawn import Frame, Line, drawing_of
from dhcli.kinematics.describe.linear import Point, coordinates_of
from dhcli.kinematics.describe.process import Walk, axis_word, frames_of, walk
from dhcli.kinematics.describe.retold import retold
from dhcli.kinematics.forward import with_own_values
from dhcli.kinematics.moves import Chain
from dhcli.kinematics.robot import Robot, Value
from dhcli.notation.angle import Angle
from dhcli.notation.quantity import value_text
from dhcli.notation.tree import ZERO as NOTHING
from dhcli.notation.tree import Expr
from dhcli.notation.writer import write

ZERO = "zero"
Pose: TypeAlias = Mapping[str, Value]


@frozen
class Sketch:
    """A robot drawn in one pose, seen from its base; from its frame 0 where its own table is asked for.

    Attributes:
        robot: The robot, with the values of the task.
        convention: Which axis a frame stands on.
        pose: The values of joints that are not zero.
        axes: The line of each joint; of a slide only the direction matters.
        walked: The process, every choice in it as in the robot's own table where it has one.
        frames: The frames that it gives, from frame 0 to the last.
        values: Value of each letter that has one.
        size: How far the farthest point of the drawing is from the base [m].
        stated: What the task fixes, in the words of `comparing.STATED`.
        measured: A length in metres as it is written on the sheet.
        distance: A distance in metres in words, in the unit of the sheet.
    """

    robot: Robot
    convention: Convention
    pose: Pose
    axes: tuple[Line, ...]
    walked: Walk
    frames: tuple[Frame, ...]
    values: Mapping[str, Angle | float]
    size: float
    stated: frozenset[str]
    measured: Callable[[Expr], Expr]
    distance: Callable[[float], str]

    @property
    def first(self) -> int:
        """Number of the first frame."""
        return self.robot.first - 1

    @property
    def joint_values(self) -> dict[str, Value]:
        """The value of every joint in the pose drawn."""
        return {line.name: self.pose.get(line.name, Angle() if line.turns else NOTHING) for line in self.axes}

    def axis_of(self, k: int) -> Line | None:
        """The joint axis that z of frame k, from 0, has to lie along; None where it is free."""
        joint = k if self.convention is Convention.STANDARD else k - 1
        return self.axes[joint] if 0 <= joint < len(self.axes) else None

    def other_of(self, k: int) -> int | None:
        """The frame whose z axis x of frame k, from 0, has to be perpendicular to and to meet; None where x is free."""
        other = k - 1 if self.convention is Convention.STANDARD else k + 1
        return other if 0 <= other < len(self.frames) else None

    def written(self, point: Point) -> str:
        """A point as it is written on the sheet."""
        return f"({', '.join(write(self.measured(expr)) for expr in coordinates_of(point))})"

    def joint(self, line: Line) -> str:
        """A joint by its number and its variable."""
        return f"joint {self.axes.index(line) + self.robot.first} ({line.name})"


def sketch_of(exercise: Exercise, convention: Convention, pose: str) -> Sketch:
    """What the frames of an exercise are put on.

    Raises:
        RobotError: The robot has no joints, no such pose, or a direction in it depends on a letter.
    """
    assert exercise.robot is not None  # noqa: S101  `check` has refused it
    robot = _valued(exercise.robot, exercise)
    drawn = pose_of(robot, pose)
    if robot.convention is convention:
        robot = replace(robot, base=())
    drawing = drawing_of(_chain(robot), robot.variables, known_values(robot), drawn)
    if not drawing.lines:
        raise RobotError(f"{robot.name} has no joints, so no frames are put on its axes")
    second = () if exercise.also is None else (_valued(exercise.also[0], exercise),)
    walked = _own_way((robot, *second), convention, drawn) or walk(drawing)
    over = Floats(known_values(robot))
    points = (*(line.through for line in drawing.lines if line.through), drawing.end.origin)
    size = max((length(at_values(point, over)) for point in points), default=0.0) or 1.0
    stated = frozenset() if not exercise.task.strip() else frozenset(STATED) - frozenset(unstated(exercise.task))
    return Sketch(
        robot,
        convention,
        drawn,
        drawing.lines,
        walked,
        frames_of(walked, convention),
        known_values(robot),
        size,
        stated,
        exercise.on_sheet,
        exercise.distance,
    )


def pose_of(robot: Robot, name: str) -> Pose:
    """A named pose; where none is named that called `drawn`, else zero.

    Raises:
        UnknownNameError: There is none of this name.
    """
    if name and name != ZERO and name not in robot.poses:
        raise UnknownNameError(f"{robot.name} has no pose {name}", did_you_mean(name, robot.poses))
    values = robot.poses.get(name or DRAWN, ())
    return dict(zip(robot.variables, values, strict=False))


def seen_from(exercise: Exercise, convention: Convention) -> str:
    """The frame that points and directions are seen from."""
    robot = exercise.robot
    is_own = robot is not None and robot.base and robot.convention is convention
    return f"frame {robot.first - 1} of the robot" if is_own and robot else "the base"


def drawn_at(pose: Pose) -> str:
    """A pose in words."""
    moved = {name: value for name, value in pose.items() if value != NOTHING and value != Angle()}
    others = "the other joints" if moved else "all joints"
    return "".join(f"{name} = {value_text(value)}, " for name, value in moved.items()) + f"{others} at 0"


def at_values(point: Point, over: Floats) -> Vector:
    """A point in metres; a letter without a value counts as one metre."""
    total = (0.0, 0.0, 0.0)
    for letter, vector in point.items():
        try:
            value = over.value(letter)
        except KeyError:
            value = 1.0
        total = plus(total, scaled(vector, value))
    return total


def axes_text(sketch: Sketch) -> Iterator[str]:
    """Each joint axis in words: `theta1 +z through (0, 0, 0)`."""
    for line in sketch.axes:
        where = "" if line.through is None else f" through {sketch.written(line.through)}"
        yield f"{line.name} {axis_word(line.direction)}{where}{'' if line.turns else ' (slides)'}"


def _valued(robot: Robot, exercise: Exercise) -> Robot:
    """The robot with the values that a task gives; in numbers no letter is left."""
    own = set(robot.parameters)
    given = {name: value for name, value in exercise.given.items() if name in own}
    if given:
        values = replaced(robot.derived, robot.parameters, given)
        robot = replace(robot, parameters={name: values.get(name) for name in robot.parameters}, derived={})
    return with_own_values(robot) if exercise.numeric else robot


def _chain(robot: Robot) -> Chain:
    return (*robot.base, *(move for link in robot.links for move in link.moves))


def _own_way(robots: tuple[Robot, ...], convention: Convention, pose: Pose) -> Walk | None:
    """The process that gives a table in the convention asked for; None if there is no such table."""
    for robot in robots:
        if robot.convention is convention and not robot.base:
            try:
                return retold(robot, pose)
            except RobotError:
                continue
    return None
