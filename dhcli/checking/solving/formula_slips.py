"""Slips in the terms of a formula for a joint: a square forgotten, a sign, one length for another."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from fractions import Fraction
from itertools import combinations, islice

from dhcli.algebra.floats import Floats
from dhcli.algebra.points import draws
from dhcli.checking.diagnosis.by_entry import slip_in
from dhcli.checking.diagnosis.mistakes.in_terms import IN_ENTRY, Among
from dhcli.checking.diagnosis.result import Slip
from dhcli.checking.diagnosis.terms import functions, lengths
from dhcli.checking.solving.covering import Asked, Case, Known
from dhcli.checking.solving.formulas import Formula
from dhcli.checking.solving.in_step import changed_step, with_other
from dhcli.checking.solving.typed import values_of
from dhcli.kinematics.inverse.derive_rules import Step
from dhcli.kinematics.robot import Robot
from dhcli.notation.angle import Angle
from dhcli.notation.names import natural_key
from dhcli.notation.tree import Call, Expr, Number, Product, Sum, Symbol, multiply, number
from dhcli.notation.trig import swapped
from dhcli.notation.walk import rebuild, walk
from dhcli.notation.writer import write

SEED = 17
POINTS = 40
"""Points at which two formulas are compared; an arccosine has no value at some of them."""

LEAST = 3
"""Points at which both must have values, to be the same."""

OF_SUMS = frozenset(("term-sign", "term-missing", "term-double", "term-half"))
"""Slips that are made in a sum; the others are made in the whole."""

OTHER_FUNCTION = {"acos": "asin", "asin": "acos"}


def slips_in_terms(typed: Formula, step: Step, robot: Robot, asked: Asked, cases: Sequence[Case]) -> tuple[Slip, ...]:
    """The slip in the terms of a formula that gives just another one, if there is one.

    Args:
        typed: The other formula.
        step: The formula, right.
        robot: The robot, for its names.
        asked: What it is a formula for.
        cases: Poses of the robot, which say how large everything is.
    """
    if not cases:
        return ()
    points = tuple(map(Floats, islice(_near(cases), POINTS)))
    wanted = [typed.at(point) for point in points]
    if sum(map(bool, wanted)) < LEAST:
        return ()

    def gives(changed: Step) -> bool:
        other = Formula(values_of(changed), "", 0)
        return all(_same(asked, values, other.at(point)) for values, point in zip(wanted, points, strict=True))

    what = " + ".join(name for name, _ in asked.terms)
    return tuple(islice((slip for slip, changed in _changed(step, robot, what) if gives(changed)), 1))


def _near(cases: Sequence[Case]) -> Iterator[Known]:
    """Values of all names as large as they are at some poses, but of no pose; what is the same at all of them stays."""
    held = {name: [one.known[name] for one in cases] for name in sorted(cases[0].known)}
    fixed = {name: values[0] for name, values in held.items() if all(value == values[0] for value in values)}
    floats = {name: [float(v) for v in values if not isinstance(v, Angle)] for name, values in held.items()}
    ranges = {name: (min(values), max(values)) for name, values in floats.items() if name not in fixed and values}
    return ({**point, **fixed} for point in draws(ranges, SEED))


def _same(asked: Asked, first: list[float], second: list[float]) -> bool:
    """Whether two formulas have the same values at a point."""

    def within(some: list[float], others: list[float]) -> bool:
        return all(any(asked.same(one, other) for other in others) for one in some)

    return within(first, second) and within(second, first)


def _changed(step: Step, robot: Robot, what: str) -> Iterator[tuple[Slip, Step]]:
    """The formula with one slip, in its whole or in one of its sums."""
    exprs = (step.value,) if step.spread is None else (step.value, step.spread)
    sums = tuple(dict.fromkeys(node for expr in exprs for node in walk(expr) if isinstance(node, Sum)))
    letters = sorted({one for expr in exprs for one in lengths(expr)}, key=lambda one: natural_key(one.name))
    angles = {name for expr in exprs for trig in functions(expr) for name in trig.angle.names}
    among = Among(tuple(sorted(angles, key=natural_key)), tuple(letters), robot.writing)
    yield from _in_whole(step, exprs, letters, what)
    for mistake in IN_ENTRY:
        for part in sums if mistake.id in OF_SUMS else exprs:
            with suppress(ZeroDivisionError, OverflowError):
                for text, other in mistake.made(part, among):
                    yield slip_in(mistake.id, text, f"the formula for {what}", what), with_other(step, part, other)


def _in_whole(step: Step, exprs: Sequence[Expr], letters: Sequence[Symbol], what: str) -> Iterator[tuple[Slip, Step]]:
    """Slips that stand all over a formula: functions, or two lengths, in each other's place."""
    shown = f"the formula for {what}"
    for call in dict.fromkeys(node for expr in exprs for node in walk(expr) if isinstance(node, Call)):
        if call.function in OTHER_FUNCTION:
            other = OTHER_FUNCTION[call.function]
            words, hint = f"{shown} has {other} for {call.function}", f"is it the sine of {what} that is known?"
            yield (
                Slip(f"function-other {what} {other}", words, hint),
                with_other(step, call, Call(other, call.arguments)),
            )
    for product in dict.fromkeys(node for expr in exprs for node in walk(expr) if isinstance(node, Product)):
        first, *others = product.factors
        if isinstance(first, Number) and abs(first.value) != 1:
            written = write(first if first.value.denominator == 1 else number(Fraction(1, first.value)))
            words, hint = f"the factor {written} is missing in {shown}", f"count the factors in {shown}"
            yield Slip(f"number-missing {what} {written}", words, hint), with_other(step, product, multiply(*others))
    words, hint = f"sines and cosines have changed places in {shown}", f"look at sines and cosines in {shown}"
    yield Slip(f"sin-cos {what}", words, hint), changed_step(step, lambda expr: rebuild(expr, swapped))
    for one, two in combinations(letters, 2):
        both: dict[Expr, Expr] = {one: two, two: one}
        words = f"{one.name} and {two.name} have changed places in {shown}"
        slip = Slip(
            f"letters-swapped {what} {one.name} and {two.name}", words, f"which letter belongs where in {shown}?"
        )
        yield slip, changed_step(step, lambda expr, both=both: rebuild(expr, lambda leaf: both.get(leaf, leaf)))  # type: ignore[misc]
