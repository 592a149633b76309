"""Slips on the way from a pose to joint values, each with the joint values that it leads to."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise, product
from typing import TypeAlias

from dhcli.checking.diagnosis.mistakes.turns import are_parallel
from dhcli.checking.diagnosis.result import Slip
from dhcli.checking.exercise import Case
from dhcli.checking.orientations import transposed
from dhcli.checking.returned import Reading
from dhcli.checking.solving.derived import derivation_of, slipped, values_at
from dhcli.checking.solving.goal import Rows, Target, solve
from dhcli.checking.solving.question import WantedJoints
from dhcli.checking.solving.reading import Vector
from dhcli.checking.solving.vectors import Range, apart
from dhcli.checking.verdicts import Verdict
from dhcli.errors import DhcliError
from dhcli.frozen import frozen
from dhcli.kinematics.conventions import OTHER
from dhcli.kinematics.robot import Robot

Joints: TypeAlias = tuple[float, ...]
SAME = 2e-3
"""Joint values that differ by less than this are typed the same [rad, m]."""

OTHER_BRANCH = Slip("other-branch", "this is a solution of another branch", "which way does the arm bend?")
OUTSIDE = Slip("out-of-limits", "a joint is outside its limits", "look at the limits of the joints")
_OF_SOLUTIONS = (OTHER_BRANCH, OUTSIDE)


@frozen
class Wrong:
    """What a slip leads to.

    Attributes:
        slip: The slip.
        rows: Every joint vector that it gives; one of them is the answer where one is asked for.
        text: The answer as it would be typed.
    """

    slip: Slip
    rows: tuple[Joints, ...]
    text: str


def showing(question: WantedJoints, case: Case) -> tuple[Wrong, ...]:
    """Every slip whose answer is wrong here, with that answer."""
    return case.memo.of(("slips", question), lambda: tuple(_showing(question, case)))


def causes_of(question: WantedJoints, case: Case, typed: Sequence[Vector]) -> tuple[Slip, ...]:
    """The slips that give what was typed, which is wrong.

    Of one vector it is seen by where it leads whether it is that of another pose: nothing is solved for that.
    """
    field = question.range_of(case)
    rows = [one.values for one in typed]
    if question.which == "all":
        wrong = [one for one in showing(question, case) if len(one.rows) == len(rows)]
        return tuple(one.slip for one in wrong if all(any(_same(field, a, b) for b in one.rows) for a in rows))
    if not field.solutions:
        return ()
    is_solution = any(_same(field, rows[0], true) for true in field.solutions)
    found = [
        slip
        for slip, others in case.memo.of(("joint slips", question), lambda: tuple(_in_work(question, case, field)))
        if (slip in _OF_SOLUTIONS or not is_solution) and any(_same(field, rows[0], other) for other in others)
    ]
    if not is_solution:
        elsewhere = ((one.slip, field.elsewhere(one.robot, one.target, one.rows)) for one in _elsewhere(field))
        found += [slip for slip, there in elsewhere if there.verdict(rows[0], case.tolerance) is Verdict.RIGHT]
    return tuple({slip.name: slip for slip in reversed(found)}.values())[::-1]


def _same(field: Range, one: Sequence[float], other: Sequence[float]) -> bool:
    return max(apart(field.robot, field.joints, one, other), default=0.0) <= SAME


def _showing(question: WantedJoints, case: Case) -> Iterator[Wrong]:
    field = question.range_of(case)
    right = field.solutions
    seen = set[str]()
    for slip, rows in _mistakes(question, case, field):
        kept = _different(field, rows)
        if not kept or slip.name in seen:
            continue
        if question.which != "all":
            if slip not in _OF_SOLUTIONS:  # what reaches the pose has another reason to be wrong
                kept = tuple(row for row in kept if not any(_same(field, row, true) for true in right))
            kept = tuple(row for row in kept if _is_wrong(question, case, (row,)))
            if not kept or not right:
                continue
            goal = right[question.wanted(case)[0]] if question.wanted(case) else right[0]
            kept = tuple(sorted(kept, key=lambda row: sum(apart(field.robot, field.joints, row, goal))))
        elif not _is_wrong(question, case, kept):
            continue
        seen.add(slip.name)
        yield Wrong(slip, kept, question.text_of(case, kept if question.which == "all" else kept[:1]))


def _is_wrong(question: WantedJoints, case: Case, rows: Sequence[Joints]) -> bool:
    if question.which != "all":  # what misses the pose is judged by that alone
        verdict = question.range_of(case).verdict(rows[0], case.tolerance)
        if verdict is not Verdict.RIGHT:
            return verdict is Verdict.WRONG
    typed = tuple(Vector(tuple(row), (False,) * len(row), shown="") for row in rows)
    return question.mark(case, Reading("", typed)).verdict is Verdict.WRONG


def _different(field: Range, rows: Sequence[Joints]) -> tuple[Joints, ...]:
    kept = list[Joints]()
    for row in rows:
        if not any(_same(field, row, other) for other in kept):
            kept.append(row)
    return tuple(kept)


def _mistakes(question: WantedJoints, case: Case, field: Range) -> Iterator[tuple[Slip, list[Joints]]]:
    """Every slip with the joint vectors it leads to, right ones among them."""
    yield from case.memo.of(("joint slips", question), lambda: tuple(_in_work(question, case, field)))
    for one in _elsewhere(field):
        yield one.slip, one.solved(case, field)


def _in_work(question: WantedJoints, case: Case, field: Range) -> Iterator[tuple[Slip, list[Joints]]]:
    """Slips on the way from the pose to the joint values."""
    yield from _of_formulas(question, case, field)
    yield from _absolute(field)
    yield from _turned_round(field)
    yield from _out_of_order(field)
    wanted = question.wanted(case)
    others = [q for k, q in enumerate(field.solutions) if k not in wanted]
    if question.which == "branch":
        yield OTHER_BRANCH, others
    elif question.within_limits:
        yield OUTSIDE, others


def _absolute(field: Range) -> Iterator[tuple[Slip, list[Joints]]]:
    """Angles that are those of the links themselves, not those to the link before."""
    robot = field.robot
    for one, two in pairwise(link.row for link in robot.links):
        if one is None or two is None or not are_parallel(one, two, robot.convention):
            continue
        for before, name in product(one.theta.names, two.theta.names):
            if before in field.joints and name in field.joints:
                i, j = field.joints.index(before), field.joints.index(name)
                words = f"{name} is counted from where {before} is, not from the link before"
                slip = Slip(f"absolute-angle {name}", words, f"from which direction is {name} counted?")
                yield slip, [(*q[:j], q[i] + q[j], *q[j + 1 :]) for q in field.solutions]


def _turned_round(field: Range) -> Iterator[tuple[Slip, list[Joints]]]:
    """One joint with the other sign, or all of them."""
    for k, name in enumerate(field.joints):
        slip = Slip(f"joint-sign {name}", f"the sign of {name} is turned round", f"which way is {name} positive?")
        yield slip, [(*q[:k], -q[k], *q[k + 1 :]) for q in field.solutions]
    slip = Slip("joint-signs", "the signs of all joints are turned round", "which way are the joints positive?")
    yield slip, [tuple(-one for one in q) for q in field.solutions]


def _out_of_order(field: Range) -> Iterator[tuple[Slip, list[Joints]]]:
    """Right values, each of two neighbours behind the other's name, or all in the reverse order."""
    hint = "in which order are the joints asked for?"
    turns = [name in field.robot.angles for name in field.joints]
    for k, (one, two) in enumerate(pairwise(field.joints)):
        if turns[k] == turns[k + 1]:
            slip = Slip(f"joints-swapped {one} {two}", f"{one} and {two} have changed places", hint)
            yield slip, [(*q[:k], q[k + 1], q[k], *q[k + 2 :]) for q in field.solutions]
    if len(turns) > 2 and turns == turns[::-1]:  # noqa: PLR2004  two that are reversed have changed places
        slip = Slip("joints-reversed", "the joints stand in the reverse order", hint)
        yield slip, [q[::-1] for q in field.solutions]


