"""The answer of `dof` at joint values: the count, and what the end frame can do there."""

from __future__ import annotations

from typing import Any

from dhcli.errors import plural
from dhcli.mobility.at_pose import MobilityAtPose
from dhcli.render.look import Look
from dhcli.render.text.forward import packed
from dhcli.render.text.mobility import mobility_content, mobility_table
from dhcli.render.text.quantities import in_units, value_lines


def at_pose_table(result: MobilityAtPose, look: Look) -> str:
    """The count, then the freedoms of the end frame."""
    paper, found = look.paper, result.found
    lines = [paper.ink("The end frame at these joint values", "bold")]
    lines += [
        paper.ink(line, "dim") for line in packed(map(paper.spell, value_lines(result.robot, result.values)), paper)
    ]
    rows = ", ".join(found.rows)
    has = f"  {plural(result.standing.measures.rank, 'freedom')} in {rows}"
    if not result.lost:
        lines.append(paper.spell(f"{has}: none is lost"))
    else:
        lines.append(paper.spell(f"{has}: {result.lost} of {found.rank} lost"))
    for factor in result.reasons:
        lines.append(paper.spell(f"  {factor.text('short', result.robot.writing)}: {factor.words}"))
        if factor.lost:
            lines.append(paper.spell(f"    lost: {factor.lost}"))
    if result.lost:
        lines.append(f"  where else it loses freedoms: dhcli singularities {result.robot.typed}")
    lines += paper.aside(f"  whether one pose is reached: dhcli ik {result.robot.typed}")
    return mobility_table(result.mobility, look) + "\n" + "\n".join(lines) + "\n"


def at_pose_content(result: MobilityAtPose, look: Look) -> dict[str, Any]:
    """The count as ever, and under `end` what the end frame can do."""
    joints = result.robot.writing
    return {
        **mobility_content(result.mobility, look),
        "end": {
            "values": {name: in_units(value) for name, value in result.values.items()},
            "rows": list(result.found.rows),
            "freedoms": result.standing.measures.rank,
            "lost": result.lost,
            "reasons": [
                {"text": factor.text("short", joints), "words": factor.words, "lost": factor.lost}
                for factor in result.reasons
            ],
        },
    }
