"""Options that several commands have, and shell completion for names."""

from __future__ import annotations

import os
from typing import Annotated, Any, TypeAlias

import typer

from dhcli.cli.shell import completing

RobotName: TypeAlias = Annotated[
    str,
    typer.Argument(
        metavar="ROBOT",
        help="A name of the library, a YAML or URDF file, or - for stdin.",
        autocompletion=completing.of_library("robots"),
    ),
]


AnyName: TypeAlias = Annotated[
    str,
    typer.Argument(
        metavar="NAME",
        help="A robot, a linkage or an exercise, a YAML or URDF file, or - for a robot on stdin.",
        autocompletion=completing.of_library("robots"),
    ),
]


ExerciseName: TypeAlias = Annotated[
    str,
    typer.Argument(
        metavar="EXERCISE", help="An exercise of the library, or a YAML file.", autocompletion=completing.exercise
    ),
]
ExerciseOrRobot: TypeAlias = Annotated[
    str,
    typer.Argument(
        metavar="NAME", help="An exercise, or a robot with a question about it.", autocompletion=completing.exercise
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


Forms: TypeAlias = Annotated[
    list[str] | None,
    typer.Option(
        "--as",
        metavar="FORM",
        help="rpy, axis-angle, quaternion, rotation-vector, position, matrix, zyz or any order of axes, fixed-xyz; "
        "repeatable, or with commas.",
        autocompletion=completing.forms,
    ),
]


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
        autocompletion=completing.of_robot("frames"),
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
