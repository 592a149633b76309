"""Moves by one variable that come to one motion, wherever they stand in a chain: such as those of a telescope."""

from __future__ import annotations

from collections.abc import Mapping

from dhcli.kinematics.inverse.arm import Axis, axis_of_move, parallel, same_axis
from dhcli.kinematics.moves import Chain, names
from dhcli.notation.angle import Angle


def is_joined(chain: Chain, variables: tuple[str, ...], values: Mapping[str, Angle | float]) -> bool:
    """Whether every move is made by one variable, and those by one variable are one motion."""
    together = joined(chain, variables, values)
    seen = set[str]()
    for move in chain:
        inside = names((move,)).intersection(variables)
        if len(inside) > 1 or inside & seen - together:
            return False
        seen |= inside
    return True


def joined(chain: Chain, variables: tuple[str, ...], values: Mapping[str, Angle | float]) -> frozenset[str]:
    """The variables that make several moves which are one motion, because nothing that moves between them minds.

    A slide commutes with every other slide and with a turn about its own direction; a turn with whatever goes along
    or about its own axis.

    Args:
        chain: The moves from the start frame to the end frame.
        variables: The joint variables.
        values: Value of each length [m] and constant angle.

    Raises:
        RobotError: A variable stands in a matrix.
    """
    inside = [(k, sorted(names((move,)).intersection(variables))) for k, move in enumerate(chain)]
    moving = [(k, own) for k, own in inside if own]
    places = {name: [k for k, own in moving if name in own] for name in variables}
    alone = {name for name, at in places.items() if len(at) > 1 and all([name] == own for k, own in moving if k in at)}
    if not alone:
        return frozenset()
    still = {**values, **dict.fromkeys(variables, 0.0)}
    axes = {(k, name): axis_of_move(chain, name, k, still, moving[0][0]) for k, own in moving for name in own}
    found = set()
    for name in alone:
        first, last = places[name][0], places[name][-1]
        head = axes[first, name]
        others = [axis for (k, other), axis in axes.items() if first < k < last and other != name]
        if all(same_axis(head, axes[k, name]) for k in places[name]) and all(_commute(head, axis) for axis in others):
            found.add(name)
    return frozenset(found)


def _commute(one: Axis, other: Axis) -> bool:
    """Whether two motions come to the same in either order."""
    if not (one.turns or other.turns):
        return True
    if one.turns and other.turns:
        return same_axis(one, other)
    return parallel(one, other)
