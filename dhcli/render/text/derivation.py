"""A derivation to be read: the steps, the equations they stand on, and the formulas."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from dhcli.errors import plural
from dhcli.kinematics.conventions import NAMES
from dhcli.kinematics.inverse.derive import Derivation
from dhcli.kinematics.inverse.derive_levels import Equation
from dhcli.kinematics.inverse.derive_rules import Step
from dhcli.kinematics.inverse.derive_terms import Atom
from dhcli.notation.tree import ZERO, Call, Expr
from dhcli.notation.writer import write
from dhcli.render.look import Look
from dhcli.render.text.forward import frame_words

SAID = {
    "SUM": "from the sum",
    "SLIDE": "linear in it",
    "BOTH": "two equations linear in its cosine and sine",
    "RATIO": "cosine and sine times the same unknown",
    "ZERO": "a cosine and a sine that cancel",
    "ONE": "one equation in cosine and sine",
    "SQUARES": "squared and added, which no turn of the joint before changes",
}
"""What each rule uses."""


def derivation_table(result: Derivation, look: Look) -> str:
    """The steps from top to bottom."""
    paper = look.paper
    given = "position px, py, pz" if result.place_only else "pose T, its entries r11 to r33, px, py, pz"
    where = f"{frame_words(result.end)} of {result.robot.name}, seen from {frame_words(result.start)}"
    lines = [
        paper.ink(paper.spell(f"derivation of the joint values: {given} of {where}"), "bold"),
        paper.ink(
            paper.spell(f"{NAMES[result.robot.convention]} · c1 = cos(theta1), c23 = cos(theta2 + theta3)"), "dim"
        ),
    ]
    for number, step in enumerate(result.steps, 1):
        lines += [
            "",
            paper.ink(paper.spell(f"{number}. {atom_text(step.atom)}: {step.rule}, {SAID[step.rule]}"), "bold"),
        ]
        lines += [f"   {paper.spell(line)}" for line in _step_lines(result, step, look)]
    lines += ["", paper.spell(f"{plural(result.branches, 'combination')} of signs, each a solution where all are real")]
    return "\n".join(lines) + "\n"


def _step_lines(result: Derivation, step: Step, look: Look) -> Iterator[str]:
    style, joints = look.style or "short", result.robot.writing
    for one in step.equations:
        yield f"{write(one.left, style, joints)} = {write(one.right, style, joints)}    {level_text(result, one)}"
    yield f"{atom_text(step.atom)} = {value_text(step, style, joints_of=result)}"
    if condition := condition_text(step, style, result):
        yield condition


def atom_text(atom: Atom) -> str:
    """An unknown: `theta2 + theta3`."""
    if isinstance(atom, str):
        return atom
    text = " + ".join(name if factor > 0 else f"-{name}" for name, factor in atom)
    return text.replace("+ -", "- ")


def value_text(step: Step, style: str, *, joints_of: Derivation) -> str:
    """A formula with its sign: `± acos(...)`, `atan2(...) or 180° more`."""
    joints = joints_of.robot.writing
    value = write(step.value, style, joints)
    if step.spread is not None:
        spread = write(step.spread, style, joints)
        return f"± {spread}" if step.value == ZERO else f"{value} ± {spread}"
    return f"{value}, or 180° more" if step.two == "opposite" else value


def condition_text(step: Step, style: str, result: Derivation) -> str:
    """Where a formula says nothing."""
    if step.condition is None:
        return ""
    text = write(step.condition, style, result.robot.writing)
    if isinstance(step.spread, Call):
        return f"no solution where {text} is beyond -1 or 1"
    if step.spread is not None:
        return f"no solution where {text} is negative"
    return f"says nothing where {text} = 0: the joint is then free, or another equation has to serve"


def level_text(result: Derivation, one: Equation) -> str:
    """Where an equation stands: `(2,4) of inv(T_01) T = T_16`."""
    low, high = one.level
    before = f"inv({_name(result.start, low)}) " if low != result.start else ""
    after = f" inv({_name(high, result.end)})" if high != result.end else ""
    level = f"{before}T{after} = {_name(low, high)}"
    if one.squared:
        return f"rows {', '.join(map(str, one.entry))} of the position in {level}"
    return f"({one.entry[0]},{one.entry[1]}) of {level}"


def _name(low: str, high: str) -> str:
    return f"T_{low}{high}" if len(low) == len(high) == 1 else f"T_{{{low},{high}}}"


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
            }
            for step in result.steps
        ],
    }
