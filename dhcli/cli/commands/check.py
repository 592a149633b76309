"""`dhcli check`: is my answer right?"""

from __future__ import annotations

import sys
from dataclasses import replace
from typing import TYPE_CHECKING, Annotated

import typer

from dhcli.cli.shell.chosen import Chosen
from dhcli.cli.shell.options import ExerciseOrRobot, Overwrite, Variant, format_option, output_option
from dhcli.cli.shell.spreading import But
from dhcli.errors import ExitStatus

if TYPE_CHECKING:
    from dhcli.checking.exercise import Exercise
    from dhcli.checking.judge import Judge
    from dhcli.cli.shell.goal import Goal

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
_QUESTION = "A question about a robot"
_TOLERANCE = "How near is near enough"


def check(
    chosen: Annotated[Chosen, But(instead={"robot": ExerciseOrRobot}, panel=_QUESTION)],
    sheet: Annotated[str | None, typer.Argument(metavar="SHEET", help="The answer sheet; - is stdin.")] = None,
    part: Annotated[str | None, typer.Option(metavar="PART", help="Look at this part only.")] = None,
    answer: Annotated[str | None, typer.Option(metavar="TEXT", help="The answer itself; - is stdin.")] = None,
    variant: Variant = None,
    symbolic: Annotated[bool, typer.Option("--symbolic", "-s", help="In symbols.", rich_help_panel=_QUESTION)] = False,
    table: Annotated[
        str | None,
        typer.Option(
            metavar="FILE",
            help="A DH table: a robot file in either convention, or rows alone.",
            rich_help_panel=_QUESTION,
        ),
    ] = None,
    frames: Annotated[
        str | None,
        typer.Option(
            metavar="FILE",
            help="Frames on the robot's axes, judged by the rules DH1 to DH3; or a robot file whose table they have.",
            rich_help_panel=_QUESTION,
        ),
    ] = None,
    compare: Annotated[
        str | None,
        typer.Option(
            metavar="HOW",
            help="How the table is compared: same-robot (the default), same-motion or literal.",
            rich_help_panel=_QUESTION,
        ),
    ] = None,
    as_: Annotated[
        str | None,
        typer.Option(
            "--as",
            metavar="FORM",
            help="What is answered: position, rotation, rpy, quaternion, axis-angle, zyz, ...; the shape says it else.",
            rich_help_panel=_QUESTION,
        ),
    ] = None,
    entry: Annotated[
        str | None, typer.Option(metavar="ROW,COLUMN", help="One entry of the pose: 1,4.", rich_help_panel=_QUESTION)
    ] = None,
    ik: Annotated[
        bool, typer.Option("--ik", help="Joint values that reach a pose are answered.", rich_help_panel=_QUESTION)
    ] = False,
    target: Annotated[
        str | None,
        typer.Option(
            metavar="MOVES",
            help="With --ik: moves such as 'Trans(0.4,0,0.3) Rot(y,90°)', a 4x4 matrix, or @FILE.",
            rich_help_panel=_QUESTION,
        ),
    ] = None,
    position: Annotated[
        str | None,
        typer.Option(metavar="X,Y,Z", help="With --ik: where the end is to stand.", rich_help_panel=_QUESTION),
    ] = None,
    branch: Annotated[
        str | None,
        typer.Option(
            metavar="WORDS",
            help="With --ik: which solution is answered, such as 'elbow up', or all; any if left out.",
            rich_help_panel=_QUESTION,
        ),
    ] = None,
    tol_rotation: Annotated[
        float | None, typer.Option(metavar="X", help="Of a direction cosine; 0.001.", rich_help_panel=_TOLERANCE)
    ] = None,
    tol_position: Annotated[
        str | None, typer.Option(metavar="LENGTH", help="Of a length, such as 0.5mm.", rich_help_panel=_TOLERANCE)
    ] = None,
    decimals: Annotated[
        int | None,
        typer.Option(min=1, max=12, metavar="N", help="Decimals the task asks for.", rich_help_panel=_TOLERANCE),
    ] = None,
    why: Annotated[bool, typer.Option("--why", help="Name the slip behind a wrong answer.")] = False,
    draw: Annotated[
        str | None,
        typer.Option(
            metavar="FILE",
            help="Draw the answer over the right arm, and mark the first frame that differs: .svg .pdf .png .tex .txt.",
            rich_help_panel="Output",
        ),
    ] = None,
    format_: Annotated[str | None, format_option("table", "json", "csv")] = None,
    output: Annotated[str | None, output_option(".json", ".csv", ".txt")] = None,
    overwrite: Overwrite = False,
) -> ExitStatus:
    """Check an answer sheet, one answer, a DH table, or frames."""
    from dhcli.checking.judge import Judge
    from dhcli.checking.variants import variant_of
    from dhcli.cli.shell.delivery import Delivery
    from dhcli.cli.shell.drawn import check_picture
    from dhcli.cli.shell.overlaid import check_overlaid, draw_over
    from dhcli.cli.shell.quiz import RobotOptions, exercise_of, exit_code, remember, with_tolerance
    from dhcli.errors import DhcliError
    from dhcli.files.yaml.sheets import judged_sheet, read_sheet
    from dhcli.kinematics.limits import warnings

    delivery = Delivery("check", format_, output=output, overwrite=overwrite and not (draw and output is None))
    delivery.chosen("marks")
    if draw is not None:
        check_picture(draw, overwrite=overwrite, page="a page shows one table")
    goal = _goal(target, position) if ik else None
    if not ik and (target, position, branch) != (None, None, None):
        raise DhcliError("--target, --position and --branch belong to --ik", "add --ik")
    if ik and target == answer == "-":
        raise DhcliError("the pose and the answer cannot both come from standard input", "save one in a file")
    which = (branch or "") if ik else ""
    asked = RobotOptions(chosen, symbolic, table, frames, as_, entry, compare, goal, which)
    answer = None if answer is None else _text(answer)
    exercise, typed = exercise_of(asked, answer or "")
    warned = tuple(warnings(exercise.robot, exercise.given)) if asked.given and exercise.robot else ()
    exercise = with_tolerance(exercise, tol_rotation, tol_position, decimals)
    if sum(source is not None for source in (sheet, answer, table, frames)) > 1:
        raise DhcliError("a sheet, --answer, --table and --frames are ways to give an answer", "use one of them")
    if draw is not None:
        check_overlaid(exercise, part)
    if sheet is None and answer is None and table is None and frames is None:
        if draw is not None:
            raise DhcliError("--draw draws an answer that was given", "name a sheet, --answer, --table or --frames")
        delivery.warn(warned)
        return _walk(variant_of(Judge(exercise), variant), part, why=why)
    if sheet is not None:
        read = read_sheet(sheet)
        exercise.accepts(read.exercise, sheet)
        marked = judged_sheet(Judge(exercise), read, sheet, variant, part)
        answers = {name: one.text for name, one in read.answers.items()}
    else:
        judge = variant_of(Judge(exercise), variant)
        only = _meant(exercise, part)
        answers = {only: typed if answer is None else answer}
        marked = judge.sheet(answers, only=only)
    remember(marked)
    delivery.hand_over("marks", replace(marked, why=why), warned)
    if draw is not None:
        draw_over(marked, answers, draw, overwrite=overwrite)
    return exit_code(marked.verdict)


