"""Robots made in Python, copied, saved and found."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from dhcli import DhcliError, Robot, forward, list_robots, load_robot, save_robot
from dhcli.files.yaml.robots import read_robot

PLANAR = [("a1", 0, 0, "theta1"), {"a": 0.3, "alpha": "0°", "theta": "theta2"}]


def test_a_robot_made_of_rows_is_the_one_of_the_file() -> None:
    """Tuples and mappings, numbers and letters."""
    robot = Robot.from_dh(PLANAR, variables=["theta1", "theta2"], parameters={"a1": 0.4})
    assert np.allclose(forward(robot, [0.3, 0.5]).matrix, forward(load_robot("planar-2r"), [0.3, 0.5]).matrix)


def test_modified_rows_take_radians_and_units() -> None:
    """The same row twice."""
    rows = [(0, np.pi / 2, "300 mm", "theta1 - 90°")]
    text = [(0, "90°", 0.3, "theta1 - 90°")]
    found = [Robot.from_dh(r, variables=["theta1"], convention="modified") for r in (rows, text)]
    assert np.allclose(forward(found[0], [0.2]).matrix, forward(found[1], [0.2]).matrix, atol=1e-15)


def test_a_copy_has_another_tool_and_other_lengths() -> None:
    """The robot itself stays."""
    robot = load_robot("planar-2r")
    longer = robot.copy(tool="Trans(0.1, 0, 0)", parameters={"a1": "500 mm"}, name="longer")
    assert forward(longer, [0, 0], end="tool").position == pytest.approx((0.9, 0, 0))
    assert (robot.tool, longer.name) == ((), "longer")
    assert longer.copy(tool="").tool == ()


@pytest.mark.parametrize("name", ["x.yaml", "x.urdf"])
def test_what_is_saved_is_loaded(name: str, tmp_path: Path) -> None:
    """And not over a file that stands there."""
    path = tmp_path / name
    robot = load_robot("stanford")
    save_robot(robot, path)
    q = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6]
    assert np.allclose(forward(load_robot(path), q).matrix, forward(robot, q).matrix, atol=1e-14)
    with pytest.raises(DhcliError, match=r"stands|exists"):
        save_robot(robot, path)


def test_the_library_is_listed_and_its_own_robot_found_behind_one_of_the_same_name(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """`builtin:` means what dhcli brings along."""
    (tmp_path / "robots").mkdir()
    save_robot(load_robot("planar-2r"), tmp_path / "robots" / "puma560.yaml")
    monkeypatch.chdir(tmp_path)
    assert "puma560" in list_robots()
    assert len(load_robot("puma560").variables) == 2
    assert len(load_robot("builtin:puma560").variables) == 6
    with pytest.raises(DhcliError, match="there is no robot"):
        load_robot("builtin:nothing")


def test_keys_that_begin_with_x_are_the_authors_own() -> None:
    """Others are not."""
    head = "format: 1\ntitle: t\nsource: s\nconvention: product\nvariables: [q1]\nlinks: ['Rot(z, q1)']\n"
    assert read_robot(f"{head}x-colour: red\nx-more: {{a: [1]}}\n", "x", "x").variables == ("q1",)
    with pytest.raises(DhcliError, match="colour: unknown key"):
        read_robot(f"{head}colour: red\n", "x", "x")


@pytest.mark.parametrize(
    ("rows", "said"),
    [
        ([(0, 0, 0)], "3 cells, not four"),
        ([{"a": 0, "alfa": 0}], "did you mean alpha"),
        ([(0, "90", 0, "theta1")], "has no unit"),
        ([("b", 0, 0, "theta1")], "b"),
    ],
)
def test_rows_that_are_none_are_refused(rows: list[object], said: str) -> None:
    """With the row."""
    with pytest.raises(DhcliError) as caught:
        Robot.from_dh(rows, variables=["theta1"])  # type: ignore[arg-type]
    assert said in str(caught.value)
