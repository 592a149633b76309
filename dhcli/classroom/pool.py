"""Work spread over processes, with a time limit that is kept.

A process that takes too long is killed, and one that dies is missed; another one takes its place, and what it worked
on is reported as lost. A thread could not be stopped, and `concurrent.futures` gives up when one process dies.

Where it is safe a process begins as a copy of this one, which has imported nearly all that it needs.
"""

from __future__ import annotations

import gc
import math
import signal
import sys
from collections import deque
from collections.abc import Callable, Generator, Hashable, Iterable, Sequence
from contextlib import suppress
from enum import Enum
from importlib import import_module
from multiprocessing import get_context
from multiprocessing.connection import Connection, wait
from pathlib import Path
from queue import SimpleQueue
from time import monotonic
from typing import Any, TypeVar

from dhcli.classroom.interrupts import ENDINGS, start_tracker, without_interrupts
from dhcli.classroom.waiting import Waiting
from dhcli.errors import DhcliError
from dhcli.kinematics.sharing import MOST, shared

MANY = 4
"""Tasks for each process above which every one has its next at hand, so that none waits until it is given it."""

_THREADS = Path("/proc/self/task")
"""Where Linux lists all threads of this process, those of libraries too."""

Task = TypeVar("Task")
Result = TypeVar("Result")


class Lost(Enum):
    """Why a piece of work has no result."""

    TIMED_OUT = "timed out"
    DIED = "died"


def spread(
    work: Callable[[Task], Result],
    tasks: Iterable[Task],
    *,
    jobs: int,
    timeout: float,
    needs: str | None = None,
    alike: Callable[[Task], Hashable] = lambda _: None,
) -> Generator[tuple[Task, Result | Lost], None, None]:
    """Do a piece of work for each task, in several processes.

    Args:
        work: A function at the top of a module, or a `partial` of one; it raises nothing.
        tasks: What it is called with, one by one; a little plain data each, not None.
        jobs: Most processes at a time.
        timeout: Longest that one task may take [s]; the start of a process does not count.
        needs: A module that the work needs and this process does not, imported when a process starts.
        alike: Of which kind a task is; a process keeps to the tasks of a kind, which share what it works out for them.

    Yields:
        Each task with its result, or with why there is none; in the order in which they end.

    Raises:
        DhcliError: Processes cannot be started here.
    """
    tasks = tuple(tasks)
    team: list[_Worker] = []
    try:
        for _ in range(min(jobs, len(tasks))):
            _hire(team, work, needs)
        waiting = Waiting(tasks, alike)  # while they start
        while team:
            spoken = wait([worker.pipe for worker in team], _patience(team))
            for worker in tuple(team):
                if worker.pipe not in spoken and monotonic() < worker.deadline:
                    continue
                outcome = worker.outcome() if worker.pipe in spoken else Lost.TIMED_OUT
                task = worker.done(timeout)
                is_lost = isinstance(outcome, Lost)
                if is_lost:  # what it has not begun goes to another
                    waiting.give_back(worker, worker.tasks)
                else:
                    worker.supply(waiting, 2 if len(waiting) > MANY * len(team) else 1, timeout)
                if is_lost or not worker.tasks:
                    worker.end()
                    team.remove(worker)
                if is_lost and task is None:
                    raise DhcliError("a process for the work could not be started", "--jobs 1 needs the least memory")
                if is_lost and waiting:
                    _hire(team, work, needs)
                if task is not None:
                    yield task, outcome
    finally:
        with without_interrupts():
            for worker in team:
                worker.end()


def in_turn(work: Callable[[Task], Result], tasks: Iterable[Task], *, jobs: int) -> Generator[Result, None, None]:
    """What a piece of work comes to for each task, in their order, few of them at a time however many there are.

    Args:
        work: A function at the top of a module, or a `partial` of one; it raises nothing and never gives None.
        tasks: What it is called with.
        jobs: How many processes share them.

    Raises:
        DhcliError: A process dies.
        Exception: What the tasks raise, once the results of those before it are taken.
    """
    team: list[_Worker] = []
    idle: SimpleQueue[_Worker] = SimpleQueue()

    def asked(task: Task) -> Result:
        worker = idle.get()
        with suppress(OSError):  # if it has died, its pipe tells
            worker.pipe.send(task)
        while (outcome := worker.outcome()) is None:  # its first word is that it is ready
            pass
        idle.put(worker)  # one that has died, too: a thread that waits for anybody would never end
        if isinstance(outcome, Lost):
            raise DhcliError("a process that shared the work has died", "--jobs 1 needs the least memory")
        return outcome  # type: ignore[no-any-return]

    try:
        for _ in range(min(jobs, MOST)):
            _hire(team, work, None)
            idle.put(team[-1])
        yield from shared(asked, tasks, len(team))
    finally:
        with without_interrupts():
            for worker in team:
                worker.end()


