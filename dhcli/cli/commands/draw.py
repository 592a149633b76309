"""`dhcli draw`: a robot, a linkage or the sheet of an exercise as a picture, in the terminal or in a file."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Annotated

import typer

from dhcli.cli.shell.options import Force, Settings, Variant, complete_pose, complete_robot
from dhcli.errors import DhcliError, Place, Problem

if TYPE_CHECKING:
    from dhcli.kinematics.robot import Robot
    from dhcli.mobility.linkage import Linkage
    from dhcli.render.pictures.picture import Picture

EXAMPLES = """
[bold]Examples[/]

dhcli draw puma560

dhcli draw scara --pose pick -o scara.svg

dhcli draw panda --worksheet --table -o sheet.pdf

dhcli draw peaucellier -o peaucellier.html

dhcli draw stanford-arm -o task.pdf
"""

LOOK = "How it looks"


def complete_view(incomplete: str) -> list[str]:
    """Named views."""
    return [name for name in ("iso", "front", "side", "top") if name.startswith(incomplete)]


def draw(
    robot: Annotated[
        str,
        typer.Argument(
            metavar="NAME",
            help="A robot, a linkage or an exercise, a YAML file, or - for stdin.",
            autocompletion=complete_robot,
        ),
    ],
    q: Annotated[
        str | None, typer.Option("--q", metavar="VALUES", help="Joint values; by default the pose that shows it best.")
    ] = None,
    pose: Annotated[
        str | None, typer.Option("--pose", metavar="NAME", help="A named pose.", autocompletion=complete_pose)
    ] = None,
    deg: Annotated[bool, typer.Option("--deg", help="Bare numbers of revolute joints are degrees.")] = False,
    set_: Settings = None,
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
            help="Write a file: .svg .tex .png .pdf .html, or .txt for letters.",
            rich_help_panel="Output",
        ),
    ] = None,
    solution: Annotated[
        bool, typer.Option("--solution", help="Of an exercise: with the frames that its picture leaves to you.")
    ] = False,
    variant: Variant = None,
    open_: Annotated[
        bool, typer.Option("--open", help="Open it in the browser; without -o as a page.", rich_help_panel="Output")
    ] = False,
    force: Force = False,
) -> None:
    """Draw a robot at a pose, a linkage, or the arm of an exercise, in the terminal or in a file."""
    from dhcli.cli.shell.delivery import check_force
    from dhcli.render.pictures.picture import Picture, format_of
    from dhcli.scene.camera import read_view

    check_force(output, force=force)
    name = None if output in (None, "-") else format_of(output or "")
    from dhcli.files.library.kinds import kind_of

    look = {"view": None if view is None else read_view(view), "dark": dark}
    if kind_of(robot).noun == "exercise":
        if q is not None or pose is not None or set_ or table:
            raise DhcliError(
                f"{robot} is an exercise: it says itself what is given", "--view, --size and --dark are free"
            )
        arm, given, hidden = _of_exercise(robot, variant, solution=solution)
        what: Robot | Linkage = arm
        picture = Picture(arm, worksheet=worksheet or hidden, **look, **given)  # type: ignore[arg-type]
    else:
        if solution or variant is not None:
            raise DhcliError(f"{robot} is no exercise: it has no solution and no variants", "leave the option out")
        what = find(robot)
        given = _posed(what, q, pose, set_ or [], degrees=deg)
        picture = Picture(what, worksheet=worksheet, table=table, **look, **given)  # type: ignore[arg-type]
    pixels = None if size is None else _sides(size)
    if table and (name in ("page", "terminal") or name is None):
        _refuse_table(what, name)
    if name is None and not open_:
        _in_letters(picture, pixels)
        return
    if pixels is not None:
        picture = _sized(picture, pixels, letters=name == "terminal")
    path = (
        _opened_page(picture, what.name or "linkage") if name is None else _written(picture, output or "", name, force)
    )
    if open_:
        import webbrowser
        from pathlib import Path

        webbrowser.open(Path(path).resolve().as_uri())


def find(name: str) -> Robot | Linkage:
    """The robot or linkage of a name, a file, or standard input.

    Raises:
        DhcliError: It is neither, or a linkage of which only counts are known.
    """
    from dhcli.files.library.kinds import kind_of

    kind = kind_of(name).noun
    if kind == "linkage":
        from dhcli.files.yaml.linkages import load_linkage
        from dhcli.mobility.linkage import Linkage

        linkage = load_linkage(name)
        if not isinstance(linkage, Linkage):
            raise DhcliError(f"of {name} only counts are known: there is nothing to draw", "dhcli dof counts it")
        return linkage
    from dhcli.files.yaml.robots import load_robot

    return load_robot(name)


def _of_exercise(name: str, variant: str | None, *, solution: bool) -> tuple[Robot, dict[str, object], bool]:
    """The arm of an exercise at the values that the task gives, and whether its frames are an answer and left out.

    Raises:
        DhcliError: It has no robot; its solution is asked for before it was tried.
    """
    from dataclasses import replace

    from dhcli.checking.figures import held_back, shown
    from dhcli.checking.variants import variant_of
    from dhcli.cli.commands.solution import ask_once
    from dhcli.files.yaml.exercises import load_exercise

    exercise = variant_of(load_exercise(name), variant)
    if exercise.robot is None or (level := shown(exercise)) is None:
        raise DhcliError(f"{exercise.id} has no robot: there is nothing to draw", f"dhcli show {exercise.id}")
    if solution:
        ask_once(exercise, held_back(exercise))
    arm = replace(exercise.robot, title=exercise.title)
    lengths = {name: value for name, value in exercise.given.items() if name in arm.parameters}
    joints = {name: value for name, value in exercise.given.items() if name in arm.variables}
    given: dict[str, object] = {"parameters": lengths}
    if arm.variables and len(joints) == len(arm.variables):
        given["q"] = joints
    return arm, given, level == "axes" and not solution


def _posed(
    what: Robot | Linkage, q: str | None, pose: str | None, settings: list[str], *, degrees: bool
) -> dict[str, object]:
    """Joint values, pose and lengths, as far as a robot has them."""
    from dhcli.kinematics.robot import Robot

    if not isinstance(what, Robot):
        if q is not None or pose is not None or settings:
            raise DhcliError(f"{what.name} is a linkage: --q, --pose and --set are for robots")
        return {}
    from dhcli.cli.shell.given import settings_of, values_of
    from dhcli.kinematics.values import given_parameters

    lengths = given_parameters(what, settings_of(settings), Place("--set", text=" ".join(settings)))
    if q is None:
        return {"pose": pose, "parameters": lengths}
    values = values_of(what, q, pose, settings, degrees=degrees, symbolic=False)
    joints = {name: value for name, value in values.items() if name in what.variables}
    return {"q": joints, "parameters": lengths}


def _refuse_table(what: Robot | Linkage, name: str | None) -> None:
    """Say where the table stands in formats that have no room beside the figure."""
    from dhcli.kinematics.robot import Robot

    if not isinstance(what, Robot):
        raise DhcliError(f"{what.name} is a linkage: it has no DH table")
    if name == "page":
        raise DhcliError("a page always has the table beside", "leave --table out")
    raise DhcliError("--table stands beside a figure in a file", f"dhcli show {what.name} --draw has both in letters")


def _sides(text: str) -> tuple[int, int]:
    """`820x640` in numbers."""
    import re

    match = re.fullmatch(r"\s*(\d{1,5})\s*[x×,]\s*(\d{1,5})\s*", text, re.ASCII)
    if match is None:
        raise DhcliError(Problem(f"'{text}' is no size", Place("--size"), "write width and height, such as 820x640"))
    return int(match[1]), int(match[2])


def _sized(picture: Picture, sides: tuple[int, int], *, letters: bool) -> Picture:
    from dataclasses import replace

    from dhcli.render.pictures.picture import check_size

    if letters:
        return picture
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


def _written(picture: Picture, output: str, name: str, force: bool) -> str:
    """Write the file.

    Raises:
        FileError: It exists already, or cannot be written.
    """
    from dhcli.cli.shell.console import say
    from dhcli.cli.shell.delivery import check_free
    from dhcli.files.atomic import write_whole

    check_free(output, force=force)
    write_whole(output, picture.rendered(name), overwrite=force)
    say(f"wrote {output}\n")
    return output


def _opened_page(picture: Picture, name: str) -> str:
    """A page in a folder of its own that the system clears; a worksheet, which is no page, as SVG."""
    import re
    import tempfile
    from pathlib import Path

    from dhcli.cli.shell.console import say

    folder = tempfile.mkdtemp(prefix="dhcli-")
    suffix, text = ("svg", picture.svg()) if picture.worksheet else ("html", picture.page())
    path = Path(folder) / f"{re.sub(r'[^A-Za-z0-9_-]+', '-', name) or 'page'}.{suffix}"
    path.write_text(text, encoding="utf-8")
    say(f"wrote {path}\n")
    return str(path)
