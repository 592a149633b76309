"""How an answer came about: which rule found each joint and from what, and which limits keep solutions out."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from dhcli.errors import joined
from dhcli.frozen import frozen
from dhcli.kinematics.derived import in_floats
from dhcli.kinematics.inverse.motions import POINT
from dhcli.kinematics.inverse.solutions import Solutions, shown_beyond
from dhcli.kinematics.inverse.steps import All, Equation, One, Step, Two
from dhcli.notation.writer import write_value

if TYPE_CHECKING:
    from dhcli.kinematics.inverse.prepared import Prepared

_KINDS = {
    "both": "one value, from two equations linear in its cosine and sine",
    "opposite": "two values half a turn apart, from a c + b s = 0",
    "pair": "two values, ±, from a c + b s = e",
    "length": "one value, from an equation linear in it",
    "lengths": "two values, from a quadratic equation",
}
"""How many values a joint has, and from what."""

_THINGS = ("direction", "point", "line", "circle")
"""What a run of joints leaves fixed, by its kind."""


@frozen
class Explanation:
    """How an answer came about.

    Attributes:
        rules: The rules used, such as ONE.
        moves: What moves of the steps are that have no variable of their own, such as `theta3 = j3 - j2`.
        steps: A line for each joint in the order in which they were found.
        limits: A line for each solution that is outside the limits.
    """

    rules: tuple[str, ...]
    moves: tuple[str, ...]
    steps: tuple[str, ...]
    limits: tuple[str, ...]


def explained(found: Solutions) -> Explanation:
    """How solutions were found, and what keeps some of them out."""
    if found.ready is None:
        together = joined(found.robot.variables)
        led = f"{together}: by Newton's steps from many places; what arrives is kept, each solution once"
        return Explanation((), (), (led,), tuple(_limits(found)))
    plan = found.ready.plan
    names = [axis.name for axis in found.ready.arm.axes[: found.ready.arm.joints]]
    held = [f"{names[j]}: held, the arm has more joints than this needs" for j in plan.held]
    steps = [_step(found.ready, step, names) for step in plan.steps]
    joints = found.robot.writing
    moves = tuple(
        f"{name} = {write_value(value, 'full', joints)}" for name, value in found.shared.items() if name in names
    )
    return Explanation(plan.rules, moves, (*held, *steps), tuple(_limits(found)))


def _step(ready: Prepared, step: Step, names: Sequence[str]) -> str:
    match step:
        case One():
            things = dict.fromkeys(thing for e in step.equations for thing in _things(e, names))
            return f"{names[step.joint]}: {_KINDS[step.kind]}" + (f"; by {joined(things)}" if things else "")
        case Two():
            pair = f"{names[step.joint]} from two equations that hold {_name(names, step.other)} too"
            return f"{pair}: at most 8 values, roots of one polynomial"
        case All():
            three = joined([_name(names, j) for j in step.joints])
            most = "at most 16 values, eigenvalues" if ready.arm.joints > 5 else "eigenvalues"  # noqa: PLR2004
            return f"{three} at once from fourteen equations: {most}"


def _things(equation: Equation, names: Sequence[str]) -> Iterator[str]:
    """What the two runs of an equation leave where it is."""
    cut = equation.cut
    for thing, run in ((equation.x, cut.second), (equation.y, cut.first)):
        if not run:
            continue
        flat = cut.kind == POINT and not thing[0]
        own = [names[j] for j in run if j < len(names)]
        fixed = f"fixed under {', '.join(own)}" if own else "wanted"
        yield f"the {'plane' if flat else _THINGS[cut.kind]} {fixed}"


def _name(names: Sequence[str], joint: int) -> str:
    return names[joint] if joint < len(names) else "a motion that the task leaves free"


def _limits(found: Solutions) -> Iterator[str]:
    """For each solution outside the limits its joints there, by how much, and what their limits are."""
    for k, outside in enumerate(found.beyond):
        for beyond in outside:
            yield f"{k + 1}: {_limit(found, k, shown_beyond(found.robot, beyond), beyond.joint)}"
    if found.left_out is not None:
        for k, outside in enumerate(found.left_out.beyond):
            branch = found.left_out.branches[k] or "a solution"
            for beyond in outside:
                words = _limit(found.left_out, k, shown_beyond(found.robot, beyond), beyond.joint)
                yield f"{branch}, left out: {words}"


def _limit(found: Solutions, k: int, words: str, joint: str) -> str:
    at = found.robot.variables.index(joint)
    turns = found.robot.joints[at].kind == "revolute"
    limits = (in_floats(limit) for limit in found.robot.limits[joint])
    value, low, high = (_shown(x, turns=turns) for x in (float(found.q[k][at]), *limits))
    return f"{joint} would be {value}, its limits are {low} and {high} ({words.removeprefix(joint).strip()})"


def _shown(value: float, *, turns: bool) -> str:
    return f"{round(math.degrees(value), 2) + 0.0:g}°" if turns else f"{value + 0.0:.4g} m"
