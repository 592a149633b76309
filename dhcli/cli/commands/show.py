"""`dhcli show`: a robot's table, a linkage's joints, an exercise's task."""

from __future__ import annotations

from typing import Annotated

from dhcli.cli.shell.options import Force, RobotName, Variant, format_option, output_option
from dhcli.errors import DhcliError

EXAMPLES = """
[bold]Examples[/]

dhcli show puma560

dhcli show puma560 --format latex

dhcli show planar-in-numbers --variant alice
"""


def show(
    name: RobotName,
    variant: Variant = None,
    format_: Annotated[str | None, format_option("table", "json", "latex", "csv")] = None,
    output: Annotated[str | None, output_option(".json", ".tex", ".csv", ".txt")] = None,
    force: Force = False,
) -> None:
    """Show a robot's table, a linkage's joints or an exercise's task, and where it comes from."""
    from dhcli.cli.shell.delivery import Delivery
    from dhcli.files.library.kinds import kind_of

    delivery = Delivery("show", format_, output=output, force=force)
    kind = kind_of(name).noun
    delivery.chosen(kind)
    delivery.hand_over(kind, _load(kind, name, variant))


def _load(kind: str, name: str, variant: str | None) -> object:
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
    from dhcli.files.yaml.robots import load_robot

    return load_robot(name)
