"""`dhcli rates`: joint rates for a velocity of the end, and the velocity for joint rates."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from dhcli.cli.shell.chosen import Chosen
from dhcli.cli.shell.options import AtPoint, Axes, Symbolic
from dhcli.cli.shell.written import Shown
from dhcli.frozen import frozen

if TYPE_CHECKING:
    from dhcli.kinematics.robot import Robot, Value
    from dhcli.kinematics.velocity.answers import VelocityAnswer
    from dhcli.kinematics.velocity.view import MotionView

EXAMPLES = """
[bold]Examples[/]

dhcli rates planar-2r --q 30,60 --deg --velocity 0.1,0,0

dhcli rates puma560 --pose nominal --velocity 0.1,0,0 --angular 0,0,0

dhcli rates planar-2r --q 0,0 --velocity 0.1,0,0 --damped 0.05

dhcli rates planar-2r --q 30,60 --deg --rates 1,-2

dhcli rates planar-2r --symbolic
"""


@frozen
class Asked:
    """The velocity or the rates that are given, as they were typed."""

    velocity: Annotated[
        str | None, typer.Option(metavar="VX,VY,VZ", help="Velocity of the point that is wanted, in m/s.")
    ] = None
    angular: Annotated[
        str | None,
        typer.Option(metavar="WX,WY,WZ", help="Angular velocity that is wanted, in rad/s; any without it."),
    ] = None
    damped: Annotated[
        float | None, typer.Option(metavar="λ", help="Damped least squares: smaller rates, not quite the velocity.")
    ] = None
    rates_: Annotated[
        str | None,
        typer.Option("--rates", metavar="RATES", help="The other way: a rate for each joint, in rad/s or m/s."),
    ] = None
    symbolic: Symbolic = False
    in_: Axes = None
    at: AtPoint = None

    @property
    def is_velocity(self) -> bool:
        """Whether a velocity is given."""
        return self.velocity is not None or self.angular is not None


def rates(chosen: Chosen, asked: Asked, out: Shown) -> None:
    """Joint rates for a velocity of a robot's end, or with --rates the velocity that they give."""
    from dhcli.cli.shell.given import robot_of, values_of
    from dhcli.cli.shell.moving import view_of

    _check(asked)
    delivery = out.delivery("rates", "velocity")
    arm = robot_of(chosen)
    view = view_of(arm, chosen, asked.in_, asked.at, "--at")
    values = values_of(arm, chosen, symbolic=asked.symbolic)
    result = (_rates if asked.is_velocity else _velocity)(arm, view, values, asked)
    delivery.hand_over("velocity", result, result.warnings)


def _check(asked: Asked) -> None:
    """Refuse what contradicts itself.

    Raises:
        DhcliError: Two options contradict each other.
    """
    from dhcli.errors import DhcliError

    if asked.is_velocity and asked.rates_ is not None:
        raise DhcliError("--rates does not go with a velocity", "it is the other way: leave it out")
    if asked.symbolic and asked.damped is not None:
        raise DhcliError("--symbolic does not go with --damped", "damped rates are numbers: leave one out")
    if asked.damped is not None and not asked.is_velocity:
        raise DhcliError("--damped is about joint rates for a velocity", "give --velocity VX,VY,VZ")


def _rates(arm: Robot, view: MotionView, values: dict[str, Value], asked: Asked) -> VelocityAnswer:
    """The rates for a velocity."""
    from dhcli.cli.shell.vectors import SPEED, TURNING, vector_of
    from dhcli.kinematics.velocity.asked import answer_rates, answer_symbolic_rates

    linear = None if asked.velocity is None else vector_of(asked.velocity, "--velocity", SPEED, arm)
    turning = None if asked.angular is None else vector_of(asked.angular, "--angular", TURNING, arm)
    if asked.symbolic:
        return answer_symbolic_rates(arm, values, view, linear, turning)
    return answer_rates(arm, values, view, (linear, turning), asked.damped or 0.0)


def _velocity(arm: Robot, view: MotionView, values: dict[str, Value], asked: Asked) -> VelocityAnswer:
    """The velocity that rates give."""
    from dhcli.cli.shell.vectors import rates_of
    from dhcli.kinematics.velocity.asked import answer_velocity
    from dhcli.kinematics.velocity.jacobian import moving_joints

    given = None if asked.rates_ is None else rates_of(asked.rates_, arm, moving_joints(arm, view))
    return answer_velocity(arm, values, view, given, symbolic=asked.symbolic)
