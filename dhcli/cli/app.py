"""All commands, registered in one place. A command's own file is imported when it is asked for."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Annotated

import typer
from typer.core import TyperCommand, TyperGroup, TyperOption

from dhcli.errors import DhcliError

if TYPE_CHECKING:
    from typer._click import Command, Context

COMMANDS = {
    "fk": "dhcli.cli.commands.fk:fk",
    "sweep": "dhcli.cli.commands.sweep:sweep",
    "transform": "dhcli.cli.commands.transform:transform",
    "dof": "dhcli.cli.commands.dof:dof",
    "check": "dhcli.cli.commands.check:check",
    "start": "dhcli.cli.commands.start:start",
    "watch": "dhcli.cli.commands.watch:watch",
    "hint": "dhcli.cli.commands.hint:hint",
    "solution": "dhcli.cli.commands.solution:solution",
    "grade": "dhcli.cli.commands.grade:grade",
    "show": "dhcli.cli.commands.show:show",
    "list": "dhcli.cli.commands.listing:list_",
    "new": "dhcli.cli.commands.new:new",
    "lint": "dhcli.cli.commands.lint:lint",
}
"""Every command and the function behind it; the order is that of the help."""

EXAMPLES = """
[bold]Start here[/]

dhcli list

dhcli show scara

dhcli fk scara --q 0.3,0.5,0.1

dhcli fk puma560 --symbolic
"""


class Commands(TyperGroup):
    """A group that imports a command when it is asked for."""

    def list_commands(self, ctx: Context) -> list[str]:
        """The names in the order of the help."""
        return list(COMMANDS)

    def get_command(self, ctx: Context, cmd_name: str) -> Command | None:
        """A command by its name, None if there is none."""
        return load(cmd_name) if cmd_name in COMMANDS else None


class OnceEach(TyperCommand):
    """A command that takes an option with one value once; of two, typer would silently take the last."""

    def parse_args(self, ctx: Context, args: list[str]) -> list[str]:
        """Refuse what is given twice, then parse as ever.

        Raises:
            DhcliError: An option is given twice that has one value.
        """
        _, _, given = self.make_parser(ctx).parse_args(list(args))
        for param in given:
            is_single = isinstance(param, TyperOption) and not param.multiple and not param.is_flag
            if is_single and given.count(param) > 1:
                raise DhcliError(f"{param.opts[0]} is given {given.count(param)} times", "it has one value: keep one")
        return super().parse_args(ctx, args)


def load(name: str) -> Command:
    """Import a command and make it one of typer's."""
    where, _, function = COMMANDS[name].partition(":")
    module = import_module(where)
    found = getattr(module, function)
    if isinstance(found, typer.Typer):
        command = typer.main.get_command(found)
    else:
        single = typer.Typer(add_completion=False, rich_markup_mode="rich")
        single.command(name, cls=OnceEach, epilog=module.EXAMPLES)(found)
        command = typer.main.get_command(single)
    command.name = name
    return command


def build() -> Command:
    """The whole command line."""
    # Commands take the names of their help from here.
    names = {"help_option_names": ["--help", "-h"]}
    app = typer.Typer(cls=Commands, rich_markup_mode="rich", context_settings=names)
    app.callback(epilog=EXAMPLES)(root)
    return typer.main.get_command(app)


def _version(*, wanted: bool) -> None:
    if wanted:
        from dhcli import __version__
        from dhcli.cli.shell.console import write_out

        write_out(f"dhcli {__version__}\n")
        raise typer.Exit


def root(
    version: Annotated[
        bool, typer.Option("--version", help="Show the version and stop.", callback=_version, is_eager=True)
    ] = False,
) -> None:
    """Forward kinematics of robot arms: from a DH table to the pose, in numbers or as the textbook prints it."""
