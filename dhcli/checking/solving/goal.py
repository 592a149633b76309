"""The pose that a question about joint values gives, and every joint vector that reaches it."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import partial
from typing import TYPE_CHECKING, TypeAlias, cast

from dhcli.algebra.floats import Floats
from dhcli.checking.exercise import Case, Exercise
from dhcli.checking.kinds.linked import needed
from dhcli.checking.units import chain_in_metres, has_length_unit, length_in_metres
from dhcli.errors import NotationError, Place, Problem, RobotError
from dhcli.frozen import frozen
from dhcli.geometry.vectors import facing
from dhcli.kinematics.entries import rounded
from dhcli.kinematics.fold import fold
from dhcli.kinematics.frames import ends
from dhcli.kinematics.moves import Chain, Fixed, names, read_chain
from dhcli.kinematics.robot import Robot, Value
from dhcli.kinematics.values import numbers
from dhcli.notation.dimensions import read_at
from dhcli.notation.matrix import parse_matrix
from dhcli.notation.quantity import to_length
from dhcli.notation.scope import Scope
from dhcli.notation.tree import ZERO, Expr, number
from dhcli.notation.walk import symbols
from dhcli.regex import regex

if TYPE_CHECKING:
    from dhcli.kinematics.inverse.solutions import Solutions
    from dhcli.kinematics.inverse.tasks import TaskName

Rows: TypeAlias = tuple[tuple[float, ...], ...]

_rounded = partial(rounded, digits=5)

TASKS = ("pose", "position", "orientation", "axis", "direction")
"""What of a pose may be given."""

_GOAL = regex(
    r"(?:(?P<start>base|\d{1,4})\s*\.\.\s*(?P<end>tool|\d{1,4})\s+)?(?:of\s+|at\s+)?(?P<task>pose|position|orientation|pointing)"
    r"\s*(?P<rest>.*)",
    re.DOTALL,
)
_QUOTED = regex(r"(?P<mark>[\"'])(?P<text>.+?)(?P=mark)\s*(?P<rest>.*)", re.DOTALL)
_BRACKET = regex(r"(?P<text>\(.*?\)|\[.*\])\s*(?P<rest>.*)", re.DOTALL)
_POINTING = regex(r"pointing\s*(?P<text>\(.*?\))\s*(?P<rest>.*)", re.DOTALL)
EXAMPLE = 'of position (0.5, 0.3, 0), or of pose "Trans(0.4, 0, 0.3) Rot(y, 90°)"'


@frozen
class Target:
    """A pose that is given.

    Attributes:
        task: What of it counts.
        text: The moves or coordinates as the author wrote them.
        chain: The moves, or none for a position.
        point: The coordinates of a position [m]; else none.
        along: Where the z axis of the frame points to; none where that is not asked, or all of the orientation is.
        frames: The frame it is seen from and the frame it describes, where they are named.
    """

    task: str
    text: str
    chain: Chain = ()
    point: tuple[Expr, ...] = ()
    along: tuple[Expr, ...] = ()
    frames: tuple[str, str] | None = None

    @property
    def names(self) -> frozenset[str]:
        """The names that stand in it."""
        return names(self.chain).union(*map(symbols, (*self.point, *self.along)))

    def ends(self, robot: Robot | None) -> tuple[str, str]:
        """The frame it is seen from and the frame it describes.

        Raises:
            DhcliError: There is no robot, or it has no such frame.
        """
        start, end = self.frames or (None, None)
        return ends(needed(robot), start, end)

    def rows(self, values: Mapping[str, Value]) -> Rows:
        """The pose, shape (4, 4) [m]; the identity stands where nothing is asked.

        Raises:
            RobotError: A name has no value.
        """
        if missing := sorted(self.names - values.keys()):
            raise RobotError(f"{missing[0]} has no value", f"given: {{{missing[0]}: 0.3 m}}")
        over = Floats(numbers(values))
        if self.chain:
            return tuple(tuple(float(x) for x in row) for row in fold(self.chain, over))
        place = [float(over.length(expr)) for expr in self.point] or [0.0, 0.0, 0.0]
        turn = facing([float(over.value(expr)) for expr in self.along] or [0.0, 0.0, 1.0])
        return (*((*row, x) for row, x in zip(turn, place, strict=True)), (0.0, 0.0, 0.0, 1.0))

    def in_unit(self, unit: Fraction, scope: Scope) -> Target:
        """The pose with its bare lengths in metres, where a sheet is in another unit."""
        if self.chain:
            return replace(self, chain=chain_in_metres(self.text, unit, scope))
        if not self.point:
            return self
        cells = _cells(self.text, scope, None)
        return replace(self, point=_lengths(_scaled(cell, unit, scope) for cell in cells))

    def words(self, exercise: Exercise) -> str:
        """What is given, as a sheet says it: its numbers."""
        start, end = self.ends(exercise.robot)
        seen = f"frame {end} seen from frame {start}"
        if self.names - exercise.known.keys():
            return f"the {self.task} {self.text} of {seen}"
        rows, per = self.rows(exercise.known), float(exercise.metres)
        place = ", ".join(_rounded(row[3] / per) for row in rows[:3])
        unit = exercise.behind
        if self.task == "position":
            return f"the origin of frame {end} at ({place}){unit}, seen from frame {start}"
        if self.along:
            z = f"z of frame {end} along ({', '.join(_rounded(row[2]) for row in rows[:3])})"
            at = f"its origin at ({place}){unit}, " if self.point else ""
            return f"{z}, {at}seen from frame {start}"
        if self.task == "orientation":
            return f"R = [{_matrix(row[:3] for row in rows[:3])}] of {seen}"
        shown = [[*map(_rounded, row[:3]), _rounded(row[3] / per)] for row in rows[:3]]
        matrix = "; ".join(" ".join(row) for row in (*shown, "0001"))
        return f"T = [{matrix}] of {seen}{unit and f', lengths in{unit}'}"


def _matrix(rows: Iterable[Sequence[float]]) -> str:
    return "; ".join(" ".join(map(_rounded, row)) for row in rows)


def read_target(text: str, scope: Scope, place: Place | None) -> tuple[Target, str]:
    """Read the pose that a question gives.

    Args:
        text: `0..3 of position (0.5, 0.3, 0) all`; the frames and what stands behind are optional.
        scope: The names it may use.
        place: Where it stands, for errors.

    Returns:
        The pose, and what stands behind it.

    Raises:
        NotationError: It gives no pose.
    """
    match = _GOAL.fullmatch(text.strip())
    given = None if match is None else _QUOTED.fullmatch(match["rest"]) or _BRACKET.fullmatch(match["rest"])
    if match is None or given is None:
        raise NotationError(Problem(f"'{text.strip():.60}' gives no pose", place, f"write {EXAMPLE}"))
    frames = (match["start"], match["end"]) if match["start"] else None
    inner = given["text"]
    rest = given["rest"].strip()
    if match["task"] == "pointing":
        return Target("direction", inner, along=_direction(inner, scope, place), frames=frames), rest
    if match["task"] == "position":
        target = Target("position", inner, point=_point(inner, scope, place), frames=frames)
        if along := _POINTING.fullmatch(rest):
            z = _direction(along["text"], scope, place)
            return replace(target, task="axis", along=z), along["rest"].strip()
        return target, rest
    return Target(match["task"], inner, read_chain(inner, scope, place), frames=frames), given["rest"].strip()


def given_target(task: str, rows: Sequence[Sequence[float]], frames: tuple[str, str]) -> Target:
    """A pose in numbers as a target.

    Args:
        task: What of it counts.
        rows: The matrix, shape (4, 4) [m].
        frames: The frame it is seen from and the frame it describes.
    """
    exact = [[number(Fraction(value)) for value in row] for row in rows[:3]]
    if task == "position":
        return Target(task, "the place given", point=tuple(row[3] for row in exact), frames=frames)
    a, b, c = ((row[0], row[1], row[2], row[3]) for row in exact)
    return Target(task, "the pose given", (Fixed((a, b, c)),), frames=frames)


def _point(text: str, scope: Scope, place: Place | None) -> tuple[Expr, ...]:
    cells = _cells(text, scope, place)
    if len(cells) != 3:  # noqa: PLR2004
        raise NotationError(Problem(f"a position has three coordinates, not {len(cells)}", place))
    return _lengths(cells, place)


def _direction(text: str, scope: Scope, place: Place | None) -> tuple[Expr, ...]:
    cells = _cells(text, scope, place)
    if len(cells) != 3:  # noqa: PLR2004
        raise NotationError(Problem(f"a direction has three parts, not {len(cells)}", place))
    if all(cell == ZERO for cell in cells):
        raise NotationError(Problem("a direction has a length", place, "write pointing (0, 0, -1)"))
    return tuple(cells)


def _cells(text: str, scope: Scope, place: Place | None) -> list[Expr]:
    return [cell.expr for row in parse_matrix(f"[{text.strip('()[]')}]", scope, place) for cell in row]


def _scaled(cell: Expr, unit: Fraction, scope: Scope) -> Expr:
    """A coordinate in metres; one that is written with a unit stays."""
    return cell if has_length_unit(cell) else length_in_metres(cell, unit, scope)


def _lengths(cells: Iterable[Expr], place: Place | None = None) -> tuple[Expr, ...]:
    return tuple(read_at(place, to_length, cell) for cell in cells)


def of_robot(robot: Robot, values: Mapping[str, Value]) -> dict[str, Value]:
    """Those values that are lengths or constant angles of a robot."""
    return {name: value for name, value in values.items() if name in robot.parameters}


def solutions(case: Case, target: Target) -> Solutions:
    """Every joint vector that reaches the pose.

    Raises:
        RobotError: A name has no value, or the robot has more joints than the pose needs.
    """

    def solved() -> Solutions:
        exercise = case.exercise
        return solve(needed(exercise.robot), target, exercise.known, target.rows(exercise.known))

    return case.memo.of(("solutions", target), solved)


def solve(robot: Robot, target: Target, values: Mapping[str, Value], rows: Rows) -> Solutions:
    """Every joint vector that takes the frame asked about to a pose."""
    from dhcli.kinematics.inverse.asked import inverse  # numpy: for these questions only

    start, end = target.ends(robot)
    task = cast("TaskName", target.task)
    return inverse(robot, rows, task=task, start=start, end=end, parameters=of_robot(robot, values))
