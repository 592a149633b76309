"""What a sweep finds is what a look at every single pose finds."""

from __future__ import annotations

from itertools import product
from math import hypot

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhcli import Robot, forward, load_robot
from dhcli import sweep as ask
from dhcli.errors import RobotError
from dhcli.kinematics.derived import in_floats
from dhcli.kinematics.frames import View
from dhcli.kinematics.sweep import walk
from dhcli.kinematics.sweep.grid import Axis, Grid
from dhcli.kinematics.sweep.highest import SLACK, Highest
from dhcli.kinematics.sweep.plan import plan
from dhcli.kinematics.sweep.ranges import read_over
from dhcli.kinematics.sweep.run import sweep
from dhcli.kinematics.sweep.target import Target, target_of
from dhcli.kinematics.sweep.walk import Walk, slabs, tables_of
from dhcli.kinematics.values import joint_values
from dhcli.notation.tree import ZERO, number

CASES = {
    "planar-2r": ("theta1=-180°..180° n 9", "theta2=-180°..180° n 9"),
    "scara": ("theta1=-90°..90° step 30°", "theta2=0..2 n 5", "d3=0..0.2 n 3"),
    "puma560": ("theta1=-160°..160° n 5", "theta2=-225°..45° n 5", "theta3=-225°..45° n 5", "theta5=0..1 n 3"),
    "stanford": ("theta2=0..90° n 4", "d3=0.1..0.5 n 4"),
    "panda": ("theta2=-1..1 n 4", "theta4=-3..-0.1 n 5", "theta6=0..3 n 3"),
}


def _asked(name: str, point: str = "", start: str | None = None, end: str | None = None) -> tuple[Target, Grid]:
    robot = load_robot(name)
    coordinates = tuple(number(part) for part in map(int, point.split(","))) if point else None
    target = target_of(robot, View.of(robot, start, end, point=coordinates))  # type: ignore[arg-type]
    return target, plan(target, [read_over(robot, text) for text in CASES[name]], {})


def all_rows(target: Target, grid: Grid) -> np.ndarray:
    """Joint values and positions of every pose, in the order of the grid."""
    way = Walk(target, grid)
    return np.concatenate([np.column_stack((slab.rows(tables_of(grid)), way.places(slab).T)) for slab in slabs(grid)])


def _seen(target: Target, q: tuple[float, ...]) -> tuple[float, ...]:
    pose = forward(target.robot, q, start=target.view.start, end=target.view.end)
    return tuple(float(value) for value in pose @ target.coordinates)


@pytest.mark.parametrize(
    ("name", "point", "start", "end"),
    [
        *((name, "", None, None) for name in CASES),
        ("puma560", "1,-2,3", None, None),
        ("puma560", "", "1", "4"),
        ("scara", "0,1,0", "3", "0"),
    ],
)
def test_the_extremes_are_those_of_all_poses_one_by_one(
    monkeypatch: pytest.MonkeyPatch, name: str, point: str, start: str | None, end: str | None
) -> None:
    """The first pose of each extreme, but for rounding, with its joint values and its position."""
    monkeypatch.setattr(walk, "BLOCK", 17)
    target, grid = _asked(name, point, start, end)
    found = sweep(target, grid)
    seen = [_seen(target, q) for q in product(*(axis.floats() for axis in grid.axes))]
    heights = {"farthest": [hypot(*place) for place in seen], "nearest": [-hypot(*place) for place in seen]}
    for k, axis in enumerate("xyz"):
        heights[f"{axis}_min"] = [-place[k] for place in seen]
        heights[f"{axis}_max"] = [place[k] for place in seen]
    for what, values in heights.items():
        extreme = found.sides.get(what) or getattr(found, what)
        first = next(i for i, value in enumerate(values) if value >= max(values) - SLACK * max(1, abs(max(values))))
        assert extreme.index == first, what
        assert extreme.position == pytest.approx(seen[first], abs=1e-12)
        assert target.at(extreme.q) == extreme.position


def test_the_rows_hold_joint_values_and_positions() -> None:
    """Of every pose, in the order of the grid."""
    target, grid = _asked("scara", "0,1,0")
    rows = all_rows(target, grid)
    assert rows.shape == (grid.count, 6)
    for index in (0, 17, grid.count - 1):
        q = tuple(map(in_floats, grid.at(index).values()))
        assert rows[index] == pytest.approx((*q, *_seen(target, q)), abs=1e-14)


def test_every_block_is_handed_on() -> None:
    """Once, in order."""
    target, grid = _asked("planar-2r")
    taken: list[np.ndarray] = []
    sweep(target, grid, taken.append)
    assert np.array_equal(np.concatenate(taken), all_rows(target, grid))


@pytest.mark.parametrize("name", CASES)
@pytest.mark.parametrize("threads", [2, 3, 200])
def test_threads_find_the_same(monkeypatch: pytest.MonkeyPatch, name: str, threads: int) -> None:
    """The same poses of those that are extreme alike, and the same rows in the same order, to the last digit."""
    monkeypatch.setattr(walk, "BLOCK", 7)
    target, grid = _asked(name)
    rows: dict[int, list[np.ndarray]] = {1: [], threads: []}
    counts: list[int] = []
    alone = sweep(target, grid, rows[1].append)
    assert sweep(target, grid, rows[threads].append, threads=threads, tell=counts.append) == alone
    assert sweep(target, grid, threads=threads) == alone
    assert np.array_equal(np.concatenate(rows[threads]), np.concatenate(rows[1]))
    assert counts == sorted(counts)
    assert counts[-1] == grid.count


