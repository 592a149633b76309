"""What is to be drawn and how, and the figure that comes of it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING

from dhcli.errors import DhcliError
from dhcli.frozen import frozen
from dhcli.kinematics.robot import Robot, Value
from dhcli.kinematics.sweep.workspace import Workspace
from dhcli.kinematics.values import JointInput
from dhcli.mobility.linkage import Linkage
from dhcli.scene.beside import beside_figure
from dhcli.scene.linkages import linkage_figure
from dhcli.scene.motion import Motion, Path, motion_of
from dhcli.scene.panels import PANEL, on_one_sheet, strip_figure
from dhcli.scene.shapes import Figure
from dhcli.scene.staging import HEIGHT, MARGIN, WIDTH, ArmAt, Paper, figure_of
from dhcli.scene.table import with_table
from dhcli.scene.traced import Traced
from dhcli.scene.workspace import workspace_figure

if TYPE_CHECKING:
    from dhcli.notation.quantity import Bare


@frozen
class Drawing:
    """What is drawn, and how.

    Attributes:
        what: A robot or a linkage.
        q: Joint values; None takes `pose`, or the pose that shows the robot best.
        pose: The name of a pose.
        view: Azimuth and elevation [deg]; None for the best view.
        size: Width and height [px].
        dark: Whether it is light on dark; otherwise an SVG follows the reader's colour scheme.
        worksheet: Whether the frames are left to the student.
        table: Whether the DH table stands beside.
        parameters: Lengths and angles instead of the robot's own.
        bare: What a number without a unit means for a joint that turns.
        to: Joint values or the name of a pose to which the robot moves: then the picture is a film strip.
        path: Joint values of each moment of a motion instead: a film strip of five of them.
        workspace: The points that a sweep came by: then the picture is these, from the side and from above.
        more: Further drawings on the same sheet.
        beside: Another table of the same arm, or frames, drawn over it; the first frame that differs is marked.
    """

    what: Robot | Linkage
    q: JointInput = None
    pose: str | None = None
    view: tuple[float, float] | None = None
    size: tuple[int, int] | None = None
    dark: bool = False
    worksheet: bool = False
    table: bool = False
    parameters: Mapping[str, Value] | None = None
    bare: Bare = "rad"
    to: JointInput = None
    beside: Robot | Traced | None = None
    path: Path = ()
    workspace: Workspace | None = None
    more: tuple[Drawing, ...] = ()

    def figure(self, paper: Paper | None = None) -> Figure:
        """The finished drawing on a paper, by default one of the shape that the size asks for."""
        if self.more:
            panel = paper or Paper(*PANEL, margin=MARGIN * 0.8)
            return on_one_sheet([one.figure(panel) for one in (replace(self, more=()), *self.more)])
        paper = paper or self._paper()
        if isinstance(self.what, Linkage):
            if self.q is not None or self.pose is not None or self.table or self.moves or self.beside:
                raise DhcliError(f"{self.what.name or 'it'} is a linkage: it has no joint values, poses or DH table")
            return linkage_figure(self.what, view=self.view, paper=paper, worksheet=self.worksheet)
        if self.moves:
            return strip_figure(self.motion())
        arm = self._arm(self.what)
        if self.beside is not None:
            if self.table or self.worksheet:
                message = "two tables over each other leave no room for more"
                raise DhcliError(message, "leave out the table or the worksheet")
            return beside_figure(arm, self.beside, paper)
        staged = arm.staged()
        if self.workspace is not None:
            return workspace_figure(staged, self.workspace)
        drawn = figure_of(staged, paper, worksheet=self.worksheet)
        return with_table(drawn, self.what) if self.table else drawn

    def _arm(self, robot: Robot) -> ArmAt:
        return ArmAt(robot, self.q, self.pose, self.view, self.parameters, self.bare)

    @property
    def moves(self) -> bool:
        """Whether it shows a motion."""
        return self.to is not None or len(self.path) > 0

    def motion(self) -> Motion:
        """The motion that it shows.

        Raises:
            DhcliError: Nothing moves, or something else is to stand in the picture too.
        """
        if not self.moves or not isinstance(self.what, Robot):
            raise DhcliError("nothing moves in this picture", "to=POSE or path=ROWS say where to; --to or --rows")
        if self.table or self.worksheet or self.beside is not None:
            raise DhcliError("a film strip has no frames and no table", "leave --to out, or the other")
        if len(self.path) and (self.to is not None or self.q is not None or self.pose is not None):
            raise DhcliError("the rows say where all joints are", "leave --q, --pose and --to out")
        return motion_of(self._arm(self.what), self.to, self.path)

    @property
    def shown_at(self) -> tuple[int, int] | None:
        """The size asked for, where the figure has that shape: one with a table beside has its own."""
        return None if self.table or self.more or self.moves or self.workspace else self.size

    def _paper(self) -> Paper:
        if self.size is None:
            return Paper()
        wide, high = self.size
        shrink = WIDTH / wide
        return Paper(WIDTH, max(high * shrink, 0.45 * HEIGHT)) if wide >= high else Paper(HEIGHT * wide / high, HEIGHT)
