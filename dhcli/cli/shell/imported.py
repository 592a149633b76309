"""A file of others, as the text of a robot file; what was taken for what is told."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from dhcli.files.foreign.importing import Wish


def imported(path: str, wish: Wish) -> str:
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

    robot = import_robot(read_text(path, limit=XML_LIMIT), source_of(path), wish)
    for remark in robot.remarks:
        tell(f"note: {remark}")
    if lacking := [name for name, value in robot.parameters.items() if value is None]:
        tell(f"note: {', '.join(lacking)} {'has' if len(lacking) == 1 else 'have'} no value yet, see parameters:")
    return robot_text(robot)
