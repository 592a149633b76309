"""A robot as SVG: our figure beside one that is plotted with matplotlib, with size and labels that overlap of both."""

from __future__ import annotations

import io
from collections.abc import Iterator
from dataclasses import replace
from importlib.util import find_spec
from itertools import combinations
from xml.etree import ElementTree as ET

from measure import Row, Task, side_by_side

from dhcli import Robot, draw, forward, load_robot
from dhcli.scene.choice import best_pose, with_examples
from dhcli.scene.labels import PRINT
from dhcli.scene.shapes import Figure

ROBOTS = ("planar-2r", "stanford", "puma560", "panda")
PEER = "matplotlib, lines and arrows"


def rows(rounds: int, robots: tuple[str, ...] = ROBOTS) -> Iterator[Row]:
    """A row for each robot; what is imported is imported before."""
    for robot in map(load_robot, robots):
        work = f"figure of {robot.name}"
        if find_spec("matplotlib") is None:
            yield Row(work, "draw", PEER)
            continue
        found: list[str] = []

        def same(ours: str, theirs: tuple[str, int], robot: Robot = robot, found: list[str] = found) -> bool:
            count = overlaps(draw(robot).figure())
            found.append(f"{len(ours) // 1000} kB, {len(theirs[0]) // 1000} kB; {count} and {theirs[1]} labels overlap")
            return all(ET.fromstring(text).tag.endswith("svg") for text in (ours, theirs[0]))  # noqa: S314  our own

        row = side_by_side(
            work,
            Task("draw", lambda robot=robot: draw(robot).svg()),
            Task(PEER, lambda robot=robot: plotted(robot)),
            same,
            rounds=rounds,
        )
        yield replace(row, note=found[0])


def overlaps(figure: Figure) -> int:
    """How many pairs of our labels overlap."""
    boxes = []
    for text in figure.texts:
        if text.look != "caption":
            (wide, high), (x, y) = PRINT.box(text.words), text.at
            boxes.append((x - wide / 2, y - 0.26 * text.size - high / 2, wide, high))
    return sum(_meet(a, b) for a, b in combinations(boxes, 2))


def plotted(robot: Robot) -> tuple[str, int]:
    """The same frames with the same names, as a person plots them: the SVG, and pairs of labels that overlap."""
    import matplotlib as mpl

    mpl.use("svg")
    from matplotlib import pyplot as plt

    full, _ = with_examples(robot, {})
    q = best_pose(robot, full)[1]
    frames = [forward(robot, q, end=name, parameters=full).rows for name in robot.frames[1:-1]]
    paper = plt.figure(figsize=(8.2, 6.4))
    axes = paper.add_subplot(projection="3d")
    axes.plot(*zip(*((rows[0][3], rows[1][3], rows[2][3]) for rows in frames), strict=True), "k-o", linewidth=3)
    size = 0.2 * max(abs(rows[i][3]) for rows in frames for i in range(3))
    for number, rows in enumerate(frames):
        for column, letter, colour in ((0, "x", "red"), (2, "z", "blue")):
            start, way = [rows[i][3] for i in range(3)], [size * rows[i][column] for i in range(3)]
            axes.quiver(*start, *way, color=colour)
            tip = [a + b for a, b in zip(start, way, strict=True)]
            axes.text(*tip, f"${letter}_{{{number}}}$", color=colour)
    axes.set_aspect("equal")
    axes.set_axis_off()
    stream = io.StringIO()
    paper.savefig(stream, format="svg")
    boxes = [text.get_window_extent().bounds for text in axes.texts]
    plt.close(paper)
    return stream.getvalue(), sum(_meet(a, b) for a, b in combinations(boxes, 2))


def _meet(a: tuple[float, ...], b: tuple[float, ...]) -> bool:
    return a[0] < b[0] + b[2] and b[0] < a[0] + a[2] and a[1] < b[1] + b[3] and b[1] < a[1] + a[3]
