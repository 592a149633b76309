"""What fewer joints than a pose has coordinates leave to be checked: whether joint values lead back to it."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice

from dhcli.algebra.floats import Floats
from dhcli.algebra.points import CIRCLE, draws
from dhcli.kinematics.forward import textbook_form
from dhcli.kinematics.frames import between
from dhcli.kinematics.inverse.derivation import Derivation
from dhcli.kinematics.inverse.derive_levels import POSITION, Equation, asked_pose
from dhcli.kinematics.inverse.derive_points import Points, pose_values
from dhcli.kinematics.inverse.derive_values import joint_values
from dhcli.kinematics.moves import Chain, Rot
from dhcli.notation.angle import Angle

COORDINATES = {True: 3, False: 6}
"""How many a position has, and a pose."""

_BESIDE = (-0.2, 0.2)
"""How far a place is drawn beside one that the arm reaches [m]."""

_TRIED = 8
"""Joint values that are looked at; what is 0 at so many that are random is always."""

_NOTHING = 1e-7
"""What rounding leaves of 0 in a long formula, in lengths of about 1 and in cosines."""


def left_to_check(derivation: Derivation) -> tuple[Equation, ...]:
    """Entries of the pose that joint values have to lead back to, as asked for and as the joints make them, in letters.

    Those alone that some poses fail: at random ones, which such an arm reaches by chance only, the others hold by what
    the joint values were found from. Nothing where there are as many joints as coordinates.
    """
    robot, place_only = derivation.robot, derivation.place_only
    if len(derivation.joints) >= COORDINATES[place_only]:
        return ()
    made = textbook_form(between(robot, derivation.start, derivation.end))
    columns = (3,) if place_only else (0, 1, 2, 3)
    level = (derivation.start, derivation.end)
    every = [Equation(level, (i + 1, k + 1), asked_pose().rows[i][k], made[i][k]) for i in range(3) for k in columns]
    found = [Floats(values) for values in islice(_beside(derivation), _TRIED)]
    return tuple(one for one in every if not found or any(_fails(one, over) for over in found))


def _fails(one: Equation, over: Floats) -> bool:
    return abs(over.value(one.right) - over.value(one.left)) > _NOTHING


def _beside(derivation: Derivation) -> Iterator[dict[str, Angle | float]]:
    """Random poses that the arm does not reach but by chance, with what the formulas find for them."""
    points = Points(derivation.robot, derivation.start, derivation.end)
    turned: Chain = (Rot("z", Angle.of("yaw")), Rot("y", Angle.of("pitch")), Rot("x", Angle.of("roll")))
    ranges = {**dict.fromkeys(("yaw", "pitch", "roll"), CIRCLE), **dict.fromkeys(POSITION, _BESIDE)}
    for values, drawn in zip(points.values_of, draws(ranges, 19), strict=False):
        place = {name: float(values[name]) + drawn[name] for name in POSITION}
        lengths = {name: value for name, value in values.items() if name not in derivation.joints}
        known = {**lengths, **pose_values(turned, drawn), **place}
        for found in joint_values(derivation, known):
            yield {**known, **found}
