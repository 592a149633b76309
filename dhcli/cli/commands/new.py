"""`dhcli new`: files to start from."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from dhcli.cli.app import Group, One
from dhcli.cli.shell.chosen import Chosen
from dhcli.cli.shell.spreading import But, spread
from dhcli.cli.shell.written import Overwrite, output_option

if TYPE_CHECKING:
    from dhcli.files.foreign.importing import Wish

_OF_URDF = But(without=("robot", "q", "deg", "pose", "set_", "motors", "from_", "to", "tool"))
"""Of the options about a robot those that choose a chain of a URDF."""

new = typer.Typer(cls=Group, add_completion=False, rich_markup_mode="rich", help="Write a file to start from.")


@new.callback()
def _group() -> None:
    """Write a file to start from."""


@new.command(
    cls=One,
    epilog="dhcli new robot my-arm --convention standard --joints RRP\n\n"
    "dhcli new robot --from table.csv --convention modified",
)
@spread
def robot(
    *,
    name: Annotated[
        str | None, typer.Argument(metavar="NAME", help="Name of the robot; with --from that of the file by default.")
    ] = None,
    convention: Annotated[
        str | None,
        typer.Option(
            metavar="NAME",
            help="standard, modified or product; of a table in FILE the one it is in.",
            show_default=False,
        ),
    ] = None,
    joints: Annotated[
        str | None,
        typer.Option(metavar="LETTERS", help="R revolute, P prismatic, such as RRP; with --from also F fixed."),
    ] = None,
    from_: Annotated[
        str | None,
        typer.Option(
            "--from",
            metavar="FILE",
            help="Make it of this: a DH table as CSV, Markdown, LaTeX, YAML or JSON, a listing with SerialLink or "
            "DHRobot, kinematics YAML of ROS, or a URDF; - is stdin.",
        ),
    ] = None,
    units: Annotated[
        str | None, typer.Option(metavar="UNITS", help="Units of bare lengths and angles in FILE, such as mm,deg.")
    ] = None,
    chain: Annotated[Chosen, _OF_URDF],
    output: Annotated[str | None, output_option("Where to write; ./robots/NAME.yaml by default, - is stdout.")] = None,
    overwrite: Overwrite = False,
) -> None:
    """Write a commented robot file that loads, for you to change, or one that is made of another description."""
    from dhcli.cli.shell.console import tell
    from dhcli.errors import DhcliError
    from dhcli.files.library.entries import Kind, is_own, refuse_namesake
    from dhcli.files.library.lookup import OWN, typed_path
    from dhcli.files.yaml.templates import check_name, robot_template

    if from_ is not None:
        from dhcli.files.foreign.importing import Wish

        name = name or ("stdin" if from_ == "-" else Path(from_).stem)
        check_name(name)
        wish = Wish(name, convention, joints or "", units or "", chain.base, chain.tip, chain.as_typed)
        text = _imported(from_, wish)
    elif name is None:
        raise DhcliError("a new robot wants a name", "write dhcli new robot my-arm, or --from FILE")
    elif units or chain.more:
        raise DhcliError("--units, --base, --tip and --as-typed say how a file is read", "name one: --from arm.urdf")
    else:
        text = robot_template(name, convention or "standard", joints or "RRP")
    path = Path(output or f"robots/{name}.yaml")
    refuse_namesake(Kind.ROBOTS, name)
    asked = name if output is None else typed_path(path)
    _write(text, output, path, f"dhcli show {asked}, then dhcli fk {asked} --symbolic", overwrite=overwrite)
    if output is None and is_own(name):
        tell(f"note: it hides the robot {name} that dhcli brings along, which is {OWN}{name} now")


def _imported(path: str, wish: Wish) -> str:
    """The text of the robot file that another file makes.

    Args:
        path: The file; `-` is standard input.
        wish: What a person says about it.

    Raises:
        FileError: It is of no form that is read, or something is wrong in it.
        UnknownNameError: There is no such convention, unit or link.
    """
    from dhcli.cli.shell.console import tell
    from dhcli.files.foreign.importing import import_robot
    from dhcli.files.reading import read_text, source_of
    from dhcli.files.yaml.robots import XML_LIMIT
    from dhcli.files.yaml.writing import robot_text
    from dhcli.lint.lengths import told_once

    robot = import_robot(read_text(path, limit=XML_LIMIT), source_of(path), wish)
    for remark in (*robot.remarks, *told_once(robot, "" if wish.units else "--units mm takes bare lengths as such")):
        tell(f"note: {remark}")
    if lacking := [name for name, value in robot.parameters.items() if value is None]:
        tell(f"note: {', '.join(lacking)} {'has' if len(lacking) == 1 else 'have'} no value yet, see parameters:")
    return robot_text(robot)


@new.command(cls=One, epilog="dhcli new exercise my-course/first --robot planar-2r")
def exercise(
    name: Annotated[str, typer.Argument(metavar="COURSE/NAME", help="Id of the exercise.")],
    robot_name: Annotated[str, typer.Option("--robot", metavar="ROBOT", help="The robot it asks about.")],
    output: Annotated[
        str | None, output_option("Where to write; ./exercises/COURSE/NAME.yaml by default, - is stdout.")
    ] = None,
    overwrite: Overwrite = False,
) -> None:
    """Write a commented exercise file with blanks that lint points at, for you to fill in."""
    from dhcli.errors import DhcliError
    from dhcli.files.library.entries import Kind, refuse_namesake
    from dhcli.files.library.lookup import is_path, typed_path
    from dhcli.files.yaml.exercise_template import exercise_template
    from dhcli.files.yaml.robots import load_robot

    if robot_name == "-":
        raise DhcliError("an exercise names its robot, and standard input has no name", "save it: --robot ./arm.yaml")
    path = Path(output or f"exercises/{name}.yaml")
    refuse_namesake(Kind.EXERCISES, name)
    robot = load_robot(robot_name)
    called = robot_name
    if robot.path is not None and is_path(Kind.ROBOTS, robot_name):
        called = Path(os.path.relpath(robot.path, "." if output == "-" else path.parent)).as_posix()
    text = exercise_template(name, robot, called)
    _write(text, output, path, f"fill in what is empty, then dhcli lint {typed_path(path)}", overwrite=overwrite)


@new.command(cls=One, epilog="dhcli new linkage my-press --form joints")
def linkage(
    name: Annotated[str, typer.Argument(metavar="NAME", help="Name of the linkage.")],
    form: Annotated[str, typer.Option(metavar="FORM", help="joints, bars, chain or loop.")] = "joints",
    output: Annotated[
        str | None, output_option("Where to write; ./robots/linkages/NAME.yaml by default, - is stdout.")
    ] = None,
    overwrite: Overwrite = False,
) -> None:
    """Write a commented linkage file that loads, for you to change."""
    from dhcli.files.library.entries import Kind, refuse_namesake
    from dhcli.files.library.lookup import typed_path
    from dhcli.files.yaml.linkage_template import linkage_template

    text = linkage_template(name, form)
    refuse_namesake(Kind.LINKAGES, name)
    path = Path(output or f"robots/linkages/{name}.yaml")
    asked = name if output is None else typed_path(path)
    _write(text, output, path, f"dhcli show {asked}, then dhcli dof {asked}", overwrite=overwrite)


def _write(text: str, output: str | None, path: Path, then: str, *, overwrite: bool) -> None:
    """Write a new file, and tell what to do next.

    Args:
        text: What is in it.
        output: What was typed: `-` is stdout, and None the usual place, whose folders are made.
        path: Where to write it.
        then: What to do next.
        overwrite: Whether it may be overwritten.
    """
    from dhcli.cli.shell.console import tell, write_out
    from dhcli.cli.shell.delivery import make_folder, write_file
    from dhcli.render.endings import check_ending

    if output == "-":
        write_out(text)
        return
    check_ending(output, "yaml")
    if output is None:
        for folder in reversed(path.parents):
            make_folder(folder)
    write_file(path, text, overwrite=overwrite)
    tell(f"wrote {path}")
    tell(f"next: {then}")
