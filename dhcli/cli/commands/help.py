"""`dhcli help`: the manual."""

from __future__ import annotations

import os
import sys
from typing import Annotated

import typer

from dhcli.cli.shell import completing

EXAMPLES = """
[bold]Examples[/]

dhcli help

dhcli help student

dhcli help check
"""


def help_(
    topic: Annotated[
        str | None,
        typer.Argument(metavar="TOPIC", help="A page or a command; without one: all.", autocompletion=completing.topic),
    ] = None,
) -> None:
    """Show a page of the manual; in a pipe it is Markdown."""
    from dhcli.cli.shell.console import write_out
    from dhcli.files.manual import read_page
    from dhcli.render.paper import Paper
    from dhcli.render.text.manual import page_text

    paper = Paper.of(sys.stdout)
    text = page_text(read_page(topic), paper)
    if paper.terminal and text.count("\n") >= os.get_terminal_size(sys.stdout.fileno()).lines:
        import pydoc

        # colours pass, the page stays on the screen afterwards, and long lines of an example go on to the right
        os.environ.setdefault("LESS", "-RFXS")
        pydoc.pager(text)
    else:
        write_out(text)
