"""The figure of a linkage: flat, in space, or as a graph where no points are known."""

from __future__ import annotations

import math
from dataclasses import replace

from dhcli.errors import DhcliError
from dhcli.mobility.linkage import Linkage
from dhcli.scene.choice import best_view
from dhcli.scene.ink import Ink
from dhcli.scene.labels import Wish, placed
from dhcli.scene.overlay import hatching
from dhcli.scene.places import check_count
from dhcli.scene.plane import plane_figure
from dhcli.scene.shapes import Figure, Shape, Text, hull, ring
from dhcli.scene.space import space_scene
from dhcli.scene.staging import Paper, Staged, figure_of, foot
from dhcli.scene.vectors import Flat
from dhcli.scene.words import Run

PIN = 11.0


def linkage_figure(
    linkage: Linkage,
    *,
    view: tuple[float, float] | None = None,
    paper: Paper | None = None,
    worksheet: bool = False,
) -> Figure:
    """The figure of a linkage.

    Args:
        linkage: The linkage.
        view: Azimuth and elevation, in space [deg]; the best view by default.
        paper: What it is drawn on.
        worksheet: Whether names are left out, and the numbers of links and joints with them.

    Raises:
        LinkageError: It has too many links for a picture.
    """
    paper = paper or Paper()
    caption = "" if worksheet else caption_of(linkage)
    if not linkage.is_placed:
        note = " · ".join(filter(None, (caption, "no points are known: links and joints only")))
        return replace(graph_figure(linkage, paper, foot(linkage.title, note, paper)), caption=note)
    if linkage.space.is_planar:
        if view is not None:
            raise DhcliError(f"{linkage.name or 'it'} is planar: there is one view of it", "leave the view out")
        drawn = plane_figure(linkage, paper, foot(linkage.title, caption, paper), worksheet=worksheet)
        return replace(drawn, caption=caption)
    staged = replace(stage_linkage(linkage, view), caption=caption)
    return figure_of(staged, paper, worksheet=worksheet)


def stage_linkage(linkage: Linkage, view: tuple[float, float] | None) -> Staged:
    """A linkage in space, ready to be drawn."""
    scene = space_scene(linkage)
    return Staged(scene, view or best_view(scene), linkage.title, caption_of(linkage), None)


def caption_of(linkage: Linkage) -> str:
    """Name, links and joints in one line."""
    name = f"{linkage.name} · " * (linkage.name != linkage.title)
    return f"{name}{len(linkage.links)} links, {linkage.pattern}"


def graph_figure(linkage: Linkage, paper: Paper, caption: list[Text]) -> Figure:
    """Links as bars in a row or around a ring, each joint a circle with its letter.

    Raises:
        LinkageError: There are too many links for a picture.
    """
    check_count(linkage)
    middles = _spots(linkage, paper)
    shapes: list[Shape] = []
    wishes: list[Wish] = []
    pairs: dict[frozenset[str], int] = {}
    for joint in linkage.joints:
        (x1, y1), (x2, y2) = (middles[link] for link in joint.links)
        number = pairs[frozenset(joint.links)] = pairs.get(frozenset(joint.links), -1) + 1
        length = math.dist((x1, y1), (x2, y2)) or 1.0
        aside = 26 * ((number + 1) // 2) * (-1) ** number
        x, y = (x1 + x2) / 2 - (y2 - y1) / length * aside, (y1 + y2) / 2 + (x2 - x1) / length * aside
        shapes += [Shape(((x1, y1), (x, y)), "edge"), Shape(((x, y), (x2, y2)), "edge")]
        shapes.append(Shape(ring((x, y), PIN, 24), "pin", closed=True))
        letter = joint.pair.letter or joint.pair.name
        wishes.append(Wish(((x, y),), (Run(letter),), "number", (0.4, -1.0)))
    for link, (x, y) in middles.items():
        ends = (x - 17, y), (x + 17, y)
        shapes.append(Shape(hull([p for end in ends for p in ring(end, 7.5, 20)]), "bar", closed=True))
        if link == linkage.ground:
            shapes += hatching((x - 24, y + 7.5), (x + 24, y + 7.5), 9.0)
        wishes.append(Wish(((x, y - 6), (x, y + 18)), (Run(link),), "dim", (0.0, -1.0)))
    ink = Ink(paper.width, paper.height)
    ink.add(shapes)
    leaders, texts = placed(wishes, ink, paper.room, paper.lettering)
    return Figure(paper.width, paper.height, (*shapes, *leaders), (*texts, *caption), linkage.title)


def _spots(linkage: Linkage, paper: Paper) -> dict[str, Flat]:
    """A place for each link: in rows of one length for an open chain, around a ring otherwise."""
    links, count = linkage.links, len(linkage.links)
    width, height = paper.width - 2 * paper.margin, paper.height - paper.foot - 2 * paper.margin
    top = paper.margin + 10
    if not linkage.loops:
        rows = math.ceil(count / max(2, int(width / 130)))
        a_row = math.ceil(count / rows)
        spots = {}
        for i, link in enumerate(links):  # there and back again, so that neighbours stay neighbours
            row, column = divmod(i, a_row)
            column = a_row - 1 - column if row % 2 else column
            spots[link] = (paper.margin + width * (column + 0.5) / a_row, top + height * (row + 0.5) / rows)
        return spots
    turns = [2 * math.pi * i / count + math.pi / 2 for i in range(count)]
    x, y = paper.width / 2, top + height / 2
    return {
        link: (x + 0.46 * width * math.cos(t), y + 0.42 * height * math.sin(t))
        for link, t in zip(links, turns, strict=True)
    }
