"""`dhcli watch`: the sheet checked again at each save, on one screen."""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Annotated

import typer

from dhcli.cli.shell.options import ExerciseName, Variant

if TYPE_CHECKING:
    from dhcli.checking.judge import Judge

EXAMPLES = """
[bold]Examples[/]

dhcli watch planar-two-links planar-two-links.sheet.yaml
"""

PAUSE = 0.2
"""Seconds between two looks at the file."""

CLEAR = "\x1b[2J\x1b[H"
KEYS = "h hint · r check again · q quit"


def watch(
    name: ExerciseName,
    sheet: Annotated[
        str | None, typer.Argument(metavar="SHEET", help="The sheet; by default the one start wrote.")
    ] = None,
    variant: Variant = None,
) -> None:
    """Check a sheet again whenever it is saved, until q or Ctrl-C."""
    from dhcli.checking.judge import Judge
    from dhcli.errors import DhcliError
    from dhcli.files.yaml.exercises import load_exercise

    exercise = load_exercise(name)
    path = sheet or f"{exercise.id.split('/')[-1]}.sheet.yaml"
    if not os.path.isfile(path):  # noqa: PTH113
        raise DhcliError(f"there is no sheet {path}", f"dhcli start {exercise.id} -o {path} writes one")
    if not sys.stdout.isatty():
        raise DhcliError("watch needs a terminal", f"dhcli check {exercise.id} {path} checks once")
    with _single_keys() as key:
        _watch(Judge(exercise), path, variant, key)


def _watch(judge: Judge, path: str, variant: str | None, key: Callable[[float], str]) -> None:
    """Draw the screen at each save and at each key."""
    seen: tuple[int, int] | None = None
    hints = 0
    while True:
        now = _stamp(path)
        pressed = key(PAUSE) if now == seen else ""
        if pressed == "q":
            return
        if now == seen and pressed not in ("h", "r"):
            continue
        hints = hints + 1 if pressed == "h" else 0 if now != seen else hints
        seen = now
        _draw(judge, path, variant, hints)


def _stamp(path: str) -> tuple[int, int]:
    """When a file was changed and how long it is; an editor that replaces the file may take it away for a moment."""
    try:
        found = os.stat(path)  # noqa: PTH116
    except OSError:
        return (0, 0)
    return found.st_mtime_ns, found.st_size


def _draw(judge: Judge, path: str, variant: str | None, hints: int) -> None:
    from dhcli.cli.shell.console import write_out
    from dhcli.cli.shell.quiz import first_open, remember
    from dhcli.errors import DhcliError
    from dhcli.files.yaml.sheets import judged_sheet, read_sheet
    from dhcli.render.look import Look, render
    from dhcli.render.paper import Paper
    from dhcli.render.text.problems import problems_text
    from dhcli.render.text.prose import prose_lines

    paper = Paper.of(sys.stdout)
    try:
        read = read_sheet(path)
        judge.exercise.accepts(read.exercise, path)
        marked = judged_sheet(judge, read, path, variant)
    except DhcliError as error:
        write_out(f"{CLEAR}{problems_text(error.problems, paper)}\n{paper.ink(KEYS, 'dim')}\n")
        return
    remember(marked)
    text = render("marks", marked, Look(paper=paper))
    if hints:
        part = first_open(marked.exercise, {p.part.id: p.mark.verdict.word for p in marked.parts})
        shown = part.hints[min(hints, len(part.hints)) - 1] if part.hints else "there is no hint for this part"
        text += "".join(f"\n{line}" for line in prose_lines(f"hint for {part.id}: {shown}", paper)) + "\n"
    at = time.strftime("%H:%M:%S")
    write_out(f"{CLEAR}{text}\n{paper.ink(paper.spell(f'{path}, checked at {at} · {KEYS}'), 'dim')}\n")
    sys.stdout.flush()


@contextmanager
def _single_keys() -> Iterator[Callable[[float], str]]:
    """Keys without Enter where the system can; elsewhere a mere pause."""
    try:
        import select
        import termios
        import tty
    except ImportError:
        yield _only_pause
        return
    if not sys.stdin.isatty():
        yield _only_pause
        return
    descriptor = sys.stdin.fileno()
    before = termios.tcgetattr(descriptor)

    def key(seconds: float) -> str:
        ready, _, _ = select.select([descriptor], [], [], seconds)
        return os.read(descriptor, 1).decode("ascii", "ignore").lower() if ready else ""

    try:
        tty.setcbreak(descriptor)
        yield key
    finally:
        termios.tcsetattr(descriptor, termios.TCSADRAIN, before)


def _only_pause(seconds: float) -> str:
    time.sleep(seconds)
    return ""
