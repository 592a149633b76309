"""Joint values as a book derives them: in letters, one after the other, each from an equation of one level."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import combinations, permutations
from typing import TypeAlias

from dhcli.errors import RobotError
from dhcli.kinematics.frames import check_moves, ends
from dhcli.kinematics.inverse.derivation import Derivation
from dhcli.kinematics.inverse.derive_checks import COORDINATES, left_to_check
from dhcli.kinematics.inverse.derive_levels import Equation, entries, squares
from dhcli.kinematics.inverse.derive_points import VANISHES, Points, symbols_of_chain
from dhcli.kinematics.inverse.derive_rules import (
    Found,
    Step,
    both,
    difference,
    of_coefficients,
    ratio,
    single,
    slide,
    squared,
)
from dhcli.kinematics.inverse.derive_terms import Atom, Coefficients, Knowledge, Terms, length, name_of
from dhcli.kinematics.inverse.derive_values import poses_proved
from dhcli.kinematics.robot import Robot, check_robot
from dhcli.notation.tree import Expr, Number, Sum, Symbol, add, multiply, negate, number
from dhcli.notation.walk import unknowns

_MOST = 16
"""Equations in one unknown that are tried with each other."""


Squared: TypeAlias = tuple[Equation, list[Expr], list[Expr]]
"""The equation to show, and the entries on the left and on the right that are squared and added."""


class NoFormError(RobotError):
    """There is no textbook form by these rules."""


def derive(robot: Robot, *, start: str | int | None = None, end: str | int | None = None, task: str = "") -> Derivation:
    """The joint values of a robot in letters, as a book derives them.

    Args:
        robot: The robot.
        start: The frame the pose is seen from; the first numbered one by default.
        end: The frame it describes; the last numbered one by default.
        task: `pose` or `position`; by default the position for robots with fewer than four joints that move it.

    Raises:
        NoFormError: The rules do not find every joint, or what they find does not lead back to every pose tried.
        RobotError: No joint moves the end.
        UnknownNameError: The robot has no such frame.
    """
    check_robot(robot)
    low, high = ends(robot, start, end)
    check_moves(len(symbols_of_chain(robot, low, high).intersection(robot.variables)))
    for place_only in _tasks(robot, task):
        steps = _steps(robot, low, high, place_only=place_only)
        if steps is not None:
            found = Derivation(robot, low, high, place_only, steps)
            found = replace(found, left=left_to_check(found))
            for strangers in (False, True) if found.left else (False,):
                if proved := poses_proved(found, strangers=strangers):
                    return replace(found, proved=proved, strangers=strangers)
    raise NoFormError(f"{robot.name} has no textbook form by these rules", "ik with a pose gives numbers")


def _tasks(robot: Robot, task: str) -> Sequence[bool]:
    if task:
        return (task == "position",)
    return (True, False) if len(robot.variables) <= 3 else (False,)  # noqa: PLR2004  coordinates of a point


def _steps(robot: Robot, start: str, end: str, *, place_only: bool) -> tuple[Step, ...] | None:
    """The steps, if the rules find every joint."""
    moving = symbols_of_chain(robot, start, end)
    known = Knowledge({name for name in robot.variables if name in moving})
    is_short = len(known.unknown) < COORDINATES[place_only]
    found = entries(robot, start, end, place_only=place_only)
    squared_ones = list(squares(robot, start, end, place_only=place_only))
    points = Points(robot, start, end)
    steps: list[Step] = []
    while known.unknown:
        step = _sum(known, steps) or _next(known, found, squared_ones, points, is_short=is_short)
        if step is None or any(step.atom == one.atom for one in steps):  # nothing new is found
            return None
        steps.append(step)
        known.learn(step.atom)
    return tuple(steps)


def _sum(known: Knowledge, steps: Sequence[Step]) -> Step | None:
    """SUM: a joint from a sum that is known, and the other joints in it."""
    for step in steps:
        if isinstance(step.atom, str):
            continue
        left = [(name, factor) for name, factor in step.atom if name in known.unknown]
        if len(left) != 1 or abs(left[0][1]) != 1 or len(step.atom) == 1:
            continue
        name, factor = left[0]
        others = [(multiply(number(-f * factor), Symbol(n))) for n, f in step.atom if n != name]
        whole = Symbol(name_of(step.atom))
        total = add(whole, *others) if factor > 0 else add(*others, negate(whole))
        return Step("SUM", ((name, 1),), (), total)
    return _difference(known, [step.atom for step in steps if not isinstance(step.atom, str)])


def _difference(known: Knowledge, sums: Sequence[Terms]) -> Step | None:
    """SUM: a joint from two sums that are known, of which one has it and the other one has not."""
    for one, other in permutations(sums, 2):
        left = [term for term in one if term not in other]
        if len(left) == 1 and len(one) == len(other) + 1 and left[0][0] in known.unknown and abs(left[0][1]) == 1:
            more, less = Symbol(name_of(one)), Symbol(name_of(other))
            first, second = (more, less) if left[0][1] > 0 else (less, more)
            return Step("SUM", ((left[0][0], 1),), (), add(first, negate(second)))
    return None


def _next(
    known: Knowledge, found: Sequence[Equation], squared_ones: Sequence[Squared], points: Points, *, is_short: bool
) -> Step | None:
    """SLIDE, BOTH, RATIO, ZERO, ONE and SQUARES, in this order."""
    by_atom: dict[Atom, list[Found]] = {}
    for one in found:
        atom = known.atom(one.unknowns)
        if atom is not None and (k := difference(one, atom, known)) is not None:
            by_atom.setdefault(atom, []).append((one, k))
    for atom, own in by_atom.items():
        own.sort(key=lambda one: (sum(map(length, one[1][1:])), length(one[1][0])))
        by_atom[atom] = _different(own)
    if step := _slide(by_atom) or _both(by_atom, points):
        return step
    step = _ratio(known, found, points)
    if step is None:
        return _one(by_atom, points) or _squares(known, squared_ones, points)
    # where there are fewer joints than coordinates, lengths say as much, and do so wherever the arm stands
    return (is_short and step.is_met_often and _squares(known, squared_ones, points)) or step


def _different(own: Sequence[Found]) -> list[Found]:
    """Each equation once, whichever levels it stands in."""
    seen = set[Coefficients]()
    kept = []
    for one, (k0, k1, k2) in own:
        if (k0, k1, k2) in seen or (negate(k0), negate(k1), negate(k2)) in seen:
            continue
        seen.add((k0, k1, k2))
        kept.append((one, (k0, k1, k2)))
    return kept


def _slide(by_atom: Mapping[Atom, list[Found]]) -> Step | None:
    made = [
        step
        for atom, own in by_atom.items()
        if isinstance(atom, str)
        for one in own
        if (step := slide(one[0], atom, one[1]))
    ]
    return min(made, key=lambda step: (step.condition is not None, length(step.value)), default=None)


def _both(by_atom: Mapping[Atom, list[Found]], points: Points) -> Step | None:
    best: tuple[tuple[bool, int, int, bool], Step] | None = None
    for atom, own in by_atom.items():
        if isinstance(atom, str):
            continue
        for first, second in combinations(own[:_MOST], 2):
            # no pair is shorter than its constants
            if best is not None and not best[0][0] and length(first[1][0]) + length(second[1][0]) > best[0][1]:
                continue
            det = _determinant(first[1], second[1])
            if best is not None and not best[0][0] and type(det) is not Number:
                continue  # where there are equations that never vanish, no others are wanted
            sign = _sign(det, points)
            for step in (both(first, second, atom, sign), both(second, first, atom, -sign)):
                if step is None:
                    continue
                apart = first[0].level != second[0].level
                key = (step.condition is not None, length(step.value), len(str(step.value)), apart)
                if best is None or key < best[0]:
                    best = key, step
    return None if best is None else best[1]


def _determinant(one: Coefficients, other: Coefficients) -> Expr:
    return add(multiply(one[1], other[2]), negate(multiply(one[2], other[1])))


def _sign(det: Expr, points: Points) -> int:
    """The sign of a determinant where it is always the same, else 0."""
    if type(det) is Number:
        return (det.value > 0) - (det.value < 0)
    dets = points.values(det)
    size = max(map(abs, dets), default=0.0)
    signs = {1 if value > 0 else -1 for value in dets}
    if size < VANISHES or len(signs) != 1 or min(map(abs, dets)) < VANISHES * size:
        return 0
    return signs.pop()


def _ratio(known: Knowledge, found: Sequence[Equation], points: Points) -> Step | None:
    singles = [(one, parts) for one in found if (parts := single(one, known))]
    made = [step for first, second in permutations(singles, 2) if (step := ratio(first, second))]
    # a sine is 0 in ordinary poses, such as those of a hand that hangs down; a sum of lengths is not, nor is one alone
    made.sort(key=lambda step: (step.is_met_often, type(step.condition) is not Sum))
    living = filter(points.lives, made)
    best = next(living, None)
    if best is None:
        return None
    return replace(best, instead=next((step for step in living if points.serves(step, best)), None))


def _one(by_atom: Mapping[Atom, list[Found]], points: Points) -> Step | None:
    made = []
    for atom, own in by_atom.items():
        if isinstance(atom, str):
            continue
        for one in own[:_MOST]:
            step = of_coefficients(one[1], atom, one[:1])
            if step is not None and points.lives(step):
                made.append(step)
    return min(made, key=lambda step: (step.rule != "ZERO", length(step.spread or step.value)), default=None)


def _squares(known: Knowledge, found: Sequence[Squared], points: Points) -> Step | None:
    made = []
    for level, left, right in found:
        atom = known.atom(unknowns(*right))
        if atom is None or not all(map(known.is_known, left)):
            continue
        step = squared(level, left, right, atom, known)
        if step is not None and points.lives(step):
            made.append(step)
    return min(made, key=lambda step: length(step.spread or step.value), default=None)
