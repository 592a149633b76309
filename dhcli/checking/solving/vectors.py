"""Joint vectors as they are typed, and how near each is to the pose asked for and to its solutions."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from dhcli.algebra.floats import Floats
from dhcli.checking.entries import check_names
from dhcli.checking.exercise import Exercise
from dhcli.checking.orientations import angle_between, angle_of, turned
from dhcli.checking.pasted import UnreadableError
from dhcli.checking.solving.goal import Rows, Target
from dhcli.checking.tolerance import CLOSE_FACTOR, Tolerance, without_unit
from dhcli.checking.verdicts import Verdict
from dhcli.errors import DhcliError, Place, UnknownNameError, plural
from dhcli.frozen import frozen
from dhcli.kinematics.fold import fold
from dhcli.kinematics.moves import Chain
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.values import joint_called, numbers
from dhcli.notation.angle import Angle
from dhcli.notation.matrix import parse_matrix
from dhcli.notation.quantity import DimensionError, has_angle_unit, to_angle, to_length
from dhcli.notation.tree import Expr
from dhcli.notation.walk import symbols
from dhcli.regex import regex

_LABEL = regex(r"(?P<name>[^\W\d]\w*)\s*=(?!=)")
_TEXT = regex(r"\A\s*(?P<name>[^\W\d]\w*)\s*=\s*(?=\[)")
FULL_TURN = 2 * math.pi
FAR = 0.5
"""Joint values farther than this from any solution [rad or reaches] are not taken for one of them."""


@frozen
class Vector:
    """Joint values as typed.

    Attributes:
        values: Radians and metres, in joint order.
        bare: Whether an angle was typed without a unit.
        shown: As they were read.
    """

    values: tuple[float, ...]
    bare: bool
    shown: str


@frozen
class Landing:
    """Where joint values lead.

    Attributes:
        off: Error in tolerances: up to 1 is right.
        solution: The number of the solution that is meant; None where none is near.
        words: By how much the pose is missed.
    """

    off: float
    solution: int | None
    words: str

    @property
    def verdict(self) -> Verdict:
        """Right, close or wrong."""
        if self.off <= 1:
            return Verdict.RIGHT
        return Verdict.CLOSE if self.off <= CLOSE_FACTOR else Verdict.WRONG


def read_vectors(exercise: Exercise, robot: Robot, joints: Sequence[str], text: str, place: Place) -> list[Vector]:
    """Read joint vectors, a row each: `30°, 45°; 60°, -45°`, or `theta1 = 30°, theta2 = 45°`.

    Raises:
        UnreadableError: A row has too few or too many values, an angle stands for a length, a name has no value.
        NotationError: It cannot be read.
    """
    text = _TEXT.sub("", text.strip())
    order = _labels(robot, joints, text)
    body = ";".join(line for line in _LABEL.sub("", text).splitlines() if line.strip(" ;,"))
    if order and ";" in body and body.count(";") + 1 == len(joints):
        body = body.replace(";", ",")  # a line for each joint
    rows = [[cell.expr for cell in row] for row in parse_matrix(_bracketed(body), exercise.scope, place)]
    if all(len(row) == 1 for row in rows) and len(rows) == len(joints):
        rows = [[row[0] for row in rows]]  # a column
    for row in rows:
        if len(row) != len(joints):
            message = f"{plural(len(row), 'value')} in a row, and there are {len(joints)} joints: {', '.join(joints)}"
            raise UnreadableError(message + "; each solution stands in a row of its own")
    placed = [[row[order.index(name)] for name in joints] for row in rows] if order else rows
    return [_vector(exercise, robot, joints, row) for row in placed]


def _bracketed(body: str) -> str:
    return body if body.startswith(("[", "\\begin")) else f"[{body}]"


def _labels(robot: Robot, joints: Sequence[str], text: str) -> tuple[str, ...]:
    """The joints in the order in which they are named; none where they are not."""
    found = [match["name"] for match in _LABEL.finditer(text)]
    if not found:
        return ()
    try:
        named = tuple(joint_called(robot, name) for name in found)
    except (UnknownNameError, DhcliError) as error:
        raise UnreadableError(str(error.problems[0].message), f"joints: {', '.join(joints)}") from None
    if sorted(named) != sorted(joints):
        raise UnreadableError(f"each joint is named once: {', '.join(joints)}")
    return named


def _vector(exercise: Exercise, robot: Robot, joints: Sequence[str], row: Sequence[Expr]) -> Vector:
    values, shown, bare = list[float](), list[str](), False
    known = exercise.known
    over = Floats(numbers(known))
    angles = {name: value for name, value in known.items() if isinstance(value, Angle)}
    for name, expr in zip(joints, row, strict=True):
        turns = name in robot.angles
        number, unit = without_unit(expr, 1.0 if turns else float(exercise.metres))
        try:
            value = to_angle(expr, bare="deg") if turns else to_length(number)
        except DimensionError as error:
            raise UnreadableError(f"{name}: {error.message}") from None
        inside = value.names if isinstance(value, Angle) else symbols(value)
        check_names(exercise, inside)
        if missing := sorted(inside - known.keys()):
            raise UnreadableError(f"{name}: a number was asked, and {missing[0]} has no value")
        bare |= turns and not has_angle_unit(expr)
        values.append(value.substitute(angles).constant() if isinstance(value, Angle) else over.value(value) * unit)
        if not math.isfinite(values[-1]):
            raise UnreadableError(f"{name} is no real number")
        shown.append(spelled(robot, name, values[-1]))
    return Vector(tuple(values), bare, ", ".join(shown))


def spelled(robot: Robot, name: str, value: float) -> str:
    """A joint value as a person would type it."""
    if name in robot.angles:
        return f"{round(math.degrees(value), 4) + 0.0:g}°"
    return f"{round(value, 6) + 0.0:g} m"


def in_radians(field: Range, one: Vector) -> Vector:
    """The same numbers with angles in radians, where degrees were read."""
    meant = tuple(
        math.degrees(value) if name in field.robot.angles else value
        for name, value in zip(field.joints, one.values, strict=True)
    )
    return Vector(meant, bare=False, shown=one.shown)


def apart(robot: Robot, joints: Sequence[str], one: Sequence[float], other: Sequence[float]) -> list[float]:
    """By how much each joint differs, whole turns aside [rad, m]."""
    return [
        abs(math.remainder(a - b, FULL_TURN)) if name in robot.angles else abs(a - b)
        for name, a, b in zip(joints, one, other, strict=True)
    ]


@frozen
class Range:
    """What a vector is judged against.

    Attributes:
        robot: The robot.
        joints: The joints that are answered.
        target: The pose asked for.
        rows: The same in numbers, shape (4, 4) [m].
        solutions: Every joint vector that reaches it.
        free: For each the joints that may stand anywhere.
        exercise: The exercise, for its values.
        size: Length of the whole arm [m].
        chain: The moves between the frames asked about.
        lengths: Values of the names in it besides the joints.
    """

    robot: Robot
    joints: tuple[str, ...]
    target: Target
    rows: Rows
    solutions: tuple[tuple[float, ...], ...]
    free: tuple[frozenset[str], ...]
    exercise: Exercise
    size: float
    chain: Chain
    lengths: Mapping[str, Angle | float]

    def landing(self, values: Sequence[float], tolerance: Tolerance) -> Landing:
        """Where joint values lead; right if the pose is met, or if they are a solution's but for rounding."""
        limit = tolerance.position if tolerance.position is not None else 1e-3 * max(self.size, 1e-9)
        off, words = self._missed(dict(zip(self.joints, values, strict=True)), limit, tolerance.rotation)
        nearest, best = None, math.inf
        for k, (solution, free) in enumerate(zip(self.solutions, self.free, strict=True)):
            gaps = apart(self.robot, self.joints, values, solution)
            shares = [
                gap / (math.radians(tolerance.angle) if name in self.robot.angles else limit)
                for name, gap in zip(self.joints, gaps, strict=True)
                if name not in free
            ]
            worst = max(shares, default=0.0)
            if worst < best:
                nearest, best = k, worst
            if not free:
                off = min(off, worst)
        near = best * math.radians(tolerance.angle) <= FAR
        return Landing(off, nearest if near else None, words)

    def _missed(self, q: Mapping[str, float], limit: float, rotation: float) -> tuple[float, str]:
        """By how many tolerances the pose is missed, and in words."""
        there = fold(self.chain, Floats({**self.lengths, **q}))
        said, off = [], 0.0
        if self.target.task in ("pose", "position", "axis"):
            far = math.dist([row[3] for row in there[:3]], [row[3] for row in self.rows[:3]])
            off = far / limit
            if off > 1:
                place = ", ".join(f"{round(row[3] / float(self.exercise.metres), 4) + 0.0:g}" for row in there[:3])
                unit = "" if self.exercise.unit == "none" else f" {self.exercise.unit}"
                far /= float(self.exercise.metres)
                said.append(
                    f"these joint values lead to ({place}){unit}, {far:.3g}{unit} away from the place asked for"
                )
        if self.target.task in ("pose", "orientation"):
            typed, right = ([row[:3] for row in rows[:3]] for rows in (there, self.rows))
            turn = angle_between(typed, right) / rotation
            off = max(off, turn)
            if turn > 1:
                said.append(turned(typed, right))
        if self.target.along:
            typed_z, right_z = ([row[2] for row in rows[:3]] for rows in (there, self.rows))
            turn = angle_of(typed_z, right_z) / rotation
            off = max(off, turn)
            if turn > 1:
                said.append(f"z points {math.degrees(turn * rotation):.3g}° away from where it should")
        return off, "; ".join(said)
