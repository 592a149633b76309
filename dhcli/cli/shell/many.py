"""The options about files with a row for each result, and what goes with them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, TypeAlias

import typer

from dhcli.cli.shell.options import jobs_option
from dhcli.errors import DhcliError
from dhcli.frozen import frozen

MANY = "Many rows"
"""Heading of the options about files with a row for each result."""


SkipBad: TypeAlias = Annotated[
    bool, typer.Option("--skip-bad", help="Go on without bad rows, list them, and end with 0.", rich_help_panel=MANY)
]
RowJobs: TypeAlias = Annotated[int | None, jobs_option(MANY)]


In: TypeAlias = Annotated[str | None, typer.Option("--in", metavar="FILE", hidden=True)]
"""What `--rows` was once called; where a command knows axes, `--in` is a frame."""


def named_file(rows: str | None, former: str | None) -> str | None:
    """The file that was typed behind `--rows`, or behind its former name; None if none was.

    Raises:
        DhcliError: There are two.
    """
    if rows is not None and former is not None:
        raise DhcliError("--rows and --in both name the file with the rows", "give it once, with --rows FILE")
    return former if rows is None else rows


@frozen
class Many:
    """The options about the rows of a file, as they were typed; `spread` makes options of a command of it.

    Attributes:
        rows: The file.
        in_: The same behind its former name.
        skip_bad: Whether to go on without rows that are bad.
        ignore_columns: Whether columns of something else are left aside.
        index: Whether each result says where its row stands.
        jobs: How many share the work.
    """

    rows: Annotated[
        str | None,
        typer.Option(
            "--rows",
            metavar="FILE",
            help="Joint values, a row for each result: CSV, JSON Lines or .npy; - is stdin. Names and units stand in "
            r"the header: theta1\[deg]. Gives rows: csv, or jsonl or npy by --format or -o.",
            rich_help_panel=MANY,
        ),
    ] = None
    in_: In = None
    skip_bad: SkipBad = False
    ignore_columns: Annotated[
        bool, typer.Option("--ignore-columns", help="Leave columns aside that are no joint.", rich_help_panel=MANY)
    ] = False
    index: Annotated[
        bool,
        typer.Option("--index", help="First column: where the row stands in FILE, as in errors.", rich_help_panel=MANY),
    ] = False
    jobs: RowJobs = None

    @property
    def given(self) -> bool:
        """Whether any of them was typed."""
        return self != Many()

    def file(self, robot: str, others: Mapping[str, object], instead: str) -> str:
        """The file with the rows, if nothing is asked for that a row cannot have.

        Args:
            robot: The robot as it was typed.
            others: Options that do not go with rows, with what was given for them.
            instead: What goes with rows.

        Raises:
            DhcliError: There is no file, or one of the others is given.
        """
        own = "--skip-bad, --ignore-columns, --index and --jobs"
        return file_of_rows(named_file(self.rows, self.in_), own, robot, others, instead)


@frozen
class ManyPoses:
    """The options about the poses of a file, as they were typed; `spread` makes options of a command of it.

    Attributes:
        rows: The file.
        in_: The same behind its former name.
        each: Which solutions of each pose.
        follow: Whether the poses are a path, to be followed on one branch.
        skip_bad: Whether to go on without rows that are bad.
        jobs: How many share the work.
    """

    rows: Annotated[
        str | None,
        typer.Option(
            "--rows",
            metavar="FILE",
            help="Poses, a row each, as fk --rows writes them: CSV, JSON Lines or .npy; - is stdin. Gives rows: where "
            "the pose stands, and joint values; csv, or jsonl or npy by --format or -o.",
            rich_help_panel=MANY,
        ),
    ] = None
    in_: In = None
    each: Annotated[
        str | None,
        typer.Option(metavar="WHICH", help="Of each row: all, nearest (to --near) or first.", rich_help_panel=MANY),
    ] = None
    follow: Annotated[
        bool,
        typer.Option(
            "--follow",
            help="With --rows: stay on one branch along the rows, beginning near --near; jumps are told.",
            rich_help_panel=MANY,
        ),
    ] = False
    skip_bad: SkipBad = False
    jobs: RowJobs = None

    @property
    def given(self) -> bool:
        """Whether any of them was typed."""
        return self != ManyPoses()

    def file(self, robot: str, others: Mapping[str, object], instead: str) -> str:
        """The file with the poses; as for `Many`."""
        own = "--each, --follow, --skip-bad and --jobs"
        return file_of_rows(named_file(self.rows, self.in_), own, robot, others, instead)


def file_of_rows(path: str | None, own: str, robot: str, others: Mapping[str, object], instead: str) -> str:
    """The file with the rows, if nothing is asked for that a row cannot have.

    Args:
        path: The file as it was typed.
        own: The options that are for rows.
        robot: The robot as it was typed.
        others: Options that do not go with rows, with what was given for them.
        instead: What goes with rows.

    Raises:
        DhcliError: There is no file, one of the others is given, or robot and rows both come from standard input.
    """
    if path is None:
        raise DhcliError(f"{own} are for many rows", "name their file with --rows FILE")
    if path == robot == "-":
        raise DhcliError("the robot and the rows cannot both come from standard input", "save one of them in a file")
    if given := [name for name, value in others.items() if value is not None and value is not False]:
        verb = "does" if len(given) == 1 else "do"
        raise DhcliError(f"{' and '.join(given)} {verb} not go with --rows", instead)
    return path
