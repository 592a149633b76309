"""Jacobians, torques and rates as tables: headings that name rows, units, point and frame."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise

from dhcli.kinematics.frames import ORIGIN
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.values import Values
from dhcli.kinematics.velocity.answers import JacobianAnswer, TorquesAnswer, VelocityAnswer
from dhcli.kinematics.velocity.form import ANGULAR, Triple
from dhcli.kinematics.velocity.view import MotionView
from dhcli.notation.styles import Joints
from dhcli.notation.tree import Expr
from dhcli.notation.writer import write
from dhcli.render.look import Look
from dhcli.render.text.forward import frame_words, legend, packed
from dhcli.render.text.matrix import cell, let_lines, matrix_lines, vector_lines
from dhcli.render.text.prose import heading_text
from dhcli.render.text.quantities import value_lines

TITLES = {True: "Joint rates", False: "Velocity"}
"""What is told, by whether a velocity was asked for."""


def jacobian_table(result: JacobianAnswer, look: Look) -> str:
    """The matrix with the names of its rows and columns, and what they are."""
    found, paper, joints = result.jacobian, look.paper, result.robot.writing
    lines = [heading_text(title(result), paper)]
    lines += [paper.ink(line, "dim") for line in packed(map(paper.spell, _said(result, look)), paper)]
    lines += let_lines(result.definitions, joints, look)
    lines += _matrix(result, look)
    if found.form.analytic and found.is_symbolic:
        triple = Triple.called(found.form.analytic)
        rates = ", ".join(f"{triple.angles[k]}'" for k in triple.order)
        note = f"{' and '.join(triple.angles[:2])} are those of the pose; ω = B ({rates}), det B = {triple.vanishing}"
        lines += [
            paper.ink(line, "dim")
            for line in packed(map(paper.spell, (note, f"no rates where {triple.singular}")), paper)
        ]
    if result.hint:
        lines.append(paper.ink(paper.spell(result.hint), "dim"))
    return "\n".join(lines) + "\n"


def title(result: JacobianAnswer) -> str:
    """What a Jacobian is of: `Jacobian of scara: frame 3 against frame 0`."""
    view, form = result.jacobian.view, result.jacobian.form
    kind = f"Jacobian with rates of {form.analytic}" if form.analytic else "Jacobian"
    if form.angular_first and view.point == ORIGIN:
        if (view.axes, view.place) == (view.start, view.start):
            kind = "Space Jacobian"
        elif (view.axes, view.place) == (view.end, view.end):
            kind = "Body Jacobian"
    return f"{kind} of {result.robot.name}: {frame_words(view.end)} against {frame_words(view.start)}"


def point_words(view: MotionView, joints: Joints, style: str) -> str:
    """The point of which a velocity is, or at which a force acts."""
    if view.point != ORIGIN:
        point = f"({', '.join(write(c, style, joints) for c in view.point)}) of {frame_words(view.place)}"
    else:
        point = f"the origin of {frame_words(view.place)}"
    return point if view.place == view.end else f"{point}, as if fixed to {frame_words(view.end)}"


def rows_words(result: JacobianAnswer, look: Look) -> Iterator[str]:
    """What the rows and columns are, with their units and axes."""
    found, robot = result.jacobian, result.robot
    style = look.style or "short"
    axes = f"along the axes of {frame_words(found.view.axes)}"
    kinds = {joint.name: joint.kind for joint in robot.joints}
    linear = f"v of {point_words(found.view, robot.writing, style)} in m/s"
    angular = f"rates of {found.form.analytic} in rad/s" if found.form.analytic else "ω in rad/s"
    said = found.form.chosen((linear,), (angular,))
    yield f"rows {' above '.join(said)}, {axes}"
    slides = {kinds[joint] for joint in found.joints}
    yield "per " + " and ".join(unit for kind, unit in (("revolute", "rad/s"), ("prismatic", "m/s")) if kind in slides)


def _said(result: JacobianAnswer, look: Look) -> list[str]:
    entries = [entry for row in result.jacobian.rows for entry in row]
    names = legend(entries, result.robot.writing, look) if result.jacobian.is_symbolic else []
    return [*rows_words(result, look), *value_lines(result.robot, result.values), *names]


def _matrix(result: JacobianAnswer, look: Look) -> list[str]:
    """The matrix, its rows and columns named; or, if it would be too wide, the entries of one column after another."""
    found, paper, joints = result.jacobian, look.paper, result.robot.writing
    labels = [paper.spell(label) for label in found.labels]
    width = max(map(len, labels))
    wide = sum(max(len(cell(row[k], joints, look)) for row in found.rows) + 2 for k in range(len(found.joints)))
    if wide + width + 4 <= paper.width:
        lines = matrix_lines(found.rows, joints, look)
        named = [f"{paper.ink(n.ljust(width), 'cyan')} {line}" for n, line in zip(labels, lines, strict=True)]
        return [paper.ink(paper.spell(f"columns {', '.join(found.joints)}"), "dim"), *named]
    lines = []
    for k, joint in enumerate(found.joints):
        lines.append(paper.ink(paper.spell(f"column {joint}"), "bold"))
        entries: list[Expr | float] = [row[k] for row in found.rows]
        lines += vector_lines(labels, entries, joints, look)
    return lines


def torques_table(result: TorquesAnswer, look: Look) -> str:
    """A torque or a force for each joint."""
    found, paper, joints = result.torques, look.paper, result.robot.writing
    style = look.style or "short"
    head = (
        f"Torques of {result.robot.name}: {frame_words(found.view.end)} presses against {frame_words(found.view.start)}"
    )
    lines = [heading_text(head, paper)]
    force, moment = (
        "(" + ", ".join(cell(part, joints, look) for part in parts) + ")"
        for parts in (found.wrench.force, found.wrench.moment)
    )
    at = point_words(found.view, joints, style)
    said = [
        f"force {force} N and moment {moment} N m at {at}",
        f"along the axes of {frame_words(found.view.axes)}",
        "the arm's own weight left aside",
    ]
    lines += context(result.robot, result.values, said, look)
    names = [f"tau_{joint}" for joint in found.joints]
    values = vector_lines(names, found.values, joints, look)
    lines += [f"{line} {unit}" for line, unit in zip(_even(values, found.values), found.units, strict=True)]
    return "\n".join(lines) + "\n"


def velocity_table(result: VelocityAnswer, look: Look) -> str:
    """Joint rates and the velocity they give."""
    paper, joints = look.paper, result.robot.writing
    view = result.view
    between = f"{frame_words(view.end)} against {frame_words(view.start)}"
    head = f"{TITLES[result.for_velocity]} of {result.robot.name}: {between}"
    lines = [heading_text(head, paper)]
    said = [f"v of {point_words(view, joints, look.style or 'short')}", f"along the axes of {frame_words(view.axes)}"]
    lines += context(result.robot, result.values, said, look)
    kinds = {joint.name: joint.kind for joint in result.robot.joints}
    rates = vector_lines([f"{joint}'" for joint in result.joints], result.rates, joints, look)
    units = ["rad/s" if kinds[joint] == "revolute" else "m/s" for joint in result.joints]
    moved = vector_lines([paper.spell(label) for label in result.labels], result.velocity, joints, look)
    turning = ["rad/s" if label in ANGULAR else "m/s" for label in result.labels]
    first = [f"{line} {unit}" for line, unit in zip(_even(rates, result.rates), units, strict=True)]
    second = [f"{line} {unit}" for line, unit in zip(_even(moved, result.velocity), turning, strict=True)]
    lines += [*first, paper.ink("gives", "dim"), *second]
    for idle in result.solved.idle if result.solved is not None else ():
        moves = ", ".join(
            f"{look.number(rate)} {joint}'"
            for joint, rate in zip(result.joints, idle, strict=True)
            if abs(rate) > 1e-9  # noqa: PLR2004
        )
        lines.append(paper.ink(paper.spell(f"moves nothing of it, at any speed: {moves}"), "dim"))
    return "\n".join(lines) + "\n"


def context(robot: Robot, values: Values, said: Sequence[str], look: Look) -> list[str]:
    """What is said above a result, and the values used."""
    paper = look.paper
    lines = packed(map(paper.spell, [*said, *value_lines(robot, values)]), paper)
    return [paper.ink(line, "dim") for line in lines]


def _even(lines: Sequence[str], values: Sequence[Expr | float]) -> list[str]:
    """Numbers with room to their right, so that units stand below each other; formulas as they are."""
    if any(isinstance(value, Expr) for value in values) or all(len(a) == len(b) for a, b in pairwise(lines)):
        return list(lines)
    width = max(map(len, lines))
    return [line.ljust(width) for line in lines]
