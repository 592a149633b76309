"""Decimal commas become points where they can separate nothing."""

from __future__ import annotations

from hypothesis import assume, given
from hypothesis import strategies as st

from dhcli.notation.commas import LONGEST, comma_remark, with_points
from dhcli.notation.pasted import without_label
from tests.notation.test_screens import matrix
from tests.row_by_row import row_by_row

POSE = "0,866 -0,5 0 1,25\n0,5 0,866 0 -2\n0 0 1 3\n0 0 0 1"
VECTOR, ROWS = (3, 1), (3, 2)


def test_decimal_commas_between_blanks_are_points() -> None:
    """Where three or four numbers stand in each row, nothing else can be meant."""
    rows = matrix(POSE.replace(",", "."))
    assert rows[0] == ["0.866", "-0.5", "0", "1.25"]
    for text in (POSE, POSE.replace("\n", "; "), POSE.replace(" ", "\t"), POSE.replace(" ", ";")):
        assert matrix(without_label(text)) == rows
        assert matrix(without_label(text, (4, 4))) == rows
    latex = POSE.replace(" ", " & ").replace("\n", r" \\ ")
    assert matrix(without_label(rf"\begin{{bmatrix}} {latex} \end{{bmatrix}}")) == rows
    pipes = "\n".join(f"| {line.replace(' ', ' | ')} |" for line in POSE.split("\n"))
    assert (
        matrix(without_label(f"{pipes[: pipes.find(chr(10))]}\n|---|---|---|---|{pipes[pipes.find(chr(10)) :]}"))
        == rows
    )


@row_by_row(
    ("text", "shape"),
    [
        ("0,5 1 2", VECTOR),
        ("0,5; 1; 2", VECTOR),
        ("(0,5; 1; 2) mm", VECTOR),
        ("(0,5 | 1 | 2)", VECTOR),
        ("[0,5 1 2]^T", VECTOR),
        ("0,5\n1\n2", VECTOR),
        ("0,5; 1; 2; 1", VECTOR),
        ("-307,39 mm, 425,30 mm, 0", VECTOR),
        ("0,5*c1 + 0,3*c12; 0,5*s1 + 0,3*s12; 0", VECTOR),
        ("x = 0,5 mm\ny = 1 mm\nz = 2 mm", VECTOR),
        ("0,5 1 2 0", (1, 4)),
        ("0,5 1\n2 3\n4 5", ROWS),
        ("0,5;1\n2;3\n4;5", ROWS),
        ("[0,5 1; 2 3; 4 5] m", ROWS),
        ("0,5 m/s; 0", (2, 1)),
        ("1,2; 3,4", (2, 1)),
    ],
)
def test_the_cells_that_are_wanted_tell(text: str, shape: tuple[int, int]) -> None:
    """With the separators, units, names and brackets that people write."""
    assert with_points(text, shape) == text.replace("0,5", "0.5").replace("0,3", "0.3").replace("7,39", "7.39").replace(
        "5,30", "5.30"
    ).replace("1,2", "1.2").replace("3,4", "3.4")


@row_by_row(
    ("text", "shape"),
    [
        ("0,5 1 2", None),
        ("1, 2, 3\n4, 5, 6", None),
        ("0,5; 1; 2", None),
        ("a,b c d\n0 0 0", None),
        ("[[0,90°,d1,theta1],[a2,0,0,theta2]]", None),
        ("Trans(a, 0,4)", None),
        ("[1,2; c1, 3]", None),
        ("1,2,3", VECTOR),
        ("0,449, 0,4819, 0", VECTOR),
        ("1,2;3,4;5,6", ROWS),
        ("1,2\n3,4\n5,6", ROWS),
        ("a1,2; 3; 4", VECTOR),
        ("atan2(0,5); 1; 2", VECTOR),
        ("c1 0,5 s1", VECTOR),
        ("0,5; 1", VECTOR),
        ("1,2 3", (3, 3)),
        ("0,5 " * LONGEST, VECTOR),
    ],
)
def test_commas_that_may_separate_stay(text: str, shape: tuple[int, int] | None) -> None:
    """Two numbers in each of three rows are what they look like; `0,5` in brackets are arguments."""
    assert with_points(text, shape) == text


@given(st.integers(1, 4), st.integers(1, 4), st.data(), st.sampled_from(["; ", ";", "\n"]))
def test_whole_numbers_between_commas_stay_what_they_are(
    rows: int, columns: int, data: st.DataObject, end: str
) -> None:
    """A matrix that has the shape wanted with its commas as separators keeps them, whatever it may look like."""
    cells = data.draw(st.lists(st.integers(-99, 99), min_size=rows * columns, max_size=rows * columns))
    text = end.join(",".join(map(str, cells[k * columns : (k + 1) * columns])) for k in range(rows))
    assume(columns > 1)
    assert with_points(text, (rows, columns)) == text


def test_what_may_be_a_decimal_comma_is_spoken_of() -> None:
    """In a list of two and more, outside names."""
    assert comma_remark("0,449, 0,4819, 0") == "if 0,449 is one number, write 0.449: decimals take a point"
    assert comma_remark("1, 2, 3") == comma_remark("0,5") == comma_remark("0,5 " * LONGEST) == ""


@row_by_row("unit", ["0,5 ", "0,5;", "(", "\\\\", "0,5\n", " ", "|", "0,5 a", "1,2"])
def test_commas_are_looked_for_once(unit: str) -> None:
    """In two thousand characters of anything."""
    text = "0,5" + unit * ((LONGEST - 3) // len(unit))
    for shape in (None, VECTOR, ROWS, (1, 500)):
        assert with_points(text, shape).replace(".", ",") == text.replace(".", ",")
