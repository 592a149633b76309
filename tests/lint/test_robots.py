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


LONG = "is longer than any arm"
METRES = "bare lengths are metres: did you mean 120 mm?"


@cases(
    Broken(
        "a: a1, alpha: 0, d: 0,",
        "a: a1, alpha: 0, d: 120,",
        "9:26",
        f"d of row 1: 120 m {LONG}",
        METRES,
        is_warning=True,
    ),
    Broken("a: a2,", "a: a2 - 120,", "10:9", f"a of row 2: 120 m {LONG}", METRES, is_warning=True),
    Broken("d: d3,", "d: d3 + 120,", "11:25", f"d of row 3: 120 m {LONG}", METRES, is_warning=True),
    Broken("limits:\n", "tool: Trans(0, 0, 120)\nlimits:\n", "12:7", f"tool: 120 m {LONG}", METRES, is_warning=True),
    Broken(
        "limits:\n",
        "base: '[1 0 0 120; 0 1 0 0; 0 0 1 0; 0 0 0 1]'\nlimits:\n",
        "12:7",
        f"base: 120 m {LONG}",
        METRES,
        is_warning=True,
    ),
    Broken(
        "limits:\n",
        "tools: {pen: 'Trans(120, 0, 0)'}\nlimits:\n",
        "12:14",
        f"pen: 120 m {LONG}",
        METRES,
        is_warning=True,
    ),
    Broken("d3: [0, 0.2 m]", "d3: [0, 120]", "14:3", f"d3: 120 m {LONG}", METRES, is_warning=True),
)
def test_a_length_in_millimetres_without_its_unit_is_told_wherever_it_stands(broken: Broken, tmp_path: Path) -> None:
    """In rows, beside joint variables, in tools and bases, and in limits."""
    assert_told(tmp_path, CLEAN, broken)


def test_where_all_lengths_lack_their_unit_one_key_mends_them(tmp_path: Path) -> None:
    """Each is told at its place, a slide within its limits among them; with the key there is nothing to tell."""
    bare = CLEAN.replace("0.4 m, a2: 300 mm", "400, a2: 300").replace("0.2 m]", "200]").replace("100 mm]", "100]")
    told = findings(tmp_path, bare)
    assert [one.message.split()[0] for one in told] == ["a1:", "a2:", "d3:", "up:"]
    assert told[3].message == "up: d3 = 100 m is longer than any arm"
    assert told[0].hint == "bare lengths are metres: did you mean 400 mm? units: mm makes all of them so"
    assert findings(tmp_path, bare.replace("convention:", "units: mm\nconvention:")) == []


def test_an_angle_whose_row_is_refused_is_no_length(tmp_path: Path) -> None:
    """What is wrong with its row is all that is told."""
    text = CLEAN.replace("theta: theta2", "theta: phi2").replace("limits:\n", "limits:\n  theta2: [-90, 90]\n")
    text = text.replace("up: [90°, 0,", "up: [90°, 90,")
    told = [one.message for one in findings(tmp_path, text)]
    assert any("phi2" in message for message in told)
    assert not any(LONG in message for message in told)


def test_a_length_that_follows_from_another_is_told_with_that_alone(tmp_path: Path) -> None:
    """One number is wrong, and twice of it is no second one."""
    text = CLEAN.replace("0.4 m, a2: 300 mm", "400, a2: 2*a1")
    assert [one.message for one in findings(tmp_path, text)] == ["a1: 400 m is longer than any arm"]


@pytest.mark.parametrize(("size", "hint"), [("0.4 mm", "did you mean 0.4 m?"), ("3 mm", "")])
def test_an_arm_of_less_than_a_fingernail_was_measured_in_metres(tmp_path: Path, size: str, hint: str) -> None:
    """With `units: mm` above them, or a wrong unit behind each; one that is open may be as long as an arm."""
    text = CLEAN.replace("0.4 m, a2: 300 mm", f"0.3 mm, a2: {size}").replace("0.2 m]", "0.1 mm]")
    text = text.replace("100 mm]", "0.1 mm]")
    told = [(one.message, one.hint) for one in findings(tmp_path, text)]
    assert told == ([("a2: the longest of all lengths is 0.4 mm", hint)] if hint else [])
    assert findings(tmp_path, text.replace("a1: 0.3 mm", "a1: ")) == []


AXES = """\
format: 1
title: An arm
source: a test
convention: axes
variables: [theta1, theta2]
axes:
  - {theta1: +z, through: (0, 0, 0)}
  - {theta2: -z, through: (300, 0, 0)}
end: Trans(0.3, 0, 0)
"""
SCREWS = """\
format: 1
title: An arm
source: a test
convention: screws
variables: [theta1, theta2]
screws:
  - {theta1: (0, 0, 1, 0, 0, 0)}
  - {theta2: (0, 0, 1, 0, -300, 0)}
home: Trans(0.7, 0, 0)
"""
PRODUCT = """\
format: 1
title: An arm
source: a test
convention: product
variables: [theta1, theta2]
links:
  - Rot(z, theta1)
  - Trans(300, 0, 0) * Rot(z, theta2)
"""


@pytest.mark.parametrize("text", [AXES, SCREWS, PRODUCT], ids=["axes", "screws", "product"])
def test_a_long_way_is_told_in_every_form_of_a_robot(tmp_path: Path, text: str) -> None:
    """At the axis, the screw or the product that it leads to."""
    (found,) = findings(tmp_path, text)
    assert (found.at, found.message, found.is_warning) == ("8:5", "row 2: 300 m is longer than any arm", True)


def test_blocks_that_no_joint_moves_have_any_size(tmp_path: Path) -> None:
    """A book may name no unit for them."""
    text = PRODUCT.replace("variables: [theta1, theta2]", "variables: []").replace("theta1", "30°")
    assert findings(tmp_path, text.replace("theta2", "40°")) == []


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
