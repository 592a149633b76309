"""Robot files with a slip: the cause is told, not what comes of it, and nothing hides anything else."""

from __future__ import annotations

from pathlib import Path

import pytest

from dhcli.errors import FileError
from dhcli.files.library.entries import Kind
from dhcli.files.library.kinds import kind_of
from dhcli.files.yaml.robots import read_robot
from tests.row_by_row import row_by_row

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

BY_ROW = "whether it turns or slides is said by the row in which it stands"
OTHERS = "theta1: [-160°, 160°], d2: [0, 250 mm]"


def told(*changes: tuple[str, str]) -> list[str]:
    """What is told of the arm with these changes, each with its line."""
    text = ARM
    for old, new in changes:
        assert text.count(old) == 1, old
        text = text.replace(old, new)
    with pytest.raises(FileError) as caught:
        read_robot(text, "arm", "arm")
    return [f"{p.place.line if p.place else 0}: {p.message}" for p in caught.value.problems]


@row_by_row(
    ("row", "hint"),
    [
        ("[a1, 0, 0, theta1]", "write {a: a1, alpha: 0, d: 0, theta: theta1}, if its cells are these"),
        ("a1, 0, 0, theta1", "write {a: a1, alpha: 0, d: 0, theta: theta1}, if its cells are these"),
        ("[theta1, 0.2, a1, -90°]", "write {theta: theta1, d: 0.2, a: a1, alpha: -90°}, if its cells are these"),
        ("[theta1, a1, 0]", "write {a: a1, alpha: 90°, d: 0, theta: theta1}, or convention: product for moves"),
    ],
)
def test_a_row_that_is_a_list_is_shown_with_its_keys(row: str, hint: str) -> None:
    """In the order in which the variable stands last, or first; it is read so, and nothing else is told."""
    text = ARM.replace("{a: a1, alpha: 0, d: 0, theta: theta1}", row)
    with pytest.raises(FileError) as caught:
        read_robot(text, "arm", "arm")
    assert [(p.message, p.hint) for p in caught.value.problems] == [("links: row 1 should be a mapping", hint)]


def test_a_cell_of_a_row_that_is_a_list_is_judged_too() -> None:
    """At its own place."""
    assert told(("{a: a1, alpha: 90°, d: 0, theta: theta3}", "[a1, 90, 0, theta3]")) == [
        "10: links: row 3 should be a mapping",
        "10: alpha: the angle 90 has no unit",
    ]


@row_by_row(
    ("old", "new", "said"),
    [
        (
            "{a: 0, alpha: 0, d: d2, theta: 0}",
            "{a: 0, alpha: 0, d: d2, theta: 0, offset: 1}",
            "9:39: offset: unknown key (add it in its cell: theta: theta1 + 90°)",
        ),
        (
            "{a: 0, alpha: 0, d: d2, theta: 0}",
            "{a: 0, alpha: 0, d: d2, theta: 0, type: P}",
            "9:39: type: unknown key (a joint turns by a variable in theta, and slides by one in d)",
        ),
        (
            "d: 0, theta: theta1}",
            "d: 0, theta1}",
            "8:29: theta1: its key is missing (write theta: theta1)",
        ),
        (
            "variables: [theta1, d2, theta3, theta4]",
            "variables: [theta1, {d2: prismatic}, theta3, theta4]",
            f"5:21: variables: a name stands alone (write d2; {BY_ROW})",
        ),
        (
            "{theta1: [-160°, 160°], d2: [0, 250 mm], theta4: [-90°, 90°]}",
            "[[-160°, 160°], [0, 250 mm], [0, 9°], [0, 1°]]",
            f"12:1: limits: should be a mapping, is a list (write {{{OTHERS}, theta3: [0, 9°], theta4: [0, 1°]}})",
        ),
        ("[-90°, 90°]", "-90° - 90°", "12:58: theta4: should be a list, is a text (write [-90°, 90°])"),
        ("[-90°, 90°]", "{max: 90°, min: -90°}", "12:58: theta4: should be a list, is a mapping (write [-90°, 90°])"),
        (
            "poses: ",
            "tool: {x: 0.1, z: 20 mm, yaw: 90°}\nposes: ",
            "13:7: tool: should be moves, is a mapping (write Trans(0.1, 0, 20 mm) rpy(0, 0, 90°))",
        ),
        (
            "poses: ",
            "tool: {x: 0.1, mass: 2}\nposes: ",
            "13:7: tool: should be moves, is a mapping (write Trans(0, 0, 0.1) Rot(z, 90°))",
        ),
    ],
)
def test_what_stands_in_the_shape_of_another_program_is_shown_in_ours(old: str, new: str, said: str) -> None:
    """With what the author has written, and nothing follows from it."""
    with pytest.raises(FileError) as caught:
        read_robot(ARM.replace(old, new), "arm", "arm")
    assert str(caught.value) == f"arm:{said}"


