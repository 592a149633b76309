"""Joints to spare held where all joints are inside their limits."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from dhcli.errors import joined, plural
from dhcli.kinematics.inverse.question import Question
from dhcli.kinematics.inverse.searching import SEARCHED, held_words, sampled
from dhcli.kinematics.inverse.solving import Solved, solve
from dhcli.kinematics.inverse.turns import are_inside, in_turn

if TYPE_CHECKING:
    from dhcli.kinematics.inverse.arm import Array

FINELY = 10 * SEARCHED
"""Values of the joints held that are tried where the first do not do."""


def held_inside(question: Question, goal: Array, held: dict[int, float], tolerance: float) -> tuple[Solved, list[str]]:
    """The solutions with joints to spare as near as can be to where they should stand, and what has to be said of it.

    Args:
        question: What is asked, of an arm with joints to spare.
        goal: What the product of the joint motions has to be, shape (4, 4).
        held: Motions of the joints that are to be held.
        tolerance: Residual up to which joint values are a solution.

    Returns:
        All solutions with these values held, some of them inside all limits; none where no values tried have one.
    """
    ready, robot = question.ready, question.robot
    chosen = [j for j in ready.plan.held if j not in held]
    best = question.best(chosen)
    for count in (SEARCHED, FINELY):
        solved = solve(ready, goal, best, sampled(question, held, chosen, best, count), tolerance)
        q = in_turn(robot, question.values(solved.motions), question.near)
        inside = np.flatnonzero(are_inside(robot, q))
        if len(inside):
            away = np.abs(solved.motions[inside][:, chosen] - best[chosen]).sum(axis=1)
            own = solved.taken(solved.index == solved.index[inside[int(np.argmin(away))]])
            more = f"{robot.name} has {plural(ready.spare, 'joint')} more than this needs"
            return own, [f"{more}: {held_words(question, chosen, own)}, with which all joints are inside their limits"]
    nothing = solved.taken(np.zeros(len(solved.motions), dtype=bool))
    names = joined([robot.variables[question.order[j]] for j in sorted(chosen)])
    tried = plural(FINELY, "value" if len(chosen) == 1 else "choice")
    return nothing, [f"none of {tried} of {names} has a solution inside all limits"]
