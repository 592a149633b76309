"""A motion as a film strip."""

from __future__ import annotations

import pytest

from dhcli import forward, load_robot
from dhcli.kinematics.values import joint_values
from dhcli.scene.strip import CELL, MOMENTS, between, strip_figure


@pytest.mark.parametrize(
    ("name", "start", "end"),
    [("scara", "zero", "pick"), ("puma560", "ready", "nominal"), ("planar-2r", "zero", "fold")],
)
def test_a_strip_has_its_moments_side_by_side_each_in_its_own_cell(name: str, start: str, end: str) -> None:
    """The base stands still in all of them; the way grows from picture to picture."""
    figure = strip_figure(load_robot(name), (None, start), end)
    assert figure.caption.endswith(f"pose {start} to pose {end}")
    assert figure.width == CELL * MOMENTS
    for shape in figure.shapes:
        cells = {int(x // CELL) for x, _ in shape.points if x % CELL}
        assert len(cells) <= 1
    assert all(0 <= x <= figure.width and 0 <= y <= figure.height for s in figure.shapes for x, y in s.points)
    ways = [shape for shape in figure.shapes if shape.look == "trace"]
    assert [len(way.points) for way in ways] == [7, 13, 19, 25]


def test_joints_go_evenly_and_end_exactly_at_both_ends() -> None:
    """Half of the way is half of each joint's."""
    robot = load_robot("scara")
    start, end = joint_values(robot, "0, 90°, 0"), joint_values(robot, "30°, 45°, 0.1")
    assert between(start, end, 0.0) == start
    assert between(start, end, 1.0) == end
    middle = forward(robot, between(start, end, 0.5))  # type: ignore[arg-type]
    expected = forward(robot, "15°, 67.5°, 0.05")
    assert middle.position == pytest.approx(expected.position, abs=1e-9)
