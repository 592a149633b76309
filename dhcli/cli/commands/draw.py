"""`dhcli draw`: a robot, a linkage or the sheet of an exercise as a picture, in the terminal or in a file."""

from __future__ import annotations

import sys
from dataclasses import replace
from typing import TYPE_CHECKING, Annotated, Any, TypeAlias

import typer

from dhcli.cli.shell.chosen import Chosen
from dhcli.cli.shell.options import Untried, Variant, complete_pose, complete_robot
from dhcli.cli.shell.spreading import But
from dhcli.cli.shell.written import Overwrite, file_to_write
from dhcli.errors import DhcliError

if TYPE_CHECKING:
    from dhcli.render.pictures.picture import Picture

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


def complete_view(incomplete: str) -> list[str]:
    """Named views."""
    return [name for name in ("iso", "front", "side", "top") if name.startswith(incomplete)]


Name: TypeAlias = Annotated[
    str,
    typer.Argument(
        metavar="NAME",
        help="A robot, a linkage or an exercise, a YAML or URDF file, or - for a robot on stdin.",
        autocompletion=complete_robot,
    ),
]


def draw(
    chosen: Annotated[Chosen, But(without=("motors", "from_", "to"), instead={"robot": Name})],
    to: Annotated[
        str | None,
        typer.Option(
            "--to",
            metavar="VALUES",
            help="Joint values or a pose to move to: a film strip, and a page that plays it.",
            autocompletion=complete_pose,
        ),
    ] = None,
    in_: Annotated[
        str | None,
        typer.Option(
            "--in", metavar="FILE", help="A motion through joint values, a row each: .csv, .jsonl or .npy; as in fk."
        ),
    ] = None,
    animate: Annotated[
        bool, typer.Option("--animate", help="An .svg of a motion moves by itself instead of being a strip.")
    ] = False,
    beside: Annotated[
        str | None,
        typer.Option(
            "--beside",
            metavar="NAME",
            help="Another table of this arm over it, and where they part: a robot or a file.",
        ),
    ] = None,
    view: Annotated[
        str | None,
        typer.Option(
            "--view",
            metavar="VIEW",
            help="iso, front, side, top, or azimuth and elevation such as 30,20; by default the best.",
            rich_help_panel=LOOK,
            autocompletion=complete_view,
        ),
    ] = None,
    size: Annotated[
        str | None,
        typer.Option(
            "--size",
            metavar="WxH",
            help="Pixels such as 820x640, or columns and rows of letters.",
            rich_help_panel=LOOK,
        ),
    ] = None,
    dark: Annotated[bool, typer.Option("--dark", help="Light on dark.", rich_help_panel=LOOK)] = False,
    worksheet: Annotated[
        bool, typer.Option("--worksheet", help="Leave the frames to the student.", rich_help_panel=LOOK)
    ] = False,
    table: Annotated[bool, typer.Option("--table", help="Put the DH table beside.", rich_help_panel=LOOK)] = False,
    output: Annotated[
        str | None,
        typer.Option(
            "-o",
            "--output",
            metavar="FILE",
            callback=file_to_write,
            help="Write a file: .svg .tex .png .pdf .html, or .txt for letters.",
            rich_help_panel="Output",
        ),
    ] = None,
    solution: Annotated[
        bool, typer.Option("--solution", help="Of an exercise: with the frames that its picture leaves to you.")
    ] = False,
    yes: Untried = False,
    variant: Variant = None,
    open_: Annotated[
        bool, typer.Option("--open", help="Open it in the browser; without -o as a page.", rich_help_panel="Output")
    ] = False,
    overwrite: Overwrite = False,
) -> None:
    """Draw a robot at a pose, a linkage, or the arm of an exercise, in the terminal or in a file.

    Without --q and --pose the robot stands as shows it best.
    """
    from dhcli.cli.shell.delivery import check_overwrite
    from dhcli.cli.shell.drawn import find, of_exercise, posed, refuse_table, sides
    from dhcli.files.library.kinds import kind_of
    from dhcli.render.pictures.picture import Picture, format_of
    from dhcli.scene.camera import read_view

    check_overwrite(output, overwrite=overwrite)
    name = None if output in (None, "-") else format_of(output or "")
    look = {"view": None if view is None else read_view(view), "dark": dark}
    robot = chosen.robot
    if kind_of(robot).noun == "exercise":
        if chosen.more or table or to or beside or in_:
            raise DhcliError(
                f"{robot} is an exercise: it says itself what is given", "--view, --size and --dark are free"
            )
        first, *others = (
            Picture(**look, **{**one, "worksheet": worksheet or one["worksheet"]})  # type: ignore[arg-type]
            for one in of_exercise(robot, variant, solution=solution, yes=yes)
        )
        what, picture = first.what, replace(first, more=tuple(others))
    else:
        if solution or yes or variant is not None:
            raise DhcliError(f"{robot} is no exercise: it has no solution and no variants", "leave the option out")
        what = find(chosen)
        given: dict[str, Any] = posed(what, chosen, to=to, beside=beside, rows=in_)
        picture = Picture(what, worksheet=worksheet, table=table, **look, **given)  # type: ignore[arg-type]
    pixels = None if size is None else sides(size)
    if animate and (name != "svg" or not picture.moves):
        raise DhcliError("--animate is for an .svg of a motion", "--to or --in says where to; a page plays it anyway")
    if table and (name in ("page", "terminal") or name is None):
        refuse_table(what, name)
    if name is None and not open_:
        _in_letters(picture, pixels)
        return
    if name == "terminal":
        path = _written(picture.terminal(None, *(pixels or ())), output or "", overwrite=overwrite)
    else:
        picture = picture if pixels is None else _sized(picture, pixels)
        if name is None:
            path = _opened_page(picture, what.name or "linkage")
        else:
            content = picture.animated() if animate else picture.rendered(name)
            path = _written(content, output or "", overwrite=overwrite)
    if open_:
        import webbrowser
        from pathlib import Path

        webbrowser.open(Path(path).resolve().as_uri())


