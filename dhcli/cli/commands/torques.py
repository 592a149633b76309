"""`dhcli torques`: what the joints bear when the end of a robot presses."""

from __future__ import annotations

from typing import Annotated

import typer

from dhcli.cli.shell.options import (
    Against,
    AsTyped,
    AtPoint,
    Axes,
    Base,
    Degrees,
    Digits,
    Force,
    Format,
    Joints,
    Moving,
    NamedPose,
    Output,
    RobotName,
    Settings,
    Spelling,
    Symbolic,
    Tip,
)

EXAMPLES = """
[bold]Examples[/]

dhcli torques planar-2r --q 30,60 --deg --force 0,10,0

dhcli torques planar-2r --symbolic --force f_x,f_y,0

dhcli torques puma560 --pose nominal --force 0,0,-10 --moment 0,0,2 --in 6
"""


def torques(
    robot: RobotName,
    q: Joints = None,
    deg: Degrees = False,
    pose: NamedPose = None,
    set_: Settings = None,
    push: Annotated[
        str | None, typer.Option("--force", metavar="FX,FY,FZ", help="Force that the end exerts, in N.")
    ] = None,
    moment: Annotated[
        str | None, typer.Option("--moment", metavar="MX,MY,MZ", help="Moment that the end exerts, in N m.")
    ] = None,
    symbolic: Symbolic = False,
    from_: Against = None,
    to: Moving = None,
    in_: Axes = None,
    at: AtPoint = None,
    base: Base = None,
    tip: Tip = None,
    as_typed: AsTyped = False,
    format_: Format = None,
    style: Spelling = None,
    digits: Digits = None,
    output: Output = None,
    overwrite: Force = False,
) -> None:
    """Joint torques with which a robot presses with a force: tau = Jᵀ F, in numbers or in symbols."""
    from dhcli.cli.shell.delivery import Delivery
    from dhcli.cli.shell.given import values_of
    from dhcli.cli.shell.moving import view_of
    from dhcli.cli.shell.vectors import FORCE, MOMENT, vector_of
    from dhcli.errors import DhcliError
    from dhcli.files.yaml.robots import load_robot
    from dhcli.kinematics.velocity.asked import answer_torques

    if push is None and moment is None:
        raise DhcliError("torques of what?", "--force 0,0,10 or --moment 0,0,1: what the end exerts")
    delivery = Delivery("torques", format_, digits, style, output, overwrite)
    delivery.chosen("torques")
    arm = load_robot(robot, base=base, tip=tip, as_typed=as_typed)
    view = view_of(arm, from_, to, in_, at, "--at")
    wrench = vector_of(push or "0,0,0", "--force", FORCE, arm), vector_of(moment or "0,0,0", "--moment", MOMENT, arm)
    values = values_of(arm, q, pose, set_ or [], degrees=deg, symbolic=symbolic)
    result = answer_torques(arm, values, view, wrench, symbolic=symbolic)
    delivery.hand_over("torques", result, result.warnings)