def _hire(team: list[_Worker], work: Callable[[Any], object], needs: str | None) -> None:
    """Start a process that is in the team as soon as it is there, so that whatever happens next ends it."""
    with without_interrupts():
        team.append(_Worker(work, needs, team))


def _is_alone() -> bool:
    """Whether nothing else runs in this process, so that a copy of it lacks nothing that something waits for.

    A thread is not copied, and what it held stays held. Only Linux tells of all of them; elsewhere, and where there is
    another, a process starts from nothing, which works everywhere.
    """
    if sys.platform != "linux":
        return False
    try:
        return sum(1 for _ in _THREADS.iterdir()) == 1
    except OSError:
        return False


class _Worker:
    """A process, and the end of the pipe that leads to it."""

    def __init__(self, work: Callable[[Any], object], needs: str | None = None, beside: Sequence[_Worker] = ()) -> None:
        """Start a process beside others."""
        self.tasks: deque[Any] = deque()
        self.deadline = math.inf
        copied = _is_alone()
        start = get_context("fork") if copied else get_context("spawn")
        self.pipe, theirs = start.Pipe()
        # A copy has our ends of the pipes too: none of them would ever learn that we have gone.
        ours = [worker.pipe for worker in (*beside, self)] if copied else []
        if not copied:
            start_tracker()
        self.process = start.Process(target=_serve, args=(theirs, work, needs, ours), daemon=True)
        self.process.start()
        theirs.close()

    def supply(self, waiting: Waiting[Any], most: int, timeout: float) -> None:
        """Hand it tasks until it has so many, that at hand included; if it has died meanwhile, its pipe will tell."""
        while waiting and len(self.tasks) < most:
            if not self.tasks:
                self.deadline = monotonic() + timeout
            self.tasks.append(waiting.take(self))
            with suppress(OSError):
                self.pipe.send(self.tasks[-1])

    def done(self, timeout: float) -> Any:  # noqa: ANN401  whatever a task is
        """The task that it has spoken of, or has not in time; None where it was only starting. The next one begins."""
        task = self.tasks.popleft() if self.tasks else None
        self.deadline = monotonic() + timeout if self.tasks else math.inf
        return task

    def outcome(self) -> Any:  # noqa: ANN401  whatever the work gives
        """What it said: that it is ready, or a result; its pipe is closed when it has died."""
        try:
            return self.pipe.recv()
        except (EOFError, OSError):
            return Lost.DIED

    def end(self) -> None:
        """Stop it, whatever it does; only once, for Ctrl-C may come just after and stop everything again."""
        with without_interrupts():  # a process that is waited for, but not known to be gone, could never be closed
            if self.pipe.closed:
                return
            self.process.kill()
            self.process.join()
            self.pipe.close()
            with suppress(ValueError):  # where SIGCHLD is ignored, nobody is told that a process has gone
                self.process.close()


def _serve(
    pipe: Connection, work: Callable[[Any], object], needs: str | None, others: Sequence[Connection] = ()
) -> None:
    """The life of a process: say that it is ready, then work until nobody gives it work any more."""
    for each in others:
        each.close()
    for number in ENDINGS[1:]:
        if callable(signal.getsignal(number)):  # what the first process does at its end
            signal.signal(number, signal.SIG_DFL)
    if hasattr(signal, "pthread_sigmask"):  # it was started deaf to these, too
        signal.pthread_sigmask(signal.SIG_UNBLOCK, ENDINGS[1:])
    if needs:
        import_module(needs)
    gc.freeze()  # what is imported stays
    gc.set_threshold(100_000)  # looking for what a sheet leaves behind takes a share of the time, and finds little
    with suppress(EOFError, OSError):
        pipe.send(None)
        while True:
            pipe.send(work(pipe.recv()))


def _patience(team: Sequence[_Worker]) -> float | None:
    """Seconds to the next deadline; None while all processes are only starting."""
    first = min(worker.deadline for worker in team)
    return None if math.isinf(first) else max(0.0, first - monotonic())
