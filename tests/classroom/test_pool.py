"""Processes that die are replaced, and what they worked on is told."""

from __future__ import annotations

import itertools
import math
import operator
import os
import signal
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager
from functools import cache
from multiprocessing import active_children
from pathlib import Path
from types import FrameType

import pytest

from dhcli.classroom import interrupts, pool
from dhcli.classroom.interrupts import ENDINGS
from dhcli.classroom.pool import Lost, _Worker, in_turn, spread
from dhcli.classroom.waiting import Waiting
from dhcli.errors import DhcliError
from tests.classroom.workers import halved, known
from tests.nightly import paired, some

WAYS = ["from nothing", *(["as a copy"] if sys.platform == "linux" else [])]


@pytest.fixture(params=WAYS)
def way(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> str:
    """Each way in which a process starts; what runs the tests has threads, and would never be copied."""
    monkeypatch.setattr(pool, "_is_alone", lambda: request.param == "as a copy")
    return str(request.param)


each_way = pytest.mark.usefixtures("way")
pytestmark = pytest.mark.filterwarnings("ignore:.*multi-threaded, use of fork:DeprecationWarning")


@each_way
def test_every_task_has_one_outcome() -> None:
    """However many processes die on the way: each odd number kills one."""
    outcomes = list(spread(halved, range(4), jobs=2, timeout=60))
    assert sorted(task for task, _ in outcomes) == list(range(4))
    assert dict(outcomes) == {n: Lost.DIED if n % 2 else n / 2 for n in range(4)}


@each_way
def test_what_waits_behind_a_death_is_done_by_another() -> None:
    """Every process has a task at hand while there are many; where it dies at one, the next is not lost with it."""
    numbers = [1 if n % 7 == 3 else 2 * n for n in range(24)]
    outcomes = list(spread(halved, numbers, jobs=2, timeout=60))
    assert sorted(task for task, _ in outcomes) == sorted(numbers)
    assert all(outcome is Lost.DIED if task % 2 else outcome == task / 2 for task, outcome in outcomes)


def test_time_is_counted_from_when_a_task_is_begun(monkeypatch: pytest.MonkeyPatch) -> None:
    """One that waits behind another in a process is not late with it."""
    now = 0.0
    monkeypatch.setattr(pool, "monotonic", lambda: now)
    worker = _Worker(halved)
    try:
        worker.supply(Waiting([2, 4, 6], alike=lambda _: None), 2, timeout=10)
        assert (list(worker.tasks), worker.deadline) == ([2, 4], 10)
        now = 7.0
        assert (worker.done(timeout=10), worker.deadline) == (2, 17)
        assert (worker.done(timeout=10), worker.deadline) == (4, math.inf)
        assert worker.done(timeout=10) is None
    finally:
        worker.end()


def test_no_task_needs_no_process() -> None:
    """Nothing to do, nothing done."""
    assert list(spread(halved, [], jobs=3, timeout=60)) == []


MOMENTS = some(range(0, 200, 7), 3)
"""Lines of the pool that run before three tasks are done: some of the first ones."""

unix = pytest.mark.skipif(os.name == "nt", reason="signals as Unix knows them")


@contextmanager
def idle_thread() -> Iterator[None]:
    """A thread that takes signals, as that of a progress bar does."""
    done = threading.Event()
    thread = threading.Thread(target=done.wait)
    thread.start()
    try:
        yield
    finally:
        done.set()
        thread.join()


def to_this_thread() -> None:
    """Ctrl-C, taken by the main thread."""
    signal.raise_signal(signal.SIGINT)


def to_any_thread() -> None:
    """Ctrl-C, taken by whichever thread does not block it."""
    os.kill(os.getpid(), signal.SIGINT)


@unix
@each_way
@pytest.mark.parametrize("press", [to_this_thread, to_any_thread])
def test_ctrl_c_while_a_process_ends_leaves_it_ended(
    press: Callable[[], None], monkeypatch: pytest.MonkeyPatch
) -> None:
    """At the worst moment: the system has told that the process is gone, and tells it once; nobody wrote it down."""
    worker = _Worker(halved)
    wait = os.waitpid

    def interrupted(process: int, options: int) -> tuple[int, int]:
        told = wait(process, options)
        press()
        return told

    with idle_thread(), monkeypatch.context() as patched:
        patched.setattr(os, "waitpid", interrupted)
        with pytest.raises(KeyboardInterrupt):
            worker.end()
    worker.end()  # as `spread` does on its way out
    assert worker.pipe.closed
    with pytest.raises(ValueError, match="closed"):
        worker.process.is_alive()


@unix
@each_way
def test_a_process_ends_where_nobody_is_told_of_it() -> None:
    """Some shells and containers start programs with SIGCHLD ignored: to wait for a process then gives no result."""
    worker = _Worker(halved)
    process = worker.process.pid
    before = signal.signal(signal.SIGCHLD, signal.SIG_IGN)
    try:
        worker.end()
    finally:
        signal.signal(signal.SIGCHLD, before)
    assert worker.pipe.closed
    assert process is not None
    with pytest.raises(ProcessLookupError):
        os.kill(process, 0)


@unix
@each_way
def test_ctrl_c_while_processes_start_ends_them(monkeypatch: pytest.MonkeyPatch) -> None:
    """It waits until the process is known, and then stops everything."""
    started: list[_Worker] = []
    start = _Worker.__init__

    def interrupted(self: _Worker, *values: object) -> None:
        started.append(self)
        start(self, *values)  # type: ignore[arg-type]
        to_any_thread()

    with idle_thread():
        monkeypatch.setattr(_Worker, "__init__", interrupted)
        with pytest.raises(KeyboardInterrupt):
            list(spread(halved, range(4), jobs=2, timeout=60))
    assert [worker.pipe.closed for worker in started] == [True]


ALONE = "from tests.classroom.workers import *; from dhcli.classroom.pool import _is_alone, spread\n"
BESIDE = f"{ALONE}import threading; threading.Thread(target=threading.Event().wait, daemon=True).start()\n"
PROGRAMS = [ALONE, BESIDE]
"""The beginning of a program of one thread, whose processes are copies of it on Linux, and of one of two."""


def start(code: str) -> subprocess.Popen[str]:
    """A program that can import the tests."""
    return subprocess.Popen(
        [sys.executable, "-c", code],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        cwd=Path(__file__).parents[2],
    )


ASKED = """
print(sorted(spread(deaf, range(4), jobs=2, timeout=60)))
import colorsys, signal
print(_is_alone(), [*spread(known, ["colorsys"], jobs=1, timeout=60)])
signal.signal(signal.SIGTERM, print); signal.signal(signal.SIGHUP, signal.SIG_IGN)
print([*spread(endings, [0], jobs=1, timeout=60)])
"""


@cache
def said_by(program: str) -> list[str]:
    """What a program says of the processes that it starts: whether they hear Ctrl-C, what they know, how they end."""
    with start(program + ASKED) as running:
        out, err = running.communicate(timeout=60)
    assert err == ""
    return out.splitlines()


@unix
@pytest.mark.parametrize("program", PROGRAMS)
def test_no_process_hears_ctrl_c(program: str) -> None:
    """Not even the first one of a program, before which Python starts a process of its own."""
    assert said_by(program)[0] == "[(0, True), (1, True), (2, True), (3, True)]"


@pytest.mark.skipif(sys.platform != "linux", reason="elsewhere all processes start from nothing")
def test_only_what_runs_alone_is_copied() -> None:
    """A copy knows what the first process has imported, and none of a thread that would not be there."""
    assert said_by(ALONE)[1] == "True [('colorsys', True)]"
    assert said_by(BESIDE)[1] == "False [('colorsys', False)]"


@unix
@pytest.mark.parametrize("program", PROGRAMS)
def test_a_process_ends_as_any_other_where_the_first_one_has_its_own_way(program: str) -> None:
    """It inherits no handler, and what is ignored stays ignored."""
    assert said_by(program)[2:] == ["[(0, ('SIG_DFL', 'SIG_IGN'))]"]


@unix
@pytest.mark.parametrize("program", PROGRAMS)
def test_processes_end_where_the_first_one_is_killed(program: str) -> None:
    """None keeps the pipe of another open: all of them have gone when nobody can write any more."""
    code = "outcomes = spread(known, ['a', 'b', 'c'], jobs=3, timeout=60)\n"
    code += "print(*[next(outcomes) for _ in range(2)], flush=True); input()"
    with start(program + code) as running:
        assert running.stdout is not None
        assert running.stdout.readline().count("False") == 2
        running.kill()
        assert running.communicate(timeout=60)[0] == ""


def pressed_at(moment: int) -> Callable[[FrameType, str, object], object]:
    """A trace function that presses Ctrl-C once, before a line of the pool is run, counted from 0."""
    lines = itertools.count()

    def trace(frame: FrameType, event: str, _: object) -> object:
        if frame.f_code.co_filename not in {pool.__file__, interrupts.__file__}:
            return None
        if event == "line" and next(lines) == moment:
            to_any_thread()
        return trace

    return trace


@unix
@each_way
@pytest.mark.parametrize(("moment", "way"), paired(MOMENTS, WAYS), indirect=["way"])
def test_ctrl_c_at_any_moment_leaves_no_process(moment: int) -> None:
    """It is heard, at once or a moment later, and all processes have gone by then; later signals are, too."""
    traced, others = sys.gettrace(), set(active_children())
    endings = [signal.getsignal(number) for number in ENDINGS]
    with idle_thread():
        sys.settrace(pressed_at(moment))
        try:
            with (
                pytest.raises(KeyboardInterrupt),
                closing(spread(operator.neg, range(3), jobs=2, timeout=60)) as outcomes,
            ):
                list(outcomes)
        finally:
            sys.settrace(traced)
    assert set(active_children()) == others
    assert [signal.getsignal(number) for number in ENDINGS] == endings


def test_what_the_work_needs_is_imported_before_the_clock_runs() -> None:
    """In the processes, not here."""
    outcomes = spread(known, ["tabnanny"], jobs=1, timeout=60, needs="tabnanny")
    assert list(outcomes) == [("tabnanny", True)]
    assert list(spread(known, ["tabnanny"], jobs=1, timeout=60)) == [("tabnanny", False)]
    with pytest.raises(DhcliError, match="could not be started"):
        list(spread(known, ["a"], jobs=1, timeout=60, needs="no_such_module"))


def test_results_come_in_the_order_of_tasks_that_are_taken_few_at_a_time() -> None:
    """However many there are: of an endless row of tasks those at hand are taken."""
    before = set(active_children())
    taken = list[int]()
    results = in_turn(halved, (taken.append(n) or 2 * n for n in itertools.count()), jobs=2)  # type: ignore[func-returns-value]
    with closing(results):
        assert list(itertools.islice(results, 12)) == list(range(12))
        assert len(taken) < 20
    assert set(active_children()) <= before


def test_a_death_in_turn_ends_the_work_with_words() -> None:
    """What went before it is there, nothing that came after it, and no process is left."""
    before = set(active_children())
    results = in_turn(halved, (0, 2, 4, 1, 6, 8, 10, 12, 14, 16), jobs=2)
    assert list(itertools.islice(results, 3)) == [0, 1, 2]
    with pytest.raises(DhcliError, match="a process that shared the work has died"):
        next(results)
    assert set(active_children()) <= before


def test_work_in_turn_ends_though_every_process_dies() -> None:
    """Nobody is left who could do what waits, and nobody waits for that."""
    results = in_turn(halved, range(1, 24, 2), jobs=2)
    ended = threading.Thread(target=lambda: failed.append(_error_of(results)), daemon=True)
    failed = list[Exception]()
    ended.start()
    ended.join(60)
    assert [type(error) for error in failed] == [DhcliError]


def _error_of(results: Iterator[object]) -> Exception:
    with pytest.raises(DhcliError) as raised:
        list(results)
    return raised.value
