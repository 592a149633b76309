"""Answers of forward kinematics for programs and papers."""

from __future__ import annotations

from dhcli.kinematics.question import ForwardKinematics
from dhcli.render.code.matrices import csv_line, csv_rows, pose_source, vector_source
from dhcli.render.look import Look
from dhcli.render.text.forward import sentence
from dhcli.render.text.matrix import ENTRIES


def pose_code(result: ForwardKinematics, look: Look) -> str:
    """The matrix for a program or a paper."""
    return pose_source(result.pose, look, comment=sentence(result.pose, result.robot.name))


def let_code(result: ForwardKinematics, look: Look) -> str:
    """Definitions, then the matrix in their terms, for a program or a paper."""
    pose = result.pose
    comment = sentence(pose, result.robot.name)
    return pose_source(pose, look, comment=comment, named=True, definitions=result.definitions)


def poses_code(result: ForwardKinematics, look: Look) -> str:
    """Every matrix of a listing for a program or a paper."""
    name = result.robot.name
    return "\n".join(pose_source(pose, look, comment=sentence(pose, name), named=True) for pose in result.poses)


def point_code(result: ForwardKinematics, look: Look) -> str:
    """The point for a program or a paper."""
    assert result.point is not None, "only a question with a point is drawn as one"  # noqa: S101
    return vector_source(result.point.seen, result.robot.writing, look)


def pose_csv(result: ForwardKinematics, look: Look) -> str:
    """The matrix as four lines."""
    return csv_rows(result.pose.rows, result.robot.writing, look)


def poses_csv(result: ForwardKinematics, look: Look) -> str:
    """One line for each pose of a listing: its name, then the upper three rows."""
    lines = [csv_line(["pose", *(name for names in ENTRIES for name in names)])]
    for pose in result.poses:
        entries = csv_rows([[e for row in pose.rows[:3] for e in row]], pose.joints, look)
        lines.append(csv_line([pose.name]).rstrip("\n") + "," + entries)
    return "".join(lines)


def point_csv(result: ForwardKinematics, look: Look) -> str:
    """The coordinates on one line."""
    assert result.point is not None, "only a question with a point is drawn as one"  # noqa: S101
    return csv_rows([list(result.point.seen)], result.robot.writing, look)
