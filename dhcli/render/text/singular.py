"""Where a robot is singular, as a table: the determinant, its factors with what they mean, and how the arm stands."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator
from typing import TYPE_CHECKING

from dhcli.kinematics.singular.result import MOST_JOINTS, Factor
from dhcli.kinematics.velocity.answers import SingularAnswer
from dhcli.notation.writer import write
from dhcli.render.look import Look
from dhcli.render.text.forward import frame_words, legend, packed
from dhcli.render.text.prose import heading_text, prose_lines
from dhcli.render.text.quantities import value_lines
from dhcli.render.text.velocity import point_words
from dhcli.safe import one_line

if TYPE_CHECKING:  # it comes with numpy
    from dhcli.kinematics.singular.standing import Standing

TASKS = {"all": "v and ω", "linear": "v", "angular": "ω"}

FINDINGS = {
    "everywhere": "singular everywhere",
    "never": "singular nowhere",
    "unreadable": "no list of conditions that anybody would read",
}


def singular_table(result: SingularAnswer, look: Look) -> str:
    """The determinant, then each factor with the configuration in words and the motion that is lost there."""
    found, paper, joints = result.found, look.paper, result.robot.writing
    style = look.style or "short"
    head = f"Singularities of {result.robot.name}: {frame_words(found.end)} against {frame_words(found.start)}"
    lines = [heading_text(head, paper)]
    shown = [found.determinant] if found.determinant is not None else [z for f in found.factors for z in f.zeros]
    said = [f"{TASKS[found.part]} of {point_words(result.view, joints, style)}: rows {', '.join(found.rows)}"]
    said += [*value_lines(result.robot, result.values), *legend(shown, joints, look)]
    lines += [paper.ink(line, "dim") for line in packed(map(paper.spell, said), paper)]
    if found.determinant is not None:
        lines.append(paper.spell(f"det J = {write(found.determinant, style, joints)}"))
    elif found.factors:
        lines.append(f"rank {found.rank}, and less where one of these holds")
    if found.finding in FINDINGS:
        lines.append(paper.spell(_verdict(result)))
    for factor in found.factors:
        lines += _factor(factor, result, look)
    lines += [paper.spell(f"less than {found.rank} at {_turns(turns)}") for turns in found.probed]
    if result.standing is not None:
        lines += ["", *(paper.spell(line) for line in standing_lines(result, result.standing, look))]
    return "\n".join(lines) + "\n"


def _verdict(result: SingularAnswer) -> str:
    found = result.found
    if found.finding == "never":
        return f"rank {found.rank} at all joint values: singular nowhere"
    if found.finding == "unreadable":
        tried = "one or two joints at right angles do not lower it; --q shows how it stands"
        if found.probed:
            tried = "what joints at right angles do, one or two at a time:"
        elif len(found.joints) > MOST_JOINTS:
            tried = f"of more than {MOST_JOINTS} joints none is looked for; --q shows how it stands"
        return f"rank {found.rank} nearly everywhere; {FINDINGS['unreadable']}; {tried}"
    still = f": {', '.join(found.still)} does not move {found.place}" if len(found.still) == 1 else ""
    wanted = min(len(found.joints), 6 if found.part == "all" else 3)
    return f"{FINDINGS['everywhere']}{still}; rank {found.rank} of {wanted}; another point may not be: --point"


def _factor(factor: Factor, result: SingularAnswer, look: Look) -> Iterator[str]:
    """A factor, and below it what it means."""
    paper, joints = look.paper, result.robot.writing
    name = factor.text(look.style or "short", joints)
    angles = f"  ({factor.angles})" if factor.angles else ""
    yield f"{paper.ink(paper.spell(name), 'cyan')}{paper.spell(angles)}"
    if factor.words:
        yield from prose_lines(one_line(factor.words), paper, "    ", "    ")
    if factor.lost:
        yield from prose_lines(one_line(f"lost: {factor.lost}"), paper, "    ", "      ")


def _turns(turns: object) -> str:
    return ", ".join(f"{name} = {90 * quarters}°" for name, quarters in turns.items())  # type: ignore[attr-defined]


def standing_lines(result: SingularAnswer, standing: Standing, look: Look) -> Iterator[str]:
    """Rank with its singular values, manipulability, and how far the nearest factor is."""
    measures, found = standing.measures, result.found
    values = ", ".join(_short(value) for value in measures.values)
    lost = " (full)" if measures.rank >= found.rank else f": {found.rank - measures.rank} less than elsewhere"
    yield f"here: rank {measures.rank}{lost}; singular values {values}"
    condition = "without bound" if measures.condition is None else _short(measures.condition)
    yield f"manipulability {_short(measures.manipulability)}, condition {condition}"
    if standing.determinant is not None:
        yield f"det J = {_short(standing.determinant)}"
    if found.part != "all":
        for size, direction in zip(measures.values, measures.directions, strict=True):
            yield f"  {_short(size)} along {_axis(direction)}"
    for one in standing.distances:
        zeros = found.factors[one.factor].text(look.style or "short", result.robot.writing)
        now = ", ".join(_short(value) for value in one.values)
        kinds = {joint.kind for joint in result.robot.joints if joint.name in found.factors[one.factor].joints}
        far = f"{_far(one.distance, kinds)} away" if math.isfinite(one.distance) else "out of reach from here"
        yield f"{zeros}: {now} here, {far}"


def _axis(direction: tuple[float, ...]) -> str:
    """A direction as the axis that it is, or its components."""
    letters = "xyz"
    ones = [k for k, part in enumerate(direction) if abs(part) > 1e-6]  # noqa: PLR2004  noise
    if len(ones) == 1:
        return letters[ones[0]]
    return f"({', '.join(_short(part) for part in direction)})"


def _far(distance: float, kinds: Collection[str]) -> str:
    """A distance in joint space; of angles in degrees besides."""
    if kinds == {"prismatic"}:
        return f"{_short(distance)} m"
    if kinds == {"revolute"}:
        return f"{_short(distance)} rad ({math.degrees(distance):.1f}°)"
    return f"{_short(distance)} (rad and m together)"


def _short(value: float) -> str:
    return "0" if abs(value) < 1e-12 else f"{value:.4g}"  # noqa: PLR2004  rounding