def test_a_robot_below_a_key_of_its_own_is_told_in_one_line() -> None:
    """And looked at as if it stood at the top."""
    inner = "".join(f"  {line}\n" for line in ARM.replace("d: d2", "d: d9").splitlines())
    with pytest.raises(FileError) as caught:
        read_robot(f"robot:\n{inner}", "arm", "arm")
    assert [str(problem).partition(" (")[0] for problem in caught.value.problems] == [
        "arm:1:1: robot: what stands below it belongs at the top of the file",
        "arm:10:27: d9 is not a name that is known here",
    ]


@pytest.mark.parametrize("comment", ["# a, alpha, d, theta", "# its columns: a, alpha, d, theta", "# Link([0 1 2 3])"])
def test_a_comment_makes_no_table_of_a_robot(comment: str) -> None:
    """That lacks its first line: this is told, and not that it is a file of others."""
    with pytest.raises(FileError) as caught:
        read_robot(ARM.replace("format: 1", comment), "arm", "arm")
    assert [problem.message for problem in caught.value.problems] == ["format: is missing"]


def test_joints_for_variables_make_no_linkage_of_a_robot(tmp_path: Path) -> None:
    """A file with a convention is one of a robot."""
    path = tmp_path / "arm.yaml"
    path.write_text(ARM.replace("variables:", "joints:"), "utf-8")
    assert kind_of(str(path)) is Kind.ROBOTS
    assert told(("variables:", "joints:")) == ["5: joints: unknown key"]


def test_the_arm_itself_is_right() -> None:
    """So that what is told comes of the changes."""
    assert read_robot(ARM, "arm", "arm").pattern == "RPRR"


def test_variables_that_are_not_listed_are_shown() -> None:
    """By what the rows move by, and nothing follows from it."""
    with pytest.raises(FileError) as caught:
        read_robot(ARM.replace("variables: [theta1, d2, theta3, theta4]\n", ""), "arm", "arm")
    (problem,) = caught.value.problems
    assert (problem.message, problem.hint) == ("variables: is missing", "variables: [theta1, d2, theta3, theta4]")
    axes = "format: 1\ntitle: T\nsource: S\nconvention: axes\naxes:\n  - {q1: +z, through: (0, 0, 0)}\n"
    with pytest.raises(FileError) as caught:
        read_robot(axes, "arm", "arm")
    assert [problem.hint for problem in caught.value.problems] == ["variables: [q1]"]


def test_nothing_follows_from_a_table_that_is_missing() -> None:
    """Whose name is misspelt, or that is not there at all."""
    assert told(("links:", "Links:")) == ["7: Links: unknown key"]
    assert told(("links:", "Rungs:")) == ["1: links: is missing", "7: Rungs: unknown key"]


