"""The robot that a command is about: which one, at which joint values, with which tool, between which frames."""

from __future__ import annotations

from dataclasses import field, replace
from typing import Annotated, Literal

import typer

from dhcli.cli.shell import completing
from dhcli.cli.shell.options import WHERE, RobotName, Settings
from dhcli.cli.shell.spreading import REQUIRED
from dhcli.frozen import frozen

_URDF = "URDF"


@frozen
class Chosen:
    """The options of every command about a robot, as they were typed; `spread` makes them options of a command.

    Attributes:
        robot: The name, or a file.
        q: Joint values.
        deg: Whether bare angles are degrees.
        pose: A named pose.
        set_: Values of lengths, `NAME=VALUE`.
        motors: Whether all that holds for joints is meant for the motors that drive them.
        from_: The frame it is seen from.
        to: The frame meant.
        tool: The tool that it has, by name or in moves.
        base: The link of a URDF that is frame 0.
        tip: The link of a URDF that is the last frame.
        as_typed: Whether the numbers of a URDF stay as they are.
    """

    robot: RobotName = field(default="", metadata=REQUIRED)
    q: Annotated[
        str | None,
        typer.Option(
            "--q", metavar="VALUES", help="Joint values: 0.3,30deg,120mm or q1=0.3,d3=0.1, a named pose, or @FILE."
        ),
    ] = None
    deg: Annotated[bool, typer.Option("--deg", help="Bare numbers of angles are degrees.")] = False
    pose: Annotated[
        str | None,
        typer.Option(
            "--pose",
            metavar="NAME",
            help="A named pose of the robot; --q NAME=VALUE varies it.",
            autocompletion=completing.of_robot("poses"),
        ),
    ] = None
    set_: Settings = None
    motors: Annotated[
        bool, typer.Option("--motors", help="Values, rates and torques of the motors, not of the joints.")
    ] = False
    from_: Annotated[
        str | None,
        typer.Option(
            "--from",
            metavar="FRAME",
            help="Seen from this frame; by default the first.",
            rich_help_panel=WHERE,
            autocompletion=completing.of_robot("frames"),
        ),
    ] = None
    to: Annotated[
        str | None,
        typer.Option(
            "--to",
            metavar="FRAME",
            help="Of this frame; by default the last.",
            rich_help_panel=WHERE,
            autocompletion=completing.of_robot("frames"),
        ),
    ] = None
    tool: Annotated[
        str | None,
        typer.Option(
            "--tool",
            metavar="TOOL",
            help="Of the end of this tool: one that the file names, or 'Trans(0,0,0.1) Rot(z,45°)'.",
            rich_help_panel=WHERE,
        ),
    ] = None
    base: Annotated[
        str | None,
        typer.Option("--base", metavar="LINK", help="Link of a URDF that is frame 0.", rich_help_panel=_URDF),
    ] = None
    tip: Annotated[
        str | None,
        typer.Option("--tip", metavar="LINK", help="Link of a URDF that is the last frame.", rich_help_panel=_URDF),
    ] = None
    as_typed: Annotated[
        bool, typer.Option("--as-typed", help="1.5708 in a URDF stays what it is.", rich_help_panel=_URDF)
    ] = False

    @property
    def end(self) -> str | None:
        """The frame meant: of a tool that was typed its own, where no other was named."""
        return "tool" if self.tool is not None and self.to is None and self.from_ != "tool" else self.to

    @property
    def stands(self) -> bool:
        """Whether joint values were typed."""
        return self.q is not None or self.pose is not None

    @property
    def more(self) -> bool:
        """Whether anything but the name was typed."""
        return replace(self, robot="", set_=self.set_ or None) != Chosen()

    @property
    def bare(self) -> Literal["deg", "rad"]:
        """What a bare number of an angle is."""
        return "deg" if self.deg else "rad"
