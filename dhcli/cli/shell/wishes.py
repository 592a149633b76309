"""What `ik` and `check` are asked about a robot, as it was typed."""

from __future__ import annotations

from typing import Annotated

import typer

from dhcli.cli.shell import completing
from dhcli.frozen import frozen

POSE = "The pose"
_WHICH = "Which solutions"
QUESTION = "A question about a robot"
TOLERANCE = "How near is near enough"


@frozen
class Goal:
    """The options that say a pose, where it is not that of joint values; `spread` makes options of a command of it.

    Attributes:
        target: Moves or a matrix.
        position: Where the origin is.
        rpy: Roll, pitch and yaw.
        quaternion: A quaternion.
        euler: An order of three axes, and three angles.
        pointing: Where z points to.
        task: What of it counts.
    """

    target: Annotated[
        str | None,
        typer.Option(
            metavar="MOVES",
            help="Moves such as 'Trans(0.4,0,0.3) Rot(y,90°)', a 4x4 matrix, @FILE, or - for stdin, also JSON of fk.",
            rich_help_panel=POSE,
        ),
    ] = None
    position: Annotated[
        str | None,
        typer.Option(metavar="X,Y,Z", help="Where the origin of the end frame is.", rich_help_panel=POSE),
    ] = None
    rpy: Annotated[
        str | None,
        typer.Option(metavar="R,P,Y", help="With --position: roll, pitch and yaw.", rich_help_panel=POSE),
    ] = None
    quaternion: Annotated[
        str | None,
        typer.Option(metavar="W,X,Y,Z", help="With --position: a quaternion.", rich_help_panel=POSE),
    ] = None
    euler: Annotated[
        str | None,
        typer.Option(
            metavar="'ORDER A,B,C'",
            help="With --position: three turns, 'zyz 0,30°,90°' or any order of axes; 'fixed-xyz ...' has fixed axes.",
            rich_help_panel=POSE,
        ),
    ] = None
    pointing: Annotated[
        str | None,
        typer.Option(metavar="X,Y,Z", help="Where the z axis of the end frame points to.", rich_help_panel=POSE),
    ] = None
    task: Annotated[
        str | None,
        typer.Option(
            metavar="WHAT",
            help="What of it counts: pose, position, orientation, axis (position and direction of z) or direction.",
            rich_help_panel=POSE,
            autocompletion=completing.among("pose", "position", "orientation", "axis", "direction"),
        ),
    ] = None


@frozen
class Which:
    """The options that choose solutions; `spread` makes options of a command of it.

    Attributes:
        near: Joint values that they should be near to.
        branch: Words of their branches.
        within_limits: Whether only those inside the limits of the joints are wanted.
        all_turns: Whether angles are wanted in every turn that the limits allow.
        hold: Joints that are not computed, and where they stand.
        family: How many samples of a redundant arm are wanted.
    """

    near: Annotated[
        str | None,
        typer.Option(
            metavar="VALUES",
            help="Sort by distance from joint values or a named pose.",
            rich_help_panel=_WHICH,
            autocompletion=completing.of_robot("poses"),
        ),
    ] = None
    branch: Annotated[
        list[str] | None,
        typer.Option(
            metavar="WORDS",
            help="Only branches with these words, such as 'elbow up'; repeatable.",
            rich_help_panel=_WHICH,
        ),
    ] = None
    within_limits: Annotated[
        bool, typer.Option("--within-limits", help="Only inside the limits of the joints.", rich_help_panel=_WHICH)
    ] = False
    all_turns: Annotated[
        bool,
        typer.Option("--all-turns", help="Angles in every turn that the limits allow.", rich_help_panel=_WHICH),
    ] = False
    hold: Annotated[
        list[str] | None,
        typer.Option(
            metavar="NAME=VALUE",
            help="A joint that is not computed but stands there; repeatable.",
            rich_help_panel=_WHICH,
        ),
    ] = None
    family: Annotated[
        int | None,
        typer.Option(
            min=2, max=1000, metavar="N", help="Sample the joints to spare of a redundant arm.", rich_help_panel=_WHICH
        ),
    ] = None


