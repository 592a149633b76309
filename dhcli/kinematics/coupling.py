"""Variables that move more than one row, or share one: the same arm with a variable of its own for each move.

What needs one axis for each variable works on that arm, and comes back by the slopes: q' = slopes q + offsets.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

from dhcli.algebra.floats import Floats
from dhcli.errors import RobotError
from dhcli.frozen import frozen
from dhcli.kinematics.conventions import Convention
from dhcli.kinematics.moves import Chain, Move, Rot, Trans, along, names
from dhcli.kinematics.robot import Link, Robot
from dhcli.notation.angle import Angle
from dhcli.notation.derivative import derivative
from dhcli.notation.factors import AXES
from dhcli.notation.names import canonical
from dhcli.notation.tree import ZERO, Expr, Symbol
from dhcli.notation.walk import substitute, symbols

Matrix = tuple[tuple[float, ...], ...]


@frozen
class Uncoupled:
    """An arm whose variables each make one move.

    Attributes:
        robot: The arm; a variable that made one move already has its name.
        slopes: For each of its variables how fast it goes with each variable of the robot given, in radians and metres.
        offsets: Values of its variables where those of the robot given are 0.
    """

    robot: Robot
    slopes: Matrix
    offsets: tuple[float, ...]


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


def uncoupled(robot: Robot, values: Mapping[str, Angle | float]) -> Uncoupled:
    """The arm with a variable of its own for each move.

    Args:
        robot: The robot.
        values: Value of each length [m] and constant angle.
    """
    if robot.drives is not None and robot.drives.actuators is not None:
        driven = robot.drives.actuators
        arm = replace(
            robot.drives, tool=robot.tool, base=robot.base, parameters=robot.parameters, derived=robot.derived
        )
        return Uncoupled(arm, driven.slopes(), driven.offsets())  # type: ignore[arg-type]
    splitter = _Splitter(robot, values)
    links = tuple(new for link in robot.links for new in splitter.links(link))
    variables = tuple(splitter.slopes)
    limits = {name: pair for name, pair in robot.limits.items() if name in variables}
    arm = replace(
        robot,
        convention=Convention.PRODUCT,
        variables=variables,
        links=links,
        limits=limits,
        poses={},
        drives=None,
    )
    rows = tuple(tuple(row.get(name, 0.0) for name in robot.variables) for row in splitter.slopes.values())
    return Uncoupled(arm, rows, (0.0,) * len(rows))


class _Splitter:
    """Gives each move that joints make a variable of its own.

    Attributes:
        slopes: The new variables in order, with their slopes by the old ones.
    """

    def __init__(self, robot: Robot, values: Mapping[str, Angle | float]) -> None:
        """Find the variables that make one move alone; they stay."""
        self._robot = robot
        self._over = Floats({**values, **dict.fromkeys(robot.variables, 0.0)})
        moves = [move for link in robot.links for move in link.moves]
        inside = [names((move,)).intersection(robot.variables) for move in moves]
        count = {name: sum(name in found for found in inside) for name in robot.variables}
        shared = frozenset().union(*(found for found in inside if len(found) > 1))
        self._kept = {name for name, times in count.items() if times == 1} - shared
        self.slopes: dict[str, dict[str, float]] = {}

    def links(self, link: Link) -> Iterator[Link]:
        """A link with new variables, as products; of a screw, which slides and turns, each has a link of its own."""
        pieces: list[list[Move]] = [[]]
        moved = False
        for move in (new for old in link.moves for new in self._moves(old, link.number)):
            moving = not names((move,)).isdisjoint(self.slopes)
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
            self.slopes[inside[0]] = {inside[0]: 1.0}
            return (move,)
        if isinstance(move, Rot):
            name = self._new(f"theta{number_}", {own: float(x) for own, x in move.angle.terms if own in inside})
            still = Angle(tuple(term for term in move.angle.terms if term[0] not in inside), move.angle.degrees)
            return (Rot(move.axis, still + Angle((), radians=move.angle.radians) + Angle.of(name)),)
        if not isinstance(move, Trans):
            raise RobotError(f"{inside[0]} stands in a matrix", "write the joint as Rot(axis, variable) or Trans(...)")
        return (Trans(*(self._still(part, inside) for part in move.offset)), *self._slides(move, inside, number_))

    def _slides(self, move: Trans, inside: list[str], number_: int) -> Chain:
        """A slide along each axis that variables stand in."""
        found: list[Move] = []
        for axis, part in zip(AXES, move.offset, strict=True):
            if slopes := {own: self._over.value(derivative(part, own)) for own in inside if own in symbols(part)}:
                found.append(along(axis, Symbol(self._new(f"d{number_}", slopes))))
        return tuple(found)

    def _still(self, part: Expr, inside: list[str]) -> Expr:
        return substitute(part, dict.fromkeys(inside, ZERO), dict.fromkeys(inside, Angle()))

    def _new(self, wish: str, slopes: dict[str, float]) -> str:
        taken = set(map(canonical, (*self._robot.variables, *self._robot.parameters, *self.slopes)))
        while canonical(wish) in taken:
            wish += "0"
        self.slopes[wish] = slopes
        return wish
