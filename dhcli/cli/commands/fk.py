"""`dhcli fk`: the pose of a robot, in numbers or in symbols."""

from __future__ import annotations

from typing import Annotated

import typer

from dhcli.cli.shell.options import (
    WHERE,
    AsTyped,
    Base,
    Digits,
    Force,
    Format,
    Forms,
    Output,
    RobotName,
    SeenFrom,
    Settings,
    Spelling,
    Tip,
    complete_frame,
    complete_pose,
)

_MANY = "Many poses"

EXAMPLES = """
[bold]Examples[/]

dhcli fk scara --q 0.3,0.5,0.1

dhcli fk puma560 --pose ready --frames

dhcli fk stanford --q 90,0,0.3,0,45,0 --deg --as rpy,position

dhcli fk puma560 --symbolic --from 3 --to 6

dhcli fk panda --symbolic --let -o panda.tex

dhcli fk puma560 --in q.csv --as position -o points.csv
"""


def fk(
    robot: RobotName,
    q: Annotated[
        str | None,
        typer.Option(
            "--q", metavar="VALUES", help="Joint values: 0.3,30deg,120mm or q1=0.3,d3=0.1, a named pose, or @FILE."
        ),
    ] = None,
    deg: Annotated[bool, typer.Option("--deg", help="Bare numbers of revolute joints are degrees.")] = False,
    pose: Annotated[
        str | None,
        typer.Option(
            "--pose",
            metavar="NAME",
            help="A named pose of the robot; --q NAME=VALUE varies it.",
            autocompletion=complete_pose,
        ),
    ] = None,
    set_: Settings = None,
    symbolic: Annotated[bool, typer.Option("--symbolic", "-s", help="Keep what has no value as symbols.")] = False,
    let: Annotated[bool, typer.Option("--let", help="Give names to long or repeated brackets.")] = False,
    frames: Annotated[bool, typer.Option("--frames", help="Every frame, T_0i.", rich_help_panel=WHERE)] = False,
    links: Annotated[
        bool, typer.Option("--links", help="Every link's own matrix, A_i.", rich_help_panel=WHERE)
    ] = False,
    factors: Annotated[
        str | None,
        typer.Option(metavar="LINK", help="Elementary matrices of a link, or of all.", rich_help_panel=WHERE),
    ] = None,
    from_: SeenFrom = None,
    to: Annotated[
        str | None,
        typer.Option(metavar="FRAME", help="Of this frame.", rich_help_panel=WHERE, autocompletion=complete_frame),
    ] = None,
    tool: Annotated[
        str | None,
        typer.Option(
            metavar="TOOL",
            help="Of the end of this tool: one that the file names, or 'Trans(0,0,0.1) Rot(z,45°)'.",
            rich_help_panel=WHERE,
        ),
    ] = None,
    inverse: Annotated[bool, typer.Option("--inverse", help="The other way round.", rich_help_panel=WHERE)] = False,
    point: Annotated[
        str | None, typer.Option(metavar="X,Y,Z", help="Where a point of the end frame is.", rich_help_panel=WHERE)
    ] = None,
    in_: Annotated[
        str | None,
        typer.Option(
            "--in",
            metavar="FILE",
            help="Joint values, a row for each pose: CSV, JSON Lines or .npy; - is stdin. Names and units stand in the "
            r"header: theta1\[deg]. Gives rows: csv, or jsonl or npy by --format or -o.",
            rich_help_panel=_MANY,
        ),
    ] = None,
    skip_bad: Annotated[
        bool,
        typer.Option("--skip-bad", help="Go on without bad rows, list them, and end with 0.", rich_help_panel=_MANY),
    ] = False,
    ignore_columns: Annotated[
        bool,
        typer.Option("--ignore-columns", help="Leave columns aside that are no joint.", rich_help_panel=_MANY),
    ] = False,
    index: Annotated[
        bool,
        typer.Option(
            "--index", help="First column: where the row stands in FILE, as in errors.", rich_help_panel=_MANY
        ),
    ] = False,
    as_: Forms = None,
    base: Base = None,
    tip: Tip = None,
    as_typed: AsTyped = False,
    format_: Format = None,
    style: Spelling = None,
    digits: Digits = None,
    output: Output = None,
    force: Force = False,
) -> None:
    """Pose of a robot's end frame: in numbers from joint values, or in symbols as the textbook prints it."""
    from dhcli.cli.shell.given import values_of, with_tool
    from dhcli.files.yaml.robots import load_robot

    if in_ is not None or skip_bad or ignore_columns or index:
        from dhcli.cli.shell.batch import asked_of_rows, check_options, fk_rows, rows_wanted
        from dhcli.cli.shell.rows import RowDelivery

        others: dict[str, object] = {"--pose": pose, "--symbolic": symbolic, "--let": let, "--links": links}
        others |= {"--factors": factors, "--style": style, "--digits": digits}
        path = check_options(in_, robot, others)
        arm = load_robot(robot, base=base, tip=tip, as_typed=as_typed)
        if tool is not None:
            arm, to = with_tool(arm, tool, from_, to)
        wanted = rows_wanted(arm, from_, to, set_ or [], as_ or [], point, inverse=inverse, every=frames)
        asked = asked_of_rows(wanted.robot, q, degrees=deg, ignores=ignore_columns)
        fk_rows(wanted, asked, path, RowDelivery(format_, output, force), skip_bad=skip_bad, index=index)
        return
    from dhcli.cli.shell.asking import ask, kind_of
    from dhcli.cli.shell.delivery import Delivery
    from dhcli.kinematics.question import answer

    delivery = Delivery("fk", format_, digits, style, output, force)
    arm = load_robot(robot, base=base, tip=tip, as_typed=as_typed)
    if tool is not None:
        arm, to = with_tool(arm, tool, from_, to)
    question = ask(
        arm,
        from_,
        to,
        inverse=inverse,
        symbolic=symbolic,
        frames=frames,
        links=links,
        factors=factors,
        point=point,
        forms=as_,
        let=let,
    )
    delivery.chosen(kind_of(question))
    result = answer(arm, values_of(arm, q, pose, set_ or [], degrees=deg, symbolic=symbolic), question)
    delivery.hand_over(kind_of(question), result, result.warnings)
