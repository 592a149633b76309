"""Rules for robots: each is broken once, by a file that is clean but for that."""

from __future__ import annotations

from pathlib import Path

import pytest

from dhcli.files.yaml.robots import load_robot
from dhcli.lint import robots
from tests.lint.linting import Broken, assert_told, cases, findings

CLEAN = """\
format: 1
title: An arm
source: a test
notes: Two links and a slide.
convention: standard
variables: [theta1, theta2, d3]
parameters: {a1: 0.4 m, a2: 300 mm}
links:
  - {a: a1, alpha: 0, d: 0, theta: theta1}
  - {a: a2, alpha: 180°, d: 0, theta: theta2}
  - {a: 0, alpha: 0, d: d3, theta: 0}
limits:
  theta1: [-160°, 160°]
  d3: [0, 0.2 m]
poses:
  up: [90°, 0, 100 mm]
"""

WRITE = "write what belongs there"


@cases(
    Broken("title: An arm", "title: TODO", "2:8", "title: still says 'TODO'", WRITE),
    Broken("source: a test", "source: write here", "3:9", "source: still says 'write here'", WRITE),
    Broken("Two links and a slide.", "TBD", "4:8", "notes: still says 'TBD'", WRITE),
)
def test_a_text_that_is_not_finished_is_told(broken: Broken, tmp_path: Path) -> None:
    """Wherever it stands."""
    assert_told(tmp_path, CLEAN, broken)


@cases(
    Broken(
        "a2: 300 mm}", "a2: 300 mm, a3: 0.1 m}", "7:41", "a3: no link uses it", "delete it, or put it into the table"
    ),
    Broken(
        "a1: 0.4 m",
        "a1: 0 m",
        "7:18",
        "a1: is 0",
        "write 0 into the table, or leave its value open",
        is_warning=True,
    ),
    Broken(
        "300 mm}",
        "300}",
        "7:29",
        "a2: 300 m is longer than any arm",
        "bare lengths are metres: did you mean 300 mm?",
        is_warning=True,
    ),
)
def test_a_length_that_makes_no_sense_is_told(broken: Broken, tmp_path: Path) -> None:
    """Not used, nothing, or millimetres taken for metres."""
    assert_told(tmp_path, CLEAN, broken)


@cases(
    Broken(
        "  - {a: 0, alpha: 0, d: d3, theta: 0}",
        "  - {a: 0, alpha: 0, d: d3, theta: 0}\n  - {a: 0, alpha: 0, d: 0, theta: 0}",
        "12:5",
        "row 4 is all zeros: nothing moves, and nothing is moved",
        "did its joint variable get lost?",
    ),
    Broken(
        "alpha: 180°",
        "alpha: 450°",
        "10:20",
        "alpha of row 2: 450° is more than a turn",
        "rad or °?",
        is_warning=True,
    ),
    Broken(
        "theta: theta2}",
        "theta: theta2 + 90 rad}",
        "10:39",
        "theta of row 2: 90 rad is more than a turn",
        "rad or °?",
        is_warning=True,
    ),
    Broken(
        "theta: theta1}",
        "theta: 2*theta1}",
        "9:36",
        "theta of row 1: one degree of theta1 turns the joint by 2",
        "write theta1 or -theta1",
        is_warning=True,
    ),
)
def test_a_row_that_makes_no_sense_is_told(broken: Broken, tmp_path: Path) -> None:
    """Nothing in it, degrees for radians, or a joint that is geared."""
    assert_told(tmp_path, CLEAN, broken)


@cases(
    Broken("[90°, 0, 100 mm]", "[161°, 0, 100 mm]", "16:3", "up: theta1 = 161° is outside its limits", "-160° to 160°"),
    Broken("[90°, 0, 100 mm]", "[90°, 0, -1 mm]", "16:3", "up: d3 = -0.001 m is outside its limits", "0 m to 0.2 m"),
)
def test_a_pose_that_the_joints_cannot_take_is_told(broken: Broken, tmp_path: Path) -> None:
    """Of either kind of joint."""
    assert_told(tmp_path, CLEAN, broken)


@pytest.mark.parametrize("pose", ["[160°, 0, 0.2 m]", "[-160°, 0, 0]"])
def test_a_pose_at_a_limit_is_clean(pose: str, tmp_path: Path) -> None:
    """Limits belong to the range."""
    assert findings(tmp_path, CLEAN.replace("[90°, 0, 100 mm]", pose)) == []


def test_a_length_without_a_value_is_clean(tmp_path: Path) -> None:
    """It is asked for when it is needed."""
    assert findings(tmp_path, CLEAN.replace("{a1: 0.4 m, a2: 300 mm}", "\n  a1:\n  a2: 300 mm")) == []


def test_a_name_that_cannot_be_typed_is_told(tmp_path: Path) -> None:
    """The name of a robot is that of its file."""
    (found,) = findings(tmp_path, CLEAN, "my arm.yaml")
    assert (found.at, found.hint) == ("1:1", "letters, digits, - and _, such as my-arm.yaml")
    assert found.message == "the file name 'my arm' is the name of the robot, and cannot be typed"


def test_an_angle_taken_exactly_is_told(tmp_path: Path) -> None:
    """1.5708 rad is a right angle to its digits; a length that another follows from is used."""
    path = tmp_path / "arm.yaml"
    path.write_text(
        "format: 1\ntitle: T\nsource: mine\nconvention: standard\nvariables: [q1]\n"
        "parameters: {a2: 0.4 m, a3: 2*a2}\nlinks:\n  - {a: a3, alpha: 1.5708 rad, d: 0, theta: q1}\n",
        "utf-8",
    )
    (found,) = robots.findings(load_robot(path))
    assert found.is_warning
    assert "1.5708 rad is taken as 90°" in found.message
