"""What is answered about a robot in motion: one typed result each, which every output format is drawn from."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhcli.frozen import frozen
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.values import Values
from dhcli.kinematics.velocity.jacobian import Jacobian
from dhcli.kinematics.velocity.statics import Torques
from dhcli.kinematics.velocity.view import MotionView
from dhcli.notation.tree import Expr

if TYPE_CHECKING:  # what only some answers hold is imported when it is asked for
    from dhcli.kinematics.singular.result import Singularities
    from dhcli.kinematics.singular.standing import Standing
    from dhcli.kinematics.velocity.rates import Rates
    from dhcli.notation.let import Definition


@frozen
class JacobianAnswer:
    """A Jacobian that somebody asked for.

    Attributes:
        robot: The robot asked.
        values: The values used.
        jacobian: The Jacobian.
        definitions: Names that stand in it for brackets, each in terms of those before it.
        hint: A frame in which it is much shorter, in words; empty if there is none.
        warnings: What a person should know all the same.
    """

    robot: Robot
    values: Values
    jacobian: Jacobian[float] | Jacobian[Expr]
    definitions: tuple[Definition, ...] = ()
    hint: str = ""
    warnings: tuple[str, ...] = ()


@frozen
class SingularAnswer:
    """Where a robot is singular, and how it stands at some joint values.

    Attributes:
        robot: The robot asked.
        values: The values used.
        view: Between which frames, of which point.
        found: Where it is singular.
        standing: How it stands, if joint values are given.
        warnings: What a person should know all the same.
    """

    robot: Robot
    values: Values
    view: MotionView
    found: Singularities
    standing: Standing | None = None
    warnings: tuple[str, ...] = ()


@frozen
class TorquesAnswer:
    """What the joints of a robot bear.

    Attributes:
        robot: The robot asked.
        values: The values used.
        torques: The torques.
        warnings: What a person should know all the same.
    """

    robot: Robot
    values: Values
    torques: Torques[float] | Torques[Expr]
    warnings: tuple[str, ...] = ()


@frozen
class VelocityAnswer:
    """The velocity for joint rates, or the joint rates for a velocity.

    Attributes:
        robot: The robot asked.
        values: The values used.
        view: Of which frame and point, along which axes.
        joints: The joints.
        rates: Their rates.
        labels: What each number of the velocity is.
        velocity: The velocity that they give.
        solved: How the rates were found, if a velocity was given.
        warnings: What a person should know all the same.
        for_velocity: Whether the velocity was given, and the rates are what was asked for.
    """

    robot: Robot
    values: Values
    view: MotionView
    joints: tuple[str, ...]
    rates: tuple[float, ...] | tuple[Expr, ...]
    labels: tuple[str, ...]
    velocity: tuple[float, ...] | tuple[Expr, ...]
    solved: Rates | None = None
    warnings: tuple[str, ...] = ()
    for_velocity: bool = False
