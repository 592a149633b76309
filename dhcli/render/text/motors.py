"""The motors of a robot: what each joint is in terms of them and back, their limits, and how torques go."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from dhcli.kinematics.actuators import Actuators, total_text
from dhcli.kinematics.robot import Robot
from dhcli.render.look import Look
from dhcli.render.text.prose import heading_text
from dhcli.render.text.quantities import in_degrees, in_units
from dhcli.render.text.table import table_text


def motors_table(robot: Robot, look: Look) -> str:
    """Both directions, for people."""
    paper, driven = look.paper, _driven(robot)
    head = f"{robot.title} · motors and joints"
    parts = {
        "joints from motors": driven.sentences(),
        "motors from joints": driven.sentences(back=True),
        "torques and forces of the motors, by the transpose": _works(driven),
    }
    lines = [heading_text(head, paper)]
    for name, sentences in parts.items():
        lines += [name, *(f"  {paper.spell(line)}" for line in sentences)]
    return "\n".join(lines) + "\n" + _limits(robot, driven, look)


def motors_content(robot: Robot, _look: Look) -> dict[str, Any]:
    """The same as JSON holds it: ratios in radians and metres."""
    driven = _driven(robot)
    return {"robot": robot.name, **actuators_content(driven)}


def actuators_content(driven: Actuators) -> dict[str, Any]:
    """Motors, ratios in radians and metres, and limits."""
    limits = {name: [in_units(value) for value in pair] for name, pair in driven.limits.items()}
    return {
        "motors": list(driven.motors),
        "joints": list(driven.joints),
        "ratios": [list(row) for row in driven.slopes()],
        "shifts": list(driven.offsets()),
        "inverse": [list(row) for row in driven.slopes(back=True)],
        "formulas": [*driven.sentences(), *driven.sentences(back=True)],
        "limits": {motor: limits.get(motor) for motor in driven.motors},
    }


def _driven(robot: Robot) -> Actuators:
    assert robot.actuators is not None  # noqa: S101  the command has asked
    return robot.actuators


def _works(driven: Actuators) -> Iterator[str]:
    """`tau_m2 = tau_theta2 + tau_theta3`: a motor's torque by those of the joints that it drives."""
    for k, motor in enumerate(driven.motors):
        if motor in driven.joints:
            continue
        pieces = [
            (row[k], driven.piece(joint, motor, abs(row[k]), called=f"tau_{joint}"))
            for joint, row in zip(driven.joints, driven.ratios, strict=True)
        ]
        yield f"tau_{motor} = {total_text(pieces)}"


def _limits(robot: Robot, driven: Actuators, look: Look) -> str:
    known = {**robot.limits, **driven.limits}
    rows = [
        [name, *map(in_degrees, known[name])]
        for name in dict.fromkeys((*driven.motors, *driven.joints))
        if name in known
    ]
    return "\n" + table_text(["limits", "from", "to"], rows, look.paper) if rows else ""
