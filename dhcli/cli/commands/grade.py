"""`dhcli grade`: a class's sheets graded at once."""

from __future__ import annotations

import re
import sys
from typing import TYPE_CHECKING, Annotated

import typer

from dhcli.cli.shell import completing
from dhcli.cli.shell.options import Jobs, workers
from dhcli.cli.shell.written import Written, in_formats
from dhcli.errors import ExitStatus

if TYPE_CHECKING:
    from dhcli.classroom.folder import Folder
    from dhcli.classroom.grades import Graded

EXAMPLES = """
[bold]Examples[/]

dhcli grade homework-3

dhcli grade homework-3 --exercise planar-two-links -o grades.csv

dhcli grade submission --format gradescope -o results.json
"""
_SHEETS = 12
"""Sheets that take as long as the start of a process."""
_SECONDS = {"ms": 0.001, "s": 1.0, "min": 60.0, "": 1.0}


def grade(
    folder: Annotated[
        str, typer.Argument(metavar="FOLDER", help="The sheets; in folders of their own for each student, or not.")
    ],
    exercise: Annotated[
        str | None,
        typer.Option(
            metavar="NAME", help="The exercise; by default each sheet says its own.", autocompletion=completing.exercise
        ),
    ] = None,
    timeout: Annotated[str, typer.Option(metavar="TIME", help="Longest that one sheet may take.")] = "10s",
    jobs: Jobs = None,
    *,
    out: Annotated[Written, in_formats(("table", "json", "csv", "gradescope"), (".json", ".csv", ".txt"))],
) -> ExitStatus:
    """Grade every sheet in a folder."""
    from dhcli.classroom.folder import find_sheets
    from dhcli.classroom.grading import grade_all
    from dhcli.classroom.report import report_on
    from dhcli.cli.shell.console import tell
    from dhcli.render.text.grades import summary
    from dhcli.render.text.progress import progress

    delivery = out.delivery("grade", "class")
    name = delivery.chosen("class")
    delivery.check_output()
    seconds = _seconds(timeout)
    found = find_sheets(folder, may_be_none=name == "gradescope")
    if exercise is not None:
        _check_exercise(exercise)
    if name == "gradescope" and len(found.submissions) != 1:
        report = report_on(found, [_no_single(found)])
        delivery.hand_over("class", report)
        return ExitStatus.NOT_RIGHT
    with progress("grading", len(found.submissions), sys.stderr) as count:
        shared = workers(jobs, 1 + len(found.submissions) // _SHEETS)
        rows = grade_all(found.submissions, exercise, jobs=shared, timeout=seconds, tell=count)
    report = report_on(found, rows)
    delivery.hand_over("class", report)
    if out.output:
        tell(summary(report))
    return ExitStatus.NOT_RIGHT if report.failed else ExitStatus.DONE


def _no_single(found: Folder) -> Graded:
    """The row of a submission without a sheet, or with several: its student must learn why there is no score."""
    from dhcli.classroom.grades import Graded
    from dhcli.errors import Problem

    hint = "hand in one file that ends in .yaml, the sheet that dhcli start writes"
    sheets = [one.sheet for one in found.submissions]
    if sheets:
        message = f"this submission holds {len(sheets)} sheets, {', '.join(sheets)}, and one is graded"
    else:
        message = "this submission holds no sheet"
        message += f", but {', '.join(found.others)}" if found.others else ""
    return Graded("", "", problems=(Problem(message, hint=hint),))


def _check_exercise(name: str) -> None:
    """Make sure that every process will find the exercise."""
    from dhcli.errors import DhcliError, Place, Problem
    from dhcli.files.yaml.exercises import load_exercise

    if name == "-":
        hint = "save it and name the file"
        raise DhcliError(Problem("each process reads the exercise, standard input only one", Place("--exercise"), hint))
    load_exercise(name)


def _seconds(text: str) -> float:
    """A time such as 10s, 500ms or 2min."""
    from dhcli.errors import DhcliError, Place, Problem

    found = re.fullmatch(r"(\d{1,6}(?:\.\d{1,6})?)\s*(ms|s|min|)", text.strip(), re.ASCII)
    seconds = float(found[1]) * _SECONDS[found[2]] if found else 0.0
    if seconds == 0.0:
        raise DhcliError(Problem(f"{text} is no time", Place("--timeout"), "write 10s, 500ms or 2min"))
    return seconds
