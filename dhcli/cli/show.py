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
    from dhcli.cli.quiz import names_exercise
    from dhcli.files.exercises import load_exercise
    from dhcli.files.robots import load_robot

    delivery = Delivery("show", format_, output=output, force=force)
    kind = "exercise" if names_exercise(name) else "linkage" if names_linkage(name) else "robot"
    delivery.chosen(kind)
    if kind == "linkage":
        from dhcli.files.linkages import load_linkage

        delivery.hand_over(kind, load_linkage(name))
    else:
        delivery.hand_over(kind, load_exercise(name) if kind == "exercise" else load_robot(name))


def names_linkage(name: str) -> bool:
    """Whether a name is that of a linkage; reads no file."""
    from dhcli.files.library import Kind, entries

    return any(entry.name == name for entry in entries(Kind.LINKAGES))
