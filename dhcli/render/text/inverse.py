"""Answers of inverse kinematics: a row for each solution, what is free, and why there is none."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import fields, replace
from typing import Any

from dhcli.errors import plural
from dhcli.geometry.euler import RollPitchYaw
from dhcli.kinematics.conventions import NAMES
from dhcli.kinematics.inverse.answer import InverseKinematics
from dhcli.kinematics.inverse.explained import Explanation
from dhcli.kinematics.inverse.solutions import shown_beyond
from dhcli.kinematics.limits import far_limits
from dhcli.render.code.matrices import csv_line, exact
from dhcli.render.look import Look
from dhcli.render.paper import Paper
from dhcli.render.text.forward import frame_words, packed
from dhcli.render.text.matrix import aligned
from dhcli.render.text.prose import prose_lines
from dhcli.render.text.quantities import in_units, value_lines
from dhcli.render.text.table import columns_of, table_text

_WORDS = {
    "pose": "pose",
    "position": "position",
    "orientation": "orientation",
    "axis": "position and z axis",
    "direction": "direction of z",
}
"""What of a frame a task places."""

_COUNTS = {
    "pose": ("position", "rotation"),
    "position": ("position",),
    "orientation": ("rotation",),
    "axis": ("position", "z"),
    "direction": ("z",),
}
"""What of the pose asked for a task looks at."""


def inverse_table(result: InverseKinematics, look: Look) -> str:
    """The whole answer, to be read from top to bottom."""
    paper = look.paper
    context = [NAMES[result.robot.convention], *value_lines(result.robot, result.lengths), "lengths in m"]
    placed = f"{_WORDS[result.task]} of {frame_words(result.end)} of {result.robot.name}"
    title = f"{placed}, seen from {frame_words(result.start)}"
    lines = [
        *(paper.ink(line, "bold") for line in prose_lines(f"inverse kinematics: {title}", paper)),
        *(paper.ink(line, "dim") for line in packed(map(paper.spell, context), paper)),
        *packed(map(paper.spell, _target(result, look)), paper),
        "",
    ]
    body = _solutions(result, look) if len(result.solutions) else _nothing(result, look)
    text = "\n".join([*lines, *body]) + "\n"
    return text if result.how is None else text.rstrip("\n") + "\n" + "\n".join(_how(result.how, look)) + "\n"


def _target(result: InverseKinematics, look: Look) -> Iterator[str]:
    """What is to be reached, as it was read."""
    for name, value in _asked(result).items():
        if name == "rotation":
            turn = RollPitchYaw.of(value)
            yield f"rpy {', '.join(f'{look.number(math.degrees(angle))}°' for angle in turn.numbers)}"
        else:
            unit = " m" if name == "position" else ""
            yield f"{name} {', '.join(map(look.number, value))}{unit}"


def _asked(result: InverseKinematics) -> dict[str, Any]:
    """What of the pose counts: where the origin is, the rotation, where z points."""
    rows = [[exact(entry) for entry in row] for row in result.pose[:3]]
    parts = {"position": [row[3] for row in rows], "rotation": [row[:3] for row in rows], "z": [row[2] for row in rows]}
    return {name: parts[name] for name in _COUNTS[result.task]}


def _solutions(result: InverseKinematics, look: Look) -> Iterator[str]:
    found, paper = result.solutions, look.paper
    product = " × ".join(f"{count} ({name})" for name, count in found.factors) if len(found.factors) > 1 else ""
    yield paper.spell(" = ".join(filter(None, (plural(len(found), "solution"), product))))
    yield ""
    numbers: dict[str, list[str]] = {"#": [str(k + 1) for k in range(len(found))]}
    for j, name in enumerate(result.robot.variables):
        numbers[name] = aligned([paper.spell(_value(result, j, float(q[j]), look)) for q in found])
    if result.near is not None:
        numbers["distance"] = aligned(look.numbers(found.travels(list(result.near)).tolist()))
    words: dict[str, list[str]] = {}
    if any(found.branches):
        words["branch"] = list(found.branches)
    if result.robot.limits or far_limits(result.robot) is not None:
        words["limits"] = [
            ", ".join(shown_beyond(result.robot, outside) for outside in beyond) or "ok" for beyond in found.beyond
        ]
    yield from _rows(numbers, words, paper)
    for relation, rows in _families(result).items():
        which = ", ".join(str(k + 1) for k in rows)
        yield from prose_lines(f"{which}: {relation}; one member is shown, --hold NAME=VALUE another", paper)


def _rows(numbers: dict[str, list[str]], words: dict[str, list[str]], paper: Paper) -> Iterator[str]:
    """A table; on a terminal too narrow for it words stand below the numbers, or names before each number as well."""
    whole, narrow = (
        table_text(list(columns), zip(*columns.values(), strict=True), paper) for columns in (numbers | words, numbers)
    )
    if not paper.terminal or _width(whole) <= paper.width:
        yield whole
        return
    if "limits" in words:
        words["limits"] = [f"limits: {text}" for text in words["limits"]]
    told = [list(filter(None, row)) for row in zip(*words.values(), strict=True)] or [[] for _ in numbers["#"]]
    if _width(narrow) <= paper.width:
        head, rule, *lines = narrow.splitlines()
        yield from (head, rule)
    else:
        names = [name for name in numbers if name != "#"]
        lines = []
        for k, number in enumerate(numbers["#"]):
            values = (f"{paper.spell(name)} = {numbers[name][k].strip()}" for name in names)
            lines.append(
                "\n     ".join(packed((f" {number}   {next(values)}", *values), replace(paper, width=paper.width - 5)))
            )
    for line, below in zip(lines, told, strict=True):
        yield line
        for text in packed(below, replace(paper, width=paper.width - 5)):
            yield from (paper.ink(one, "dim") for one in prose_lines(text, paper, "     ", "     "))
    yield ""


def _width(table: str) -> int:
    return max(map(columns_of, table.splitlines()))


def _how(how: Explanation, look: Look) -> Iterator[str]:
    """How the answer came about."""
    paper = look.paper
    by = f", by rule {' and '.join(how.rules)}" if how.rules else ""
    where = (f"where {', '.join(how.moves)}",) if how.moves else ()
    headed = ((f"How{by}", (*where, *how.steps)), ("Outside the limits", how.limits))
    for head, lines in headed:
        if lines:
            yield ""
            yield paper.ink(head, "bold")
            for line in lines:
                yield from prose_lines(line, paper, "  ", "    ")


def _families(result: InverseKinematics) -> dict[str, list[int]]:
    """What is free, and in which solutions."""
    found: dict[str, list[int]] = {}
    for k, ways in enumerate(result.solutions.free):
        for way in ways:
            found.setdefault(way.relation, []).append(k)
    return found


def _nothing(result: InverseKinematics, look: Look) -> Iterator[str]:
    """Why there is no solution, and the joint values that come nearest."""
    paper, found = look.paper, result.solutions
    yield paper.ink("no solution", "bold")
    for reason in found.why.split("; "):
        yield from prose_lines(reason, paper, "  ", "    ")
    if found.closest is not None:
        values = [
            f"{name} = {_value(result, j, float(found.closest[j]), look)}"
            for j, name in enumerate(result.robot.variables)
        ]
        yield from prose_lines(f"nearest with {', '.join(values)}", paper, "  ", "    ")


def _value(result: InverseKinematics, joint: int, value: float, look: Look) -> str:
    """A joint value for people: degrees, or metres."""
    turns = result.robot.joints[joint].kind == "revolute"
    return f"{look.number(math.degrees(value))}°" if turns else f"{look.number(value)} m"


def inverse_csv(result: InverseKinematics, _look: Look) -> str:
    """A line for each solution: its branch, whether it keeps the limits, and all joint values in radians and metres."""
    found = result.solutions
    lines = [csv_line(["branch", "within_limits", *result.robot.variables])]
    for branch, inside, q in zip(found.branches, found.within_limits.tolist(), found.q.tolist(), strict=True):
        lines.append(csv_line([branch, str(inside).lower(), *(repr(exact(x)) for x in q)]))
    return "".join(lines)


def inverse_latex(result: InverseKinematics, look: Look) -> str:
    """The joint values as an array, a row for each solution; angles in degrees."""
    found = result.solutions
    body = " \\\\\n".join(
        "  " + " & ".join(_latex(_value(result, j, float(x), look)) for j, x in enumerate(q)) for q in found.q.tolist()
    )
    return f"\\begin{{array}}{{{'r' * len(result.robot.variables)}}}\n{body}\n\\end{{array}}\n"


def _latex(value: str) -> str:
    return value.replace("°", r"^\circ").replace(" m", r"\,\mathrm{m}")


def inverse_content(result: InverseKinematics, _look: Look) -> dict[str, Any]:
    """The answer as JSON holds it."""
    found = result.solutions
    how = result.how
    residual = [0.0] * len(found) if found.residual is None else found.residual.tolist()
    return {
        "robot": result.robot.name,
        "convention": result.robot.convention.value,
        "values": {name: in_units(value) for name, value in result.lengths.items()},
        "task": result.task,
        "reference": result.start,
        "frame": result.end,
        "target": _asked(result),
        "joints": list(result.robot.variables),
        "reachable": found.reachable,
        "why": found.why,
        "held": dict(found.held),
        "factors": dict(found.factors),
        "how": None if how is None else {f.name: getattr(how, f.name) for f in fields(how)},
        "closest": None if found.closest is None else [exact(x) for x in found.closest.tolist()],
        "solutions": [
            {
                "q": [exact(x) for x in q],
                "branch": found.branches[k],
                "within_limits": not found.beyond[k],
                "beyond": {outside.joint: outside.by for outside in found.beyond[k]},
                "residual": residual[k],
                "free": [
                    {"joint": way.joint, "joints": list(way.joints), "relation": way.relation} for way in found.free[k]
                ],
            }
            for k, q in enumerate(found.q.tolist())
        ],
    }
