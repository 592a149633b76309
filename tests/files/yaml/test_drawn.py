"""Robots given by axes or screws, and every description as a file that loads."""

from __future__ import annotations

from pathlib import Path

import pytest

from dhcli.errors import FileError
from dhcli.files.yaml.robots import load_robot, read_robot
from dhcli.files.yaml.writing import described_text
from dhcli.kinematics.describe.asked import FORMS, Asked
from dhcli.kinematics.describe.description import describe, known_values
from dhcli.kinematics.describe.proof import proved
from dhcli.kinematics.forward import symbolic
from tests.coupled import COUPLED
from tests.nightly import paired
from tests.row_by_row import row_by_row

ROBOTS = sorted({path.stem for path in (Path(__file__).parents[3] / "robots").glob("*.yaml")} - {*COUPLED})

HEAD = "format: 1\ntitle: t\nsource: s\n"
ZHOU = f"""{HEAD}convention: axes
variables: [theta1, theta2, theta3]
parameters: {{a: 0.4 m, b: 0.3 m}}
drawn: {{theta1: 90°}}            # values in the pose drawn, else 0
axes:
  - {{theta1: +z, through: (0, 0, 0)}}
  - {{theta2: +z, through: (a, 0, 0)}}
  - {{theta3: +y, through: (a + b, 0, 0)}}   # a point (of it)
end: Trans(a + b, 0, 0) Rot(x, -90°)
"""


def with_line(old: str, new: str) -> str:
    """The drawn robot with one line changed."""
    assert old in ZHOU
    return ZHOU.replace(old, new)


@pytest.mark.parametrize(("name", "form"), paired([name for name in ROBOTS if not name.startswith("dh-link")], FORMS))
def test_what_is_written_loads_and_is_the_same_motion(name: str, form: str) -> None:
    """Every robot in every form, letters, limits and poses kept."""
    robot = load_robot(name)
    if not robot.variables:
        return
    text = described_text(describe(robot, Asked(form)))  # type: ignore[arg-type]
    back = read_robot(text, "file", name)
    assert proved(robot.chain, back.chain, known_values(robot)).kind == "exact"
    assert back.limits == robot.limits
    assert back.poses.keys() == robot.poses.keys()


def test_letters_in_the_place_of_angles_are_written_too() -> None:
    """Names with braces are quoted."""
    robot = load_robot("dh-link-modified")
    back = read_robot(described_text(describe(robot, Asked("standard"))), "file", "x")
    assert proved(robot.chain, back.chain, {}).kind == "exact"


def test_axes_drawn_elsewhere_than_at_zero_give_offsets() -> None:
    """Zhou's arm drawn at theta1 = 90°: the table of the slides with theta1 - 90°."""
    robot = read_robot(ZHOU, "file", "zhou")
    rows = [link.row for link in describe(robot, Asked("standard")).robot.links]
    assert [str(row.a) for row in rows if row] == ["a", "b", "0"]
    assert rows[0] is not None
    assert rows[0].theta.degrees == -90
    assert str(symbolic(robot).position) == "(a*s1 + b*s12, -a*c1 - b*c12, 0)"
    assert robot.poses["drawn"][0].degrees == 90  # type: ignore[union-attr]


def test_an_axis_may_be_given_by_two_points() -> None:
    """From the first to the second, whatever is between them."""
    text = with_line("{theta2: +z, through: (a, 0, 0)}", "{theta2: (a, 0, 1) to (a, 0, 3)}")
    one, other = read_robot(text, "file", "zhou"), read_robot(ZHOU, "file", "zhou")
    assert proved(one.chain, other.chain, {}).kind == "exact"


def test_screws_of_a_book_are_read() -> None:
    """A planar arm after Lynch and Park: space screws and the home pose."""
    text = f"""{HEAD}convention: screws
variables: [theta1, theta2]
parameters: {{a1: 0.4 m, a2: 0.3 m}}
screws:
  - {{theta1: (0, 0, 1, 0, 0, 0)}}
  - {{theta2: (0, 0, 1, 0, -a1, 0)}}
home: Trans(a1 + a2, 0, 0)
"""
    robot = read_robot(text, "file", "x")
    assert proved(robot.chain, load_robot("planar-2r").chain, {}).kind == "exact"


