"""Poses in files, as `ik --rows` reads them: whole blocks at once, and the same row by row."""

from __future__ import annotations

import gzip
import io
import json
from unittest.mock import patch

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhcli.errors import FileError
from dhcli.files.rows import MATRIX, TURNS, csvrows
from dhcli.files.rows import poses as reading
from dhcli.files.rows.blocks import Block
from dhcli.files.rows.poses import BLOCK, pose_rows
from dhcli.files.rows.source import Source
from dhcli.geometry.euler import EulerAngles, Order
from dhcli.geometry.many import table
from dhcli.kinematics.placement import ORIENTATIONS
from dhcli.kinematics.pose import Pose
from tests.files.rows.tables import saved
from tests.row_by_row import row_by_row

pytestmark = pytest.mark.usefixtures("json_by")

finite = st.floats(allow_nan=False, allow_infinity=False)
POSITIONS = st.tuples(finite, finite, finite)
MATRICES = st.lists(st.tuples(finite, finite, finite, finite), min_size=3, max_size=4)
csv_lines = st.one_of(
    POSITIONS.map(lambda row: ",".join(map(repr, row))), st.text('0123456789+-.eE, "x_naif\r', max_size=9)
)
json_lines = st.one_of(
    POSITIONS.map(lambda row: json.dumps({"position": row})),
    MATRICES.map(lambda rows: json.dumps({"row": 3, "matrix": rows})),
    st.sampled_from(
        [
            '{"matrix": [1, 2], "position": [1, 2, 3]}',
            '{"position": [1, 2, null]}',
            '{"position": [1, true, "3"]}',
            '{"position": [1, 2, false]}',
            '{"matrix": [[1, 0, 0, true], [0, 1, 0, 2], [0, 0, 1, 3]]}',
            '{"position": [1, 2, NaN]}',
            '{"position": [1, 2, 1e999]}',
            f'{{"position": [1, 2, 1{"0" * 400}]}}',
            '{"position": [1, 2, 3]},{"position": [4, 5, 6]}',
            '{"position": [1, 2, 3], "more": [{}',
            '{}], "position": [1, 2, 3]}',
            '{"position": [1, 2, 3], "position": [4, 5, 6]}',
            '{"position": [1, 2], "name": "}"}',
            '{"matrix": ' + "[" * 2000 + "}",
            "[1, 2, 3]",
            "{}",
            "",
        ]
    ),
)


def blocks(content: str | bytes, path: str = "-", *, whole: bool = True) -> list[Block]:
    """The blocks of a file of this content."""
    stream = io.BytesIO(content.encode() if isinstance(content, str) else content)
    return list(pose_rows(Source(path, stream), whole=whole).blocks())


def read(text: str) -> tuple[list[tuple[int, object]], list[str]]:
    """Where each pose stands, and it; and what is wrong with the others."""
    found, bad = list[tuple[int, object]](), list[str]()
    for block in blocks(text):
        found += zip(block.rows, block.values.tolist(), strict=True)
        bad += map(str, block.bad)
    return found, bad


def carefully(text: str) -> tuple[list[tuple[int, object]], list[str]]:
    """The same with an eye on every row."""
    with (
        patch.multiple(reading, BLOCK=3, _objects_at_once=lambda _: None),
        patch.object(csvrows, "plain_table", lambda *_: None),
    ):
        return read(text)


@given(st.lists(csv_lines, max_size=9), st.sampled_from(["\n", "\r\n"]), st.booleans())
def test_a_block_of_csv_is_read_at_once_only_as_it_would_be_row_by_row(lines: list[str], end: str, ends: bool) -> None:
    """In blocks of any length."""
    text = end.join(["p_x,p_y,p_z", *lines]) + end * ends
    with patch.object(reading, "BLOCK", 4):
        assert repr(read(text)) == repr(carefully(text))  # NaN is none the less the same


