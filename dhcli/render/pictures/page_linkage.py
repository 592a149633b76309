"""What a page must know of a linkage: its joints with what they demand, and the points or the scene drawn."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from dhcli.geometry.vectors import Vector
from dhcli.mobility.linkage import Joint, Linkage
from dhcli.render.pictures.page_scene import scene_data, words_data
from dhcli.scene.camera import VIEWS
from dhcli.scene.linkages import stage_linkage
from dhcli.scene.places import Places
from dhcli.scene.plane import circles
from dhcli.scene.space import holder
from dhcli.scene.words import named

if TYPE_CHECKING:
    from dhcli.scene.drawing import Drawing


UNMOVED = frozenset({"gear", "rolling"})
"""Joints in space whose motion a page does not know: it only turns a linkage that has one."""


def space_model(picture: Drawing) -> dict[str, Any]:
    """A linkage in space: its scene, each part on the link that holds it, and what its joints demand."""
    linkage = picture.what
    assert isinstance(linkage, Linkage)  # noqa: S101  the caller has looked
    staged = stage_linkage(linkage, picture.view)
    views = [["best", list(staged.view)], *([name, list(view)] for name, view in VIEWS.items())]
    places = Places(linkage)
    number = {link: i for i, link in enumerate(linkage.links)}
    seen: dict[str, Any] = {
        "name": linkage.name,
        "view": list(staged.view),
        "views": views,
        "scene": scene_data(staged.scene),
        "links": list(linkage.links),
        "points": [[words_data(named(name)), list(at), number[holder(places, at)]] for name, at in places.named()],
    }
    if any(joint.pair.name in UNMOVED for joint in linkage.joints):
        return seen
    held = [list(at) for at in places.at]
    spots = [point for _, point, _ in seen["points"]]
    return {
        **seen,
        "size": places.size,
        "centre": [sum(p[i] for p in held) / len(held) for i in range(3)],
        "ground": number[linkage.ground],
        "ties": [_spatial(joint, at, number, spots) for joint, at in zip(linkage.joints, places.at, strict=True)],
        "output": number.get(linkage.output, -1),
    }


def _spatial(joint: Joint, at: Vector, number: dict[str, int], spots: list[list[float]]) -> dict[str, Any]:
    """A joint in space: its kind, its links, and the geometry that it has; a point that has a name by its number."""
    point = list(at if joint.point is None else joint.point)
    geometry = {"u": joint.axis, "v": joint.axis2, "s": joint.slide, "o": joint.other, "h": joint.pitch}
    return {
        "t": joint.pair.name,
        **({"name": joint.name} if joint.pair.name in ("revolute", "prismatic") else {}),
        "a": number[joint.links[0]],
        "b": number[joint.links[1]],
        "p": spots.index(point) if point in spots else point,
        **{key: value for key, value in geometry.items() if value is not None},
    }


def plane_model(linkage: Linkage) -> dict[str, Any]:
    """A planar linkage: what its joints demand, and the points that are drawn."""
    places = Places(linkage)
    links = list(linkage.links)
    number = {link: i for i, link in enumerate(links)}
    joints = []
    for joint, at in zip(linkage.joints, places.at, strict=True):
        joints.append(
            {
                "t": joint.pair.name,
                "a": number[joint.links[0]],
                "b": number[joint.links[1]],
                "p": _flat(at),
                "o": _flat(joint.other),
                "u": _flat(joint.axis if joint.pair.name == "prismatic" else joint.slide),
                "c": number.get(joint.carrier or "", -1),
                "r": joint.radii,
                "n": joint.internal,
            }
        )
    points = []
    for name, at in places.named():
        points.append([words_data(named(name)), _flat(at), number[holder(places, at)]])
    return {
        "name": linkage.name,
        "size": places.size,
        "ground": number[linkage.ground],
        "bar": linkage.ground != "ground",
        "links": [[link, [_flat(p) for p in places.links[link]]] for link in links],
        "joints": joints,
        "circles": [[number[link], _flat(centre), radius] for link, centre, radius in circles(places)],
        "points": points,
        "output": number.get(linkage.output, -1),
    }


def _flat(point: tuple[float, float, float] | None) -> list[float] | None:
    return None if point is None else [point[0], point[1]]
