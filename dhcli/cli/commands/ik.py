"""`dhcli ik`: the joint values that take a robot's end to a pose, all of them."""

from __future__ import annotations

from dataclasses import replace
from typing import Annotated, TypeAlias

import typer

from dhcli.cli.shell import completing
from dhcli.cli.shell.chosen import Chosen
from dhcli.cli.shell.many import ManyPoses
from dhcli.cli.shell.spreading import But
from dhcli.cli.shell.wishes import POSE, Goal, Which
from dhcli.cli.shell.written import Written, in_formats
from dhcli.errors import ExitStatus

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


Standing: TypeAlias = Annotated[
    str | None,
    typer.Option(
        "--q", metavar="VALUES", help="Where these joint values stand, as fk takes them.", rich_help_panel=POSE
    ),
]
StandingPose: TypeAlias = Annotated[
    str | None,
    typer.Option(
        "--pose",
        metavar="NAME",
        help="Where a named pose of the robot stands.",
        rich_help_panel=POSE,
        autocompletion=completing.of_robot("poses"),
    ),
]


def ik(
    chosen: Annotated[Chosen, But(instead={"q": Standing, "pose": StandingPose})],
    word: Annotated[str | None, typer.Argument(metavar="[TARGET]", help="The same as --target.")] = None,
    *,
    goal: Goal,
    which: Which,
    many: ManyPoses,
    why: Annotated[
        bool,
        typer.Option("--why", help="Which rule finds each joint, and which limits keep solutions out."),
    ] = False,
    derive: Annotated[
        bool, typer.Option("--derive", help="The formulas, step by step as a book derives them; no pose is needed.")
    ] = False,
    out: Annotated[
        Written,
        in_formats(
            ("table", "json", "csv", "latex", "md"),
            (".json", ".csv", ".tex", ".md", ".txt"),
            "code",
            "with_values",
            "digits",
        ),
    ],
) -> ExitStatus:
    """Inverse kinematics: every way to hold the joints so that the end frame stands in a pose."""
    if many.given:
        return _rows(chosen, word, goal, which, many, out, derive=derive, why=why)
    if derive or out.is_code:
        return _derived(chosen, word, goal, which, out, why=why)
    return _solved(chosen, word, goal, which, out, why=why)


def _rows(
    chosen: Chosen,
    word: str | None,
    goal: Goal,
    which: Which,
    many: ManyPoses,
    out: Written,
    *,
    derive: bool,
    why: bool,
) -> ExitStatus:
    """The solutions of each pose of a file."""
    from dhcli.cli.shell.inverse_rows import solve_rows

    others: dict[str, object] = {"--q": chosen.q, "--pose": chosen.pose, "--target": goal.target}
    others |= {"--position": goal.position, "--rpy": goal.rpy, "--quaternion": goal.quaternion}
    others |= {"--pointing": goal.pointing, "--branch": which.branch or None, "--family": which.family}
    others |= {"--all-turns": which.all_turns, "--derive": derive, "--digits": out.digits}
    others |= {"--euler": goal.euler, "--why": why, "TARGET": word, "--code": out.code}
    others |= {"--with-values": out.with_values}
    return solve_rows(chosen, goal.task, which, many, others, out.rows())


def _derived(chosen: Chosen, word: str | None, goal: Goal, which: Which, out: Written, *, why: bool) -> ExitStatus:
    """The formulas of a solution, or functions that compute them."""
    from dhcli.cli.shell.coding import check_alone, code_delivery
    from dhcli.cli.shell.given import robot_of
    from dhcli.cli.shell.solutions import derived

    kind = "inverse function" if out.is_code else "derivation"
    others: dict[str, object] = {"--near": which.near, "--branch": which.branch, "--family": which.family}
    others |= {"--hold": which.hold, "--why": why, "--within-limits": which.within_limits}
    others |= {"--all-turns": which.all_turns}
    if out.is_code:
        delivery = code_delivery(out, "ik", kind, others)
    else:
        check_alone("--derive", others)
        delivery = out.delivery("ik", kind)
    arm = robot_of(chosen)
    found, remarks = derived(arm, _one(goal, word), chosen, with_own=out.with_values), list[str]()
    if (form := found.robot.convention) is not arm.convention:
        remarks = [f"the formulas are those of its DH table: dhcli describe {arm.typed} --as {form.value} shows it"]
    delivery.hand_over(kind, found, remarks)
    return ExitStatus.DONE


def _solved(chosen: Chosen, word: str | None, goal: Goal, which: Which, out: Written, *, why: bool) -> ExitStatus:
    """The solutions of one pose."""
    from dhcli.cli.shell.given import robot_of
    from dhcli.cli.shell.goal import asked
    from dhcli.cli.shell.solutions import held_of, near_of, only_branches

    delivery = out.delivery("ik", "inverse")
    arm = robot_of(chosen)
    question = asked(arm, _one(goal, word), chosen)
    near = near_of(arm, which.near, chosen.bare)
    held = held_of(arm, which.hold or [], chosen.bare)

    from dhcli.kinematics.inverse.asked import inverse  # numpy: not for what is refused before it starts

    wanted: dict[str, object] = {
        "near": near,
        "hold": held,
        "family": which.family,
        "all_turns": which.all_turns,
    }
    wanted |= {"start": question.start, "end": question.end, "parameters": question.lengths}
    found = inverse(arm, question.standing or question.pose, task=question.task, **wanted)  # type: ignore[arg-type]  # each is what it takes
    if question.slack:
        from dhcli.kinematics.inverse.as_typed import as_typed, at_limits  # few poses are

        found = as_typed(found, question.pose, question.slack, wanted)
        found = at_limits(found, question.pose, question.slack, wanted)
    if which.within_limits and len(found):
        from dhcli.kinematics.inverse.turns import inside_only

        found = inside_only(found)
        if not len(found):  # joints to spare may stand elsewhere
            found = inverse(arm, question.pose, task=question.task, within_limits=True, **wanted)  # type: ignore[arg-type]
    found = only_branches(found, which.branch or [])
    delivery.hand_over("inverse", question.answered(found, near, why=why), (*question.remarks, *found.remarks))
    return ExitStatus.DONE if len(found) else ExitStatus.NOT_RIGHT


def _one(goal: Goal, word: str | None) -> Goal:
    """The pose that was typed, behind `--target` or as a word.

    Raises:
        DhcliError: It was typed twice.
    """
    if word is None:
        return goal
    if goal.target is not None:
        from dhcli.errors import DhcliError

        raise DhcliError("the pose is given in two ways", "leave --target out, it is the same as the second word")
    return replace(goal, target=word)
