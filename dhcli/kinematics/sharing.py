"""Work shared by threads, its results in the order of its parts."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterable, Iterator
from typing import TypeVar

from dhcli.errors import RobotError

Part = TypeVar("Part")
Result = TypeVar("Result")

MOST = 128
"""Threads at the most: each takes memory of its own, and more of them than processors gain nothing."""

AHEAD = 2
"""Parts for each thread that may be done, or waiting, before the result of the first is taken."""


def check_threads(threads: object) -> None:
    """Refuse what is no number of threads.

    Raises:
        RobotError: That is none.
    """
    if type(threads) is not int or threads < 1:
        raise RobotError(f"threads is a number from 1, not {threads!r:.60}")


def shared(work: Callable[[Part], Result], parts: Iterable[Part], threads: int) -> Iterator[Result]:
    """What each part of a work comes to, in their order, few of them at a time however many there are.

    >>> list(shared(lambda part: part * part, range(5), 2))
    [0, 1, 4, 9, 16]

    Args:
        work: What is done with a part; by several threads at once.
        parts: The parts.
        threads: How many threads share them; with one no other is started.

    Raises:
        Exception: What work raises, or the parts do, once the results of the parts before it are taken.
    """
    if threads == 1:
        yield from map(work, parts)
        return
    from concurrent.futures import Future, ThreadPoolExecutor  # a command that needs none starts sooner

    threads = min(threads, MOST)
    waiting: deque[Future[Result]] = deque()
    pool = ThreadPoolExecutor(threads)

    def begun() -> Iterator[Future[Result]]:
        try:
            for part in parts:
                yield pool.submit(work, part)
        except Exception as error:  # noqa: BLE001  raised in its turn, after what the parts before it come to
            failed = Future[Result]()
            failed.set_exception(error)
            yield failed

    try:
        for future in begun():
            waiting.append(future)
            if len(waiting) > AHEAD * threads:
                yield waiting.popleft().result()
        while waiting:
            yield waiting.popleft().result()
    finally:
        pool.shutdown(cancel_futures=True)
