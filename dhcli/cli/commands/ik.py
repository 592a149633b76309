"""`dhcli ik`: the joint values that take a robot's end to a pose, all of them."""

from __future__ import annotations

from typing import Annotated, TypeAlias

import typer

from dhcli.cli.shell.chosen import Chosen
from dhcli.cli.shell.options import (
    MANY,
    Code,
    Digits,
    Overwrite,
    RowJobs,
    SkipBad,
    WithValues,
    complete_pose,
    format_option,
    output_option,
)
from dhcli.cli.shell.spreading import But

_POSE = "The pose"
_WHICH = "Which solutions"

EXAMPLES = """
[bold]Examples[/]

dhcli ik puma560 --pose ready

dhcli ik ur5e --target "Trans(0.4,0.2,0.3) Rot(x,180°)" --near home

dhcli ik planar-2r --position 0.5,0.3,0

dhcli ik panda --pose ready --hold theta7=30°

dhcli ik planar-2r --derive

dhcli ik puma560 --code c -o inverse.c

dhcli ik puma560 --q 0.3,-0.5,0.7,1,0.8,-2 --branch "elbow up" --within-limits
"""


def complete_task(incomplete: str) -> list[str]:
    """What of a pose may be asked for."""
    return [name for name in ("pose", "position", "orientation", "axis", "direction") if name.startswith(incomplete)]


Standing: TypeAlias = Annotated[
    str | None,
    typer.Option(
        "--q", metavar="VALUES", help="Where these joint values stand, as fk takes them.", rich_help_panel=_POSE
    ),
]
StandingPose: TypeAlias = Annotated[
    str | None,
    typer.Option(
        "--pose",
        metavar="NAME",
        help="Where a named pose of the robot stands.",
        rich_help_panel=_POSE,
        autocompletion=complete_pose,
    ),
]


