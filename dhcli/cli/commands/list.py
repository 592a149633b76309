"""`dhcli list`: what there is, and where it comes from."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from dhcli.cli.shell import completing
from dhcli.cli.shell.written import Written, in_formats

if TYPE_CHECKING:
    from dhcli.files.library.entries import Kind

EXAMPLES = """
[bold]Examples[/]

dhcli list

dhcli list robots --format json
"""


def list_(
    kind: Annotated[
        str | None,
        typer.Argument(
            metavar="KIND",
            help="robots, linkages or exercises; all by default.",
            autocompletion=completing.among("robots", "linkages", "exercises"),
        ),
    ] = None,
    *,
    out: Annotated[Written, in_formats(("table", "json", "csv"), (".json", ".csv", ".txt"))],
) -> None:
    """List what there is: names, joints, titles, and the folder each comes from."""
    from dhcli.cli.shell.console import tell
    from dhcli.files.library.catalogue import catalogue

    delivery = out.delivery("list", "library")
    listed = catalogue(kinds_of(kind))
    delivery.hand_over("library", listed)
    if not listed:
        tell(f"there are no {kind or 'files'} yet")


def kinds_of(word: str | None) -> tuple[Kind, ...]:
    """The kinds meant by a word; all of them by none."""
    from dhcli.errors import UnknownNameError, did_you_mean
    from dhcli.files.library.entries import Kind

    if word is None:
        return tuple(Kind)
    kinds = {kind.value: kind for kind in Kind} | {kind.noun: kind for kind in Kind}
    if word not in kinds:
        hint = did_you_mean(word, [kind.value for kind in Kind])
        raise UnknownNameError(f"there is no kind of thing called {word}", hint)
    return (kinds[word],)
