"""Pasted print: what papers, MATLAB and dhcli itself set around a matrix or an entry."""

from __future__ import annotations

import pytest

from dhcli.errors import NotationError
from dhcli.notation.matrix import parse_matrix
from dhcli.notation.parser import parse
from dhcli.notation.pasted import EntriesError, rows_of, without_label
from dhcli.notation.scope import Scope
from dhcli.notation.screens import LONGEST, equations, plain, with_factor
from dhcli.notation.writer import write
from tests.row_by_row import row_by_row

ROBOT = Scope(joints=("theta1", "theta2"), lengths=("a1", "a2", "a_i"), angles=("theta_i",))
ARRAY = r"\begin{array}{cc} c_{12} & -s_{12} \\ s_{12} & c_{12} \end{array}"


def matrix(text: str) -> list[list[str]]:
    """A pasted matrix as it is read."""
    return [[write(cell.expr) for cell in row] for row in parse_matrix(without_label(text), ROBOT)]


@row_by_row(
    ("text", "read"),
    [
        ("r_{11} = c_{12}", "c12"),
        ("p_{x} = a_1 c_1 + a_2 c_{12}.", "a1*c1 + a2*c12"),
        ("p_x = a_1 c_1,", "a1*c1"),
        ("^{1}r_{11} &= c_{12}, \\\\", "c12"),
        ("{}_{2}^{0}p_x = a_{1}c\\theta_{1}", "a1*c1"),
        ("$$r_{11} = c_{12}.$$", "c12"),
        ("\\[ r_{11} = c_{12} \\]", "c12"),
        ("\\begin{equation} r_{11} = c_{12} \\label{eq:1} \\end{equation}", "c12"),
        ("c_{12} \\quad (2.21)", "c12"),
        ("a_{i}c\\theta_{i}", "a_i*cos(theta_i)"),
        ("a_{i}s\\theta_{i}", "a_i*sin(theta_i)"),
        ("a_1c(\\theta 1 + \\theta 2)", "a1*c12"),
        ("a1.*c1 + a2./2", "a1*c1 + a2/2"),
        ("c1.^2", "c1^2"),
        ("a1^{*}c_1", "a1*c1"),
        ("c_{\\theta_i}", "cos(theta_i)"),
        ("5.", "5"),
    ],
)
def test_one_entry_is_read_as_it_is_printed(text: str, read: str) -> None:
    """With its name, its index and the stop at its end."""
    assert write(parse(without_label(text), ROBOT)) == read


@row_by_row(
    "text",
    [
        ARRAY,
        rf"\left({ARRAY}\right)",
        rf"\left[{ARRAY}\right].",
        rf"T = \left({ARRAY}\right),",
        rf"{{}}_{{2}}^{{0}}T = {{}}_{{1}}^{{0}}T {{}}_{{2}}^{{1}}T = {ARRAY}",
        rf"^0T_2 = A_1 A_2 = {ARRAY}.",
        rf"\begin{{aligned}} R(z, \theta) &= {ARRAY}. \end{{aligned}} \tag{{2.6}}",
        "\\begin{align*}\nR &= " + ARRAY + "\n\\end{align*}",
        ARRAY.replace("\\\\", "\\\\[2pt]"),
        ARRAY.replace("\\\\", "\\\\ [-0.5 ex]"),
        ARRAY.replace(" & ", ", & "),
        "⎡ c12  -s12 ⎤\n⎣ s12   c12 ⎦",
    ],
)
def test_a_matrix_is_read_whatever_a_paper_sets_around_it(text: str) -> None:
    """Brackets that grow, labels with products, display environments, room between rows."""
    assert matrix(text) == [["c12", "-s12"], ["s12", "c12"]]


@row_by_row(
    ("text", "cells"),
    [
        (r"\frac{1}{\sqrt{2}}\begin{bmatrix} 1 & -1 \\ 1 & 1 \end{bmatrix}", ["sqrt(2)/2", "-sqrt(2)/2"]),
        (r"R = \frac{1}{\sqrt{2}} \cdot \begin{bmatrix} 1 & -1 \\ 1 & 1 \end{bmatrix}.", ["sqrt(2)/2", "-sqrt(2)/2"]),
        (r"\begin{bmatrix} 0{,}866 & -12{,}5 \\ 1{,}5 & 0{,}5 \end{bmatrix}", ["0.866", "-12.5"]),
        (r"10^{-2}\begin{bmatrix} 86.6 & -50 \\ 50 & 86.6 \end{bmatrix}", ["0.866", "-1/2"]),
        (r"\begin{bmatrix} 1 & -1 \\ 1 & 1 \end{bmatrix}\cdot\frac{1}{\sqrt{2}}", ["sqrt(2)/2", "-sqrt(2)/2"]),
        ("[1 -1; 1 1]/sqrt(2)", ["sqrt(2)/2", "-sqrt(2)/2"]),
        ("0.5*[c1 -s1; s1 c1]", ["0.5*c1", "-0.5*s1"]),
        ("a1*[c1 -s1; s1 c1]", ["a1*c1", "-a1*s1"]),
        ("np.array([[1, -1], [1, 1]])/2", ["1/2", "-1/2"]),
        ("T =\n\n   1.0e+03 *\n\n    0.5000   -0.0010\n    0.0010    0.5000\n", ["500", "-1"]),
    ],
)
def test_a_factor_goes_to_every_cell(text: str, cells: list[str]) -> None:
    """Before the matrix or behind it; MATLAB's common factor above it."""
    assert matrix(text)[0] == cells


