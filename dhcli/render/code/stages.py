"""The steps of a derivation as formulas over one tape, so that none of them computes what another has."""

from __future__ import annotations

import math
from collections.abc import Iterator

from dhcli.algebra.arithmetic import evaluate
from dhcli.algebra.tape import Number
from dhcli.algebra.written import Lean, Written, written
from dhcli.frozen import frozen
from dhcli.kinematics.inverse.derivation import Derivation
from dhcli.kinematics.inverse.derive_levels import POSITION, ROTATION
from dhcli.kinematics.inverse.derive_rules import Step
from dhcli.kinematics.inverse.derive_terms import name_of
from dhcli.notation.angle import Angle
from dhcli.notation.tree import Call, Expr, Trig, add, negate
from dhcli.notation.walk import rebuild, symbols_in, walk


@frozen
class Stage:
    """A step in formulas that share their parts with all other steps.

    Attributes:
        step: The step.
        name: What its unknown is called.
        before: What there must be a root or an arc cosine of, if the step has one.
        value: Its value, or what stands before the sign.
        spread: What stands behind the sign, if anything does; the arc cosine of `before` where that is one.
        instead: Its value where sine and cosine in the other say nothing, if the step has one.
        ranges_later: Whether a step behind it has no value for some values of its unknown.
    """

    step: Step
    name: str
    before: Expr | None
    value: Expr
    spread: Expr | None
    instead: Expr | None
    ranges_later: bool

    @property
    def is_tried(self) -> bool:
        """Whether the unknown is tried in four places where it is free: not in all of them has a later one a value."""
        return self.step.is_met_often and self.step.two == "opposite" and self.instead is None and self.ranges_later

    @property
    def has_cosine(self) -> bool:
        """Whether the unknown is plus or minus an arc cosine."""
        return self.step.two == "plus-minus" and isinstance(self.step.spread, Call)


@frozen
class Stages:
    """All steps of a derivation.

    Attributes:
        formulas: Names for what occurs more than once.
        steps: The steps in order.
        gaps: What must be 0 in the end, within a tolerance: how far the joint values lead beside the pose.
    """

    formulas: Written
    steps: tuple[Stage, ...]
    gaps: tuple[Expr, ...]

    @property
    def most(self) -> int:
        """How many solutions there may be."""
        return math.prod(4 if stage.is_tried else 2 if stage.step.two else 1 for stage in self.steps)


def shared(result: Derivation) -> Stages:
    """All formulas of a derivation over one tape."""
    unknown = [name_of(step.atom) for step in result.steps]
    tape = Lean(list(dict.fromkeys([*lengths_used(result), *(name for name, _, _ in entries_used(result)), *unknown])))
    sums: dict[tuple[tuple[str, object], ...], str] = {}
    numbers, places = list[Number](), list[list[int | None]]()
    indices = dict(result.robot.writing.index)
    for step, name in zip(result.steps, unknown, strict=True):
        row: list[int | None] = []
        for expr in _parts(step):
            row.append(None if expr is None else len(numbers))
            if expr is not None:
                numbers.append(evaluate(_whole_sums(expr, sums), tape))
        places.append(row)
        if not isinstance(step.atom, str) and len(step.atom) > 1:
            sums[step.atom] = name
            digits = [indices.get(part, "") for part, factor in step.atom if factor == 1]
            if len(digits) == len(step.atom) and all(digits):
                indices[name] = "".join(digits)
    first = len(numbers)
    numbers += [evaluate(_whole_sums(add(one.right, negate(one.left)), sums), tape) for one in result.left]
    formulas = written(tape, numbers, indices)
    found = [[None if place is None else formulas.results[place] for place in row] for row in places]
    steps = tuple(
        Stage(step, name, before, value, spread, instead, any(s.two == "plus-minus" for s in result.steps[k:]))
        for k, (step, name, (before, value, spread, instead)) in enumerate(
            zip(result.steps, unknown, found, strict=True), 1
        )
        if value is not None
    )
    return Stages(formulas, steps, formulas.results[first:])


def _parts(step: Step) -> tuple[Expr | None, Expr, Expr | None, Expr | None]:
    """What must not be out of range, the value, what stands behind the sign, and the value instead."""
    if step.two == "plus-minus" and isinstance(step.spread, Call):
        return step.spread.arguments[0], step.value, None, None
    instead = None if step.instead is None else step.instead.value
    return step.condition if step.two == "plus-minus" else None, step.value, step.spread, instead


def lengths_used(result: Derivation) -> list[str]:
    """The lengths and constant angles that the formulas need."""
    used = _used(result)
    return [name for name in result.robot.parameters if name in used]


def entries_used(result: Derivation) -> Iterator[tuple[str, int, int]]:
    """The entries of the pose that the formulas need, with their row and column from 1."""
    used = _used(result)
    for name in ROTATION:
        if name in used:
            yield name, int(name[1]), int(name[2])
    for row, name in enumerate(POSITION, 1):
        if name in used:
            yield name, row, 4


def _used(result: Derivation) -> frozenset[str]:
    every = [expr for step in result.steps for expr in (step.value, step.spread, *_parts(step)) if expr is not None]
    return symbols_in((*every, *(side for one in result.left for side in (one.left, one.right))))


def _whole_sums(expr: Expr, sums: dict[tuple[tuple[str, object], ...], str]) -> Expr:
    """An expression in which a sum that was found as a whole has a name of its own."""

    def leaf(node: Expr) -> Expr:
        if type(node) is Trig and node.angle.terms in sums:
            whole = Angle.of(sums[node.angle.terms])
            return Trig(node.function, Angle(whole.terms, node.angle.degrees, node.angle.radians))
        return node

    # what is put together again anew loses the root below a line
    return rebuild(expr, leaf) if any(leaf(node) != node for node in walk(expr)) else expr
