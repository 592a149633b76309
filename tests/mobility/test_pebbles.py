"""Random bars and bodies pinned together in the plane, and the (2,3) pebble game, which counts without any geometry.

Source: Jacobs and Hendrickson 1997; Laman 1970 for the count 2|V| - 3 of every part.
"""

from __future__ import annotations

import random
from itertools import combinations

import numpy as np
import pytest

from dhcli.geometry.rank import rank_of
from dhcli.geometry.vectors import Vector
from dhcli.mobility import decision, large
from dhcli.mobility.copies import mapped
from dhcli.mobility.counting import Counts
from dhcli.mobility.large import _placed, _widest, eliminate, large_mobility
from dhcli.mobility.linkage import Joint, Linkage
from dhcli.mobility.model import model_of
from dhcli.mobility.pairs import LETTERS, PLANAR, SPATIAL, pair_of
from dhcli.mobility.pebbles import generic_freedoms, independent
from dhcli.mobility.truth import true_mobility
from tests.mobility.dense import constraint_rank
from tests.mobility.mechanisms import MECHANISMS
from tests.mobility.mechanisms import linkage as mechanism
from tests.nightly import NIGHT, in_turn, paired
from tests.row_by_row import row_by_row

Edge = tuple[int, int]


def placed_rank(edges: list[Edge], points: list[Vector]) -> int:
    """The rank of the bars' equations at some places: (p - q)·(p' - q') = 0 for each."""
    matrix = np.zeros((len(edges), len(points), 2))
    for row, (a, b) in enumerate(edges):
        matrix[row, a] = np.subtract(points[a], points[b])[:2]
        matrix[row, b] = -matrix[row, a]
    return int(np.linalg.matrix_rank(matrix.reshape(len(edges), -1), 1e-9))


def test_the_game_knows_a_triangle_and_a_braced_square() -> None:
    """K4 has one bar too many."""
    assert independent([2] * 3, [(0, 1), (1, 2), (2, 0)]) == 3
    assert independent([2] * 4, [(a, b) for a in range(4) for b in range(a)]) == 5
    assert independent([2] * 4, [(0, 1), (1, 2), (2, 3), (3, 0)]) == 4


def test_the_game_counts_what_an_angle_ties_together() -> None:
    """Of two points and an angle two equations count, of three points four; a point and an angle alone have none."""
    assert independent([2, 2, 1], [(0, 1, 2)] * 3) == 2
    assert independent([2, 2, 2, 1], [(0, 1, 3), (1, 2, 3), (2, 0, 3)] * 2) == 4
    assert independent([2, 1], [(0, 1)]) == 0


def largest_independent(pebbles: list[int], edges: list[tuple[int, ...]]) -> int:
    """By the definition: the most edges of which no part is larger than the pebbles of its vertices less 3."""

    def is_sparse(chosen: tuple[tuple[int, ...], ...]) -> bool:
        parts = (part for size in range(1, len(chosen) + 1) for part in combinations(chosen, size))
        return all(len(part) <= sum(pebbles[v] for v in set().union(*part)) - 3 for part in parts)

    sizes = range(len(edges), -1, -1)
    return next(size for size in sizes if any(map(is_sparse, combinations(edges, size))))


@row_by_row("seed", range(25))
def test_the_game_finds_as_many_edges_as_the_definition(seed: int) -> None:
    """With vertices of one and of two pebbles, edges of two ends and of three, and the same edge twice."""
    draw = random.Random(seed)  # noqa: S311  labels, no secret
    pebbles = [2, 2, 2, 2, 1, 1]
    edges = [tuple(draw.sample(range(6), draw.choice([2, 3]))) for _ in range(6)]
    edges += draw.sample(edges, 2)
    assert independent(pebbles, edges) == largest_independent(pebbles, edges)


@row_by_row("seed", in_turn(range(60), 0, 2))
def test_the_game_counts_the_rank_of_random_places(seed: int) -> None:
    """Which is that of almost all."""
    vertices, edges = framework(seed)
    assert independent([2] * vertices, edges) == placed_rank(edges, places(vertices, seed))
    order = random.Random(seed).sample(edges, len(edges))  # noqa: S311  labels, no secret
    assert independent([2] * vertices, [(b, a) for a, b in order]) == independent([2] * vertices, edges)


