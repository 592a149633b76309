"""Jacobians, determinants, torques and rates for programs and papers; numbers in full precision."""

from __future__ import annotations

from collections.abc import Sequence

from dhcli.kinematics.velocity.answers import JacobianAnswer, SingularAnswer, TorquesAnswer, VelocityAnswer
from dhcli.notation.styles import Joints
from dhcli.notation.tree import Expr
from dhcli.render.code.matrices import Letter, csv_line, entry, matrix_source
from dhcli.render.look import Look
from dhcli.render.text.forward import frame_words
from dhcli.render.text.velocity import TITLES, rows_words, title


def jacobian_code(result: JacobianAnswer, look: Look) -> str:
    """The matrix for a program or a paper."""
    found = result.jacobian
    comment = f"{title(result)}; {', '.join(rows_words(result, look))}; columns {', '.join(found.joints)}"
    return matrix_source(
        found.rows, result.robot.writing, look, comment=comment, name=Letter("J"), definitions=result.definitions
    )


def jacobian_csv(result: JacobianAnswer, look: Look) -> str:
    """A line for each row, under the names of the joints and behind its own."""
    found, joints = result.jacobian, result.robot.writing
    lines = [csv_line(["row", *found.joints])]
    for k, label in enumerate(found.labels):
        lines.append(csv_line([label, *(entry(value, joints, look) for value in found.rows[k])]))
    return "".join(lines)


def singular_code(result: SingularAnswer, look: Look) -> str:
    """The determinant, or the expressions of each condition, one a line."""
    found, joints = result.found, result.robot.writing
    if found.determinant is not None:
        text = entry(found.determinant, joints, look)
        return {"latex": f"\\det J = {text}", "matlab": f"detJ = {text};"}.get(look.format, text) + "\n"
    return "".join(", ".join(entry(zero, joints, look) for zero in factor.zeros) + "\n" for factor in found.factors)


def singular_csv(result: SingularAnswer, look: Look) -> str:
    """A line for each factor or condition."""
    joints = result.robot.writing
    lines = [csv_line(["zero", "exponent", "angles", "words", "lost"])]
    for factor in result.found.factors:
        zeros = " and ".join(entry(zero, joints, look) for zero in factor.zeros)
        lines.append(csv_line([zeros, str(factor.exponent), factor.angles, factor.words, factor.lost]))
    return "".join(lines)


def torques_code(result: TorquesAnswer, look: Look) -> str:
    """A column with a torque or a force for each joint."""
    found = result.torques
    units = ", ".join(f"{joint} [{unit}]" for joint, unit in zip(found.joints, found.units, strict=True))
    return _column(found.values, result.robot.writing, look, f"Torques of {result.robot.name}: {units}", "tau")


def torques_csv(result: TorquesAnswer, look: Look) -> str:
    """A line for each joint."""
    found, joints = result.torques, result.robot.writing
    lines = [csv_line(["joint", "torque", "unit"])]
    values: Sequence[Expr | float] = found.values
    for joint, value, unit in zip(found.joints, values, found.units, strict=True):
        lines.append(csv_line([joint, entry(value, joints, look), unit]))
    return "".join(lines)


def velocity_code(result: VelocityAnswer, look: Look) -> str:
    """A column: the joint rates where a velocity was asked for, else the velocity."""
    robot, view = result.robot, result.view
    solved = result.solved is not None
    values, names = (result.rates, result.joints) if solved else (result.velocity, result.labels)
    of = f"{frame_words(view.end)} against {frame_words(view.start)}, along the axes of {frame_words(view.axes)}"
    comment = f"{TITLES[solved]} of {robot.name}: {of}; {', '.join(names)}"
    return _column(values, robot.writing, look, comment, "qd" if solved else "v")


def velocity_csv(result: VelocityAnswer, look: Look) -> str:
    """A line for each joint, then one for each number of the velocity."""
    joints = result.robot.writing
    names: Sequence[str] = (*result.joints, *result.labels)
    values: Sequence[Expr | float] = (*result.rates, *result.velocity)
    lines = [csv_line([n, entry(value, joints, look)]) for n, value in zip(names, values, strict=True)]
    return csv_line(["of", "rate"]) + "".join(lines)


def _column(values: Sequence[Expr | float], joints: Joints, look: Look, comment: str, letter: str) -> str:
    return matrix_source([[value] for value in values], joints, look, comment=comment, name=Letter(letter))