@pytest.mark.parametrize("threads", [0, -2, 1.5, "2", None, True])
def test_what_is_no_number_of_threads_is_refused(threads: object) -> None:
    """As by `forward_batch`."""
    with pytest.raises(RobotError, match="threads is a number from 1, not"):
        ask(load_robot("planar-2r"), threads=threads)  # type: ignore[arg-type]


def test_exact_angles_give_exact_positions() -> None:
    """The arm stretched along y is at x = 0, not at 4e-17."""
    found = sweep(*_asked("planar-2r"))
    assert found.sides["y_max"].position == (0.0, 0.7, 0.0)
    assert found.box == ((-0.7, 0.7), (-0.7, 0.7), (0.0, 0.0))


@pytest.mark.parametrize("threads", [1, 2])
def test_a_position_beyond_all_floats_is_refused(threads: int) -> None:
    """Not handed on as infinity."""
    robot = load_robot("cartesian")
    target = target_of(robot)
    axes = tuple(Axis(name, ZERO, number(10**300), 3) for name in robot.variables)
    with pytest.raises(RobotError, match="too large"):
        sweep(target, Grid(axes), threads=threads)


heights = st.lists(
    st.one_of(st.floats(-5, 5), st.sampled_from([1.0, 2.0]).flatmap(lambda x: st.floats(x - 2e-9, x + 2e-9))),
    min_size=1,
)


@given(heights, st.integers(1, 7), st.sampled_from([1, -1]), st.integers(1, 5))
def test_the_highest_is_the_first_within_rounding_of_the_maximum(
    values: list[float], block: int, sign: int, late: int
) -> None:
    """However the numbers are cut into blocks, and however many of these are looked at before the first is taken."""
    highest = Highest(sign)
    waiting = []
    for first in range(0, len(values), block):
        waiting.append(highest.records(np.array(values[first : first + block]), first))
        if len(waiting) == late:
            highest.take(waiting.pop(0))
    for records in waiting:
        highest.take(records)
    heights = [sign * value for value in values]
    top = max(heights)
    assert highest.index == next(i for i, v in enumerate(heights) if v >= top - SLACK * max(1, abs(top)))


@pytest.mark.parametrize(
    ("name", "point", "end", "expected"),
    [
        ("puma560", (0, 0, 0), None, "theta1 theta2 theta3"),
        ("puma560", (0, 0, 1), None, "theta1 theta2 theta3 theta4 theta5"),
        ("puma560", (1, 0, 0), None, "theta1 theta2 theta3 theta4 theta5 theta6"),
        ("puma560", (0, 0, 0), "3", "theta1 theta2"),
        ("scara", (0, 0, 0), None, "theta1 theta2 d3"),
        ("planar-2r", (0, 0, 0), "0", ""),
    ],
)
def test_the_joints_that_move_a_point_are_known(
    name: str, point: tuple[int, int, int], end: str | None, expected: str
) -> None:
    """From the formula of its position; a wrist does not move its own centre."""
    robot = load_robot(name)
    x, y, z = map(number, point)
    target = target_of(robot, View.of(robot, None, end, point=(x, y, z)))
    assert target.movers() == set(expected.split())
    q = joint_values(robot, [0.3] * len(robot.variables))
    for name_ in robot.variables:  # moving an idle joint changes nothing, moving another does
        moved = target.at({**q, **joint_values(robot, {name_: 0.7})})
        assert (moved != pytest.approx(target.at(q), abs=1e-12)) == (name_ in target.movers())


def test_a_program_asks_as_the_command_does() -> None:
    """Ranges in a mapping, a list or one text; a joint that stands; a point; every row on the way."""
    robot, blocks = load_robot("scara"), []
    found = ask(robot, {"q1": "0..90° n 3", "d3": "0..0.2 n 2"}, {"q2": "90°"}, point=(0, 0, 0.1), each=blocks.append)
    assert found.grid.count == 6
    assert np.concatenate(blocks).shape == (6, 6)
    assert found == ask(robot, ["q1=0..90° n 3", "d3=0..0.2 n 2"], "0, 90°, 0", point=("0", 0, "100mm"))
    q = {"theta1": found.nearest.q["theta1"], "theta2": "90°", "d3": found.nearest.q["d3"]}
    assert forward(robot, q) @ (0, 0, 0.1) == pytest.approx(found.nearest.position)
    assert ask(robot, "q1=0..90° n 3").grid.count == 3
    with pytest.raises(RobotError, match="90 has no unit"):
        ask(robot, "q1=0°..90")
    for over in (None, 5, ["q1", 3], b"q1"):
        with pytest.raises(RobotError, match=r"over says in text what each joint is swept over, and .* does not"):
            ask(robot, over)  # type: ignore[arg-type]
    with pytest.raises(RobotError, match="a point has three coordinates, not 2"):
        ask(robot, "q1", point=(0, 0))


def test_more_joints_than_an_array_has_axes_are_swept() -> None:
    """Those that stand still have no axis of their own: forty joints, of which three move."""
    rows = [{"alpha": 0, "a": 0.1, "d": 0, "theta": f"q{k}"} for k in range(40)]
    robot = Robot.from_dh(rows, variables=[f"q{k}" for k in range(40)])
    found = ask(robot, {"q0": "0..1 n 3", "q20": "0..1 n 3", "q39": "0..1 n 3"})
    assert found.grid.count == 27
    assert found.farthest.distance == pytest.approx(4.0)
    assert found.nearest.distance < 4.0


def test_a_sweep_shows_itself_in_a_line() -> None:
    """How many poses, and how far they reach."""
    found = ask(load_robot("planar-2r"), {"theta1": "0..90° n 1001", "theta2": "0..180° n 3"})
    assert repr(found) == "<Sweep of planar-2r: 3,003 poses, 0.1 to 0.7 m from frame 0>"
