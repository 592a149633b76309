"""A robot with values in the place of its lengths."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from dhcli.errors import RobotError
from dhcli.kinematics.forward import link_with, put_in
from dhcli.kinematics.robot import Robot, Value
from dhcli.notation.walk import symbols


def with_values(robot: Robot, values: Mapping[str, Value]) -> Robot:
    """The robot with exact values in the place of lengths and constant angles; they are no parameters of it."""
    base, tool = put_in(robot.base, values), put_in(robot.tool, values)
    links = tuple(link_with(link, values, robot.convention) for link in robot.links)
    tools = {name: put_in(chain, values) for name, chain in robot.tools.items()}
    left = {name: value for name, value in robot.parameters.items() if name not in values}
    derived = {name: how for name, how in robot.derived.items() if symbols(how.expr) | {name} <= left.keys()}
    return replace(robot, links=links, base=base, tool=tool, tools=tools, parameters=left, derived=derived)


def in_numbers(robot: Robot) -> Robot:
    """The robot with the values of its lengths in their place.

    Raises:
        RobotError: A length has no value.
    """
    if lacking := [name for name, value in robot.parameters.items() if value is None]:
        raise RobotError(
            f"{', '.join(lacking)} {'has' if len(lacking) == 1 else 'have'} no value",
            "numbers need one: --set NAME=VALUE",
        )
    return with_values(robot, {name: value for name, value in robot.parameters.items() if value is not None})
