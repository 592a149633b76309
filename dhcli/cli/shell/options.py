"""Options that several commands have, and shell completion for names."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Annotated, Any, TypeAlias

import typer

if TYPE_CHECKING:
    from dhcli.kinematics.robot import Robot


def complete_robot(incomplete: str) -> list[str]:
    """Names of robots that begin like this; reads no file."""
    from dhcli.files.library.entries import Kind, entries

    return [entry.name for entry in entries(Kind.ROBOTS) if entry.name.startswith(incomplete)]


RobotName: TypeAlias = Annotated[
    str,
    typer.Argument(
        metavar="ROBOT",
        help="A name of the library, a YAML or URDF file, or - for stdin.",
        autocompletion=complete_robot,
    ),
]


AnyName: TypeAlias = Annotated[
    str,
    typer.Argument(
        metavar="NAME",
        help="A robot, a linkage or an exercise, a YAML or URDF file, or - for a robot on stdin.",
        autocompletion=complete_robot,
    ),
]


def complete_exercise(incomplete: str) -> list[str]:
    """Names of exercises that begin like this, with their folder or without; reads no file."""
    from dhcli.files.library.entries import Kind, entries

    names = [entry.name for entry in entries(Kind.EXERCISES)]
    return [name for name in names if name.startswith(incomplete) or name.split("/")[-1].startswith(incomplete)]


ExerciseName: TypeAlias = Annotated[
    str,
    typer.Argument(
        metavar="EXERCISE", help="An exercise of the library, or a YAML file.", autocompletion=complete_exercise
    ),
]
ExerciseOrRobot: TypeAlias = Annotated[
    str,
    typer.Argument(
        metavar="NAME", help="An exercise, or a robot with a question about it.", autocompletion=complete_exercise
    ),
]
Variant: TypeAlias = Annotated[
    str | None,
    typer.Option("--variant", metavar="NAME", help="With the numbers drawn for NAME, any text; the same everywhere."),
]


WHERE = "Where and what"
"""Heading of the options that choose frames and points."""

Settings: TypeAlias = Annotated[
    list[str] | None,
    typer.Option("--set", metavar="NAME=VALUE", help="Value of a length or constant angle; repeatable."),
]


def jobs_option(panel: str | None = None) -> Any:  # noqa: ANN401  the same
    """`--jobs`, under a heading of the help."""
    told = "How many share the work; by default one a processor, fewer for little work."
    return typer.Option("--jobs", min=1, metavar="N", help=told, rich_help_panel=panel)


Jobs: TypeAlias = Annotated[int | None, jobs_option()]


def workers(jobs: int | None, worth: int) -> int:
    """How many share a work: as many as `--jobs` says, else one a processor, but no more than pay for their start."""
    return jobs or max(1, min(_processors(), worth))


def _processors() -> int:
    """How many processors this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def complete_forms(incomplete: str) -> list[str]:
    """Ways to say a pose, behind those that are typed already."""
    before, comma, begun = incomplete.rpartition(",")
    from dhcli.kinematics.placement import FORMS

    return [f"{before}{comma}{name}" for name in FORMS if name.startswith(begun)]


Forms: TypeAlias = Annotated[
    list[str] | None,
    typer.Option(
        "--as",
        metavar="FORM",
        help="rpy, axis-angle, quaternion, rotation-vector, position, matrix, zyz or any order of axes, fixed-xyz; "
        "repeatable, or with commas.",
        autocompletion=complete_forms,
    ),
]


def complete_pose(ctx: typer.Context, incomplete: str) -> list[str]:
    """Named poses of the robot that is typed already."""
    robot = _robot_of(ctx)
    return [name for name in robot.poses if name.startswith(incomplete)] if robot else []


def complete_frame(ctx: typer.Context, incomplete: str) -> list[str]:
    """Frames of the robot that is typed already."""
    robot = _robot_of(ctx)
    return [name for name in robot.frames if name.startswith(incomplete)] if robot else []


def complete_joint(ctx: typer.Context, incomplete: str) -> list[str]:
    """Joints of the robot that is typed already."""
    robot = _robot_of(ctx)
    return [name for name in robot.variables if name.startswith(incomplete)] if robot else []


def _robot_of(ctx: typer.Context) -> Robot | None:
    """The robot, unless it cannot be read; a shell that completes has no room for errors."""
    from dhcli.errors import DhcliError
    from dhcli.files.yaml.robots import load_robot

    # Behind an option that still lacks its value typer leaves the arguments where they are.
    name = ctx.params.get("robot") or next(iter(ctx.args), None)
    try:
        return load_robot(name) if name and name != "-" else None
    except DhcliError:
        return None


Symbolic: TypeAlias = Annotated[bool, typer.Option("--symbolic", "-s", help="Keep what has no value as symbols.")]
Untried: TypeAlias = Annotated[bool, typer.Option("--yes", help="Show parts that were never tried, too.")]
Let: TypeAlias = Annotated[bool, typer.Option("--let", help="Give names to long or repeated brackets.")]
Axes: TypeAlias = Annotated[
    str | None,
    typer.Option(
        "--in",
        metavar="FRAME",
        help="Along the axes of this frame; those of --from by default.",
        rich_help_panel=WHERE,
        autocompletion=complete_frame,
    ),
]
EndPoint: TypeAlias = Annotated[
    str | None,
    typer.Option(
        "--point", metavar="X,Y,Z", help="Of a point of the end frame, not of its origin.", rich_help_panel=WHERE
    ),
]
AtPoint: TypeAlias = Annotated[
    str | None,
    typer.Option(
        "--at",
        metavar="POINT",
        help="At a point X,Y,Z of the end frame, or at the origin of a frame; at the end's by default.",
        rich_help_panel=WHERE,
    ),
]
