"""`dhcli describe`: a robot's table from its axes, and every other description of it."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Annotated, TypeAlias

import typer

from dhcli.cli.shell import completing
from dhcli.cli.shell.chosen import Chosen
from dhcli.cli.shell.spreading import But
from dhcli.cli.shell.written import Written, in_formats
from dhcli.frozen import frozen

if TYPE_CHECKING:
    from dhcli.kinematics.describe.asked import Form

EXAMPLES = """
[bold]Examples[/]

dhcli describe puma560 --as standard

dhcli describe zhou-3r --as modified --steps

dhcli describe ur5e --as standard --choose previous-x

dhcli describe panda --as screws

dhcli describe scara --as axes -o drawn.yaml

dhcli describe ur5e -o ur5e.urdf

dhcli describe ur5e --as standard --straighten 1e-4

dhcli describe fanuc-like --as motors

dhcli describe fanuc-like --motors --as modified
"""

_NO_MOTORS = "a URDF has no motors that drive joints together: each joint has the widest range that they leave it"


@frozen
class Wanted:
    """Which description is wanted, as it was typed."""

    form: Annotated[
        str | None,
        typer.Option(
            "--as",
            metavar="FORM",
            help="standard, modified, axes, screws, body-screws, product, urdf, or motors: what drives the joints.",
            autocompletion=completing.of_module("kinematics.describe.asked", "FORMS", "urdf", "motors"),
        ),
    ] = None
    steps: Annotated[
        bool, typer.Option("--steps", help="Tell the process of Denavit and Hartenberg, step by step.")
    ] = False
    choose: Annotated[
        str | None,
        typer.Option(
            metavar="WHAT",
            help="Where the rules leave a choice: next-d (parallel axes: the next d is 0), previous-x (a may be < 0).",
            autocompletion=completing.of_module("kinematics.describe.choices", "WORDS"),
        ),
    ] = None
    straighten: Annotated[
        str | None,
        typer.Option(
            metavar="ANGLE",
            help="Take axes as parallel, or meeting, that are so within an angle: 1e-4, 0.01°; says what changes.",
        ),
    ] = None
    numbers: Annotated[bool, typer.Option("--numbers", help="Put the values of lengths in.")] = False


DrawnPose: TypeAlias = Annotated[
    str | None,
    typer.Option(
        "--pose",
        metavar="NAME",
        help="A named pose of the robot, in which it is drawn.",
        autocompletion=completing.of_robot("poses"),
    ),
]


def describe(
    chosen: Annotated[Chosen, But(without=("q", "deg", "from_", "to"), instead={"pose": DrawnPose})],
    wanted: Wanted,
    out: Annotated[
        Written, in_formats(("table", "json", "yaml", "urdf"), (".yaml", ".urdf", ".json", ".txt"), "digits")
    ],
) -> None:
    """Describe a robot anew: DH tables of either convention, drawn axes, screws, products; each result is proved.

    With --pose it is drawn in that pose, not at zero.
    """
    out = _as_urdf(out) if wanted.form == "urdf" else out
    if wanted.form == "motors":
        _motors(chosen, wanted, out)
    else:
        _description(chosen, wanted, out)


def _as_urdf(out: Written) -> Written:
    """What `--as urdf` says of the format.

    Raises:
        DhcliError: Something else says another.
    """
    from dhcli.errors import DhcliError
    from dhcli.render.endings import check_ending

    if out.format not in (None, "urdf"):
        raise DhcliError(f"--as urdf and --format {out.format} ask for different things", "leave one of the two out")
    check_ending(out.output, "urdf", "--as", ())
    return replace(out, format="urdf")


def _motors(chosen: Chosen, wanted: Wanted, out: Written) -> None:
    """What drives the joints."""
    from dhcli.cli.shell.given import robot_of
    from dhcli.errors import DhcliError
    from dhcli.kinematics.motors import driven

    if replace(wanted, form=None, choose=wanted.choose or None) != Wanted() or chosen.pose is not None:
        raise DhcliError("--as motors has no steps, choices, numbers, pose or straightening", "leave them out")
    if chosen.motors:
        raise DhcliError("--motors describes the arm by motor values, --as motors the drives", "leave one out")
    delivery = out.delivery("describe", "motors")
    delivery.hand_over("motors", driven(robot_of(chosen)))


def _description(chosen: Chosen, wanted: Wanted, out: Written) -> None:
    """A table, axes, screws or a product."""
    from dhcli.cli.shell.given import angle_of, lengths_of, named_pose, robot_of
    from dhcli.kinematics.describe.asked import Asked
    from dhcli.kinematics.describe.choices import read_choices
    from dhcli.kinematics.describe.description import describe as described

    delivery = out.delivery("describe", "description")
    name = delivery.chosen("description")
    form = _form(wanted, name)
    arm = robot_of(chosen)
    arm = replace(arm, parameters={**arm.parameters, **lengths_of(arm, chosen, symbolic=True)})
    drawn = None if chosen.pose is None else named_pose(arm, chosen.pose)
    within = None if wanted.straighten is None else angle_of(wanted.straighten, "--straighten")
    asked = Asked(form, wanted.steps, wanted.numbers, drawn, read_choices(wanted.choose or ""), within)
    result = described(arm, asked)
    # a file says nothing of itself where it is written
    said = result.straightened.lines()[:1] if result.straightened and name in ("yaml", "urdf") else ()
    lost = (_NO_MOTORS,) if arm.actuators is not None and name == "urdf" else ()
    delivery.hand_over("description", result, (*arm.remarks, *said, *lost, *result.warnings))


def _form(wanted: Wanted, name: str) -> Form:
    """The form of a description that is written in a format.

    Raises:
        DhcliError: There is no such form, or format or choices do not go with it.
    """
    from dhcli.errors import DhcliError
    from dhcli.kinematics.conventions import TABLES
    from dhcli.kinematics.describe.asked import check_form

    usual = "product" if name == "urdf" else "standard"
    form = check_form(usual if wanted.form in (None, "urdf") else wanted.form, ("urdf", "motors"))
    if name == "urdf" and form != usual:
        raise DhcliError(f"--as {form} and a URDF ask for different things", "leave one of the two out")
    if wanted.choose and form not in TABLES:
        raise DhcliError("--choose is about tables", "--as standard or --as modified")
    if wanted.steps and form not in TABLES:
        raise DhcliError("--steps tells how a table is found", "--as standard or --as modified")
    return form
