"""What stands under `data` in JSON for Jacobians, singularities, torques and rates."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from dhcli.kinematics.robot import Robot
from dhcli.kinematics.singular.result import Factor
from dhcli.kinematics.values import Values
from dhcli.kinematics.velocity.answers import JacobianAnswer, SingularAnswer, TorquesAnswer, VelocityAnswer
from dhcli.kinematics.velocity.view import MotionView
from dhcli.notation.styles import Joints
from dhcli.render.code.matrices import exact
from dhcli.render.json.contents import number, plain_number
from dhcli.render.look import Look
from dhcli.render.text.quantities import in_units

if TYPE_CHECKING:  # it comes with numpy
    from dhcli.kinematics.singular.standing import Standing


def jacobian_content(result: JacobianAnswer, look: Look) -> dict[str, Any]:
    """A Jacobian: its matrix, what the rows and columns are, of which point, along which axes."""
    found, joints = result.jacobian, result.robot.writing
    content: dict[str, Any] = {
        **_asked(result.robot, result.values),
        "symbolic": found.is_symbolic,
        **view_content(found.view, joints, look),
        "rows": list(found.labels),
        "joints": list(found.joints),
        "matrix": [[number(entry, joints, look) for entry in row] for row in found.rows],
    }
    if result.definitions:
        content["definitions"] = [
            {"name": one.name, "value": number(one.expr, joints, look)} for one in result.definitions
        ]
    return content


def view_content(view: MotionView, joints: Joints, look: Look) -> dict[str, Any]:
    """The frame along whose axes things are written, the two frames, and the point in the frame it is given in."""
    return {
        "frame": view.axes,
        "from": view.start,
        "to": view.end,
        "point": {"frame": view.place, "at": [plain_number(value, joints, look) for value in view.point]},
    }


def singular_content(result: SingularAnswer, look: Look) -> dict[str, Any]:
    """Singularities: the determinant or none, and each factor or condition with what it means."""
    found, joints = result.found, result.robot.writing
    content: dict[str, Any] = {
        **_asked(result.robot, result.values),
        **{key: value for key, value in view_content(result.view, joints, look).items() if key != "frame"},
        "part": found.part,
        "rows": list(found.rows),
        "joints": list(found.joints),
        "finding": found.finding,
        "rank": found.rank,
        "still": list(found.still),
        "place": found.place,
        "determinant": None if found.determinant is None else number(found.determinant, joints, look),
        "factors": [_factor(factor, joints, look) for factor in found.factors],
        "probed": [{name: 90 * quarters for name, quarters in turns.items()} for turns in found.probed],
    }
    if result.standing is not None:
        content["at"] = _standing(result.standing)
    return content


def _factor(factor: Factor, joints: Joints, look: Look) -> dict[str, Any]:
    return {
        "text": factor.text("short", joints),
        "zeros": [number(zero, joints, look) for zero in factor.zeros],
        "exponent": factor.exponent,
        "joints": list(factor.joints),
        "angles": factor.angles,
        "words": factor.words,
        "dependent": list(factor.dependent),
        "lost": factor.lost,
    }


def _standing(standing: Standing) -> dict[str, Any]:
    measures = standing.measures
    return {
        "rank": measures.rank,
        "singular_values": [exact(value) for value in measures.values],
        "manipulability": exact(measures.manipulability),
        "condition": None if measures.condition is None else exact(measures.condition),
        "determinant": None if standing.determinant is None else exact(standing.determinant),
        "factors": [
            {
                "factor": one.factor,
                "values": [exact(value) for value in one.values],
                "distance": exact(one.distance) if math.isfinite(one.distance) else None,
            }
            for one in standing.distances
        ],
    }


def torques_content(result: TorquesAnswer, look: Look) -> dict[str, Any]:
    """Torques: a number and a unit for each joint."""
    found, joints = result.torques, result.robot.writing
    return {
        **_asked(result.robot, result.values),
        **view_content(found.view, joints, look),
        "force": [number(value, joints, look) for value in found.wrench.force],
        "moment": [number(value, joints, look) for value in found.wrench.moment],
        "joints": list(found.joints),
        "units": [unit.replace(" ", "*") for unit in found.units],
        "torques": [number(value, joints, look) for value in found.values],
    }


def velocity_content(result: VelocityAnswer, look: Look) -> dict[str, Any]:
    """Rates and the velocity they give; how they were found where a velocity was asked for."""
    joints, solved = result.robot.writing, result.solved
    content: dict[str, Any] = {
        **_asked(result.robot, result.values),
        **view_content(result.view, joints, look),
        "joints": list(result.joints),
        "rates": [number(value, joints, look) for value in result.rates],
        "rows": list(result.labels),
        "velocity": [number(value, joints, look) for value in result.velocity],
    }
    if solved is not None:
        content["solved"] = {
            "wanted": [exact(value) for value in solved.wanted],
            "reached": solved.is_reached,
            "rank": solved.rank,
            "damping": solved.damping,
            "idle": [[exact(value) for value in row] for row in solved.idle],
        }
    return content


def _asked(robot: Robot, values: Values) -> dict[str, Any]:
    return {"robot": robot.name, "values": {name: in_units(value) for name, value in values.items()}}
