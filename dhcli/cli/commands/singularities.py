"""`dhcli singularities`: where a robot loses motions, and how far from there it stands."""

from __future__ import annotations

from typing import Annotated

import typer

from dhcli.cli.shell.chosen import Chosen
from dhcli.cli.shell.options import WHERE, EndPoint
from dhcli.cli.shell.spreading import But
from dhcli.cli.shell.written import Written

EXAMPLES = """
[bold]Examples[/]

dhcli singularities puma560

dhcli singularities articulated --q 30,60,-75 --deg

dhcli singularities puma560 --part linear --to 4

dhcli singularities zhou-3r --point 0.1,0,0
"""


def singularities(
    chosen: Chosen,
    point: EndPoint = None,
    part: Annotated[
        str | None,
        typer.Option(
            metavar="PART",
            help="The task: linear, angular or all; by default what the joints suffice for.",
            rich_help_panel=WHERE,
        ),
    ] = None,
    *,
    out: Annotated[Written, But(without=("code", "with_values", "digits"))],
) -> None:
    """Singular poses of a robot: the determinant in factors, what each means, and with --q how far they are."""
    from dhcli.cli.shell.given import lengths_of, robot_of, values_of
    from dhcli.cli.shell.moving import part_of, view_of
    from dhcli.kinematics.singular.finding import find
    from dhcli.kinematics.velocity.asked import answer_singularities

    delivery = out.delivery("singularities", "singularities")
    arm = robot_of(chosen)
    view = view_of(arm, chosen, None, point, "--point")
    given = lengths_of(arm, chosen, symbolic=True)
    values = values_of(arm, chosen)
    found = find(arm, view, part_of(part), given)
    result = answer_singularities(arm, values, view, found, at_values=chosen.stands)
    delivery.hand_over("singularities", result, result.warnings)