@row_by_row(
    ("old", "new", "said"),
    [
        ("through: (a, 0, 0)", "through: (a, 0)", "3 values are wanted, not 2"),
        ("through: (a, 0, 0)", "through: a 0 0", "3 values are wanted, not 1 (write (a, 0, 0))"),
        ("{theta2: +z, through: (a, 0, 0)}", "[0, 0, 1]", "is a list (write {theta2: (0, 0, 1)})"),
        ("theta2: +z", "theta2: (0, 0, 0)", "a direction is not zero"),
        ("theta2: +z", "theta2: (a, b, 0)", "a direction cannot depend on a, b"),
        ("{theta2: +z, through: (a, 0, 0)}", "{theta2: (a, 0, 0) to (a, 0, 0)}", "the two points of the axis are one"),
        ("{theta2: +z, through: (a, 0, 0)}", "{theta2: (a, 0, 0) to (0, 0, 1)}", "depends on a"),
        ("{theta2: +z, through: (a, 0, 0)}", "{theta2: (a, 0, 0) to (a, 0)}", "3 values are wanted, not 2"),
        ("theta2: +z", "theta4: +z", "theta4 is not a joint variable"),
        (", through: (a, 0, 0)", "", "a point of it is missing"),
        ("drawn: {theta1: 90°}", "drawn: {theta1: 90}", "the angle 90 has no unit"),
        ("drawn: {theta1: 90°}", "drawn: {phi: 90°}", "phi is not a joint variable"),
        ("end: Trans(a + b, 0, 0) Rot(x, -90°)", 'end: "[1 0 0 0; 0 1 0 0; 0 0 -1 0; 0 0 0 1]"', "left-handed"),
        ("axes:", "axis:", "axis: unknown key"),
        ("convention: axes", "convention: axis", "'axis' is not known"),
    ],
)
def test_what_is_wrong_with_drawn_axes_is_said_with_its_line(old: str, new: str, said: str) -> None:
    """One slip each."""
    with pytest.raises(FileError) as caught:
        read_robot(with_line(old, new), "file", "zhou")
    assert said in str(caught.value)
    assert "file:" in str(caught.value)


def test_the_line_of_an_error_stands_as_in_the_file() -> None:
    """With the commas between the coordinates of a point, under a marker that fits."""
    wrong = "  - {theta2: (a, 1, 0), through: (a, 0, 0)}"
    with pytest.raises(FileError) as caught:
        read_robot(with_line("  - {theta2: +z, through: (a, 0, 0)}", wrong), "mine.yaml", "mine")
    place = caught.value.problems[0].place
    assert place
    assert place.text == wrong
    assert wrong[(place.column or 0) - 1 :].startswith("(a, 1, 0)")


def test_lengths_that_follow_from_others_still_follow() -> None:
    """The formula is written, not its value."""
    text = f"""{HEAD}convention: standard
variables: [theta1, theta2]
parameters: {{a1: 0.4 m, a2: 2*a1}}
links:
  - {{a: a1, alpha: 0, d: 0, theta: theta1}}
  - {{a: a2, alpha: 0, d: 0, theta: theta2}}
"""
    robot = read_robot(text, "file", "x")
    written = described_text(describe(robot, Asked("modified")))
    assert "a2: 2*a1" in written
    assert read_robot(written, "file", "x").derived == robot.derived


def test_screws_without_names_are_those_of_the_variables_in_turn() -> None:
    """It is told of each with its name, and nothing follows from it."""
    rows = "screws: [[0, 0, 1, 0, 0, 0], [0, 0, 1, 0, -0.4, 0]]\nhome: Trans(0.7, 0, 0)\n"
    with pytest.raises(FileError) as caught:
        read_robot(f"{HEAD}convention: screws\nvariables: [q1, q2]\n{rows}", "file", "x")
    assert str(caught.value).splitlines() == [
        "file:6:10: screws: row 1: should be a mapping, is a list (write {q1: (0, 0, 1, 0, 0, 0)})",
        "file:6:30: screws: row 2: should be a mapping, is a list (write {q2: (0, 0, 1, 0, -0.4, 0)})",
    ]
