"""Rows as text: heads, nesting, and numbers that lose no bit."""

import csv
import io
import json

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhcli.render.code.rows import Group, Layout, RowText
from tests.row_by_row import row_by_row

pytestmark = pytest.mark.usefixtures("json_by")

POSITION = Group.listed("position", ("p_x", "p_y", "p_z"))
RPY = Group.named("rpy", {"roll": "roll", "yaw": "yaw"})
finite = st.floats(allow_nan=False, allow_infinity=False)


def test_csv_has_a_head_for_each_number() -> None:
    """In the order of the groups."""
    text = RowText(Layout((Group("k", ("k",), "%s"), POSITION)), "csv")
    assert text.heading == "k,p_x,p_y,p_z\n"
    assert text.lines(np.array([[1, 0.5, -0.0, 1e-300]])) == "1.0,0.5,0.0,1e-300\n"


def test_json_lines_nest_what_belongs_together() -> None:
    """A list, an object, and groups under one key."""
    text = RowText(Layout((Group("k", ("k",), "%s"), Group.within("T_01", (POSITION, RPY)))), "jsonl")
    assert text.heading == ""
    assert text.lines(np.arange(6.0)[None]) == (
        '{"k": 0.0, "T_01": {"position": [1.0, 2.0, 3.0], "rpy": {"roll": 4.0, "yaw": 5.0}}}\n'
    )


def test_groups_under_one_key_are_told_apart_in_csv() -> None:
    """The heads get the key as a prefix."""
    layout = Layout(tuple(Group.within(key, (POSITION,)) for key in ("T_01", "T_02")))
    assert layout.heads == ("T_01_p_x", "T_01_p_y", "T_01_p_z", "T_02_p_x", "T_02_p_y", "T_02_p_z")
    assert layout.width == 6


@given(st.lists(st.tuples(finite, finite, finite), max_size=5))
@pytest.mark.parametrize("format_", ["csv", "jsonl"])
def test_what_is_read_back_is_what_was_written(format_: str, rows: list[tuple[float, ...]]) -> None:
    """To the last bit, but for the sign of zero; no row is nothing."""
    block = np.array(rows, dtype=float).reshape(-1, 3)
    text = RowText(Layout((POSITION,)), format_).lines(block)
    lines = csv.reader(io.StringIO(text)) if format_ == "csv" else map(json.loads, text.splitlines())
    read = [list(map(float, line if format_ == "csv" else line["position"])) for line in lines]
    assert np.array_equal(np.array(read).reshape(-1, 3), block)


@given(st.lists(st.tuples(finite, finite, finite), min_size=1, max_size=5), st.integers(0, 2**53))
def test_every_number_is_written_as_python_writes_it(rows: list[tuple[float, ...]], first: int) -> None:
    """So that a file is the same whatever is installed; the number of a row without a point."""
    layout = Layout((Group("row", ("row",), "%s", is_whole=True), POSITION))
    block = np.array([(first + k, *row) for k, row in enumerate(rows)], dtype=float)
    cells = [[str(int(row[0])), *(repr(x + 0.0) for x in row[1:])] for row in block.tolist()]
    assert RowText(layout, "csv").lines(block) == "".join(",".join(row) + "\n" for row in cells)
    objects = ('{"row": ' + row[0] + ', "position": [' + ", ".join(row[1:]) + "]}\n" for row in cells)
    assert RowText(layout, "jsonl").lines(block) == "".join(objects)


@row_by_row("key", ["100%", 'a"b', "a,b", "%s", "%r"])
def test_a_name_may_hold_any_letter(key: str) -> None:
    """Also those that steer a template or a format."""
    layout = Layout((Group(key, (key,), "%s"),))
    assert json.loads(RowText(layout, "jsonl").lines(np.array([[1.5]]))) == {key: 1.5}
    heading = RowText(layout, "csv").heading
    assert next(csv.reader(io.StringIO(heading))) == [key]
