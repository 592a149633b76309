"""Linkages put together in a line each, for tests that need many of them."""

from __future__ import annotations

from collections.abc import Sequence

from dhcli.geometry.vectors import Vector
from dhcli.mobility.finding import mobility_of
from dhcli.mobility.linkage import Joint, Linkage
from dhcli.mobility.pairs import PLANAR, SPATIAL, pair_of
from dhcli.mobility.result import Mobility


def vector(numbers: Sequence[float] | None) -> Vector | None:
    """Two or three numbers as a vector."""
    return None if numbers is None else (*map(float, numbers), 0.0)[:3]  # type: ignore[return-value]


def joint(
    kind: str,
    first: str,
    second: str,
    point: Sequence[float] | None = None,
    axis: Sequence[float] | None = None,
    **more: Sequence[float],
) -> Joint:
    """A joint that is named after its links; `more` are vectors such as `axis2`."""
    vectors = {key: vector(value) for key, value in more.items()}
    return Joint(pair_of(kind), (first, second), f"{first}-{second}", vector(point), vector(axis), **vectors)  # type: ignore[arg-type]


def planar(joints: Sequence[Joint], output: str = "", tolerance: float = 0.0) -> Mobility:
    """The answer about a planar linkage whose ground is called g."""
    return mobility_of(Linkage("test", PLANAR, tuple(joints), "g", output), tolerance)


def spatial(joints: Sequence[Joint], output: str = "", tolerance: float = 0.0) -> Mobility:
    """The answer about a spatial linkage whose ground is called g."""
    return mobility_of(Linkage("test", SPATIAL, tuple(joints), "g", output), tolerance)
