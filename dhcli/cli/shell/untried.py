"""What a person sees only once it was tried: the solution of a part, and a picture with it."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from dhcli.checking.exercise import Exercise, Part


def ask_once(exercise: Exercise, parts: Sequence[Part]) -> None:
    """Make sure that a person wants to see parts that were never tried.

    Raises:
        DhcliError: They do not, or nobody is there to ask; it says which part is yet to try, and how.
    """
    from dhcli.cli.shell.console import say
    from dhcli.errors import DhcliError
    from dhcli.files.progress import Try, read_progress
    from dhcli.render.paper import Paper

    done = read_progress()[0].get(exercise.id, {})
    untried = [part.id for part in parts if not done.get(part.id, Try("", 0)).tries]
    if not untried:
        return
    listed = ", ".join(untried)
    paper = Paper.of(sys.stderr)
    if not sys.stdin.isatty():
        first = "it" if len(untried) == 1 else untried[0]
        hint = f"dhcli check {exercise.typed} --part {untried[0]} asks for {first}; --yes shows what was not tried"
        raise DhcliError(f"never tried: {listed}", hint)
    say(f"You have not tried {paper.spell(listed)} yet. Show the solution all the same? [y/N] ")
    if sys.stdin.readline().strip().lower() not in ("y", "yes"):
        raise DhcliError("not shown", f"dhcli hint {exercise.typed} gives a hint")
