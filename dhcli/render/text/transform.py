"""Products of moves: every frame on the way, the pose, points and vectors."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from dhcli.kinematics.question import SeenPoint
from dhcli.kinematics.transform import Transform
from dhcli.notation.styles import THETAS
from dhcli.render.code.matrices import csv_rows, pose_source, vector_source
from dhcli.render.json.contents import number, placements_content, plain_number, pose_content
from dhcli.render.look import Look
from dhcli.render.text.matrix import cell, matrix_lines
from dhcli.render.text.placement import placement_lines
from dhcli.render.text.prose import heading_text, prose_lines


def transform_table(result: Transform, look: Look) -> str:
    """The pose, what it does to points and vectors, and the pose in other ways."""
    return "\n".join([*_pose_lines(result, len(result.steps), look), *_rest(result, look)]) + "\n"


def steps_table(result: Transform, look: Look) -> str:
    """Every frame on the way."""
    lines: list[str] = []
    for count in range(1, len(result.steps) + 1):
        lines += [*_pose_lines(result, count, look), ""]
    return "\n".join([*lines[:-1], *_rest(result, look)]) + "\n"


def transform_code(result: Transform, look: Look) -> str:
    """The matrix, or the points and vectors if there are any, for a program or a paper."""
    triples = (*result.points, *result.vectors)
    if triples:
        return "".join(vector_source(triple.seen, THETAS, look) for triple in triples)
    return pose_source(result.pose, look, comment=_title(result, len(result.steps)))


def steps_code(result: Transform, look: Look) -> str:
    """The matrix of every frame on the way."""
    return "\n".join(
        pose_source(step.pose, look, comment=_title(result, count), named=True)
        for count, step in enumerate(result.steps, 1)
    )


def transform_csv(result: Transform, look: Look) -> str:
    """The matrix as four lines, or one line for each point and vector."""
    triples = (*result.points, *result.vectors)
    return csv_rows([list(triple.seen) for triple in triples] or list(result.pose.rows), THETAS, look)


def transform_content(result: Transform, look: Look) -> dict[str, Any]:
    """A product as JSON holds it."""
    found: dict[str, Any] = {
        "order": result.order,
        "symbolic": result.pose.is_symbolic,
        **pose_content(result.pose, look),
        "steps": [{"move": step.text, **pose_content(step.pose, look)} for step in result.steps],
        "points": [_triple(point, look) for point in result.points],
        "vectors": [_triple(vector, look) for vector in result.vectors],
    }
    if result.placements:
        found["as"] = placements_content(result.placements, THETAS, look)
    return found


def _triple(triple: SeenPoint, look: Look) -> dict[str, Any]:
    return {
        "given": [plain_number(value, THETAS, look) for value in triple.given],
        "seen": [number(value, THETAS, look) for value in triple.seen],
    }


def _title(result: Transform, count: int) -> str:
    """The moves in the order in which they are multiplied."""
    texts: list[str] = []
    for step in result.steps[:count]:
        texts = [step.text, *texts] if step.about == "fixed" else [*texts, step.text]
    return f"{result.steps[count - 1].pose.name} = {' '.join(texts)}"


def _about(result: Transform, count: int) -> str:
    """About which frame the moves are, those apart that differ."""
    said = "each move about the current frame" if result.order == "current" else "each move about the fixed frame 0"
    others = [step for step in result.steps[:count] if step.about != result.order]
    if not others:
        return said
    other = "the fixed frame 0" if result.order == "current" else "the current frame"
    return f"{said}, but {', '.join(step.text for step in others)} about {other}"


def _pose_lines(result: Transform, count: int, look: Look) -> list[str]:
    paper, pose = look.paper, result.steps[count - 1].pose
    seen = f"frame {pose.frame} seen from frame 0; {_about(result, count)}"
    return [
        heading_text(_title(result, count), paper),
        *(paper.ink(line, "dim") for line in prose_lines(seen, paper)),
        *matrix_lines(pose.rows, THETAS, look),
    ]


def _rest(result: Transform, look: Look) -> Iterator[str]:
    if result.words:
        yield look.paper.ink(", ".join(result.words), "dim")
    for noun, verb, triples in (("point", "is at", result.points), ("vector", "is", result.vectors)):
        for triple in triples:
            given, seen = (
                ", ".join(look.paper.spell(cell(e, THETAS, look)) for e in side) for side in (triple.given, triple.seen)
            )
            yield f"{noun} ({given}) of frame {triple.frame} {verb} ({seen}) in frame {triple.reference}"
    yield from placement_lines(result.placements, THETAS, look)
