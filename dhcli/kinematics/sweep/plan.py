"""From what was asked to a grid: which joints are swept, over what, and where the others stand."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Mapping, Sequence

from dhcli.errors import Place, Problem, RobotError
from dhcli.kinematics.derived import in_floats
from dhcli.kinematics.limits import warnings
from dhcli.kinematics.robot import Kind, Robot, Value
from dhcli.kinematics.sweep.grid import Axis, Grid
from dhcli.kinematics.sweep.ranges import Over, counted
from dhcli.kinematics.sweep.target import Target
from dhcli.kinematics.values import Values
from dhcli.notation.angle import Angle
from dhcli.notation.tree import ZERO

LARGEST = 1_000_000_000
"""Poses of the largest grid that is computed: some minutes of work."""

MODEST = 1_000_000
"""Poses of a grid for which nobody said how fine it should be: less than a second of work."""

COUNTS = (181, 121, 73, 61, 37, 25, 13, 9, 5)
"""Values of a joint for which nobody said how many: whole degrees on a whole turn, its quarters among them."""

WHOLE_TURN = Angle.in_degrees(-180), Angle.in_degrees(180)


def plan(target: Target, overs: Sequence[Over], held: Values | None = None, place: Place | None = None) -> Grid:
    """The grid that is asked for.

    Args:
        target: What is followed through it.
        overs: What each joint is swept over; none for every joint that moves the target and is not held.
        held: Where joints stand that are not swept; 0 by default.
        place: Where the ranges come from, for errors.

    Raises:
        RobotError: A joint is given twice or has no limits to sweep over, none is swept, or the grid is too large.
    """
    robot, held = target.robot, held or {}
    movers = target.movers()
    if not robot.variables:
        raise RobotError(f"{robot.name} has no joint, so there is nothing to sweep")
    if not overs and not movers:
        message = f"no joint moves this point of frame {target.view.end}, seen from frame {target.view.start}"
        raise RobotError(message, f"frames: {', '.join(robot.frames)}")
    if not overs:
        overs = [Over(name) for name in robot.variables if name in movers and name not in held]
    asked: dict[str, Over] = {}
    for over in overs:
        if over.name in asked:
            raise RobotError(Problem(f"{over.name} is given twice", place, "one range a joint"))
        asked[over.name] = over
    ranges = _with_ends(robot, asked, place)
    axes = [_axis(robot, name, ranges.get(name), held) for name in robot.variables]
    count = _open_count(axes)
    grid = Grid(tuple(axis if axis.count else Axis(axis.name, axis.first, axis.last, count) for axis in axes))
    if not grid.swept:
        hint = "sweep one: --over " + (next(iter(asked), "") or robot.variables[0]) + "=FROM..TO"
        raise RobotError(Problem("every joint stands still, so there is nothing to sweep", place, hint))
    if grid.count > LARGEST:
        raise _too_large(grid, movers, place)
    return grid


def remarks(target: Target, grid: Grid) -> Iterator[str]:
    """What a person should know of a grid that can be computed all the same."""
    robot = target.robot
    said = {axis.name: axis.last for axis in grid.axes}
    yield from dict.fromkeys((*warnings(robot, grid.at(0)), *warnings(robot, said)))
    movers = target.movers()
    if idle := [axis for axis in grid.swept if axis.name not in movers]:
        names = ", ".join(axis.name for axis in idle)
        times = math.prod(axis.count for axis in idle)
        verb = "does" if len(idle) == 1 else "do"
        yield f"{names} {verb} not move this point: each position comes {counted(times)} times"


def _with_ends(robot: Robot, asked: Mapping[str, Over], place: Place | None) -> dict[str, Over]:
    """Every range with its ends: those of the joint where none were given."""
    kinds = {joint.name: joint.kind for joint in robot.joints}
    found: dict[str, Over] = {}
    endless = []
    for name, over in asked.items():
        ends = (over.first, over.last) if over.first is not None else _limits(robot, name, kinds[name])
        if ends is None:
            endless.append(name)
        else:
            found[name] = Over(name, *ends, over.count)
    if endless:
        open_ = (name for name, over in asked.items() if over.first is None)
        words = " ".join(f"--over {name}{'=0..0.2' if name in endless else ''}" for name in open_)
        has, it = ("has", "it slides") if len(endless) == 1 else ("have", "they slide")
        message = f"{', '.join(endless)} of {robot.name} {has} no limits in its file, so how far {it} is not known"
        raise RobotError(Problem(message, place, f"say it: {words}"))
    return found


def _limits(robot: Robot, name: str, kind: Kind) -> tuple[Value, Value] | None:
    """How far a joint goes; a turn is enough where it may turn further, for there it comes by the same places."""
    limits = robot.limits.get(name)
    if kind == "prismatic":
        return limits
    low, high = map(in_floats, limits or WHOLE_TURN)
    is_free = low <= in_floats(WHOLE_TURN[0]) and high >= in_floats(WHOLE_TURN[1])
    return WHOLE_TURN if limits is None or is_free else limits


def _axis(robot: Robot, name: str, over: Over | None, held: Values) -> Axis:
    """The values of a joint; their number is 0 where it is still open."""
    if over is None or over.first is None or over.last is None:
        return Axis.held(name, held.get(name, Angle() if name in robot.angles else ZERO))
    return Axis(name, over.first, over.last, over.count or 0)


def _open_count(axes: Sequence[Axis]) -> int:
    """How many values each joint gets for which nobody said it."""
    open_ = sum(axis.count == 0 for axis in axes)
    others = math.prod(axis.count or 1 for axis in axes)
    return next((count for count in COUNTS if count**open_ * others <= MODEST), COUNTS[-1])


def _too_large(grid: Grid, movers: frozenset[str], place: Place | None) -> RobotError:
    """How many poses there would be, and what makes them fewer."""
    message = f"this grid has {counted(grid.count)} poses, more than the {LARGEST:,} that are computed"
    if idle := [axis.name for axis in grid.swept if axis.name not in movers]:
        does = "does" if len(idle) == 1 else "do"
        return RobotError(Problem(message, place, f"leave out {', '.join(idle)}, which {does} not move this point"))
    joints = len(grid.swept)
    most = next(n for n in itertools.count(1) if (n + 1) ** joints > LARGEST)
    hint = f"{joints} joints may take {most} values each, n {most}; or hold some of them with --q"
    return RobotError(Problem(message, place, hint))
