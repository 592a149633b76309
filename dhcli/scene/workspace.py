"""The workspace of a robot on paper: from two sides, or one; darker where more poses lead, with the arm in it."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from typing import NamedTuple

from dhcli.geometry.vectors import Vector
from dhcli.kinematics.sweep.workspace import Counts, Workspace
from dhcli.scene.camera import VIEWS, Camera
from dhcli.scene.painter import painted
from dhcli.scene.panels import on_one_sheet
from dhcli.scene.primitives import Scene
from dhcli.scene.shapes import Figure, Shape, Text
from dhcli.scene.staging import Paper, Staged, extent, foot
from dhcli.scene.vectors import WORLD, Flat
from dhcli.scene.words import Run, spelled

FLAT = 0.05
"""Points that go less far along an axis, in parts of the farthest, are seen along that axis alone."""

WIDER = 1.5
"""From the front, not from the side, are seen points that go so much farther along y than along x."""

LEVELS = 5
"""Shades of density."""

PANEL, ALONE = (520.0, 520.0), (680.0, 640.0)
"""Width and height of a view beside another, and of one by itself [px]."""

ROOM = 46.0
SEAM = 0.3
"""What one rectangle reaches over the next, so that no line is seen between them [px]."""

TICKS = 4

MOST, FEWEST, HOLES = 64, 16, 0.03
"""Cells on a side at the most and at the least; and empty ones between full ones, in parts of these, from which cells
are made larger: then they are finer than the grid of poses."""


class View(NamedTuple):
    """One view of the points."""

    name: str
    right: str
    up: str
    counts: Counts

    def place(self, right: float, up: float) -> Vector:
        """A point of the plane that is seen, in space."""
        at = {self.right: right, self.up: up}
        return at.get("x", 0.0), at.get("y", 0.0), at.get("z", 0.0)


def workspace_figure(staged: Staged, workspace: Workspace) -> Figure:
    """The points from the side and from above, with axes in metres; points of a plane from where that is seen whole."""
    views = [view._replace(counts=_without_holes(view.counts)) for view in views_of(workspace)]
    paper = Paper(*(PANEL if len(views) > 1 else ALONE))
    shown = is_at_base(staged.scene, workspace)
    arm = replace(staged.scene, arrows=(), dimensions=()) if shown else None
    cameras = [_camera(view, arm, workspace, paper) for view in views]
    scale = min(camera.scale for camera in cameras)
    figures = []
    for view, fitted in zip(views, cameras, strict=True):
        camera = _scaled(fitted, scale)
        cells = sorted(_cells(view, workspace.half, camera), key=lambda shape: shape.look)
        shapes = [*cells, *_axes(camera, paper)]
        if arm is not None:
            shapes += painted(arm, camera, turns=False)
        told = f"{view.name}: {view.right} and {view.up} in metres"
        texts = [*_marks(camera, view.right, view.up, paper), *foot(told, "", paper)]
        figures.append(Figure(paper.width, paper.height, tuple(shapes), tuple(texts), staged.title))
    sheet = on_one_sheet(figures, staged.title)
    what = f"frame {workspace.frame}, seen from frame {workspace.reference}"
    caption = f"{workspace.count:,} poses of {what}; darker where more of them lead · {staged.caption}"
    low = Paper(sheet.width, sheet.height + paper.foot)
    return replace(sheet, height=low.height, texts=(*sheet.texts, *foot(staged.title, caption, low)), caption=caption)


def views_of(workspace: Workspace) -> list[View]:
    """From where the points are seen: from above and from a side; along an axis alone along which they hardly go.

    The side is the one from which they go farther; x is to the right unless y goes clearly farther.
    """
    side, top, front = (
        View("side", "x", "z", workspace.side),
        View("top", "x", "y", workspace.top),
        View("front", "y", "z", workspace.front),
    )
    x, y, z = workspace.extents
    if min(x, y, z) < FLAT * max(x, y, z):
        return [min((z, top), (y, side), (x, front), key=lambda one: one[0])[1]]
    return [front if y > WIDER * x else side, top]


def is_at_base(scene: Scene, workspace: Workspace) -> bool:
    """Whether the points are seen from where the arm is drawn: its base, and no base before it."""
    return scene.states[0] == WORLD and workspace.reference in ("0", "base") and bool(scene.rods or scene.solids)


def _camera(view: View, arm: Scene | None, workspace: Workspace, paper: Paper) -> Camera:
    """Everything on paper: the cells that were reached, and the arm."""
    counts = view.counts
    size = 2 * workspace.half / len(counts)
    rows = [j for j, row in enumerate(counts) if any(row)]
    columns = [i for row in counts for i, count in enumerate(row) if count]
    corners = [
        view.place(i * size - workspace.half, j * size - workspace.half)
        for i in (min(columns, default=0), max(columns, default=0) + 1)
        for j in (min(rows, default=0), max(rows, default=0) + 1)
    ]
    points = corners + (extent(arm) if arm is not None else [])
    room = (ROOM, ROOM * 0.6, paper.width - ROOM * 0.6, paper.height - paper.foot - ROOM)
    return Camera.at(*VIEWS[view.name]).fitted(points, room, math.inf)


def _scaled(camera: Camera, scale: float) -> Camera:
    """The same middle at another scale."""
    part = scale / camera.scale
    return replace(camera, scale=scale, centre=(camera.centre[0] * part, camera.centre[1] * part))


def _cells(view: View, half: float, camera: Camera) -> Iterator[Shape]:
    """Cells of one shade that follow each other in a row, as one rectangle."""
    counts = view.counts
    shades = _shades(counts)
    size = 2 * half / len(counts)
    for j, row in enumerate(counts):
        start, level = 0, 0
        for i, count in enumerate((*row, 0)):
            here = sum(count >= least for least in shades)
            if here == level:
                continue
            if level:
                left, low = camera.flat(view.place(start * size - half, j * size - half))
                right, high = camera.flat(view.place(i * size - half, (j + 1) * size - half))
                corners = ((left, low + SEAM), (right + SEAM, low + SEAM), (right + SEAM, high), (left, high))
                yield Shape(corners, f"density-{level}", closed=True)
            start, level = i, here


def _without_holes(counts: Counts) -> Counts:
    """Cells as small as the grid of poses fills them, seen from this side."""
    while len(counts) > MOST or (len(counts) > FEWEST and _holes(counts) > HOLES):
        counts = _coarser(counts)
    return counts


def _holes(counts: Counts) -> float:
    """How many empty cells have full ones at both sides, in parts of the full ones."""
    full = sum(bool(count) for row in counts for count in row)
    holes = 0
    for j in range(1, len(counts) - 1):
        below, row, above = counts[j - 1 : j + 2]
        for i in range(1, len(row) - 1):
            holes += not row[i] and bool((row[i - 1] and row[i + 1]) or (below[i] and above[i]))
    return holes / max(full, 1)


def _coarser(counts: Counts) -> Counts:
    """Four cells as one."""
    pairs = zip(counts[::2], counts[1::2], strict=True)
    return tuple(
        tuple(a + b + c + d for a, b, c, d in zip(low[::2], low[1::2], high[::2], high[1::2], strict=True))
        for low, high in pairs
    )


def _shades(counts: Counts) -> list[int]:
    """The least count of each shade: about as many cells in each of them."""
    full = sorted(count for row in counts for count in row if count)
    return [1, *(full[len(full) * k // LEVELS] for k in range(1, LEVELS))] if full else []


def _step(camera: Camera, paper: Paper) -> float:
    """A round number of metres between marks."""
    rough = paper.width / camera.scale / TICKS
    power = 10.0 ** math.floor(math.log10(rough))
    return next(power * factor for factor in (1, 2, 5, 10) if power * factor >= rough * 0.7)


def _ends(paper: Paper) -> tuple[float, float, float, float]:
    """Left, top, right and bottom of the panel inside its axes [px]."""
    return ROOM, ROOM * 0.6, paper.width - ROOM * 0.6, paper.height - paper.foot - ROOM


def _axes(camera: Camera, paper: Paper) -> Iterator[Shape]:
    """A frame with short marks, and lines through the origin."""
    left, top, right, low = _ends(paper)
    yield Shape(((left, top), (left, low), (right, low)), "ground-line")
    for at, _ in _values(camera, paper, 0, left, right):
        yield Shape(((at, low), (at, low + 5)), "ground-line")
    for at, _ in _values(camera, paper, 1, top, low):
        yield Shape(((left - 5, at), (left, at)), "ground-line")
    x, y = camera.flat((0.0, 0.0, 0.0))
    if left < x < right:
        yield Shape(((x, top), (x, low)), "extension")
    if top < y < low:
        yield Shape(((left, y), (right, y)), "extension")


def _values(camera: Camera, paper: Paper, axis: int, start: float, end: float) -> Iterator[tuple[float, float]]:
    """Where round numbers are along an axis of the paper, and the numbers."""
    step, origin = _step(camera, paper), camera.flat((0.0, 0.0, 0.0))[axis]
    sign = -1 if axis else 1
    for k in range(-200, 201):
        at = origin + sign * k * step * camera.scale
        if start <= at <= end:
            yield at, k * step


def _marks(camera: Camera, right_name: str, up: str, paper: Paper) -> Iterator[Text]:
    left, top, right, low = _ends(paper)
    size = 12.0

    def text(at: Flat, words: str, look: str = "number") -> Text:
        return Text(at, spelled(words), look, size)

    for at, value in _values(camera, paper, 0, left, right - 14):
        yield text((at, low + 19), f"{value:.6g}")
    for at, value in _values(camera, paper, 1, top + 12, low):
        yield text((left - 22, at + 4), f"{value:.6g}")
    yield Text((right, low + 19), (Run(right_name),), "mark", 14.0)
    yield Text((left - 22, top + 6), (Run(up),), "mark", 14.0)