@given(st.lists(json_lines, max_size=9), st.sampled_from(["\n", "\r\n"]))
def test_a_block_of_json_is_read_at_once_only_as_it_would_be_row_by_row(lines: list[str], end: str) -> None:
    """Lines that only make sense together are no rows."""
    text = end.join(['{"position": [0, 0, 0]}', *lines])
    with patch.object(reading, "BLOCK", 4):
        assert repr(read(text)) == repr(carefully(text))


@given(st.lists(MATRICES, min_size=1, max_size=4))
def test_what_is_written_is_read_to_the_last_bit(matrices: list[list[tuple[float, ...]]]) -> None:
    """Columns in any order, among others; matrices with their last row or without."""
    numbers = [[x for row in rows[:3] for x in row] for rows in matrices]
    header = ",".join(["row", *MATRIX[::-1]])
    table = "".join(",".join(["7", *map(repr, row[::-1])]) + "\n" for row in numbers)
    lines = "".join(json.dumps({"matrix": rows}) + "\n" for rows in matrices)
    for text, begun in ((f"{header}\n{table}", 2), (lines, 1)):
        found, bad = read(text)
        assert bad == []
        assert [place for place, _ in found] == list(range(begun, begun + len(numbers)))
        poses = np.array([pose for _, pose in found])
        assert poses[:, :3].reshape(-1, 12).tolist() == numbers
        assert poses[:, 3].tolist() == [[0, 0, 0, 1]] * len(numbers)


def test_a_row_is_told_by_its_line_in_any_block() -> None:
    """The rows around it are there."""
    lines = ["0.1,0.2,0.3"] * (2 * BLOCK)
    lines[BLOCK + 5] = "0.1,x,0.3"
    found, bad = read("p_x,p_y,p_z\n" + "\n".join(lines))
    assert [place for place, _ in found] == [k for k in range(2, 2 * BLOCK + 2) if k != BLOCK + 7]
    assert bad == [
        f"standard input:{BLOCK + 7}:5: p_y 'x' is not a number (a cell is a plain number, such as -0.25 or 1e-3)"
    ]


@row_by_row(
    ("line", "said"),
    [
        ('{"position": [1, 2, true]}', "p_z is true, not a number"),
        ('{"matrix": [[1, 0, 0, 1], [0, 1, false, 2], [0, 0, 1, 3]]}', "r23 is false, not a number"),
        ('{"position": [1, 2, null]}', "p_z is null, not a number"),
        ('{"position": [1, "2", 3]}', "p_y is '2', not a number (write it without quotes)"),
        ('{"position": [1, 2, NaN]}', "p_z is nan, not a finite number"),
        ('{"position": [[1], 2, 3]}', "p_x is a list or an object, not a number"),
    ],
)
def test_a_value_that_is_no_number_is_told_wherever_it_stands(line: str, said: str) -> None:
    """Alone, and among rows that are read at once; true is not taken for 1."""
    rows = [json.dumps({"position": [0, 0, 0]})] * 3
    for text in (line, "\n".join([*rows, line]), "\n".join([line, *rows])):
        for way in (read, carefully):
            found, bad = way(text)
            assert len(found) == text.count("\n")
            assert [problem.partition(": ")[2] for problem in bad] == [said]


ROWS = [[0.5, 0.25, -3.0], [1e-3, 7.0, 0.0]]


@row_by_row(
    "text",
    [
        "p_x;p_y;p_z\n0,5;0,25;-3\n1e-3;7;0\n",
        "\ufeffP_X;P_Y;P_Z\r\n0,5;0,25;-3\r\n1e-3;7;0\r\n\r\n",
        "p_x\tp_y\tp_z\n0.5\t0.25\t-3\n0.001\t7\t0\n",
        "sep=;\np_x;p_y;p_z\n0,5;0,25;-3\n0,001;7;0\n",
        "p_z, p_x, p_y,\n-3, 0.5, 0.25,\n, , ,\n0, 0.001, 7,\n",
        'p_x;p_y;p_z\n"0,5";"0,25";"-3"\n0.001;7;0',
    ],
)
def test_a_spreadsheet_writes_the_same_poses_in_many_ways(text: str) -> None:
    """As joint values are: another sign between cells, decimal commas, heads in capitals, blank lines at the end."""
    assert [row for block in blocks(text, "p.csv") for row in block.values.tolist()] == ROWS


