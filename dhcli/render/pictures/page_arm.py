"""What a page must know of an arm: the chain of moves, the scene in its states, the table."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from dhcli.algebra.floats import Floats
from dhcli.errors import DhcliError
from dhcli.kinematics.derived import in_floats
from dhcli.kinematics.moves import Fixed, Move, Rot
from dhcli.kinematics.robot import Robot, Value
from dhcli.kinematics.sweep.workspace import Workspace
from dhcli.kinematics.values import JointInput, Values, numbers
from dhcli.notation.angle import Angle
from dhcli.notation.tree import Expr
from dhcli.render.pictures.page_scene import scene_data, words_data
from dhcli.scene.camera import VIEWS
from dhcli.scene.motion import joints_of
from dhcli.scene.primitives import Scene
from dhcli.scene.skeleton import Given
from dhcli.scene.staging import ArmAt, posed
from dhcli.scene.table import cells, heads
from dhcli.scene.words import named
from dhcli.scene.workspace import is_at_base

if TYPE_CHECKING:
    from dhcli.scene.drawing import Drawing


def arm_model(picture: Drawing) -> dict[str, Any]:
    """A robot, its joints at the values of the picture."""
    robot = picture.what
    assert isinstance(robot, Robot)  # noqa: S101  the caller has looked
    q: JointInput = joints_of(robot, picture.path[0]) if picture.path else picture.q  # type: ignore[assignment]
    arm = ArmAt(robot, q, picture.pose, picture.view, picture.parameters, picture.bare)
    staged, values = arm.staged(), arm.values()
    given = numbers(values)
    variables = robot.variables
    state, frames = len(robot.base), [["base", 0]] * bool(robot.base)
    frames.append([str(robot.first - 1), state])
    for link in robot.links:
        state += len(link.moves)
        frames.append([str(link.number), state])
    if robot.tool:
        frames.append(["tool", len(robot.chain)])
    return {
        "name": robot.name,
        "joints": [_joint(robot, name, values[name]) for name in variables],
        "moves": [_move(move, variables, given) for move in robot.chain],
        "frames": frames,
        "poses": [[name, [_number(value) for value in pose]] for name, pose in robot.poses.items()],
        "path": _path(robot, picture, values),
        "cloud": [] if picture.workspace is None else _cloud(picture.workspace, staged.scene),
        "view": list(staged.view),
        "views": [["best", list(staged.view)], *([name, list(view)] for name, view in VIEWS.items())],
        "table": _table(robot, given),
        "scene": scene_data(staged.scene),
    }


def _cloud(workspace: Workspace, scene: Scene) -> list[list[float]]:
    """Some points of a sweep, in as many digits as a dot needs."""
    if not is_at_base(scene, workspace):
        raise DhcliError(
            f"a page shows points seen from the base, not from frame {workspace.reference}", "write .svg, .pdf or .png"
        )
    return [[float(f"{x:.4g}") for x in point] for point in workspace.sample]


MOST_ROWS = 400
"""Rows of a path that a page knows, evenly among all."""


def _path(robot: Robot, picture: Drawing, values: Values) -> list[list[float]]:
    """Where the page plays to: the goal, or what comes after the first of the rows."""
    if picture.to is not None:
        goal = posed(robot, picture.to, None, values, picture.bare)[1]
        return [[_number(goal[name]) for name in robot.variables]]
    last = len(picture.path) - 1
    count = min(last, MOST_ROWS)
    return [[float(f"{x:.9g}") for x in picture.path[round(k * last / count)]] for k in range(1, count + 1)]


def _joint(robot: Robot, name: str, value: Value) -> dict[str, Any]:
    joint = next(each for each in robot.joints if each.name == name)
    low, high = (map(in_floats, robot.limits[name])) if name in robot.limits else (None, None)
    at = _number(value)
    reach = math.pi if joint.kind == "revolute" else max(1.5 * abs(at), _longest(robot), 0.1)
    ends = {"from": min(-reach, at), "till": max(reach, at)} if low is None else {"lo": low, "hi": high}
    return {"name": name, "words": words_data(named(name)), "kind": joint.kind, **ends, "q": at}


def _longest(robot: Robot) -> float:
    lengths = [in_floats(v) for n, v in robot.parameters.items() if v is not None and n not in robot.angles]
    return max((abs(x) for x in lengths), default=0.5)


def _move(move: Move, variables: tuple[str, ...], given: Given) -> list[Any]:
    """A move in numbers: quarter turns and radians with factors of joints, or an offset with its slopes."""
    if isinstance(move, Rot):
        quarters, angle = _quarters(move.angle, given, variables)
        slopes = [[variables.index(n), float(f)] for n, f in move.angle.terms if n in variables]
        return ["r", move.axis, quarters, angle, slopes]
    if isinstance(move, Fixed):
        rows = [[float(Floats(given).length(entry)) for entry in row] for row in move.rows]
        columns = [[rows[i][k] for i in range(3)] for k in range(3)]
        return ["m", columns, *_offset([row[3] for row in move.rows], variables, given)]
    return ["t", None, *_offset(list(move.offset), variables, given)]


def _quarters(angle: Angle, given: Given, variables: tuple[str, ...]) -> tuple[int, float]:
    """The constant part of an angle: quarter turns, exactly, and what is left in radians."""
    known = {name: value for name, value in given.items() if isinstance(value, Angle) and name not in variables}
    constant = angle.substitute(known)
    quarters = int(constant.degrees // 90)
    rest = Angle((), constant.degrees - 90 * quarters, constant.radians).constant()
    for name, factor in constant.terms:
        if name not in variables:
            rest += float(factor) * float(given[name])  # type: ignore[arg-type]
    return quarters % 4, rest


def _offset(lengths: list[Expr], variables: tuple[str, ...], given: Given) -> tuple[list[float], list[Any]]:
    """A translation at joint values of zero, and how it grows with each joint."""
    joints = dict.fromkeys(variables, 0.0)
    start = [float(Floats({**given, **joints}).length(length)) for length in lengths]
    slopes = []
    for number, name in enumerate(variables):
        end = [float(Floats({**given, **joints, name: 1.0}).length(length)) for length in lengths]
        slope = [b - a for a, b in zip(start, end, strict=True)]
        if any(slope):
            slopes.append([number, slope])
    return start, slopes


def _table(robot: Robot, given: Given) -> dict[str, Any]:
    rows = []
    for link in robot.links:
        row: list[dict[str, Any]] = [{"words": [[str(link.number), 0]]}]
        for column, words in zip(robot.columns if link.row else ("product",), cells(robot, link), strict=True):
            row.append({"words": words_data(words), **_live(robot, link.row, column, given)})
        rows.append(row)
    return {"heads": [words_data(head) for head in heads(robot)], "rows": rows}


def _live(robot: Robot, row: object, column: str, given: Given) -> dict[str, Any]:
    """What a cell comes to, with the joints that it follows."""
    if row is None:
        return {}
    cell = getattr(row, column)
    if isinstance(cell, Angle):
        quarters, rest = _quarters(cell, given, robot.variables)
        value: float = math.pi / 2 * quarters + rest
        slopes = [[robot.variables.index(n), float(f)] for n, f in cell.terms if n in robot.variables]
        live = bool(cell.terms)
    else:
        start, found = _offset([cell], robot.variables, given)
        value, slopes = start[0], [[number, slope[0]] for number, slope in found]
        live = bool(slopes) or not cell_is_number(cell)
    if not live:
        return {}
    return {"v": float(f"{value:.9g}"), "j": slopes, **({"angle": 1} if isinstance(cell, Angle) else {})}


def cell_is_number(cell: Expr) -> bool:
    """Whether a cell already shows its value."""
    from dhcli.notation.tree import Number

    return isinstance(cell, Number)


def _number(value: Value) -> float:
    return float(in_floats(value))
