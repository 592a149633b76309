"""Several figures on one sheet: in rows, or the moments of a motion as a film strip."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

from dhcli.scene.motion import SHRUNK, Motion
from dhcli.scene.shapes import Figure, Shape, Text
from dhcli.scene.staging import LARGEST_DRUM, Paper, foot
from dhcli.scene.vectors import Flat
from dhcli.scene.words import Run

PANEL = (460.0, 380.0)
"""Width and height of a figure that stands beside others [px]."""

MOST_ABREAST = 3
MOMENTS = 5
"""Pictures of a strip."""

CELL, HIGH = 250.0, 316.0
SMALL = 10.5
"""Height of the joint values under a moment [px]; what is too long for its cell is written smaller."""


def on_one_sheet(figures: Sequence[Figure], title: str = "") -> Figure:
    """Figures of one size in rows, as wide as high as far as that goes."""
    abreast = min(MOST_ABREAST, math.ceil(math.sqrt(len(figures))))
    wide, high = max(f.width for f in figures), max(f.height for f in figures)
    shapes: list[Shape] = []
    texts: list[Text] = []
    for number, figure in enumerate(figures):
        by = wide * (number % abreast), high * (number // abreast)
        shapes += [moved(shape, by) for shape in figure.shapes]
        texts += [replace(text, at=(text.at[0] + by[0], text.at[1] + by[1])) for text in figure.texts]
    rows = math.ceil(len(figures) / abreast)
    caption = " · ".join(figure.title for figure in figures)
    return Figure(wide * abreast, high * rows, tuple(shapes), tuple(texts), title, caption)


def moved(shape: Shape, by: Flat) -> Shape:
    """A shape in another place."""

    def there(point: Flat) -> Flat:
        return point[0] + by[0], point[1] + by[1]

    shade = (there(shape.shade[0]), there(shape.shade[1])) if shape.shade else None
    return replace(shape, points=tuple(map(there, shape.points)), shade=shade)


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