def framework(seed: int) -> tuple[int, list[Edge]]:
    """A connected graph without double bars."""
    draw = random.Random(seed)  # noqa: S311  labels, no secret
    vertices = draw.randint(3, 9)
    edges = {(draw.randrange(v), v) for v in range(1, vertices)}
    for _ in range(draw.randint(0, 2 * vertices)):
        a, b = sorted(draw.sample(range(vertices), 2))
        edges.add((a, b))
    return vertices, sorted(edges)


def places(vertices: int, seed: int) -> list[Vector]:
    """Random points of the plane."""
    draw = random.Random(seed)  # noqa: S311  labels, no secret
    return [(draw.uniform(-1, 1), draw.uniform(-1, 1), 0.0) for _ in range(vertices)]


def linkage_of(points: list[Vector], edges: list[Edge]) -> Linkage:
    """Bars as links and pins as joints, the first bar the ground."""
    joints = []
    for vertex, point in enumerate(points):
        held = [f"bar{i}" for i, edge in enumerate(edges) if vertex in edge]
        joints += [Joint(LETTERS["R"], (held[0], other), f"{vertex}.{k}", point) for k, other in enumerate(held[1:])]
    return Linkage("random", PLANAR, tuple(joints), joints[0].links[0], joints[-1].links[1])


@row_by_row("seed", in_turn(range(120), 0, 3))
def test_random_bars_have_the_mobility_of_their_equations(seed: int) -> None:
    """2|V| - 3 less the independent bars, against one bar that stands still."""
    vertices, edges = framework(seed)
    points = places(vertices, seed)
    expected = 2 * vertices - 3 - placed_rank(edges, points)
    linkage = linkage_of(points, edges)
    found = true_mobility(linkage)
    assert (found.instantaneous, found.mobility) == (expected, expected)
    counted = 2 * vertices - 3 - len(edges)
    assert Counts.of(linkage).gruebler == counted


def net(links: int, joints: int, seed: int, kinds: str = "pin") -> Linkage:
    """Links tied at random: by pins, pins through three links, sliders, pins in slots, bars, or welds."""
    draw = random.Random(seed)  # noqa: S311  labels, no secret
    names, found = [f"b{i}" for i in range(links)], list[Joint]()
    while len(found) < joints:
        first = len(found) + 1
        a, b = (names[draw.randrange(first)], names[first]) if first < links else draw.sample(names, 2)
        kind = draw.choice(kinds.split())
        at, far = places(2, draw.randrange(1 << 30))
        other, axis = far if kind == "bar" else None, far if kind == "slider" else None
        slide = far if kind == "slot" else None
        found.append(Joint(pair_of(kind), (a, b), str(len(found)), at, axis=axis, other=other, slide=slide))
        if kind == "pin" and not draw.randrange(6) and len(found) >= links:
            found.append(Joint(pair_of(kind), (b, draw.choice([n for n in names if n not in (a, b)])), "more", at))
    return Linkage("net", PLANAR, tuple(found), names[0], names[-1])


@row_by_row(
    "kinds",
    [
        "pin",
        "pin pin bar",
        "pin pin bar weld",
        "slider",
        "pin slider",
        "pin pin pin slider",
        "pin slider bar weld",
        "slot",
        "pin slot",
        "pin slider slot",
        "pin slot bar weld",
    ],
)
@row_by_row("seed", in_turn(range(12), 0, 3))
def test_no_placement_has_fewer_motions_than_the_game_says(seed: int, kinds: str) -> None:
    """Random ones have as many, and those in which all pins lie on one line as many or more."""
    draw = random.Random(seed)  # noqa: S311  labels, no secret
    links = draw.randint(3, 14)
    linkage = net(links, links + draw.randint(0, links), seed, kinds)
    model = model_of(linkage)
    game = generic_freedoms(model)
    assert game == model.motions - rank_of(model.jacobian()).rank
    special = model_of(mapped(linkage, lambda p: p * [1, 0, 0], lambda d: d * [0, 1, 0]))
    coarse = generic_freedoms(special)
    assert coarse is not None
    assert coarse <= special.motions - rank_of(special.jacobian()).rank


