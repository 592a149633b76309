"""Recordings played over many rows: a few one by one, more by numpy in blocks, or by the compiled loop."""

from __future__ import annotations

import math
from collections import deque
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from dhcli.algebra.columns import Columns
from dhcli.algebra.kernel import is_ready
from dhcli.algebra.program import Program
from dhcli.kinematics.recorded import Recording
from dhcli.kinematics.sharing import check_threads, shared

if TYPE_CHECKING:
    from numpy.typing import NDArray

BLOCK = 4040
"""Rows at a time: enough to make a call of numpy cheap beside its work, few enough to keep the columns in the cache.

2000 to 8000 differ little where this was tried; PUMA 560 takes 34 columns of 32 kB, of which most rest. Columns of a
power of two would lie on the same few lines of a cache: to turn them into rows takes up to three times as long then.
"""

CACHE = 900_000
"""Bytes of all columns that are worked on at a time; the Jacobian of a Panda has 79 of them."""

FEWEST = 1000
"""Rows at a time however many columns there are."""

CHUNK = 8 * BLOCK
"""Rows that one thread takes at a time; as one block, for at each call of numpy one thread may wait for the other.

With fewer they wait more often, with twice as many the columns of two threads no longer fit the last cache.
"""

STRETCH = 8 * CHUNK
"""Rows that the compiled loop takes at a time: it keeps no columns, and two threads wait for each other at its ends."""

FEW = 16
"""Rows that are played one by one in less time than numpy takes to begin."""

MODEST = 10.0
"""Joint values [rad] up to which parallel joints are merged; the sum of larger angles lacks digits of its parts."""

_IDLE: deque[Columns] = deque(maxlen=4)
"""Columns that nobody uses now: the next block, or the next call, of the same robot need not make them.

A megabyte each, or those of threads some ten.
"""


def play(recording: Recording, q: NDArray[np.float64], found: NDArray[Any], threads: int = 1) -> None:
    """Work out what was recorded for each row.

    Args:
        recording: What to work out.
        q: Joint values, shape (N, n); radians and metres.
        found: Where the results go, shape (N, ...), as many numbers in each row as were recorded; NaN or infinite where
            a joint value is. They are worked out in double precision and rounded once if it holds float32.
        threads: How many threads share the work.

    Raises:
        RobotError: That is no number of threads.
    """
    check_threads(threads)
    by_loop = is_ready(len(q))
    if not by_loop and len(q) <= FEW and _one_by_one(recording, q, found):
        return
    one = partial(_by_loop if by_loop else _by_columns, recording, q, found)
    chunks = shares(len(q), threads, STRETCH if by_loop else CHUNK)
    if threads == 1 or len(chunks) < 2:  # noqa: PLR2004  nothing to share
        for chunk in chunks:
            one(chunk)
    else:
        for _ in shared(partial(one, block=CHUNK), chunks, threads):
            pass


def shares(count: int, threads: int, size: int) -> list[slice]:
    """Rows in parts of at most that size; for several threads as many and as large for each, but none below a block."""
    if threads > 1:
        parts = -(-count // size)
        parts = min(-(-parts // threads) * threads, count // BLOCK)
        size = -(-count // max(1, parts))
    return [slice(first, first + size) for first in range(0, count, max(1, size))]


def _one_by_one(recording: Recording, q: NDArray[np.float64], found: NDArray[Any]) -> bool:
    """A few rows, each in floats; whether all of them have values."""
    try:
        rows = [recording.one(row) for row in q.tolist()]
    except (ArithmeticError, ValueError):
        return False
    values = np.array(rows)
    if found.dtype != values.dtype:
        with np.errstate(over="ignore"):  # what float32 does not hold is infinite in it
            values = values.astype(found.dtype)
    found[...] = values.reshape(found.shape)
    return True


def _by_loop(
    recording: Recording, q: NDArray[np.float64], found: NDArray[Any], chunk: slice, block: int | None = None
) -> None:
    """A chunk by the compiled loop; by numpy where that does not know a step, or an angle is too large for it."""
    rows, target = np.ascontiguousarray(q[chunk]), found[chunk]
    is_plain = target.flags.c_contiguous
    flat = (target if is_plain else np.empty(target.shape, target.dtype)).reshape(len(rows), -1)
    for merged, most in ((True, MODEST), (False, math.inf)):
        kernel = recording.kernel(merged=merged)
        if kernel is not None and kernel.play(rows, flat, most=most):
            break
    else:
        _by_columns(recording, q, found, chunk, block)
        return
    if not is_plain:
        target[...] = flat.reshape(target.shape)


def _by_columns(
    recording: Recording, q: NDArray[np.float64], found: NDArray[Any], chunk: slice, block: int | None = None
) -> None:
    """A chunk by numpy, so many rows at a time, by default as a cache holds well."""
    rows, target = q[chunk], found[chunk]
    with np.errstate(all="ignore"):  # a thread has its own
        length = block or _length(recording.program(merged=True, tangents=True))
        length = -(-len(rows) // max(1, -(-len(rows) // length)))  # as many in each part, so that one size serves all
        for first in range(0, len(rows), max(1, length)):
            part = rows[first : first + length]
            merged = bool(part.max(initial=0.0) <= MODEST and part.min(initial=0.0) >= -MODEST)
            columns = _columns(recording.program(merged=merged, tangents=True), len(part))
            results = columns.play(part.T).reshape(*target.shape[1:], -1)
            target[first : first + length] = np.moveaxis(results, -1, 0)
            _IDLE.append(columns)


def _length(program: Program) -> int:
    """Rows at a time of a program: fewer where it has so many columns that they would not fit the cache."""
    return min(BLOCK, max(FEWEST, CACHE // (8 * program.registers)))


def _columns(program: Program, rows: int) -> Columns:
    """Columns of a program for so many rows: idle ones that are long enough and not much longer, if there are any.

    A large block takes milliseconds to be handed out by the system, so calls that differ a little share one.
    """
    for columns in tuple(_IDLE):
        if columns.program is program and rows <= columns.length <= rows + max(16, rows // 8):
            try:
                _IDLE.remove(columns)
            except ValueError:  # another thread was quicker
                continue
            return columns
    step = max(16, 1 << rows.bit_length() >> 8)
    return Columns(program, -(-(rows - 8) // step) * step + 8)  # an odd number of the lines of a cache
