"""Answers of inverse kinematics: a row for each solution, what is free, and why there is none."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from dhcli.errors import plural
from dhcli.kinematics.conventions import NAMES
from dhcli.kinematics.farlimits import far_limits
from dhcli.kinematics.inverse.answer import InverseKinematics
from dhcli.kinematics.inverse.solutions import shown_beyond
from dhcli.render.code.matrices import csv_line, exact
from dhcli.render.look import Look
from dhcli.render.text.forward import frame_words, packed
from dhcli.render.text.matrix import aligned
from dhcli.render.text.quantities import in_units, value_lines
from dhcli.render.text.table import table_text

_WORDS = {
    "pose": "pose",
    "position": "position",
    "orientation": "orientation",
    "axis": "position and z axis",
    "direction": "direction of z",
}
"""What of a frame a task places."""


def inverse_table(result: InverseKinematics, look: Look) -> str:
    """The whole answer, to be read from top to bottom."""
    paper = look.paper
    context = [NAMES[result.robot.convention], *value_lines(result.robot, result.lengths), "lengths in m"]
    placed = f"{_WORDS[result.task]} of {frame_words(result.end)} of {result.robot.name}"
    title = f"{placed}, seen from {frame_words(result.start)}"
    lines = [
        paper.ink(paper.spell(f"inverse kinematics: {title}"), "bold"),
        *(paper.ink(line, "dim") for line in packed(map(paper.spell, context), paper)),
        "",
    ]
    body = _solutions(result, look) if len(result.solutions) else _nothing(result, look)
    return "\n".join([*lines, *body]) + "\n"


def _solutions(result: InverseKinematics, look: Look) -> Iterator[str]:
    found, paper = result.solutions, look.paper
    yield paper.spell(plural(len(found), "solution"))
    yield ""
    columns: dict[str, list[str]] = {"#": [str(k + 1) for k in range(len(found))]}
    for j, name in enumerate(result.robot.variables):
        columns[name] = aligned([paper.spell(_value(result, j, float(q[j]), look)) for q in found])
    if result.near is not None:
        columns["distance"] = aligned(look.numbers(found.distances(list(result.near)).tolist()))
    if any(found.branches):
        columns["branch"] = list(found.branches)
    if result.robot.limits or far_limits(result.robot) is not None:
        columns["limits"] = [
            ", ".join(shown_beyond(result.robot, outside) for outside in beyond) or "ok" for beyond in found.beyond
        ]
    yield table_text(list(columns), zip(*columns.values(), strict=True), paper)
    for relation, rows in _families(result).items():
        numbers = ", ".join(str(k + 1) for k in rows)
        yield paper.spell(f"{numbers}: {relation}; one member is shown, --hold NAME=VALUE another")


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
        yield paper.spell(f"  {reason}")
    if found.closest is not None:
        values = [
            f"{name} = {_value(result, j, float(found.closest[j]), look)}"
            for j, name in enumerate(result.robot.variables)
        ]
        yield paper.spell(f"  nearest with {', '.join(values)}")


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
    residual = [0.0] * len(found) if found.residual is None else found.residual.tolist()
    return {
        "robot": result.robot.name,
        "convention": result.robot.convention.value,
        "values": {name: in_units(value) for name, value in result.lengths.items()},
        "task": result.task,
        "reference": result.start,
        "frame": result.end,
        "joints": list(result.robot.variables),
        "reachable": found.reachable,
        "why": found.why,
        "held": dict(found.held),
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
