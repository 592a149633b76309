"""`dhcli show`: a robot's table, a linkage's joints, an exercise's task."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, cast

import typer

from dhcli.cli.shell.chosen import Chosen
from dhcli.cli.shell.options import AnyName, Variant
from dhcli.cli.shell.spreading import But
from dhcli.cli.shell.written import Written, in_formats
from dhcli.errors import DhcliError

if TYPE_CHECKING:
    from dhcli.kinematics.robot import Robot
    from dhcli.mobility.linkage import Linkage

EXAMPLES = """
[bold]Examples[/]

dhcli show puma560

dhcli show puma560 --format latex

dhcli show planar-in-numbers --variant alice

dhcli show planar-in-numbers -o task.md
"""


def show(
    chosen: Annotated[
        Chosen,
        But(without=("q", "deg", "pose", "set_", "motors", "from_", "to", "tool"), instead={"robot": AnyName}),
    ],
    variant: Variant = None,
    *,
    out: Annotated[
        Written, in_formats(("table", "json", "latex", "csv", "md"), (".json", ".tex", ".csv", ".md", ".txt"))
    ],
    draw: Annotated[bool, typer.Option("--draw", help="With a picture under it, in letters.")] = False,
) -> None:
    """Show a robot's table, a linkage's joints or an exercise's task, and where it comes from."""
    from dhcli.files.library.kinds import kind_of

    name = chosen.robot
    kind = kind_of(name).noun
    delivery = out.delivery("show", kind)
    ends = {"--base": chosen.base, "--tip": chosen.tip, "--as-typed": chosen.as_typed or None}
    if kind != "robot" and (given := [option for option, value in ends.items() if value is not None]):
        raise DhcliError(f"{' and '.join(given)} choose links of a URDF, and {name} is no robot", "leave them out")
    result = _load(kind, chosen, variant)
    if draw and (kind == "exercise" or delivery.chosen(kind) != "table" or out.output is not None):
        raise DhcliError("--draw puts a picture under the table of a robot or a linkage", "dhcli draw writes files")
    delivery.hand_over(kind, result, _said(cast("Robot", result)) if kind == "robot" else ())
    if draw:
        from dhcli.cli.shell.drawn import find

        _draw(cast("Robot", result) if kind == "robot" else find(chosen))


def _said(robot: Robot) -> tuple[str, ...]:
    """What was taken for something else when a robot was read, and lengths that no arm has."""
    from dhcli.lint.lengths import told_once

    return (*robot.remarks, *told_once(robot))


def _draw(what: Robot | Linkage) -> None:
    """The picture of a robot or a linkage, on standard output."""
    import sys

    from dhcli.cli.shell.console import write_out
    from dhcli.render.paper import Paper
    from dhcli.render.pictures.picture import Picture

    write_out("\n" + Picture(what).terminal(Paper.of(sys.stdout)))


def _load(kind: str, chosen: Chosen, variant: str | None) -> object:
    name = chosen.robot
    if kind == "exercise":
        from dhcli.checking.judge import Judge
        from dhcli.checking.variants import variant_of
        from dhcli.files.yaml.exercises import load_exercise

        return variant_of(Judge(load_exercise(name)), variant).exercise
    if variant is not None:
        raise DhcliError(f"{name} is a {kind}: only exercises have variants", "leave --variant out")
    if kind == "linkage":
        from dhcli.files.yaml.linkages import load_linkage

        return load_linkage(name)
    from dhcli.cli.shell.given import robot_of
    from dhcli.errors import UnknownNameError

    try:
        return robot_of(chosen)
    except UnknownNameError as error:
        if chosen.base is not None or chosen.tip is not None:
            raise  # it may be a link that is not known
        from dhcli.files.library.entries import Kind
        from dhcli.files.library.near import unknown

        raise unknown(name, tuple(Kind), error) from None
