"""Several figures on one sheet, in rows."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

from dhcli.scene.shapes import Figure, Shape, Text
from dhcli.scene.vectors import Flat

PANEL = (460.0, 380.0)
"""Width and height of a figure that stands beside others [px]."""

MOST_ABREAST = 3


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
