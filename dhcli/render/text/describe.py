"""A robot in another description: the steps, the result, what went to base and tool, and the proof."""

from __future__ import annotations

import textwrap
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

from dhcli.algebra.floats import Floats
from dhcli.algebra.terms import TERMS
from dhcli.geometry.vectors import Vector
from dhcli.kinematics.conventions import Convention
from dhcli.kinematics.describe.asked import NAMES
from dhcli.kinematics.describe.description import Described
from dhcli.kinematics.describe.exact import exact_factor
from dhcli.kinematics.describe.linear import coordinates_of
from dhcli.kinematics.describe.process import axis_word
from dhcli.kinematics.describe.products import end_of, pitch_of
from dhcli.kinematics.describe.shown import shown
from dhcli.kinematics.describe.straight import Straightened
from dhcli.kinematics.describe.words import Step
from dhcli.kinematics.fold import fold
from dhcli.kinematics.moves import spelled
from dhcli.notation.tree import Expr, Number, Symbol, multiply
from dhcli.notation.walk import symbols
from dhcli.notation.writer import write, write_value
from dhcli.regex import regex
from dhcli.render.look import Look
from dhcli.render.text.matrix import matrix_lines
from dhcli.render.text.prose import heading_text
from dhcli.render.text.robot import links_table, robot_content
from dhcli.render.text.table import table_text

_PROSE = 100
"""Columns at which the steps are folded at most."""

_POINT = regex(r"\([^()]*\)")
_JOINED = "\N{NO-BREAK SPACE}"
"""A point is not folded."""

_AXIS = {
    "standard": "z_{i-1} is the axis of joint i",
    "modified": "z_i is the axis of joint i",
    "axes": "seen from the base, in the pose drawn",
    "screws": "T = exp(S_1 q_1) ... exp(S_n q_n) M",
    "body-screws": "T = M exp(B_1 q_1) ... exp(B_n q_n)",
    "product": "every frame stands as the base in the pose drawn",
}


def description_table(result: Described, look: Look) -> str:
    """What was found, for people, who are shown no more of its numbers than they need."""
    if look.digits is not None:
        return _page(result, replace(look, places=look.digits))
    few = shown(result)
    page = _page(result, replace(look, places=few.places))
    if page == _page(result, look):
        return page
    said = f"rounded to {few.places} decimals"
    if few.off is not None:
        said += f", which moves the tip by at most {few.off * 1e6:.1g} µm"
    return page + look.paper.spell(f"{said}; --digits and files have more") + "\n"


def _page(result: Described, look: Look) -> str:
    paper = look.paper
    origin = " from its axes" if result.steps else ""
    head = f"{result.given.title}{origin} · {NAMES[result.form]} · {_AXIS[result.form]}"
    blocks = [heading_text(head, paper) + "\n"]
    if result.shared and (result.told or result.form in ("axes", "screws", "body-screws")):
        shared = " · ".join(f"{name} = {text}" for name, text in _shared(result).items())
        blocks.append(heading_text(shared, paper) + "\n")
    if result.told and result.steps:
        blocks.append("".join(_steps(result, look)))
    return "".join([*blocks, *_body(result, look), *(f"{paper.spell(line)}\n" for line in _facts(result, look))])


def description_content(result: Described, look: Look) -> dict[str, Any]:
    """The same as JSON holds it; lengths and directions as text, exact."""
    found: dict[str, Any] = {
        "robot": result.given.name,
        "as": result.form,
        "proof": {"kind": result.proof.kind, "error": result.proof.error},
        "notes": list(result.notes),
        "steps": [_step_content(step) for step in result.steps] if result.told else [],
        "result": robot_content(result.robot, look),
    }
    if result.shared:
        found["shared"] = _shared(result)
    if result.straightened:
        found["straightened"] = _straightened_content(result.straightened)
    if result.screws and result.drawing is not None:
        found["screws"] = [
            {
                "joint": s.name,
                "omega": list(map(_written, s.omega)),
                "v": [write(e, "full") for e in coordinates_of(s.v)],
            }
            for s in result.screws
        ]
        found["home"] = " ".join(map(spelled, end_of(result.drawing.end)))
    elif result.form == "axes" and result.drawing is not None:
        found["axes"] = [
            {
                "joint": line.name,
                "turns": line.turns,
                "rate": str(line.rate),
                "direction": list(map(_written, line.direction)),
                "through": None if line.through is None else [write(e, "full") for e in coordinates_of(line.through)],
                "pitch": write(pitch_of(line), "full") if line.pitch else None,
            }
            for line in result.drawing.lines
        ]
        found["end"] = " ".join(map(spelled, end_of(result.drawing.end)))
    return found


