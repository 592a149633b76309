"""`dhcli jacobian`: how the end of a robot moves with its joints, in numbers or in symbols."""

from __future__ import annotations

from typing import Annotated

import typer

from dhcli.cli.shell.chosen import Chosen
from dhcli.cli.shell.options import (
    MANY,
    Axes,
    Code,
    Digits,
    EndPoint,
    Format,
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

ROWS = "Rows"

EXAMPLES = """
[bold]Examples[/]

dhcli jacobian planar-2r --symbolic

dhcli jacobian puma560 --symbolic --to 4 --in 3 --part linear

dhcli jacobian ur5e --q 0,-90,90,0,45,0 --deg

dhcli jacobian scara --pose pick --point 0,0,0.1

dhcli jacobian stanford --pose grasp --body

dhcli jacobian ur5e --code python --with-values

dhcli jacobian puma560 --rows q.csv -o jacobians.npy
"""


def jacobian(
    chosen: Chosen,
    symbolic: Symbolic = False,
    let: Let = False,
    in_: Axes = None,
    point: EndPoint = None,
    part: Annotated[
        str | None, typer.Option(metavar="PART", help="linear: v alone; angular: ω alone.", rich_help_panel=ROWS)
    ] = None,
    order: Annotated[
        str | None, typer.Option(metavar="ORDER", help="angular-first: ω above v.", rich_help_panel=ROWS)
    ] = None,
    analytic: Annotated[
        str | None,
        typer.Option(
            metavar="ANGLES", help="Rates of rpy, or of zyz and so on, in the place of ω.", rich_help_panel=ROWS
        ),
    ] = None,
    space: Annotated[
        bool,
        typer.Option("--space", help="Space Jacobian: ω first, v of the point at the origin.", rich_help_panel=ROWS),
    ] = False,
    body: Annotated[
        bool, typer.Option("--body", help="Body Jacobian: ω first, in the end frame.", rich_help_panel=ROWS)
    ] = False,
    rows: Annotated[
        str | None,
        typer.Option(
            "--rows",
            metavar="FILE",
            help="Joint values, a row for each Jacobian: CSV, JSON Lines or .npy; - is stdin. "
            "Gives rows: csv, or jsonl or npy by --format or -o.",
            rich_help_panel=MANY,
        ),
    ] = None,
    skip_bad: SkipBad = False,
    ignore_columns: IgnoreColumns = False,
    index: Index = False,
    jobs: RowJobs = None,
    format_: Format = None,
    code: Code = None,
    with_values: WithValues = False,
    style: Spelling = None,
    digits: Digits = None,
    output: Output = None,
    overwrite: Overwrite = False,
) -> None:
    """Jacobian of a robot: velocity of its end for each joint's rate, in numbers or as the textbook prints it."""
    from dhcli.cli.shell.given import lengths_of, robot_of, values_of
    from dhcli.cli.shell.moving import form_of, twist_view, view_of
    from dhcli.errors import DhcliError
    from dhcli.kinematics.velocity.form import Form

    many = rows is not None or skip_bad or ignore_columns or index or jobs is not None
    if many:
        from dhcli.cli.shell.jacobian_rows import check_options

        others: dict[str, object] = {"--pose": chosen.pose, "--symbolic": symbolic, "--let": let}
        others |= {"--style": style, "--digits": digits, "--code": code, "--with-values": with_values}
        check_options(rows, chosen.robot, others)
    arm = robot_of(chosen)
    view = view_of(arm, chosen, in_, point, "--point")
    form = form_of(part, order, analytic)
    if space or body:
        said: dict[str, object] = {"--in": in_, "--point": point, "--order": order, "--analytic": analytic}
        view = twist_view(arm, view, said, space=space, body=body)
        form = Form(form.part, angular_first=True)
    if many and rows is not None:
        from dhcli.cli.shell.batch import asked_of_rows
        from dhcli.cli.shell.jacobian_rows import jacobian_rows
        from dhcli.cli.shell.rows import RowDelivery
        from dhcli.kinematics.velocity.rows import JacobianRows

        wanted = JacobianRows(arm, view, form, lengths_of(arm, chosen))
        asked = asked_of_rows(arm, chosen, ignores=ignore_columns)
        there = RowDelivery(format_, output, overwrite)
        jacobian_rows(wanted, asked, rows, there, skip_bad=skip_bad, index=index, jobs=jobs)
        return
    if code is not None or with_values:
        from dhcli.cli.shell.coding import code_delivery
        from dhcli.kinematics.generated import jacobian_function

        besides: dict[str, object] = {"--let": let, "--style": style, "--digits": digits}
        written = code_delivery("function", "jacobian", code, besides, format_, output, overwrite=overwrite)
        values = values_of(arm, chosen, symbolic=True)
        written.hand_over("function", jacobian_function(arm, view, form, values, with_values=with_values))
        return
    from dhcli.cli.shell.delivery import Delivery
    from dhcli.kinematics.velocity.asked import answer_jacobian

    if let and not symbolic:
        raise DhcliError("--let gives names to parts of formulas, and this result is in numbers", "add --symbolic")
    delivery = Delivery("jacobian", format_, digits, style, output, overwrite)
    delivery.chosen("jacobian")
    values = values_of(arm, chosen, symbolic=symbolic)
    result = answer_jacobian(arm, values, view, form, symbolic=symbolic, let=let)
    delivery.hand_over("jacobian", result, result.warnings)
