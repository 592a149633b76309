"""Answers that are right on one branch only: a square root loses the sign, an acos the side.

Whether an answer is right is decided elsewhere; here a wrong one gets a point to think about, and where it agrees with
the truth at some points, the condition under which it does.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from itertools import chain, islice
from typing import TypeAlias

from dhcli.algebra.equality import CLOSE, agree
from dhcli.algebra.floats import Floats
from dhcli.algebra.points import WHOLE, Reach, all_round, general
from dhcli.frozen import frozen
from dhcli.notation.angle import Angle
from dhcli.notation.styles import THETAS, Joints
from dhcli.notation.tree import Call, Expr, Number, Power, Symbol, Trig
from dhcli.notation.walk import angles_in, symbols, walk
from dhcli.notation.writer import write

Same: TypeAlias = Callable[[float, float], bool]

NEAR_ZERO = 1e-6
PLAIN_DIGITS = 1
PLAIN_POINTS = 6
PLAIN_SEED = 7

_LOSSES = {
    "acos": "acos gives angles from 0° to 180° only, atan2 all",
    "asin": "asin gives angles from -90° to 90° only, atan2 all",
    "atan": "atan does not tell opposite directions apart, atan2 does",
    "sqrt": "a square root loses the sign",
}


@frozen
class Sample:
    """Both answers at one point.

    Attributes:
        values: The point.
        typed: What the student's answer gives; NaN where it is not real.
        right: What the right one gives.
        same: Whether they agree.
    """

    values: dict[str, float]
    typed: float
    right: float
    same: bool


def same_angle(one: float, other: float) -> bool:
    """Whether two angles [rad] agree modulo a full turn."""
    return abs(math.remainder(one - other, math.tau)) <= CLOSE


def samples(typed: Expr, right: Expr, reach: Reach, same: Same = agree) -> tuple[Sample, ...]:
    """Both expressions at forty points; those where the right one is not real are left out."""
    found = []
    for values in all_round((typed, right), reach):
        over = Floats(values)
        one, other = over.value(typed), over.value(right)
        if math.isfinite(other):
            found.append(Sample(values, one, other, same(one, other)))
    return tuple(found)


def all_same(found: tuple[Sample, ...]) -> bool:
    """Whether two answers agree at every point, of which there is one at least."""
    return bool(found) and all(one.same for one in found)


def explained(typed: Expr, right: Expr, reach: Reach, same: Same = agree, writing: Joints = THETAS) -> str:
    """A point where an answer is wrong, with both numbers, after the condition under which it is right, if any."""
    may_hold = may_branch(typed) or may_branch(right)
    where = held(typed, right, samples(typed, right, reach, same), writing) if may_hold else ""
    point = _counterexample(typed, right, reach, same)
    return "; ".join(filter(None, (where, point)))


def may_branch(expr: Expr) -> bool:
    """Whether an expression may be right at some points and wrong at others; else what differs does so at nearly all.

    That of sums, products, cosines and sines of exact numbers may not. Decimals may agree by their digits.
    """
    if not symbols(expr):
        return False
    return any(
        type(node) is Call
        or (type(node) is Power and node.exponent.denominator != 1)
        or (type(node) is Number and node.places is not None)
        for node in walk(expr)
    )


def held(typed: Expr, right: Expr, found: tuple[Sample, ...], writing: Joints = THETAS) -> str:
    """Where an answer is right, and what loses the rest; empty if it is right nowhere, or everywhere."""
    agreed = [one.same for one in found]
    if all(agreed) or not any(agreed):
        return ""
    why = _loss(typed)
    condition = _condition(typed, right, found, writing)
    if not condition and not why:
        return ""  # it happens to agree somewhere
    where = condition or f"at {sum(agreed)} of {len(agreed)} points tried, on one branch"
    return f"right only {where}" + (f"; {why}" if why else "")


def _condition(typed: Expr, right: Expr, found: tuple[Sample, ...], writing: Joints) -> str:
    """The sign of some quantity that tells where two answers agree; empty if none does."""
    for text, quantity in _quantities(typed, right, writing):
        signs = [Floats(one.values).value(quantity) for one in found]
        for words, is_so in ((">= 0", 1.0), ("<= 0", -1.0)):
            if all(one.same == (sign * is_so >= 0) for one, sign in zip(found, signs, strict=True)):
                return f"where {text} {words}"
    return ""


def _quantities(typed: Expr, right: Expr, writing: Joints) -> Iterator[tuple[str, Expr]]:
    """What may have a sign: sines and cosines, the names, the truth, and what stands in the answer's functions."""
    seen = set[Expr]()
    angles = angles_in(right) | angles_in(typed)
    for tree in (right, typed):
        for node in walk(tree):
            both: tuple[Expr, ...] = ()
            if type(node) is Trig:
                both = (Trig("sin", node.angle), Trig("cos", node.angle))
            elif type(node) is Symbol:
                both = _of_angle(node) if node.name in angles else (node,)
            elif type(node) is Call:
                both = node.arguments
            for one in both:
                if one not in seen:
                    seen.add(one)
                    yield write(one, "full", writing), one
    yield "the right value", right


def _of_angle(node: Symbol) -> tuple[Expr, ...]:
    return Trig("sin", Angle.of(node.name)), Trig("cos", Angle.of(node.name))


def _loss(typed: Expr) -> str:
    """Which function of an answer gives one branch only."""
    for node in walk(typed):
        if type(node) is Call and node.function in _LOSSES:
            return _LOSSES[node.function]
        if type(node) is Power and node.exponent.denominator % 2 == 0:
            return _LOSSES["sqrt"]
    return ""


def _plain_points(typed: Expr, right: Expr, reach: Reach) -> Iterator[dict[str, float]]:
    """Points that are easy to try on paper, everything positive and below 75°, where the names may be there."""
    for values in islice(general(symbols(typed) | symbols(right), PLAIN_SEED), PLAIN_POINTS):
        within = ((values[name], reach[name]) for name in values.keys() & reach.keys())
        if all(low <= value <= high for value, (low, high) in within):
            yield values


def _counterexample(typed: Expr, right: Expr, reach: Reach, same: Same) -> str:
    unreal = ""
    for drawn in chain(_plain_points(typed, right, reach), all_round((typed, right), reach)):
        values = {name: round(value, 0 if reach.get(name) == WHOLE else PLAIN_DIGITS) for name, value in drawn.items()}
        over = Floats(values)
        one, other = over.value(typed), over.value(right)
        if not math.isfinite(other):
            continue
        where = ", ".join(f"{name} = {value:g}" for name, value in values.items())
        at = f"at {where}: " if where else ""
        if not math.isfinite(one):
            unreal = unreal or f"{at}yours has no real value, the right one is {other:.4g}"
        elif not same(one, other) and abs(one - other) > NEAR_ZERO:
            return f"{at}yours gives {one:.4g}, the right one {other:.4g}"
    return unreal
