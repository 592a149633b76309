"""Mobility of long scissors: elimination link by link beside one dense singular value decomposition."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

from measure import Row, Task, side_by_side

from dhcli.mobility.constraints import constraint_rank
from dhcli.mobility.large import large_mobility
from dhcli.mobility.linkage import Joint, Linkage
from dhcli.mobility.model import model_of
from dhcli.mobility.pairs import LETTERS, PLANAR
from dhcli.mobility.truth import true_mobility

BARS = (20, 50, 100, 200, 400, 800)
ANGLE = 0.6


def rows(rounds: int, bars: tuple[int, ...] = BARS) -> Iterator[Row]:
    """A row for each length."""
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