def test_a_comma_beside_a_point_is_not_taken_for_a_decimal_one() -> None:
    """It may group thousands; the line is that in the file."""
    found, bad = read("sep=;\np_x;p_y;p_z\n1;2;3\n1,234;0.5;0\n")
    assert found == [(3, [1.0, 2.0, 3.0])]
    assert bad == ["standard input:4:1: p_x '1,234' is not a number (write 1.234, with a point)"]


@row_by_row(
    ("content", "path", "said"),
    [
        ("p_x\tp_y\tp_z\n1\t2\t3\n".encode("utf-16"), "p.csv", "p.csv: is written in UTF-16"),
        (gzip.compress(b"p_x,p_y,p_z\n1,2,3\n", mtime=0), "p.csv", "p.csv: is compressed by gzip"),
        (b"p_x,p_y,p_z\n1,2,\xb03\n", "p.csv", "p.csv:2:5: is not UTF-8"),
        (b"1,2,3\n", "p.csv", "p.csv:1: poses have a header, and this line has numbers"),
        (b"p_x,p_y,P_X[mm],p_z\n1,2,3,4\n", "p.csv", "p.csv:1:9: p_x has two columns (keep one of them)"),
        (b"p_x,p_y,p_z\n1,2,3\n", "p.npy", "p.npy: is no .npy file"),
        (saved(np.zeros((2, 3, 3))), "p.npy", "p.npy: has the shape (2, 3, 3), and (N, 4, 4) or (N, 3) is wanted"),
        (saved(np.zeros((2, 3), complex)), "p.npy", "p.npy: holds complex128, not real numbers"),
        (saved(np.zeros(()))[:-1], "p.npy", "p.npy: has the shape ()"),
    ],
)
def test_what_holds_no_poses_is_called_what_it_is(content: bytes, path: str, said: str) -> None:
    """As where joint values are read."""
    with pytest.raises(FileError) as caught:
        blocks(content, path)
    assert str(caught.value).startswith(said)


@row_by_row("array", [np.arange(48.0).reshape(3, 4, 4), np.arange(9.0).reshape(3, 3)])
@row_by_row("order", ["C", "F"])
def test_arrays_of_poses_are_read_from_any_stream_in_either_order_of_memory(array: np.ndarray, order: str) -> None:
    """Whatever it is called."""
    with patch.object(reading, "BLOCK", 2):
        found = blocks(saved(np.array(array, order=order)))
    assert [row for block in found for row in block.rows] == [0, 1, 2]
    assert np.array_equal(np.concatenate([block.values for block in found]), array)


@pytest.mark.parametrize("form", ["quaternion", "axis-angle"])
def test_an_orientation_without_a_direction_is_a_bad_row(form: str) -> None:
    """The rows around it are poses; the size of the others does not matter."""
    heads = TURNS[form]
    good = ",".join(["1e200"] + ["0"] * (len(heads) - 1))
    none = ",".join(["0"] * len(heads))
    text = f"p_x,p_y,p_z,{','.join(heads)}\n1,2,3,{good}\n1,2,3,{none}\n4,5,6,{good}\n"
    for way in (read, carefully):
        found, bad = way(text)
        assert [place for place, _ in found] == [2, 4]
        assert [np.array(pose)[:3, 3].tolist() for _, pose in found] == [[1, 2, 3], [4, 5, 6]]
        assert np.allclose([np.array(pose)[:3, :3] for _, pose in found], np.eye(3))
        assert bad == [f"standard input:3: {', '.join(heads)} are all 0: that is no {form}"]


