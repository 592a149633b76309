"""Answers of `sweep`: the grid, how far it reaches, and the poses at the sides of its box."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, TypeAlias

from dhcli.files.rows import POSITION
from dhcli.kinematics.conventions import NAMES
from dhcli.kinematics.derived import in_floats
from dhcli.kinematics.robot import Value
from dhcli.kinematics.sweep.grid import Axis
from dhcli.kinematics.sweep.result import Extreme, Sweep
from dhcli.notation.angle import Angle
from dhcli.render.code.matrices import csv_line, exact
from dhcli.render.look import Look
from dhcli.render.text.forward import frame_words, packed
from dhcli.render.text.matrix import aligned
from dhcli.render.text.prose import heading_text
from dhcli.render.text.quantities import in_units, value_lines
from dhcli.render.text.table import table_text

Columns: TypeAlias = Mapping[str, Sequence[str]]
"""Cells of a table by the heads of its columns."""

NARROW = 80
"""Columns of a usual window: a table that would be wider is drawn in parts, on any paper."""
BETWEEN = "extremes of this grid; between its poses the robot may reach a little further"
_GAP = 3
_AXES = "xyz"


def sweep_table(result: Sweep, look: Look) -> str:
    """The whole answer, to be read from top to bottom."""
    paper, target, grid = look.paper, result.target, result.grid
    context = [NAMES[target.robot.convention], *value_lines(target.robot, target.lengths), "lengths in m"]
    held = [f"{axis.name} = {_value(result, axis, axis.first, look)}" for axis in grid.held]
    dim = [*packed(map(paper.spell, context), paper)]
    if held:
        dim += packed(map(paper.spell, (f"held: {held[0]}", *held[1:])), paper)
    lines = [
        heading_text(_heading(result, look), paper),
        *(paper.ink(line, "dim") for line in dim),
        "",
        _axes(result, look),
        paper.spell(f"{grid.count:,} poses; {_reach(result, look)}"),
        paper.spell("box: " + " · ".join(_side(result, k, look) for k in range(3))),
        "",
        *_extremes(result, look),
        paper.ink(BETWEEN, "dim"),
        *paper.aside(f"whether one pose is reached: dhcli ik {target.robot.typed}"),
    ]
    return "\n".join(lines) + "\n"


def sweep_csv(result: Sweep, _look: Look) -> str:
    """A line for each extreme: what it is, distance, position, and all joint values in radians and metres."""
    names = [axis.name for axis in result.grid.axes]
    lines = [csv_line(["extreme", "distance", *POSITION, *names])]
    for name, extreme in _named(result):
        numbers = (extreme.distance, *extreme.position, *map(in_floats, extreme.q.values()))
        lines.append(csv_line([name, *(repr(exact(number)) for number in numbers)]))
    return "".join(lines)


def sweep_content(result: Sweep, _look: Look) -> dict[str, Any]:
    """The answer as JSON holds it."""
    target = result.target
    return {
        "robot": target.robot.name,
        "convention": target.robot.convention.value,
        "values": {name: in_units(value) for name, value in target.lengths.items()},
        "reference": target.view.start,
        "frame": target.view.end,
        "point": list(target.coordinates),
        "poses": result.grid.count,
        "joints": [
            {"name": axis.name, "first": in_floats(axis.first), "last": in_floats(axis.last), "count": axis.count}
            for axis in result.grid.axes
        ],
        "box": [[exact(low), exact(high)] for low, high in result.box],
        "extremes": {name: _content(extreme) for name, extreme in _named(result)},
    }


def _content(extreme: Extreme) -> dict[str, Any]:
    return {
        "distance": exact(extreme.distance),
        "position": [exact(coordinate) for coordinate in extreme.position],
        "q": {name: in_floats(value) for name, value in extreme.q.items()},
    }


def _named(result: Sweep) -> Iterator[tuple[str, Extreme]]:
    yield "farthest", result.farthest
    yield "nearest", result.nearest
    yield from result.sides.items()


def _heading(result: Sweep, look: Look) -> str:
    target = result.target
    what = "origin" if not any(target.coordinates) else f"({', '.join(map(look.number, target.coordinates))})"
    of, seen_from = frame_words(target.view.end), frame_words(target.view.start)
    return f"sweep of {target.robot.name}: {what} of {of}, seen from {seen_from}"


def _reach(result: Sweep, look: Look) -> str:
    least, most = look.numbers(extreme.distance for extreme in (result.nearest, result.farthest))
    return f"reach {least} to {most} m from the origin of {frame_words(result.target.view.start)}"


def _side(result: Sweep, k: int, look: Look) -> str:
    low, high = look.numbers(result.box[k])
    return f"{_AXES[k]} {low} to {high}"


def _axes(result: Sweep, look: Look) -> str:
    """What each joint is swept over."""
    heads = ("joint", "from", "to", "step", "values")
    rows = [
        (
            axis.name,
            *(_value(result, axis, each, look) for each in (axis.first, axis.last, axis.step)),
            f"{axis.count:,}",
        )
        for axis in result.grid.swept
    ]
    return table_text(heads, rows, look.paper)


def _extremes(result: Sweep, look: Look) -> list[str]:
    """Each extreme with its position and the joints that move; in more tables than one where that would be too wide."""
    extremes = [extreme for _, extreme in _named(result)]
    title: Columns = {"extreme": [name.replace("_", " ") for name, _ in _named(result)]}
    places = {"distance": aligned(look.numbers(extreme.distance for extreme in extremes))}
    for k, axis in enumerate(_AXES):
        places[axis] = aligned(look.numbers(extreme.position[k] for extreme in extremes))
    joints = {
        axis.name: aligned([look.paper.spell(_value(result, axis, extreme.q[axis.name], look)) for extreme in extremes])
        for axis in result.grid.swept
    }
    parts: list[Columns] = [{**places, **joints}]
    if _width({**title, **parts[0]}) > NARROW:
        parts = [places, *_parts(joints, NARROW - _width(title))]
    tables = ({**title, **part} for part in parts)
    return [table_text(list(table), zip(*table.values(), strict=True), look.paper) for table in tables]


def _parts(columns: Columns, room: int) -> Iterator[Columns]:
    """Columns in groups, each as wide as there is room, and of at least one column."""
    part: Columns = {}
    for head, cells in columns.items():
        if part and _width({**part, head: cells}) > room:
            yield part
            part = {}
        part = {**part, head: cells}
    yield part


def _width(columns: Columns) -> int:
    return sum(max(len(head), *map(len, cells)) + _GAP for head, cells in columns.items())


def _value(result: Sweep, axis: Axis, value: Value, look: Look) -> str:
    """A joint value for people: an angle in degrees, unless an end of its axis was typed in radians."""
    if not isinstance(value, Angle):
        return f"{_alone(in_floats(value), look)} m"
    ends = (axis.first, axis.last)
    in_radians = any(isinstance(end, Angle) and end.radians for end in ends)
    if in_radians and ends != result.target.robot.limits.get(axis.name):
        return f"{_alone(value.constant(), look)} rad"
    return f"{_alone(math.degrees(value.constant()) if in_radians else float(value.degrees), look)}°"


def _alone(value: float, look: Look) -> str:
    """A number by itself, with its first digits where it is small."""
    return look.numbers([value])[0]
