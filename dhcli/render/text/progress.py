"""How far a long piece of work has come: a bar on a terminal, nothing anywhere else.

It is drawn by who does the work, step by step, and not by a thread beside it: a process that runs nothing else can be
copied (`classroom/pool.py`), and all signals come to the one thread.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from time import monotonic
from typing import TYPE_CHECKING, TextIO

from dhcli.render.paper import Paper

if TYPE_CHECKING:
    from rich.progress import Progress, ProgressColumn

_OFTEN = 0.1
"""Seconds after which a step is drawn: eyes follow no faster, and drawing takes a millisecond."""


@contextmanager
def progress(what: str, total: int, stream: TextIO) -> Iterator[Callable[[], None]]:
    """Show a bar while something is done, and take it away afterwards.

    Args:
        what: What is done.
        total: How many steps there are.
        stream: Where the bar is drawn; if it is no terminal, nothing is.

    Yields:
        What to call after each step.
    """
    paper = Paper.of(stream)
    if not paper.terminal:
        yield lambda: None
        return
    from rich.progress import BarColumn, MofNCompleteColumn, TextColumn, TimeRemainingColumn

    columns = (TextColumn("{task.description}", markup=False), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn())
    with _bar(paper, stream, *columns) as bar:
        task, is_due = bar.add_task(paper.spell(what), total=total), _clock()
        yield lambda: bar.update(task, advance=1, refresh=is_due())


@contextmanager
def row_progress(stream: TextIO, *, wanted: bool = True) -> Iterator[Callable[[int, float | None], None]]:
    """Show how many rows are done while they are, and take it away afterwards.

    Args:
        stream: Where it is drawn; if it is no terminal, nothing is.
        wanted: Whether to draw at all; rows on the same terminal would run through the bar.

    Yields:
        What to call with the rows done so far and the share of the work they are, None where nobody knows.
    """
    paper = Paper.of(stream)
    if not paper.terminal or not wanted:
        yield lambda _rows, _share: None
        return
    from rich.progress import BarColumn, TextColumn, TimeRemainingColumn

    columns = (BarColumn(), TextColumn("{task.description}", markup=False), TimeRemainingColumn())
    with _bar(paper, stream, *columns) as bar:
        task, is_due = bar.add_task("0 rows", total=None), _clock()

        def tell(rows: int, share: float | None) -> None:
            total, done = None if share is None else 1.0, share or 0.0
            bar.update(task, description=f"{rows:,} rows", total=total, completed=done, refresh=is_due())

        yield tell


def _bar(paper: Paper, stream: TextIO, *columns: ProgressColumn) -> Progress:
    """A bar that is taken away in the end; rich would put itself before both streams, but results go their own way."""
    from rich.console import Console
    from rich.progress import Progress

    console = Console(file=stream, width=paper.width, no_color=not paper.colour, legacy_windows=False)
    return Progress(
        *columns, console=console, transient=True, redirect_stdout=False, redirect_stderr=False, auto_refresh=False
    )


def _clock() -> Callable[[], bool]:
    """Tells, each time it is asked, whether the time to draw again has come."""
    due = monotonic() + _OFTEN

    def is_due() -> bool:
        nonlocal due
        now = monotonic()
        if now < due:
            return False
        due = now + _OFTEN
        return True

    return is_due