@row_by_row(
    ("old", "new", "message", "hint"),
    [
        ("convention: standard", "convention: Craig", "convention: 'Craig' is not known", "write modified"),
        ("convention: standard", "convention: classical", "convention: 'classical' is not known", "write standard"),
        ("{a1: 300 mm}", "[a1]", "parameters: should be a mapping, is a list", "write {a1: 300 mm, a2: 0.2 m}"),
        ("300 mm", "300 Meter", "Meter is not a name that is known here", "the unit is written m"),
        ("[0, 250 mm]", "±250 mm", "d2: should be a list, is a text", "write [-250 mm, 250 mm]"),
        ("[-90°, 90°]", "-80°..90°", "theta4: should be a list, is a text", "write [-80°, 90°]"),
        ("[-90°, 90°]", "-80° to 90°", "theta4: should be a list, is a text", "write [-80°, 90°]"),
        ("[0, 0.1, 0, 20°]", "0", "home: should be a list, is a text", "write [90°, 100 mm, 90°, 90°]"),
        (
            "[0, 0.1, 0, 20°]",
            "{theta4: 20°, theta_1: 0, d2: 0.1, theta3: 0}",
            "home: should be a list, is a mapping",
            "write [0, 0.1, 0, 20°]",
        ),
        ("[0, 0.1, 0, 20°]", "0 0.1 0 20°", "home: should be a list, is a text", "write [0, 0.1, 0, 20°]"),
        (
            "[0, 0.1, 0, 20°]",
            "[0, 0,1, 0, 20,5°]",
            "home: a number has a decimal comma, which ends a value here",
            "write [0, 0.1, 0, 20.5°]",
        ),
        (
            "[-90°, 90°]",
            "[-1,5 rad,1,5 rad]",
            "theta4: a number has a decimal comma, which ends a value here",
            "write [-1.5 rad, 1.5 rad]",
        ),
        (
            "[theta1, d2, theta3, theta4]",
            "theta1 d2 theta3 theta4",
            "variables: should be a list, is a text",
            "write [theta1, d2, theta3, theta4]",
        ),
        (
            "poses:",
            "tool: [[1, 0, 0, 0,1], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]\nposes:",
            "tool: a number has a decimal comma, which ends a value here",
            "write [1, 0, 0, 0.1]",
        ),
        (
            "{a: 0, alpha",
            "{a: a1*sin(30), alpha",
            "sin of 30 does not say what 30 is",
            "write 30° for degrees, 30 rad for radians",
        ),
        (
            "poses:",
            "tool: {xyz: [0, 0, 0.1], rpy: [0, 0, 0]}\nposes:",
            "tool: should be moves, is a mapping",
            "write Trans(0, 0, 0.1) Rot(z, 90°)",
        ),
        ("poses:", "tool: [0, 0, a1]\nposes:", "tool: should be moves, is a list", "write Trans(0, 0, a1)"),
        (
            "poses:",
            "tool: Trans(0, 0, 0,1)\nposes:",
            "Trans takes three lengths, not 4",
            "write Trans(1, 2, 3); decimals take a point: 0.5",
        ),
    ],
)
def test_a_value_in_another_form_is_one_problem_that_shows_the_right_one(
    old: str, new: str, message: str, hint: str
) -> None:
    """And nothing follows from it."""
    with pytest.raises(FileError) as caught:
        read_robot(ARM.replace(old, new, 1), "arm", "arm")
    assert [(problem.message, problem.hint) for problem in caught.value.problems] == [(message, hint)]


@pytest.mark.parametrize("home", ["[0,0,1,0,20°]", "[0,1, 0, 0.5, 0, 20°, 0]"])
def test_commas_that_may_separate_are_not_taken_for_decimal_ones(home: str) -> None:
    """Where nobody can say which of them are, values are counted as they stand."""
    assert told(("[0, 0.1, 0, 20°]", home))[0].startswith("13: home: ")
    assert "decimal" not in " ".join(told(("[0, 0.1, 0, 20°]", home)))


def test_a_matrix_may_be_a_list_of_its_rows() -> None:
    """On one line or on several, wherever moves stand; no quotes are needed."""
    rows = "[[0, -1, 0, a1], [1, 0, 0, 0], [0, 0, 1, 0.1], [0, 0, 0, 1]]"
    wanted = read_robot(ARM.replace("poses:", f"tool: '{rows}'\nposes:"), "arm", "arm").tool
    assert wanted
    below = rows.removeprefix("[").removesuffix("]").replace("], [", "]\n  - [")
    for spelled in (rows, f"\n  - {below}"):
        robot = read_robot(ARM.replace("poses:", f"tool: {spelled}\ntools: {{t: {rows}}}\nposes:"), "arm", "arm")
        assert robot.tool == robot.tools["t"] == wanted


def test_joints_are_known_in_every_spelling() -> None:
    """θ1 is theta1, in the keys of limits too."""
    assert set(read_robot(ARM.replace("{theta1:", "{θ_1:"), "arm", "arm").limits) == {"theta1", "d2", "theta4"}


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
