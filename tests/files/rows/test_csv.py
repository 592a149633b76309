"""Joint values from CSV: headers, units, separators, and cells that are no numbers."""

from __future__ import annotations

import gzip
import math
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhcli.errors import FileError
from dhcli.files.rows.csvrows import CsvRows
from tests.files.rows.tables import bad, read, rows
from tests.row_by_row import row_by_row

pytestmark = pytest.mark.usefixtures("json_by")

ROW = [0.1, 0.2, 0.3]
finite = st.floats(allow_nan=False, allow_infinity=False, width=64)


@row_by_row(
    "content",
    [
        "theta1,theta2,d3\n0.1,0.2,0.3\n",
        "theta1,theta2,d3\n0.1,0.2,0.3",  # no line end after the last row
        "theta1,theta2,d3\r\n0.1,0.2,0.3\r\n",
        "\ufefftheta1,theta2,d3\n0.1,0.2,0.3\n",
        "\n\ntheta1,theta2,d3\n\n0.1,0.2,0.3\n\n",
        "d3,theta1,theta2\n0.3,0.1,0.2\n",
        "θ1,θ₂,d_3\n0.1,0.2,0.3\n",
        "\\theta_1,q2,q3\n0.1,0.2,0.3\n",
        "theta1;theta2;d3\n0.1;0.2;0.3\n",
        "theta1\ttheta2\td3\n0.1\t0.2\t0.3\n",
        "theta1 theta2  d3\n0.1  0.2 0.3\n",
        "# theta1 theta2 d3\n1.0e-01 2.0e-01 3.0e-01\n",  # numpy.savetxt
        '"theta1","theta2","d3"\n"0.1","0.2","0.3"\n',
        " theta1 , theta2 , d3 \n 0.1 , 0.2 , 0.3 \n",
        "theta1[rad],theta2 (rad),d3 [m]\n+.1,2e-1,0.30\n",
        "0.1,0.2,0.3\n",
        "0.1 0.2 0.3\n",
    ],
)
@row_by_row("drops", [False, True])
def test_a_table_is_read_however_it_is_spelled(content: str, drops: bool) -> None:
    """In any order, under any name of a joint, in one piece or in drops."""
    assert read(content, drops=drops).tolist() == [ROW]


@row_by_row(
    ("content", "degrees", "expected"),
    [
        ("theta1[deg],theta2[°],d3[mm]\n180,90,250\n", False, [math.pi, math.pi / 2, 0.25]),
        ("theta1[deg] theta2 [deg] d3 [cm]\n180 90 25\n", False, [math.pi, math.pi / 2, 0.25]),
        ("theta1,theta2[rad],d3[in]\n180,1.5,10\n", True, [math.pi, 1.5, 0.254]),
        ("180,90,0.25\n", True, [math.pi, math.pi / 2, 0.25]),
        ("theta1,theta2,d3\n180,90,0.25\n", True, [math.pi, math.pi / 2, 0.25]),
    ],
)
def test_units_stand_in_the_header(content: str, degrees: bool, expected: list[float]) -> None:
    """Bare columns are radians and metres, or degrees with `--deg`, which never turns a length."""
    assert read(content, degrees=degrees)[0] == pytest.approx(expected, rel=1e-15)


@pytest.mark.parametrize("content", ["theta1,theta2,d3\n", "theta1,theta2,d3", "\ntheta1,theta2,d3\n\n\n"])
def test_a_header_alone_is_a_table_of_no_rows(content: str) -> None:
    """And no error."""
    assert len(read(content)) == 0


@pytest.mark.parametrize("content", ["", "\n\n", "  \n"])
def test_nothing_at_all_is_no_table(content: str) -> None:
    """The program before in the pipe has failed, most likely."""
    with pytest.raises(FileError, match="is empty"):
        read(content)


