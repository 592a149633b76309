"""A value of any length is answered at once, whatever it looks like for most of its way."""

from __future__ import annotations

import pytest

from dhcli.errors import FileError, Problem
from dhcli.files.yaml.exercises import read_exercise
from dhcli.files.yaml.linkages import read_linkage
from dhcli.files.yaml.robots import read_robot
from tests.row_by_row import row_by_row

MANY = 30_000
ROBOT = """\
format: 1
title: An arm
source: a test
convention: standard
variables: [q1]
links: [{a: 1, alpha: 0, d: 0, theta: q1}]
limits: {q1: "LONG"}
"""
LINKAGE = """\
format: 1
title: Two links
source: a test
space: spatial
"""
EXERCISE = """\
format: 1
title: An arm
source: a test
task: a test
robot: "LONG"
parts: [{id: a, ask: link 1}]
"""


def problems(read: object, text: str) -> list[Problem]:
    """What is wrong in a file."""
    with pytest.raises(FileError) as caught:
        read(text, "x.yaml", "x")  # type: ignore[operator]
    return list(caught.value.problems)


@row_by_row("axis", ["A" * MANY + ">>>", "A" + " " * MANY + ">>", "A " + "-" * MANY])
def test_a_long_direction_is_told(axis: str) -> None:
    """It is none."""
    text = f'{LINKAGE}joints: [{{type: R, links: [ground, a], point: [0, 0, 0], axis: "{axis}"}}]\n'
    assert any("is no direction" in problem.message for problem in problems(read_linkage, text))


@row_by_row("joint", ["ground" + " " * MANY + "R", "ground" + "-" * MANY + "R"])
def test_a_long_joint_is_told(joint: str) -> None:
    """In one line."""
    found = problems(read_linkage, f'{LINKAGE}joints: ["{joint}"]\n')
    assert any("is not read as a joint" in problem.message for problem in found)


@row_by_row("limits", ["1" + " " * MANY + "x", "1" + "." * MANY, "1 to " * (MANY // 5)])
def test_long_limits_are_told(limits: str) -> None:
    """They are no list of two."""
    found = problems(read_robot, ROBOT.replace("LONG", limits))
    assert any("should be a list" in problem.message for problem in found)


@row_by_row("name", ["a" * 300 + ".yaml", "a/" * MANY + "b.yaml"])
def test_a_path_longer_than_any_file_is_told(name: str) -> None:
    """As one that is not there."""
    found = problems(read_exercise, EXERCISE.replace("LONG", name))
    assert any(problem.message.startswith("robot: ") for problem in found)
