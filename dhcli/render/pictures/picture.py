"""A picture of a robot or a linkage, as an object: it shows itself in a notebook and saves itself by suffix."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import fields, replace
from math import isfinite
from pathlib import Path
from typing import TYPE_CHECKING, Any

from dhcli.errors import DhcliError, RobotError, plural
from dhcli.frozen import FrozenDict
from dhcli.kinematics.robot import Robot
from dhcli.kinematics.sweep.workspace import Workspace
from dhcli.kinematics.values import JointInput, given_parameters, joint_values
from dhcli.mobility.linkage import Linkage
from dhcli.render.endings import PICTURES, format_by_ending
from dhcli.scene.camera import view_given
from dhcli.scene.drawing import Drawing
from dhcli.scene.motion import Path as Rows
from dhcli.scene.staging import posed

if TYPE_CHECKING:
    from dhcli.render.paper import Paper as Letters

LEAST, MOST = 120, 8000
"""The smallest and the largest side of a picture [px]."""


class Picture(Drawing):
    """A drawing as text, as a file, and in a notebook."""

    def svg(self) -> str:
        """The text of an SVG file."""
        from dhcli.render.pictures.svg import svg

        return svg(self.figure(), dark=self.dark, size=self.shown_at)

    def animated(self) -> str:
        """The text of an SVG file that moves by itself.

        Raises:
            DhcliError: It shows no motion, or something else too.
        """
        from dhcli.render.pictures.animated import animated
        from dhcli.scene.motion import moments

        return animated(moments(self.motion()), dark=self.dark, size=self.size)

    def tikz(self) -> str:
        """The text of a TikZ figure."""
        from dhcli.render.pictures.tikz import tikz

        return tikz(self.figure(), dark=self.dark, size=self.shown_at)

    def pdf(self) -> bytes:
        """The bytes of a PDF file."""
        from dhcli.render.pictures.pdf import pdf

        return pdf(self.figure(), dark=self.dark, size=self.shown_at)

    def png(self) -> bytes:
        """The bytes of a PNG file; needs the extra `[draw]`."""
        from dhcli.render.pictures.png import png

        return png(self.figure(), dark=self.dark, size=self.shown_at)

    def page(self) -> str:
        """The text of an HTML page that turns, moves and computes by itself."""
        from dhcli.render.pictures.page import page

        return page(self)

    def terminal(self, paper: Letters | None = None, columns: int | None = None, rows: int | None = None) -> str:
        """The picture in letters; no line is wider than the paper.

        Args:
            paper: What it is written on.
            columns: Its width in letters; that of the paper by default.
            rows: Its height in letters.
        """
        from dhcli.render.paper import Paper as Letters
        from dhcli.render.pictures.terminal import LEAST as FEWEST
        from dhcli.render.pictures.terminal import sheet_of, terminal

        if self.workspace is not None:
            raise DhcliError("a workspace is no picture in letters", "write .svg, .pdf, .png, .tex or .html")
        if self.moves:
            raise DhcliError(
                "a film strip is no picture in letters", "write .svg, .pdf, .png, .tex, or .html to play it"
            )
        if self.more:
            each = (
                replace(self, more=()),
                *(Picture(*(getattr(one, part.name) for part in fields(one))) for one in self.more),
            )
            return "\n".join(one.terminal(paper, columns, rows) for one in each)
        paper = paper or Letters()
        columns = columns or min(paper.width, 120)
        rows = rows or max(FEWEST[1], min(44, round(columns * 0.4)))
        if columns < FEWEST[0] or rows < FEWEST[1]:
            raise DhcliError(f"{columns} x {rows} letters are too few for a picture", "at least 16 columns and 8 rows")
        figure = replace(self, table=False).figure(sheet_of(columns, rows, paper))
        return terminal(figure, paper)

    def save(self, path: str | Path, *, overwrite: bool = True) -> None:
        """Write a file; its suffix says in which format.

        Args:
            path: The file.
            overwrite: Whether one of that name may be replaced.

        Raises:
            UnknownNameError: The suffix stands for no format.
            FileError: The file cannot be written.
        """
        from dhcli.storage.atomic import write_whole

        write_whole(path, self.rendered(format_of(path)), overwrite=overwrite)

    def rendered(self, name: str) -> str | bytes:
        """The content of a file in a format."""
        makers: dict[str, Callable[[], str | bytes]] = {
            "svg": self.svg, "tikz": self.tikz, "png": self.png, "pdf": self.pdf, "page": self.page,
            "terminal": self.terminal,
        }  # fmt: skip
        return makers[name]()

    def _repr_svg_(self) -> str:
        return self.svg()

    def _repr_html_(self) -> str:
        """The SVG inside a box that shrinks with the window."""
        return f'<div style="max-width:100%;overflow:auto">{self.svg()}</div>'


def draw(  # noqa: PLR0913  a figure has as many sides
    what: Robot | Linkage,
    q: JointInput = None,
    *,
    pose: str | None = None,
    view: str | tuple[float, float] | None = None,
    size: tuple[int, int] | None = None,
    dark: bool = False,
    worksheet: bool = False,
    table: bool = False,
    parameters: Mapping[str, Any] | None = None,
    to: JointInput = None,
    path: Rows = (),
    beside: Robot | None = None,
    workspace: Workspace | None = None,
) -> Picture:
    """A picture of a robot at joint values, or of a linkage in its assembled position.

    Args:
        what: The robot or the linkage.
        q: Joint values as `forward` takes them; by default the pose that shows the robot best.
        pose: The name of a pose instead.
        view: `iso`, `front`, `side`, `top`, `"30,20"`, or azimuth and elevation [deg]; the best view by default.
        size: Width and height [px].
        dark: Whether it is light on dark; otherwise an SVG follows the reader's colour scheme.
        worksheet: Whether the frames are left to the student: bodies, axes and numbers of the joints only.
        table: Whether the DH table stands beside.
        parameters: Lengths and angles to use instead of the robot's own.
        to: Joint values or the name of a pose to which it moves: a film strip, and a page that plays it.
        path: Joint values of each moment of a motion instead, radians and metres, shape (N, n).
        beside: Another table of the same arm, drawn over it; the first frame that differs is marked.
        workspace: The points of a sweep, as `dhcli.kinematics.sweep.density.Density` counts them.

    Returns:
        The picture: shown by a notebook, or saved with `save("arm.svg")`; also .tex, .png, .pdf, .html and .txt.

    Raises:
        RobotError: A joint has no value or there are too many, or there is no such pose.
        ViewError: There is no such view.
    """
    if not isinstance(what, Robot | Linkage):
        hint = "load_robot loads a robot" if not isinstance(what, str) else f"load_robot({what!r}) loads one"
        raise RobotError(f"a Robot or a Linkage is wanted, not {what!r:.60}", hint)
    if size is not None:
        check_size(size)
    given = given_parameters(what, parameters) if parameters is not None and isinstance(what, Robot) else None
    seen = None if view is None else view_given(view)
    if isinstance(what, Robot):
        _check_poses(what, q, pose, to)
    moving: dict[str, Any] = {"to": _own(to), "path": _rows(what, path)}
    other: dict[str, Any] = {"beside": beside, "workspace": workspace}
    return Picture(what, _own(q), pose, seen, size, dark, worksheet, table, given, **moving, **other)


def _check_poses(robot: Robot, q: JointInput, pose: str | None, to: JointInput) -> None:
    """Refuse joint values that a robot does not have, before a notebook shows the picture."""
    if q is not None or pose is not None:
        posed(robot, q, pose, {}, "rad")
    if to is not None:
        joint_values(robot, to)


def _own(q: JointInput) -> JointInput:
    """Joint values as the picture keeps them: it is drawn when it is shown, and a program goes on with its array."""
    if q is None or isinstance(q, str):
        return q
    return FrozenDict(q) if isinstance(q, Mapping) else tuple(q)


def _rows(what: Robot | Linkage, path: Rows) -> Rows:
    """The rows of a path in plain numbers, one for each joint.

    Raises:
        RobotError: A row has more or fewer, or what moves is no robot.
    """
    try:
        rows = tuple(tuple(map(float, row)) for row in path)
    except (TypeError, ValueError, OverflowError):
        raise RobotError(f"a path is rows of joint values in numbers, not {path!r:.60}") from None
    count = len(what.variables) if isinstance(what, Robot) else 0
    for number, row in enumerate(rows):
        if len(row) != count or not all(map(isfinite, row)):
            has = f"row {number} of the path has {plural(len(row), 'number')}"
            raise RobotError(f"{has}; wanted: {count}, each finite")
    return rows


def check_size(size: tuple[int, int]) -> None:
    """Refuse sizes that are no picture.

    Raises:
        DhcliError: A side is too short or too long.
    """
    try:
        width, height = map(int, size)
    except (TypeError, ValueError, OverflowError):
        raise DhcliError(f"a size is a width and a height, not {size!r:.60}", "size=(800, 600)") from None
    if not (LEAST <= width <= MOST and LEAST <= height <= MOST):
        raise DhcliError(f"a picture of {width} x {height} pixels is not drawn", f"from {LEAST} to {MOST} each")


def format_of(path: str | Path) -> str:
    """The format that the suffix of a file stands for.

    Raises:
        UnknownNameError: It stands for none.
    """
    return format_by_ending(path, PICTURES, more="")
