"""A derivation put into numbers: every combination of signs, step by step."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

from dhcli.algebra.floats import Floats
from dhcli.kinematics.frames import between
from dhcli.kinematics.inverse.derivation import Derivation
from dhcli.kinematics.inverse.derive_levels import POSITION
from dhcli.kinematics.inverse.derive_points import Points, pose_values
from dhcli.kinematics.inverse.derive_rules import FAINT, Step
from dhcli.kinematics.inverse.derive_terms import Atom, name_of
from dhcli.notation.angle import Angle

TRIED = 12
"""Random poses at which a derivation is proved."""

_NEAR = 1e-6
"""Rounding of a long formula, in lengths of about 1 and in cosines."""


def joint_values(derivation: Derivation, known: Mapping[str, Angle | float]) -> Iterator[dict[str, float]]:
    """Joint values that the formulas give for a pose, one for each combination of signs that has real numbers.

    Args:
        derivation: The derivation.
        known: The entries of the pose by their names, `r11` to `r33`, `px`, `py`, `pz` [m], and every length and
            constant angle.
    """
    for values in _branches(derivation, 0, dict(known), {}):
        yield {name: values[name] for step in derivation.steps for name in _joints(step)}


def poses_proved(derivation: Derivation, *, strangers: bool = False) -> int:
    """At how many random poses the formulas are right; 0 where they are wrong at one.

    Args:
        derivation: The derivation.
        strangers: Whether combinations of signs may be there that lead to other poses.
    """
    robot = derivation.robot
    chain = between(robot, derivation.start, derivation.end)
    points = Points(robot, derivation.start, derivation.end)
    for values in points.values_of[:TRIED]:
        joints = {name for step in derivation.steps for name in _joints(step)}
        known = {name: value for name, value in values.items() if name not in joints}
        back = False
        for found in joint_values(derivation, known):
            there = pose_values(chain, {**values, **found})
            wanted = POSITION if derivation.place_only else tuple(there)
            if any(_apart(there[name], values[name], turns=False) > _NEAR for name in wanted):
                if not strangers:
                    return 0
                continue
            back = back or all(_apart(found[name], values[name], turns=name in robot.angles) < _NEAR for name in joints)
        if not back:
            return 0
    return TRIED


def _apart(one: float, other: Angle | float, *, turns: bool) -> float:
    gap = one - (other.constant() if isinstance(other, Angle) else other)
    return abs(math.remainder(gap, 2 * math.pi) if turns else gap)


def _joints(step: Step) -> tuple[str, ...]:
    if isinstance(step.atom, str):
        return (step.atom,)
    return tuple(name for name, _ in step.atom) if len(step.atom) == 1 else ()


def _branches(
    derivation: Derivation, at: int, values: dict[str, Angle | float], sums: dict[Atom, float]
) -> Iterator[dict[str, float]]:
    if at == len(derivation.steps):
        yield {name: value for name, value in values.items() if not isinstance(value, Angle)}
        return
    step = derivation.steps[at]
    over = Floats(values)
    value = _value(step, over)
    spread = 0.0 if step.spread is None else over.value(step.spread)
    turn = math.pi if step.two == "opposite" else spread
    for found in (
        (value + turn, value - turn) if step.two == "plus-minus" else (value, value + turn)[: 1 + bool(step.two)]
    ):
        if not math.isfinite(found):
            continue
        more, known_sums = dict(values), dict(sums)
        more[name_of(step.atom)] = found
        if not isinstance(step.atom, str) and (len(step.atom) > 1 or step.atom[0][1] != 1):
            known_sums[step.atom] = found
        if not isinstance(step.atom, str) and len(step.atom) == 1:
            more[step.atom[0][0]] = found / float(step.atom[0][1])
        _stand_in(derivation, at, more, known_sums)
        yield from _branches(derivation, at + 1, more, known_sums)


def _value(step: Step, over: Floats) -> float:
    """The value of a step, or of the one instead where it says nothing."""
    other = step.instead
    if other is not None:
        size, stronger = (sum(abs(over.value(part)) for part in one.arc) for one in (step, other))
        if size <= FAINT * stronger:
            return over.value(other.value)
    return over.value(step.value)


def _stand_in(derivation: Derivation, at: int, values: dict[str, Angle | float], sums: Mapping[Atom, float]) -> None:
    """Values of joints of which a sum alone is known, so that the sum is right; they are found later."""
    found = {name for step in derivation.steps[: at + 1] for name in _joints(step)}
    for atom, total in sums.items():
        if isinstance(atom, str):
            continue
        open_ones = [(name, factor) for name, factor in atom if name not in found]
        if not open_ones:
            continue
        last, multiple = open_ones[-1]
        rest = total
        for name, factor in atom:
            if name == last:
                continue
            if name not in found:
                values[name] = 0.0
            value = values[name]
            rest -= float(factor) * (value if not isinstance(value, Angle) else value.constant())
        values[last] = rest / float(multiple)
