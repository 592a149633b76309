"""The workspace of a robot on paper."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from dhcli import draw, load_robot
from dhcli.errors import DhcliError
from dhcli.kinematics.sweep.density import CELLS, SAMPLE, Density
from dhcli.kinematics.sweep.plan import plan
from dhcli.kinematics.sweep.ranges import read_over
from dhcli.kinematics.sweep.result import Sweep
from dhcli.kinematics.sweep.run import sweep
from dhcli.kinematics.sweep.target import target_of
from dhcli.kinematics.sweep.workspace import Workspace
from dhcli.scene.camera import VIEWS
from dhcli.scene.workspace import views_of

Place = tuple[float, ...]


def _swept(name: str, *overs: str) -> tuple[list[Place], Sweep, Workspace]:
    """Every place of a grid, what a sweep finds, and what was counted on the way."""
    robot, density = load_robot(name), Density()
    target = target_of(robot)
    every: list[Place] = []

    def take(rows: np.ndarray[Any, np.dtype[np.float64]]) -> None:
        every.extend(map(tuple, rows[:, -3:].tolist()))
        density.take(rows)

    found = sweep(target, plan(target, [read_over(robot, text) for text in overs]), take)
    return every, found, density.workspace(target)


def test_every_point_is_counted_in_the_cell_where_it_is() -> None:
    """Against a count of all points in plain Python, from both sides."""
    every, found, seen = _swept("scara", "theta1=-90°..90° n 31", "theta2 n 37", "d3=0..0.2 n 5")
    size = 2 * seen.half / CELLS
    for counts, right, up in ((seen.side, 0, 2), (seen.top, 0, 1), (seen.front, 1, 2)):
        known: dict[tuple[int, int], int] = {}
        for place in every:
            cell = int((place[up] + seen.half) / size), int((place[right] + seen.half) / size)
            known[cell] = known.get(cell, 0) + 1
        assert {(j, i): count for j, row in enumerate(counts) for i, count in enumerate(row) if count} == known
    assert seen.count == found.grid.count
    assert all(abs(x) < seen.half for side in found.box for x in side)


def test_a_square_grows_around_its_middle_as_points_come_from_farther_away() -> None:
    """Cells of the larger square hold what lay in four of the smaller."""
    density = Density()
    points = [(0.1 * 3.0**k, -0.07 * 3.0**k, 0.02) for k in range(8)]
    for point in points:
        density.take(np.array([point]))
    seen = density.workspace(target_of(load_robot("planar-2r")))
    size = 2 * seen.half / CELLS
    assert seen.half > 0.1 * 3.0**7
    for x, y, _ in points:
        assert seen.top[math.floor((y + seen.half) / size)][math.floor((x + seen.half) / size)]
    assert sum(map(sum, seen.top)) == sum(map(sum, seen.side)) == sum(map(sum, seen.front)) == 8


def test_the_points_kept_are_spread_over_the_whole_grid() -> None:
    """At least half as many as may be, each one of those of the grid."""
    every, _, seen = _swept("planar-2r", "theta1=-180°..180° n 181", "theta2=-180°..180° n 61")
    assert SAMPLE / 2 <= len(seen.sample) <= SAMPLE
    assert set(seen.sample) <= set(every)
    assert {(x > 0, y > 0) for x, y, _ in seen.sample} == {(a, b) for a in (True, False) for b in (True, False)}


@pytest.mark.parametrize(
    ("name", "overs", "views"),
    [
        ("puma560", ("theta1 n 7", "theta2 n 7", "theta3 n 7"), ["side", "top"]),
        ("puma560", ("theta1=80°..110° n 5", "theta2=-90°..60° n 9", "theta3=-90°..0° n 5"), ["front", "top"]),
        ("planar-2r", (), ["top"]),
        ("puma560", ("theta2", "theta3"), ["side"]),
        ("puma560", ("theta1=90°..91° n 2", "theta2", "theta3"), ["front"]),
        ("cartesian", ("d1=0..1 n 4",), ["side"]),
    ],
)
def test_points_are_seen_from_where_they_go_farthest(name: str, overs: tuple[str, ...], views: list[str]) -> None:
    """From above and a side, or, where they are in a plane or a line, from the one side that shows all of it."""
    _, _, seen = _swept(name, *overs)
    assert [view.name for view in views_of(seen)] == views
    figure = draw(load_robot(name), workspace=seen).figure()
    said = ["".join(run.text for run in text.words) for text in figure.texts if text.look == "caption"]
    assert [view for view in VIEWS if any(line.startswith(f"{view}:") for line in said)] == sorted(views)


def test_extents_are_those_of_the_points_to_a_cell() -> None:
    """Along each axis."""
    every, _, seen = _swept("puma560", "theta1 n 7", "theta2 n 7", "theta3 n 7")
    cell = 2 * seen.half / CELLS
    for extent, places in zip(seen.extents, zip(*every, strict=True), strict=True):
        assert 0 <= extent - (max(places) - min(places)) <= 2 * cell


def test_a_workspace_is_drawn_with_the_arm_in_it() -> None:
    """A cell stands where its points are; more poses, a darker shade."""
    _, _, seen = _swept("planar-2r", "theta1=-180°..180° n 181", "theta2=-180°..180° n 181")
    picture = draw(load_robot("planar-2r"), workspace=seen)
    figure = picture.figure()
    cells = [shape for shape in figure.shapes if shape.look.startswith("density")]
    assert len({shape.look for shape in cells}) == 5
    assert sum(shape.look == "cap" for shape in figure.shapes) == 2  # of the drums, from above
    xs, ys = ([point[i] for shape in cells for point in shape.points] for i in (0, 1))
    assert max(xs) - min(xs) == pytest.approx(max(ys) - min(ys), rel=0.02)  # a disc
    assert "32,761 poses of frame 2, seen from frame 0" in figure.caption
    assert picture.svg() == draw(load_robot("planar-2r"), workspace=seen).svg()
    assert len(picture.svg().encode()) < 100_000
    with pytest.raises(DhcliError, match="no picture in letters"):
        picture.terminal()


def test_a_page_knows_the_sample_of_a_workspace() -> None:
    """As far as it is seen from the base."""
    _, _, seen = _swept("planar-2r", "theta1=-180°..180° n 25", "theta2=-180°..180° n 25")
    assert '"cloud":[[' in draw(load_robot("planar-2r"), workspace=seen).page()
    robot, density = load_robot("puma560"), Density()
    from dhcli.kinematics.frames import View

    target = target_of(robot, View.of(robot, 1, 6))
    sweep(target, plan(target, [read_over(robot, "theta2 n 5")]), density.take)
    with pytest.raises(DhcliError, match="not from frame 1"):
        draw(robot, workspace=density.workspace(target)).page()
    assert "density" in draw(robot, workspace=density.workspace(target)).svg()


def test_cells_are_as_small_as_their_own_view_has_them_full() -> None:
    """A slide fills the side with fewer poses than two turns take above, where holes would look out of reach."""
    _, _, seen = _swept("scara", "theta1=-130°..130° n 73", "theta2=-150°..150° n 73", "d3=0..0.18 n 73")
    figure = draw(load_robot("scara"), workspace=seen).figure()
    cells = [shape.points for shape in figure.shapes if shape.look.startswith("density")]
    side, top = (
        {round(points[0][1] - points[2][1]) for points in cells if (points[0][0] > figure.width / 2) == is_right}
        for is_right in (False, True)
    )
    assert len(side) == len(top) == 1
    assert max(top) == 2 * max(side)
