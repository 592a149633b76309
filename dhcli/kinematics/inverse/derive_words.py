"""A derivation in words: its unknowns, its equations with the level they stand on, and its formulas."""

from __future__ import annotations

from collections.abc import Callable

from dhcli.errors import plural
from dhcli.kinematics.inverse.derivation import Derivation
from dhcli.kinematics.inverse.derive_levels import Equation
from dhcli.kinematics.inverse.derive_rules import Step
from dhcli.kinematics.inverse.derive_terms import Atom, name_of
from dhcli.notation.tree import HALF, ZERO, Call, Power, is_negative, negate
from dhcli.notation.walk import symbols
from dhcli.notation.writer import write

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


_WHOLE = 12
"""The entries of a pose."""

_LONG = 48
"""A formula of more characters is not written twice."""


def proof_text(result: Derivation) -> str:
    """How many combinations of signs there are, and which of them lead back to the pose."""
    signs = plural(result.branches, "combination")
    tried = f"tried at {result.proved} random poses and lengths"
    which = "of which some lead back to the pose" if result.strangers else "each a solution where all are real"
    return f"{signs} of signs, {which}: {tried}"


def left_text(result: Derivation, style: str) -> str:
    """Which poses an arm of few joints has solutions for; nothing where it is all that are near enough."""
    joints = set(result.robot.variables)
    fixed = [one for one in result.left if joints.isdisjoint(symbols(one.right))]
    plain = ", ".join(f"{write(one.left, style)} = {write(one.right, style, result.robot.writing)}" for one in fixed)
    back = ", ".join(write(one.left, style) for one in result.left if one not in fixed)
    said = [f"with {plain}"] if plain else []
    said += [f"where the joint values lead back to {back}"] if back else []
    if not fixed and len(result.left) == _WHOLE:
        return "only for poses that the joint values lead back to"
    return f"only for poses {', and '.join(said)}" if said else ""


def atom_text(atom: Atom, spelled: Callable[[str], str] = str) -> str:
    """An unknown, `theta2 + theta3`, its names spelled as they are or otherwise."""
    if isinstance(atom, str):
        return spelled(atom)
    text = " + ".join(spelled(name) if factor > 0 else f"-{spelled(name)}" for name, factor in atom)
    return text.replace("+ -", "- ")


def named_text(atom: Atom, spelled: Callable[[str], str] = str) -> str:
    """An unknown before its formula, a sum with the name that it has in later ones: `theta23 = theta2 + theta3`."""
    text, name = atom_text(atom, spelled), spelled(name_of(atom))
    return text if isinstance(atom, str) or len(atom) == 1 else f"{name} = {text}"


def value_text(step: Step, style: str, *, joints_of: Derivation) -> str:
    """A formula with its sign: `± acos(...)`, `atan2(...), or 180° more`."""
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
    condition = step.condition
    if step.spread is None:  # a root is 0 where what it is taken of is, and the sign says nothing
        condition = condition.base if type(condition) is Power and condition.exponent == HALF else condition
        condition = negate(condition) if is_negative(condition) else condition
    text = write(condition, style, result.robot.writing)
    is_long = len(write(condition, "short", result.robot.writing)) > _LONG
    text = f"${text}$" if style == "latex" else text
    if isinstance(step.spread, Call):
        return f"no solution where {'that cosine' if is_long else text} is beyond -1 or 1"
    if step.spread is not None:
        return f"no solution where {'what the root is taken of' if is_long else text} is negative"
    if (other := step.instead) is not None:
        value = write(other.value, style, result.robot.writing)
        value = f"${value}$" if style == "latex" else value
        half = ", or 180° more" if other.two else ""
        levels = " and ".join(level_text(result, one) for one in other.equations)
        return f"where {text} = 0 it is {value}{half}, from {levels}"
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
