"""`dhcli show`: a robot's table, with units and joint types."""

from __future__ import annotations

from dhcli.cli.options import Force, Format, Output, RobotName

EXAMPLES = """
[bold]Examples[/]

dhcli show puma560

dhcli show puma560 --format latex
"""


def show(name: RobotName, format_: Format = None, output: Output = None, force: Force = False) -> None:
    """Show a robot: its table, joints, limits, parameters, poses, and where the numbers come from."""
    from dhcli.cli.delivery import Delivery
    from dhcli.cli.quiz import names_exercise
    from dhcli.files.exercises import load_exercise
    from dhcli.files.robots import load_robot

    delivery = Delivery("show", format_, output=output, force=force)
    kind, load = ("exercise", load_exercise) if names_exercise(name) else ("robot", load_robot)
    delivery.chosen(kind)
    delivery.hand_over(kind, load(name))
