"""`dhcli solution`: a part worked out step by step."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Annotated

import typer

from dhcli.cli.shell.options import ExerciseName, Variant

if TYPE_CHECKING:
    from dhcli.checking.exercise import Exercise, Part

EXAMPLES = """
[bold]Examples[/]

dhcli solution planar-two-links --part t02 --yes

dhcli solution planar-two-links --yes
"""


def solution(
    name: ExerciseName,
    part: Annotated[str | None, typer.Option(metavar="PART", help="Only this part.")] = None,
    variant: Variant = None,
    yes: Annotated[bool, typer.Option("--yes", help="Show parts that were never tried, too.")] = False,
) -> None:
    """Work an exercise out, step by step; asks once before it shows what was never tried."""
    from dhcli.checking.judge import Judge
    from dhcli.checking.variants import variant_of
    from dhcli.cli.shell.console import write_out
    from dhcli.files.yaml.exercises import load_exercise
    from dhcli.render.paper import Paper
    from dhcli.render.text.marks import solution_text

    judge = variant_of(Judge(load_exercise(name)), variant)
    exercise = judge.exercise
    parts = (exercise.part(part),) if part else exercise.asked
    if not yes:
        ask_once(exercise, parts, "try first with dhcli check, or say --yes")
    paper = Paper.of(sys.stdout)
    write_out("\n".join(solution_text(exercise, one, judge.solution(one), paper) for one in parts))


def ask_once(exercise: Exercise, parts: tuple[Part, ...], hint: str) -> None:
    """Make sure that a person wants to see parts that were never tried.

    Args:
        exercise: The exercise.
        parts: What would be seen.
        hint: What to do where nobody can be asked.

    Raises:
        DhcliError: They do not, or nobody is there to ask.
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
        raise DhcliError(f"never tried: {listed}", hint)
    say(f"You have not tried {paper.spell(listed)} yet. Show the solution all the same? [y/N] ")
    if sys.stdin.readline().strip().lower() not in ("y", "yes"):
        raise DhcliError("not shown", f"dhcli hint {exercise.typed} gives a hint")
