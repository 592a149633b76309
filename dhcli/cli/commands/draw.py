"""`dhcli draw`: a robot, a linkage or the sheet of an exercise as a picture, in the terminal or in a file."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Annotated, Any

import typer

from dhcli.cli.shell import completing
from dhcli.cli.shell.chosen import Chosen
from dhcli.cli.shell.many import In, named_file
from dhcli.cli.shell.options import AnyName, Untried, Variant
from dhcli.cli.shell.spreading import But
from dhcli.cli.shell.written import Overwrite, output_option
from dhcli.errors import DhcliError
from dhcli.frozen import frozen

if TYPE_CHECKING:
    from dhcli.render.pictures.picture import Picture

    View = tuple[float, float] | None

EXAMPLES = """
[bold]Examples[/]

dhcli draw puma560

dhcli draw scara --pose pick -o scara.svg

dhcli draw panda --worksheet --table -o sheet.pdf

dhcli draw scara --pose zero --to pick --animate -o move.svg

dhcli draw peaucellier -o peaucellier.html

dhcli draw stanford-arm -o task.pdf
"""

LOOK = "How it looks"


@frozen
class Motion:
    """Where a robot moves to, and what stands over it, as it was typed."""

    to: Annotated[
        str | None,
        typer.Option(
            "--to",
            metavar="VALUES",
            help="Joint values or a pose to move to: a film strip, and a page that plays it.",
            autocompletion=completing.of_robot("poses"),
        ),
    ] = None
    rows: Annotated[
        str | None,
        typer.Option(
            "--rows", metavar="FILE", help="A motion through joint values, a row each: .csv, .jsonl or .npy; as in fk."
        ),
    ] = None
    in_: In = None
    animate: Annotated[
        bool, typer.Option("--animate", help="An .svg of a motion moves by itself instead of being a strip.")
    ] = False
    beside: Annotated[
        str | None,
        typer.Option(
            "--beside",
            metavar="NAME",
            help="Another table of this arm over it, and where they part: a robot or a file.",
        ),
    ] = None

    @property
    def path(self) -> str | None:
        """The file with the rows."""
        return named_file(self.rows, self.in_)


@frozen
class Looks:
    """How a picture looks, as it was typed."""

    view: Annotated[
        str | None,
        typer.Option(
            "--view",
            metavar="VIEW",
            help="iso, front, side, top, or azimuth and elevation such as 30,20; by default the best.",
            rich_help_panel=LOOK,
            autocompletion=completing.among("iso", "front", "side", "top"),
        ),
    ] = None
    size: Annotated[
        str | None,
        typer.Option(
            "--size",
            metavar="WxH",
            help="Pixels such as 820x640, or columns and rows of letters.",
            rich_help_panel=LOOK,
        ),
    ] = None
    dark: Annotated[bool, typer.Option("--dark", help="Light on dark.", rich_help_panel=LOOK)] = False
    worksheet: Annotated[
        bool, typer.Option("--worksheet", help="Leave the frames to the student.", rich_help_panel=LOOK)
    ] = False
    table: Annotated[bool, typer.Option("--table", help="Put the DH table beside.", rich_help_panel=LOOK)] = False


@frozen
class OfExercise:
    """What the picture of an exercise shows, as it was typed."""

    solution: Annotated[
        bool, typer.Option("--solution", help="Of an exercise: with the frames that its picture leaves to you.")
    ] = False
    yes: Untried = False
    variant: Variant = None


@frozen
class Sheet:
    """Where a picture goes, as it was typed."""

    output: Annotated[str | None, output_option("Write a file: .svg .tex .png .pdf .html, or .txt for letters.")] = None
    open_: Annotated[
        bool, typer.Option("--open", help="Open it in the browser; without -o as a page.", rich_help_panel="Output")
    ] = False
    overwrite: Overwrite = False


def draw(
    chosen: Annotated[Chosen, But(without=("motors", "from_", "to"), instead={"robot": AnyName})],
    motion: Motion,
    looks: Looks,
    task: OfExercise,
    sheet: Sheet,
) -> None:
    """Draw a robot at a pose, a linkage, or the arm of an exercise, in the terminal or in a file.

    Without --q and --pose the robot stands as shows it best.
    """
    from dhcli.cli.shell.delivery import check_overwrite
    from dhcli.cli.shell.pictures import in_letters, sides
    from dhcli.files.library.kinds import kind_of
    from dhcli.render.pictures.picture import format_of
    from dhcli.scene.camera import read_view

    check_overwrite(sheet.output, overwrite=sheet.overwrite)
    name = None if sheet.output in (None, "-") else format_of(sheet.output or "")
    view = None if looks.view is None else read_view(looks.view)
    is_exercise = kind_of(chosen.robot).noun == "exercise"
    picture = (_exercise if is_exercise else _arm)(chosen, motion, looks, task, view)
    pixels = None if looks.size is None else sides(looks.size)
    _check(picture, name, motion, looks)
    if name is None and not sheet.open_:
        in_letters(picture, pixels)
        return
    path = _saved(picture, name, pixels, sheet, animate=motion.animate)
    if sheet.open_:
        import webbrowser
        from pathlib import Path

        webbrowser.open(Path(path).resolve().as_uri())


def _exercise(chosen: Chosen, motion: Motion, looks: Looks, task: OfExercise, view: View) -> Picture:
    """The pictures of an exercise on one sheet.

    Raises:
        DhcliError: Something is given that the exercise says itself.
    """
    from dhcli.cli.shell.drawn import of_exercise
    from dhcli.render.pictures.picture import Picture

    if chosen.more or looks.table or motion.to or motion.beside or motion.path:
        raise DhcliError(
            f"{chosen.robot} is an exercise: it says itself what is given", "--view, --size and --dark are free"
        )
    first, *others = (
        Picture(view=view, dark=looks.dark, **{**one, "worksheet": looks.worksheet or one["worksheet"]})
        for one in of_exercise(chosen.robot, task.variant, solution=task.solution, yes=task.yes)
    )
    return replace(first, more=tuple(others))


def _arm(chosen: Chosen, motion: Motion, looks: Looks, task: OfExercise, view: View) -> Picture:
    """The picture of a robot or a linkage.

    Raises:
        DhcliError: Something is given that exercises have.
    """
    from dhcli.cli.shell.drawn import find, posed
    from dhcli.render.pictures.picture import Picture

    if task != OfExercise():
        raise DhcliError(f"{chosen.robot} is no exercise: it has no solution and no variants", "leave the option out")
    what = find(chosen)
    given: dict[str, Any] = posed(what, chosen, to=motion.to, beside=motion.beside, rows=motion.path)
    return Picture(what, view=view, dark=looks.dark, worksheet=looks.worksheet, table=looks.table, **given)


def _check(picture: Picture, name: str | None, motion: Motion, looks: Looks) -> None:
    """Refuse a motion or a table where the format has none.

    Raises:
        DhcliError: It has none.
    """
    from dhcli.cli.shell.drawn import refuse_table

    if motion.animate and not picture.moves:
        raise DhcliError("--animate is for a motion, and nothing moves", "--to or --rows says where to")
    if motion.animate and name != "svg":
        hint = "a page plays a motion by itself: leave --animate out" if name in ("page", None) else "write -o move.svg"
        raise DhcliError("only an .svg is animated", hint)
    if looks.table and (name in ("page", "terminal") or name is None):
        refuse_table(picture.what, name)


def _saved(picture: Picture, name: str | None, pixels: tuple[int, int] | None, sheet: Sheet, *, animate: bool) -> str:
    """The file that a picture is in, its own or a page for the browser."""
    from dhcli.cli.shell.pictures import page_to_open, write_letters, write_picture
    from dhcli.render.pictures.picture import check_size

    output = sheet.output or ""
    if name == "terminal":
        write_letters(picture, output, pixels, overwrite=sheet.overwrite)
        return output
    if pixels is not None:
        check_size(pixels)
        picture = replace(picture, size=pixels)
    if name is None:
        return page_to_open(picture, picture.what.name or "linkage")
    write_picture(picture, output, overwrite=sheet.overwrite, animate=animate)
    return output