@row_by_row("name", MECHANISMS)
def test_the_game_never_counts_more_than_the_truth(name: str) -> None:
    """Of the mechanisms of the literature, most of which are special."""
    game = generic_freedoms(model_of(mechanism(name)))
    assert game is None or game <= MECHANISMS[name]["truth"]["dof"]


def test_the_game_leaves_space_alone() -> None:
    """It knows pins with parallel axes, and what slides across them."""
    assert generic_freedoms(model_of(mechanism("bennett"))) is None
    assert generic_freedoms(model_of(mechanism("spherical4r"))) is None
    assert generic_freedoms(model_of(mechanism("fourbar_spatial"))) == 1  # all of its axes are parallel
    for axis, freedoms in (((1.0, 0.0, 0.0), 1), ((0.0, 0.0, 1.0), None)):
        slides = Joint(LETTERS["P"], ("g", "a"), axis=axis)
        assert generic_freedoms(model_of(Linkage("slider", SPATIAL, (slides,), "g"))) == freedoms


def test_three_links_that_slide_along_one_another_in_a_ring_keep_a_freedom() -> None:
    """Gruebler counts none: none of them can turn against another, which is held three times."""
    ways = {("g", "a"): (1.0, 0.0, 0.0), ("a", "b"): (0.6, 0.8, 0.0), ("b", "g"): (0.0, 1.0, 0.0)}
    ring = Linkage("ring", PLANAR, tuple(Joint(LETTERS["P"], ends, axis=way) for ends, way in ways.items()), "g")
    assert Counts.of(ring).gruebler == 0
    assert generic_freedoms(model_of(ring)) == 1
    assert true_mobility(ring).mobility == 1


@pytest.mark.parametrize("seed", range(6))
def test_what_the_game_certifies_is_found_by_moving_too(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Amplitudes imposed on over-braced nets close, with as many freedoms and the same motion of the output."""
    linkage = net(10, 14, seed, "pin pin slider slot" if seed % 2 else "pin")
    certified = true_mobility(linkage)
    monkeypatch.setattr(decision, "generic_freedoms", lambda model: None)
    moved = true_mobility(linkage)
    assert (certified.mobility, certified.motion) == (moved.mobility, moved.motion)


@pytest.mark.parametrize("kinds", ["pin", "pin pin pin slider"])
def test_over_braced_nets_of_hundreds_of_links_are_decided(kinds: str) -> None:
    """Though they have more equations than are independent; by day of a hundred and fifty."""
    found = true_mobility(net(400, 580, 1, kinds) if NIGHT else net(150, 218, 1, kinds))
    assert found.mobility == found.instantaneous
    assert found.mobility is not None
    assert found.mobility > Counts.of(found.model.linkage).gruebler  # type: ignore[operator]
    assert found.certificate.startswith("exact")


def test_a_net_is_decided_by_its_loops_and_a_narrow_gap_by_its_links(monkeypatch: pytest.MonkeyPatch) -> None:
    """Elimination of a wide front takes a hundred times as long; its gap is the wider one."""
    eliminated: list[int] = []
    monkeypatch.setattr(large, "eliminate", lambda *given: eliminated.append(given[1]) or eliminate(*given))
    model = model_of(net(210, 300, 2))
    by_loops = large_mobility(model)
    assert not eliminated
    monkeypatch.setattr(large, "NEAR", 1.0)
    small = model_of(net(40, 55, 2))
    assert large_mobility(small).instantaneous == generic_freedoms(small)
    assert eliminated == [39]
    assert by_loops.instantaneous == generic_freedoms(model)


@pytest.mark.parametrize(("size", "seed"), paired([(30, 40), (60, 90)], range(2)))
def test_a_front_is_never_wider_than_foreseen(size: tuple[int, int], seed: int) -> None:
    """And both forms of the equations leave as many motions."""
    model = model_of(net(*size, seed))
    equations, largest = _placed(model)
    blocks = eliminate(equations, len(model.tree), 3, 1e-10 * largest)
    assert max(len(block.others) for block in blocks) <= _widest(model)
    assert constraint_rank(model)[1] == large_mobility(model).instantaneous == generic_freedoms(model)
