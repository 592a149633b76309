"""Answers of forward kinematics: headings that name both frames, matrices, points."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from dhcli.kinematics.conventions import NAMES
from dhcli.kinematics.frames import View
from dhcli.kinematics.question import AnyPose, ForwardKinematics
from dhcli.kinematics.robot import Robot
from dhcli.notation.styles import Joints
from dhcli.notation.tree import Expr, Trig
from dhcli.notation.walk import walk
from dhcli.notation.writer import write
from dhcli.render.look import Look
from dhcli.render.paper import Paper
from dhcli.render.text.matrix import let_lines, matrix_lines, vector_lines
from dhcli.render.text.prose import heading_text, prose_lines
from dhcli.render.text.quantities import value_lines

AXES = ("p_x", "p_y", "p_z")


def pose_table(result: ForwardKinematics, look: Look) -> str:
    """The pose between two frames."""
    lines = [heading(result.pose, result.robot.name, look), *context_lines(result, look)]
    lines += let_lines(result.definitions, result.robot.writing, look)
    lines += matrix_lines(result.pose.rows, result.robot.writing, look)
    if result.words:
        lines.append(look.paper.ink(", ".join(result.words), "dim"))
    if not result.question.symbolic:
        lines += look.paper.aside(f"from a pose back to the joints: dhcli ik {result.robot.typed}")
    return _text(lines)


def poses_table(result: ForwardKinematics, look: Look) -> str:
    """Every pose of a listing, with its heading."""
    lines = list(context_lines(result, look))
    for pose in result.poses:
        lines += ["", heading(pose, result.robot.name, look), *matrix_lines(pose.rows, pose.joints, look)]
    return _text(lines)


def point_table(result: ForwardKinematics, look: Look) -> str:
    """Where a point is."""
    point = result.point
    assert point is not None, "only a question with a point is drawn as one"  # noqa: S101
    joints = result.robot.writing
    given = ", ".join(write(coordinate, look.style or "short", joints) for coordinate in point.given)
    title = f"({given}) of frame {point.frame} of {result.robot.name}, seen from frame {point.reference}"
    lines = [heading_text(title, look.paper), *context_lines(result, look)]
    return _text([*lines, *vector_lines(AXES, point.seen, joints, look)])


def sentence(pose: AnyPose, robot: str) -> str:
    """What a matrix is, in words: `T_03 of scara: frame 3 seen from frame 0`."""
    return f"{pose.name} of {robot}: {frame_words(pose.frame)} seen from {frame_words(pose.reference)}"


def heading(pose: AnyPose, robot: str, look: Look) -> str:
    """The line above a matrix; a factor of a link is not between two frames."""
    is_factor = pose.title and not pose.title.startswith("A_")
    text = f"{pose.title}, a factor of A_{pose.frame}" if is_factor else sentence(pose, robot)
    return heading_text(text, look.paper)


def context_lines(result: ForwardKinematics, look: Look) -> Iterator[str]:
    """Convention and the values used, and what `c1` means where it is new to a reader."""
    parts = [NAMES[result.robot.convention], *value_lines(result.robot, result.values)]
    parts += ["lengths in m"] if not result.question.symbolic else _legend(result, look)
    parts += left_out(result.robot, result.question.view) if result.question.listing is None else ()
    yield from (look.paper.ink(line, "dim") for line in packed(map(look.paper.spell, parts), look.paper))


def left_out(robot: Robot, view: View) -> Iterator[str]:
    """That the base or the tool of a robot is no part of a pose between its first and its last frame."""
    if (view.start, view.end) != (robot.frames[1], robot.frames[-2]):
        return
    ends = {"base": ("--from base", robot.base), "tool": ("--to tool", robot.tool)}
    away = {name: option for name, (option, chain) in ends.items() if chain}
    if away:
        yield f"without {' and '.join(away)}: {' '.join(away.values())} {'has it' if len(away) == 1 else 'has both'}"


def _legend(result: ForwardKinematics, look: Look) -> list[str]:
    poses = result.poses or (result.pose,)
    return legend((entry for pose in poses for row in pose.rows for entry in row), result.robot.writing, look)


def legend(entries: Iterable[Expr | float], joints: Joints, look: Look) -> list[str]:
    """What `c1` and `s23` mean, by the first of each sort that occurs."""
    shown: dict[bool, str] = {}
    for expr in entries if look.style != "full" else ():
        for node in walk(expr) if isinstance(expr, Expr) else ():
            if isinstance(node, Trig) and len(shown) < 2:  # noqa: PLR2004  one angle, and a sum of angles
                short, full = write(node, "short", joints), write(node, "full", joints)
                if short != full:
                    shown.setdefault(len(node.angle.terms) > 1, f"{short} = {full}")
    return [shown[key] for key in sorted(shown)]


def frame_words(name: str) -> str:
    """A frame in a sentence."""
    return name if name in ("base", "tool") else f"frame {name}"


def packed(parts: Iterable[str], paper: Paper) -> Iterator[str]:
    """Parts between middle dots, as many on a line as fit; on a terminal, one that is too long by itself is folded."""
    dot = paper.spell(" · ")
    line = ""
    for whole in parts:
        part = whole
        if paper.terminal and len(whole) > paper.width:
            *folded, part = prose_lines(whole, paper)
            yield from (line, *folded) if line else folded
            line = ""
        longer = f"{line}{dot}{part}" if line else part
        if line and len(longer) > paper.width:
            yield line
            longer = part
        line = longer
    yield line


def _text(lines: Iterable[str]) -> str:
    return "\n".join(lines) + "\n"
