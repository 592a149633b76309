"""A derivation as a formula sheet in LaTeX, and as a function that returns every solution."""

from __future__ import annotations

from collections.abc import Iterator

from dhcli.kinematics.inverse.derive import Derivation
from dhcli.kinematics.inverse.derive_levels import POSITION, ROTATION
from dhcli.kinematics.inverse.derive_rules import Step
from dhcli.kinematics.inverse.derive_terms import Atom, name_of
from dhcli.kinematics.validity import in_floats
from dhcli.notation.angle import Angle
from dhcli.notation.styles import identifier, latex_name
from dhcli.notation.tree import ZERO, Call, Expr, Trig
from dhcli.notation.walk import rebuild, symbols, walk
from dhcli.notation.writer import write
from dhcli.render.look import Look


def derivation_latex(result: Derivation, _look: Look) -> str:
    """The formulas, one a line, aligned at their equals signs."""
    lines = []
    for step in result.steps:
        value = write(step.value, "latex", result.robot.writing)
        if step.spread is not None:
            spread = write(step.spread, "latex", result.robot.writing)
            value = rf"\pm {spread}" if step.value == ZERO else rf"{value} \pm {spread}"
        if step.two == "opposite":
            value += r" \; (+\, 180^\circ)"
        lines.append(f"{_latex_atom(step.atom)} &= {value}")
    return "\\begin{aligned}\n" + " \\\\\n".join(lines) + "\n\\end{aligned}\n"


def _latex_atom(atom: Atom) -> str:
    if isinstance(atom, str):
        return latex_name(atom)
    text = " + ".join(latex_name(name) if factor > 0 else f"-{latex_name(name)}" for name, factor in atom)
    return text.replace("+ -", "- ")


def derivation_code(result: Derivation, look: Look) -> str:
    """A function of the pose and the lengths that returns a list of all solutions, joint values in joint order."""
    return "\n".join(_python(result) if look.format == "numpy" else _matlab(result)) + "\n"


def _lengths(result: Derivation) -> list[str]:
    """The lengths and constant angles that the formulas need."""
    used = {name for step in result.steps for expr in _exprs(step) for name in symbols(expr)}
    return [name for name in result.robot.parameters if name in used]


def _entries(result: Derivation) -> Iterator[tuple[str, int, int]]:
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


def _spelled(result: Derivation, style: str) -> Iterator[tuple[Step, str, str, str]]:
    """Each step with its name, its value, and what stands behind its sign."""
    sums: dict[tuple[tuple[str, object], ...], str] = {}
    for step in result.steps:
        value, spread = (
            "" if expr is None else write(_whole_sums(expr, sums), style, result.robot.writing)
            for expr in (step.value, step.spread)
        )
        if style == "numpy":  # the names that every numpy has
            value, spread = (
                t.replace("np.atan2", "np.arctan2").replace("np.acos", "np.arccos") for t in (value, spread)
            )
        name = identifier(name_of(step.atom))
        if not isinstance(step.atom, str) and len(step.atom) > 1:
            sums[step.atom] = name
        yield step, name, value, spread


def _python(result: Derivation) -> list[str]:
    values = {name: result.robot.parameters[name] for name in _lengths(result)}
    names = [f"{identifier(n)}={in_floats(v)!r}" for n, v in values.items() if v is not None]
    names = [*(identifier(n) for n, v in values.items() if v is None), *names]
    lines = ["import numpy as np", "", ""]
    lines += [f"def inverse({', '.join(['T', *names])}):"]
    lines += [f'    """Every solution of {result.robot.name}: joint values in radians and metres, in joint order."""']
    lines += [f"    {name} = T[{row - 1}][{column - 1}]" for name, row, column in _entries(result)]
    lines += ["    solutions = []"]
    margin = "    "
    for step, name, value, spread in _spelled(result, "numpy"):
        if step.two == "plus-minus":
            lines += [f"{margin}for sign_{name} in (1, -1):"]
            margin += "    "
            if isinstance(step.spread, Call):
                lines += [
                    f"{margin}cosine = {spread.removeprefix('np.arccos')}",
                    f"{margin}if abs(cosine) > 1:",
                    f"{margin}    continue",
                ]
                term = f"sign_{name}*np.arccos(cosine)"
            else:
                term = f"sign_{name}*{spread}"
            lines += [f"{margin}{name} = {term if value == '0' else f'{value} + {term}'}"]
        elif step.two == "opposite":
            lines += [f"{margin}for turn_{name} in (0, np.pi):"]
            margin += "    "
            lines += [f"{margin}{name} = {value} + turn_{name}"]
        else:
            lines += [f"{margin}{name} = {value}"]
    row = ", ".join(identifier(name) for name in _found(result))
    return [*lines, f"{margin}solutions.append([{row}])", "    return solutions"]


def _matlab(result: Derivation) -> list[str]:
    names = [identifier(name) for name in _lengths(result)]
    lines = [f"function solutions = inverse({', '.join(['T', *names])})"]
    lines += [f"% Every solution of {result.robot.name}, a row each: radians and metres, in joint order."]
    lines += [f"{name} = T({row}, {column});" for name, row, column in _entries(result)]
    lines += ["solutions = [];"]
    margin, ends = "", list[str]()
    for step, name, value, spread in _spelled(result, "matlab"):
        if step.two:
            choices = "[1, -1]" if step.two == "plus-minus" else "[0, pi]"
            lines += [f"{margin}for choice_{name} = {choices}"]
            ends.append(f"{margin}end")
            margin += "  "
        if step.two == "plus-minus" and isinstance(step.spread, Call):
            lines += [f"{margin}cosine = {spread.removeprefix('acos')};"]
            lines += [f"{margin}if abs(cosine) > 1, continue, end"]
            spread = "acos(cosine)"  # noqa: PLW2901  what was just given a name
        term = f"choice_{name}*{spread}" if step.two == "plus-minus" else f"choice_{name}" if step.two else ""
        whole = " + ".join(part for part in (value if value != "0" or not term else "", term) if part)
        lines += [f"{margin}{name} = {whole};"]
    row = ", ".join(identifier(name) for name in _found(result))
    return [*lines, f"{margin}solutions(end + 1, :) = [{row}];", *reversed(ends), "end"]


def _found(result: Derivation) -> list[str]:
    """The joints in joint order."""
    found = {name_of(step.atom) for step in result.steps}
    return [name for name in result.robot.variables if name in found]
