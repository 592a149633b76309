"""Random bars pinned together in the plane, against the (2,3) pebble game: another method, without any geometry.

Source: Jacobs and Hendrickson 1997; Laman 1970 for the count 2|V| - 3 of every part.
"""

from __future__ import annotations

import random

import pytest

from dhcli.mobility.counting import Counts
from dhcli.mobility.linkage import Joint, Linkage
from dhcli.mobility.pairs import LETTERS, PLANAR
from dhcli.mobility.truth import true_mobility

Edge = tuple[int, int]


def independent_edges(vertices: int, edges: list[Edge]) -> int:
    """The number of bars that the pebble game accepts: the rank of the generic framework."""
    pebbles = [2] * vertices
    out: list[list[int]] = [[] for _ in range(vertices)]

    def gather(start: int, kept: int) -> bool:
        """Free one more pebble at a vertex by turning a path round, without taking from `kept`."""
        came: dict[int, int] = {start: start, kept: kept}
        waiting = [start]
        while waiting:
            here = waiting.pop()
            for there in out[here]:
                if there in came:
                    continue
                came[there] = here
                if pebbles[there]:
                    pebbles[there] -= 1
                    end = there
                    while end != start:
                        back = came[end]
                        out[back].remove(end)
                        out[end].append(back)
                        end = back
                    pebbles[start] += 1
                    return True
                waiting.append(there)
        return False

    accepted = 0
    for a, b in edges:
        while pebbles[a] < 2 and gather(a, b):
            pass
        while pebbles[b] < 2 and gather(b, a):
            pass
        if pebbles[a] + pebbles[b] == 4:
            pebbles[a] -= 1
            out[a].append(b)
            accepted += 1
    return accepted


def test_the_oracle_knows_a_triangle_and_a_braced_square() -> None:
    """K4 has one bar too many."""
    assert independent_edges(3, [(0, 1), (1, 2), (2, 0)]) == 3
    assert independent_edges(4, [(a, b) for a in range(4) for b in range(a)]) == 5
    assert independent_edges(4, [(0, 1), (1, 2), (2, 3), (3, 0)]) == 4


def framework(seed: int) -> tuple[int, list[Edge]]:
    """A connected graph without double bars."""
    draw = random.Random(seed)  # noqa: S311  labels, no secret
    vertices = draw.randint(3, 9)
    edges = {(draw.randrange(v), v) for v in range(1, vertices)}
    for _ in range(draw.randint(0, 2 * vertices)):
        a, b = sorted(draw.sample(range(vertices), 2))
        edges.add((a, b))
    return vertices, sorted(edges)


def linkage_of(vertices: int, edges: list[Edge], seed: int) -> Linkage | None:
    """Bars as links and pins as joints, the first bar the ground; None if no pin holds two bars."""
    draw = random.Random(seed)  # noqa: S311  labels, no secret
    points = [(draw.uniform(-1, 1), draw.uniform(-1, 1), 0.0) for _ in range(vertices)]
    joints = []
    for vertex in range(vertices):
        held = [f"bar{i}" for i, edge in enumerate(edges) if vertex in edge]
        joints += [
            Joint(LETTERS["R"], (held[0], other), f"{vertex}.{k}", points[vertex]) for k, other in enumerate(held[1:])
        ]
    return Linkage("random", PLANAR, tuple(joints), joints[0].links[0]) if joints else None


@pytest.mark.parametrize("seed", range(120))
def test_random_bars_have_the_mobility_of_the_pebble_game(seed: int) -> None:
    """2|V| - 3 less the independent bars, against one bar that stands still."""
    vertices, edges = framework(seed)
    linkage = linkage_of(vertices, edges, seed)
    assert linkage is not None
    expected = 2 * vertices - 3 - independent_edges(vertices, edges)
    found = true_mobility(linkage)
    assert (found.instantaneous, found.mobility) == (expected, expected)
    counted = 2 * vertices - 3 - len(edges)
    assert Counts.of(linkage).gruebler == counted
