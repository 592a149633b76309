"""Where the documents print a result, dhcli writes the same tree, and never with more operations.

The same up to the order of terms and factors and the sign of brackets.
"""

from __future__ import annotations

import pytest

from dhcli.algebra.equality import equal
from dhcli.files.yaml.robots import load_robot
from dhcli.kinematics.forward import symbolic
from dhcli.notation.parser import parse
from dhcli.notation.writer import write
from tests.row_by_row import row_by_row
from tests.truth.items import EQUATIONS, computed, count, matrix, tree

PRINTED = {name: item for name, item in EQUATIONS.items() if item["printed"]}
"""Results that stand in a document; where it has a misprint, the corrected entry counts."""

OTHERWISE = {
    "Y38": (
        frozenset({(1, 1), (1, 2), (1, 4), (2, 1), (2, 2), (2, 4)}),
        (
            "The slides multiply c1 and s1 into the wrist's brackets, c1*c4*c5*c6 - c1*s4*s6; the product of the "
            "links keeps c1*(c4*c5*c6 - s4*s6). In the position they gather d6 where the chain gathers s1 and c1."
        ),
    ),
    "Y45": (
        frozenset({(1, 4), (2, 4), (3, 4)}),
        (
            "The slides gather d6 in the position, c2*d3 + d6*(c2*c5 - s2*c4*s5); the chain gathers what joint 2 "
            "turns, c2*(d3 + d6*c5) - d6*s2*c4*s5."
        ),
    ),
    "Y53": (
        frozenset({(1, 1), (1, 2), (2, 1), (2, 2)}),
        (
            "The slides leave c12*c4 + s12*s4; axis 4 is parallel to axes 1 and 2 with the sense turned, so this is "
            "one angle, c(theta1+theta2-theta4)."
        ),
    ),
    "Z21": (
        frozenset({(1, 1), (2, 1), (3, 1)}),
        (
            "The slides multiply the point into the columns of 0T3, one product a term; the chain turns the point "
            "by one joint after the other and leaves the brackets."
        ),
    ),
}
"""The four results that documents write in another way: the cells, and how. Ours are equal to them."""

COUNTS = {
    "planar-2r": 6,
    "scara-yim": 7,
    "cylindrical-wrist": 67,
    "stanford": 131,
    "puma560": 120,
    "panda": 450,
}
"""Operations that the twelve entries may have at most, binary + - * / only, nothing shared."""


def different_cells(name: str) -> frozenset[tuple[int, int]]:
    """The cells whose tree is not the document's."""
    pairs = zip(computed(EQUATIONS[name]), matrix(EQUATIONS[name]["expected"]), strict=True)
    return frozenset(
        (i, j)
        for i, (ours, theirs) in enumerate(pairs, 1)
        for j, (one, other) in enumerate(zip(ours, theirs, strict=True), 1)
        if tree(one) != tree(other)
    )


def test_the_comparison_of_trees_sees_a_difference_of_form() -> None:
    """Equal values in another form are another tree; order and signs of brackets are not."""
    assert tree(parse("c1*(a2*c2 - a3*s23) - d3*s1")) == tree(parse("-(s1*d3) - (a3*s23 - c2*a2)*c1"))
    assert tree(parse("c1*(a2 + a3)")) != tree(parse("c1*a2 + c1*a3"))
    assert tree(parse("c12")) != tree(parse("c1*c2 - s1*s2"))
    assert tree(parse("2*a1 - a2")) != tree(parse("2*a1 + a2"))


@row_by_row("name", [name for name in PRINTED if name not in OTHERWISE])
def test_the_result_is_the_printed_tree(name: str) -> None:
    """In every cell."""
    assert different_cells(name) == frozenset()


@pytest.mark.parametrize("name", OTHERWISE)
def test_a_result_written_otherwise_is_so_in_the_cells_of_the_note_only(name: str) -> None:
    """And it is equal there: the note must not outlive the difference."""
    cells, note = OTHERWISE[name]
    assert different_cells(name) == cells
    assert note
    ours, theirs = computed(EQUATIONS[name]), matrix(EQUATIONS[name]["expected"])
    assert all(equal(ours[i - 1][j - 1], theirs[i - 1][j - 1]) for i, j in cells)


@row_by_row("name", PRINTED)
def test_the_result_has_no_more_operations_than_the_printed_one(name: str) -> None:
    """All entries together."""
    assert count(computed(PRINTED[name])) <= count(matrix(PRINTED[name]["expected"]))


@pytest.mark.parametrize(("robot", "most"), COUNTS.items())
def test_the_pose_of_a_robot_has_at_most_so_many_operations(robot: str, most: int) -> None:
    """The counts that the design promises."""
    assert count(symbolic(load_robot(robot)).rows) <= most


@row_by_row(
    ("robot", "cell", "text"),
    [
        ("planar-2r", (0, 3), "a1*c1 + a2*c12"),
        ("scara", (0, 3), "-l2*s1 - l3*s12"),
        ("stanford", (0, 0), "c1*(c2*(c4*c5*c6 - s4*s6) - s2*s5*c6) - s1*(s4*c5*c6 + c4*s6)"),
        ("puma560", (0, 3), "c1*(a2*c2 + a3*c23 - d4*s23) - d3*s1"),
        ("puma560", (1, 3), "s1*(a2*c2 + a3*c23 - d4*s23) + d3*c1"),
        ("puma560", (0, 2), "-c1*(c23*c4*s5 + s23*c5) - s1*s4*s5"),
        ("scara-yim", (0, 0), "c(theta1+theta2-theta4)"),
        ("articulated", (0, 3), "c1*(a2*c2 + a3*c23)"),
    ],
)
def test_the_text_is_the_one_a_reader_expects(robot: str, cell: tuple[int, int], text: str) -> None:
    """Order of terms and factors too, for some well-known entries."""
    arm = load_robot(robot)
    assert write(symbolic(arm).rows[cell[0]][cell[1]], "short", arm.writing) == text
