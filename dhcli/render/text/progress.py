"""How far a long piece of work has come: a bar on a terminal, nothing anywhere else."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, TextIO

from dhcli.render.paper import Paper

if TYPE_CHECKING:
    from rich.progress import Progress, ProgressColumn


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
        task = bar.add_task(paper.spell(what), total=total)
        yield lambda: bar.advance(task)


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
        task = bar.add_task("0 rows", total=None)

        def tell(rows: int, share: float | None) -> None:
            bar.update(task, description=f"{rows:,} rows", total=None if share is None else 1.0, completed=share or 0.0)

        yield tell


def _bar(paper: Paper, stream: TextIO, *columns: ProgressColumn) -> Progress:
    """A bar that is taken away in the end; rich would put itself before both streams, but results go their own way."""
    from rich.console import Console
    from rich.progress import Progress

    console = Console(file=stream, width=paper.width, no_color=not paper.colour, legacy_windows=False)
    return Progress(*columns, console=console, transient=True, redirect_stdout=False, redirect_stderr=False)
