"""`dhcli fk`: the pose of a robot, in numbers or in symbols."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from dhcli.cli.shell.chosen import Chosen
from dhcli.cli.shell.many import Many
from dhcli.cli.shell.options import WHERE, Forms, Let, Symbolic
from dhcli.cli.shell.written import Written
from dhcli.frozen import frozen

if TYPE_CHECKING:
    from dhcli.kinematics.many import PoseRows
    from dhcli.kinematics.question import Listing, Question
    from dhcli.kinematics.robot import Robot

EXAMPLES = """
[bold]Examples[/]

dhcli fk scara --q 0.3,0.5,0.1

dhcli fk puma560 --pose ready --frames

dhcli fk stanford --q 90,0,0.3,0,45,0 --deg --as rpy,position

dhcli fk puma560 --symbolic --from 3 --to 6

dhcli fk panda --symbolic --let -o panda.tex

dhcli fk puma560 --code c -o puma560.c

dhcli fk puma560 --rows q.csv --as position -o points.csv
"""


_WITH_ROWS = (
    "with --rows go --q NAME=VALUE --deg --set --from --to --tool --inverse --frames --point --as --skip-bad "
    "--ignore-columns --index --jobs --format -o --overwrite"
)
LISTINGS: tuple[Listing, ...] = ("frames", "links", "factors")


@frozen
class Asked:
    """What is asked of a pose, as it was typed."""

    symbolic: Symbolic = False
    let: Let = False
    frames: Annotated[bool, typer.Option("--frames", help="Every frame, T_0i.", rich_help_panel=WHERE)] = False
    links: Annotated[bool, typer.Option("--links", help="Every link's own matrix, A_i.", rich_help_panel=WHERE)] = False
    factors: Annotated[
        str | None,
        typer.Option(metavar="LINK", help="Elementary matrices of a link, or of all.", rich_help_panel=WHERE),
    ] = None
    inverse: Annotated[bool, typer.Option("--inverse", help="The other way round.", rich_help_panel=WHERE)] = False
    point: Annotated[
        str | None, typer.Option(metavar="X,Y,Z", help="Where a point of the end frame is.", rich_help_panel=WHERE)
    ] = None
    forms: Forms = None


def fk(
    chosen: Chosen,
    asked: Asked,
    *,
    many: Many,
    out: Written,
) -> None:
    """Pose of a robot's end frame: in numbers from joint values, or in symbols as the textbook prints it."""
    if many.given:
        _rows(chosen, asked, many, out)
    elif out.is_code:
        _code(chosen, asked, out)
    else:
        _pose(chosen, asked, out)


def _pose(chosen: Chosen, asked: Asked, out: Written) -> None:
    """One pose, or what else is asked of it."""
    from dhcli.cli.shell.given import robot_of, values_of
    from dhcli.kinematics.question import answer

    arm = robot_of(chosen)
    question = _question(arm, chosen, asked)
    delivery = out.delivery("fk", _kind(question))
    result = answer(arm, values_of(arm, chosen, symbolic=asked.symbolic), question)
    delivery.hand_over(_kind(question), result, result.warnings)


def _code(chosen: Chosen, asked: Asked, out: Written) -> None:
    """A function that computes the pose."""
    from dhcli.cli.shell.coding import code_delivery
    from dhcli.cli.shell.given import robot_of, values_of
    from dhcli.kinematics.frames import View
    from dhcli.kinematics.generated import forward_function

    others: dict[str, object] = {"--frames": asked.frames, "--links": asked.links, "--factors": asked.factors}
    others |= {"--point": asked.point, "--as": asked.forms, "--let": asked.let}
    written = code_delivery(out, "fk", "function", others)
    arm = robot_of(chosen)
    view = View.of(arm, chosen.from_, chosen.end, inverse=asked.inverse)
    values = values_of(arm, chosen, symbolic=True)
    written.hand_over("function", forward_function(arm, view, values, with_values=out.with_values))


