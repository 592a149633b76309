"""What a page must know: the chain of moves, the scene in its states, the table; the joints of a linkage."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from dhcli.algebra.floats import Floats
from dhcli.errors import DhcliError
from dhcli.kinematics.moves import Fixed, Move, Rot
from dhcli.kinematics.robot import Robot, Value
from dhcli.kinematics.sweep.workspace import Workspace
from dhcli.kinematics.validity import in_floats
from dhcli.kinematics.values import JointInput, Values, numbers
from dhcli.mobility.linkage import Joint, Linkage
from dhcli.notation.angle import Angle
from dhcli.notation.tree import Expr
from dhcli.scene.camera import VIEWS
from dhcli.scene.linkages import stage_linkage
from dhcli.scene.motion import joints_of
from dhcli.scene.places import Places
from dhcli.scene.plane import circles
from dhcli.scene.primitives import Ball, Box, Drum, Face, Scene, Solid
from dhcli.scene.skeleton import Given
from dhcli.scene.space import holder
from dhcli.scene.staging import posed, stage_arm, values_at
from dhcli.scene.table import cells, heads
from dhcli.scene.vectors import Vec
from dhcli.scene.words import Words, named, spelled
from dhcli.scene.workspace import is_at_base

if TYPE_CHECKING:
    from dhcli.scene.drawing import Drawing


def arm_model(picture: Drawing) -> dict[str, Any]:
    """A robot, its joints at the values of the picture."""
    robot = picture.what
    assert isinstance(robot, Robot)  # noqa: S101  the caller has looked
    q: JointInput = joints_of(robot, picture.path[0]) if picture.path else picture.q  # type: ignore[assignment]
    staged = stage_arm(robot, q, pose=picture.pose, view=picture.view, parameters=picture.parameters, bare=picture.bare)
    values = values_at(robot, q, picture.pose, picture.parameters, picture.bare)
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
        "scene": _scene(staged.scene),
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


UNMOVED = frozenset({"gear", "rolling"})
"""Joints in space whose motion a page does not know: it only turns a linkage that has one."""


def space_model(picture: Drawing) -> dict[str, Any]:
    """A linkage in space: its scene, each part on the link that holds it, and what its joints demand."""
    linkage = picture.what
    assert isinstance(linkage, Linkage)  # noqa: S101  the caller has looked
    staged = stage_linkage(linkage, picture.view)
    views = [["best", list(staged.view)], *([name, list(view)] for name, view in VIEWS.items())]
    places = Places(linkage)
    number = {link: i for i, link in enumerate(linkage.links)}
    seen: dict[str, Any] = {
        "name": linkage.name,
        "view": list(staged.view),
        "views": views,
        "scene": _scene(staged.scene),
        "links": list(linkage.links),
        "points": [[_words(named(name)), list(at), number[holder(places, at)]] for name, at in places.named()],
    }
    if any(joint.pair.name in UNMOVED for joint in linkage.joints):
        return seen
    held = [list(at) for at in places.at]
    spots = [point for _, point, _ in seen["points"]]
    return {
        **seen,
        "size": places.size,
        "centre": [sum(p[i] for p in held) / len(held) for i in range(3)],
        "ground": number[linkage.ground],
        "ties": [_spatial(joint, at, number, spots) for joint, at in zip(linkage.joints, places.at, strict=True)],
        "output": number.get(linkage.output, -1),
    }


def _spatial(joint: Joint, at: Vec, number: dict[str, int], spots: list[list[float]]) -> dict[str, Any]:
    """A joint in space: its kind, its links, and the geometry that it has; a point that has a name by its number."""
    point = list(at if joint.point is None else joint.point)
    geometry = {"u": joint.axis, "v": joint.axis2, "s": joint.slide, "o": joint.other, "h": joint.pitch}
    return {
        "t": joint.pair.name,
        **({"name": joint.name} if joint.pair.name in ("revolute", "prismatic") else {}),
        "a": number[joint.links[0]],
        "b": number[joint.links[1]],
        "p": spots.index(point) if point in spots else point,
        **{key: value for key, value in geometry.items() if value is not None},
    }


def plane_model(linkage: Linkage) -> dict[str, Any]:
    """A planar linkage: what its joints demand, and the points that are drawn."""
    places = Places(linkage)
    links = list(linkage.links)
    number = {link: i for i, link in enumerate(links)}
    joints = []
    for joint, at in zip(linkage.joints, places.at, strict=True):
        joints.append(
            {
                "t": joint.pair.name,
                "a": number[joint.links[0]],
                "b": number[joint.links[1]],
                "p": _flat(at),
                "o": _flat(joint.other),
                "u": _flat(joint.axis if joint.pair.name == "prismatic" else joint.slide),
                "c": number.get(joint.carrier or "", -1),
                "r": joint.radii,
                "n": joint.internal,
            }
        )
    points = []
    for name, at in places.named():
        points.append([_words(named(name)), _flat(at), number[holder(places, at)]])
    return {
        "name": linkage.name,
        "size": places.size,
        "ground": number[linkage.ground],
        "bar": linkage.ground != "ground",
        "links": [[link, [_flat(p) for p in places.links[link]]] for link in links],
        "joints": joints,
        "circles": [[number[link], _flat(centre), radius] for link, centre, radius in circles(places)],
        "points": points,
        "output": number.get(linkage.output, -1),
    }


def _joint(robot: Robot, name: str, value: Value) -> dict[str, Any]:
    joint = next(each for each in robot.joints if each.name == name)
    low, high = (map(in_floats, robot.limits[name])) if name in robot.limits else (None, None)
    at = _number(value)
    reach = math.pi if joint.kind == "revolute" else max(1.5 * abs(at), _longest(robot), 0.1)
    ends = {"from": min(-reach, at), "till": max(reach, at)} if low is None else {"lo": low, "hi": high}
    return {"name": name, "words": _words(named(name)), "kind": joint.kind, **ends, "q": at}


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
    quarters = math.floor(constant.degrees / 90)
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
            row.append({"words": _words(words), **_live(robot, link.row, column, given)})
        rows.append(row)
    return {"heads": [_words(head) for head in heads(robot)], "rows": rows}


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


def _scene(scene: Scene) -> dict[str, Any]:
    """The scene, in as many digits as a drawing needs."""
    return {key: _short(value) for key, value in _whole_scene(scene).items()}


def _short(value: Any) -> Any:  # noqa: ANN401  anything that JSON knows
    if isinstance(value, float):
        return int(value) if value == int(value) and abs(value) < 1e6 else float(f"{value:.6g}")  # noqa: PLR2004
    return [_short(each) for each in value] if isinstance(value, list | tuple) else value


def _whole_scene(scene: Scene) -> dict[str, Any]:
    plate, hand = scene.plate, scene.hand
    return {
        "unit": scene.unit,
        "solids": [_solid(solid) for solid in scene.solids],
        "rods": [[r.start.state, r.start.at, r.end.state, r.end.at, r.thickness, int(r.ground)] for r in scene.rods],
        "dims": [
            [d.start.state, d.start.at, d.end.state, d.end.at, _words(d.words), d.variable, d.direct]
            for d in scene.dimensions
        ],
        "plate": plate and [plate.centre.state, plate.centre.at, plate.normal, plate.size, plate.broken],
        "hand": hand and [hand.wrist.state, hand.wrist.at, hand.forward, hand.across, hand.size],
        "pinned": [[anchor.state, anchor.at] for anchor in scene.pinned],
    }


def _solid(solid: Solid) -> list[Any]:
    if isinstance(solid, Face):
        return ["face", [[c.state, c.at] for c in solid.corners], solid.ground]
    if isinstance(solid, Ball):
        return ["ball", solid.centre.state, solid.centre.at, solid.radius]
    if isinstance(solid, Drum):
        words = _words(spelled(solid.name))
        return ["drum", solid.centre.state, solid.centre.at, solid.axis, solid.radius, solid.half, words]
    assert isinstance(solid, Box)  # noqa: S101  the last kind
    return ["box", solid.centre.state, solid.centre.at, solid.axis, solid.half]


def _words(words: Words) -> list[list[Any]]:
    return [[run.text, int(run.below)] for run in words]


def _flat(point: tuple[float, float, float] | None) -> list[float] | None:
    return None if point is None else [point[0], point[1]]


def _number(value: Value) -> float:
    return float(in_floats(value))