def _goal(target: str | None, position: str | None) -> Goal:
    from dhcli.cli.shell.goal import Goal

    return Goal(target, position)


def _walk(judge: Judge, part: str | None, *, why: bool) -> ExitStatus:
    """Ask part by part, on a terminal only: a script must never wait."""
    from dhcli.cli.shell.quiz import exit_code
    from dhcli.errors import DhcliError

    if not (sys.stdin.isatty() and sys.stdout.isatty()):
        hint = f"dhcli start {judge.exercise.typed} writes one; or give --part PART --answer TEXT"
        if "/" not in judge.exercise.id:
            hint = "give it with --answer TEXT; - reads it from standard input"
        raise DhcliError("there is no answer to check: name a sheet", hint)
    from dhcli.cli.shell.walk import walk

    return exit_code(walk(judge, part, why=why).verdict)


def _meant(exercise: Exercise, part: str | None) -> str:
    """The one part that an answer is to."""
    from dhcli.errors import DhcliError

    if part is None and len(exercise.asked) > 1:
        names = ", ".join(one.id for one in exercise.asked)
        raise DhcliError(f"{exercise.id} has {len(exercise.asked)} parts: say which one is answered", f"--part {names}")
    return exercise.part(part).id if part else exercise.asked[0].id


def _text(answer: str) -> str:
    """The answer that was typed, or stands on standard input."""
    from dhcli.files.reading import read_text

    return read_text("-") if answer == "-" else answer