@row_by_row("form", TURNS)
def test_columns_of_orientations_are_the_rotations_that_fk_says(form: str) -> None:
    """Many at once, by the formulas for one."""
    rotation = EulerAngles(Order("zyx"), (0.3, -0.4, 0.5)).rotation()
    pose = Pose((*((*row, 0.25 * k) for k, row in enumerate(rotation)), (0.0, 0.0, 0.0, 1.0)))
    numbers = table(ORIENTATIONS["fixed-xyz" if form == "rpy" else form], np.array(pose.rows)[None])[0].tolist()
    text = ",".join(["p_x", "p_y", "p_z", *TURNS[form]]) + "\n" + ",".join(map(repr, [0.0, 0.25, 0.5, *numbers]))
    [(_, found)], _ = read(text)
    assert np.allclose(found, pose.rows)


@pytest.mark.parametrize("way", ["at once", "row by row"])
def test_angles_in_degrees_without_their_unit_are_bad_rows(way: str) -> None:
    """Whichever of them tells; what is within a turn is read, and so is what says its unit."""
    text = "x,y,z,roll,pitch,yaw\n1,2,3,180,0,0\n1,2,3,0.5,0,0\n1,2,3,0,-90,1\n"
    found, bad = (read if way == "at once" else carefully)(text)
    assert [line for line, _ in found] == [3]
    said = "roll, pitch: more than a turn in radians; in degrees the header says so, roll[deg]"
    assert bad == [f"standard input:{line}: {said}" for line in (2, 4)]
    degrees, none = read(text.replace("roll", "roll[deg]").replace("pitch", "pitch[deg]"))
    assert ([line for line, _ in degrees], none) == ([2, 3, 4], [])


@row_by_row(
    ("heads", "hint"),
    [
        ("X,Y,Z,A,B,C", "A, B, C of KUKA are yaw[deg],pitch[deg],roll[deg]"),
        ("X,Y,Z,W,P,R", "W, P, R of FANUC are roll[deg],pitch[deg],yaw[deg]"),
        ("X,Y,Z,O,A,T", "O, A, T of Kawasaki are zyz_1[deg],zyz_2[deg],zyz_3[deg]"),
        ("x,y,z,rx,ry,rz", "rx, ry, rz of Universal Robots are r_x,r_y,r_z, a rotation vector in radians"),
        ("x,y,z,q1,q2,q3,q4", "q1 to q4 of ABB are q_w,q_x,q_y,q_z"),
    ],
)
def test_what_makers_call_an_orientation_is_told_with_our_columns(heads: str, hint: str) -> None:
    """Whose columns they are nobody knows, so they are refused; those of the hint are read."""
    cells = ["1", "2", "3", "0.1", "0.2", "0.3", "0.4"][: heads.count(",") + 1]
    with pytest.raises(FileError, match="says no orientation that is known") as caught:
        blocks(f"{heads}\n{','.join(cells)}\n", "p.csv")
    assert caught.value.problems[0].hint.startswith(hint)
    ours = hint.partition(" are ")[2].split(", ")[0]
    assert len(blocks(f"x,y,z,{ours}\n{','.join(cells)}\n", "p.csv")[0].values) == 1


def test_poses_of_messages_of_ros_are_read() -> None:
    """By what their columns are called in tables of them; a half turn about y."""
    heads = ",".join(f"/pose.{part}" for part in ("position.x", "position.y", "position.z"))
    turned = ",".join(f"/pose/orientation/{part}" for part in "xyzw")
    (block,) = blocks(f"time,{heads},{turned}\n5,1,2,3,0,1,0,0\n", "p.csv")
    expected = [[-1, 0, 0, 1], [0, 1, 0, 2], [0, 0, -1, 3], [0, 0, 0, 1]]
    assert np.allclose(block.values[0], expected)
