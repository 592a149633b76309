"""Two ways to do the same work, timed in turn in one run, so that a noisy machine is noisy for both."""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable
from dataclasses import dataclass


@dataclass(frozen=True)
class Row:
    """One line of the table.

    Attributes:
        work: What is done.
        ours: What of dhcli does it.
        peer: What else does it.
        seconds: Median of ours.
        peer_seconds: Median of the peer's, or None if it is not installed.
        ratio: Peer's time over ours, the median of the pairs; above 1 ours is faster.
        spread: Smallest and largest ratio of a pair.
        note: What else was counted.
    """

    work: str
    ours: str
    peer: str
    seconds: float
    peer_seconds: float | None
    ratio: float | None
    spread: tuple[float, float] | None
    note: str = ""


Task = tuple[str, Callable[[], object]]
"""What does the work, and the call that does it."""


def side_by_side(work: str, ours: Task, peer: Task, *, rounds: int, note: str = "") -> Row:
    """Time two callables A B A B ..., after one round that is not counted.

    Args:
        work: What both do.
        ours: Name and callable.
        peer: Name and callable.
        rounds: How many pairs are counted.
        note: What else to say in the row.
    """
    pairs = [(seconds(ours[1]), seconds(peer[1])) for _ in range(rounds + 1)][1:]
    ratios = [theirs / own for own, theirs in pairs]
    return Row(
        work,
        ours[0],
        peer[0],
        statistics.median(own for own, _ in pairs),
        statistics.median(theirs for _, theirs in pairs),
        statistics.median(ratios),
        (min(ratios), max(ratios)),
        note,
    )


def seconds(work: Callable[[], object]) -> float:
    """Wall time of one call [s]."""
    start = time.perf_counter()
    work()
    return time.perf_counter() - start


def table(rows: list[Row]) -> str:
    """The rows as text in columns."""
    heads = ("work", "ours", "peer", "ours [ms]", "peer [ms]", "peer/ours", "spread", "note")
    lines = [heads, *(_cells(row) for row in rows)]
    widths = [max(len(line[k]) for line in lines) for k in range(len(heads))]
    return "\n".join("  ".join(cell.ljust(w) for cell, w in zip(line, widths, strict=True)).rstrip() for line in lines)


def _cells(row: Row) -> tuple[str, ...]:
    spread = "" if row.spread is None else f"{row.spread[0]:.3g} to {row.spread[1]:.3g}"
    return (
        row.work,
        row.ours,
        row.peer,
        f"{row.seconds * 1000:.3g}",
        "not installed" if row.peer_seconds is None else f"{row.peer_seconds * 1000:.3g}",
        "" if row.ratio is None else f"{row.ratio:.3g}",
        spread,
        row.note,
    )