@row_by_row(
    ("header", "said"),
    [
        (
            "theta1,theta2",
            ["q.csv:1: no column for d3 (wanted: theta1[rad], theta2[rad], d3[m]; --q d3=0 if it stands still)"],
        ),
        (
            "tetha1,theta2,d33",
            [
                "q.csv:1:1: scara has no joint tetha1 (did you mean theta1 or theta2?)",
                "q.csv:1:15: scara has no joint d33 (did you mean d3?)",
                "q.csv:1: no column for theta1, d3 (wanted: theta1[rad], theta2[rad], d3[m])",
            ],
        ),
        ("theta1,theta2,d3,q1", ["q.csv:1:18: theta1 has two columns (keep one of them)"]),
        (
            ",theta1,theta2,d3",
            [
                (
                    "q.csv:1:1: a column has no name "
                    "(a column of row numbers? pandas leaves it out with index=False; --ignore-columns leaves it aside)"
                ),
            ],
        ),
        (
            "theta1[mm],theta2,d3[deg]",
            [
                "q.csv:1:1: mm is a unit of length, and theta1 is an angle (write theta1[deg])",
                "q.csv:1:19: deg is a unit of angle, and d3 is a length (write d3[mm])",
            ],
        ),
        ("theta1[grad],theta2,d3", ["q.csv:1:1: grad is no unit (did you mean rad?)"]),
        (
            "theta1[deg,theta2,d3",
            [
                "q.csv:1:1: 'theta1[deg' is not read as a column (write theta1 or theta1[deg])",
                "q.csv:1: no column for theta1 (wanted: theta1[rad], theta2[rad], d3[m])",
            ],
        ),
    ],
)
def test_everything_wrong_with_a_header_is_told_at_once(header: str, said: list[str]) -> None:
    """With the column of each name and the nearest that is right."""
    with pytest.raises(FileError) as caught:
        read(f"{header}\n1,2,3\n")
    assert [str(problem) for problem in caught.value.problems] == said


@row_by_row(
    ("row", "said"),
    [
        ("0.1,abc,0.3", ["q.csv:3:5: theta2 'abc' is not a number (a cell is a plain number, such as -0.25 or 1e-3)"]),
        ("0.1, ,0.3", ["q.csv:3:6: theta2 is empty"]),
        (
            "nan,0.2,-inf",
            ["q.csv:3:1: theta1 'nan' is not a finite number", "q.csv:3:9: d3 '-inf' is not a finite number"],
        ),
        ("0.1,1e999,0.3", ["q.csv:3:5: theta2 '1e999' is too large"]),
        (
            "0.1,30deg,0.3",
            ["q.csv:3:5: theta2 '30deg' is not a number (the unit stands once, in the header: [deg])"],
        ),
        (
            "0.1,1_000,0.3",
            ["q.csv:3:5: theta2 '1_000' is not a number (a cell is a plain number, such as -0.25 or 1e-3)"],
        ),
        ("0.1,١,0.3", ["q.csv:3:5: theta2 '١' is not a number (a cell is a plain number, such as -0.25 or 1e-3)"]),
        (
            "0.1,pi/2,0.3",
            ["q.csv:3:5: theta2 'pi/2' is not a number (a cell is a plain number, such as -0.25 or 1e-3)"],
        ),
        ('0.1,"0,2",0.3', ["q.csv:3:6: theta2 '0,2' is not a number (write 0.2, with a point)"]),
        ('"' + "1" * 140_000, ["q.csv:3: 1 cell in a table of 3 columns (a quote is not closed)"]),
        ('"0.1,0.2,0.3', ["q.csv:3: 1 cell in a table of 3 columns (a quote is not closed)"]),
        ("0.1,0.2", ["q.csv:3: 2 cells in a table of 3 columns"]),
        ("0.1,0.2,0.3,,", ["q.csv:3: 5 cells in a table of 3 columns"]),
        ("0.1,0.2,", ["q.csv:3:9: d3 is empty"]),
    ],
)
def test_a_bad_cell_is_named_by_line_column_and_joint(row: str, said: list[str]) -> None:
    """The rows around it are read."""
    content = f"theta1,theta2,d3\n1,2,3\n{row}\n4,5,6\n"
    assert bad(content) == said
    assert read(content).tolist() == [[1, 2, 3], [4, 5, 6]]


@row_by_row("separator", [";", "\t"])
@row_by_row("header", ["", "theta1;theta2;d3\n"])
@row_by_row("last", ["", "x;0,2;0,3\n"])
def test_decimal_commas_are_read_where_no_comma_stands_between_cells(separator: str, header: str, last: str) -> None:
    """As spreadsheets write them in half of Europe; at once and cell by cell."""
    content = f"{header}0,1;0,2;,3\n-1;2,;3,5e-1\n{last}".replace(";", separator)
    assert read(content).tolist() == [[0.1, 0.2, 0.3], [-1, 2, 0.35]]


