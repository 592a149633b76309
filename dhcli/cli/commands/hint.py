"""`dhcli hint`: help with the next part, one step at a time."""

from __future__ import annotations

import sys
from typing import Annotated

import typer

from dhcli.cli.shell.options import ExerciseName, Variant

EXAMPLES = """
[bold]Examples[/]

dhcli hint planar-two-links

dhcli hint planar-two-links --part t02
"""


def hint(
    name: ExerciseName,
    part: Annotated[str | None, typer.Option(metavar="PART", help="Help with this part.")] = None,
    variant: Variant = None,
) -> None:
    """Show the next hint, for the first part that is not solved yet or the one named."""
    from dhcli.checking.judge import Judge
    from dhcli.checking.variants import variant_of
    from dhcli.cli.shell.console import tell, write_out
    from dhcli.cli.shell.quiz import first_open
    from dhcli.files.progress import Try, read_progress, record_hint
    from dhcli.files.yaml.exercises import load_exercise
    from dhcli.render.paper import Paper
    from dhcli.render.text.prose import prose_lines

    exercise = variant_of(Judge(load_exercise(name)), variant).exercise
    progress, message = read_progress()
    done = progress.get(exercise.id, {})
    meant = exercise.part(part) if part else first_open(exercise, {p: t.best for p, t in done.items()})
    shown = done.get(meant.id, Try("SKIPPED", 0)).hints
    paper = Paper.of(sys.stdout)
    if not meant.hints:
        write_out(f"{paper.spell(meant.id)}: there is no hint for this part\n")
        return
    number = min(shown, len(meant.hints) - 1)
    text = f"{meant.id}, hint {number + 1} of {len(meant.hints)}: {meant.hints[number]}"
    write_out("".join(f"{line}\n" for line in prose_lines(text, paper)))
    message = message or record_hint(exercise.id, meant.id)
    if message:
        tell(f"dhcli: {message}")
    if number + 1 == len(meant.hints):
        tell(f"that was the last one; dhcli solution {exercise.typed} --part {meant.id} works it out")
