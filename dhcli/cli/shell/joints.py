"""Joint values as they are typed behind an option: in place, or in a file, which may have a header."""

from __future__ import annotations

import re

from dhcli.errors import DhcliError, Place, Problem, RobotError, plural
from dhcli.kinematics.robot import Robot, Value
from dhcli.kinematics.values import joint_called, joint_values
from dhcli.notation.brackets import split
from dhcli.notation.quantity import Bare
from dhcli.regex import regex

_ASSIGNS = regex("[=:]")
_ONE_JOINT = regex(r'"?([^\W\d]\w*)"?\s{0,20}[=:\s]\s{0,20}([-+−–.\d√π(][^=:,;]*(?:,\d[^=:,;]*)?)')  # noqa: RUF001  minus signs
"""A joint and its value in a line."""


def typed_joints(robot: Robot, text: str | None, bare: Bare, option: str = "--q") -> dict[str, Value]:
    """Values of the joints that are given.

    Args:
        robot: The robot.
        text: What was typed, `@FILE` for what stands in a file: values, assignments, a line for each joint, or a
            table of one row.
        bare: What a number without a unit means for a revolute joint.
        option: What it was typed behind.

    Raises:
        DhcliError: It cannot be read, or the file holds many rows.
    """
    if text is None or not text.startswith("@"):
        return joint_values(robot, text, bare=bare, place=Place(option))
    from dhcli.files.reading import read_text, source_of

    path = text[1:]
    place = Place(f"{option} {source_of(path)}")
    bare_lines = (line.partition("#")[0].strip().rstrip(",;") for line in read_text(path).split("\n"))
    lines = [line for line in bare_lines if line not in ("", "{", "}")]
    if all(named := [_named(robot, line) for line in lines]):
        return joint_values(robot, ", ".join(named), bare=bare, place=place)
    if len(lines) > 1 and all(line.startswith("- ") for line in lines):
        raise DhcliError(Problem("each line is a list entry, or negative", place, "write -0.5, or 0.5 without '- '"))
    if lines and _names_joints(robot, lines[0]):
        return joint_values(robot, _assigned(lines, place, path), bare=bare, place=place)
    width = len(robot.variables)
    if sum(_is_row(line, width) for line in lines) > 1:
        raise DhcliError(_many(len(lines), width, place, path))
    return joint_values(robot, ", ".join(lines), bare=bare, place=place)


def _named(robot: Robot, line: str) -> str:
    """A line with a joint and its value, `J1: 0`, `J1 0.00 deg`, as an assignment; nothing if it is none."""
    found = _ONE_JOINT.fullmatch(line)
    return f"{found[1]}={found[2].replace(',', '.')}" if found and _is_joint(robot, found[1]) else ""


def _names_joints(robot: Robot, line: str) -> bool:
    """Whether a line is the header of a table: `theta1[deg], d3 [mm]`; assignments are none."""
    return not _ASSIGNS.search(line) and any(_is_joint(robot, head) for head in re.findall(r'[^\s,;"\[(]+', line))


def _is_joint(robot: Robot, name: str) -> bool:
    try:
        return bool(joint_called(robot, name))
    except RobotError:
        return False


def _is_row(line: str, width: int) -> bool:
    return width in (len(list(split(line))), len(line.split())) and not _ASSIGNS.search(line)


def _assigned(lines: list[str], place: Place, path: str) -> str:
    """A table of one row as assignments, each value with the unit that stands over it: `theta1=30 deg, d3=100 mm`.

    Raises:
        DhcliError: It has no row or more than one, or a cell too few or too many.
    """
    from dhcli.files.rows.cells import DECIMAL_BETWEEN, cells_of, sign_between  # with numpy: few files have a header
    from dhcli.files.rows.heads import name_and_unit

    sign = sign_between(lines[0])
    heads, *rows = ([text.strip() for _, text in cells_of(line, sign)] for line in lines)
    if not rows:
        raise DhcliError(Problem("is a header without values", place))
    if len(rows) > 1:
        raise DhcliError(_many(len(rows), len(heads), place, path))
    (values,) = rows
    if len(values) != len(heads):
        message = f"{plural(len(values), 'cell')} in a table of {plural(len(heads), 'column')}"
        raise DhcliError(Problem(message, place))
    if sign in DECIMAL_BETWEEN:
        values = [value if "(" in value else value.replace(",", ".") for value in values]
    named = zip((name_and_unit(head, place) for head in heads), values, strict=True)
    return ", ".join(f"{name}={value} {unit}".rstrip() for (name, unit), value in named)


def _many(rows: int, width: int, place: Place, path: str) -> Problem:
    message = f"{plural(rows, 'row')} of {plural(width, 'value')}, and one pose is wanted"
    return Problem(message, place, f"many rows: fk --rows {path}; else leave one")
