"""A derivation to be read: the steps, the equations they stand on, and the formulas."""

from __future__ import annotations

from collections.abc import Iterator
from textwrap import wrap
from typing import Any

from dhcli.kinematics.conventions import NAMES
from dhcli.kinematics.inverse.derivation import Derivation
from dhcli.kinematics.inverse.derive_rules import Step
from dhcli.kinematics.inverse.derive_words import (
    SAID,
    atom_text,
    condition_text,
    left_text,
    level_text,
    named_text,
    proof_text,
    value_text,
)
from dhcli.notation.tree import Expr
from dhcli.notation.writer import write
from dhcli.render.look import Look
from dhcli.render.text.forward import frame_words, legend, packed
from dhcli.render.text.prose import heading_text


def derivation_table(result: Derivation, look: Look) -> str:
    """The steps from top to bottom."""
    paper = look.paper
    given = "position px, py, pz" if result.place_only else "pose T, its entries r11 to r33, px, py, pz"
    where = f"{frame_words(result.end)} of {result.robot.name}, seen from {frame_words(result.start)}"
    lines = [
        heading_text(f"derivation of the joint values: {given} of {where}", paper),
        *(paper.ink(line, "dim") for line in packed(map(paper.spell, _context(result, look)), paper)),
    ]
    for number, step in enumerate(result.steps, 1):
        lines += [
            "",
            heading_text(f"{number}. {atom_text(step.atom)}: {step.rule}, {SAID[step.rule]}", paper),
        ]
        lines += [f"   {paper.spell(look.shown(line))}" for line in _step_lines(result, step, look)]
    for said in filter(None, (left_text(result, look.style or "short"), proof_text(result))):
        lines += ["", *wrap(paper.spell(said), paper.width)]
    return "\n".join(lines) + "\n"


def _context(result: Derivation, look: Look) -> list[str]:
    """The convention, and what `c1` means, by the first that occurs."""
    written = (side for step in result.steps for one in step.equations for side in (one.left, one.right))
    return [NAMES[result.robot.convention], *legend(written, result.robot.writing, look)]


def _step_lines(result: Derivation, step: Step, look: Look) -> Iterator[str]:
    style, joints = look.style or "short", result.robot.writing
    for one in step.equations:
        yield f"{write(one.left, style, joints)} = {write(one.right, style, joints)}    {level_text(result, one)}"
    yield f"{named_text(step.atom)} = {value_text(step, style, joints_of=result)}"
    if condition := condition_text(step, style, result):
        yield condition


def derivation_content(result: Derivation, _look: Look) -> dict[str, Any]:
    """The derivation as JSON holds it; formulas as sympy reads them."""

    def plain(expr: Expr | None) -> str | None:
        return None if expr is None else write(expr, "sympy", result.robot.writing)

    return {
        "robot": result.robot.name,
        "convention": result.robot.convention.value,
        "reference": result.start,
        "frame": result.end,
        "task": "position" if result.place_only else "pose",
        "branches": result.branches,
        "proved": result.proved,
        "only_where": [{"left": plain(one.left), "right": plain(one.right)} for one in result.left],
        "steps": [
            {
                "rule": step.rule,
                "unknown": atom_text(step.atom),
                "equations": [
                    {"level": level_text(result, one), "left": plain(one.left), "right": plain(one.right)}
                    for one in step.equations
                ],
                "value": plain(step.value),
                "plus_minus": plain(step.spread),
                "or_half_a_turn_more": step.two == "opposite",
                "condition": plain(step.condition),
                "instead": None if step.instead is None else plain(step.instead.value),
            }
            for step in result.steps
        ],
    }
