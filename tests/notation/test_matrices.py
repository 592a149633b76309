"""Matrices in all the ways people write and paste them."""

from __future__ import annotations

import pytest

from dhcli.errors import NotationError
from dhcli.files.yaml.robots import load_robot
from dhcli.kinematics.forward import symbolic
from dhcli.notation.matrix import Cell, parse_matrix
from dhcli.notation.scope import Scope
from dhcli.notation.styles import STYLES
from dhcli.notation.writer import write
from tests.row_by_row import row_by_row

ROBOT = Scope(joints=("theta1", "theta2", "theta3"), lengths=("a1", "a2", "d3", "l1"))

ROTATION = [["c1", "-s1"], ["s1", "c1"]]


def texts(matrix: tuple[tuple[Cell, ...], ...]) -> list[list[str]]:
    """The entries as they are written."""
    return [[write(cell.expr) for cell in row] for row in matrix]


@row_by_row(
    "text",
    [
        "[[c1, -s1], [s1, c1]]",
        "[c1 -s1; s1 c1]",
        "[c1, -s1; s1, c1];",
        "[c1 -s1\n s1 c1]",
        "c1 -s1\ns1 c1",
        "c1 -s1\r\ns1 c1\r\n",
        "c1\t-s1\ns1\tc1",
        "c1, -s1\ns1, c1\n",
        "c1 -s1; s1 c1",
        "\n\n  c1 -s1\n\n  s1 c1\n",
        "np.array([[c1, -s1], [s1, c1]])",
        "array([[c1, -s1],\n       [s1,  c1]])",
        "numpy.matrix([[c1, -s1], [s1, c1]])",
        "sympy.Matrix([[c1, -s1], [s1, c1]])",
        "T = [c1, -s1; s1, c1];",
        "% T_01\nT = [c1 -s1; s1 c1];",
        "# T_01\nnp.array([[np.cos(theta1), -np.sin(theta1)],\n          [np.sin(theta1), np.cos(theta1)]])",
        "[[c1 -s1]\n [s1 c1]]",
        "- [c1, -s1]\n- [s1, c1]",
        "{{c1, -s1}, {s1, c1}}",
        "{c1, -s1},\n{s1, c1}",
        "([c1, -s1], [s1, c1])",
        "[[c1, -s1], [s1, c1],]",
        "| c1 | -s1 |\n|----|-----|\n| s1 | c1 |",
        "c1 | -s1\n---|:---:\ns1 | c1",
        "+----+-----+\n| c1 | -s1 |\n+----+-----+\n| s1 | c1  |\n+----+-----+",
        "┌────┬─────┐\n│ c1 │ -s1 │\n├────┼─────┤\n│ s1 │ c1  │\n└────┴─────┘",
        "┌         ┐\n│ c1  -s1 │\n│ s1   c1 │\n└         ┘",
        "⎡ c1  -s1 ⎤\n⎣ s1  c1  ⎦",
        "| c1 -s1 |\n| s1 c1 |",
        r"\begin{bmatrix} c_1 & -s_1 \\ s_1 & c_1 \end{bmatrix}",
        r"$$\begin{pmatrix} c_{1} & -s_{1} \\ s_{1} & c_{1} \\ \end{pmatrix}$$",
        r"\left[\begin{array}{cc} \cos\theta_1 & -\sin\theta_1 \\ \sin\theta_1 & \cos\theta_1 \end{array}\right]",
        r"c_1 & -s_1 \\ s_1 & c_1",
        "cos(θ1) -sin(θ1)\nsin(θ1) cos(θ1)",
        "cos θ1 -sin θ1\nsin θ1 cos θ1",
        "[c(θ1) -s(θ1); s(θ1) c(θ1)]",
        "[(c1) (-s1); (s1) (c1)]",
    ],
)
def test_a_matrix_is_read_however_it_is_written(text: str) -> None:
    """The same four entries each time."""
    assert texts(parse_matrix(text, ROBOT)) == ROTATION


