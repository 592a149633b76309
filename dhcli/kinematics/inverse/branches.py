"""Names of branches, from the pose of the arm: never from the order in which roots happen to come."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from math import prod
from typing import TYPE_CHECKING

import numpy as np

from dhcli.frozen import frozen
from dhcli.kinematics.inverse.anatomy import Anatomy, posture
from dhcli.kinematics.inverse.polishing import product
from dhcli.kinematics.inverse.rows import Rows
from dhcli.kinematics.inverse.steps import One, Plan

if TYPE_CHECKING:
    from dhcli.kinematics.inverse.arm import Arm, Array, Flags

_NOWHERE = 1e-9

_PLACES = 6
"""Decimals of a degree or metre beyond which a value in a name is noise."""


@frozen
class Told:
    """The variables that a person knows solutions by, in the place of the motions of the arm.

    Attributes:
        names: The variables.
        turning: Which of them turn, shape (n,).
        q: Their values at the solutions, shape (K, n).
        signs: For a joint of the arm the variable by which alone it moves, and the sign of its rate; a joint that is
            not among them is not named.
    """

    names: tuple[str, ...]
    turning: Flags
    q: Array
    signs: Mapping[str, tuple[str, int]]

    @classmethod
    def own(cls, arm: Arm, motions: Array) -> Told:
        """Of an arm each of whose joints has a variable of its own."""
        names = tuple(axis.name for axis in arm.axes[: arm.joints])
        return cls(names, arm.turning, motions / arm.factors, {name: (name, 1) for name in names})


def branch_names(plan: Plan, parts: Anatomy, motions: Array, told: Told | None = None) -> tuple[str, ...]:
    """A name for each of some solutions of one pose.

    The words for shoulder, elbow and wrist first; where they leave two solutions with one name, the signs that tell
    the roots of the plan's equations apart, such as `theta3 +`, and at last the value of a joint itself.

    Args:
        plan: The plan that found them.
        parts: The parts of the arm.
        motions: The solutions, shape (K, n).
        told: The variables to name them by; by default the arm's own.
    """
    arm = plan.actions.arm
    told = told or Told.own(arm, motions)
    said = posture(arm, parts, motions)
    for name, signs in _signs(plan, motions, told):
        if max(Counter(map(tuple, said)).values(), default=0) < 2:  # noqa: PLR2004
            break
        if _tells(said, signs):
            said = [words + ([f"{name} {sign}"] if sign else []) for words, sign in zip(said, signs, strict=True)]
    return with_values(told, said)


def factors(plan: Plan, parts: Anatomy, motions: Array, told: Told | None = None) -> tuple[tuple[str, int], ...]:
    """What the number of solutions of one pose is a product of: each choice between roots, and between how many.

    Args:
        plan: The plan that found them.
        parts: The parts of the arm.
        motions: The solutions, shape (K, n).
        told: The variables to name them by; by default the arm's own.

    Returns:
        Names, a joint or `wrist`, and counts; nothing where the choices do not multiply to the number.
    """
    arm = plan.actions.arm
    told = told or Told.own(arm, motions)
    last = [axis.name for axis in arm.axes[: arm.joints]][-3:] if parts.flips else []
    wrist = {told.signs[name][0] for name in last if name in told.signs}
    counts = [("wrist" if name in wrist else name, len(set(signs))) for name, signs in _signs(plan, motions, told)]
    found = tuple((name, count) for name, count in counts if count > 1)
    return found if prod(count for _, count in found) == len(motions) > 1 else ()


def _tells(said: Sequence[Sequence[str]], signs: Sequence[str]) -> bool:
    """Whether signs tell apart what words do not."""
    groups: dict[tuple[str, ...], set[str]] = {}
    for words, sign in zip(said, signs, strict=True):
        groups.setdefault(tuple(words), set()).add(sign)
    return any(len(group) > 1 for group in groups.values())


def _signs(plan: Plan, motions: Array, told: Told) -> list[tuple[str, list[str]]]:
    """For each joint with two roots the sign of the slope of its equation, which changes where the roots meet only."""
    arm = plan.actions.arm
    rows = Rows.start(plan.actions, product(arm, motions), {})
    for j in range(arm.joints):
        value = motions[:, j]
        rows.known[j] = (np.cos(value), np.sin(value)) if arm.axes[j].turns else (value, value * value / 2)
    found: dict[str, list[str]] = {}
    for step in plan.steps:
        if not isinstance(step, One) or step.kind not in {"pair", "opposite", "lengths"}:
            continue
        name, way = told.signs.get(arm.axes[step.joint].name, ("", 1))
        if not name or name in found:  # of one variable that makes two such moves the first sign counts
            continue
        _, a, b = rows.coefficients(step.equations[0], step.joint)
        u, v = rows.known[step.joint]
        slope = np.broadcast_to(b * u - a * v if arm.axes[step.joint].turns else a + b * u, len(motions))
        slope = slope * np.sign(arm.factors[step.joint]) * way
        found[name] = ["" if abs(x) < _NOWHERE * step.equations[0].size else "+" if x > 0 else "-" for x in slope]
    return list(found.items())


def with_values(told: Told, said: Sequence[Sequence[str]]) -> tuple[str, ...]:
    """Names from words, those that are alike made different by the value of the first variable that differs."""
    names = [", ".join(words) for words in said]
    result = list(names)
    for name, times in Counter(names).items():
        if times < 2:  # noqa: PLR2004
            continue
        at = [k for k, other in enumerate(names) if other == name]
        columns = np.round(np.degrees(told.q[at]), _PLACES).T + 0.0  # rounding tells nothing apart, nor does -0 from 0
        spread = np.array([len({f"{x:.4g}" for x in column}) for column in columns.tolist()])
        j = int(np.argmax(spread))
        for k, value in zip(at, told.q[at, j].tolist(), strict=True):
            size = round(np.degrees(value) if told.turning[j] else value, _PLACES) + 0.0
            shown = f"{size:.4g}{'°' if told.turning[j] else ' m'}"
            result[k] = ", ".join(filter(None, (name, f"{told.names[j]} = {shown}")))
    return tuple(result)
