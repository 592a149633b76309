"""A derivation as a formula sheet in LaTeX or Markdown, and as a function that returns every solution."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from dhcli.kinematics.inverse.derivation import Derivation
from dhcli.kinematics.inverse.derive_levels import POSITION, ROTATION
from dhcli.kinematics.inverse.derive_rules import Step
from dhcli.kinematics.inverse.derive_terms import Atom, name_of
from dhcli.kinematics.inverse.derive_words import SAID, condition_text, level_text, proof_text
from dhcli.kinematics.validity import in_floats
from dhcli.notation.angle import Angle
from dhcli.notation.styles import identifier, latex_name
from dhcli.notation.tree import ZERO, Call, Expr, Trig
from dhcli.notation.walk import rebuild, symbols, walk
from dhcli.notation.writer import write
from dhcli.render.look import Look
from dhcli.safe import comment, docstring, markdown, markdown_code, markdown_heading


def derivation_latex(result: Derivation, _look: Look) -> str:
    """The formulas, one a line, aligned at their equals signs."""
    lines = [f"{_latex_atom(step.atom)} &= {_latex_value(result, step)}" for step in result.steps]
    return "\\begin{aligned}\n" + " \\\\\n".join(lines) + "\n\\end{aligned}\n"


def _latex_value(result: Derivation, step: Step) -> str:
    value = write(step.value, "latex", result.robot.writing)
    if step.spread is not None:
        spread = write(step.spread, "latex", result.robot.writing)
        value = rf"\pm {spread}" if step.value == ZERO else rf"{value} \pm {spread}"
    return value + (r" \; (+\, 180^\circ)" if step.two == "opposite" else "")


def derivation_markdown(result: Derivation, _look: Look) -> str:
    """The steps as a page: for each its equations, its formula, and where it says nothing."""
    joints = result.robot.writing
    lines = [markdown_heading(1, f"Joint values of {result.robot.name}")]
    lines += ["", f"Of frame {markdown(result.end)}, seen from frame {markdown(result.start)}."]
    for number, step in enumerate(result.steps, 1):
        lines += ["", f"## {number}. ${_latex_atom(step.atom)}$: {step.rule}, {SAID[step.rule]}"]
        for one in step.equations:
            sides = f"{write(one.left, 'latex', joints)} = {write(one.right, 'latex', joints)}"
            lines += ["", f"$${sides}$$", "", f"{markdown_code(level_text(result, one))}, so"]
        lines += ["", f"$${_latex_atom(step.atom)} = {_latex_value(result, step)}$$"]
        if condition := condition_text(step, "latex", result):
            lines += ["", f"Here: {condition}."]
    return "\n".join(lines) + f"\n\n{proof_text(result)}\n"


def _latex_atom(atom: Atom) -> str:
    if isinstance(atom, str):
        return latex_name(atom)
    text = " + ".join(latex_name(name) if factor > 0 else f"-{latex_name(name)}" for name, factor in atom)
    return text.replace("+ -", "- ")


def derivation_code(result: Derivation, look: Look) -> str:
    """A function of the pose and the lengths that returns a list of all solutions, joint values in joint order."""
    lines = _matlab(result) if look.format == "matlab" else _python(result, look.format)
    return "\n".join(lines) + "\n"


def lengths_used(result: Derivation) -> list[str]:
    """The lengths and constant angles that the formulas need."""
    used = {name for step in result.steps for expr in _exprs(step) for name in symbols(expr)}
    return [name for name in result.robot.parameters if name in used]


def entries_used(result: Derivation) -> Iterator[tuple[str, int, int]]:
    """The entries of the pose that the formulas need, with their row and column from 1."""
    used = {name for step in result.steps for expr in _exprs(step) for name in symbols(expr)}
    for name in ROTATION:
        if name in used:
            yield name, int(name[1]), int(name[2])
    for row, name in enumerate(POSITION, 1):
        if name in used:
            yield name, row, 4


def _exprs(step: Step) -> list[Expr]:
    return [expr for expr in (step.value, step.spread) if expr is not None]


def _whole_sums(expr: Expr, sums: dict[tuple[tuple[str, object], ...], str]) -> Expr:
    """An expression in which a sum that was found as a whole has a name of its own."""

    def leaf(node: Expr) -> Expr:
        if type(node) is Trig and node.angle.terms in sums:
            name = sums[node.angle.terms]
            whole = Angle.of(name)
            return Trig(node.function, Angle(whole.terms, node.angle.degrees, node.angle.radians))
        return node

    # what is put together again anew loses the root below a line
    return rebuild(expr, leaf) if any(leaf(node) != node for node in walk(expr)) else expr


@dataclass(frozen=True, slots=True)
class Spelled:
    """A step in the spelling of a language.

    Attributes:
        step: The step.
        name: What its unknown is called.
        value: Its value, or what stands before the sign.
        spread: What stands behind the sign.
        square: What there is no root of where it is negative; empty where nothing can be.
    """

    step: Step
    name: str
    value: str
    spread: str
    square: str


def spelled_steps(result: Derivation, style: str) -> Iterator[Spelled]:
    """Each step in the spelling of a language."""
    sums: dict[tuple[tuple[str, object], ...], str] = {}
    for step in result.steps:
        rooted = step.two == "plus-minus" and not isinstance(step.spread, Call)
        value, spread, square = (
            "" if expr is None else write(_whole_sums(expr, sums), style, result.robot.writing)
            for expr in (step.value, step.spread, step.condition if rooted else None)
        )
        name = identifier(name_of(step.atom))
        if not isinstance(step.atom, str) and len(step.atom) > 1:
            sums[step.atom] = name
        yield Spelled(step, name, value, spread, square)


PYTHON = {
    "numpy": ("import numpy as np", "np.", "np.arctan2", "np.arccos"),
    "python": ("import math", "math.", "math.atan2", "math.acos"),
}
"""For each of the two what is imported, what stands before its names, and its own names of two of them."""


def _python(result: Derivation, language: str) -> list[str]:
    imported, module, atan2, acos = PYTHON[language]

    def own(text: str) -> str:
        return text.replace("np.atan2", atan2).replace("np.acos", acos).replace("np.", module)

    values = {name: result.robot.parameters[name] for name in lengths_used(result)}
    names = [f"{identifier(n)}={in_floats(v)!r}" for n, v in values.items() if v is not None]
    names = [*(identifier(n) for n, v in values.items() if v is None), *names]
    lines = [imported, "", ""]
    lines += [f"def inverse({', '.join(['T', *names])}):"]
    said = f"Every solution of {result.robot.name}: joint values in radians and metres, in joint order."
    lines += [f"    {docstring(said)}"]
    lines += [f"    {name} = T[{row - 1}][{column - 1}]" for name, row, column in entries_used(result)]
    lines += ["    solutions = []"]
    margin = "    "
    for one in spelled_steps(result, "numpy"):
        name, value, spread = one.name, own(one.value), own(one.spread)
        if one.step.two == "plus-minus":
            lines += [f"{margin}for sign_{name} in (1, -1):"]
            margin += "    "
            if isinstance(one.step.spread, Call):
                lines += [
                    f"{margin}cosine = {spread.removeprefix(acos)}",
                    f"{margin}if abs(cosine) > 1:",
                    f"{margin}    continue",
                ]
                spread = f"{acos}(cosine)"
            elif one.square:
                lines += [f"{margin}if {own(one.square)} < 0:", f"{margin}    continue"]
            term = f"sign_{name}*{spread}"
            lines += [f"{margin}{name} = {term if value == '0' else f'{value} + {term}'}"]
        elif one.step.two == "opposite":
            lines += [f"{margin}for turn_{name} in (0, {module}pi):"]
            margin += "    "
            lines += [f"{margin}{name} = {value} + turn_{name}"]
        else:
            lines += [f"{margin}{name} = {value}"]
    row = ", ".join(identifier(name) for name in joints_found(result))
    return [*lines, f"{margin}solutions.append([{row}])", "    return solutions"]


def _matlab(result: Derivation) -> list[str]:
    names = [identifier(name) for name in lengths_used(result)]
    lines = [f"function solutions = inverse({', '.join(['T', *names])})"]
    said = f"Every solution of {result.robot.name}, a row each: radians and metres, in joint order."
    lines += [comment(said, "%").rstrip("\n")]
    lines += [f"{name} = T({row}, {column});" for name, row, column in entries_used(result)]
    lines += ["solutions = [];"]
    margin, ends = "", list[str]()
    for one in spelled_steps(result, "matlab"):
        step, name, spread = one.step, one.name, one.spread
        if step.two:
            choices = "[1, -1]" if step.two == "plus-minus" else "[0, pi]"
            lines += [f"{margin}for choice_{name} = {choices}"]
            ends.append(f"{margin}end")
            margin += "  "
        if step.two == "plus-minus" and isinstance(step.spread, Call):
            lines += [f"{margin}cosine = {spread.removeprefix('acos')};"]
            lines += [f"{margin}if abs(cosine) > 1, continue, end"]
            spread = "acos(cosine)"
        elif one.square:
            lines += [f"{margin}if {one.square} < 0, continue, end"]
        term = f"choice_{name}*{spread}" if step.two == "plus-minus" else f"choice_{name}" if step.two else ""
        whole = " + ".join(part for part in (one.value if one.value != "0" or not term else "", term) if part)
        lines += [f"{margin}{name} = {whole};"]
    row = ", ".join(identifier(name) for name in joints_found(result))
    return [*lines, f"{margin}solutions(end + 1, :) = [{row}];", *reversed(ends), "end"]


def joints_found(result: Derivation) -> list[str]:
    """The joints in joint order."""
    found = {name_of(step.atom) for step in result.steps}
    return [name for name in result.robot.variables if name in found]