def ik(
    chosen: Annotated[Chosen, But(instead={"q": Standing, "pose": StandingPose})],
    goal_: Annotated[str | None, typer.Argument(metavar="[TARGET]", help="The same as --target.")] = None,
    target: Annotated[
        str | None,
        typer.Option(
            metavar="MOVES",
            help="Moves such as 'Trans(0.4,0,0.3) Rot(y,90°)', a 4x4 matrix, @FILE, or - for stdin, also JSON of fk.",
            rich_help_panel=_POSE,
        ),
    ] = None,
    position: Annotated[
        str | None,
        typer.Option(metavar="X,Y,Z", help="Where the origin of the end frame is.", rich_help_panel=_POSE),
    ] = None,
    rpy: Annotated[
        str | None,
        typer.Option(metavar="R,P,Y", help="With --position: roll, pitch and yaw.", rich_help_panel=_POSE),
    ] = None,
    quaternion: Annotated[
        str | None,
        typer.Option(metavar="W,X,Y,Z", help="With --position: a quaternion.", rich_help_panel=_POSE),
    ] = None,
    euler: Annotated[
        str | None,
        typer.Option(
            metavar="'ORDER A,B,C'",
            help="With --position: three turns, 'zyz 0,30°,90°' or any order of axes; 'fixed-xyz ...' has fixed axes.",
            rich_help_panel=_POSE,
        ),
    ] = None,
    pointing: Annotated[
        str | None,
        typer.Option(metavar="X,Y,Z", help="Where the z axis of the end frame points to.", rich_help_panel=_POSE),
    ] = None,
    task: Annotated[
        str | None,
        typer.Option(
            metavar="WHAT",
            help="What of it counts: pose, position, orientation, axis (position and direction of z) or direction.",
            rich_help_panel=_POSE,
            autocompletion=complete_task,
        ),
    ] = None,
    near: Annotated[
        str | None,
        typer.Option(
            metavar="VALUES",
            help="Sort by distance from joint values or a named pose.",
            rich_help_panel=_WHICH,
            autocompletion=complete_pose,
        ),
    ] = None,
    branch: Annotated[
        list[str] | None,
        typer.Option(
            metavar="WORDS",
            help="Only branches with these words, such as 'elbow up'; repeatable.",
            rich_help_panel=_WHICH,
        ),
    ] = None,
    within_limits: Annotated[
        bool, typer.Option("--within-limits", help="Only inside the limits of the joints.", rich_help_panel=_WHICH)
    ] = False,
    all_turns: Annotated[
        bool,
        typer.Option("--all-turns", help="Angles in every turn that the limits allow.", rich_help_panel=_WHICH),
    ] = False,
    hold: Annotated[
        list[str] | None,
        typer.Option(
            metavar="NAME=VALUE",
            help="A joint that is not computed but stands there; repeatable.",
            rich_help_panel=_WHICH,
        ),
    ] = None,
    family: Annotated[
        int | None,
        typer.Option(
            min=2, max=1000, metavar="N", help="Sample the joints to spare of a redundant arm.", rich_help_panel=_WHICH
        ),
    ] = None,
    in_: Annotated[
        str | None,
        typer.Option(
            "--in",
            metavar="FILE",
            help="Poses, a row each, as fk --in writes them: CSV, JSON Lines or .npy; - is stdin. Gives rows: where "
            "the pose stands, and joint values; csv, or jsonl or npy by --format or -o.",
            rich_help_panel=MANY,
        ),
    ] = None,
    each: Annotated[
        str | None,
        typer.Option(metavar="WHICH", help="Of each row: all, nearest (to --near) or first.", rich_help_panel=MANY),
    ] = None,
    follow: Annotated[
        bool,
        typer.Option(
            "--follow",
            help="With --in: stay on one branch along the rows, beginning near --near; jumps are told.",
            rich_help_panel=MANY,
        ),
    ] = False,
    skip_bad: SkipBad = False,
    jobs: RowJobs = None,
    why: Annotated[
        bool,
        typer.Option("--why", help="Which rule finds each joint, and which limits keep solutions out."),
    ] = False,
    derive: Annotated[
        bool, typer.Option("--derive", help="The formulas, step by step as a book derives them; no pose is needed.")
    ] = False,
    format_: Annotated[str | None, format_option("table", "json", "csv", "latex", "md")] = None,
    code: Code = None,
    with_values: WithValues = False,
    digits: Digits = None,
    output: Annotated[str | None, output_option(".json", ".csv", ".tex", ".md", ".txt")] = None,
    overwrite: Overwrite = False,
) -> int:
    """Inverse kinematics: every way to hold the joints so that the end frame stands in a pose."""
    from dhcli.cli.shell.delivery import Delivery
    from dhcli.cli.shell.given import robot_of
    from dhcli.cli.shell.goal import Goal, asked
    from dhcli.cli.shell.solutions import derived, held_of, near_of, only_branches
    from dhcli.errors import DhcliError, ExitStatus

    if in_ is not None or each is not None or follow or skip_bad or jobs is not None:
        from dhcli.cli.shell.inverse_rows import RowWish, solve_rows

        others: dict[str, object] = {
            "--q": chosen.q,
            "--pose": chosen.pose,
            "--target": target,
            "--position": position,
            "--rpy": rpy,
        }
        others |= {"--quaternion": quaternion, "--pointing": pointing, "--branch": branch, "--family": family}
        others |= {"--all-turns": all_turns, "--derive": derive, "--digits": digits}
        others |= {"--euler": euler, "--why": why, "TARGET": goal_, "--code": code}
        others |= {"--with-values": with_values}
        rows = RowWish(in_, each, task, near, hold or [], within_limits, follow, skip_bad, jobs)
        return solve_rows(chosen, rows, others, format_, output, overwrite=overwrite)
    writes_code = code is not None or with_values
    kind = "inverse function" if writes_code else "derivation" if derive else "inverse"
    besides: dict[str, object] = {"--near": near, "--branch": branch, "--family": family, "--hold": hold}
    besides |= {"--why": why, "--within-limits": within_limits, "--all-turns": all_turns}
    if writes_code:
        from dhcli.cli.shell.coding import code_delivery

        besides |= {"--digits": digits}
        delivery = code_delivery(kind, "ik", code, besides, format_, output, overwrite=overwrite)
    else:
        if derive:
            from dhcli.cli.shell.coding import check_alone

            check_alone("--derive", besides)
        delivery = Delivery("ik", format_, digits, None, output, overwrite)
        delivery.chosen(kind)
    arm = robot_of(chosen)
    if goal_ is not None and target is not None:
        raise DhcliError("the pose is given in two ways", "leave --target out, it is the same as the second word")
    goal = Goal(goal_ if target is None else target, position, rpy, quaternion, euler, pointing, task)
    if derive or writes_code:
        delivery.hand_over(kind, derived(arm, goal, chosen, with_own=with_values))
        return ExitStatus.DONE
    question = asked(arm, goal, chosen)
    wish = near_of(arm, near, chosen.bare)
    held = held_of(arm, hold or [], chosen.bare)

    from dhcli.kinematics.inverse.asked import inverse  # numpy: not for what is refused before it starts

    wanted: dict[str, object] = {
        "near": wish,
        "hold": held,
        "family": family,
        "within_limits": within_limits,
        "all_turns": all_turns,
    }
    wanted |= {"start": question.start, "end": question.end, "parameters": question.lengths}
    found = inverse(arm, question.pose, task=question.task, **wanted)  # type: ignore[arg-type]  # each is what it takes
    if not len(found) and question.slack:
        from dhcli.kinematics.inverse.as_typed import as_typed  # few poses are

        found = as_typed(found, question.pose, question.slack, wanted)
    found = only_branches(found, branch or [])
    delivery.hand_over("inverse", question.answered(found, wish, why=why), (*question.remarks, *found.remarks))
    return ExitStatus.DONE if len(found) else ExitStatus.NOT_RIGHT
