"""`dhcli schema`: what editors need to complete keys and to mark mistakes."""

from __future__ import annotations

from typing import Annotated

import typer

from dhcli.cli.shell import completing
from dhcli.cli.shell.written import Overwrite, output_option

EXAMPLES = """
[bold]Examples[/]

dhcli schema robot -o robot.schema.json

dhcli schema exercise
"""


def schema(
    kind: Annotated[
        str,
        typer.Argument(
            metavar="KIND",
            help="robot, exercise or linkage.",
            autocompletion=completing.of_module("files.keys.schema", "KINDS"),
        ),
    ],
    output: Annotated[str | None, output_option("Write to a file; - is stdout.")] = None,
    overwrite: Overwrite = False,
) -> None:
    """Print the JSON schema of a kind of file, for an editor that completes keys and marks mistakes."""
    import json

    from dhcli.cli.shell.console import tell, write_out
    from dhcli.cli.shell.delivery import write_file
    from dhcli.files.keys.schema import schema_of
    from dhcli.render.endings import check_ending

    text = json.dumps(schema_of(kind), indent=2, ensure_ascii=False) + "\n"
    if output in (None, "-"):
        write_out(text)
        return
    check_ending(output, "json")
    write_file(output, text, overwrite=overwrite)
    tell(f"wrote {output}")
    tell(f"next: begin a file with # yaml-language-server: $schema={output}")
