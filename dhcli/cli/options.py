"""Options that several commands have, and shell completion for names."""

from __future__ import annotations

from typing import Annotated, TypeAlias

import typer


def complete_robot(incomplete: str) -> list[str]:
    """Names of robots that begin like this; reads no file."""
    from dhcli.files.library import Kind, entries

    return [entry.name for entry in entries(Kind.ROBOTS) if entry.name.startswith(incomplete)]


RobotName: TypeAlias = Annotated[
    str,
    typer.Argument(
        metavar="ROBOT", help="A name of the library, a YAML file, or - for stdin.", autocompletion=complete_robot
    ),
]


def complete_exercise(incomplete: str) -> list[str]:
    """Names of exercises that begin like this, with their folder or without; reads no file."""
    from dhcli.files.library import Kind, entries

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
Format: TypeAlias = Annotated[
    str | None,
    typer.Option(
        "--format", metavar="NAME", help="table, json, latex, matlab, numpy, csv or sympy.", rich_help_panel="Output"
    ),
]
Digits: TypeAlias = Annotated[
    int | None, typer.Option(min=0, max=15, metavar="N", help="Decimals to show.", rich_help_panel="Output")
]
Spelling: TypeAlias = Annotated[
    str | None,
    typer.Option("--style", metavar="NAME", help="short writes c1, full writes cos(theta1).", rich_help_panel="Output"),
]
Output: TypeAlias = Annotated[
    str | None,
    typer.Option(
        "-o",
        "--output",
        metavar="FILE",
        callback=lambda path: None if path == "-" else path,  # standard output, as - is standard input
        help="Write to a file; .json .tex .m .py .csv .txt choose the format.",
        rich_help_panel="Output",
    ),
]
Force: TypeAlias = Annotated[bool, typer.Option("--force", help="Overwrite the file.", rich_help_panel="Output")]
Settings: TypeAlias = Annotated[
    list[str] | None,
    typer.Option("--set", metavar="NAME=VALUE", help="Value of a length or constant angle; repeatable."),
]
Forms: TypeAlias = Annotated[
    list[str] | None,
    typer.Option(
        "--as", metavar="FORM", help="rpy, axis-angle, quaternion, position or matrix; repeatable, or with commas."
    ),
]
