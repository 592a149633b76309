"""What a page must know of a scene, in as many digits as a drawing needs."""

from __future__ import annotations

from typing import Any

from dhcli.scene.primitives import Ball, Box, Drum, Face, Scene, Solid
from dhcli.scene.words import Words, spelled


def scene_data(scene: Scene) -> dict[str, Any]:
    """The scene, in as many digits as a drawing needs."""
    return {key: _short(value) for key, value in _whole_scene(scene).items()}


def _short(value: Any) -> Any:  # noqa: ANN401  anything that JSON knows
    if isinstance(value, float):
        return int(value) if value == int(value) and abs(value) < 1e6 else float(f"{value:.6g}")  # noqa: PLR2004
    return [_short(each) for each in value] if isinstance(value, list | tuple) else value


def _whole_scene(scene: Scene) -> dict[str, Any]:
    plate, hand = scene.plate, scene.hand
    return {
        "unit": scene.unit,
        "solids": [_solid(solid) for solid in scene.solids],
        "rods": [[r.start.state, r.start.at, r.end.state, r.end.at, r.thickness, int(r.ground)] for r in scene.rods],
        "dims": [
            [d.start.state, d.start.at, d.end.state, d.end.at, words_data(d.words), d.variable, d.direct]
            for d in scene.dimensions
        ],
        "plate": plate and [plate.centre.state, plate.centre.at, plate.normal, plate.size, plate.broken],
        "hand": hand and [hand.wrist.state, hand.wrist.at, hand.forward, hand.across, hand.size],
        "pinned": [[anchor.state, anchor.at] for anchor in scene.pinned],
    }


def _solid(solid: Solid) -> list[Any]:
    if isinstance(solid, Face):
        return ["face", [[c.state, c.at] for c in solid.corners], solid.ground]
    if isinstance(solid, Ball):
        return ["ball", solid.centre.state, solid.centre.at, solid.radius]
    if isinstance(solid, Drum):
        words = words_data(spelled(solid.name))
        return ["drum", solid.centre.state, solid.centre.at, solid.axis, solid.radius, solid.half, words]
    assert isinstance(solid, Box)  # noqa: S101  the last kind
    return ["box", solid.centre.state, solid.centre.at, solid.axis, solid.half]


def words_data(words: Words) -> list[list[Any]]:
    """The runs of some words, and whether each stands below the line."""
    return [[run.text, int(run.below)] for run in words]
