"""Mobility of long scissors: elimination link by link beside one dense singular value decomposition."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Iterator

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

from measure import Row, side_by_side

from dhcli.mobility.constraints import constraint_rank
from dhcli.mobility.large import large_mobility
from dhcli.mobility.linkage import Joint, Linkage
from dhcli.mobility.model import Model, model_of
from dhcli.mobility.pairs import LETTERS, PLANAR
from dhcli.mobility.truth import true_mobility

BARS = (20, 50, 100, 200, 400, 800)
ANGLE = 0.6


def rows(rounds: int, bars: tuple[int, ...] = BARS) -> Iterator[Row]:
    """A row for each length."""
    for count in bars:
        linkage = scissor(count // 2)
        model = model_of(linkage)
        found = true_mobility(linkage)
        if found.mobility != 1 or large_mobility(model).mobility != 1:
            raise SystemExit(f"a scissor of {count} bars has mobility {found.mobility}, not 1")
        yield side_by_side(
            f"scissor of {count} bars",
            ("true_mobility", task(true_mobility, linkage)),
            ("dense constraint form", dense(model)),
            rounds=rounds if count < 400 else 1,
            note=f"smallest singular value kept {found.rank.kept:.1e}",
        )


def task(work: Callable[[Linkage], object], linkage: Linkage) -> Callable[[], object]:
    """The work on one linkage, as a call without arguments."""
    return lambda: work(linkage)


def dense(model: Model) -> Callable[[], object]:
    """The rank of the whole matrix of constraints."""
    return lambda: constraint_rank(model, 1e-12)


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
