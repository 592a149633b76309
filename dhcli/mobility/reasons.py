"""Why the formula and the truth differ, in words that a student understands.

Tried in this order: λ too large for the loops; a part of the joint graph with too many joints;
special lengths; special directions of axes. Each is tested by computing, not guessed.
"""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np

from dhcli.errors import plural
from dhcli.geometry.rank import TIGHT, Rank, rank_of, spaces
from dhcli.mobility.copies import disturbed, generic, twisted
from dhcli.mobility.decision import Truth
from dhcli.mobility.linkage import Linkage
from dhcli.mobility.loops import shortest_lambdas
from dhcli.mobility.model import Model, model_of
from dhcli.mobility.pairs import LinkageError
from dhcli.mobility.pebbles import Groups

DISTURBANCE = 0.02
FAINT, FAINTEST = 3e-3, 1e-8
"""Relative to the largest, a singular value between these may be rounding of a drawing ..."""

APART = 30.0
"""... if the next larger one is so many times as large."""

MOST_LINKS, MOST_MOTIONS = 60, 500
"""Larger linkages are told apart without looking for the part that is over-braced."""


def reasons(linkage: Linkage, truth: Truth, formula: int, tolerance: float) -> tuple[str, ...]:
    """Sentences about what is special, the main reason first; empty where the formula simply holds."""
    found: list[str] = []
    if truth.mobility is not None and truth.mobility != formula:
        found.append(_main_reason(linkage, truth, truth.mobility, tolerance))
    if truth.mobility is not None and truth.instantaneous > truth.mobility:
        found.append(_special_position(truth, truth.mobility))
    found += [f"{one.passing}." for one in truth.passing]
    if not tolerance and (hint := _looks_rounded(truth.rank)):
        found.append(hint)
    if len(truth.branches) > 1:
        sizes = " and ".join(map(str, truth.branches))
        found.append(f"Motions of different kinds meet in this position, with {sizes} freedoms.")
    elif len(truth.kinds) > 1:
        kinds = " on one, ".join(truth.kinds)
        found.append(f"Motions of different kinds meet in this position: the output has {kinds} on another.")
    return tuple(found)


def _looks_rounded(rank: Rank) -> str:
    """About singular values that stand apart from the others, as small as rounded coordinates leave what was zero."""
    values = rank.values[: rank.rank]
    for larger, smaller in pairwise(values):
        if FAINTEST < smaller / values[0] < FAINT and larger > APART * smaller:
            decimals = math.floor(-math.log10(4 * smaller / values[0]))
            return (
                f"A singular value that counts is only {smaller / values[0]:.1e} of the largest, as rounding leaves "
                f"one that should be zero. If these coordinates are a drawing's, they look rounded: try --tol "
                f"{3 * 10.0**-decimals:g}."
            )
    return ""


def _main_reason(linkage: Linkage, truth: Truth, mobility: int, tolerance: float) -> str:
    model = truth.model
    loops = shortest_lambdas(model, max(TIGHT, tolerance))
    lambda_ = linkage.space.lambda_
    corrected = model.motions - sum(loops) - len(model.ties)
    if corrected == mobility and any(loop < lambda_ for loop in loops):
        return _too_large(loops, lambda_, model.motions, mobility, len(model.ties))
    if corrected == mobility and any(loop > lambda_ for loop in loops):
        own = ", ".join(map(str, loops))
        return f"λ = {lambda_} is too small: the motions of the loops span {own} freedoms, so the axes lie otherwise."
    if len(linkage.links) > MOST_LINKS or model.motions > MOST_MOTIONS:
        return "Some of the constraints repeat others, which the formula cannot see."
    if graph := _over_braced(linkage, mobility):
        return graph
    return _special(linkage, mobility, tolerance, loops, lambda_)


def _too_large(loops: tuple[int, ...], lambda_: int, freedoms: int, mobility: int, ties: int) -> str:
    own = f"{loops[0]}" if len(set(loops)) == 1 else ", ".join(map(str, loops))
    many = "the loop's motions span" if len(loops) == 1 else "the motions of the loops span"
    each = "" if len(loops) == 1 else " each" if len(set(loops)) == 1 else ", one after the other"
    total = " - ".join([str(freedoms), *map(str, loops), *(["1"] * ties)])
    return (
        f"λ is too large: {many} only {own}{each} of the {lambda_} freedoms that λ = {lambda_} stands for. A loop "
        f"takes away no more freedoms than its motions span; counted so, it comes out right: {total} = {mobility}."
    )


