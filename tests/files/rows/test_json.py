"""Joint values from JSON Lines: objects by name, lists in joint order."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhcli.errors import FileError
from dhcli.files.rows.jsonrows import JsonRows
from tests.files.rows.tables import bad, read, rows
from tests.row_by_row import row_by_row

pytestmark = pytest.mark.usefixtures("json_by")

finite = st.floats(allow_nan=False, allow_infinity=False)
json_values = st.recursive(
    st.none() | st.booleans() | st.integers(-9, 9) | finite | st.sampled_from(["", "1", "theta1", '"']),
    lambda below: (
        st.lists(below, max_size=3)
        | st.dictionaries(st.sampled_from(["theta1", "q2", "d3", "θ2", "x"]), below, max_size=3)
    ),
    max_leaves=6,
)


@row_by_row(
    "content",
    [
        '{"theta1": 0.1, "theta2": 0.2, "d3": 0.3}\n',
        '{"d3": 0.3, "q1": 0.1, "θ2": 0.2}',
        '\ufeff{"d3": 0.3, "q1": 0.1, "\\u03b82": 0.2}\r\n',
        '{"theta1": 0.1, "theta2": 0.2, "d3[mm]": 300}\n',
        '{"header": {"seq": 1}, "name": ["d3", "theta1", "q2"], "position": [0.3, 0.1, 0.2], "velocity": []}\n',
        "[0.1, 0.2, 0.3]\n",
        "\n  [0.1, 2e-1, 0.30]  \n\n",
        "\n" * 100 + "[0.1, 0.2, 0.3]\n",
    ],
)
@row_by_row("drops", [False, True])
def test_a_row_is_read_however_it_is_spelled(content: str, drops: bool) -> None:
    """In any order, under any name of a joint."""
    assert read(content, drops=drops) == pytest.approx(np.array([[0.1, 0.2, 0.3]]), rel=1e-15)


def test_each_object_may_have_its_own_order_and_units() -> None:
    """As rows of several programs have."""
    content = '{"theta1[deg]": 180, "theta2": 0, "d3": 1}\n{"d3": 2, "q1": 1, "q2": 0}\n[1, 2, 3]\n'
    assert read(content) == pytest.approx(np.array([[math.pi, 0, 1], [1, 0, 2], [1, 2, 3]]))
    assert read("[180, 0, 1]\n", degrees=True) == pytest.approx(np.array([[math.pi, 0, 1]]))


def test_no_rows_are_no_error_where_the_name_says_json() -> None:
    """Unlike a CSV file, which has a header at least."""
    assert len(read("", path="q.jsonl")) == 0


@row_by_row(
    ("row", "said"),
    [
        ("[1, 2]", "q.csv:2: 2 numbers where scara has 3 joints"),
        ("[1, true, 3]", "q.csv:2: theta2 is true, not a number"),
        ("[1, null, 3]", "q.csv:2: theta2 is null, not a number"),
        ('[1, "2", 3]', "q.csv:2: theta2 is '2', not a number (write it without quotes)"),
        ("[1, NaN, 3]", "q.csv:2: theta2 is nan, not a finite number"),
        ("[1, -Infinity, 3]", "q.csv:2: theta2 is -inf, not a finite number"),
        ("[1, 1e999, 3]", "q.csv:2: theta2 is inf, not a finite number"),
        (f"[1, 1{'0' * 400}, 3]", "q.csv:2: theta2 is inf, not a finite number"),
        ('{"theta1": 1, "theta1": 2, "theta2": 0, "d3": 0}', "q.csv:2: theta1 has two columns (keep one of them)"),
        ('{"theta1": 1, "theta2": [2], "d3": 0}', "q.csv:2: theta2 is a list or an object, not a number"),
    ],
)
def test_a_bad_value_is_named_by_line_and_joint(row: str, said: str) -> None:
    """The rows around it are read."""
    content = f"[1, 2, 3]\n{row}\n[4, 5, 6]\n"
    assert bad(content) == [said]
    assert read(content).tolist() == [[1, 2, 3], [4, 5, 6]]


def test_unknown_and_missing_names_are_told_at_once() -> None:
    """As of a header."""
    assert bad('{"theta1": 1, "tetha2": 2}\n') == [
        "q.csv:1: scara has no joint tetha2 (did you mean theta2 or theta1?)",
        "q.csv:1: no column for theta2, d3 (wanted: theta1[rad], theta2[rad], d3[m])",
    ]


@row_by_row(
    "content", ["[[1, 2, 3], [4, 5, 6]]", "[\n  [1, 2, 3],\n  [4, 5, 6]\n]", '[ {"q1": 1}]', '\n{\n"q1": [1, 2]}']
)
def test_one_list_of_rows_is_not_taken_for_lines(content: str) -> None:
    """The last of its rows stands in a line of its own, and would be the only one."""
    with pytest.raises(FileError, match=r"q\.csv: is one list or object, not a row in each line"):
        read(content)


def test_an_object_without_names_has_none_of_the_joints() -> None:
    """And its place is told all the same."""
    assert bad("{}\n") == ["q.csv:1: no column for theta1, theta2, d3 (wanted: theta1[rad], theta2[rad], d3[m])"]


@row_by_row("row", ["[[1, 2, 3], [4, 5, 6]]", "[1, 2, 3],", "[1, 2, 3", "{}x", "[" * 5000, '{"a":', "7"])
def test_what_is_no_row_is_told_with_what_one_looks_like(row: str) -> None:
    """A list over several lines, for one."""
    [said] = bad(f"[1,2,3]\n{row}\n")
    assert said.startswith("q.csv:2")
    assert "JSON Lines has a row in each line" in said


@given(st.lists(st.tuples(finite, finite, finite), min_size=1, max_size=6))
def test_what_json_writes_is_read_to_the_last_bit(values: list[tuple[float, ...]]) -> None:
    """Lists and objects."""
    lists = "".join(json.dumps(row) + "\n" for row in values)
    objects = "".join(json.dumps(dict(zip(("d3", "q1", "q2"), row, strict=True))) + "\n" for row in values)
    assert read(lists).tolist() == [list(row) for row in values]
    assert read(objects).tolist() == [[b, c, a] for a, b, c in values]


@given(st.lists(json_values.map(json.dumps) | st.text('[]{}":, 1theta', max_size=9), min_size=1, max_size=5))
def test_a_block_is_read_at_once_only_as_it_would_be_line_by_line(lines: list[str]) -> None:
    """Lines that only make sense together are no rows; the quick way and the careful way are one."""
    reader = rows("[0,0,0]\n")
    assert isinstance(reader, JsonRows)
    careful = reader._line_by_line(1, lines)
    quick = reader._at_once(1, lines) or careful
    assert quick.values.tolist() == careful.values.tolist()
    assert list(quick.rows) == list(careful.rows)
    assert quick.bad_rows == careful.bad_rows


@pytest.mark.parametrize("lines", [["[1,2,3],[4,5,6]", "[7,[8]", "[9],10]"], ["[1,2,3],[4,5,6]", "[7", "8,9]"]])
def test_lines_that_are_rows_only_together_are_none(lines: list[str]) -> None:
    """As many lines as rows, and still not the same."""
    reader = rows("[0,0,0]\n")
    assert isinstance(reader, JsonRows)
    assert reader._at_once(1, lines) is None


def test_members_of_something_else_may_be_left_aside() -> None:
    """Also where `dhcli sweep` has written the joints into an object of their own."""
    content = '{"t": "10:00", "theta1": 1, "theta2": 2, "d3": 3}\n'
    swept = '{"q": {"theta1": 4, "theta2": 5, "d3": 6}, "position": [1, 2, 3]}\n'
    numbers = '{"t": 7, "theta1": 1, "theta2": 2, "d3": 3}\n'
    assert read(content + swept, ignores=True).tolist() == [[1, 2, 3], [4, 5, 6]]
    assert read(numbers, ignores=True).tolist() == [[1, 2, 3]]
    assert "--ignore-columns" in bad(content)[0]


def test_a_joint_without_a_name_may_stand_still() -> None:
    """In objects and in lists."""
    assert read('{"d3": 3, "theta1": 1}\n[4, 6]\n', held={"theta2": 0.5}).tolist() == [[1, 0.5, 3], [4, 0.5, 6]]
    assert read("[4, 6]\n", held={"theta2": 0.5}).tolist() == [[4, 0.5, 6]]
