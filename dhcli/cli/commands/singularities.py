"""`dhcli singularities`: where a robot loses motions, and how far from there it stands."""

from __future__ import annotations

from typing import Annotated

import typer

from dhcli.cli.shell.options import (
    WHERE,
    Against,
    AsTyped,
    Base,
    Degrees,
    EndPoint,
    Force,
    Format,
    Joints,
    Moving,
    NamedPose,
    Output,
    RobotName,
    Settings,
    Spelling,
    Tip,
)

EXAMPLES = """
[bold]Examples[/]

dhcli singularities puma560

dhcli singularities articulated --q 30,60,-75 --deg

dhcli singularities puma560 --part linear --to 4

dhcli singularities zhou-3r --point 0.1,0,0
"""


def singularities(
    robot: RobotName,
    q: Joints = None,
    deg: Degrees = False,
    pose: NamedPose = None,
    set_: Settings = None,
    from_: Against = None,
    to: Moving = None,
    point: EndPoint = None,
    part: Annotated[
        str | None,
        typer.Option(
            metavar="PART",
            help="The task: linear, angular or all; by default what the joints suffice for.",
            rich_help_panel=WHERE,
        ),
    ] = None,
    base: Base = None,
    tip: Tip = None,
    as_typed: AsTyped = False,
    format_: Format = None,
    style: Spelling = None,
    output: Output = None,
    force: Force = False,
) -> None:
    """Singular poses of a robot: the determinant in factors, what each means, and with --q how far they are."""
    from dhcli.cli.shell.delivery import Delivery
    from dhcli.cli.shell.given import values_of
    from dhcli.cli.shell.moving import part_of, view_of
    from dhcli.files.yaml.robots import load_robot
    from dhcli.kinematics.singular.finding import find
    from dhcli.kinematics.velocity.asked import answer_singularities

    delivery = Delivery("singularities", format_, None, style, output, force)
    delivery.chosen("singularities")
    arm = load_robot(robot, base=base, tip=tip, as_typed=as_typed)
    view = view_of(arm, from_, to, None, point, "--point")
    at_values = q is not None or pose is not None
    given = values_of(arm, None, None, set_ or [], degrees=deg, symbolic=True)
    values = values_of(arm, q, pose, set_ or [], degrees=deg, symbolic=False)
    found = find(arm, view, part_of(part), given)
    result = answer_singularities(arm, values, view, found, at_values=at_values)
    delivery.hand_over("singularities", result, result.warnings)
