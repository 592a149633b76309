"""`dhcli watch`: the sheet checked again at each save, on one screen."""

from __future__ import annotations

import os
import shutil
import sys
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import field, replace
from typing import TYPE_CHECKING, Annotated

import typer

from dhcli.cli.shell.options import ExerciseName, Variant
from dhcli.frozen import frozen

if TYPE_CHECKING:
    from dhcli.checking.judge import Judge
    from dhcli.checking.marked import SheetMark
    from dhcli.errors import Problem

EXAMPLES = """
[bold]Examples[/]

dhcli watch planar-two-links planar-two-links.sheet.yaml --why
"""

PAUSE = 0.2
"""Seconds between two looks at the file."""

CLEAR = "\x1b[2J\x1b[H"
KEYS = "h hint · w names · r check again · q quit"


@frozen
class Seen:
    """What was found in the sheet.

    Attributes:
        at: When.
        marked: Its judgement; None where it cannot be judged.
        texts: Its answers by part.
        problems: Why it cannot be judged.
    """

    at: str = ""
    marked: SheetMark | None = None
    texts: Mapping[str, str] = field(default_factory=dict)
    problems: tuple[Problem, ...] = ()


def watch(
    name: ExerciseName,
    sheet: Annotated[
        str | None, typer.Argument(metavar="SHEET", help="The sheet; by default the one start wrote.")
    ] = None,
    variant: Variant = None,
    why: Annotated[bool, typer.Option("--why", help="Name the slips behind wrong answers.")] = False,
) -> None:
    """Check a sheet again whenever it is saved, until q or Ctrl-C."""
    from dhcli.checking.judge import Judge
    from dhcli.errors import DhcliError
    from dhcli.files.yaml.exercises import load_exercise

    exercise = load_exercise(name)
    path = sheet or f"{exercise.file_name}.sheet.yaml"
    if not os.path.isfile(path):  # noqa: PTH113
        drawn = replace(exercise, variant=variant or "")
        raise DhcliError(f"there is no sheet {path}", f"dhcli start {drawn.typed} -o {path} writes one")
    if not sys.stdout.isatty():
        raise DhcliError("watch needs a terminal", f"dhcli check {exercise.id} {path} checks once")
    with _single_keys() as key:
        _watch(Judge(exercise), path, variant, key, why=why)


def _watch(judge: Judge, path: str, variant: str | None, key: Callable[[float], str], *, why: bool) -> None:
    """Draw the screen at each save, at each key, and when the window gets another size."""
    from dhcli.files.library.catalogue import stamp

    saved: tuple[int, int] | None = None
    size = shutil.get_terminal_size()
    seen, texts, hints = Seen(), dict[str, str](), 0
    while True:
        now = stamp(path), shutil.get_terminal_size()
        is_same = now == (saved, size)
        pressed = key(PAUSE) if is_same else ""
        if pressed == "q":
            return
        if is_same and pressed not in ("h", "w", "r"):
            continue
        if now[0] != saved or pressed == "r":
            before, seen = seen, _looked(judge, path, variant)
            texts = _remembered(seen, texts)
            hints = hints if seen.texts == before.texts else 0
        hints += pressed == "h"
        why ^= pressed == "w"
        saved, size = now
        _draw(seen, path, hints, why=why)


def _looked(judge: Judge, path: str, variant: str | None) -> Seen:
    """The sheet as it is now, judged."""
    from dhcli.errors import DhcliError
    from dhcli.files.yaml.sheets import judged_sheet, read_sheet

    at = time.strftime("%H:%M:%S")
    try:
        read = read_sheet(path)
        judge.exercise.accepts(read.exercise, path)
        marked = judged_sheet(judge, read, path, variant)
    except DhcliError as error:
        return Seen(at, problems=error.problems)
    return Seen(at, marked, {name: answer.text for name, answer in read.answers.items()})


def _remembered(seen: Seen, counted: Mapping[str, str]) -> dict[str, str]:
    """Note the verdicts on answers that are new, for one that was judged before is not tried again by a save.

    Returns:
        The answer to each part that was judged last.
    """
    from dhcli.cli.shell.quiz import remember

    if seen.marked is not None:
        new = tuple(one for one in seen.marked.parts if seen.texts.get(one.part.id, "") != counted.get(one.part.id, ""))
        remember(replace(seen.marked, parts=new))
    return {**counted, **seen.texts}


def _draw(seen: Seen, path: str, hints: int, *, why: bool) -> None:
    from dhcli.cli.shell.console import write_out
    from dhcli.cli.shell.quiz import first_open
    from dhcli.render.kinds import render
    from dhcli.render.look import Look
    from dhcli.render.paper import Paper
    from dhcli.render.text.problems import problems_text
    from dhcli.render.text.prose import prose_lines

    paper, marked = Paper.of(sys.stdout), seen.marked
    if marked is None:
        text = problems_text(seen.problems, paper)
    else:
        text = render("marks", replace(marked, why=why), Look(paper=paper))
    if hints and marked is not None:
        part = first_open(marked.exercise, {p.part.id: p.mark.verdict.word for p in marked.parts})
        shown = part.hints[min(hints, len(part.hints)) - 1] if part.hints else "there is no hint for this part"
        text += "".join(f"\n{line}" for line in prose_lines(f"hint for {part.id}: {shown}", paper)) + "\n"
    foot = f"{path}, checked at {seen.at} · {KEYS}"
    text += "\n" + "".join(f"{paper.ink(line, 'dim')}\n" for line in prose_lines(foot, paper))
    write_out(f"{CLEAR}{text}")
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