def _sized(picture: Picture, sides: tuple[int, int]) -> Picture:
    from dhcli.render.pictures.picture import check_size

    check_size(sides)
    return replace(picture, size=sides)


def _in_letters(picture: Picture, sides: tuple[int, int] | None) -> None:
    """The picture on standard output, as large as the window allows."""
    import shutil

    from dhcli.cli.shell.console import write_out
    from dhcli.render.paper import Paper

    paper = Paper.of(sys.stdout)
    columns, rows = sides or (min(paper.width, 120), None)
    if sides is None and paper.terminal:
        rows = max(8, min(round(columns * 0.42), shutil.get_terminal_size((80, 24)).lines - 3))
    write_out(picture.terminal(paper, columns, rows))


def _written(content: str | bytes, output: str, *, overwrite: bool) -> str:
    """Write the file.

    Raises:
        FileError: It exists already, or cannot be written.
    """
    from dhcli.cli.shell.console import tell
    from dhcli.cli.shell.delivery import check_free
    from dhcli.storage.atomic import write_whole

    check_free(output, overwrite=overwrite)
    write_whole(output, content, overwrite=overwrite)
    tell(f"wrote {output}")
    return output


def _opened_page(picture: Picture, name: str) -> str:
    """A page in a folder of its own that the system clears; a worksheet, which is no page, and several as SVG."""
    import re
    import tempfile
    from pathlib import Path

    from dhcli.cli.shell.console import tell

    folder = tempfile.mkdtemp(prefix="dhcli-")
    suffix, text = ("svg", picture.svg()) if picture.worksheet or picture.more else ("html", picture.page())
    path = Path(folder) / f"{re.sub(r'[^A-Za-z0-9_-]+', '-', name) or 'page'}.{suffix}"
    path.write_text(text, encoding="utf-8")
    tell(f"wrote {path}")
    return str(path)
