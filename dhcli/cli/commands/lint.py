"""`dhcli lint`: what a careful lecturer would find in exercises, robots and linkages."""

from __future__ import annotations

from typing import Annotated

import typer

from dhcli.cli.shell.written import Written, in_formats
from dhcli.errors import ExitStatus

EXAMPLES = """
[bold]Examples[/]

dhcli lint

dhcli lint exercises/my-course robots/my-arm.yaml
"""


def lint(
    paths: Annotated[
        list[str] | None,
        typer.Argument(metavar="PATH...", help="Files and folders; ./robots and ./exercises by default."),
    ] = None,
    *,
    out: Annotated[Written, in_formats(("table", "json"), (".json", ".txt"))],
) -> ExitStatus:
    """Look for mistakes in exercises, robots and linkages before students do; ends with 1 on an error."""
    from dhcli.lint.files import lint as lint_files

    delivery = out.delivery("lint", "lint")
    linted = lint_files(paths or ())
    delivery.hand_over("lint", linted)
    return ExitStatus.NOT_RIGHT if linted.errors else ExitStatus.DONE
