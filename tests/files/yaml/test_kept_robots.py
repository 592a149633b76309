"""Robots that were read from files are kept for as long as their files say the same."""

from __future__ import annotations

from pathlib import Path

import pytest

from dhcli import forward
from dhcli.errors import FileError
from dhcli.files.reading import LIMIT
from dhcli.files.yaml.robots import load_robot
from tests.lint.linting import ONE_JOINT

URDF = """<robot name="arm"><link name="a"/><link name="b"/>
<joint name="j" type="continuous"><parent link="a"/><child link="b"/><axis xyz="0 0 1"/></joint></robot>
"""


def test_a_robot_is_the_same_until_its_file_says_something_else(tmp_path: Path) -> None:
    """Nothing that was worked out for the old one is told of the new one, nor the other way round."""
    file = tmp_path / "arm.yaml"
    reached = []
    for length in ("0.4", "0.9", "0.4"):
        file.write_text(ONE_JOINT.replace("0.4", length), encoding="utf-8")
        robot = load_robot(file)
        assert load_robot(file) is robot
        reached.append(forward(robot, [0]).rows[0][3])
    assert reached == [0.4, 0.9, 0.4]


def test_files_that_say_the_same_are_robots_of_their_own(tmp_path: Path) -> None:
    """Each has its path and its name, and a robot from a file that is broken by now is not handed out."""
    one, other = tmp_path / "one.yaml", tmp_path / "more" / "other.yaml"
    other.parent.mkdir()
    for file in (one, other):
        file.write_text(ONE_JOINT, encoding="utf-8")
    assert [(robot.name, robot.path) for robot in map(load_robot, (one, other))] == [("one", one), ("other", other)]
    one.write_text("format: 1", encoding="utf-8")
    with pytest.raises(FileError, match="convention"):
        load_robot(one)


def test_a_large_file_is_read_again(tmp_path: Path) -> None:
    """Its text would be kept too, megabytes of it; and how a URDF is read counts where it is kept."""
    small, large = tmp_path / "small.urdf", tmp_path / "large.urdf"
    small.write_text(URDF, encoding="utf-8")
    large.write_text(f"{URDF}<!--{'-'.join('x' * LIMIT)}-->", encoding="utf-8")
    assert load_robot(small) is load_robot(small)
    assert load_robot(small, base="a") is not load_robot(small, as_typed=True)
    assert load_robot(large) is not load_robot(large)
    assert load_robot(large) == load_robot(large)