def _of_formulas(question: WantedJoints, case: Case, field: Range) -> Iterator[tuple[Slip, list[Joints]]]:
    """Slips in a formula; what is computed from a wrong joint is wrong, too."""
    derivation = derivation_of(case, question.target)
    if derivation is None:
        return
    entries = {f"r{i + 1}{j + 1}": field.rows[i][j] for i in range(3) for j in range(3)}
    entries |= {f"p{axis}": field.rows[i][3] for i, axis in enumerate("xyz")}

    def vectors(one: object) -> list[Joints]:
        found = values_at(one, field.robot, case.exercise.known, entries)  # type: ignore[arg-type]
        rows = [[q[name] for name in field.joints] for q in found if all(n in q for n in field.joints)]
        return [tuple(map(_wrapped, field.joints, row)) for row in rows]

    def _wrapped(name: str, value: float) -> float:
        return math.remainder(value, math.tau) if name in field.robot.angles else value

    true = _different(field, vectors(derivation))
    if len(true) != len(field.solutions) or not all(any(_same(field, a, b) for b in field.solutions) for a in true):
        return  # the formulas say nothing at this pose
    for one in slipped(derivation, field.robot):
        yield one.slip, vectors(one.derivation)


@frozen
class Elsewhere:
    """A slip before the first formula: another pose, or another robot.

    Attributes:
        slip: The slip.
        robot: The robot that is solved for.
        target: What is asked of it.
        rows: The pose, shape (4, 4) [m].
    """

    slip: Slip
    robot: Robot
    target: Target
    rows: Rows

    def solved(self, case: Case, field: Range) -> list[Joints]:
        """Every vector that it leads to; none where nobody can say."""
        at = [field.robot.variables.index(name) for name in field.joints]
        try:
            answer = solve(self.robot, self.target, case.exercise.known, self.rows)
        except DhcliError:
            return []
        return [tuple(float(row[k]) for k in at) for row in answer.q]


def _elsewhere(field: Range) -> Iterator[Elsewhere]:
    """The pose as its inverse, the tool left on, the table of the other convention."""
    robot, target, rows = field.robot, field.target, field.rows
    start, end = target.ends(robot)
    if target.task in {"pose", "orientation"}:
        turn = transposed([row[:3] for row in rows[:3]])
        back = tuple((*line, -sum(a * row[3] for a, row in zip(line, rows[:3], strict=True))) for line in turn)
        slip = Slip("inverse", "the pose was read the other way round, as its inverse", "seen from which frame?")
        upper = back if target.task == "pose" else tuple((*line, 0.0) for line in turn)
        yield Elsewhere(slip, robot, target, (*upper, rows[3]))
    if end == "tool" and robot.tool and target.task == "pose":
        slip = Slip("tool-kept", "the tool was not taken off: T is where the tool stands", "T_06 is T inv(tool)")
        last = [frame for frame in robot.frames if frame.isdecimal()][-1]
        yield Elsewhere(slip, robot, replace(target, frames=(start, last)), rows)
    if robot.convention in OTHER:
        try:
            other = replace(robot, convention=OTHER[robot.convention])
        except DhcliError:
            return
        words = f"the table was read in {OTHER[robot.convention].value} DH"
        slip = Slip("convention", words, "in which order do a row's four moves stand?")
        yield Elsewhere(slip, other, target, rows)
