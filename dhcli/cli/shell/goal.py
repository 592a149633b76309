"""The pose that `ik` is asked for, in whatever way it was typed."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import field
from typing import TYPE_CHECKING, cast

from dhcli.cli.shell.chosen import Chosen
from dhcli.cli.shell.given import lengths_of, point_of, values_of
from dhcli.cli.shell.wishes import Goal
from dhcli.errors import DhcliError, Place, Problem, UnknownNameError, did_you_mean, plural
from dhcli.frozen import frozen
from dhcli.geometry.euler import EulerAngles, Order, RollPitchYaw, euler
from dhcli.geometry.rotations import Quaternion
from dhcli.geometry.vectors import facing
from dhcli.kinematics.derived import in_floats
from dhcli.kinematics.forward import numeric_pose
from dhcli.kinematics.frames import ends
from dhcli.kinematics.inverse.answer import InverseKinematics
from dhcli.kinematics.moves import Fixed
from dhcli.kinematics.pose import Pose
from dhcli.kinematics.robot import Robot, Value
from dhcli.kinematics.transform import Wanted, compose, read_product
from dhcli.notation.brackets import split
from dhcli.notation.parser import parse
from dhcli.notation.quantity import Bare, DimensionError, has_angle_unit, to_angle
from dhcli.notation.scope import Scope
from dhcli.notation.tree import Expr
from dhcli.regex import regex

if TYPE_CHECKING:
    from dhcli.geometry.rotations import Rotation
    from dhcli.kinematics.inverse.solutions import Solutions
    from dhcli.kinematics.inverse.tasks import TaskName

_POINT = regex(
    r"\s*[\[(]?[^][(),;\n]+(?:,[^][(),;\n]+){2}[\])]?\s*"
    r"|\s*[\[(]?\s*[-+]?[.\d][^][(),;\s]*(?:\s+[-+]?[.\d][^][(),;\s]*){2}\s*[\])]?\s*"
)
"""Three values with commas, or three numbers with blanks: no move and no matrix."""

_DECIMALS, _NOT_PLAIN = regex(r"\.([0-9]+)"), regex(r"[0-9] *(?:[mci]|e[-+]?[0-9])")
"""The decimals of a number; a number with a unit or a power of ten, whose decimals count otherwise."""

_FEW = 3
"""Decimals from which on a matrix may be meant to its digits only."""

Rows = tuple[tuple[float, ...], ...]

_IN_NUMBERS = "a pose to reach is in numbers; --derive gives the formulas in letters"


@frozen
class Question:
    """A pose that is asked for.

    Attributes:
        robot: The robot.
        pose: The matrix, shape (4, 4) [m].
        task: What of it counts.
        start: The frame it is seen from.
        end: The frame that is placed.
        lengths: Values of lengths and constant angles.
        remarks: What was taken for something else, such as a matrix of few decimals for the nearest rotation.
        slack: By how much the decimals of a typed matrix leave an entry open; 0 where it is exact.
        standing: Values of the joints, where the pose is given by them.
    """

    robot: Robot
    pose: Rows
    task: TaskName
    start: str
    end: str
    lengths: Mapping[str, Value]
    remarks: tuple[str, ...] = ()
    slack: float = 0.0
    standing: Mapping[str, Value] = field(default_factory=dict)

    def answered(self, found: Solutions, near: Sequence[float] | None, *, why: bool) -> InverseKinematics:
        """The question with its answer, and with how that came about if it is wanted."""
        from dhcli.kinematics.inverse.explained import explained

        wish = None if near is None else tuple(near)
        how = explained(found) if why else None
        return InverseKinematics(self.robot, self.lengths, self.task, self.start, self.end, found, self.pose, wish, how)


def asked(
    robot: Robot,
    goal: Goal,
    chosen: Chosen,
) -> Question:
    """The question that options ask.

    Args:
        robot: The robot.
        goal: The options about the pose.
        chosen: The frames and lengths, or joint values that stand there.

    Raises:
        DhcliError: No pose is given, or two are, or it cannot be read.
    """
    first, last = ends(robot, chosen.from_, chosen.end)
    lengths = lengths_of(robot, chosen)
    task = task_of(goal)
    rows, remarks, slack = _rows(robot, goal, chosen, (first, last))
    values = values_of(robot, chosen) if chosen.stands else {}
    standing = {name: value for name, value in values.items() if name in robot.variables}
    return Question(robot, rows, cast("TaskName", task), first, last, lengths, remarks, slack, standing)


def task_of(goal: Goal) -> str:
    """What counts: as asked for, else what the options determine."""
    known = ("pose", "position", "orientation", "axis", "direction")
    if goal.task is not None:
        if goal.task not in known:
            hint = did_you_mean(goal.task, known) or "known: " + ", ".join(known)
            raise UnknownNameError(Problem(f"there is no task {goal.task}", Place("--task"), hint))
        return goal.task
    turned = any(turn is not None for turn in (goal.rpy, goal.quaternion, goal.euler))
    if goal.pointing is not None:
        return "direction" if goal.position is None else "axis"
    if goal.position is not None:
        return "pose" if turned else "position"
    return "orientation" if turned else "pose"


def _rows(robot: Robot, goal: Goal, chosen: Chosen, frames: tuple[str, str]) -> tuple[Rows, tuple[str, ...], float]:
    """The matrix, what in it was taken for something else, and by how much its decimals leave an entry open."""
    parts = (goal.position, goal.rpy, goal.quaternion, goal.euler, goal.pointing)
    ways = [chosen.stands, goal.target is not None, any(p is not None for p in parts)]
    if sum(ways) != 1:
        said = "no pose is given" if not any(ways) else "the pose is given in two ways"
        raise DhcliError(
            said, "one of --q, --pose, --target, or --position with --rpy, --quaternion, --euler or --pointing"
        )
    if ways[0]:
        return numeric_pose(robot, values_of(robot, chosen), *frames).rows, (), 0.0
    if goal.target is not None:
        return _target(goal.target, chosen.robot)
    return _from_parts(goal, chosen.bare), (), 0.0


def _target(text: str, typed: str) -> tuple[Rows, tuple[str, ...], float]:
    from dhcli.files.reading import read_text, source_of

    place = Place("--target")
    if text == "-" or text.startswith("@"):
        path = text.removeprefix("@")
        if path == typed == "-":
            raise DhcliError("the robot and the pose cannot both come from standard input", "save one in a file")
        text, place = read_text(path), Place(source_of(path))
    if _POINT.fullmatch(text):
        message = f"'{text.strip()}' is a position, and a whole pose is wanted"
        said = ",".join(part for part in re.split(r"[\s,]+", text.strip("[]() \t\n")) if part)
        hint = f"write --position {said}, where the turn is free"
        raise DhcliError(Problem(message, place, hint))
    product = read_product(text, place)
    pose = compose(product, {}, Wanted()).pose
    if pose.is_symbolic:
        _known([cast("Expr", entry) for row in pose.rows for entry in row], place)
        pose = pose.in_numbers()
    is_matrix = len(product.moves) == 1 and isinstance(product.moves[0], Fixed)
    return cast("Pose[float]", pose).rows, product.remarks, _slack(text, product.remarks) if is_matrix else 0.0


def _slack(text: str, remarks: Sequence[str]) -> float:
    """Half a unit of the last decimal of a matrix that is rounded; 0 for one that is meant as it stands.

    That it was rounded its rotation tells, which is one to its digits only; 0.5 and 0.125 beside plain ones are exact.
    """
    decimals = max((len(found[1]) for found in _DECIMALS.finditer(text)), default=0)
    is_rounded = decimals >= (_FEW if remarks else _FEW + 1)
    return 0.5 * 10.0**-decimals if is_rounded and not _NOT_PLAIN.search(text) else 0.0


def _from_parts(goal: Goal, bare: Bare) -> Rows:
    turns = [p for p in (goal.rpy, goal.quaternion, goal.euler, goal.pointing) if p is not None]
    if len(turns) > 1:
        raise DhcliError("the orientation is given in two ways", "one of --rpy, --quaternion, --euler or --pointing")
    place = (0.0, 0.0, 0.0) if goal.position is None else _vector(goal.position, "--position")
    turn: Rotation[float] = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    if goal.rpy is not None:
        turn = RollPitchYaw(*_angles(goal.rpy, "--rpy", bare)).rotation()
    elif goal.quaternion is not None:
        q = _numbers(goal.quaternion, "--quaternion", 4)
        size = math.hypot(*q)
        turn = Quaternion(*(part / size for part in q)).rotation()
    elif goal.euler is not None:
        order, _, angles = goal.euler.strip().partition(" ")
        turn = EulerAngles(_order(order), _angles(angles, "--euler", bare)).rotation()
    elif goal.pointing is not None:
        turn = facing(_numbers(goal.pointing, "--pointing", 3))
    return (*((*row, length) for row, length in zip(turn, place, strict=True)), (0.0, 0.0, 0.0, 1.0))


def _vector(text: str, option: str) -> tuple[float, float, float]:
    x, y, z = (in_floats(part) for part in _known(point_of(text, option), Place(option)))
    return x, y, z


def _known(parts: Sequence[Expr], place: Place) -> Sequence[Expr]:
    from dhcli.notation.walk import symbols_in

    if free := sorted(symbols_in(parts)):
        raise DhcliError(Problem(f"{', '.join(free)} has no value", place, _IN_NUMBERS))
    return parts


def _angles(text: str, option: str, bare: Bare) -> tuple[float, float, float]:
    pieces = list(split(text))
    if len(pieces) != 3:  # noqa: PLR2004
        hint = "write --euler 'zyz 0,30°,90°'" if option == "--euler" else "write 0,90°,0"
        raise DhcliError(Problem(f"three angles are wanted, not {len(pieces)}", Place(option), hint))
    exprs = [parse(piece, Scope(), Place(option)) for _, piece in pieces]
    try:
        a, b, c = (to_angle(expr, bare=bare).constant() for expr in exprs)
    except DimensionError as error:
        raise DhcliError(Problem(error.message, Place(option), error.hint)) from None
    for expr, angle in zip(exprs, (a, b, c), strict=True):
        if bare == "rad" and not has_angle_unit(expr) and abs(angle) > 2 * math.pi:
            hint = f"write {angle:g}°, or --deg"
            raise DhcliError(Problem(f"{angle:g} rad is more than a turn", Place(option), hint))
    return a, b, c


def _numbers(text: str, option: str, count: int) -> tuple[float, ...]:
    pieces = [piece for _, piece in split(text)]
    if len(pieces) != count:
        message = f"{plural(count, 'number')} are wanted, not {len(pieces)}"
        raise DhcliError(Problem(message, Place(option)))
    values = tuple(
        in_floats(part) for part in _known([parse(p, Scope(), Place(option)) for p in pieces], Place(option))
    )
    if not any(values):
        raise DhcliError(Problem("it has no length", Place(option), "one of its numbers must not be 0"))
    return values


def _order(name: str) -> Order:
    """An order of three axes as it was typed, `zyz` or `fixed-xyz`."""
    try:
        return euler(name.removeprefix("fixed-"), fixed=name.startswith("fixed-"))
    except UnknownNameError as error:
        problem = error.problems[0]
        hint = f"write --euler 'zyz 0,30°,90°', or fixed-zyz; {problem.hint}"
        raise UnknownNameError(Problem(problem.message, Place("--euler"), hint)) from None
