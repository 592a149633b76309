"""The solutions of one pose, those joints to spare held or sampled, and a search where the plan finds none."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from dhcli.errors import plural
from dhcli.kinematics.inverse.prepared import Prepared
from dhcli.kinematics.inverse.question import Question, stands
from dhcli.kinematics.inverse.solutions import shown_value
from dhcli.kinematics.inverse.solving import Solved, solve
from dhcli.kinematics.inverse.turns import limits_of

if TYPE_CHECKING:
    from dhcli.kinematics.inverse.arm import Array

Near: TypeAlias = "tuple[Array, float, float]"
"""Motions that come nearest to a pose, shape (n,), and what is left: a distance [m] and an angle [rad]."""

SEARCHED = 48
"""Values of a joint held that are tried where none was asked for and the first does not do."""

REACHED = 1e-6
"""A pose nearer than this to the one asked for [reaches, rad] is reached, if the joints held stand as they do there."""

SPREAD = (1.0, 0.6180339887498949, 0.7548776662466927, 0.8191725133961645, 0.5698402909980532, 0.6710436067037893)
"""Steps, in turns, by which values of several joints are spread."""


def find(
    question: Question,
    goal: Array,
    held: dict[int, float],
    family: int | None,
    tolerance: float,
    nearest: Callable[[], Near],
) -> tuple[Solved, list[str]]:
    """The solutions, and what has to be said about joints that are held without having been asked for.

    Args:
        question: What is asked.
        goal: What the product of the joint motions has to be, shape (4, 4).
        held: Motions of the joints that are to be held.
        family: Into how many values of a joint to spare solutions are sampled.
        tolerance: Residual up to which joint values are a solution.
        nearest: Finds the pose that is nearest, where nothing else is found.
    """
    ready = question.ready
    chosen = [j for j in ready.plan.held if j not in held]
    best = question.best(chosen)
    if not chosen:
        fixed = {j: np.array([value]) for j, value in held.items()}
        solved = solve(ready, goal, best, fixed, tolerance)
        return solved if len(solved.motions) else _searched(question, goal, nearest(), tolerance), []
    count = family or 1
    solved = solve(ready, goal, best, sampled(question, held, chosen, best, count), tolerance)
    if not len(solved.motions) and family is None:
        solved = solve(ready, goal, best, sampled(question, held, chosen, best, SEARCHED), tolerance)
        if len(solved.motions):
            distance = np.abs(solved.motions[:, chosen] - best[chosen]).sum(axis=1)
            solved = solved.taken(solved.index == solved.index[int(np.argmin(distance))])
    if not len(solved.motions) and family is None:
        motions, apart, angle = nearest()
        if max(apart / ready.arm.reach, angle) < REACHED:
            solved = solve(ready, goal, motions, sampled(question, held, chosen, motions, 1), tolerance)
            solved = solved if len(solved.motions) else solve(ready, goal, motions, None, tolerance, motions)
    more = f"{question.robot.name} has {plural(ready.spare, 'joint')} more than this needs"
    return solved, [f"{more}: {held_words(question, chosen, solved, family)}"]


def _searched(question: Question, goal: Array, nearest: Near, tolerance: float) -> Solved:
    """What a search for the nearest pose finds where that is the pose itself, as where too much of it is singular."""
    motions, apart, angle = nearest
    begun = motions if max(apart / question.ready.arm.reach, angle) < REACHED else np.full_like(motions, np.nan)
    return solve(question.ready, goal, question.best(), None, tolerance, begun)


def nearest_to(ready: Prepared, goal: Array, held: dict[int, float]) -> Near:
    """Motions that come nearest to a pose, and what is left of it."""
    from dhcli.kinematics.inverse.reasons import nearest_reachable  # not for the poses that are reached

    return nearest_reachable(ready, goal, held)


def held_words(question: Question, chosen: list[int], solved: Solved, family: int | None = None) -> str:
    """Which joints were held, and where if it is the same for all solutions; of a family, how many values do."""
    order = question.order
    names = ", ".join(question.robot.variables[order[j]] for j in sorted(chosen))
    if family:
        reached = len(np.unique(solved.index))
        return f"{names} sampled at {plural(family, 'value')}, {reached or 'none'} of them with solutions"
    if not len(solved.motions):
        return f"{names} held"
    q = question.values(solved.motions)[0]
    shown = [shown_value(question.robot, order[j], float(q[order[j]])) for j in sorted(chosen)]
    there = stands(dict(zip(question.robot.variables, q.tolist(), strict=True)), names.split(", "), question.standing)
    return f"held {', '.join(shown)}{there}"


def sampled(question: Question, held: dict[int, float], chosen: list[int], best: Array, count: int) -> dict[int, Array]:
    """Values of the joints held, as many for each that was chosen as asked for."""
    ready = question.ready
    limits = limits_of(question.robot)[list(question.order)] * ready.arm.factors[:, None]
    if count == 1:
        return {**{j: np.array([value]) for j, value in held.items()}, **{j: best[j : j + 1] for j in chosen}}
    # one joint in equal steps; several so that any few of the values are spread evenly
    steps = np.linspace(0, 1, count)
    result = {j: np.full(count, value) for j, value in held.items()}
    for k, j in enumerate(chosen):
        low, high = sorted(limits[j])
        if not (math.isfinite(low) and math.isfinite(high)):
            half = np.pi if ready.arm.turning[j] else 1.0
            low, high = best[j] - half, best[j] + half
        result[j] = low + (high - low) * (steps if not k else np.arange(count) * SPREAD[k % len(SPREAD)] % 1)
    return result