def _rows(chosen: Chosen, asked: Asked, many: Many, out: Written) -> None:
    """A pose for each row of a file."""
    from dhcli.cli.shell.batch import Work, compute_rows, joint_table
    from dhcli.cli.shell.given import robot_of
    from dhcli.render.code.layouts import pose_layout

    others: dict[str, object] = {"--pose": chosen.pose, "--symbolic": asked.symbolic, "--let": asked.let}
    others |= {"--links": asked.links, "--factors": asked.factors, **out.options}
    path = many.file(chosen.robot, others, _WITH_ROWS)
    arm = robot_of(chosen)
    wanted = _each(arm, chosen, asked)
    table = joint_table(arm, chosen, many)
    there = out.rows()
    layout = pose_layout(wanted.forms, wanted.views if wanted.every else (), index=many.index)
    is_whole = there.chosen() == "npy" and wanted.forms == ("matrix",) and not many.index  # with its last row
    said = (lambda poses: poses) if is_whole else wanted.said
    work = Work(arm, layout, wanted.poses, said, "the pose has an entry that is not a real number", wanted.locked)
    compute_rows(work, table, path, there, many)


def _question(arm: Robot, chosen: Chosen, asked: Asked) -> Question:
    """The question that the options ask.

    Raises:
        DhcliError: Two options contradict each other, the point cannot be read, or the robot has no such frame.
    """
    from dhcli.cli.shell.given import forms_of, open_scope, point_of
    from dhcli.errors import DhcliError
    from dhcli.kinematics.frames import View
    from dhcli.kinematics.question import Question

    factors = asked.factors
    given = {
        "--frames": asked.frames,
        "--links": asked.links,
        "--factors": factors is not None,
        "--point": asked.point is not None,
        "--as": bool(asked.forms),
        "--let": asked.let,
    }
    if len(typed := [option for option, is_given in given.items() if is_given]) > 1:
        raise DhcliError(f"{' and '.join(typed)} ask for different things", "use one of them")
    if asked.let and not asked.symbolic:
        raise DhcliError("--let gives names to parts of formulas, and this result is in numbers", "add --symbolic")
    if factors is not None and asked.inverse:
        raise DhcliError(
            "--factors and --inverse do not go together", "the factors of a link have an order of their own"
        )
    listing = next((name for name in LISTINGS if given[f"--{name}"]), None)
    seen = None if asked.point is None else point_of(asked.point, "--point", open_scope(arm))
    view = View.of(arm, chosen.from_, chosen.end, inverse=asked.inverse, point=seen)
    link = None if factors == "all" else factors
    return Question(view, asked.symbolic, listing, link, forms_of(asked.forms or ()), asked.let)


def _kind(question: Question) -> str:
    """The kind of result that a question has, which decides the formats."""
    if question.listing:
        return "poses"
    if question.view.point is not None:
        return "point"
    if question.let:
        return "let"
    return "placement" if question.forms else "pose"


def _each(arm: Robot, chosen: Chosen, asked: Asked) -> PoseRows:
    """What the options ask of each row.

    Raises:
        DhcliError: There is no such frame or form, a length has no value, or the point is none.
    """
    from dataclasses import replace

    from dhcli.cli.shell.given import forms_of, lengths_of, open_scope, point_of
    from dhcli.errors import DhcliError
    from dhcli.kinematics.frames import View
    from dhcli.kinematics.many import PoseRows

    forms, point = asked.forms or [], asked.point
    if point is not None and (forms or asked.frames):
        raise DhcliError(f"--point and {'--as' if forms else '--frames'} ask for different things", "use one of them")
    view = View.of(arm, chosen.from_, chosen.end, inverse=asked.inverse)
    lengths = lengths_of(arm, chosen)
    if point is None:
        views = view.on_the_way(arm) if asked.frames else (view,)
        return PoseRows(arm, views, lengths, forms_of(forms) or ("matrix",), asked.frames)
    from dhcli.kinematics.sweep.target import target_of  # few follow a point

    target = target_of(arm, replace(view, point=point_of(point, "--point", open_scope(arm))), lengths)
    return PoseRows(arm, (target.view,), lengths, ("position",))
