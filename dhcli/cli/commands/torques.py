"""`dhcli torques`: what the joints bear when the end of a robot presses."""

from __future__ import annotations

from typing import Annotated

import typer

from dhcli.cli.shell.chosen import Chosen
from dhcli.cli.shell.options import AtPoint, Axes, Symbolic
from dhcli.cli.shell.written import Shown

EXAMPLES = """
[bold]Examples[/]

dhcli torques planar-2r --q 30,60 --deg --force 0,10,0

dhcli torques planar-2r --symbolic --force f_x,f_y,0

dhcli torques puma560 --pose nominal --force 0,0,-10 --moment 0,0,2 --in 6
"""


def torques(
    chosen: Chosen,
    push: Annotated[
        str | None, typer.Option("--force", metavar="FX,FY,FZ", help="Force that the end exerts, in N.")
    ] = None,
    moment: Annotated[
        str | None, typer.Option("--moment", metavar="MX,MY,MZ", help="Moment that the end exerts, in N m.")
    ] = None,
    symbolic: Symbolic = False,
    in_: Axes = None,
    at: AtPoint = None,
    *,
    out: Shown,
) -> None:
    """Joint torques with which a robot presses with a force: tau = Jᵀ F, in numbers or in symbols."""
    from dhcli.cli.shell.given import robot_of, values_of
    from dhcli.cli.shell.moving import view_of
    from dhcli.cli.shell.vectors import FORCE, MOMENT, vector_of
    from dhcli.errors import DhcliError
    from dhcli.kinematics.velocity.asked import answer_torques

    if push is None and moment is None:
        raise DhcliError("torques of what?", "--force 0,0,10 or --moment 0,0,1: what the end exerts")
    delivery = out.delivery("torques", "torques")
    arm = robot_of(chosen)
    view = view_of(arm, chosen, in_, at, "--at")
    wrench = vector_of(push or "0,0,0", "--force", FORCE, arm), vector_of(moment or "0,0,0", "--moment", MOMENT, arm)
    values = values_of(arm, chosen, symbolic=symbolic)
    result = answer_torques(arm, values, view, wrench, symbolic=symbolic)
    delivery.hand_over("torques", result, result.warnings)
