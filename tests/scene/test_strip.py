"""A motion as a film strip."""

from __future__ import annotations

import pytest

from dhcli import forward, load_robot
from dhcli.kinematics.values import joint_values
from dhcli.scene.camera import Camera
from dhcli.scene.choice import EDGE_ON
from dhcli.scene.motion import MOST_SCENES, between, moments, motion_of
from dhcli.scene.panels import CELL, MOMENTS, strip_figure
from dhcli.scene.staging import ArmAt


@pytest.mark.parametrize(
    ("name", "start", "end"),
    [("scara", "zero", "pick"), ("puma560", "ready", "nominal"), ("planar-2r", "zero", "fold")],
)
def test_a_strip_has_its_moments_side_by_side_each_in_its_own_cell(name: str, start: str, end: str) -> None:
    """The base stands still in all of them; the way grows from picture to picture."""
    figure = strip_figure(motion_of(ArmAt(load_robot(name), pose=start), to=end))
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


def test_a_strip_of_rows_begins_at_the_first_and_ends_at_the_last() -> None:
    """The way of the end goes through the place of every row, also of those that are not drawn."""
    robot = load_robot("planar-2r")
    rows = [(0.01 * k, 0.5 - 0.002 * k) for k in range(300)]
    motion = motion_of(ArmAt(robot), rows=rows)
    assert (motion.steps[0], motion.steps[-1], len(motion.places)) == (0, 299, 300)
    assert len(motion.scenes) == MOST_SCENES + 1
    for row, place in zip(rows, motion.places, strict=True):
        assert place == pytest.approx(forward(robot, row).position, abs=1e-9)
    for step, scene in zip(motion.steps, motion.scenes, strict=True):
        assert scene.states[-1].origin == pytest.approx(motion.places[step], abs=1e-12)
    assert strip_figure(motion).caption.endswith("to 300 rows")


@pytest.mark.parametrize("count", [1, 2, 3])
def test_a_path_of_few_rows_has_no_more_pictures_than_rows(count: int) -> None:
    """One row is one picture."""
    figure = strip_figure(motion_of(ArmAt(load_robot("planar-2r")), rows=[(0.1 * k, 0.2) for k in range(count)]))
    assert figure.width == CELL * count


def test_what_stands_still_does_so_in_every_moment_of_an_animation() -> None:
    """The ground of a spatial arm is the same area in all of them."""
    figures = moments(motion_of(ArmAt(load_robot("stanford"), pose="zero"), to="grasp"))
    plates = {shape.points for figure in figures for shape in figure.shapes if shape.look == "plate"}
    assert len(plates) == 1
    assert len(figures) == 25


@pytest.mark.parametrize(("name", "start", "end"), [("scara", "zero", "pick"), ("panda", "ready", "square")])
def test_each_moment_of_a_strip_has_its_joint_values_below(name: str, start: str, end: str) -> None:
    """In joint order, those of both poses at the ends, and never wider than its cell."""
    robot = load_robot(name)
    figure = strip_figure(motion_of(ArmAt(robot, pose=start), to=end))
    told = [text for text in figure.texts if text.at[1] > CELL and text.look == "number"]
    assert len(told) == MOMENTS
    for text, pose in ((told[0], start), (told[-1], end)):
        typed = "".join(run.text for run in text.words)
        assert joint_values(robot, typed) == dict(zip(robot.variables, robot.poses[pose], strict=True))
    assert all(0.53 * text.size * sum(len(run.text) for run in text.words) <= CELL for text in told)


@pytest.mark.parametrize(("name", "start", "end"), [("panda", "ready", "square"), ("puma560", "ready", "nominal")])
def test_a_hand_is_seen_as_a_fork_and_opens_one_way_in_all_moments(name: str, start: str, end: str) -> None:
    """Edge-on it would pass for a stick; and it may not turn from picture to picture but with its joint."""
    motion = motion_of(ArmAt(load_robot(name), pose=start), to=end)
    first = motion.scenes[0]
    assert first.hand is not None
    camera = Camera.at(*motion.view)
    state = first.hand.wrist.state
    (ax, ay), (bx, by) = (
        camera.flat_direction(first.direction(state, side)) for side in (first.hand.forward, first.hand.across)
    )
    assert abs(ax * by - ay * bx) > EDGE_ON
    assert {scene.hand.across for scene in motion.scenes if scene.hand} == {first.hand.across}
