"""`dhcli show`: a robot's table, with units and joint types."""

from __future__ import annotations

from dhcli.cli.options import Force, Format, Output, RobotName

EXAMPLES = """
dhcli show puma560

dhcli show puma560 --format latex
"""


def show(name: RobotName, format_: Format = None, output: Output = None, force: Force = False) -> None:
    """Show a robot: its table, joints, limits, parameters, poses, and where the numbers come from."""
    from dhcli.cli.delivery import Delivery
    from dhcli.files.robots import load_robot

    delivery = Delivery("show", format_, output=output, force=force)
    delivery.chosen("robot")
    delivery.hand_over("robot", load_robot(name))
