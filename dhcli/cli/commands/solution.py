"""`dhcli solution`: a part worked out step by step."""

from __future__ import annotations

import sys
from typing import Annotated

import typer

from dhcli.cli.shell.options import ExerciseName, Untried, Variant

EXAMPLES = """
[bold]Examples[/]

dhcli solution planar-two-links --part t02 --yes

dhcli solution planar-two-links --yes
"""


def solution(
    name: ExerciseName,
    part: Annotated[str | None, typer.Option(metavar="PART", help="Only this part.")] = None,
    variant: Variant = None,
    yes: Untried = False,
) -> None:
    """Work an exercise out, step by step; asks once before it shows what was never tried."""
    from dhcli.checking.judge import Judge
    from dhcli.checking.variants import variant_of
    from dhcli.cli.shell.console import write_out
    from dhcli.cli.shell.untried import ask_once
    from dhcli.files.yaml.exercises import load_exercise
    from dhcli.render.paper import Paper
    from dhcli.render.text.worked import solutions_text

    judge = variant_of(Judge(load_exercise(name)), variant)
    exercise = judge.exercise
    parts = (exercise.part(part),) if part else exercise.asked
    if not yes:
        ask_once(exercise, parts)
    paper = Paper.of(sys.stdout)
    write_out(solutions_text(exercise, {one.id: judge.solution(one) for one in parts}, paper))
