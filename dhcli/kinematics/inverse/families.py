"""Solutions that are not alone: where the arm can move without moving its end, and what then stays the same."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from dhcli.frozen import frozen
from dhcli.kinematics.inverse.arm import nearest_turn
from dhcli.kinematics.inverse.matrices import eliminate
from dhcli.kinematics.inverse.polishing import SINGULAR, jacobian, polished, product, residuals

if TYPE_CHECKING:
    from dhcli.kinematics.inverse.arm import Arm, Array, Flags, Ints
    from dhcli.kinematics.inverse.tasks import Task

_TRY = 0.05
"""How far the arm is moved to see whether its end stays [rad, reaches]."""

_STAYS = 1e-12
_NEARLY = 2e-11
"""An arm this near to a singular pose moves as if it were there; the members of its family are polished."""

_BESIDE = 1e-5
"""How far rounding may put a solution beside the family that it belongs to [rad, reaches]."""

_STRIDE = 0.25
_WHOLE = 1e-6


Pattern: TypeAlias = tuple[int, ...]
"""The joints that move in one way."""


@frozen
class Freedom:
    """One way to move without moving the end.

    Attributes:
        parameter: The joint that may be chosen, by its number.
        joints: All joints that move, by their numbers.
        rates: How each of the joints of the arm moves with the parameter here, shape (n,).
        straight: Whether these rates are the same all the way.
    """

    parameter: int
    joints: tuple[int, ...]
    rates: tuple[float, ...]
    straight: bool


def standing_still(arm: Arm, task: Task, motions: Array, held: tuple[int, ...] = ()) -> list[Array]:
    """The rates at which joints may begin to move so that the end stands still, at some solutions.

    Args:
        arm: The arm.
        task: What of the end has to stay.
        motions: Motions of the joints, shape (N, n).
        held: Joints that do not move.

    Returns:
        For each solution a basis, shape (k, n), in echelon form; whether the arm can go on so, `freedoms` finds out.
    """
    others = [j for j in range(arm.joints) if j not in held]
    if not others or not len(motions):
        return [np.empty((0, arm.joints))] * len(motions)
    _, slope = jacobian(arm, task, motions)
    _, sizes, rows = np.linalg.svd(slope[:, :, others])
    ranks = np.count_nonzero(sizes > SINGULAR, axis=1)
    bases = np.zeros((len(motions), len(others), arm.joints))
    for k, rank in enumerate(ranks.tolist()):
        bases[k, rank:, others] = _reduced_from_left(rows[k, rank:]).T
    bases[np.abs(bases) <= _WHOLE] = 0.0
    whole = np.round(bases)
    bases = np.where(np.abs(bases - whole) < _WHOLE, whole, bases)
    return [basis[rank:] for basis, rank in zip(bases, ranks.tolist(), strict=True)]


def freedoms(
    arm: Arm, task: Task, motions: Array, held: tuple[int, ...] = (), basis: Array | None = None
) -> tuple[Freedom, ...]:
    """The ways to move without moving the end, at one solution, shape (n,), some joints held.

    Args:
        arm: The arm.
        task: What of the end has to stay.
        motions: The solution, shape (n,).
        held: Joints that do not move.
        basis: What `standing_still` finds of it, where that is known.
    """
    basis = standing_still(arm, task, motions[None], held)[0] if basis is None else basis
    if not len(basis):
        return ()
    total = product(arm, motions[None])
    found = []
    for rates in basis:
        parameter = int(np.flatnonzero(rates)[0])
        if straight := _is_straight(arm, task, motions, rates, total):
            joints = tuple(int(j) for j in np.flatnonzero(rates))
        elif (moved := _walked(arm, task, motions, total, parameter, held)) is None:
            continue
        else:
            joints = tuple(int(j) for j in np.flatnonzero(np.abs(moved - motions) > _WHOLE * _TRY))
        found.append(Freedom(parameter, joints, tuple(rates.tolist()), straight))
    return tuple(found)


def _reduced_from_left(rows: Array) -> Array:
    """A basis in echelon form whose leading entries are those of the first joints."""
    rows = rows.copy()
    done = 0
    for column in range(rows.shape[1]):
        if done == len(rows):
            break
        k = done + int(np.argmax(np.abs(rows[done:, column])))
        if abs(rows[k, column]) < 1e-4:  # noqa: PLR2004  of unit vectors
            continue
        eliminate(rows, done, k, column)
        done += 1
    return rows


def _is_straight(arm: Arm, task: Task, motions: Array, rates: Array, total: Array) -> bool:
    """Whether the end stays while all joints move at constant rates, as far as half a turn."""
    ways = motions + np.array([[0.3], [1.1], [-2.0]]) * rates
    return bool(residuals(task, arm.home, product(arm, ways), np.repeat(total, 3, axis=0)).max() < _NEARLY)


def _walked(arm: Arm, task: Task, motions: Array, goal: Array, parameter: int, held: tuple[int, ...]) -> Array | None:
    """A solution with the parameter a little further on, or a little back; None where there is none."""
    for step in (_TRY, -_TRY):
        start = motions.copy()
        start[parameter] += step
        led, left = polished(arm, task, start[None], goal, (parameter, *held))
        if left[0] < _STAYS and np.abs(led[0] - motions).max() < 20 * _TRY:
            return np.asarray(led[0])
    return None


def one_of_each(
    arm: Arm, task: Task, motions: Array, path: Ints, rates: Sequence[Array], held: tuple[int, ...] = ()
) -> dict[int, tuple[Freedom, ...]]:
    """Of solutions of one pose the first member of each family, and those that are alone.

    Where families cross, the arm may begin to move in the ways of each of them, and every one is shown by another.

    Args:
        arm: The arm.
        task: What of the end has to stay.
        motions: Solutions, shape (N, n).
        path: The choices among roots that led to them; joints that do not move at constant rates tell no families
            apart that came about by different ones.
        rates: What `standing_still` finds of each.
        held: Joints that do not move.

    Returns:
        By their numbers those that are left, each with the ways in which the arm can move there.
    """
    covered = [set[Pattern]() for _ in rates]
    first: dict[int, tuple[Freedom, ...]] = {}
    alone, beside = list[int](), set[int]()
    for k in sorted(range(len(motions)), key=lambda k: len(rates[k])):
        if len(rates[k]) and _are_shown(_moving(rates[k]), covered[k]):
            continue
        ways = freedoms(arm, task, motions[k], held, rates[k])
        own = _moving(way.rates for way in ways)
        if not ways:
            alone.append(k)
        elif not _are_shown(own, covered[k]):
            first[k] = ways
            near = np.flatnonzero(_alike(arm, motions, motions[k], ways)).tolist()
            if not all(way.straight for way in ways):
                near = [i for i in near if path[i] == path[k] or len(rates[i]) > len(rates[k])]
            beside.update(near)
            for other in near:
                covered[other] |= own
    # one that is beside a family by rounding alone cannot move at all
    return first | {k: () for k in alone if k not in beside}


def _are_shown(ways: set[Pattern], others: set[Pattern]) -> bool:
    """Whether ways are among others; of several, which are mixtures, whether there are as many with the same joints."""
    same = {j for way in ways for j in way} <= {j for way in others for j in way}
    return ways <= others or (same and 1 < len(ways) <= len(others))


def _moving(rates: Iterable[Sequence[float] | Array]) -> set[Pattern]:
    """Which joints move in each of some ways."""
    return {tuple(np.flatnonzero(way).tolist()) for way in rates}


def _alike(arm: Arm, motions: Array, member: Array, ways: tuple[Freedom, ...]) -> Flags:
    """Which solutions, shape (N, n), may be members of the families of another one, shape (n,).

    All joints that do not move in them stand as there, and those that move at constant rates where these lead.
    """
    gap = motions - member
    for way in ways:
        gap = gap - gap[:, way.parameter, None] * np.array(way.rates) if way.straight else gap
    curved = {j for way in ways if not way.straight for j in way.joints}
    still = [j for j in range(arm.joints) if j not in curved]
    return np.asarray(np.abs(nearest_turn(arm.turning, gap)[:, still]).max(axis=1, initial=0.0) < _BESIDE)


def moved_to(  # noqa: PLR0913, PLR0917  where from, where to, and what has to stay
    arm: Arm, task: Task, motions: Array, goal: Array, freedom: Freedom, value: float, held: tuple[int, ...]
) -> Array | None:
    """The member of a family with a certain value of its parameter.

    Args:
        arm: The arm.
        task: What of the end has to stay.
        motions: A member, shape (n,).
        goal: What the product of the joint motions has to be, shape (4, 4).
        freedom: The family.
        value: Motion of the parameter.
        held: Joints that do not move.

    Returns:
        The member, or None if the family has none there, or cannot be followed that far.
    """
    now = motions.copy()
    way = value - now[freedom.parameter]
    if freedom.straight:
        now += way * np.array(freedom.rates)
        led, left = polished(arm, task, now[None], goal[None], (freedom.parameter, *held))
        return np.asarray(led[0]) if left[0] <= _STAYS else None
    steps = int(np.ceil(abs(way) / _STRIDE))
    for k in range(1, steps + 1):
        now[freedom.parameter] = motions[freedom.parameter] + way * k / steps
        led, left = polished(arm, task, now[None], goal[None], (freedom.parameter, *held))
        if left[0] > _STAYS:
            return None
        now = led[0]
    return now
