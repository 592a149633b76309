"""How far a long piece of work has come: a bar on a terminal, nothing anywhere else."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TextIO

from dhcli.render.paper import Paper


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
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

    console = Console(file=stream, width=paper.width, no_color=not paper.colour, legacy_windows=False)
    columns = (TextColumn("{task.description}", markup=False), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn())
    with Progress(*columns, console=console, transient=True) as bar:
        task = bar.add_task(paper.spell(what), total=total)
        yield lambda: bar.advance(task)
