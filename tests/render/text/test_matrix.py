"""How matrices look, and that what is pasted back is read."""

import pytest

from dhcli import forward, load_robot, symbolic
from dhcli.files.library.entries import Kind, entries
from dhcli.notation.matrix import parse_matrix
from dhcli.notation.tree import Expr
from dhcli.render.look import Look
from dhcli.render.paper import Paper
from dhcli.render.text.matrix import matrix_lines
from tests.row_by_row import row_by_row

ROBOTS = [entry.name for entry in entries(Kind.ROBOTS) if entry.origin == "built-in"]
WIDE = 10_000


@row_by_row("unicode", [True, False])
@row_by_row("name", ROBOTS)
def test_a_printed_symbolic_matrix_is_read_back_as_the_same_tree(name: str, unicode: bool) -> None:
    """Copy from the terminal, paste into an answer: nothing is lost."""
    robot = load_robot(name)
    pose = symbolic(robot)
    lines = matrix_lines(pose.rows, pose.joints, Look(paper=Paper(WIDE, unicode=unicode)))
    cells = parse_matrix("\n".join(lines), robot.scope)
    assert [[cell.expr for cell in row] for row in cells] == [list(row) for row in pose.rows]


@pytest.mark.parametrize("unicode", [True, False])
def test_a_printed_numeric_matrix_is_read_back(unicode: bool) -> None:
    """To the digits shown."""
    pose = forward(load_robot("puma560"), [0.1, -0.2, 0.3, -0.4, 0.5, -0.6])
    lines = matrix_lines(pose.rows, pose.joints, Look(paper=Paper(unicode=unicode)))
    cells = parse_matrix("\n".join(lines))
    assert [[cell.text for cell in row] for row in cells] == [list(row) for row in pose.cells()]


def test_decimal_points_stand_below_each_other() -> None:
    """In every column, also beside whole numbers."""
    rows = ((1.0, -0.25), (-12.5, 3.0), (0.125, 100.0))
    assert matrix_lines(rows, load_robot("scara").writing, Look()) == [
        "⎡   1       -0.25 ⎤",
        "⎢ -12.5      3    ⎥",
        "⎣   0.125  100    ⎦",
    ]


@row_by_row("name", ROBOTS)
def test_a_matrix_fits_the_paper_or_is_given_entry_by_entry(name: str) -> None:
    """At 80 columns no line of a matrix is longer, and no formula is ever folded."""
    pose = symbolic(load_robot(name))
    lines = matrix_lines(pose.rows, pose.joints, Look(paper=Paper(80)))
    if lines[0].startswith("⎡"):
        assert len(lines) == 4
        assert max(map(len, lines)) <= 80
    else:
        texts = [line.partition(" = ")[2] for line in lines]
        assert texts == [cell for row in pose.cells()[:3] for cell in row]


def test_noughts_and_ones_are_dim_and_nothing_else_is() -> None:
    """What is structural stands back."""
    pose = symbolic(load_robot("planar-2r"))
    line = matrix_lines(pose.rows, pose.joints, Look(paper=Paper(colour=True)))[0]
    assert "\x1b[2m" in line
    assert "c12" in line
    assert "\x1b[2mc12" not in line


def test_rows_of_expressions_are_what_a_pose_has() -> None:
    """The helper above must see trees, or the test of pasting back would compare nothing."""
    assert all(isinstance(entry, Expr) for row in symbolic(load_robot("scara")).rows for entry in row)
