"""`dhcli dof`: how many freedoms a linkage has, by the formula and in truth."""

from __future__ import annotations

from dataclasses import replace
from typing import Annotated

import typer

from dhcli.cli.shell.chosen import Chosen
from dhcli.cli.shell.spreading import But
from dhcli.cli.shell.written import Written, in_formats

EXAMPLES = """
[bold]Examples[/]

[dim]# a pattern, a linkage of the library, a robot, your own file, or bare counts[/]

dhcli dof 6R

dhcli dof bennett

dhcli dof puma560 --pose stretch

dhcli dof --planar --links 4 --joints 4R
"""

_COUNTS = "Bare counts"
_ROBOT = "A robot at joint values"


def complete_linkage(incomplete: str) -> list[str]:
    """Names of linkages and robots that begin like this; reads no file."""
    from dhcli.files.library.lookup import Kind, entries

    names = (entry.name for kind in (Kind.LINKAGES, Kind.ROBOTS) for entry in entries(kind))
    return [name for name in names if name.startswith(incomplete)]


def dof(
    what: Annotated[
        list[str] | None,
        typer.Argument(
            metavar="WHAT",
            help="A linkage or robot of the library, a YAML or URDF file, - or a pattern: 6R, loop 6R, 6-UPS.",
            autocompletion=complete_linkage,
        ),
    ] = None,
    planar: Annotated[bool, typer.Option("--planar", help="Patterns and counts in the plane, λ = 3.")] = False,
    lambda_: Annotated[
        str | None, typer.Option("--lambda", metavar="L", help="planar, spherical, spatial, or λ from 1 to 6.")
    ] = None,
    links: Annotated[
        str | None,
        typer.Option(metavar="N", help="Links with the ground; may hold a name: 2*n.", rich_help_panel=_COUNTS),
    ] = None,
    joints: Annotated[
        str | None, typer.Option(metavar="LIST", help="Joints: 4R, or 3R 1P.", rich_help_panel=_COUNTS)
    ] = None,
    *,
    chosen: Annotated[
        Chosen, But(without=("robot", "set_", "motors", "from_", "to", "tool", "as_typed"), panel=_ROBOT)
    ],
    tol: Annotated[
        float | None,
        typer.Option("--tol", metavar="X", help="Relative error of rounded input: 0.003 for 3 decimals."),
    ] = None,
    out: Annotated[Written, in_formats(("table", "json"), (".json", ".txt"))],
) -> None:
    """Count the freedoms of a linkage, say whether the formula can be trusted, and find the true mobility."""
    from dhcli.cli.shell.counted import Ends, asked
    from dhcli.errors import DhcliError
    from dhcli.mobility.finding import analyse

    if chosen.stands and not what:
        raise DhcliError("joint values are those of a robot", "dhcli dof puma560 --pose zero")
    kind = "mobility at joint values" if chosen.stands else "mobility"
    delivery = out.delivery("dof", kind)
    tolerance = 0.0 if tol is None else tol
    linkage = asked(
        " ".join(what or []),
        Ends(chosen.base, chosen.tip),
        planar=planar,
        lambda_=lambda_,
        links=links,
        joints=joints,
        tolerance=tolerance,
    )
    mobility = analyse(linkage, tolerance)
    if not chosen.stands:
        delivery.hand_over(kind, mobility)
        return
    from dhcli.cli.shell.given import robot_of, values_of
    from dhcli.mobility.at_pose import at_pose

    robot = robot_of(replace(chosen, robot=" ".join(what or [])))
    found = at_pose(robot, values_of(robot, chosen), mobility)
    delivery.hand_over(kind, found, found.warnings)
