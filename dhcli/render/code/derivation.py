"""A derivation as a formula sheet, in LaTeX or Markdown."""

from __future__ import annotations

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
)
from dhcli.notation.styles import latex_name
from dhcli.notation.tree import ZERO
from dhcli.notation.writer import write
from dhcli.render.look import Look
from dhcli.safe import markdown, markdown_code, markdown_heading


def derivation_latex(result: Derivation, look: Look) -> str:
    """The formulas, one a line, aligned at their equals signs."""
    lines = [f"{named_text(step.atom, latex_name)} &= {_latex_value(result, step)}" for step in result.steps]
    return look.shown("\\begin{aligned}\n" + " \\\\\n".join(lines) + "\n\\end{aligned}\n")


def _latex_value(result: Derivation, step: Step) -> str:
    value = write(step.value, "latex", result.robot.writing)
    if step.spread is not None:
        spread = write(step.spread, "latex", result.robot.writing)
        value = rf"\pm {spread}" if step.value == ZERO else rf"{value} \pm {spread}"
    return value + (r" \; (+\, 180^\circ)" if step.two == "opposite" else "")


def derivation_markdown(result: Derivation, look: Look) -> str:
    """The steps as a page: for each its equations, its formula, and where it says nothing."""
    joints = result.robot.writing
    lines = [markdown_heading(1, f"Joint values of {result.robot.name}")]
    lines += ["", f"Of frame {markdown(result.end)}, seen from frame {markdown(result.start)}."]
    for number, step in enumerate(result.steps, 1):
        lines += ["", f"## {number}. ${atom_text(step.atom, latex_name)}$: {step.rule}, {SAID[step.rule]}"]
        for one in step.equations:
            sides = f"{write(one.left, 'latex', joints)} = {write(one.right, 'latex', joints)}"
            lines += ["", f"$${sides}$$", "", f"{markdown_code(level_text(result, one))}, so"]
        lines += ["", f"$${named_text(step.atom, latex_name)} = {_latex_value(result, step)}$$"]
        if condition := condition_text(step, "latex", result):
            lines += ["", f"Here: {condition}."]
    for said in filter(None, (left_text(result, "short"), proof_text(result))):
        lines += ["", said[0].upper() + said[1:] + "."]
    return look.shown("\n".join(lines) + "\n")
