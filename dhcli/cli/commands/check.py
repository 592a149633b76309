"""`dhcli check`: is my answer right?"""

from __future__ import annotations

import sys
from dataclasses import replace
from typing import TYPE_CHECKING, Annotated

import typer

from dhcli.cli.shell.chosen import Chosen
from dhcli.cli.shell.options import ExerciseOrRobot, Variant
from dhcli.cli.shell.spreading import But
from dhcli.cli.shell.wishes import QUESTION, Near, RobotQuestion
from dhcli.cli.shell.written import Written, in_formats
from dhcli.errors import DhcliError, ExitStatus
from dhcli.frozen import frozen

if TYPE_CHECKING:
    from dhcli.checking.exercise import Exercise
    from dhcli.checking.judge import Judge
    from dhcli.checking.marked import SheetMark

EXAMPLES = """
[bold]Examples[/]

dhcli check planar-two-links planar-two-links.sheet.yaml

dhcli check planar-two-links --part d02 --answer "a1c1+a2c12, a1s1+a2s12, 0"

dhcli check planar-2r --symbolic --entry 1,4 --answer "a1c1 + a2c12"

dhcli check scara --pose zero --answer "0, 0.5, 0.4" --tol-position 0.5mm

dhcli check scara --q 0.3,0.5,0.1 --answer "-0.2321, 0.4259, 0.3"

dhcli check puma560 --pose ready --as rpy --answer "0, 0, 180°"

dhcli check planar-2r --ik --position 0.5,0.3,0 --answer "2.477°, 67.98°"

dhcli check puma560 --table my-table.yaml

dhcli check puma560 --frames my-frames.yaml
"""


@frozen
class Given:
    """The answer that is given, as it was typed."""

    sheet: Annotated[str | None, typer.Argument(metavar="SHEET", help="The answer sheet; - is stdin.")] = None
    part: Annotated[str | None, typer.Option(metavar="PART", help="Look at this part only.")] = None
    answer: Annotated[str | None, typer.Option(metavar="TEXT", help="The answer itself; - is stdin.")] = None


def check(
    chosen: Annotated[Chosen, But(instead={"robot": ExerciseOrRobot}, panel=QUESTION)],
    given: Given,
    variant: Variant = None,
    *,
    asked: RobotQuestion,
    near: Near,
    why: Annotated[bool, typer.Option("--why", help="Name the slip behind a wrong answer.")] = False,
    draw: Annotated[
        str | None,
        typer.Option(
            metavar="FILE",
            help="Draw the answer over the right arm, and mark the first frame that differs: .svg .pdf .png .tex .txt.",
            rich_help_panel="Output",
        ),
    ] = None,
    out: Annotated[Written, in_formats(("table", "json", "csv"), (".json", ".csv", ".txt"))],
) -> ExitStatus:
    """Check an answer sheet, one answer, a DH table, or frames."""
    from dhcli.checking.judge import Judge
    from dhcli.checking.variants import variant_of
    from dhcli.cli.shell.overlaid import check_overlaid, draw_over
    from dhcli.cli.shell.quiz import exercise_of, exit_code, is_asked, remember, with_tolerance
    from dhcli.files.reading import read_text
    from dhcli.kinematics.limits import warnings

    delivery = (replace(out, overwrite=False) if draw and out.output is None else out).delivery("check", "marks")
    if draw is not None:
        from dhcli.cli.shell.pictures import check_picture

        check_picture(draw, overwrite=out.overwrite, page="a page shows one table")
    is_given = _is_given(asked, given)
    if draw is not None and not is_given:
        raise DhcliError("--draw draws an answer that was given", "name a sheet, --answer, --table or --frames")
    answer = read_text("-") if given.answer == "-" else given.answer
    exercise, stated = exercise_of(chosen, asked, answer or "")
    warned = tuple(warnings(exercise.robot, exercise.given)) if is_asked(chosen, asked) and exercise.robot else ()
    exercise = with_tolerance(exercise, near)
    if draw is not None:
        check_overlaid(exercise, given.part)
    if not is_given:
        delivery.warn(warned)
        return _walk(variant_of(Judge(exercise), variant), given.part, why=why)
    marked, answers = _marked(exercise, given, stated if answer is None else answer, variant)
    remember(marked)
    delivery.hand_over("marks", replace(marked, why=why), warned)
    if draw is not None:
        draw_over(marked, answers, draw, overwrite=out.overwrite)
    return exit_code(marked.verdict)


def _is_given(asked: RobotQuestion, given: Given) -> bool:
    """Whether there is an answer to check.

    Raises:
        DhcliError: There are several, what belongs to `--ik` stands without it, or standard input is wanted twice.
    """
    if not asked.ik and (asked.target, asked.position, asked.branch) != (None, None, None):
        raise DhcliError("--target, --position and --branch belong to --ik", "add --ik")
    if asked.ik and asked.target == given.answer == "-":
        raise DhcliError("the pose and the answer cannot both come from standard input", "save one in a file")
    ways = sum(source is not None for source in (given.sheet, given.answer, asked.table, asked.frames))
    if ways > 1:
        raise DhcliError("a sheet, --answer, --table and --frames are ways to give an answer", "use one of them")
    return ways == 1


def _marked(exercise: Exercise, given: Given, answer: str, variant: str | None) -> tuple[SheetMark, dict[str, str]]:
    """The judgement on a sheet, or on one answer; and the answers by part."""
    from dhcli.checking.judge import Judge
    from dhcli.checking.variants import variant_of
    from dhcli.files.yaml.sheets import judged_sheet, read_sheet

    if given.sheet is None:
        judge = variant_of(Judge(exercise), variant)
        only = _meant(exercise, given.part)
        answers = {only: answer}
        return judge.sheet(answers, only=only), answers
    read = read_sheet(given.sheet)
    exercise.accepts(read.exercise, given.sheet)
    marked = judged_sheet(Judge(exercise), read, given.sheet, variant, given.part)
    return marked, {name: one.text for name, one in read.answers.items()}


def _walk(judge: Judge, part: str | None, *, why: bool) -> ExitStatus:
    """Ask part by part, on a terminal only: a script must never wait."""
    from dhcli.cli.shell.quiz import exit_code

    if not (sys.stdin.isatty() and sys.stdout.isatty()):
        hint = f"dhcli start {judge.exercise.typed} writes one; or give --part PART --answer TEXT"
        if "/" not in judge.exercise.id:
            hint = "give it with --answer TEXT; - reads it from standard input"
        raise DhcliError("there is no answer to check: name a sheet", hint)
    from dhcli.cli.shell.walk import walk

    return exit_code(walk(judge, part, why=why).verdict)


def _meant(exercise: Exercise, part: str | None) -> str:
    """The one part that an answer is to."""
    if part is None and len(exercise.asked) > 1:
        names = ", ".join(one.id for one in exercise.asked)
        raise DhcliError(f"{exercise.id} has {len(exercise.asked)} parts: say which one is answered", f"--part {names}")
    return exercise.part(part).id if part else exercise.asked[0].id