def test_a_comma_beside_a_point_may_group_thousands() -> None:
    """So that nobody knows what it means."""
    assert bad("1,234;0.5;1\n") == ["q.csv:1:1: theta1 '1,234' is not a number (write 1.234, with a point)"]
    assert bad("1.234,5;0;1\n") == [
        "q.csv:1:1: theta1 '1.234,5' is not a number (write 1234.5: nothing stands between thousands)"
    ]


@pytest.mark.parametrize(
    ("row", "said"),
    [
        ("0,5;1.2;0,3", "q.csv:2:5: theta2 '1.2' has a point, and others here a comma (write 1,2)"),
        (
            "0,5;1.234,5;2",
            "q.csv:2:5: theta2 '1.234,5' is not a number (write 1234.5: nothing stands between thousands)",
        ),
        (
            "0,5;1,234.5;2",
            "q.csv:2:5: theta2 '1,234.5' is not a number (write 1234.5: nothing stands between thousands)",
        ),
    ],
)
def test_the_cell_that_is_unlike_the_others_is_the_wrong_one(row: str, said: str) -> None:
    """Where decimals have commas, those are right, and the point is what should not be there."""
    around = "0,1;0,2;0,3\n"
    assert bad(f"{around}{row}\n{around}") == [said]


@row_by_row(
    ("header", "row", "said"),
    [
        ("theta1,theta2,d3", "0.5;0.2;0.1", "has semicolons between its cells, and the first line has commas"),
        ("theta1,theta2,d3", "0,5;0,2;0,1", "has semicolons between its cells, and the first line has commas"),
        ("theta1,theta2,d3", "0,5;0;1", "has semicolons between its cells, and the first line has commas"),
        ("theta1;theta2;d3", "0.5,0.2,0.1", "has commas between its cells, and the first line has semicolons"),
        ("theta1 theta2 d3", "1,2,3", "has commas between its cells, and the first line has blanks"),
        ("theta1,theta2,d3", "0.5 0.2 0.1", "has blanks between its cells, and the first line has commas"),
    ],
)
def test_a_row_that_is_parted_otherwise_is_told_as_one(header: str, row: str, said: str) -> None:
    """And no cell of it, for it has none."""
    assert bad(f"{header}\n{row}\n") == [f"q.csv:2: {said} (the same in all lines)"]


def test_two_joints_between_semicolons_are_not_taken_for_two_cells_with_a_comma() -> None:
    """`0,5;1` has one comma, as a row of two cells between commas has."""
    said = "q.csv:2: has semicolons between its cells, and the first line has commas (the same in all lines)"
    assert bad("theta1,theta2\n0,5;1\n", "planar-2r") == [said]


def test_decimal_commas_between_commas_are_asked_about() -> None:
    """Twice as many cells, and all of them whole numbers."""
    said = "6 cells in a table of 3 columns (are there decimal commas? part the cells by semicolons: 0,5;1,2)"
    assert bad("theta1,theta2,d3\n0,5,0,2,0,1\n") == [f"q.csv:2: {said}"]


@pytest.mark.parametrize("header", ["", "theta1 theta2 d3\n"])
def test_decimal_commas_are_read_between_blanks(header: str) -> None:
    """With a header or without one."""
    assert read(f"{header}0,5 0,2 -0,1\n").tolist() == [[0.5, 0.2, -0.1]]


def test_signs_of_a_word_processor_are_read() -> None:
    """A minus that is no hyphen, and a blank at which no line breaks."""
    assert read("theta1,theta2,d3\n\u22120.5,\u00a00.2,0.1\n").tolist() == [[-0.5, 0.2, 0.1]]


@pytest.mark.parametrize(
    ("row", "said"),
    [
        ("theta1,theta2,d3", "is the header once more (take it out)"),
        ("[deg],deg,mm", "holds units, not numbers (they stand in the header: theta1[deg],theta2[deg],d3[mm])"),
    ],
)
def test_a_row_of_words_is_told_as_one(row: str, said: str) -> None:
    """What spreadsheets and files put together have under a header or between rows."""
    assert bad(f"theta1,theta2,d3\n{row}\n1,2,3\n") == [f"q.csv:2: {said}"]


def test_a_row_with_a_cell_too_many_may_keep_its_first_cells() -> None:
    """As an array may, and a list of JSON."""
    for content, path in (("1,2,3,4\n5,6,7,8\n", "q.csv"), ("[1,2,3,4]\n[5,6,7,8]\n", "q.jsonl")):
        assert "--ignore-columns takes the first 3" in bad(content, path=path)[0]
        assert read(content, path=path, ignores=True).tolist() == [[1, 2, 3], [5, 6, 7]]


