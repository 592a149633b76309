"""A motion as a film strip: the arm at a few moments, side by side, with the way of its end."""

from __future__ import annotations

from dhcli.scene.motion import SHRUNK, Motion
from dhcli.scene.panels import moved
from dhcli.scene.shapes import Figure, Shape, Text
from dhcli.scene.staging import LARGEST_DRUM, Paper, foot
from dhcli.scene.words import Run

MOMENTS = 5
"""Pictures of a strip."""

CELL, HIGH = 250.0, 316.0
SMALL = 10.5
"""Height of the joint values under a moment [px]; what is too long for its cell is written smaller."""


def strip_figure(motion: Motion) -> Figure:
    """The film strip of a motion."""
    last = len(motion.scenes) - 1
    shown = sorted({round(k * last / (MOMENTS - 1)) for k in range(MOMENTS)})
    paper = Paper(CELL * len(shown), HIGH)
    camera = motion.camera((14.0, 34.0, CELL - 14.0, HIGH - paper.foot - 28.0), LARGEST_DRUM * SHRUNK)
    shapes: list[Shape] = []
    texts: list[Text] = []
    for k, moment in enumerate(shown):
        shapes += [moved(shape, (k * CELL, 0.0)) for shape in motion.shapes(moment, camera)]
        texts.append(Text(((k + 0.5) * CELL, 22.0), (Run(str(k + 1)),), "number", 15.0))
        said = motion.values[moment] if motion.values else ""
        size = min(SMALL, (CELL - 12.0) / (0.53 * max(len(said), 1)))
        texts.append(Text(((k + 0.5) * CELL, HIGH - paper.foot - 12.0), (Run(said),), "number", size))
    shapes += [Shape(((k * CELL, 8.0), (k * CELL, HIGH - paper.foot)), "extension") for k in range(1, len(shown))]
    title = motion.robot.title
    texts += foot(title, motion.caption, paper)
    return Figure(paper.width, paper.height, tuple(shapes), tuple(texts), title, motion.caption)
