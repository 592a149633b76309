"""How an arm stands at some joint values: its rank, and how far the nearest singular pose is."""

from __future__ import annotations

import math
from collections.abc import Mapping

from dhcli.algebra.floats import Floats
from dhcli.frozen import frozen
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.singular.distance import least_move
from dhcli.kinematics.singular.result import Singularities
from dhcli.kinematics.values import Values, numbers
from dhcli.kinematics.velocity.form import Form
from dhcli.kinematics.velocity.jacobian import numeric_jacobian
from dhcli.kinematics.velocity.measures import Measures, measures_of
from dhcli.kinematics.velocity.view import MotionView
from dhcli.notation.angle import Angle
from dhcli.notation.tree import Expr, Trig
from dhcli.notation.walk import symbols


@frozen
class Distance:
    """How far a factor is from zero.

    Attributes:
        factor: Its place among the factors found.
        values: What its expressions are at the joint values.
        distance: How far joints have to move to make it zero [rad and m together]; infinite where no move was found.
    """

    factor: int
    values: tuple[float, ...]
    distance: float


@frozen
class Standing:
    """How an arm stands.

    Attributes:
        measures: Rank, singular values, manipulability, condition.
        determinant: The determinant, if there is one.
        distances: How far each factor is from zero, the nearest first.
    """

    measures: Measures
    determinant: float | None
    distances: tuple[Distance, ...]


def standing_at(robot: Robot, values: Values, view: MotionView, found: Singularities) -> Standing:
    """How an arm stands at values of all names that its chain has.

    Raises:
        RobotError: A value is missing.
    """
    form = Form(found.part)
    rows = [form.labels.index(label) for label in found.rows]
    measures = measures_of(numeric_jacobian(robot, values, view, form).matrix, rows)
    known = numbers(values)
    distances = [Distance(k, *_distance(factor.zeros, found.joints, known)) for k, factor in enumerate(found.factors)]
    determinant = None if found.determinant is None else Floats(known).value(found.determinant)
    return Standing(measures, determinant, tuple(sorted(distances, key=lambda one: one.distance)))


def _distance(
    zeros: tuple[Expr, ...], joints: tuple[str, ...], known: Mapping[str, Angle | float]
) -> tuple[tuple[float, ...], float]:
    """The values of expressions, and how far joints are from making all of them zero at once."""
    over = Floats(known)
    values = tuple(over.value(zero) for zero in zeros)
    match zeros:
        case (Trig(_, angle),):
            size = math.hypot(*(float(factor) for name, factor in angle.terms if name in joints))
            return values, math.asin(min(1.0, abs(values[0]))) / size
    own = [name for name in joints if any(name in symbols(zero) for zero in zeros)]
    return values, least_move(zeros, own, known)