@pytest.mark.parametrize("content", ["My measurements\n1,2,3\n", "time,x,y\n1,2,3\n"])
def test_a_first_line_without_a_joint_is_told_as_one(content: str) -> None:
    """A title, or the table of something else."""
    with pytest.raises(FileError) as caught:
        read(content)
    assert [str(problem) for problem in caught.value.problems] == [
        "q.csv:1: names no joint of scara (wanted: theta1[rad], theta2[rad], d3[m])"
    ]


@row_by_row(
    "content",
    [
        "# of Monday, run 3\n#\ntheta1,theta2,d3\n0.1,0.2,0.3\n# the end\n",
        "# of Monday\n0.1,0.2,0.3\n",
        "sep=;\ntheta1;theta2;d3\n0,1;0,2;0,3\n",
        '"sep=,"\nTheta1,THETA2,D3\n0.1,0.2,0.3\n',
        "theta1,theta2,d3,\n0.1,0.2,0.3,\n",
        "theta1,theta2,d3\n0.1,0.2,0.3,\n",
        "0.1,0.2,0.3,\n",
        "Q1,Q2,Q3\n0.1,0.2,0.3\n",
    ],
)
@row_by_row("last", ["", "x,y,z\n"])
def test_what_programs_write_around_a_table_is_no_part_of_it(content: str, last: str) -> None:
    """Comments, the separator by its name, one more of it in each line, capital letters."""
    assert read(content + last).tolist() == [ROW]


def test_a_first_row_with_units_is_no_header() -> None:
    """What is wrong with it is said cell by cell."""
    assert bad("30°,20°,100mm\n") == [
        "q.csv:1:1: theta1 '30°' is not a number (the unit stands once, in the header: [°])",
        "q.csv:1:5: theta2 '20°' is not a number (the unit stands once, in the header: [°])",
        "q.csv:1:9: d3 '100mm' is not a number (the unit stands once, in the header: [mm])",
    ]


@pytest.mark.parametrize("stamp", ["7", "2026-11-26T10:00"])
def test_columns_of_something_else_may_be_left_aside(stamp: str) -> None:
    """Numbers or text, in front or behind; asked for, for a name may as well be misspelled."""
    content = f"time,theta1,theta2,d3,id\n{stamp},0.1,0.2,0.3,{stamp}\n"
    assert read(content, ignores=True).tolist() == [ROW]
    with pytest.raises(FileError, match=r"scara has no joint time .*--ignore-columns leaves aside what is no joint"):
        read(content)
    with pytest.raises(FileError, match="no column for theta1"):
        read("tetha1,theta2,d3\n1,2,3\n", ignores=True)


def test_the_numbers_of_rows_that_dhcli_writes_are_left_aside(tmp_path: Path) -> None:
    """`ik --rows` and `--index` put them in front; a joint of that name keeps its column."""
    assert read("row,theta1,theta2,d3\n2,0.1,0.2,0.3\n").tolist() == [ROW]
    oar = tmp_path / "oar.yaml"
    oar.write_text(
        "format: 1\ntitle: An oar\nsource: a test\nconvention: standard\n"
        "variables: [row]\nlinks: [{a: 1, alpha: 0, d: 0, theta: row}]\n",
        "utf-8",
    )
    assert read("row\n0.5\n", robot=str(oar)).tolist() == [[0.5]]


def test_the_positions_that_sweep_writes_are_left_aside(tmp_path: Path) -> None:
    """All three together only; joints of that name keep their columns."""
    assert read("theta1,theta2,d3,p_x,p_y,p_z\n0.1,0.2,0.3,7,8,9\n").tolist() == [ROW]
    with pytest.raises(FileError, match="scara has no joint p_x"):
        read("theta1,theta2,d3,p_x,p_y\n0.1,0.2,0.3,7,8\n")
    gantry = tmp_path / "gantry.yaml"
    gantry.write_text(
        "format: 1\ntitle: A gantry\nsource: a test\nconvention: product\nvariables: [p_x, p_y, p_z]\n"
        'links: ["Trans(p_x, 0, 0)", "Trans(0, p_y, 0)", "Trans(0, 0, p_z)"]\n',
        "utf-8",
    )
    assert read("p_x,p_y,p_z\n0.5,0.6,0.7\n", robot=str(gantry)).tolist() == [[0.5, 0.6, 0.7]]


