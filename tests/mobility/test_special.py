"""Linkages beyond the list of mechanisms: contacts, bars, gears in space, flexible polyhedra, folded positions."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from dhcli.geometry.vectors import Vector
from dhcli.mobility.finding import mobility_of
from dhcli.mobility.linkage import Joint, Linkage
from dhcli.mobility.pairs import PLANAR, SPATIAL, pair_of

ORIGIN: Vector = (0.0, 0.0, 0.0)
A: Vector = (3.0, 0.0, 0.0)
X: Vector = (1.0, 0.0, 0.0)
Z: Vector = (0.0, 0.0, 1.0)


def vectors(count: int, seed: int = 0) -> list[Vector]:
    """Random points."""
    return [tuple(map(float, row)) for row in np.random.default_rng(seed).normal(size=(count, 3))]  # type: ignore[misc]


def figures(linkage: Linkage) -> tuple[int | None, int | None, int | None]:
    """Formula, instantaneous and true mobility."""
    found = mobility_of(linkage)
    return found.gruebler, found.instantaneous, found.mobility


@pytest.mark.parametrize(("bars", "expected"), [(4, (2, 2, 2)), (5, (1, 1, 1)), (6, (0, 0, 0)), (7, (-1, 0, 0))])
def test_bars_hold_a_body_in_space(bars: int, expected: tuple[int, int, int]) -> None:
    """Six are enough."""
    ends = iter(vectors(2 * bars))
    joints = tuple(Joint(pair_of("bar"), ("ground", "body"), str(i), next(ends), other=next(ends)) for i in range(bars))
    assert figures(Linkage("bars", SPATIAL, joints, "ground", "body")) == expected


def test_a_wheel_rolls_round_another_one() -> None:
    """Alone it needs no arm; with one, the distance is kept twice."""
    roll = Joint(pair_of("rolling"), ("ground", "wheel"), "1", ORIGIN, other=A, radii=(2.0, 1.0))
    arm = (
        Joint(pair_of("R"), ("ground", "arm"), "2", ORIGIN),
        Joint(pair_of("R"), ("arm", "wheel"), "3", A),
    )
    assert figures(Linkage("roll", PLANAR, (roll,), "ground", "wheel")) == (1, 1, 1)
    assert figures(Linkage("roll", PLANAR, (roll, *arm), "ground", "wheel")) == (0, 1, 1)


def test_bevel_gears_turn_in_space() -> None:
    """Each wheel about its own axis in the carrier."""
    joints = (
        Joint(pair_of("R"), ("ground", "a"), "1", ORIGIN, Z),
        Joint(pair_of("R"), ("ground", "b"), "2", ORIGIN, X),
        Joint(pair_of("gear"), ("a", "b"), "3", carrier="ground", radii=(1.0, 2.0)),
    )
    assert figures(Linkage("bevel", SPATIAL, joints, "ground", "b")) == (1, 1, 1)


def test_a_loop_of_welds_does_not_move() -> None:
    """A pin between two welded links is locked."""
    joints = (
        Joint(pair_of("fixed"), ("ground", "a"), "1"),
        Joint(pair_of("R"), ("a", "b"), "2", ORIGIN, Z),
        Joint(pair_of("fixed"), ("b", "ground"), "3"),
    )
    assert figures(Linkage("weld", SPATIAL, joints, "ground")) == (-5, 0, 0)


def test_a_folded_rhombus_has_no_idle_freedom() -> None:
    """It turns about one double pin or about the other, never about both."""
    places = [("g", "a", ORIGIN), ("a", "c", X), ("c", "b", ORIGIN), ("b", "g", X)]
    joints = tuple(Joint(pair_of("R"), (first, second), first + second, point) for first, second, point in places)
    found = mobility_of(Linkage("rhombus", PLANAR, joints, "g"))
    assert (found.idle, found.instantaneous, found.mobility) == ((), 2, 1)


def octahedron(corners: dict[str, Vector]) -> Linkage:
    """Eight plates hinged along twelve edges; small letters stand opposite to capitals."""
    faces = ["".join(corner) for corner in itertools.product("Aa", "Bb", "Cc")]
    joints = []
    for first, second in itertools.combinations(faces, 2):
        edge = sorted(set(first) & set(second))
        if len(edge) == 2:
            start, end = (np.array(corners[corner]) for corner in edge)
            axis: Vector = tuple(map(float, end - start))  # type: ignore[assignment]
            joints.append(Joint(pair_of("R"), (first, second), "".join(edge), corners[edge[0]], axis))
    return Linkage("octahedron", SPATIAL, tuple(joints), "ABC", "abc")


def test_bricards_octahedra_move_and_others_do_not() -> None:
    """Cauchy: convex ones are rigid; Bricard 1897: line-symmetric and plane-symmetric ones are not."""
    a, b, c = (1.2, 0.3, 0.2), (0.4, 1.1, -0.3), (-0.8, 0.5, 0.6)
    line = {"A": a, "B": b, "C": c} | {k: (-p[0], -p[1], p[2]) for k, p in zip("abc", (a, b, c), strict=True)}
    plane = {"A": a, "a": (1.2, 0.3, -0.2), "B": b, "b": (0.4, 1.1, 0.3), "C": (0.9, -1.0, 0.0), "c": (-1.3, 0.2, 0.0)}
    assert figures(octahedron(line)) == (-18, 1, 1)
    assert figures(octahedron(plane)) == (-18, 1, 1)
    assert figures(octahedron(dict(zip("ABCabc", vectors(6), strict=True)))) == (-18, 0, 0)
