"""Slips of a formula in whatever form it is typed: it is right once one of them is taken back.

A book has one form of each formula, and slips in that form are ready to be compared. Whoever computes an angle another
way, `atan2(±sqrt(1 - D^2), D)` for an arccosine, makes the same slips in what no derivation has.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import combinations

from dhcli.checking.diagnosis.by_entry import slip_in
from dhcli.checking.diagnosis.result import Rank, Slip
from dhcli.checking.diagnosis.terms import shown
from dhcli.checking.solving.formulas import Formula
from dhcli.checking.solving.in_step import COSINE, ORDINALS, SINE, SWAPPED, Arctangent, angle_sign, exchanged, negated
from dhcli.notation.styles import Joints
from dhcli.notation.tree import PI, Call, Expr, Power, Sum, add, multiply, negate, number
from dhcli.notation.walk import put_for, walk

LONGEST = 20
"""Characters of a term that is told; of a longer one only where it stands."""

Test = Callable[[Formula], bool]
_IN_ARCS = {
    "acos": ("asin", "the sign of what stands in acos is turned round in the formula for {}", "acos-sign"),
    "asin": ("acos", "the sign of what stands in asin is turned round in the formula for {}", "asin-sign"),
}


def mended_functions(formula: Formula, name: str, is_right: Test) -> tuple[Slip, ...]:
    """The slip in the inverse functions of a formula, if it is right without that.

    Args:
        formula: A formula that is wrong.
        name: What it is for.
        is_right: Whether another one is right.
    """
    return _first(_in_functions(formula, name), is_right)


def mended_terms(formula: Formula, name: str, writing: Joints, is_right: Test) -> tuple[Slip, ...]:
    """The sign of a term of a formula, if it is right with the other one."""
    return _first(_in_sums(formula, name, writing), is_right)


def mended_zero(formula: Formula, name: str, is_sound: Test) -> tuple[Slip, ...]:
    """From where an angle is counted, if all that a formula gives solves once it is counted from elsewhere."""
    return _first(_counted_from_elsewhere(formula, name), is_sound)


def mended(formula: Formula, name: str, writing: Joints) -> Iterator[tuple[Slip, Formula]]:
    """Every slip that may be taken back in a formula, and the formula without it."""
    yield from _in_functions(formula, name)
    yield from _in_sums(formula, name, writing)


def _first(found: Iterator[tuple[Slip, Formula]], is_right: Test) -> tuple[Slip, ...]:
    return next(((slip,) for slip, mended in found if is_right(mended)), ())


def _in_functions(formula: Formula, name: str) -> Iterator[tuple[Slip, Formula]]:
    for k, count in _each(formula, "atan2"):
        yield Arctangent(name, k, count).slip(SWAPPED), _changed(formula, "atan2", k, exchanged)
    widths = {len(value.terms) if isinstance(value, Sum) else 0 for value in formula.values}
    for k in range(min(widths)) if len(widths) == 1 else ():
        if all(any(isinstance(node, Call) for node in walk(_terms(value)[k])) for value in formula.values):
            yield angle_sign(name), _with_values(formula, lambda value, k=k: _turned(value, k))  # type: ignore[misc]
    for k, count in _each(formula, "atan2"):
        for at, kind in enumerate((SINE, COSINE)):
            change = _changed(formula, "atan2", k, lambda call, at=at: negated(call, at))  # type: ignore[misc]
            yield Arctangent(name, k, count).slip(kind), change
    for function, (other, words, kind) in _IN_ARCS.items():
        for k, _ in _each(formula, function):
            sign = Slip(f"{kind} {name}", words.format(name), "which angle of the triangle is it?")
            yield sign, _changed(formula, function, k, lambda call: negated(call, 0))
            text, hint = (
                f"the formula for {name} has {function} for {other}",
                f"is it the sine of {name} that is known?",
            )
            exchange = _changed(formula, function, k, lambda call, other=other: Call(other, call.arguments))  # type: ignore[misc]
            yield Slip(f"function-other {name} {function}", text, hint), exchange


def _counted_from_elsewhere(formula: Formula, name: str) -> Iterator[tuple[Slip, Formula]]:
    for quarters in (1, -1, 2):
        off = f"{'-' if quarters > 0 else ''}{90 * abs(quarters)}°" if abs(quarters) == 1 else "180°"
        slip = Slip(f"zero-off {name} {off}", f"{name} is off by {off}", f"from which direction is {name} counted?")
        angle = multiply(number(Fraction(quarters, 2)), PI)
        yield slip, _with_values(formula, lambda value, angle=angle: add(value, angle))  # type: ignore[misc]


def _in_sums(formula: Formula, name: str, writing: Joints) -> Iterator[tuple[Slip, Formula]]:
    nodes = [node for value in formula.values for node in walk(value)]
    roots = {node.base for node in nodes if isinstance(node, Power) and node.exponent.denominator == 2}  # noqa: PLR2004
    for whole in dict.fromkeys(node for node in nodes if isinstance(node, Sum)):
        for k, term in enumerate(whole.terms):
            text = shown(term, writing)
            if len(text) <= LONGEST:
                slip = slip_in("term-sign", text, f"the formula for {name}", name)
            elif whole in roots:
                words = f"a sign under a square root is turned round in the formula for {name}"
                slip = Slip(f"root-sign {name}", words, "sin² = 1 - cos²: which signs stand there?")
            else:
                words = f"a sign is turned round in the formula for {name}"
                slip = Slip(f"inner-sign {name}", words, f"look at the signs in the formula for {name}")
            yield slip, _with_instead(formula, whole, _turned(whole, k))
        for one, two in combinations(range(len(whole.terms)), 2):
            both = [shown(whole.terms[k], writing) for k in (one, two)]
            words = f"the signs of {both[0]} and {both[1]} in the formula for {name} are turned round"
            slip = Slip(
                f"term-signs {name} {both[0]} and {both[1]}", words, f"look at the signs of {name}", Rank.SYMPTOM
            )
            if max(map(len, both)) <= LONGEST:
                yield slip, _with_instead(formula, whole, _turned(whole, one, two))


def _with_instead(formula: Formula, old: Expr, new: Expr) -> Formula:
    """A formula with one expression in the place of another, wherever that stands."""
    return _with_values(formula, lambda value: put_for(value, {old: new}))


def _each(formula: Formula, function: str) -> Iterator[tuple[int, int]]:
    """The number of each call of a function from 0, and how many there are, where all values have as many."""
    counts = {len(_calls(value, function)) for value in formula.values}
    if len(counts) == 1:
        count = min(counts.pop(), len(ORDINALS))
        yield from ((k, count) for k in range(count))


def _changed(formula: Formula, function: str, k: int, change: Callable[[Call], Call]) -> Formula:
    """A formula with one of its calls changed, in each of its values."""

    def value_with(value: Expr) -> Expr:
        call = _calls(value, function)[k]
        return put_for(value, {call: change(call)})

    return _with_values(formula, value_with)


def _with_values(formula: Formula, change: Callable[[Expr], Expr]) -> Formula:
    return replace(formula, values=tuple(map(change, formula.values)), together=tuple(map(change, formula.together)))


def _calls(value: Expr, function: str) -> Sequence[Call]:
    """The calls of a function in a value, from the left."""
    return [node for node in walk(value) if isinstance(node, Call) and node.function == function]


def _terms(value: Expr) -> Sequence[Expr]:
    return value.terms if isinstance(value, Sum) else (value,)


def _turned(value: Expr, *places: int) -> Expr:
    """A sum with the other sign before some of its terms."""
    return add(*(negate(term) if k in places else term for k, term in enumerate(_terms(value))))
