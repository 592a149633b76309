"""`dhcli describe`: a robot's table from its axes, and every other description of it."""

from __future__ import annotations

from typing import Annotated

import typer

from dhcli.cli.shell.chosen import Chosen
from dhcli.cli.shell.options import Digits, Overwrite, format_option, output_option
from dhcli.cli.shell.spreading import But

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


def complete_form(incomplete: str) -> list[str]:
    """The descriptions that begin like this."""
    from dhcli.kinematics.describe.asked import FORMS

    return [form for form in (*FORMS, "urdf", "motors") if form.startswith(incomplete)]


def complete_choice(incomplete: str) -> list[str]:
    """The choices that begin like this."""
    from dhcli.kinematics.describe.choices import WORDS

    return [word for word in WORDS if word.startswith(incomplete)]


def describe(
    chosen: Annotated[Chosen, But(without=("q", "deg", "from_", "to"))],
    as_: Annotated[
        str | None,
        typer.Option(
            "--as",
            metavar="FORM",
            help="standard, modified, axes, screws, body-screws, product, urdf, or motors: what drives the joints.",
            autocompletion=complete_form,
        ),
    ] = None,
    steps: Annotated[
        bool, typer.Option("--steps", help="Tell the process of Denavit and Hartenberg, step by step.")
    ] = False,
    choose: Annotated[
        str | None,
        typer.Option(
            metavar="WHAT",
            help="Where the rules leave a choice: next-d (parallel axes: the next d is 0), previous-x (a may be < 0).",
            autocompletion=complete_choice,
        ),
    ] = None,
    straighten: Annotated[
        str | None,
        typer.Option(
            metavar="ANGLE",
            help="Take axes as parallel, or meeting, that are so within an angle: 1e-4, 0.01°; says what changes.",
        ),
    ] = None,
    numbers: Annotated[bool, typer.Option("--numbers", help="Put the values of lengths in.")] = False,
    format_: Annotated[str | None, format_option("table", "json", "yaml", "urdf")] = None,
    digits: Digits = None,
    output: Annotated[str | None, output_option(".yaml", ".urdf", ".json", ".txt")] = None,
    overwrite: Overwrite = False,
) -> None:
    """Describe a robot anew: DH tables of either convention, drawn axes, screws, products; each result is proved.

    With --pose it is drawn in that pose, not at zero.
    """
    from dataclasses import replace

    from dhcli.cli.shell.delivery import Delivery
    from dhcli.cli.shell.endings import check_ending
    from dhcli.cli.shell.given import angle_of, lengths_of, named_pose, robot_of
    from dhcli.errors import DhcliError
    from dhcli.kinematics.describe.asked import Asked, check_form
    from dhcli.kinematics.describe.choices import read_choices
    from dhcli.kinematics.describe.description import describe as described
    from dhcli.kinematics.motors import driven

    if as_ == "urdf":
        if format_ not in (None, as_):
            raise DhcliError(f"--as urdf and --format {format_} ask for different things", "leave one of the two out")
        check_ending(output, as_, "--as", ())
        format_ = as_
    delivery = Delivery("describe", format_, digits, output=output, overwrite=overwrite)
    if as_ == "motors":
        if steps or choose or numbers or straighten is not None or chosen.pose is not None:
            raise DhcliError("--as motors has no steps, choices, numbers, pose or straightening", "leave them out")
        if chosen.motors:
            raise DhcliError("--motors describes the arm by motor values, --as motors the drives", "leave one out")
        delivery.chosen("motors")
        delivery.hand_over("motors", driven(robot_of(chosen)))
        return
    name = delivery.chosen("description")
    usual = "product" if name == "urdf" else "standard"
    form = check_form(usual if as_ in (None, "urdf") else as_, ("urdf", "motors"))
    if name == "urdf" and form != usual:
        raise DhcliError(f"--as {form} and a URDF ask for different things", "leave one of the two out")
    if choose and form not in ("standard", "modified"):
        raise DhcliError("--choose is about tables", "--as standard or --as modified")
    arm = robot_of(chosen)
    arm = replace(arm, parameters={**arm.parameters, **lengths_of(arm, chosen, symbolic=True)})
    drawn = None if chosen.pose is None else named_pose(arm, chosen.pose)
    within = None if straighten is None else angle_of(straighten, "--straighten")
    result = described(arm, Asked(form, steps, numbers, drawn, read_choices(choose or ""), within))
    # a file says nothing of itself where it is written
    said = result.straightened.lines()[:1] if result.straightened and name in ("yaml", "urdf") else ()
    lost = (_NO_MOTORS,) if arm.actuators is not None and name == "urdf" else ()
    delivery.hand_over("description", result, (*arm.remarks, *said, *lost, *result.warnings))
