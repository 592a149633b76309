"""`dhcli show`: a robot's table, a linkage's joints, an exercise's task."""

from __future__ import annotations

from dhcli.cli.options import Force, Format, Output, RobotName

EXAMPLES = """
[bold]Examples[/]

dhcli show puma560

dhcli show puma560 --format latex
"""


def show(name: RobotName, format_: Format = None, output: Output = None, force: Force = False) -> None:
    """Show a robot's table, a linkage's joints or an exercise's task, and where it comes from."""
    from dhcli.cli.delivery import Delivery
    from dhcli.files.kinds import kind_of

    delivery = Delivery("show", format_, output=output, force=force)
    kind = kind_of(name).noun
    delivery.chosen(kind)
    delivery.hand_over(kind, _load(kind, name))


def _load(kind: str, name: str) -> object:
    if kind == "exercise":
        from dhcli.files.exercises import load_exercise

        return load_exercise(name)
    if kind == "linkage":
        from dhcli.files.linkages import load_linkage

        return load_linkage(name)
    from dhcli.files.robots import load_robot

    return load_robot(name)
