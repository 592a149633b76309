"""A robot at a pose as states: where the chain of moves has got after each of them, its joints, its legs."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from typing import Literal, TypeAlias

from dhcli.algebra.floats import Floats
from dhcli.frozen import frozen
from dhcli.geometry.vectors import ORIGIN, Vector, length, minus, plus, scaled
from dhcli.kinematics.moves import Chain, Fixed, Move, Rot, Trans, expressions
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.values import Values, numbers
from dhcli.notation.angle import Angle, magnitude
from dhcli.notation.tree import Expr, Number
from dhcli.notation.walk import symbols, symbols_in
from dhcli.notation.writer import write, write_angle
from dhcli.scene.vectors import WORLD, Frame, unit
from dhcli.scene.words import Words, spelled

Given: TypeAlias = Mapping[str, Angle | float]

AXES: Mapping[str, Vector] = {"x": WORLD.x, "y": WORLD.y, "z": WORLD.z}


@frozen
class Axis:
    """The axis of a joint.

    Attributes:
        name: The joint variable, or the sum of those that turn about it together.
        kind: Whether it turns or slides.
        state: The state before its move; the axis goes through the origin of that state.
        direction: Its direction in that state, positive as the variable grows.
    """

    name: str
    kind: Literal["revolute", "prismatic"]
    state: int
    direction: Vector


@frozen
class Leg:
    """A straight piece of the way from the base to the hand, in the state before its move."""

    state: int
    start: Vector
    end: Vector
    words: Words
    variable: str = ""


@frozen
class Skeleton:
    """A robot at a pose.

    Attributes:
        robot: The robot.
        values: Value of each joint, length and constant angle.
        chain: All moves from frame `base` to frame `tool`.
        states: Frames before the first move and after each.
        axes: The axes of the joints, in order.
        numbered: Names of the frames, each with its state.
    """

    robot: Robot
    values: Values
    chain: Chain
    states: tuple[Frame, ...]
    axes: tuple[Axis, ...]
    numbered: tuple[tuple[str, int], ...]

    @classmethod
    def of(cls, robot: Robot, values: Values) -> Skeleton:
        """The states of a robot at known values."""
        given = numbers(values)
        floats = Floats(given)
        states = [WORLD]
        for move in robot.chain:
            states.append(moved(states[-1], move, floats))
        numbered, state = [("base", 0)] if robot.base else [], len(robot.base)
        numbered.append((str(robot.first - 1), state))
        for link in robot.links:
            state += len(link.moves)
            numbered.append((str(link.number), state))
        if robot.tool:
            numbered.append(("tool", len(robot.chain)))
        return cls(robot, values, robot.chain, tuple(states), tuple(_axes(robot, given)), tuple(numbered))

    @cached_property
    def legs(self) -> tuple[Leg, ...]:
        """The straight pieces, without those of no length that no joint can lengthen."""
        floats = Floats(numbers(self.values))
        found: list[Leg] = []
        for state, move in enumerate(self.chain):
            found += _legs_of(state, move, floats, self.robot)
        return tuple(leg for leg in found if leg.variable or length(minus(leg.end, leg.start)) > 0)

    def ends(self, leg: Leg) -> tuple[Vector, Vector]:
        """Where a piece starts and ends in the world [m]."""
        frame = self.states[leg.state]
        return frame.point(leg.start), frame.point(leg.end)

    def place(self, axis: Axis) -> tuple[Vector, Vector]:
        """A point of a joint's axis in the world, and its direction."""
        frame = self.states[axis.state]
        return frame.origin, frame.direction(axis.direction)


def moved(frame: Frame, move: Move, floats: Floats) -> Frame:
    """The frame that a move leads to."""
    if isinstance(move, Rot):
        cos, sin = floats.cos_sin(move.angle)
        return turned(frame, move.axis, float(cos), float(sin))
    if isinstance(move, Trans):
        return frame._replace(origin=frame.point(offset(move, floats)))
    rows = [[float(floats.length(entry)) for entry in row] for row in move.rows]
    columns: list[Vector] = [(rows[0][i], rows[1][i], rows[2][i]) for i in range(4)]
    x, y, z = (frame.direction(column) for column in columns[:3])
    return Frame(x, y, z, frame.point(columns[3]))


def turned(frame: Frame, axis: str, cos: float, sin: float) -> Frame:
    """A frame turned about one of its own axes."""
    x, y, z, origin = frame
    if axis == "x":
        return Frame(x, _mix(y, z, cos, sin), _mix(z, y, cos, -sin), origin)
    if axis == "y":
        return Frame(_mix(x, z, cos, -sin), y, _mix(z, x, cos, sin), origin)
    return Frame(_mix(x, y, cos, sin), _mix(y, x, cos, -sin), z, origin)


def _mix(a: Vector, b: Vector, cos: float, sin: float) -> Vector:
    return plus(scaled(a, cos), scaled(b, sin))


def _axes(robot: Robot, given: Given) -> list[Axis]:
    """Every move that holds one joint variable, as an axis."""
    found: list[Axis] = []
    for state, move in enumerate(robot.chain):
        if isinstance(move, Rot):
            terms = tuple((name, factor) for name, factor in move.angle.terms if name in robot.variables)
            if len(terms) == 1:
                (name, factor), *_ = terms
                found.append(Axis(name, "revolute", state, scaled(AXES[move.axis], 1.0 if factor > 0 else -1.0)))
            elif terms:  # joints that drives tie turn about one axis: one body, whose angle is their sum
                text = write_angle(Angle(terms), "short", robot.writing)
                found.append(Axis(text, "revolute", state, AXES[move.axis]))
        elif isinstance(move, Trans):
            sliding = variables_of(move, robot)
            found += (Axis(name, "prismatic", state, unit(slope(move, name, given))) for name in sliding)
    return found


def variables_of(move: Trans, robot: Robot) -> list[str]:
    """The joint variables that stand in a translation."""
    held = symbols_in(expr for expr in expressions((move,)))
    return [name for name in robot.variables if name in held]


def slope(move: Trans, name: str, given: Given) -> Vector:
    """How a translation grows with a variable, in which it is affine."""
    low, high = (offset(move, Floats({**given, name: at})) for at in (0.0, 1.0))
    return minus(high, low)


def offset(move: Trans, floats: Floats) -> Vector:
    """A translation in numbers [m]."""
    x, y, z = (float(floats.length(part)) for part in move.offset)
    return x, y, z


def _legs_of(state: int, move: Move, floats: Floats, robot: Robot) -> list[Leg]:
    if isinstance(move, Rot):
        return []
    if isinstance(move, Fixed):
        entries = [row[3] for row in move.rows]
        return _stretches(state, entries, floats, robot)
    return _stretches(state, list(move.offset), floats, robot)


def _stretches(state: int, lengths: list[Expr], floats: Floats, robot: Robot) -> list[Leg]:
    """One piece for each axis that a move goes along, x before y before z."""
    found, at = [], ORIGIN
    for axis, expr in zip(AXES.values(), lengths, strict=True):
        value = float(floats.length(expr))
        held = [name for name in robot.variables if name in symbols(expr)]
        end = plus(at, scaled(axis, value))
        if value or held:
            words = spelled(write(_positive(expr), "short", robot.writing))
            found.append(Leg(state, at, end, words, held[0] if held else ""))
        at = end
    return found


def _positive(expr: Expr) -> Expr:
    """A number without its sign: a dimension is as long as it is."""
    return Number(magnitude(expr.value), expr.places) if isinstance(expr, Number) else expr
