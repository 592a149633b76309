"""Poses and Jacobians as functions that run, in each language, and as data in JSON."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from dhcli.kinematics.conventions import NAMES
from dhcli.kinematics.frames import View
from dhcli.kinematics.generated import Function
from dhcli.kinematics.pose import Pose
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.velocity.answers import JacobianAnswer
from dhcli.kinematics.velocity.jacobian import Jacobian
from dhcli.notation.writer import write
from dhcli.render.code.language import Heading, Spelling
from dhcli.render.code.languages import LANGUAGES
from dhcli.render.look import Look
from dhcli.render.text.forward import sentence
from dhcli.render.text.velocity import rows_words, title


def function_code(result: Function, look: Look) -> str:
    """A file with one function: joint values and lengths in, a matrix out."""
    language = LANGUAGES[look.format]
    spelling = language.spelling([*result.joints, *result.lengths, *(one.name for one in result.formulas.definitions)])
    is_pose = isinstance(result.view, View)
    name, letter = ("forward", "T") if is_pose else ("jacobian", "J")
    cells = [[spelling.formula(entry) for entry in row] for row in result.rows]
    heading = Heading(name, list(_said(result, spelling)), result.joints, result.lengths, gives=letter)
    if language.name == "c":
        size = f"double {letter}[{len(cells)}][{len(cells[0])}]"
        heading = Heading(name, heading.said, result.joints, result.lengths, filled=[size], gives="void")
    body = [spelling.let(one.name, spelling.formula(one.expr)) for one in result.formulas.definitions]
    shape = [spelling.names[joint] for joint in result.joints]
    return language.function(heading, spelling, [*body, *language.returned(shape, letter, cells)])


def _said(result: Function, spelling: Spelling) -> Iterator[str]:
    """What the function gives and takes, in units, and where its numbers come from."""
    robot, names = result.robot, spelling.names
    if isinstance(result.view, View):
        pose = Pose(result.rows, result.view.reference, result.view.frame, joints=robot.writing)
        yield f"{sentence(pose, robot.name)}."
    else:
        answer = _answer(result)
        yield f"{title(answer)}."
        yield f"Has {'; '.join(rows_words(answer, Look()))}; columns {', '.join(answer.jacobian.joints)}."
    yield f"{robot_words(robot)}; radians and metres."
    kinds = {joint.name: joint.kind for joint in robot.joints}
    units = [f"{names[j]} [{'m' if kinds.get(j) == 'prismatic' else 'rad'}]" for j in result.joints]
    if units:
        yield f"Joint values: {', '.join(units)}."
    yield from lengths_words(robot, {name: names[name] for name in result.lengths})
    yield f"Source: {robot.source}"


def robot_words(robot: Robot) -> str:
    """What a robot is called, and its convention."""
    convention = NAMES[robot.convention]
    return robot.title if convention in robot.title else f"{robot.title}, {convention}"


def lengths_words(robot: Robot, names: Mapping[str, str]) -> Iterator[str]:
    """Lengths and constant angles that a function takes, in their units."""
    if names:
        kind = "Lengths" if robot.angles.isdisjoint(names) else "Lengths and constant angles"
        units = (f"{spelled} [{'rad' if name in robot.angles else 'm'}]" for name, spelled in names.items())
        yield f"{kind}: {', '.join(units)}."


def _answer(result: Function) -> JacobianAnswer:
    """A Jacobian as its words are made of."""
    assert not isinstance(result.view, View), "a pose has words of its own"  # noqa: S101
    assert result.form is not None, "a Jacobian has one"  # noqa: S101
    found = Jacobian(result.rows, result.form.labels, result.moving, result.view, result.form)
    return JacobianAnswer(result.robot, {}, found)


def function_content(result: Function, _look: Look) -> dict[str, Any]:
    """The formulas as JSON holds them, as sympy reads them, for whoever writes another language."""
    return {
        "robot": result.robot.name,
        "joints": list(result.joints),
        "lengths": dict(result.lengths),
        "definitions": [{"name": one.name, "formula": write(one.expr, "sympy")} for one in result.formulas.definitions],
        "rows": [[write(entry, "sympy") for entry in row] for row in result.rows],
        "operations": result.operations,
        "cosines_and_sines": result.turns,
    }
