"""The true mobility of a linkage in its given position, step by step.

1 twists and scale, 2 λ of the loops, 3 rank, 4 certificates, 5 idle freedoms, 6 second order, 7 imposed amplitude,
8 rank at the landings, 9 bounds where it stays undecided, 10 motion of the output link. Source: mobility.md.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

import numpy as np

from dhcli.geometry.rank import TIGHT, Rank, orthonormal, rank_of, spaces
from dhcli.geometry.twists import Array
from dhcli.mobility.idle import Idle, idle_freedoms
from dhcli.mobility.landing import AMPLITUDES, CLOSED, LANDED, SHAKY, Branch, Trial, attempt, branch_at, close
from dhcli.mobility.linkage import Linkage
from dhcli.mobility.loops import lambdas
from dhcli.mobility.model import Model, model_of
from dhcli.mobility.motion import residual
from dhcli.mobility.second_order import proves_rigid, quadratic_forms

DIRECTIONS = 4
ENOUGH = 2
"""Landings on which the full instantaneous mobility was found."""

MANY = 200
"""With more links the constraint form is used."""

MOST_MOTIONS = 700
"""With more motions an amplitude is not imposed: the answer would take minutes."""


@dataclass(frozen=True)
class Truth:
    """What the geometry says; see `Mobility` for the words.

    Attributes:
        model: The linkage in numbers.
        rank: The rank in the given position.
        instantaneous: Freedoms at this instant.
        lambdas: λ of each loop of the spanning tree.
        mobility: The true one; None if undecided.
        bounds: Lowest and highest possible mobility.
        certificate: How it is known.
        idle: Idle freedoms.
        branches: Dimensions of the families of motion found, with idle freedoms.
        order: Power of the amplitude with which a shaky structure resists.
        motion: Type of the output link's motion.
    """

    model: Model
    rank: Rank
    instantaneous: int
    lambdas: tuple[int, ...]
    mobility: int | None
    bounds: tuple[int, int]
    certificate: str
    idle: tuple[Idle, ...] = ()
    branches: tuple[int, ...] = ()
    order: int | None = None
    motion: str = field(default="")


@dataclass(frozen=True)
class Verdict:
    """What was decided beyond the rank.

    Attributes:
        mobility: The true one; None if undecided.
        certificate: How it is known.
        motion: Type of the output link's motion.
        least: The smallest possible mobility where it is undecided.
        branches: Dimensions of the families of motion found.
        order: Power of the amplitude with which a shaky structure resists.
    """

    mobility: int | None
    certificate: str
    motion: str = ""
    least: int = 0
    branches: tuple[int, ...] = ()
    order: int | None = None


def true_mobility(linkage: Linkage, tolerance: float = 0.0) -> Truth:
    """Find the mobility of a linkage whose geometry is known.

    Args:
        linkage: The linkage.
        tolerance: Relative error of rounded input; 0 for exact input.

    Raises:
        LinkageError: The geometry makes no sense.
    """
    model = model_of(linkage)
    if len(linkage.links) > MANY:
        from dhcli.mobility.large import large_mobility

        return large_mobility(model, tolerance)
    tight = max(TIGHT, tolerance)
    rank, motions, stresses = spaces(model.jacobian(), tight)
    found = lambdas(model, tight)
    instantaneous = model.motions - rank.rank
    equations = sum(found) + len(model.ties)
    idle = idle_freedoms(model, tight)
    verdict = Verdict(instantaneous, certain(model, rank, equations, instantaneous))
    if verdict.certificate:
        verdict = Verdict(instantaneous, verdict.certificate, _nearby(model, motions, tolerance))
    elif instantaneous == len(idle):
        words = "exact: apart from the idle freedoms nothing can move, not even for an instant"
        verdict = Verdict(instantaneous, words, motion_type(model, motions))
    else:
        frozen = orthonormal(np.array([one.rates for one in idle]).T).T if idle else np.zeros((0, model.motions))
        verdict = _beyond_rank(model, stresses, frozen, equations, tolerance)
    low = verdict.mobility if verdict.mobility is not None else max(verdict.least, len(idle))
    high = verdict.mobility if verdict.mobility is not None else instantaneous
    return Truth(
        model,
        rank,
        instantaneous,
        found,
        verdict.mobility,
        (low, high),
        verdict.certificate,
        idle,
        verdict.branches,
        verdict.order,
        verdict.motion,
    )


def _beyond_rank(model: Model, stresses: Array, frozen: Array, equations: int, tolerance: float) -> Verdict:
    """Where the rank alone says nothing: second order, then imposed amplitudes."""
    _, free, _ = spaces(np.concatenate([model.jacobian(), frozen]), max(TIGHT, tolerance))
    if not tolerance and proves_rigid(quadratic_forms(model, free, stresses)):
        words = "exact: the second order test: what can begin to move is stopped at once"
        return Verdict(len(frozen), words, motion_type(model, frozen.T), order=2)
    if model.motions > MOST_MOTIONS:
        return Verdict(None, f"undecided: more than {MOST_MOTIONS} motions, too many to try how far they go")
    trials, branches = _try_out(model, free, frozen, equations, tolerance)
    return _decided(model, trials, branches, frozen, free.shape[1])


def certain(model: Model, rank: Rank, equations: int, instantaneous: int) -> str:
    """A certificate that needs no more than the rank; empty if there is none."""
    if not model.chords and not len(model.ties):
        return "exact: there is no loop, so every joint moves freely"
    if instantaneous == 0:
        return "exact: nothing can move, not even for an instant"
    if rank.rank == equations:
        return "exact: the loop equations are independent here, so every instantaneous motion goes on"
    return ""


def _try_out(
    model: Model, free: Array, frozen: Array, equations: int, tolerance: float
) -> tuple[list[Trial], list[Branch]]:
    """Impose amplitudes along random directions, and look at every landing."""
    trials: list[Trial] = []
    branches: list[Branch] = []
    for direction in _directions(free):
        trial = attempt(model, direction, frozen, tolerance)
        trials.append(trial)
        if trial.q is not None:
            branches.append(branch_at(model, trial.q, frozen, equations, tolerance))
        if sum(branch.dimension == free.shape[1] for branch in branches) >= ENOUGH:
            break
    return trials, branches


def _directions(free: Array) -> Iterator[Array]:
    """Unit vectors among the instantaneous motions, both ways along each."""
    draw = np.random.default_rng(7)
    for _ in range(DIRECTIONS if free.shape[1] > 1 else 1):
        weights = draw.normal(size=free.shape[1])
        direction = free @ (weights / np.linalg.norm(weights))
        yield direction
        yield -direction


def _decided(model: Model, trials: list[Trial], branches: list[Branch], frozen: Array, most: int) -> Verdict:
    """The verdict over all directions tried; `most` is the instantaneous mobility without idle freedoms."""
    idle = len(frozen)
    orders = [trial.order for trial in trials if trial.order is not None and trial.moves is False]
    order = round(float(np.median(orders))) if orders else None
    landed = [trial.order for trial in trials if trial.moves]
    if landed and all(power is not None and power > SHAKY for power in landed):
        words = "undecided: within this tolerance a shaky structure cannot be told from a motion"
        return Verdict(None, words, least=idle)
    known = [(branch.dimension, branch) for branch in branches if branch.dimension is not None]
    if known:
        dimension, best = max(known, key=lambda found: found[0])
        dimensions = tuple(sorted({size + idle for size, _ in known}, reverse=True))
        motion = motion_type(model, best.motions, best.twists)
        if len(known) < len(branches) and dimension < most:
            words = "undecided: some motions were found whose number of freedoms stayed unclear"
            return Verdict(None, words, motion, dimension + idle, dimensions)
        words = (
            "numerical: the loops close to rounding at amplitudes 0.3, 0.1 and 0.03, and the rank stays the same there"
        )
        if best.exact and dimension == most:
            words = "exact: the loop equations are independent at a position that was reached"
        return Verdict(dimension + idle, words, motion, branches=dimensions, order=order)
    if orders and len(orders) == len(trials):
        words = f"numerical: the loops cannot close; the gap grows like the amplitude to the power {order}"
        return Verdict(idle, words, motion_type(model, frozen.T), order=order)
    return Verdict(None, "undecided: the loops neither close nor leave a gap with a clear trend")


def _nearby(model: Model, motions: Array, tolerance: float) -> str:
    """The output link's motion a little away from the given position, where the link may be at a dead point."""
    if not motions.shape[1] or model.linkage.output not in model.linkage.links:
        return motion_type(model, motions)
    weights = np.random.default_rng(3).normal(size=motions.shape[1])
    direction = motions @ (weights / np.linalg.norm(weights))
    q, error = close(model, AMPLITUDES[1] * direction, direction[None, :], np.array(AMPLITUDES[1:2]))
    if error > max(CLOSED, tolerance):
        return motion_type(model, motions)
    _, twists = residual(model, q)
    _, there, _ = spaces(model.jacobian(twists), max(LANDED, tolerance))
    return max(motion_type(model, motions), motion_type(model, there, twists), key=_freedoms)


def _freedoms(motion: str) -> int:
    """How many freedoms a type such as 3T1R has."""
    return int(motion[0]) + int(motion[2])


def motion_type(model: Model, motions: Array, twists: Array | None = None) -> str:
    """The output link's motion as `3T0R`: translations, and rotations beyond them; empty without an output."""
    links = model.linkage.links
    if model.linkage.output not in links:
        return ""
    if not motions.shape[1]:
        return "0T0R"
    moving = model.link_twists(motions, twists)[links.index(model.linkage.output)]
    whole = rank_of(moving, LOOSE).rank if np.abs(moving).max() > LOOSE else 0
    turning = rank_of(moving[:3], LOOSE).rank if np.abs(moving[:3]).max() > LOOSE else 0
    return f"{whole - turning}T{turning}R"


LOOSE = 1e-6
"""Relative tolerance of an output link's motion, which a landing knows to fewer digits than the given position."""