def _shared(result: Described) -> dict[str, str]:
    """What each joint of the drawing moves by that has no variable of its own, written out."""
    joints = result.given.writing
    return {name: write_value(value, "full", joints) for name, value in result.shared.items()}


def _straightened_content(straight: Straightened) -> dict[str, Any]:
    """Angles in radians, lengths in metres; of the tip they are bounds over the whole workspace."""
    return {
        "within": straight.within,
        "exact": not straight.changes,
        "tip": straight.tip,
        "turn": straight.turn,
        "strokes": dict(straight.strokes),
        "changes": [
            {"joint": change.joint, "turned": change.turned, "shifted": change.shifted, "said": change.said}
            for change in straight.changes
        ],
    }


def _step_content(step: Step) -> dict[str, Any]:
    return {
        "step": step.number,
        "subject": step.subject,
        "said": step.said,
        "rule": step.rule,
        "free": step.free,
        "cells": list(step.cells),
    }


def _steps(result: Described, look: Look) -> Iterator[str]:
    """The steps, each number once."""
    paper = look.paper
    width = min(paper.width, _PROSE)
    number = 0
    for step in result.steps:
        for i, part in enumerate(step.lines()):
            mark = f"{step.number}  " if step.number != number else " " * (5 if i else 3)
            number = step.number
            text = _POINT.sub(lambda point: point[0].replace(" ", _JOINED), paper.spell(look.formula(part)))
            lines = textwrap.wrap(
                text,
                width,
                initial_indent=mark,
                subsequent_indent=" " * 5,
                break_long_words=False,
                break_on_hyphens=False,
            )
            yield "\n".join(lines).replace(_JOINED, " ") + "\n"


def _body(result: Described, look: Look) -> Iterator[str]:
    if result.form == "axes" and result.drawing is not None:
        rows = [
            [
                look.formula(write(multiply(Number(line.rate), Symbol(line.name)), "full")),
                "screws about" if line.pitch else "turns about" if line.turns else "slides along",
                _direction(line.direction, look),
                "" if line.through is None else _triple(coordinates_of(line.through), look),
                look.formula(write(pitch_of(line))) if line.pitch else "",
            ]
            for line in result.drawing.lines
        ]
        heads = ["joint", "", "direction", "through", "each turn"]
        width = len(heads) if any(line.pitch for line in result.drawing.lines) else -1
        yield table_text(heads[:width], [row[:width] for row in rows], look.paper)
        end = " ".join(map(spelled, end_of(result.drawing.end)))
        yield look.paper.spell(f"end  {look.formula(end)}") + "\n"
    elif result.screws and result.drawing is not None:
        turns = [tuple(exact_factor(part) for part in screw.omega) for screw in result.screws]
        rows = [
            [screw.name, _triple(omega, look), _triple(coordinates_of(screw.v), look)]
            for screw, omega in zip(result.screws, turns, strict=True)
        ]
        yield table_text(["joint", "ω", "v"], rows, look.paper)
        yield "M, the end frame with all joints at zero\n"
        home = [list(map(_evaluated, row)) for row in fold(end_of(result.drawing.end), TERMS)]
        yield "".join(f"{line}\n" for line in matrix_lines(home, result.robot.writing, look))
    else:
        yield links_table(result.robot, look)


def _facts(result: Described, look: Look) -> Iterator[str]:
    ends = (("base", result.robot.base, result.given.base), ("tool", result.robot.tool, result.given.tool))
    for name, chain, before in ends:
        if chain and chain == before:
            yield look.formula(f"{name}  {' '.join(spelled(move, result.robot.writing) for move in chain)}")
    yield from map(look.formula, result.notes)
    straight = result.straightened
    yield from straight.lines() if straight else ()
    same = "the same motion as the straightened robot" if straight and straight.changes else "the same motion"
    if result.proof.kind == "exact":
        yield f"proved: {same} from base to tool, for all values of joints and lengths"
    else:
        error = max(result.proof.error, 1e-16)
        yield f"checked: {same} from base to tool at drawn poses, to {error:.0e} of the reach"
    if result.robot.convention is not Convention.PRODUCT and result.robot.convention is not result.given.convention:
        yield "frames 1 to n stand elsewhere now, as the convention wants them"


def _direction(vector: Vector, look: Look) -> str:
    """`+z`, or components: in a table with as many places as its lengths have, for they move the tip as much."""
    word = axis_word(vector)
    return _triple(tuple(map(exact_factor, vector)), look) if word.startswith("(") else word


def _evaluated(entry: Expr) -> Expr:
    """An entry without letters as a number."""
    return entry if symbols(entry) else exact_factor(Floats().value(entry))


def _triple(entries: tuple[Expr, ...], look: Look) -> str:
    return f"({', '.join(look.formula(write(entry)) for entry in entries)})"


def _written(value: float) -> str:
    return write(exact_factor(value), "full")
