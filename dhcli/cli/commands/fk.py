"""`dhcli fk`: the pose of a robot, in numbers or in symbols."""

from __future__ import annotations

from typing import Annotated

import typer

from dhcli.cli.shell.chosen import Chosen
from dhcli.cli.shell.options import (
    MANY,
    WHERE,
    Code,
    Digits,
    Format,
    Forms,
    IgnoreColumns,
    Index,
    Let,
    Output,
    Overwrite,
    RowJobs,
    SkipBad,
    Spelling,
    Symbolic,
    WithValues,
)

EXAMPLES = """
[bold]Examples[/]

dhcli fk scara --q 0.3,0.5,0.1

dhcli fk puma560 --pose ready --frames

dhcli fk stanford --q 90,0,0.3,0,45,0 --deg --as rpy,position

dhcli fk puma560 --symbolic --from 3 --to 6

dhcli fk panda --symbolic --let -o panda.tex

dhcli fk puma560 --code c -o puma560.c

dhcli fk puma560 --in q.csv --as position -o points.csv
"""


def fk(
    chosen: Chosen,
    symbolic: Symbolic = False,
    let: Let = False,
    frames: Annotated[bool, typer.Option("--frames", help="Every frame, T_0i.", rich_help_panel=WHERE)] = False,
    links: Annotated[
        bool, typer.Option("--links", help="Every link's own matrix, A_i.", rich_help_panel=WHERE)
    ] = False,
    factors: Annotated[
        str | None,
        typer.Option(metavar="LINK", help="Elementary matrices of a link, or of all.", rich_help_panel=WHERE),
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
            rich_help_panel=MANY,
        ),
    ] = None,
    skip_bad: SkipBad = False,
    ignore_columns: IgnoreColumns = False,
    index: Index = False,
    jobs: RowJobs = None,
    as_: Forms = None,
    format_: Format = None,
    code: Code = None,
    with_values: WithValues = False,
    style: Spelling = None,
    digits: Digits = None,
    output: Output = None,
    overwrite: Overwrite = False,
) -> None:
    """Pose of a robot's end frame: in numbers from joint values, or in symbols as the textbook prints it."""
    from dhcli.cli.shell.given import robot_of, values_of

    if in_ is not None or skip_bad or ignore_columns or index or jobs is not None:
        from dhcli.cli.shell.batch import asked_of_rows, check_options, fk_rows, rows_wanted
        from dhcli.cli.shell.rows import RowDelivery

        others: dict[str, object] = {"--pose": chosen.pose, "--symbolic": symbolic, "--let": let, "--links": links}
        others |= {"--factors": factors, "--style": style, "--digits": digits}
        others |= {"--code": code, "--with-values": with_values}
        path = check_options(in_, chosen.robot, others)
        arm = robot_of(chosen)
        wanted = rows_wanted(arm, chosen, as_ or [], point, inverse=inverse, every=frames)
        asked = asked_of_rows(wanted.robot, chosen, ignores=ignore_columns)
        there = RowDelivery(format_, output, overwrite)
        fk_rows(wanted, asked, path, there, skip_bad=skip_bad, index=index, jobs=jobs)
        return
    if code is not None or with_values:
        from dhcli.cli.shell.coding import code_delivery
        from dhcli.kinematics.frames import View
        from dhcli.kinematics.generated import forward_function

        besides: dict[str, object] = {"--frames": frames, "--links": links, "--factors": factors, "--point": point}
        besides |= {"--as": as_, "--let": let, "--style": style, "--digits": digits}
        written = code_delivery("function", "fk", code, besides, format_, output, overwrite=overwrite)
        arm = robot_of(chosen)
        values = values_of(arm, chosen, symbolic=True)
        view = View.of(arm, chosen.from_, chosen.end, inverse=inverse)
        written.hand_over("function", forward_function(arm, view, values, with_values=with_values))
        return
    from dhcli.cli.shell.asking import ask, result_kind
    from dhcli.cli.shell.delivery import Delivery
    from dhcli.kinematics.question import answer

    delivery = Delivery("fk", format_, digits, style, output, overwrite)
    arm = robot_of(chosen)
    question = ask(
        arm,
        chosen,
        inverse=inverse,
        symbolic=symbolic,
        frames=frames,
        links=links,
        factors=factors,
        point=point,
        forms=as_,
        let=let,
    )
    delivery.chosen(result_kind(question))
    result = answer(arm, values_of(arm, chosen, symbolic=symbolic), question)
    delivery.hand_over(result_kind(question), result, result.warnings)
