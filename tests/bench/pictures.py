"""A robot as SVG: our figure beside those of matplotlib, of the Robotics Toolbox and of visual_kinematics.

Each row tells the size of both, and how many labels there are and how many pairs of them overlap.
"""

from __future__ import annotations

import io
from collections.abc import Callable, Iterator
from dataclasses import replace
from importlib.util import find_spec
from itertools import combinations
from typing import Any, TypeAlias
from xml.etree import ElementTree as ET

from measure import Row, Task, side_by_side
from peers import SLIDE, Link, links

from dhcli import Robot, draw, forward, load_robot
from dhcli.kinematics.conventions import Convention
from dhcli.kinematics.derived import in_floats
from dhcli.scene.choice import best_pose, with_examples
from dhcli.scene.labels import PRINT
from dhcli.scene.shapes import Figure

ROBOTS = ("planar-2r", "stanford", "puma560", "panda")

Plotted: TypeAlias = tuple[str, int, int]
"""An SVG, its labels, and the pairs of them that overlap."""


def rows(rounds: int, robots: tuple[str, ...] = ROBOTS) -> Iterator[Row]:
    """A row for each robot and peer; what is imported is imported before."""
    for robot in map(load_robot, robots):
        for peer, package, plot in PEERS:
            work = f"figure of {robot.name}"
            if find_spec(package) is None or find_spec("matplotlib") is None:
                yield Row(work, "draw", peer)
                continue
            found: list[str] = []

            def same(ours: str, theirs: Plotted, robot: Robot = robot, found: list[str] = found) -> bool:
                figure, (svg, labels, count) = draw(robot).figure(), theirs
                own = sum(text.look != "caption" for text in figure.texts)
                sizes = f"{len(ours) // 1000} kB, {len(svg) // 1000} kB"
                found.append(f"{sizes}; {own} labels, {overlaps(figure)} overlap; {labels}, {count} overlap")
                return all(ET.fromstring(text).tag.endswith("svg") for text in (ours, svg))  # noqa: S314  our own

            row = side_by_side(
                work,
                Task("draw", lambda robot=robot: draw(robot).svg()),
                Task(peer, lambda robot=robot, plot=plot: plot(robot)),
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


def plotted(robot: Robot) -> Plotted:
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
    return _saved(paper, axes.texts)


def by_toolbox(robot: Robot) -> Plotted:
    """The plot of the Robotics Toolbox, with its labels of joints."""
    from matplotlib import pyplot as plt
    from roboticstoolbox import DHRobot, PrismaticDH, PrismaticMDH, RevoluteDH, RevoluteMDH

    plt.switch_backend("svg")
    kinds = (PrismaticMDH, RevoluteMDH) if robot.convention is Convention.MODIFIED else (PrismaticDH, RevoluteDH)
    made, q = [], []
    for link, value in _at_best(robot):
        turns = link.moves != SLIDE
        own = {"d": link.d} if turns else {"theta": link.theta}
        made.append(kinds[turns](a=link.a, alpha=link.alpha, offset=link.theta if turns else link.d, **own))
        q.append(value)
        if not turns:
            made[-1].qlim = [0, max(1.0, 2 * abs(value))]
    shown = DHRobot(made, name=robot.name).plot(q, backend="pyplot", block=False, jointlabels=True, eeframe=True)
    return _saved(shown.fig, shown.ax.texts)


def by_visual_kinematics(robot: Robot) -> Plotted:
    """The plot of visual_kinematics; a joint that slides stands where it is."""
    import numpy as np
    from matplotlib import pyplot as plt
    from visual_kinematics.RobotSerial import RobotSerial

    plt.switch_backend("svg")
    table, q = [], []
    for link, value in _at_best(robot):
        slides = link.moves == SLIDE
        table.append([link.d + value * slides, link.a, link.alpha, link.theta])
        q.append(0.0 if slides else value)
    kind = "modified" if robot.convention is Convention.MODIFIED else "normal"
    arm = RobotSerial(np.array(table), dh_type=kind, plot_xlim=[-1, 1], plot_ylim=[-1, 1], plot_zlim=[-1, 1])
    arm.forward(np.array(q))
    arm.draw()
    return _saved(arm.figure, arm.ax.texts)


PEERS: tuple[tuple[str, str, Callable[[Robot], Plotted]], ...] = (
    ("matplotlib, lines and arrows", "matplotlib", plotted),
    ("Robotics Toolbox, robot.plot", "roboticstoolbox", by_toolbox),
    ("visual_kinematics, robot.draw", "visual_kinematics", by_visual_kinematics),
)


def _at_best(robot: Robot) -> Iterator[tuple[Link, float]]:
    """The rows of a table, each with the value of its joint at the pose that we draw; 0 for a fixed row."""
    full, _ = with_examples(robot, {})
    values = list(map(in_floats, best_pose(robot, full)[1].values()))
    for link in links(robot):
        yield link, values[link.joint] if link.moves else 0.0


def _saved(paper: Any, texts: Any) -> Plotted:  # noqa: ANN401  of matplotlib
    from matplotlib import pyplot as plt

    stream = io.StringIO()
    paper.savefig(stream, format="svg")
    boxes = [text.get_window_extent().bounds for text in texts if text.get_text().strip()]
    plt.close(paper)
    return stream.getvalue(), len(boxes), sum(_meet(a, b) for a, b in combinations(boxes, 2))


def _meet(a: tuple[float, ...], b: tuple[float, ...]) -> bool:
    return a[0] < b[0] + b[2] and b[0] < a[0] + a[2] and a[1] < b[1] + b[3] and b[1] < a[1] + a[3]
