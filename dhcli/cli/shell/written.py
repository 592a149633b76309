"""The options that say how a result is written, and where to."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Annotated, Any, TypeAlias

import typer

from dhcli.cli.shell import completing
from dhcli.cli.shell.spreading import But
from dhcli.errors import joined
from dhcli.frozen import frozen

if TYPE_CHECKING:
    from dhcli.cli.shell.delivery import Delivery
    from dhcli.cli.shell.rows import RowDelivery


_PANEL = "Output"
"""Heading of all these options."""


def format_option(*names: str) -> Any:  # noqa: ANN401  what typer makes of an option
    """`--format` for the formats that a command has, with completion."""
    return typer.Option(
        "--format",
        metavar="NAME",
        help=f"{joined(names, 'or')}.",
        rich_help_panel=_PANEL,
        autocompletion=completing.among(*names),
    )


def file_to_write(path: str | None) -> str | None:
    """A file to write as it was typed.

    Raises:
        FileError: Its name is empty, which would pass for an option that is not given.
    """
    if path != "":
        return path
    from dhcli.errors import FileError, Place, Problem
    from dhcli.storage.atomic import EMPTY

    raise FileError(Problem(EMPTY, Place("-o"), "name a file"))


def output_option(told: str, callback: Callable[[str | None], str | None] = file_to_write) -> Any:  # noqa: ANN401
    """`-o` for what a command writes, and what the help tells of it."""
    return typer.Option("-o", "--output", metavar="FILE", callback=callback, help=told, rich_help_panel=_PANEL)


def result_option(*suffixes: str) -> Any:  # noqa: ANN401  the same
    """`-o` for the files that a result is written to; - is standard output, where it goes by itself."""
    told = f"Write to a file; {' '.join(suffixes)} choose the format."
    return output_option(told, lambda path: None if path == "-" else file_to_write(path))


Overwrite: TypeAlias = Annotated[bool, typer.Option("--overwrite", help="Overwrite the file.", rich_help_panel=_PANEL)]
Digits: TypeAlias = Annotated[
    int | None, typer.Option(min=0, max=15, metavar="N", help="Decimals to show.", rich_help_panel=_PANEL)
]
LANGUAGES = ("python", "numpy", "c", "matlab", "julia", "javascript")
"""Languages in which a function can be written."""


@frozen
class Written:
    """How a person wants a result, as it was typed; `spread` makes options of a command of it.

    Attributes:
        format: The format.
        code: The language of a function.
        with_values: Whether the lengths of the robot stand in that in numbers.
        style: Spelling of formulas.
        digits: Decimals to show.
        output: The file to write.
        overwrite: Whether that file may be overwritten.
    """

    format: Annotated[str | None, format_option("table", "json", "latex", "matlab", "numpy", "csv", "sympy")] = None
    code: Annotated[
        str | None,
        typer.Option(
            "--code",
            metavar="LANGUAGE",
            help=f"A function that runs: {joined(LANGUAGES, 'or')}.",
            rich_help_panel=_PANEL,
            autocompletion=completing.among(*LANGUAGES),
        ),
    ] = None
    with_values: Annotated[
        bool,
        typer.Option(
            "--with-values",
            help="With --code: the robot's lengths as numbers, not as arguments.",
            rich_help_panel=_PANEL,
        ),
    ] = False
    style: Annotated[
        str | None,
        typer.Option(
            "--style", metavar="NAME", help="short writes c1, full writes cos(theta1).", rich_help_panel=_PANEL
        ),
    ] = None
    digits: Digits = None
    output: Annotated[str | None, result_option(".json", ".tex", ".m", ".py", ".csv", ".txt")] = None
    overwrite: Overwrite = False

    @property
    def is_code(self) -> bool:
        """Whether a function is asked for."""
        return self.code is not None or self.with_values

    @property
    def options(self) -> dict[str, object]:
        """What was typed that is for a result shown, and not for rows of numbers."""
        return {"--style": self.style, "--digits": self.digits, "--code": self.code, "--with-values": self.with_values}

    def delivery(self, command: str, kind: str) -> Delivery:
        """Where a result goes, once everything that can be known before the work has been looked at.

        Args:
            command: The command typed.
            kind: What kind of result it is.

        Raises:
            DhcliError: It cannot be written so.
        """
        from dhcli.cli.shell.delivery import Delivery

        delivery = Delivery(command, self.format, self.digits, self.style, self.output, self.overwrite)
        delivery.chosen(kind)
        return delivery

    def rows(self) -> RowDelivery:
        """Where rows of numbers go."""
        from dhcli.cli.shell.rows import RowDelivery

        return RowDelivery(self.format, self.output, self.overwrite)


_CODE = ("code", "with_values")

Shown: TypeAlias = Annotated[Written, But(without=_CODE)]
"""Those of a result that is no function."""


def in_formats(formats: tuple[str, ...], suffixes: tuple[str, ...], *others: str) -> But:
    """How the options differ of a command that has formats of its own.

    Args:
        formats: Its formats.
        suffixes: The suffixes of its files, which choose one.
        others: What else it has of `code`, `with_values`, `style` and `digits`.
    """
    own = {
        "format": Annotated[str | None, format_option(*formats)],
        "output": Annotated[str | None, result_option(*suffixes)],
    }
    return But(without=tuple(name for name in (*_CODE, "style", "digits") if name not in others), instead=own)
