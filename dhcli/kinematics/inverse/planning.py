"""How a plan is found: which joint can be read off, tried at random poses of the arm."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from dhcli.kinematics.inverse.arm import Arm
from dhcli.kinematics.inverse.idealised import idealised
from dhcli.kinematics.inverse.matrices import PARALLEL, Actions
from dhcli.kinematics.inverse.motions import CIRCLE, POINT
from dhcli.kinematics.inverse.pairings import Cut, Loop, cuts
from dhcli.kinematics.inverse.planning_all import find_all, other_three
from dhcli.kinematics.inverse.planning_two import find_two, other_two
from dhcli.kinematics.inverse.rows import ROUNDED
from dhcli.kinematics.inverse.samples import SAMPLES, Samples
from dhcli.kinematics.inverse.steps import All, Equation, Kind, One, Plan, Step, Two, found_by

if TYPE_CHECKING:
    from dhcli.kinematics.inverse.arm import Array

_VANISHES = 10 * PARALLEL
"""Coefficients below this at every sample are zero."""

_WELL = 0.05
"""Sine between two equations from which more are not looked for."""

_TIE = 1e-6
"""Part of a size within which two are one."""

_RANK = {"both": 0, "length": 0, "opposite": 1, "pair": 2, "lengths": 3}
"""The order in which ways to find a joint are preferred."""


class NoPlanError(Exception):
    """No rule finds the joints that are left."""


def find_plan(arm: Arm, held: Sequence[int] = ()) -> Plan:
    """The plan for an arm of which the values of some joints will be given.

    Raises:
        NoPlanError: No rule finds some joints, because they are more than the task determines.
    """
    plan = _found(arm, held)
    return replace(plan, meant=_meant(plan)) if _has_all(plan) or plan.slack > ROUNDED else plan


def _has_all(plan: Plan) -> bool:
    return any(isinstance(step, All) for step in plan.steps)


def _meant(plan: Plan) -> Plan | None:
    """The plan of the arm that this one was meant to be, where its joints are not taken three at once."""
    ideal = idealised(plan.actions.arm)
    if ideal is None:
        return None
    try:
        meant = _found(ideal, plan.held)
    except NoPlanError:
        return None
    return None if _has_all(meant) else meant


def _found(arm: Arm, held: Sequence[int]) -> Plan:
    return completed(Plan(Actions(arm), tuple(held), ()))


def completed(begun: Plan) -> Plan:
    """A plan with the steps that are still to be found.

    Raises:
        NoPlanError: No rule finds some joints.
    """
    samples, arm = Samples(begun.actions), begun.actions.arm
    known, steps, slack = begun.known, list(begun.steps), begun.slack
    is_first = True
    while missing := [j for j in range(arm.joints) if j not in known]:
        unknown = [j for j in range(len(arm.axes)) if j not in known]
        loop = samples.loop(known)
        step: Step | None = find_one(samples, loop, unknown, missing)
        step = step or find_two(samples, loop, unknown, missing) or find_all(samples, loop, unknown)
        if step is None and is_first and len(steps) > len(begun.steps):
            # a joint that was read off alone may leave five that no three follow from; with it they are six
            known, steps, slack, is_first = begun.known, list(begun.steps), begun.slack, False
            unknown = [j for j in range(len(arm.axes)) if j not in known]
            step = find_all(samples, samples.loop(known), unknown)
        if step is None:
            raise NoPlanError(", ".join(arm.axes[j].name for j in missing))
        steps.append(step)
        if isinstance(step, One):
            slack = max(slack, samples.gap(loop, step))
        known += found_by(step)
    return replace(begun, steps=tuple(steps), slack=slack)


def otherwise(begun: Plan, step: Two | All) -> Iterator[Plan]:
    """Plans that have begun, with other joints at once than those of a step, and all that follows."""
    samples, unknown = Samples(begun.actions), [j for j in range(len(begun.actions.arm.axes)) if j not in begun.known]
    loop = samples.loop(begun.known)
    twos = other_two(samples, loop, unknown, step) if isinstance(step, Two) else ()
    for other in (*twos, *other_three(samples, loop, unknown, step)):
        with suppress(NoPlanError):
            yield completed(replace(begun, steps=(*begun.steps, other)))


def find_one(samples: Samples, loop: Loop, unknown: Sequence[int], missing: Sequence[int]) -> One | None:
    """The best way to read off one joint, if any can be."""
    best: tuple[tuple[float, float], One] | None = None
    for joint in missing:
        found = _of_joint(samples, loop, unknown, joint)
        if found is not None and (best is None or found[0] < best[0]):
            best = found
            if _RANK[found[1].kind] == 0:
                break
    return None if best is None else best[1]


def _of_joint(
    samples: Samples, loop: Loop, unknown: Sequence[int], joint: int
) -> tuple[tuple[float, float], One] | None:
    """The best way to read off a certain joint, with what to compare it by."""
    used = list[Cut]()
    equations = list[tuple[Cut, int]]()
    rows = list["Array"]()
    chosen = None
    for cut in sorted(cuts(len(samples.actions.arm.axes), unknown, (joint,)), key=lambda cut: cut.kind):
        tensor = loop.tensor(cut, (joint,))
        sizes = np.abs(tensor[:, :, 1:]).max(axis=(0, 2))
        alive = np.flatnonzero(sizes > _VANISHES)
        if not len(alive):
            continue
        used.append(cut)
        if chosen is not None and chosen[0] >= _WELL and chosen[1] in {"both", "length"}:
            continue
        equations += [(cut, int(k)) for k in alive]
        rows += [tensor[:, k] for k in alive]
        chosen = _choice(np.array(rows), turns=samples.actions.arm.axes[joint].turns)
    if chosen is None:
        return None
    score, kind, picked = chosen
    made = tuple(_equation(samples.actions, *equations[k], np.array(rows[k])) for k in picked)
    return (_RANK[kind], -round(score, 6)), One(joint, kind, made, tuple(used))


def _choice(rows: Array, *, turns: bool) -> tuple[float, Kind, tuple[int, ...]] | None:
    """Which of some equations to use, from coefficients (m, N, 3): how well, how, and which."""
    if not turns:
        linear = np.abs(rows[:, :, 2]).max(axis=1) < _VANISHES
        sizes = _quarter(np.abs(rows[:, :, 1])) / np.abs(rows).max(axis=(1, 2))
        if linear.any():
            k = _best(np.where(linear, sizes, -1))
            return float(sizes[k]), "length", (k,)
        k = _best(_quarter(np.abs(rows[:, :, 2])))
        return 0.0, "lengths", (k,)
    norms = np.hypot(rows[:, :, 1], rows[:, :, 2])
    typical = np.sort(norms, axis=1)[:, SAMPLES // 2]
    steady = _quarter(norms) / np.abs(rows).max(axis=(1, 2))
    a, b = rows[:, :, 1] / typical[:, None], rows[:, :, 2] / typical[:, None]
    best: tuple[float, tuple[int, ...]] = (0.0, ())
    for i in range(len(rows)):
        dets = np.abs(a[i] * b[i + 1 :] - b[i] * a[i + 1 :])
        if not len(dets):
            break
        # beside a few samples: a determinant that often is small serves badly
        scores = _quarter(dets)
        k = _best(scores)
        if scores[k] > best[0] * (1 + _TIE):
            best = float(scores[k]), (i, i + 1 + k)
    if best[0] > _VANISHES:
        return best[0], "both", best[1]
    homogeneous = np.abs(rows[:, :, 0]).max(axis=1) < _VANISHES * typical
    if homogeneous.any():
        k = _best(np.where(homogeneous, steady, -1))
        return float(steady[k]), "opposite", (k,)
    k = _best(steady)
    return float(steady[k]), "pair", (k,)


def _best(sizes: Array) -> int:
    """The first of the largest; which of equals rounding makes the larger differs from machine to machine."""
    return int(np.argmax(sizes >= sizes.max() * (1 - _TIE)))


def _quarter(sizes: Array) -> Array:
    """What three quarters of the samples are above, shape (m,)."""
    return np.asarray(np.sort(sizes, axis=1)[:, SAMPLES // 4])


def _equation(actions: Actions, cut: Cut, number: int, rows: Array) -> Equation:
    """An equation of a cut by its number, with the things that it pairs."""
    x, y = actions.fixed(cut.kind, cut.second), actions.fixed(cut.kind, cut.first)
    i, k = divmod(number, len(x))
    size = float(np.sort(np.abs(rows[:, 1:]).max(axis=1))[SAMPLES // 2])
    return Equation(cut, tuple(x[k].tolist()), tuple(y[i].tolist()), size)


__all__ = ["CIRCLE", "POINT", "NoPlanError", "Samples", "find_one", "find_plan"]
