"""The true mobility of a linkage in its given position, step by step.

1 twists and scale, 2 λ of the loops, 3 rank, 4 certificates, 5 idle freedoms, 6 second order, 7 imposed amplitude,
8 rank at the landings, 9 bounds where it stays undecided, 10 motion of the output link.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from dhcli.geometry.rank import TIGHT, Rank, orthonormal, spaces
from dhcli.geometry.twists import Array
from dhcli.mobility.branches import LANDED, branch_at
from dhcli.mobility.decision import Decision, Landed, Setting, Truth, certain, decided
from dhcli.mobility.draws import Draws
from dhcli.mobility.idle import Idle, idle_freedoms, still_idle
from dhcli.mobility.landing import SHAKY, Path, Trial, attempt
from dhcli.mobility.large import large_mobility
from dhcli.mobility.linkage import Linkage
from dhcli.mobility.loops import lambdas
from dhcli.mobility.model import Model, model_of
from dhcli.mobility.outputs import motion_nearby, motion_type, twists_nearby
from dhcli.mobility.second_order import (
    CLEAR,
    DRAWN,
    DRAWN_NEGATIVE,
    MOST_DIRECTIONS,
    MOST_FORMS,
    ROUNDING,
    common_zero,
    cover,
    possible,
    proves_rigid,
    quadratic_forms,
)

DIRECTIONS = 4
STARTS = 48
"""Directions from which those that go on in second order are looked for."""

ABOVE_SECOND = 2.5
"""Along a direction that passes the second order test a gap grows like A³ at least; like A², no way was found."""

ENOUGH = 2
"""Landings on which the full instantaneous mobility was found."""

SAME = 0.9999
"""Cosine of two directions that are one."""

MANY = 200
"""With more links the constraint form is used."""

WIDE = 1000
"""So it is with more equations or motions than this: ten thousand bars may lie between two links."""

MOST_MOTIONS = 700
"""With more motions an amplitude is not imposed: the answer would take minutes."""


def true_mobility(linkage: Linkage, tolerance: float = 0.0) -> Truth:
    """Find the mobility of a linkage whose geometry is known.

    Args:
        linkage: The linkage.
        tolerance: Relative error of rounded input; 0 for exact input.

    Raises:
        LinkageError: The geometry makes no sense.
    """
    model = model_of(linkage)
    if len(linkage.links) > MANY or max(model.equations, model.motions) > WIDE:
        return large_mobility(model, tolerance)
    tight = max(TIGHT, tolerance)
    there = spaces(model.jacobian(), tight)
    found, idle = lambdas(model, tight), idle_freedoms(model, tight)
    verdict = _verdict(model, there, idle, sum(found) + len(model.ties), tolerance)
    lasting, kept = sum(one.lasting for one in idle), idle
    for twists in verdict.landings if len(idle) > lasting else ():
        kept = still_idle(model, kept, twists, max(LANDED, tolerance))
    rank, instantaneous = there[0], model.motions - there[0].rank
    low = verdict.mobility if verdict.mobility is not None else max(verdict.least, lasting)
    high = verdict.mobility if verdict.mobility is not None else instantaneous
    return Truth(
        model,
        rank,
        instantaneous,
        found,
        verdict.mobility,
        (low, high),
        verdict.certificate,
        kept,
        tuple(one for one in idle if one not in kept),
        verdict.branches,
        verdict.order,
        verdict.motion,
        verdict.kinds,
    )


def _verdict(
    model: Model, there: tuple[Rank, Array, Array], idle: Sequence[Idle], equations: int, tolerance: float
) -> Decision:
    """What the rank decides, and else what is found beyond it.

    Args:
        model: The linkage.
        there: The rank of its Jacobian, the motions that it allows, and the stresses.
        idle: Its idle freedoms.
        equations: How many there would be if all were independent.
        tolerance: Relative error of rounded input.
    """
    rank, motions, stresses = there
    instantaneous = model.motions - rank.rank
    lasting = [one.rates for one in idle if one.lasting]
    if certificate := certain(model, rank, equations, instantaneous):
        twists = twists_nearby(model, motions, tolerance) if len(idle) > len(lasting) else None
        # an open chain has no equations that rounding could hide
        motion = motion_nearby(model, motions, tolerance if equations else 0.0)
        return Decision(instantaneous, certificate, motion, landings=() if twists is None else (twists,))
    if instantaneous == len(idle):
        words = "exact: apart from the idle freedoms nothing can move, not even for an instant"
        return Decision(instantaneous, words, motion_type(model, motions, tolerance=tolerance))
    frozen = orthonormal(np.array(lasting).T).T if lasting else np.zeros((0, model.motions))
    return _beyond_rank(model, stresses, frozen, equations, tolerance)


def _beyond_rank(model: Model, stresses: Array, frozen: Array, equations: int, tolerance: float) -> Decision:
    """Where the rank alone says nothing: second order, then imposed amplitudes."""
    _, free, _ = spaces(np.concatenate([model.jacobian(), frozen]), max(TIGHT, tolerance))
    forms, flat = np.zeros((0, free.shape[1], free.shape[1])), max(CLEAR, DRAWN * tolerance)
    if free.shape[1] <= MOST_FORMS:
        forms = quadratic_forms(model, free, stresses)
        left = possible(forms, flat, max(ROUNDING, DRAWN_NEGATIVE * tolerance))
        free, forms = free @ left, left.T @ forms @ left
        if not free.shape[1] or (not tolerance and (proves_rigid(forms) or not len(cover(forms)))):
            sure = "exact" if not tolerance else "numerical"
            words = f"{sure}: the second order test: what can begin to move is stopped at once"
            return Decision(len(frozen), words, motion_type(model, frozen.T), order=2)
    vanish = len(forms) > 0 and float(np.abs(forms).max()) <= max(CLEAR, DRAWN_NEGATIVE * tolerance)
    if tolerance:
        forms = forms[:0]  # where they vanish together is not to be seen in a drawing
    if model.motions > MOST_MOTIONS:
        return Decision(None, f"undecided: more than {MOST_MOTIONS} motions, too many to try how far they go")
    directions, go_on = _directions(free, forms)
    setting = Setting(model, frozen, free.shape[1], tolerance, ABOVE_SECOND if go_on or vanish else SHAKY)
    return decided(*_try_out(setting, directions, equations), setting)


def _try_out(setting: Setting, directions: list[Array], equations: int) -> tuple[list[Trial], list[Landed]]:
    """Impose amplitudes along some directions, and look at every landing."""
    trials: list[Trial] = []
    landed: list[Landed] = []
    for direction in directions:
        path = Path(setting.model, direction, setting.frozen)
        trial = attempt(path, setting.tolerance, setting.least)
        trials.append(trial)
        if trial.q is not None:
            branch = branch_at(setting.model, trial.q, setting.frozen, equations, setting.tolerance)
            landed.append(Landed(path, branch))
        if sum(one.branch.dimension == setting.most for one in landed) >= ENOUGH:
            break
    return trials, landed


def _directions(free: Array, forms: Array) -> tuple[list[Array], bool]:
    """Unit vectors among the instantaneous motions, both ways along each; whether they pass the second order test."""
    k = free.shape[1]
    draw = Draws(7)
    random = np.linalg.qr(draw.normal(k, k))[0] if k < DIRECTIONS else _units(draw.normal(DIRECTIONS, k))
    if not forms.size or float(np.abs(forms).max()) < CLEAR:
        return [sign * free @ way for way in random[: DIRECTIONS if k > 1 else 1] for sign in (1.0, -1.0)], bool(
            len(forms)
        )
    starts = draw.shuffled(cover(forms))[:STARTS] if k <= MOST_DIRECTIONS else _units(draw.normal(STARTS, k))
    found: list[Array] = []
    for start in starts:
        zero = common_zero(forms, start)
        if zero is not None and not any(abs(float(zero @ other)) > SAME for other in found):
            found.append(zero)
        if len(found) == DIRECTIONS:
            break
    return [sign * free @ way for way in found or random for sign in (1.0, -1.0)], bool(found)


def _units(rows: Array) -> Array:
    return np.asarray(rows / np.linalg.norm(rows, axis=1, keepdims=True))