def _over_braced(linkage: Linkage, mobility: int) -> str:
    """The reason if the same joint graph with random geometry has the true mobility; empty if not."""
    try:
        model = model_of(generic(linkage, 11))
    except LinkageError:
        return ""
    jacobian = model.jacobian()
    _, motions, _ = spaces(jacobian)
    if motions.shape[1] != mobility:
        return ""
    groups = [group for group in rigid_groups(model, motions) if len(group) > 1]
    removable = _removable(linkage, groups, mobility)
    named = "; ".join(", ".join(group[:8]) + ", ..." * (len(group) > 8) for group in groups[:3])  # noqa: PLR2004  as many as a person reads
    text = "A part has more joints than it needs, whatever its lengths: "
    text += f"{named} are rigid together and over-braced" if groups else "some of its constraints repeat others"
    text += "; the formula takes the surplus from the freedoms of the rest"
    return text + (f". Without {removable[0]} it would move as it does now." if removable else ".")


def rigid_groups(model: Model, motions: np.typing.NDArray[np.float64]) -> list[tuple[str, ...]]:
    """Sets of links that do not move against each other in any of the given motions."""
    rigid = Groups()
    moving = model.link_twists(motions) if motions.shape[1] else np.zeros((len(model.linkage.links), 6, 1))
    for step in model.steps:
        if float(np.abs(moving[step.tail] - moving[step.head]).max()) < 1e-7:  # noqa: PLR2004  rounding, of unit motions
            rigid.join(step.head, step.tail)
    groups: dict[int, list[str]] = {}
    for link, name in enumerate(model.linkage.links):
        groups.setdefault(rigid.of(link), []).append(name)
    return [tuple(group) for group in groups.values()]


def _removable(linkage: Linkage, groups: list[tuple[str, ...]], mobility: int) -> list[str]:
    """Links whose removal changes nothing for the others."""
    found = []
    for link in dict.fromkeys(name for group in groups for name in group):
        joints = tuple(joint for joint in linkage.joints if link not in joint.links and joint.carrier != link)
        if link in (linkage.ground, linkage.output) or not joints:
            continue
        try:
            rest = Linkage(linkage.name, linkage.space, joints, linkage.ground)
            model = model_of(generic(rest, 12))
        except LinkageError:
            continue
        if len(rest.links) == len(linkage.links) - 1 and model.motions - rank_of(model.jacobian()).rank == mobility:
            found.append(link)
    return found


def _special(linkage: Linkage, mobility: int, tolerance: float, loops: tuple[int, ...], lambda_: int) -> str:
    """Special lengths or special directions, by disturbing them."""
    amount = max(DISTURBANCE, 3 * tolerance)
    if not all(_survives(disturbed(linkage, amount, seed), mobility) for seed in (1, 2)):
        return (
            "The lengths are special: they make some constraints repeat others, and the formula counts all of them. "
            "With its points moved by 2 % it could not move like this."
        )
    less = (
        f" Loops with their own λ: {', '.join(map(str, loops))} instead of {lambda_}."
        if min(loops, default=6) < lambda_
        else ""
    )
    if not linkage.space.is_planar and not _survives(twisted(linkage, amount, 3), mobility):
        return (
            "The directions of the axes are special: they make some constraints repeat others, and the formula counts "
            f"all of them. With its axes turned by 1° it could not move like this.{less}"
        )
    return f"Some constraints repeat others, which the formula cannot see.{less}"


def _survives(copy: Linkage, mobility: int) -> bool:
    """Whether a disturbed copy still has so many freedoms, at least for an instant."""
    model = model_of(copy)
    return model.motions - rank_of(model.jacobian(), 1e-7).rank >= mobility


def _special_position(truth: Truth, mobility: int) -> str:
    """About a position that can do more for an instant than for good."""
    more = truth.instantaneous - mobility
    if mobility == len(truth.idle):
        how = f" The gap grows like the displacement to the power {truth.order}." if truth.order else ""
        return (
            f"It is shaky: for an instant it yields in {plural(more, 'direction')}, but it cannot move on.{how} "
            "Real parts with a little play will wobble."
        )
    return (
        f"The position is singular: at this instant {truth.instantaneous} motions can begin, of which {more} cannot go "
        "on together with the others."
    )
