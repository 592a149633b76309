"""Two ways to do the same work, compared and then timed in turn, so that a noisy machine is noisy for both."""

from __future__ import annotations

import math
import os
import statistics
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Generic, TypeVar

SHORTEST = 0.01
"""Quicker work is repeated until it takes this long, and the time divided [s]."""

LONGEST = 3.0
"""A pair that takes longer is not measured again; one that takes less, as often as this allows, but twice [s]."""

HEADS = ("work", "dhcli", "peer", "dhcli takes", "peer takes", "peer/dhcli", "spread", "note")

Ours = TypeVar("Ours")
Theirs = TypeVar("Theirs")


@dataclass(frozen=True)
class Task(Generic[Ours]):
    """What does the work, and the call that does it."""

    name: str
    work: Callable[[], Ours]


@dataclass(frozen=True)
class Row:
    """One line of the table.

    Attributes:
        work: What is done.
        ours: What of dhcli does it.
        peer: What else does it.
        pairs: Seconds of ours and of the peer's, in turn; none if the peer is not installed.
        note: What else was counted.
    """

    work: str
    ours: str
    peer: str
    pairs: tuple[tuple[float, float], ...] = ()
    note: str = ""

    @property
    def seconds(self) -> float:
        """Median of ours."""
        return statistics.median(own for own, _ in self.pairs)

    @property
    def peer_seconds(self) -> float:
        """Median of the peer's."""
        return statistics.median(theirs for _, theirs in self.pairs)

    @property
    def ratios(self) -> list[float]:
        """Peer's time over ours in each pair, smallest first; above 1 ours is faster."""
        return sorted(theirs / own for own, theirs in self.pairs)

    def cells(self) -> tuple[str, ...]:
        """The line as texts."""
        if not self.pairs:
            return (self.work, self.ours, self.peer, "", "not installed", "", "", self.note)
        ratios = self.ratios
        spread = f"{number(ratios[0])} to {number(ratios[-1])}" if len(ratios) > 1 else "one pair"
        times = (duration(self.seconds), duration(self.peer_seconds))
        return (self.work, self.ours, self.peer, *times, number(statistics.median(ratios)), spread, self.note)


def side_by_side(
    work: str,
    ours: Task[Ours],
    peer: Task[Theirs],
    same: Callable[[Ours, Theirs], bool],
    *,
    rounds: int,
    note: str = "",
) -> Row:
    """Compare what two callables return, then time them A B A B ...

    The pair that is compared also warms both up, and is not counted, unless it takes so long that it is the only one.

    Args:
        work: What both do.
        ours: Ours.
        peer: The peer.
        same: Whether both results are right.
        rounds: How many pairs are counted; fewer if they would take too long.
        note: What else to say in the row.

    Raises:
        SystemExit: The results differ: what is wrong is not timed.
    """
    own, own_result = timed(ours.work)
    theirs, peer_result = timed(peer.work)
    if not same(own_result, peer_result):
        raise SystemExit(f"{work}: {ours.name} and {peer.name} do not say the same")
    if own + theirs > LONGEST:
        return Row(work, ours.name, peer.name, ((own, theirs),), note)
    del own_result, peer_result  # a batch is a gigabyte
    often = [max(1, math.ceil(SHORTEST / once)) for once in (own, theirs)]
    rounds = min(rounds, max(2, round(LONGEST / (own + theirs))))
    pairs = tuple((seconds(ours.work, often[0]), seconds(peer.work, often[1])) for _ in range(rounds))
    return Row(work, ours.name, peer.name, pairs, note)


def timed(work: Callable[[], Ours]) -> tuple[float, Ours]:
    """Wall time of one call [s], and what it returns."""
    start = time.perf_counter()
    result = work()
    return time.perf_counter() - start, result


def seconds(work: Callable[[], object], often: int) -> float:
    """Wall time of a call, the mean of so many [s]."""
    start = time.perf_counter()
    for _ in range(often):
        work()
    return (time.perf_counter() - start) / often


@contextmanager
def one_core() -> Iterator[None]:
    """Keep this thread, and the threads and processes that it starts, on one core, where the system can."""
    if not hasattr(os, "sched_setaffinity"):
        yield
        return
    allowed = os.sched_getaffinity(0)
    os.sched_setaffinity(0, {max(allowed)})
    try:
        yield
    finally:
        os.sched_setaffinity(0, allowed)


def behind(rows: list[Row]) -> list[str]:
    """Where dhcli takes longer than what it is held against, the furthest behind first."""
    slower = [(statistics.median(row.ratios), row) for row in rows if row.pairs]
    slower = sorted((pair for pair in slower if pair[0] < 1), key=lambda pair: pair[0])
    return [f"{row.work}, {row.ours}: {number(1 / ratio)} times {row.peer}" for ratio, row in slower]


def table(rows: list[Row]) -> str:
    """The rows as a table that is text to read and Markdown to paste."""
    columns = [column for column in zip(HEADS, *(row.cells() for row in rows), strict=True) if any(column[1:])]
    padded = [[cell.ljust(max(map(len, column))) for cell in (column[0], "", *column[1:])] for column in columns]
    lines = ["| " + " | ".join(cells) + " |" for cells in zip(*padded, strict=True)]
    lines[1] = lines[1].replace(" ", "-")
    return "\n".join(lines)


def duration(value: float) -> str:
    """A time with its unit: `43 µs`, `1.2 s`."""
    for unit, size in (("s", 1.0), ("ms", 1e-3), ("µs", 1e-6)):
        if value >= size:
            return f"{number(value / size)} {unit}"
    return f"{number(value * 1e9)} ns"


def number(value: float) -> str:
    """Two digits, three of what begins with 1, and no exponent: 0.61, 1.25, 48, 2300."""
    digits = 1 - math.floor(math.log10(value)) + (f"{value:e}"[0] == "1")
    return f"{round(value, digits):.{max(digits, 0)}f}"
