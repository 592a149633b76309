"""Variables that move more than one row, or share one: the same arm with a variable of its own for each move.

What needs one axis for each variable works on that arm, and comes back by the formulas of its variables.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

from dhcli.algebra.floats import Floats
from dhcli.errors import RobotError
from dhcli.frozen import frozen
from dhcli.kinematics.conventions import Convention
from dhcli.kinematics.forward import link_with
from dhcli.kinematics.moves import Chain, Move, Rot, Trans, along, in_radians, names
from dhcli.kinematics.robot import Link, Robot, Value
from dhcli.notation.angle import Angle
from dhcli.notation.derivative import derivative
from dhcli.notation.factors import AXES
from dhcli.notation.names import canonical
from dhcli.notation.tree import ZERO, Expr, Symbol, add, multiply
from dhcli.notation.walk import parted, substitute, symbols

Matrix = tuple[tuple[float, ...], ...]


@frozen
class Uncoupled:
    """An arm whose variables each make one move.

    Attributes:
        given: The robot whose variables share moves.
        robot: The arm; a variable that made one move already has its name.
        formulas: Each of its variables in terms of those of the robot given, exactly.
    """

    given: Robot
    robot: Robot
    formulas: Mapping[str, Value]

    @property
    def shared(self) -> dict[str, Value]:
        """The formulas of those variables that the robot given has not got."""
        return {name: formula for name, formula in self.formulas.items() if name not in self.given.variables}

    def shared_by(self, arm: Robot) -> dict[str, Value]:
        """The same for this arm in another description, which may have values in the place of letters."""
        own = self.given.parameters.items()
        put = {name: value for name, value in own if name not in arm.parameters and value is not None}
        return {name: _put(formula, put) for name, formula in self.shared.items()}

    def values(self, pose: Mapping[str, Value]) -> dict[str, Value]:
        """Exact values of its variables for those of the robot given; one that is not named stands at zero."""
        turning = self.given.turning
        all_ = {name: pose.get(name, Angle() if name in turning else ZERO) for name in self.given.variables}
        return {name: _put(formula, all_) for name, formula in self.formulas.items()}

    def back(self, arm: Robot) -> Robot:
        """An arm with its variables, however it is described, as a robot with the variables of the one given."""
        given = self.given
        return replace(
            arm,
            variables=given.variables,
            links=tuple(link_with(link, self.shared_by(arm), arm.convention) for link in arm.links),
            limits=given.limits,
            poses=given.poses,
            actuators=given.actuators,
            drives=given.drives,
            called=given.called,
        )

    def linear(self, values: Mapping[str, Angle | float]) -> tuple[Matrix, tuple[float, ...]]:
        """Slopes and offsets of its variables by those of the robot given, q' = slopes q + offsets.

        Args:
            values: Value of each length [m] and constant angle.

        Returns:
            Slopes of shape (m, n) and m offsets, in radians and metres.
        """
        over = Floats({**values, **dict.fromkeys(self.given.variables, 0.0)})
        slopes = tuple(tuple(_slope(f, name, over) for name in self.given.variables) for f in self.formulas.values())
        return slopes, tuple(f.constant() if isinstance(f, Angle) else over.value(f) for f in self.formulas.values())


def is_coupled(robot: Robot) -> bool:
    """Whether a variable makes several moves, or several variables make one."""
    if robot.drives is not None:
        return True
    seen = set[str]()
    for move in (move for link in robot.links for move in link.moves):
        inside = names((move,)).intersection(robot.variables)
        if len(inside) > 1 or inside & seen:
            return True
        seen |= inside
    return False


def uncoupled(robot: Robot, *, singly: bool = False, joined: frozenset[str] = frozenset()) -> Uncoupled:
    """The arm with a variable of its own for each move.

    Args:
        robot: The robot.
        singly: Whether a move that several variables make is one move by each of them.
        joined: Variables that keep their several moves, because those are one motion.

    Raises:
        RobotError: A variable stands in a matrix.
    """
    if robot.drives is not None and robot.drives.actuators is not None and not singly:
        driven = robot.drives.actuators
        arm = replace(
            robot.drives, tool=robot.tool, base=robot.base, parameters=robot.parameters, derived=robot.derived
        )
        return Uncoupled(robot, arm, driven.formulas)  # type: ignore[arg-type]
    splitter = _Splitter(robot, singly=singly, joined=joined)
    links = tuple(new for link in robot.links for new in splitter.links(link))
    variables = tuple(splitter.formulas)
    arm = replace(
        robot,
        convention=Convention.PRODUCT,
        variables=variables,
        links=links,
        limits={name: pair for name, pair in robot.limits.items() if name in variables},
        poses={},
        actuators=None,
        drives=None,
        called={},
    )
    return Uncoupled(robot, arm, splitter.formulas)


class _Splitter:
    """Gives each move that joints make a variable of its own.

    Attributes:
        formulas: The new variables in order, in terms of the old ones.
    """

    def __init__(self, robot: Robot, *, singly: bool, joined: frozenset[str]) -> None:
        """Find the variables that make one move alone; they stay, as do those joined."""
        self._robot = robot
        self._singly = singly
        moves = [move for link in robot.links for move in link.moves]
        inside = [names((move,)).intersection(robot.variables) for move in moves]
        count = {name: sum(name in found for found in inside) for name in robot.variables}
        shared = frozenset().union(*(found for found in inside if len(found) > 1))
        self._kept = {name for name, times in count.items() if times == 1 or name in joined} - shared
        self.formulas: dict[str, Value] = {}

    def links(self, link: Link) -> Iterator[Link]:
        """A link with new variables, as products; of a screw, which slides and turns, each has a link of its own."""
        pieces: list[list[Move]] = [[]]
        moved = False
        for move in (new for old in link.moves for new in self._moves(old, link.number)):
            moving = not names((move,)).isdisjoint(self.formulas)
            if moving and moved:
                pieces.append([])
            moved = moved or moving
            pieces[-1].append(move)
        for k, piece in enumerate(pieces):
            # no frame that anybody asks for stands inside a link: its number only has to be another one
            number_ = link.number if piece is pieces[-1] else -(100 * link.number + k)
            yield Link(number_, tuple(piece))

    def _moves(self, move: Move, number_: int) -> Chain:
        inside = sorted(names((move,)).intersection(self._robot.variables))
        if not inside:
            return (move,)
        if len(inside) == 1 and inside[0] in self._kept:
            name = inside[0]
            self.formulas[name] = Angle.of(name) if name in self._robot.turning else Symbol(name)
            return (move,)
        together = [[name] for name in inside] if self._singly else [inside]
        if isinstance(move, Rot):
            still = move.angle.substitute(dict.fromkeys(inside, Angle()))
            turns = [Angle(tuple(term for term in move.angle.terms if term[0] in own)) for own in together]
            first, *others = (Angle.of(self._new(f"theta{number_}", turn)) for turn in turns)
            return (Rot(move.axis, still + first), *(Rot(move.axis, angle) for angle in others))
        if not isinstance(move, Trans):
            raise RobotError(f"{inside[0]} stands in a matrix", "write the joint as Rot(axis, variable) or Trans(...)")
        rest = Trans(*(self._still(part, inside) for part in move.offset))
        return (rest, *(slide for own in together for slide in self._slides(move, own, number_)))

    def _slides(self, move: Trans, inside: list[str], number_: int) -> Iterator[Move]:
        """A slide along each axis that variables stand in."""
        for axis, part in zip(AXES, move.offset, strict=True):
            if own := [name for name in inside if name in symbols(part)]:
                way = add(*(multiply(derivative(part, name), Symbol(name)) for name in own))
                yield along(axis, Symbol(self._new(f"d{number_}", way)))

    def _still(self, part: Expr, inside: list[str]) -> Expr:
        return substitute(part, dict.fromkeys(inside, ZERO), dict.fromkeys(inside, Angle()))

    def _new(self, wish: str, formula: Value) -> str:
        """A variable of this name, or a like one that is free; where it is one of the robot's own, that one once."""
        own = next((name for name in self._robot.variables if formula in (Angle.of(name), Symbol(name))), None)
        if own and own not in self.formulas:
            self.formulas[own] = formula
            return own
        taken = set(map(canonical, (*self._robot.variables, *self._robot.parameters, *self.formulas)))
        while canonical(wish) in taken:
            wish += "0"
        self.formulas[wish] = formula
        return wish


def _put(formula: Value, values: Mapping[str, Value]) -> Value:
    """A formula with exact values in the place of its names."""
    if isinstance(formula, Angle):
        return formula.substitute(values)
    _, angles = parted(values)
    lengths = {name: in_radians(value) if isinstance(value, Angle) else value for name, value in values.items()}
    return substitute(formula, lengths, angles)


def _slope(formula: Value, name: str, over: Floats) -> float:
    if isinstance(formula, Angle):
        return float(dict(formula.terms).get(name, 0))
    return over.value(derivative(formula, name)) if name in symbols(formula) else 0.0
