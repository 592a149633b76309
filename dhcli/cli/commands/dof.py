"""`dhcli dof`: how many freedoms a linkage has, by the formula and in truth."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Annotated

import typer

from dhcli.cli.shell import completing
from dhcli.cli.shell.chosen import Chosen
from dhcli.cli.shell.spreading import But
from dhcli.cli.shell.written import Written, in_formats
from dhcli.frozen import frozen

if TYPE_CHECKING:
    from dhcli.mobility.counting import Counts
    from dhcli.mobility.linkage import Linkage
    from dhcli.mobility.pairs import Space

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


@frozen
class Counted:
    """Where a linkage moves, and how many links and joints it has, as it was typed."""

    planar: Annotated[bool, typer.Option("--planar", help="Patterns and counts in the plane, λ = 3.")] = False
    lambda_: Annotated[
        str | None, typer.Option("--lambda", metavar="L", help="planar, spherical, spatial, or λ from 1 to 6.")
    ] = None
    links: Annotated[
        str | None,
        typer.Option(metavar="N", help="Links with the ground; may hold a name: 2*n.", rich_help_panel=_COUNTS),
    ] = None
    joints: Annotated[
        str | None, typer.Option(metavar="LIST", help="Joints: 4R, or 3R 1P.", rich_help_panel=_COUNTS)
    ] = None


def dof(
    what: Annotated[
        list[str] | None,
        typer.Argument(
            metavar="WHAT",
            help="A linkage or robot of the library, a YAML or URDF file, - or a pattern: 6R, loop 6R, 6-UPS.",
            autocompletion=completing.of_library("linkages", "robots"),
        ),
    ] = None,
    *,
    counted: Counted,
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
    from dhcli.errors import DhcliError
    from dhcli.mobility.finding import mobility_of

    if chosen.stands and not what:
        raise DhcliError("joint values are those of a robot", "dhcli dof puma560 --pose zero")
    chosen = replace(chosen, robot=" ".join(what or []))
    kind = "mobility at joint values" if chosen.stands else "mobility"
    delivery = out.delivery("dof", kind)
    tolerance = tol or 0.0
    mobility = mobility_of(_meant(chosen, counted, tolerance), tolerance)
    if not chosen.stands:
        delivery.hand_over(kind, mobility)
        return
    from dhcli.cli.shell.given import robot_of, values_of
    from dhcli.mobility.at_pose import at_pose

    robot = robot_of(chosen)
    found = at_pose(robot, values_of(robot, chosen), mobility)
    delivery.hand_over(kind, found, found.warnings)


def _meant(chosen: Chosen, counted: Counted, tolerance: float) -> Linkage | Counts:
    """The linkage, or the counts, that the words and options describe.

    Raises:
        DhcliError: They contradict each other, or describe nothing.
    """
    from dhcli.errors import DhcliError

    if counted.planar and counted.lambda_ is not None:
        raise DhcliError("--planar and --lambda say the same thing", "use one of them")
    space = _space(counted)
    if chosen.robot:
        if counted.links is not None or counted.joints is not None:
            message = f"--links and --joints describe a linkage, and so does {chosen.robot}"
            raise DhcliError(message, "give one or the other")
        return _found(chosen, space, tolerance)
    if chosen.base is not None or chosen.tip is not None:
        raise DhcliError("--base and --tip are links of a URDF", "write dhcli dof arm.urdf --tip tool0")
    return _counts(counted, space)


def _space(counted: Counted) -> Space | None:
    from dhcli.errors import Place, Problem
    from dhcli.mobility.pairs import PLANAR, LinkageError, space_of

    if counted.lambda_ is None:
        return PLANAR if counted.planar else None
    try:
        return space_of(counted.lambda_)
    except LinkageError as error:
        place = Place("--lambda", None, None, counted.lambda_)
        raise LinkageError(Problem(p.message, place, p.hint) for p in error.problems) from None


def _found(chosen: Chosen, space: Space | None, tolerance: float) -> Linkage | Counts:
    """The linkage of a file, a name or a pattern."""
    from dhcli.errors import DhcliError
    from dhcli.files.yaml.linkages import find_linkage, open_chain
    from dhcli.mobility.linkage import Linkage
    from dhcli.mobility.pairs import SPATIAL

    what = chosen.robot
    if chosen.base is None and chosen.tip is None:
        found = find_linkage(what, space or SPATIAL, tolerance)
    else:
        from dhcli.files.yaml.robots import load_robot  # few linkages are chains of a URDF

        found = open_chain(load_robot(what, base=chosen.base, tip=chosen.tip), what)
    if space is not None and isinstance(found, Linkage) and not found.reading:
        raise DhcliError(f"{what} says itself where it moves: {found.space}", "leave --planar and --lambda out")
    return found


def _counts(counted: Counted, space: Space | None) -> Counts:
    """Counts without a linkage."""
    from dhcli.errors import DhcliError, Place
    from dhcli.mobility.counting import counts
    from dhcli.mobility.pairs import SPATIAL
    from dhcli.mobility.patterns import count_of, joint_counts

    links, joints = counted.links, counted.joints
    if links is None or joints is None:
        missing = "--links" if joints is not None else "--joints" if links is not None else ""
        if missing:
            raise DhcliError(f"{missing} is missing", "write --planar --links 4 --joints 4R")
        raise DhcliError("nothing to count", "write dhcli dof bennett, dhcli dof 6R, or --planar --links 4 --joints 4R")
    place = Place("--joints", None, None, joints)
    n = count_of(links, Place("--links", None, 1, links))
    return counts(space or SPATIAL, n, joint_counts(joints, place), f"{links} links, {joints}")
