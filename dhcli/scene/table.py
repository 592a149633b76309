"""The DH table beside a figure."""

from __future__ import annotations

from dataclasses import replace

from dhcli.kinematics.conventions import COLUMNS, LETTERS, Convention
from dhcli.kinematics.robot import Link, Robot
from dhcli.notation.writer import write_value
from dhcli.regex import regex
from dhcli.scene.labels import PRINT
from dhcli.scene.shapes import Figure, Shape, Text
from dhcli.scene.words import Run, Words, spelled

LINE, GAP = 26.0, 26.0
"""Height of a row, and room between columns [px]."""

_SIDE_BY_SIDE = regex(r"(?<=[)\]])\s*\*?\s*(?=[A-Za-z\[])")
"""Between two moves of a product, whether a star stands there or not."""


def with_table(figure: Figure, robot: Robot) -> Figure:
    """A wider figure, with the robot's table at its right: the columns of its convention, or the products."""
    rows = [heads(robot), *([(Run(str(link.number)),), *cells(robot, link)] for link in robot.links)]
    widths = [max(PRINT.box(row[i])[0] for row in rows) for i in range(len(rows[0]))]
    left, size = figure.width - 10, 15.0
    top = max(LINE, (figure.height - LINE * len(rows)) / 2)
    starts = [left + sum(widths[:i]) + GAP * i for i in range(len(widths))]
    right = starts[-1] + widths[-1] + GAP
    texts = [
        Text((start + 4, top + LINE * number), words, "cell", size)
        for number, row in enumerate(rows)
        for start, words in zip(starts, row, strict=True)
    ]
    low = top + LINE * (len(rows) - 1)
    rules = [
        Shape(((left, y), (right - GAP / 2, y)), "rule")
        for y in (top - LINE * 0.75, top + 0.35 * LINE, low + 0.35 * LINE)
    ]
    height = max(figure.height, low + 2 * LINE)
    return replace(figure, width=right, height=height, shapes=(*figure.shapes, *rules), texts=(*figure.texts, *texts))


def heads(robot: Robot) -> list[Words]:
    """What stands over the columns; the modified convention has the index before for a and α."""
    if robot.convention is Convention.PRODUCT:
        return [(Run("i"),), (Run("A"), Run("i", below=True))]
    before = "i−1" if robot.convention is Convention.MODIFIED else "i"  # noqa: RUF001  a minus sign
    found: list[Words] = [(Run("i"),)]
    for column in _columns(robot):
        index = before if column in ("a", "alpha") else "i"
        found.append((Run(LETTERS[column]), Run(index, below=True)))
    return found


def cells(robot: Robot, link: Link) -> list[Words]:
    """The cells of one link, in the order of the columns."""
    if link.row is None:
        return [spelled(_SIDE_BY_SIDE.sub(" * ", link.product))]
    return [spelled(write_value(getattr(link.row, column), "short", robot.writing)) for column in _columns(robot)]


def _columns(robot: Robot) -> tuple[str, ...]:
    return tuple(column for column in robot.columns if column in COLUMNS)
