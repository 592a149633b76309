"""`dhcli start`: an answer sheet to fill in."""

from __future__ import annotations

import shlex
import sys
from typing import TYPE_CHECKING, Annotated

import typer

from dhcli.cli.shell.options import ExerciseName, Variant
from dhcli.cli.shell.written import Overwrite, output_option

if TYPE_CHECKING:
    from dhcli.checking.exercise import Exercise

EXAMPLES = """
[bold]Examples[/]

dhcli start planar-two-links

dhcli start planar-two-links -o -

dhcli start planar-in-numbers --variant alice

dhcli start planar-in-numbers --class names.txt -o homework-4
"""


def start(
    name: ExerciseName,
    variant: Variant = None,
    class_: Annotated[
        str | None,
        typer.Option(
            "--class", metavar="FILE", help="A sheet for each name in FILE, one a line, with numbers of its own."
        ),
    ] = None,
    output: Annotated[
        str | None, output_option("Where to write it; - is stdout. With --class the folder of the sheets.")
    ] = None,
    overwrite: Overwrite = False,
) -> None:
    """Write an answer sheet for an exercise, or one for each student of a class."""
    from dhcli.checking.judge import Judge
    from dhcli.checking.variants import variant_of
    from dhcli.cli.shell.console import tell, write_out
    from dhcli.cli.shell.delivery import write_file
    from dhcli.errors import DhcliError
    from dhcli.files.library.entries import YAML
    from dhcli.files.yaml.exercises import load_exercise
    from dhcli.files.yaml.sheets import write_sheet
    from dhcli.render.endings import check_ending
    from dhcli.render.paper import Paper

    judge = Judge(load_exercise(name))
    if class_ is not None:
        from dhcli.cli.shell.roster import start_class

        if variant is not None or output == "-":
            raise DhcliError("--class writes a sheet for each name into a folder", "leave out --variant, and -o -")
        start_class(judge, class_, output, overwrite=overwrite)
        return
    exercise = variant_of(judge, variant).exercise
    text = write_sheet(exercise)
    if output == "-":
        if not exercise.variant.isascii() and not Paper.of(sys.stdout).unicode:
            message = f"this output has no letters for {exercise.variant}, and another name draws other numbers"
            raise DhcliError(message, "-o FILE.yaml writes the sheet")
        write_out(text)
        return
    check_ending(output, "yaml")
    path = output or f"{exercise.file_name}.sheet.yaml"
    write_file(path, text, overwrite=overwrite, instead="it may hold answers: -o OTHER.yaml writes another; ")
    tell(f"wrote {path}")
    _tell_next(exercise, shlex.quote(name) if name.endswith(YAML) else exercise.id, path, variant)


def _tell_next(exercise: Exercise, named: str, path: str, variant: str | None) -> None:
    """What is typed next: for a picture, and when the sheet is filled in."""
    from dhcli.checking.figures import subject
    from dhcli.cli.shell.console import tell

    if pictured := subject(exercise):
        drawn = f" --variant {shlex.quote(variant)}" if variant else ""
        tell(f"dhcli draw {named}{drawn} draws {pictured}")
    words = f"{named} {shlex.quote(path)}"
    tell(f"next: fill it in, then dhcli check {words}, or dhcli watch {words}")
