"""Angles that no residue stands for, such as 1.1 rad: they get names while the rules work, and are put back in the end.

What holds for every angle holds for this one, so that nothing proved is lost; what holds for it alone is not seen.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from dhcli.kinematics.moves import Chain, Move, Rot
from dhcli.kinematics.singular.angles import angle_words
from dhcli.kinematics.singular.result import Factor, Singularities
from dhcli.notation.angle import Angle
from dhcli.notation.styles import Joints
from dhcli.notation.tree import Expr
from dhcli.notation.walk import substitute

HALF_DEGREES = 2
"""Residues hold multiples of half a degree."""


def with_names(chain: Chain) -> tuple[Chain, Mapping[str, Angle]]:
    """A chain with names in the place of angles that no residue stands for, and what they are."""
    known: dict[Angle, str] = {}
    moves: list[Move] = []
    for move in chain:
        constant = Angle(degrees=move.angle.degrees, radians=move.angle.radians) if isinstance(move, Rot) else Angle()
        if isinstance(move, Rot) and (constant.radians or (constant.degrees * HALF_DEGREES).denominator != 1):
            sign = -1 if constant.constant() < 0 else 1
            name = known.setdefault(constant * sign, f"κ{len(known) + 1}")
            moves.append(Rot(move.axis, Angle(move.angle.terms) + Angle.of(name) * sign))
        else:
            moves.append(move)
    return tuple(moves), {name: angle for angle, name in known.items()}


def put_back(found: Singularities, constants: Mapping[str, Angle]) -> Singularities:
    """Singularities with the angles themselves in the place of their names."""
    if not constants:
        return found

    def back(expr: Expr) -> Expr:
        return substitute(expr, {}, constants)

    determinant = None if found.determinant is None else back(found.determinant)
    factors = tuple(_factor(factor, tuple(map(back, factor.zeros)), found.writing) for factor in found.factors)
    return replace(found, determinant=determinant, factors=factors)


def _factor(factor: Factor, zeros: tuple[Expr, ...], joints: Joints) -> Factor:
    return replace(factor, zeros=zeros, angles=angle_words(zeros, joints))
