"""Joints with four freedoms: a ball in a tube, and a cylinder on a plane."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhcli.errors import DhcliError
from dhcli.mobility.linkage import Joint, Linkage
from dhcli.mobility.pairs import PLANAR, SPATIAL, pair_of
from tests.mobility.building import joint, spatial
from tests.nightly import examples

KINDS = ("ball-in-tube", "line-contact")
law = examples(0.4)


def test_they_have_four_freedoms_in_space_only() -> None:
    """So two constraints each."""
    for name in KINDS:
        assert (SPATIAL.freedoms(pair_of(name)), SPATIAL.constraints(pair_of(name))) == (4, 2)
        with pytest.raises(DhcliError):
            PLANAR.freedoms(pair_of(name))
    assert pair_of("ball in a tube").name == "ball-in-tube"
    assert pair_of("line contact").name == "line-contact"


def placed(kind: str, first: str, second: str, draw: np.random.Generator) -> Joint:
    """A joint somewhere."""
    point, axis, line = draw.normal(size=(3, 3))
    more = {"axis2": np.cross(axis, line)} if kind == "line-contact" else {}
    return joint(kind, first, second, point, axis, **more)


def in_series(whole: Joint, between: str) -> list[Joint]:
    """The same freedom with two simple joints and a link between them: P S, and E R."""
    first, second = whole.links
    if whole.pair.name == "ball-in-tube":
        return [joint("P", first, between, axis=whole.axis), joint("S", between, second, whole.point)]
    return [joint("E", first, between, axis=whole.axis), joint("R", between, second, whole.point, whole.axis2)]


@law
@given(st.integers(0, 10_000), st.lists(st.sampled_from(KINDS), min_size=2, max_size=4), st.integers(0, 2))
def test_they_move_as_two_simple_joints_in_series(seed: int, kinds: list[str], pins: int) -> None:
    """In loops of any kind, in both forms of the formula and in truth."""
    draw = np.random.default_rng(seed)
    joints = [placed(kind, "g", f"l{i}" if i < pins else "body", draw) for i, kind in enumerate(kinds)]
    joints += [placed("R", f"l{i}", "body", draw) for i in range(min(pins, len(kinds)))]
    simple = [
        part
        for i, one in enumerate(joints)
        for part in (in_series(one, f"between{i}") if one.pair.name in KINDS else [one])
    ]
    found, expected = spatial(joints, "body"), spatial(simple, "body")
    assert (found.gruebler, found.mobility, found.motion) == (expected.gruebler, expected.mobility, expected.motion)
    assert found.instantaneous == expected.instantaneous


def test_a_kinematic_coupling_holds_exactly() -> None:
    """Maxwell: three balls in three grooves that point to the middle hold a body without constraint to spare."""
    places = [(math.cos(angle), math.sin(angle), 0.0) for angle in (0.0, 2.1, 4.2)]
    found = spatial([joint("ball-in-tube", "g", "body", place, place) for place in places], "body")
    assert (found.gruebler, found.mobility, found.redundant, found.motion) == (0, 0, 0, "0T0R")


def test_grooves_round_the_middle_let_it_turn_for_an_instant() -> None:
    """Along the circle of the balls the three grooves resist in second order only."""
    joints = []
    for angle in (0.0, 2.1, 4.2):
        place = (math.cos(angle), math.sin(angle), 0.0)
        joints.append(joint("ball-in-tube", "g", "body", place, (-math.sin(angle), math.cos(angle), 0.0)))
    found = spatial(joints, "body")
    assert (found.gruebler, found.instantaneous, found.mobility) == (0, 1, 0)


def test_a_roller_between_a_table_and_the_ground_spins_and_slides_idly() -> None:
    """What both of its contacts allow, it does by itself."""
    joints = [
        joint("line-contact", "g", "roller", (0, 0, 1), (0, 0, 1), axis2=(0, 1, 0)),
        joint("line-contact", "table", "roller", (0, 0, 1), (0, 0, 1), axis2=(0, 1, 0)),
        joint("P", "g", "table", axis=(1, 0, 0)),
    ]
    found = spatial(joints, "table")
    assert (found.gruebler, found.mobility, found.motion) == (3, 5, "1T0R")
    assert len(found.idle) == 4


def test_a_line_that_leaves_the_plane_is_refused() -> None:
    """The cylinder lies on the plane."""
    with pytest.raises(DhcliError, match="does not lie in the plane"):
        Linkage("l", SPATIAL, (joint("line-contact", "g", "a", (0, 0, 0), (0, 0, 1), axis2=(0, 1, 1)),), "g")
