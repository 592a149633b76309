"""The mechanisms of the literature in `tests/data/mechanisms.json`, as linkages."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from dhcli.mobility.linkage import Joint, Linkage
from dhcli.mobility.pairs import pair_of, space_of

DATA = Path(__file__).parent.parent / "data" / "mechanisms.json"
MECHANISMS: dict[str, dict[str, Any]] = {m["id"]: m for m in json.loads(DATA.read_text("utf-8"))["mechanisms"]}
Z = (0.0, 0.0, 1.0)


def linkage(name: str) -> Linkage:
    """A mechanism by its id; its truth stands in `MECHANISMS`."""
    found = MECHANISMS[name]
    joints = []
    for i, joint in enumerate(found["joints"], 1):
        first, *others = joint["links"]
        joints += [_joint(joint, (first, other), str(i), found) for other in others]
    ground = found.get("ground") or found["joints"][0]["links"][0]
    return Linkage(name, space_of(str(found["lambda"])), tuple(joints), ground, found["output"], found["name"])


def _joint(joint: dict[str, Any], links: tuple[str, str], name: str, found: dict[str, Any]) -> Joint:
    def vector(key: str) -> tuple[float, float, float] | None:
        value = joint.get(key)
        if isinstance(value, str):
            value = found["points"][value]
        return None if value is None else (*map(float, value), 0.0, 0.0)[:3]  # type: ignore[return-value]

    return Joint(
        pair_of(joint["type"]),
        links,
        joint.get("name", name),
        vector("point"),
        vector("axis") or (Z if joint["type"] != "prismatic" else None),
        vector("axis2"),
        vector("other"),
        vector("slide"),
        joint.get("pitch"),
        joint.get("carrier"),
        tuple(joint["radii"]) if "radii" in joint else None,
        joint.get("internal", False),
    )
