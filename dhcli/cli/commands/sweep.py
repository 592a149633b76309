"""`dhcli sweep`: a grid of poses, and what of the space around a robot it reaches."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from typing import TYPE_CHECKING, Annotated

import typer

from dhcli.cli.shell import completing
from dhcli.cli.shell.chosen import Chosen
from dhcli.cli.shell.options import EndPoint, Jobs, workers
from dhcli.cli.shell.written import Digits, Overwrite, output_option
from dhcli.frozen import frozen

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from dhcli.cli.shell.rows import RowDelivery, RowSink
    from dhcli.kinematics.robot import Robot
    from dhcli.kinematics.sweep.density import Density
    from dhcli.kinematics.sweep.grid import Grid
    from dhcli.kinematics.sweep.target import Target
    from dhcli.kinematics.sweep.workspace import Workspace
    from dhcli.render.pictures.picture import Picture


EXAMPLES = """
[bold]Examples[/]

dhcli sweep planar-2r

dhcli sweep scara --over 'q1=-90°..90° step 5°' --over 'd3=0..0.2 n 11'

dhcli sweep puma560 --pose ready --over q2 --over q3 -o reach.csv

dhcli sweep scara --over q1 --over q2 --over d3=0..0.2 --draw reach.svg
"""
_POSES = 4_000_000
"""Poses that take several times as long as the start of a thread."""


@frozen
class Asked:
    """What is swept, and where it goes, as it was typed."""

    over: Annotated[
        list[str] | None,
        typer.Option(
            metavar="RANGE",
            help="Sweep a joint: 'q1=-90°..90° step 5°', 'd3=0..0.2 n 11', 'q1=-90°..90°', or q1 for all that its "
            "limits allow; repeatable. Without it all joints are swept.",
            autocompletion=completing.of_robot("variables"),
        ),
    ] = None
    point: EndPoint = None
    format_: Annotated[
        str | None,
        typer.Option("--format", metavar="NAME", help="Of the summary: table, json or csv.", rich_help_panel="Output"),
    ] = None
    digits: Digits = None
    jobs: Jobs = None
    output: Annotated[
        str | None, output_option("Write all points to a file, joint values and position a row: .csv, .jsonl or .npy.")
    ] = None
    draw: Annotated[
        str | None,
        typer.Option(
            metavar="FILE",
            help="Draw the points from the side and from above, a plane once, .svg .pdf .png .tex, or in space, .html.",
            rich_help_panel="Output",
        ),
    ] = None
    overwrite: Overwrite = False


def sweep(chosen: Chosen, asked: Asked) -> None:
    """Sweep joints over a grid: how far a robot reaches, the box it stays in, and the poses at its sides.

    --q and --pose say where the joints stand that are not swept, at 0 by default.
    """
    from dhcli.cli.shell.delivery import Delivery
    from dhcli.cli.shell.given import robot_of

    delivery = Delivery("sweep", asked.format_, asked.digits)
    delivery.chosen("sweep")
    points = _points(asked)
    if asked.draw is not None:
        from dhcli.cli.shell.pictures import check_picture, write_picture

        check_picture(asked.draw, overwrite=asked.overwrite)
    target, grid = _grid(robot_of(chosen), chosen, asked)

    from dhcli.kinematics.sweep.density import Density  # numpy: not for what is refused before it starts
    from dhcli.kinematics.sweep.run import sweep as go_through

    density = None if asked.draw is None else Density()
    threads = workers(asked.jobs, 1 + grid.count // _POSES)
    with _taking(points, grid, density) as (take, tell):
        result = go_through(target, grid, take, threads=threads, tell=tell)
    delivery.hand_over("sweep", result, result.warnings)
    if asked.draw is not None and density is not None:
        write_picture(_picture(target, grid, density.workspace(target)), asked.draw, overwrite=asked.overwrite)


def _grid(arm: Robot, chosen: Chosen, asked: Asked) -> tuple[Target, Grid]:
    """What is swept, and the grid that it is swept over.

    Raises:
        DhcliError: The point, a range or a value cannot be read, or there are too many poses.
    """
    from dhcli.cli.shell.given import open_scope, point_of, values_of
    from dhcli.errors import Place
    from dhcli.kinematics.frames import View
    from dhcli.kinematics.sweep.plan import plan
    from dhcli.kinematics.sweep.ranges import read_over
    from dhcli.kinematics.sweep.target import target_of

    values = values_of(arm, chosen)
    seen = None if asked.point is None else point_of(asked.point, "--point", open_scope(arm))
    target = target_of(arm, View.of(arm, chosen.from_, chosen.end, point=seen), values)
    overs = [read_over(arm, text, bare=chosen.bare, place=Place("--over")) for text in asked.over or []]
    return target, plan(target, overs, values, Place("--over") if overs else None)


def _picture(target: Target, grid: Grid, workspace: Workspace) -> Picture:
    """The points with the arm among them, joints that are held where they are."""
    from dhcli.kinematics.derived import in_floats
    from dhcli.notation.angle import Angle
    from dhcli.render.pictures.picture import Picture
    from dhcli.scene.choice import best_pose

    _, values = best_pose(target.robot, target.lengths)
    values |= {axis.name: axis.first for axis in grid.held}
    q = {name: value if isinstance(value, Angle) else in_floats(value) for name, value in values.items()}
    return Picture(target.robot, q, parameters=target.lengths, workspace=workspace)


def _points(asked: Asked) -> RowDelivery | None:
    """Where the points go, once it is known that they can; None if nobody wants them."""
    output = asked.output
    if output is None and (asked.draw is not None or not asked.overwrite):
        return None
    from dhcli.cli.shell.rows import RowDelivery
    from dhcli.render.code.rows import FORMATS
    from dhcli.render.endings import format_by_ending

    if output is not None:
        summary = "the summary is on standard output, see --format"
        format_by_ending(output, FORMATS, of=" of points", more=summary)
    delivery = RowDelivery(None, output, asked.overwrite)
    delivery.chosen()
    return delivery


@contextmanager
def _taking(
    points: RowDelivery | None, grid: Grid, density: Density | None
) -> Iterator[tuple[Callable[[NDArray[np.float64]], None] | None, Callable[[int], None]]]:
    """What takes the rows of a grid, a file and a picture if they are wanted; and the bar that shows how far it is."""
    from dhcli.render.text.progress import row_progress

    with ExitStack() as stack:
        sink: RowSink | None = None
        if points is not None:
            from dhcli.render.code.layouts import point_layout

            sink = stack.enter_context(points.open(point_layout(axis.name for axis in grid.axes)))
        bar = stack.enter_context(row_progress(sys.stderr))

        def take(rows: NDArray[np.float64]) -> None:
            if sink is not None:
                sink.write(rows)
            if density is not None:
                density.take(rows)

        yield None if sink is None and density is None else take, lambda done: bar(done, done / grid.count)