@frozen
class RobotQuestion:
    """The options that ask something about a robot; `spread` makes options of a command of it.

    Attributes:
        symbolic: Whether symbols are asked for.
        table: The file with a DH table to compare; its convention is the one asked for.
        frames: The file with frames, or with their table, that are to lie on the robot's axes.
        compare: How the table is compared.
        form: What of the pose is answered, or how: position, rotation, rpy, zyz, quaternion and so on.
        entry: Row and column of the one entry that is answered.
        ik: Whether joint values are answered.
        target: Moves or a matrix that they reach.
        position: Where the end is to stand instead.
        branch: Which of them: all, or the words of a branch; any where nothing is said.
    """

    symbolic: Annotated[bool, typer.Option("--symbolic", "-s", help="In symbols.", rich_help_panel=QUESTION)] = False
    table: Annotated[
        str | None,
        typer.Option(
            metavar="FILE",
            help="A DH table: a robot file in either convention, or rows alone.",
            rich_help_panel=QUESTION,
        ),
    ] = None
    frames: Annotated[
        str | None,
        typer.Option(
            metavar="FILE",
            help="Frames on the robot's axes, judged by the rules DH1 to DH3; or a robot file whose table they have.",
            rich_help_panel=QUESTION,
        ),
    ] = None
    compare: Annotated[
        str | None,
        typer.Option(
            metavar="HOW",
            help="How the table is compared: same-robot (the default), same-motion or literal.",
            rich_help_panel=QUESTION,
        ),
    ] = None
    form: Annotated[
        str | None,
        typer.Option(
            "--as",
            metavar="FORM",
            help="What is answered: position, rotation, rpy, quaternion, axis-angle, zyz, ...; the shape says it else.",
            rich_help_panel=QUESTION,
        ),
    ] = None
    entry: Annotated[
        str | None, typer.Option(metavar="ROW,COLUMN", help="One entry of the pose: 1,4.", rich_help_panel=QUESTION)
    ] = None
    ik: Annotated[
        bool, typer.Option("--ik", help="Joint values that reach a pose are answered.", rich_help_panel=QUESTION)
    ] = False
    target: Annotated[
        str | None,
        typer.Option(
            metavar="MOVES",
            help="With --ik: moves such as 'Trans(0.4,0,0.3) Rot(y,90°)', a 4x4 matrix, or @FILE.",
            rich_help_panel=QUESTION,
        ),
    ] = None
    position: Annotated[
        str | None,
        typer.Option(metavar="X,Y,Z", help="With --ik: where the end is to stand.", rich_help_panel=QUESTION),
    ] = None
    branch: Annotated[
        str | None,
        typer.Option(
            metavar="WORDS",
            help="With --ik: which solution is answered, such as 'elbow up', or all; any if left out.",
            rich_help_panel=QUESTION,
        ),
    ] = None

    @property
    def goal(self) -> Goal | None:
        """The pose that joint values are asked for, if they are."""
        return Goal(self.target, self.position) if self.ik else None


@frozen
class Near:
    """The options that say how near to the truth is near enough; `spread` makes options of a command of it.

    Attributes:
        tol_rotation: Tolerance of a direction cosine.
        tol_position: Tolerance of a length.
        decimals: Decimals that the task asks for.
    """

    tol_rotation: Annotated[
        float | None, typer.Option(metavar="X", help="Of a direction cosine; 0.001.", rich_help_panel=TOLERANCE)
    ] = None
    tol_position: Annotated[
        str | None, typer.Option(metavar="LENGTH", help="Of a length, such as 0.5mm.", rich_help_panel=TOLERANCE)
    ] = None
    decimals: Annotated[
        int | None,
        typer.Option(min=1, max=12, metavar="N", help="Decimals the task asks for.", rich_help_panel=TOLERANCE),
    ] = None
