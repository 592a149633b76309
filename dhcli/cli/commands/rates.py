"""`dhcli rates`: joint rates for a velocity of the end, and the velocity for joint rates."""

from __future__ import annotations

from typing import Annotated

import typer

from dhcli.cli.shell.chosen import Chosen
from dhcli.cli.shell.options import AtPoint, Axes, Symbolic
from dhcli.cli.shell.written import Shown

EXAMPLES = """
[bold]Examples[/]

dhcli rates planar-2r --q 30,60 --deg --velocity 0.1,0,0

dhcli rates puma560 --pose nominal --velocity 0.1,0,0 --angular 0,0,0

dhcli rates planar-2r --q 0,0 --velocity 0.1,0,0 --damped 0.05

dhcli rates planar-2r --q 30,60 --deg --rates 1,-2

dhcli rates planar-2r --symbolic
"""


def rates(
    chosen: Chosen,
    velocity: Annotated[
        str | None, typer.Option(metavar="VX,VY,VZ", help="Velocity of the point that is wanted, in m/s.")
    ] = None,
    angular: Annotated[
        str | None,
        typer.Option(metavar="WX,WY,WZ", help="Angular velocity that is wanted, in rad/s; any without it."),
    ] = None,
    damped: Annotated[
        float | None, typer.Option(metavar="λ", help="Damped least squares: smaller rates, not quite the velocity.")
    ] = None,
    rates_: Annotated[
        str | None,
        typer.Option("--rates", metavar="RATES", help="The other way: a rate for each joint, in rad/s or m/s."),
    ] = None,
    symbolic: Symbolic = False,
    in_: Axes = None,
    at: AtPoint = None,
    *,
    out: Shown,
) -> None:
    """Joint rates for a velocity of a robot's end, or with --rates the velocity that they give."""
    from dhcli.cli.shell.given import robot_of, values_of
    from dhcli.cli.shell.moving import view_of
    from dhcli.cli.shell.vectors import SPEED, TURNING, rates_of, vector_of
    from dhcli.errors import DhcliError
    from dhcli.kinematics.velocity.asked import answer_rates, answer_symbolic_rates, answer_velocity
    from dhcli.kinematics.velocity.jacobian import moving_joints

    wanted = velocity is not None or angular is not None
    if wanted and rates_ is not None:
        raise DhcliError("--rates does not go with a velocity", "it is the other way: leave it out")
    if symbolic and damped is not None:
        raise DhcliError("--symbolic does not go with --damped", "damped rates are numbers: leave one out")
    if damped is not None and not wanted:
        raise DhcliError("--damped is about joint rates for a velocity", "give --velocity VX,VY,VZ")
    delivery = out.delivery("rates", "velocity")
    arm = robot_of(chosen)
    view = view_of(arm, chosen, in_, at, "--at")
    values = values_of(arm, chosen, symbolic=symbolic)
    if wanted:
        linear = None if velocity is None else vector_of(velocity, "--velocity", SPEED, arm)
        turning = None if angular is None else vector_of(angular, "--angular", TURNING, arm)
        if symbolic:
            result = answer_symbolic_rates(arm, values, view, linear, turning)
        else:
            result = answer_rates(arm, values, view, (linear, turning), damped or 0.0)
    else:
        given = None if rates_ is None else rates_of(rates_, arm, moving_joints(arm, view))
        result = answer_velocity(arm, values, view, given, symbolic=symbolic)
    delivery.hand_over("velocity", result, result.warnings)
