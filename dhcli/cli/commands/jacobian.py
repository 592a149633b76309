"""`dhcli jacobian`: how the end of a robot moves with its joints, in numbers or in symbols."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from dhcli.cli.shell.chosen import Chosen
from dhcli.cli.shell.many import Many
from dhcli.cli.shell.options import Axes, EndPoint, Let, Symbolic
from dhcli.cli.shell.spreading import But
from dhcli.cli.shell.written import Written
from dhcli.frozen import frozen

if TYPE_CHECKING:
    from dhcli.kinematics.robot import Robot
    from dhcli.kinematics.velocity.form import Form
    from dhcli.kinematics.velocity.view import MotionView

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


@frozen
class Asked:
    """Which Jacobian is asked for, as it was typed."""

    symbolic: Symbolic = False
    let: Let = False
    in_: Axes = None
    point: EndPoint = None
    part: Annotated[
        str | None, typer.Option(metavar="PART", help="linear: v alone; angular: ω alone.", rich_help_panel=ROWS)
    ] = None
    order: Annotated[
        str | None, typer.Option(metavar="ORDER", help="angular-first: ω above v.", rich_help_panel=ROWS)
    ] = None
    analytic: Annotated[
        str | None,
        typer.Option(
            metavar="ANGLES", help="Rates of rpy, or of zyz and so on, in the place of ω.", rich_help_panel=ROWS
        ),
    ] = None
    space: Annotated[
        bool,
        typer.Option("--space", help="Space Jacobian: ω first, v of the point at the origin.", rich_help_panel=ROWS),
    ] = False
    body: Annotated[
        bool, typer.Option("--body", help="Body Jacobian: ω first, in the end frame.", rich_help_panel=ROWS)
    ] = False


def jacobian(
    chosen: Chosen,
    asked: Asked,
    *,
    many: Annotated[Many, But(without=("in_",))],
    out: Written,
) -> None:
    """Jacobian of a robot: velocity of its end for each joint's rate, in numbers or as the textbook prints it."""
    if many.given:
        _rows(chosen, asked, many, out)
    elif out.is_code:
        _code(chosen, asked, out)
    else:
        _jacobian(chosen, asked, out)


def _jacobian(chosen: Chosen, asked: Asked, out: Written) -> None:
    """One Jacobian."""
    from dhcli.cli.shell.given import robot_of, values_of
    from dhcli.errors import DhcliError
    from dhcli.kinematics.velocity.asked import answer_jacobian

    arm = robot_of(chosen)
    view, form = _meant(arm, chosen, asked)
    if asked.let and not asked.symbolic:
        raise DhcliError("--let gives names to parts of formulas, and this result is in numbers", "add --symbolic")
    delivery = out.delivery("jacobian", "jacobian")
    values = values_of(arm, chosen, symbolic=asked.symbolic)
    result = answer_jacobian(arm, values, view, form, symbolic=asked.symbolic, let=asked.let)
    delivery.hand_over("jacobian", result, result.warnings)


def _code(chosen: Chosen, asked: Asked, out: Written) -> None:
    """A function that computes the Jacobian."""
    from dhcli.cli.shell.coding import code_delivery
    from dhcli.cli.shell.given import robot_of, values_of
    from dhcli.kinematics.generated import jacobian_function

    arm = robot_of(chosen)
    view, form = _meant(arm, chosen, asked)
    written = code_delivery(out, "jacobian", "function", {"--let": asked.let})
    values = values_of(arm, chosen, symbolic=True)
    written.hand_over("function", jacobian_function(arm, view, form, values, with_values=out.with_values))


def _rows(chosen: Chosen, asked: Asked, many: Many, out: Written) -> None:
    """A Jacobian for each row of a file."""
    from dhcli.cli.shell.batch import Work, compute_rows, joint_table
    from dhcli.cli.shell.given import lengths_of, robot_of
    from dhcli.kinematics.velocity.rows import JacobianRows
    from dhcli.render.code.layouts import jacobian_layout

    others = {"--pose": chosen.pose, "--symbolic": asked.symbolic, "--let": asked.let, **out.options}
    instead = "rows are numbers, csv, jsonl or npy"
    path = many.file(chosen.robot, others, instead)
    arm = robot_of(chosen)
    wanted = JacobianRows(arm, *_meant(arm, chosen, asked), lengths_of(arm, chosen))
    layout = jacobian_layout(*wanted.layout, index=many.index)
    unreal = "the Jacobian has an entry that is not a real number here"
    width = layout.width - many.index
    work = Work(arm, layout, wanted.jacobians, lambda found: found.reshape(len(found), width), unreal)
    compute_rows(work, joint_table(arm, chosen, many), path, out.rows(), many)


def _meant(arm: Robot, chosen: Chosen, asked: Asked) -> tuple[MotionView, Form]:
    """Of which frame and point, along which axes, and in which form.

    Raises:
        DhcliError: There is no such frame, point or form, or two options contradict each other.
    """
    from dhcli.cli.shell.moving import form_of, twist_view, view_of
    from dhcli.kinematics.velocity.form import Form

    view = view_of(arm, chosen, asked.in_, asked.point, "--point")
    form = form_of(asked.part, asked.order, asked.analytic)
    if not (asked.space or asked.body):
        return view, form
    said: dict[str, object] = {"--in": asked.in_, "--point": asked.point, "--order": asked.order}
    said |= {"--analytic": asked.analytic}
    view = twist_view(arm, view, said, space=asked.space, body=asked.body)
    return view, Form(form.part, angular_first=True)
