"""The figure of a linkage: flat, in space, or as a graph where no points are known."""

from __future__ import annotations

from dataclasses import replace

from dhcli.errors import DhcliError
from dhcli.mobility.linkage import Linkage
from dhcli.scene.choice import best_view
from dhcli.scene.graph import graph_figure
from dhcli.scene.plane import plane_figure
from dhcli.scene.shapes import Figure
from dhcli.scene.space import space_scene
from dhcli.scene.staging import Paper, Staged, figure_of, foot


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
    return f"{linkage.name} · {len(linkage.links)} links, {linkage.pattern}"
