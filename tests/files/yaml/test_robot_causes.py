"""Robot files with a slip: the cause is told, not what comes of it, and nothing hides anything else."""

from __future__ import annotations

import pytest

from dhcli.errors import FileError
from dhcli.files.yaml.robots import read_robot

ARM = """\
format: 1
title: T
source: S
convention: standard
variables: [theta1, d2, theta3, theta4]
parameters: {a1: 300 mm}
links:
  - {a: a1, alpha: 0, d: 0, theta: theta1}
  - {a: 0, alpha: 0, d: d2, theta: 0}
  - {a: a1, alpha: 90°, d: 0, theta: theta3}
  - {a: a1, alpha: 0, d: 0, theta: theta4}
limits: {theta1: [-160°, 160°], d2: [0, 250 mm], theta4: [-90°, 90°]}
poses: {home: [0, 0.1, 0, 20°]}
"""


def told(*changes: tuple[str, str]) -> list[str]:
    """What is told of the arm with these changes, each with its line."""
    text = ARM
    for old, new in changes:
        assert text.count(old) == 1, old
        text = text.replace(old, new)
    with pytest.raises(FileError) as caught:
        read_robot(text, "arm", "arm")
    return [f"{p.place.line if p.place else 0}: {p.message}" for p in caught.value.problems]


def test_the_arm_itself_is_right() -> None:
    """So that what is told comes of the changes."""
    assert read_robot(ARM, "arm", "arm").pattern == "RPRR"


def test_limits_of_a_joint_that_is_not_there_say_so() -> None:
    """Not that their unit is wrong for the length that the name might be."""
    assert told(("theta4: [-90°", "theta5: [-90°")) == ["12: limits: theta5 is not a joint variable"]


def test_the_wrong_variable_in_a_row_is_told_at_the_row() -> None:
    """And no unit in limits and poses is, for what d2 and theta4 are is not known."""
    assert told(("theta: theta4", "theta: d2")) == ["5: variables: theta4 moves no link", "11: links: d2 is used twice"]


def test_a_slip_in_the_base_hides_nothing() -> None:
    """All problems at once."""
    assert told(("theta: theta4", "theta: d2"), ("poses:", "base: Rot(z, 90)\nlimit: 3\nposes:")) == [
        "5: variables: theta4 moves no link",
        "11: links: d2 is used twice",
        "13: the angle 90 has no unit",
        "14: limit: unknown key",
    ]


def test_a_key_that_stands_twice_hides_nothing() -> None:
    """The first one counts meanwhile."""
    assert told(("poses:", "title: again\nlimit: 3\nposes:"), ("theta4: [-90°", "theta5: [-90°")) == [
        "12: limits: theta5 is not a joint variable",
        "13: title: stands twice, first on line 2",
        "14: limit: unknown key",
    ]


def test_a_cell_that_cannot_be_read_is_told_alone() -> None:
    """Its variable is not said to move nothing."""
    assert told(("theta: theta3", "theta: thta3")) == ["10: thta3 is not a name that is known here"]


def test_without_variables_limits_are_not_said_to_be_of_no_joint() -> None:
    """The rows tell enough."""
    assert not any("limits" in line for line in told(("[theta1, d2, theta3, theta4]", "[]")))


def test_a_cell_that_cannot_be_read_hides_nothing_that_stands_elsewhere() -> None:
    """Variables, limits and poses are looked at all the same; only of its own variable nothing is known."""
    assert told(
        ("theta: theta3", "theta: theta3 + 90"),
        ("d2, theta3, theta4]", "d2, theta3, theta4, theta1]"),
        ("d2: [0, 250 mm]", "d2: [250 mm, 0], theta3: [0, 0.1 m]"),
        ("[0, 0.1, 0, 20°]", "[0, 0.1, 0]"),
    ) == [
        "5: variables: theta1 is used twice",
        "10: theta: the angle 90 has no unit",
        "12: d2: the lower limit is not below the upper one",
        "13: home: 3 values for 5 joints",
    ]


def test_limits_that_stand_the_wrong_way_round_are_shown_the_right_one() -> None:
    """To be copied; of two that are one there is none."""
    for old, hint in (("[250 mm, 0]", "[0 m, 0.25 m]"), ("[0, 0]", "[lowest, highest]")):
        with pytest.raises(FileError) as caught:
            read_robot(ARM.replace("[0, 250 mm]", old), "arm", "arm")
        assert caught.value.problems[0].hint == f"write {hint}"