def test_a_joint_without_a_column_may_stand_still() -> None:
    """With a header or none; it must not have a column as well."""
    held = {"theta2": 0.2}
    assert read("d3[cm],theta1\n30,0.1\n", held=held).tolist() == [ROW]
    assert read("0.1,0.3\n", held=held).tolist() == [ROW]
    with pytest.raises(FileError, match="theta2 has a column, and --q gives it too"):
        read("theta1,theta2,d3\n1,2,3\n", held=held)


def test_no_header_is_made_of_a_row_with_a_bad_cell() -> None:
    """A name is never a number, and a row has at least one."""
    assert bad("0.1,abc,0.3\n1,2,3\n") == [
        "q.csv:1:5: theta2 'abc' is not a number (a cell is a plain number, such as -0.25 or 1e-3)"
    ]


def test_of_many_bad_cells_the_first_twenty_are_told() -> None:
    """But all rows are counted."""
    [block] = rows("theta1,theta2,d3\n" + "x,y,z\n" * 1000).blocks()
    assert (len(block.bad), block.bad_rows) == (20, 1000)


def test_lines_are_counted_across_blocks() -> None:
    """Blank lines too."""
    content = "theta1,theta2,d3\n" + "1,2,3\n\n" * 60_000 + "1,x,3\n"
    assert bad(content) == [
        "q.csv:120002:3: theta2 'x' is not a number (a cell is a plain number, such as -0.25 or 1e-3)"
    ]


@given(st.lists(st.tuples(finite, finite, finite), min_size=1, max_size=8))
def test_what_repr_writes_is_read_to_the_last_bit(values: list[tuple[float, ...]]) -> None:
    """At once, or cell by cell where a bad row stands beside them."""
    lines = "".join(",".join(map(repr, row)) + "\n" for row in values)
    assert read(lines).tolist() == [list(row) for row in values]
    assert read(lines + "1,2\n").tolist() == [list(row) for row in values]


@pytest.mark.parametrize("separator", [",", ";", " "])
@given(st.lists(st.text('0123456789+-.eE, ;\t"x_naif\n', max_size=12), min_size=1, max_size=6))
def test_a_block_is_read_at_once_only_as_it_would_be_line_by_line(separator: str, lines: list[str]) -> None:
    """The quick way and the careful way are one."""
    text = "\n".join(lines) + "\n"
    reader = rows("")
    assert isinstance(reader, CsvRows)
    columns, _ = reader._columns(separator.join("000"), 1)
    assert columns is not None
    quick, careful = reader._block(1, text, columns), reader._line_by_line(1, text, columns)
    assert quick.values.tolist() == careful.values.tolist()
    assert list(quick.rows) == list(careful.rows)
    assert (quick.bad, quick.bad_rows) == (careful.bad, careful.bad_rows)


@row_by_row(
    ("content", "said"),
    [
        ("théta1,theta2,d3\n".encode("latin-1"), "q.csv:1:3: is not UTF-8: byte 3 is 0xE9"),
        (b"theta1,theta2,d3\n1,2,3\n1,\xb02,3\n", "q.csv:3:3: is not UTF-8: byte 26 is 0xB0"),
        ("theta1,theta2,d3\n".encode("utf-16"), "is written in UTF-16"),
        ("theta1,theta2,d3\n".encode("utf-16-le"), "is written in UTF-16"),
        (b"theta1,theta2,d3\n1,\0,2\n", "is not a text file: byte 20 is NUL"),
        (b"PK\x03\x04\0\0\0", "is a ZIP archive, as .xlsx and .npz are"),
        (gzip.compress(b"theta1,theta2,d3\n1,2,3\n", mtime=0), "is compressed by gzip"),
        (b"1" * 3_000_000, "q.csv:1: this line is longer than 262,144 bytes"),
    ],
)
def test_what_is_no_text_is_refused(content: bytes, said: str) -> None:
    """A spreadsheet, a table in another encoding, or one endless line."""
    with pytest.raises(FileError) as caught:
        read(content)
    assert said in str(caught.value)


def test_a_robot_of_one_joint_has_one_column() -> None:
    """Without anything between cells."""
    assert read("theta_i [deg]\n180\n90\n", "dh-link") == pytest.approx(np.array([[math.pi], [math.pi / 2]]))
