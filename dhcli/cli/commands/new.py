"""`dhcli new`: files to start from."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from dhcli.cli.app import Group, One
from dhcli.cli.shell.options import Force

new = typer.Typer(cls=Group, add_completion=False, rich_markup_mode="rich", help="Write a file to start from.")


@new.callback()
def _group() -> None:
    """Write a file to start from."""


@new.command(cls=One, epilog="dhcli new robot my-arm --convention standard --joints RRP")
def robot(
    name: Annotated[str, typer.Argument(metavar="NAME", help="Name of the robot.")],
    convention: Annotated[str, typer.Option(metavar="NAME", help="standard, modified or product.")] = "standard",
    joints: Annotated[str, typer.Option(metavar="LETTERS", help="R revolute, P prismatic, such as RRP.")] = "RRP",
    output: Annotated[
        str | None,
        typer.Option(
            "-o", "--output", metavar="FILE", help="Where to write; ./robots/NAME.yaml by default, - is stdout."
        ),
    ] = None,
    force: Force = False,
) -> None:
    """Write a commented robot file that loads, for you to change."""
    from dhcli.cli.shell.console import tell, write_out
    from dhcli.cli.shell.delivery import make_folder, write_file
    from dhcli.files.yaml.templates import robot_template

    text = robot_template(name, convention, joints)
    if output == "-":
        write_out(text)
        return
    path = Path(output or f"robots/{name}.yaml")
    if output is None:
        make_folder(path.parent)
    write_file(path, text, force=force)
    asked = name if output is None else path
    tell(f"wrote {path}")
    tell(f"next: dhcli show {asked}, then dhcli fk {asked} --symbolic")


@new.command(cls=One, epilog="dhcli new exercise my-course/first --robot planar-2r")
def exercise(
    name: Annotated[str, typer.Argument(metavar="COURSE/NAME", help="Id of the exercise.")],
    robot_name: Annotated[str, typer.Option("--robot", metavar="ROBOT", help="The robot it asks about.")],
    output: Annotated[
        str | None,
        typer.Option(
            "-o",
            "--output",
            metavar="FILE",
            help="Where to write; ./exercises/COURSE/NAME.yaml by default, - is stdout.",
        ),
    ] = None,
    force: Force = False,
) -> None:
    """Write a commented exercise file with blanks that lint points at, for you to fill in."""
    from dhcli.cli.shell.console import tell, write_out
    from dhcli.cli.shell.delivery import make_folder, write_file
    from dhcli.files.yaml.exercise_template import exercise_template
    from dhcli.files.yaml.robots import load_robot

    text = exercise_template(name, load_robot(robot_name))
    if output == "-":
        write_out(text)
        return
    path = Path(output or f"exercises/{name}.yaml")
    if output is None:
        make_folder(path.parent.parent)
        make_folder(path.parent)
    write_file(path, text, force=force)
    tell(f"wrote {path}")
    tell(f"next: fill in what is empty, then dhcli lint {path}")


@new.command(cls=One, epilog="dhcli new linkage my-press --form joints")
def linkage(
    name: Annotated[str, typer.Argument(metavar="NAME", help="Name of the linkage.")],
    form: Annotated[str, typer.Option(metavar="FORM", help="joints, bars, chain or loop.")] = "joints",
    output: Annotated[
        str | None,
        typer.Option(
            "-o",
            "--output",
            metavar="FILE",
            help="Where to write; ./robots/linkages/NAME.yaml by default, - is stdout.",
        ),
    ] = None,
    force: Force = False,
) -> None:
    """Write a commented linkage file that loads, for you to change."""
    from dhcli.cli.shell.console import tell, write_out
    from dhcli.cli.shell.delivery import make_folder, write_file
    from dhcli.files.yaml.linkage_template import linkage_template

    text = linkage_template(name, form)
    if output == "-":
        write_out(text)
        return
    path = Path(output or f"robots/linkages/{name}.yaml")
    if output is None:
        make_folder(path.parent.parent)
        make_folder(path.parent)
    write_file(path, text, force=force)
    asked = name if output is None else path
    tell(f"wrote {path}")
    tell(f"next: dhcli show {asked}, then dhcli dof {asked}")