@row_by_row(
    ("text", "entries"),
    [
        ("c1 -s1", [["c1", "-s1"]]),
        ("c1 - s1", [["c1 - s1"]]),
        ("[c1 - s1, 0]", [["c1 - s1", "0"]]),
        ("c1*a1 + c12*a2 -s1", [["a1*c1 + a2*c12", "-s1"]]),
        ("c1 *a1 2", [["a1*c1", "2"]]),
        ("[-1 -2; - 3 4]", [["-1", "-2"], ["-3", "4"]]),
        ("a1 c1 s1", [["a1", "c1", "s1"]]),
        ("a1c1 2a2", [["a1*c1", "2*a2"]]),
        ("c1*(a1 + a2) (a1 - a2)", [["c1*(a1 + a2)", "a1 - a2"]]),
        ("l1 - d3\n1", [["l1 - d3"], ["1"]]),
        ("1/2 √3/2", [["1/2", "sqrt(3)/2"]]),
        ("30 mm 5 cm", [["30*mm", "5*cm"]]),
        ("90° -90°", [["90*deg", "-90*deg"]]),
        ("[1 2 3]", [["1", "2", "3"]]),
        ("[1; 2; 3]", [["1"], ["2"], ["3"]]),
        ("[[1], [2]]", [["1"], ["2"]]),
        ("5", [["5"]]),
        ("1. 0.\n0. -1.e-3", [["1", "0"], ["0", "-0.001"]]),
    ],
)
def test_a_blank_begins_a_cell_where_a_person_means_one(text: str, entries: list[list[str]]) -> None:
    """`c1 -s1` is two cells, `c1 - s1` is one; in brackets a blank is nothing."""
    assert texts(parse_matrix(text, ROBOT)) == entries


@row_by_row("style", [name for name in STYLES if name != "sympy"])
@row_by_row("separators", [(", ", "; "), (" & ", " \\\\ "), (" | ", "\n"), (", ", "\n")])
def test_a_written_matrix_is_read_back(style: str, separators: tuple[str, str]) -> None:
    """The pose of a robot in every notation and every layout."""
    arm = load_robot("scara")
    rows = symbolic(arm).rows
    between, below = separators
    text = below.join(between.join(write(entry, style, arm.writing) for entry in row) for row in rows)
    assert tuple(tuple(cell.expr for cell in row) for row in parse_matrix(text, arm.scope)) == rows


def test_a_cell_knows_its_text_and_its_place() -> None:
    """What was typed, and where, for a judge that points at it."""
    cells = parse_matrix("[ c1  - s1, a1c1;\n  0.50, 2 ]", ROBOT)
    assert [[(cell.text, cell.start) for cell in row] for row in cells] == [
        [("c1  - s1", 2), ("a1c1", 12)],
        [("0.50", 20), ("2", 26)],
    ]


@row_by_row(
    ("text", "message"),
    [
        ("", "matrix:1: no matrix is written here (write [1 0 0 0; 0 1 0 0; 0 0 1 0; 0 0 0 1])"),
        ("[]", "matrix:1: no matrix is written here (write [1 0 0 0; 0 1 0 0; 0 0 1 0; 0 0 0 1])"),
        (
            "[c1 -s1 0; s1 - c1 0; 0 0 1]",
            (
                "matrix:12: row 2 has 2 cells where others have 3: s1 - c1 | 0"
                " (c1 -s1 and a1 c1 are two cells, c1 - s1 and a1*c1 are one; commas settle it)"
            ),
        ),
        ("[1, 2; 3, x]", "matrix:11: x is not a name that is known here"),
        ("1 2\n3 q", "matrix:2:3: q is not a name that is known here"),
        ("[1, , 2]", "matrix:5: a cell is empty here (write 0 for a zero)"),
        ("| 1 | | 2 |", "matrix:7: a cell is empty here (write 0 for a zero)"),
        ("1 & & 2", "matrix:5: a cell is empty here (write 0 for a zero)"),
        ("[1, 2; 3, 4 +]", "matrix:14: the end where a number, a name or a bracket was expected"),
        ("1 2 % two cells", "matrix:5: % (Percent Sign) means nothing here"),
    ],
)
def test_what_is_no_matrix_is_told_with_its_column(text: str, message: str) -> None:
    """Lengths of rows that differ, with the row as it was read; empty cells; unknown names."""
    with pytest.raises(NotationError) as caught:
        parse_matrix(text, ROBOT)
    assert str(caught.value).split(" (known")[0].split(" (did you")[0] == message


def test_at_most_256_cells_are_read() -> None:
    """A table of sixty-four rows, and not one more."""
    assert len(parse_matrix("; ".join(["1 2 3 4"] * 64))) == 64
    with pytest.raises(NotationError, match="a matrix of more than 256 cells is not read"):
        parse_matrix(" ".join(["1"] * 257))
