"""Figures that follow each other as one SVG that moves by itself, without a script."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from dhcli.render.pictures.svg import svg
from dhcli.scene.shapes import Figure, Shape

SECONDS, REST = 3.0, 8
"""How long a round takes, and for how many moments the last one stays."""

MARK = Shape(((0.0, 0.0),), "moment")
"""Stands before the shapes of each moment."""


def animated(figures: Sequence[Figure], *, dark: bool = False, size: tuple[int, int] | None = None) -> str:
    """The text of an SVG file that shows one figure after the other, over and over.

    Where nothing may move, because the reader has asked for that or cannot, the last one is shown.

    Args:
        figures: The moments, all of one size; the texts of the first stay.
        dark: Whether it is dark always.
        size: Width and height at which it is shown [px].
    """
    shapes = [shape for figure in figures for shape in (MARK, *figure.shapes)]
    text = svg(replace(figures[0], shapes=tuple(shapes)), dark=dark, size=size)
    before, *groups = text.split('<path class="moment" d="M0 0"/>\n')
    last, _, texts = groups[-1].partition("<g ")
    groups[-1] = last
    slots = len(figures) + REST
    part = 100 / slots
    key = before.partition('class="')[2].partition('"')[0]
    rules = (
        f"@media (prefers-reduced-motion:no-preference){{.{key} .m{{animation:{key}m {SECONDS}s step-end infinite}}"
        f".{key} .e{{animation:{key}e {SECONDS}s step-end infinite}}}}"
        f"@keyframes {key}m{{0%{{visibility:visible}}{part:.3f}%{{visibility:hidden}}}}"
        f"@keyframes {key}e{{0%{{visibility:visible}}{part * (REST + 1):.3f}%{{visibility:hidden}}}}"
    )
    found = []
    for number, group in enumerate(groups):
        is_last = number == len(groups) - 1
        delay = f"animation-delay:{SECONDS * (number / slots - 1):.3f}s"
        hidden = "" if is_last else ' visibility="hidden"'
        found.append(f'<g class="{"e" if is_last else "m"}" style="{delay}"{hidden}>\n{group}</g>\n')
    return before.replace("</style>", f"{rules}</style>", 1) + "".join(found) + f"<g {texts}"