def test_a_factor_is_one_only_where_it_can_be_nothing_else() -> None:
    """Not the number of an equation, not a bracket in a row, not a second matrix."""
    assert matrix(r"\begin{bmatrix} 1 & 2 \\ 3 & 4 \end{bmatrix} \quad (2.21)") == [["1", "2"], ["3", "4"]]
    assert matrix("1 [a1 + a2] 3\n4 5 6") == [["1", "a1 + a2", "3"], ["4", "5", "6"]]
    with pytest.raises(NotationError):
        parse_matrix("[1 2; 3 4] [1 0; 0 1]", ROBOT)
    with pytest.raises(NotationError):
        parse_matrix("[1 2; 3 4]^2", ROBOT)


@pytest.mark.parametrize("sign", ["^T", "^{T}", "^\\top", r"^{\top}", "'"])
def test_rows_are_columns_where_a_transposition_stands_behind(sign: str) -> None:
    """As it is meant; a factor may stand with it."""
    assert matrix(f"[1 2; 3 4]{sign}") == [["1", "3"], ["2", "4"]]
    assert matrix(f"[1 2 3]{sign}") == [["1"], ["2"], ["3"]]
    assert matrix(f"10*[1 2; 3 4]{sign}") == [["10", "30"], ["20", "40"]]


def test_a_unit_behind_a_matrix_is_in_each_cell_and_can_be_told_apart() -> None:
    """A pose has directions, which have no unit, beside its lengths."""
    (cell, _), _ = parse_matrix("[1 2; 3 4] mm", ROBOT)
    assert (str(cell.expr), str(cell.own)) == ("mm", "1")
    (cell, _), _ = parse_matrix("[1 2; 3 4]/2", ROBOT)
    assert (str(cell.expr), str(cell.own)) == ("1/2", "1/2")


HEADING = "T_02 of planar-2r: frame 2 seen from frame 0\nstandard DH · c12 = cos(theta1+theta2)\n"


def test_what_dhcli_prints_for_people_is_read_without_its_heading() -> None:
    """And with the brackets of `--let` in the place of their names, each in terms of those before it."""
    assert matrix(HEADING + "⎡ c12  -s12 ⎤\n⎣ s12   c12 ⎦\nx' points along +y") == [["c12", "-s12"], ["s12", "c12"]]
    lets = HEADING + "let k1 = a1 + a2\nlet k2 = k1*c1 - a1\n⎡ k2  -k1*s1 ⎤\n⎣ 0   k12     ⎦"
    assert without_label(lets) == "⎡ ((a1 + a2)*c1 - a1)  -(a1 + a2)*s1 ⎤\n⎣ 0   k12     ⎦"
    doubling = "let k1 = a1 + a1\n" + "".join(f"let k{n} = k{n - 1} + k{n - 1}\n" for n in range(2, 40)) + "[k39]"
    assert len(plain(doubling)) <= LONGEST


def test_a_list_of_entries_may_have_blank_lines_stops_and_ampersands() -> None:
    """As papers set equations under each other."""
    names = [f"r{i}{j}" for i in "123" for j in "123"]
    cells = [f"{name[1]}*a1" if name != "r11" else "c1" for name in names]
    for between, before, after in (
        ("\n\n", "", ""),
        (".\n\n\n", "", "."),
        (", \\\\\n", "\\begin{array}{rcl}", ".\\end{array}"),
    ):
        text = before + between.join(f"^{{0}}{name} &= {cell}" for name, cell in zip(names, cells, strict=True)) + after
        rows = parse_matrix(rows_of(text, (3, 3)), ROBOT)
        assert write(rows[0][0].expr) == "c1"
        assert write(rows[2][1].expr) == "3*a1"
    with pytest.raises(EntriesError, match="r33 is missing"):
        rows_of("\n\n".join(f"{name} = 1" for name in names[:-1]), (3, 3))


def test_three_lines_are_a_column_whatever_braces_stand_in_them() -> None:
    """`c_{12}` and blanks, one coordinate a line."""
    from dhcli.checking.vectors import as_column

    for text in (
        "a_1 c_1 + a_2 c_{12}\na_1 s_1 + a_2 s_{12}\n0",
        "a_1 c_1 \\\\ a_1 s_{1} \\\\ 0",
        "a_1 \\theta_{1}\n\n2\n\n0",
    ):
        (row,) = parse_matrix(as_column(text, ROBOT, is_axis=False), ROBOT)
        assert len(row) == 3


@pytest.mark.parametrize(
    "unit",
    [
        " ",
        "\n",
        "=",
        "a = ",
        "$",
        "\\",
        "{",
        "\\begin{array}",
        "let k1 = k1\n",
        "r11 = ",
        "1.0e+03 *\n",
        "0,5 ",
        "k1 k2 ",
        ".",
        "& ",
    ],
)
def test_cleaning_goes_through_a_text_once(unit: str) -> None:
    """A hundred thousand characters of anything; a careless pattern would not end."""
    text = unit * (100_000 // len(unit))
    for clean in (plain, equations, with_factor, without_label):
        assert clean(text) is not None
    try:
        rows_of(text, (4, 4))
    except EntriesError as error:
        assert str(error)
