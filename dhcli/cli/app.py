"""All commands, registered in one place. A command's own file is imported when it is asked for."""

from __future__ import annotations

import os
import sys
from importlib import import_module
from inspect import cleandoc
from types import ModuleType
from typing import TYPE_CHECKING, Annotated, Any

import typer
from typer.core import TyperCommand, TyperGroup, TyperOption

from dhcli.cli.shell.spreading import spread
from dhcli.errors import DhcliError

if TYPE_CHECKING:
    from typer._click import Command, Context, HelpFormatter

PANELS = {
    "Compute": ("fk", "ik", "sweep", "jacobian", "singularities", "rates", "torques", "transform", "describe", "dof"),
    "See": ("draw",),
    "Exercises": ("start", "check", "watch", "hint", "solution"),
    "Classes": ("grade",),
    "Library and authors": ("show", "list", "new", "lint", "schema"),
    "Manual": ("help",),
}
"""Every command under its heading in the help, which keeps this order; each has the file of its name in `commands`."""

COMMANDS = tuple(name for names in PANELS.values() for name in names)

EXAMPLES = """
[bold]Start here[/]

dhcli list

dhcli show scara

dhcli fk scara --q 0.3,0.5,0.1

dhcli fk puma560 --symbolic

dhcli help student
"""


class _PlainHelp:
    """Help without colours, and without bold letters too, where nobody wants them; typer leaves the bold ones."""

    def format_help(self, ctx: Context, formatter: HelpFormatter) -> None:
        """Write the help as ever, once rich knows."""
        if not os.environ.get("TERMINAL_WIDTH", "").isdigit():
            os.environ.pop("TERMINAL_WIDTH", None)  # typer takes it for a number
        from dhcli.render.paper import is_colour_wanted

        _help_writer().COLOR_SYSTEM = "auto" if is_colour_wanted() else None
        super().format_help(ctx, formatter)  # type: ignore[misc]


def _help_writer() -> Any:  # noqa: ANN401  a module
    """What typer writes help with, had without the two readers that it imports for others, and that cost most of it.

    They read Markdown and tracebacks; a stand-in is there for each while it is imported, unless the reader itself is.
    """
    spared = {"rich.markdown", "rich.traceback"} - sys.modules.keys()
    for name in spared:
        stand_in: Any = ModuleType(name)
        stand_in.__getattr__ = lambda _: object
        sys.modules[name] = stand_in
    try:
        return import_module("typer.rich_utils")
    finally:
        for name in spared:
            del sys.modules[name]


class Group(_PlainHelp, TyperGroup):
    """A command with commands of its own."""


class One(_PlainHelp, TyperCommand):
    """One of them, which takes an option with one value once; of two, typer would silently take the last.

    Where it reads what a person types at a terminal, it says that it waits for it.
    """

    def parse_args(self, ctx: Context, args: list[str]) -> list[str]:
        """Refuse what is given twice, then parse as ever.

        Raises:
            DhcliError: An option is given twice that has one value.
        """
        from typer._click.core import augment_usage_errors

        with augment_usage_errors(ctx):  # an option without its value is refused without a word about the command
            _, _, given = self.make_parser(ctx).parse_args(list(args))
        for param in given:
            is_single = isinstance(param, TyperOption) and not param.multiple and not param.is_flag
            if is_single and given.count(param) > 1:
                raise DhcliError(f"{param.opts[0]} is given {given.count(param)} times", "it has one value: keep one")
        return super().parse_args(ctx, args)

    def invoke(self, ctx: Context) -> object:
        """Run the command."""
        typed = {str(value) for name, value in ctx.params.items() if name != "output"}
        if typed & {"-", "@-"} and sys.stdin and not sys.stdin.closed and sys.stdin.isatty():
            from dhcli.cli.shell.console import say

            say("dhcli: reading from the keyboard; Ctrl-D on an empty line ends it\n")
        return super().invoke(ctx)


class Commands(Group):
    """A group that imports a command when it is asked for."""

    is_listing = False

    def list_commands(self, ctx: Context) -> list[str]:
        """The names in the order of the help."""
        return list(COMMANDS)

    def get_command(self, ctx: Context, cmd_name: str) -> Command | None:
        """A command by its name, None if there is none."""
        if cmd_name not in COMMANDS:
            return None
        return _listed(cmd_name) if self.is_listing else load(cmd_name)

    def format_help(self, ctx: Context, formatter: HelpFormatter) -> None:
        """Write the help, which names every command without its options."""
        self.is_listing = True
        try:
            super().format_help(ctx, formatter)
        finally:
            self.is_listing = False


def _listed(name: str) -> Command:
    """A command as the help of all names it."""
    found = _found(name)
    if isinstance(found, typer.Typer):
        return load(name)
    return One(name, help=cleandoc(found.__doc__ or ""), rich_markup_mode="rich", rich_help_panel=_panel(name))


def _found(name: str) -> Any:  # noqa: ANN401  a function or a group of them
    """What the file of a command defines."""
    module = import_module(f"dhcli.cli.commands.{name}")
    return getattr(module, name, None) or getattr(module, f"{name}_")  # of `list_` and `help_` Python has the name


def _panel(name: str) -> str:
    """The heading that a command stands under."""
    return next(panel for panel, names in PANELS.items() if name in names)


def load(name: str) -> Command:
    """Import a command and make it one of typer's."""
    found = _found(name)
    if isinstance(found, typer.Typer):
        command = typer.main.get_command(found)
    else:
        single = typer.Typer(add_completion=False, rich_markup_mode="rich")
        single.command(name, cls=One, epilog=sys.modules[found.__module__].EXAMPLES)(spread(found))
        command = typer.main.get_command(single)
    command.name = name
    command.rich_help_panel = _panel(name)  # type: ignore[attr-defined]
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
    """Kinematics of robot arms: poses, joint values, velocities, pictures; in numbers or as a textbook prints them."""
