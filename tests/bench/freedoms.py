"""Mobility of long scissors and of nets of pinned links, beside one dense singular value decomposition."""

from __future__ import annotations

import math
import random
import sys
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

from measure import Row, Task, side_by_side

sys.path.insert(0, str(Path(__file__).parents[2]))

from dhcli.mobility.large import large_mobility
from dhcli.mobility.linkage import Joint, Linkage
from dhcli.mobility.model import model_of
from dhcli.mobility.pairs import LETTERS, PLANAR
from dhcli.mobility.truth import true_mobility
from tests.mobility.dense import constraint_rank

BARS = (20, 100, 400)
NETS = (50, 200, 400)
LARGE = 800
"""Links of a net that the decomposition takes half a minute for."""

SURPLUS = 1.45
"""Pins for each link of a net: more than it takes to make parts of it rigid, so that equations repeat others."""

ANGLE = 0.6


def rows(rounds: int, bars: tuple[int, ...] = BARS, nets: tuple[int, ...] = NETS) -> Iterator[Row]:
    """A row for each length, and for each size of a net."""
    for count in bars:
        linkage = scissor(count // 2)
        model = model_of(linkage)
        if large_mobility(model).mobility != 1:
            raise SystemExit(f"a scissor of {count} bars has another mobility than 1")
        row = side_by_side(
            f"scissor of {count} bars",
            Task("true_mobility", lambda linkage=linkage: true_mobility(linkage)),
            Task("dense constraint form", lambda model=model: constraint_rank(model, 1e-12)),
            lambda ours, theirs: ours.mobility == 1 == theirs[1],
            rounds=rounds,
        )
        yield replace(row, note=f"smallest singular value kept {true_mobility(linkage).rank.kept:.1e}")

    for count in nets:
        linkage = net(count)
        model = model_of(linkage)
        motions = true_mobility(linkage).mobility
        if motions is None:
            raise SystemExit(f"a net of {count} links is undecided")
        yield side_by_side(
            f"net of {count} links",
            Task("true_mobility", lambda linkage=linkage: true_mobility(linkage)),
            Task("dense constraint form", lambda model=model: constraint_rank(model, 1e-12)),
            lambda ours, theirs: ours.mobility == theirs[1],
            rounds=rounds,
        )


def large(rounds: int) -> Iterator[Row]:
    """A row for the largest net."""
    return rows(rounds, (), (LARGE,))


def net(links: int) -> Linkage:
    """Links pinned together at random in the plane, each to one before it and then any two."""
    draw = random.Random(links)  # noqa: S311  no secret
    names = [f"link{i}" for i in range(links)]
    pairs = [(draw.choice(names[:i]), names[i]) for i in range(1, links)]
    while len(pairs) < SURPLUS * links:
        first, second = draw.sample(names, 2)
        pairs.append((first, second))
    return Linkage("net", PLANAR, tuple(pin(*pair, draw.gauss(0, 1), draw.gauss(0, 1)) for pair in pairs), names[0])


def scissor(stages: int) -> Linkage:
    """Pairs of crossed bars in a row: 2N bars and 3N - 2 pins."""
    half, height = math.cos(ANGLE), math.sin(ANGLE)
    joints = []
    for i in range(stages):
        joints.append(pin(f"rise{i}", f"fall{i}", half * (2 * i + 1), height))
        if i:
            joints.append(pin(f"rise{i - 1}", f"fall{i}", 2 * half * i, 2 * height))
            joints.append(pin(f"fall{i - 1}", f"rise{i}", 2 * half * i, 0.0))
    return Linkage("scissor", PLANAR, tuple(joints), "rise0")


def pin(first: str, second: str, x: float, y: float) -> Joint:
    """A revolute joint in the plane."""
    return Joint(LETTERS["R"], (first, second), f"{first}-{second}", (x, y, 0.0))
