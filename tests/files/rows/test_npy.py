"""numpy's own format, row by row: what is written is what numpy reads."""

import io
from pathlib import Path

import numpy as np
import pytest

from dhcli.errors import FileError
from dhcli.files.rows.npy import NpyWriter
from tests.files.rows.tables import read, rows, saved
from tests.row_by_row import row_by_row


class Pipe(io.BytesIO):
    """Bytes that cannot be turned back."""

    def seekable(self) -> bool:
        """No."""
        return False

    def seek(self, *_: int) -> int:
        """Fail as a pipe does."""
        raise io.UnsupportedOperation


@pytest.mark.parametrize("blocks", [[], [0], [1], [3, 0, 5], [100_000, 1]])
def test_numpy_loads_what_was_written_in_blocks(tmp_path: Path, blocks: list[int]) -> None:
    """However many rows there are, none too."""
    rows = np.random.default_rng(1).normal(size=(sum(blocks), 4, 4))
    with (tmp_path / "a.npy").open("wb") as stream, NpyWriter(stream, (4, 4)) as writer:
        for block in np.split(rows, np.cumsum(blocks)[:-1]) if blocks else []:
            writer.write(block.reshape(len(block), 16))
    assert writer.count == sum(blocks)
    read = np.load(tmp_path / "a.npy", allow_pickle=False)
    assert (read.shape, read.dtype) == (rows.shape, np.float64)
    assert np.array_equal(read, rows)


def test_a_pipe_gets_the_same_bytes_at_the_end() -> None:
    """Nothing before, because the header comes first and has the number of rows."""
    pipe, file = Pipe(), io.BytesIO()
    with NpyWriter(pipe, (2,)) as writer:
        writer.write(np.ones((3, 2)))
        assert pipe.getvalue() == b""
    with NpyWriter(file, (2,)) as writer:
        writer.write(np.ones((3, 2)))
    assert pipe.getvalue() == file.getvalue()


def test_a_pipe_gets_nothing_of_work_that_failed() -> None:
    """Half a result is none."""
    pipe = Pipe()

    def work() -> None:
        with NpyWriter(pipe, (2,)) as writer:
            writer.write(np.ones((3, 2)))
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        work()
    assert pipe.getvalue() == b""


def headed(header: str) -> bytes:
    """An array whose header says this."""
    return b"\x93NUMPY\x01\x00" + len(header).to_bytes(2, "little") + header.encode() + bytes(72)


Q = np.random.default_rng(2).normal(size=(5, 3))


@row_by_row("kind", ["<f8", ">f8", "<f4", "<i2", "u1"])
@row_by_row("drops", [False, True])
def test_real_numbers_of_any_kind_are_read(kind: str, drops: bool) -> None:
    """As float64."""
    table = (Q * 9).astype(kind) if "f" in kind else np.abs(Q * 9).astype(kind)
    assert np.array_equal(read(saved(table), drops=drops), table.astype(np.float64))


def test_degrees_turn_the_columns_that_turn() -> None:
    """The prismatic one stays."""
    assert read(saved([[180.0, 90, 1]]), degrees=True) == pytest.approx(np.array([[np.pi, np.pi / 2, 1]]))


def test_blocks_of_a_large_array_are_all_of_it() -> None:
    """More than is read at once, and the second version of the format."""
    table = np.random.default_rng(3).normal(size=(100_000, 3))
    blocks = list(rows(saved(table, (2, 0))).blocks())
    assert len(blocks) > 1
    assert np.array_equal(np.concatenate([block.values for block in blocks]), table)
    assert [block.rows[0] for block in blocks] == np.cumsum([0, *map(len, (b.values for b in blocks))])[:-1].tolist()


def test_rows_are_read_in_either_order_of_memory() -> None:
    """Also none, and a single one."""
    assert read(saved(np.asfortranarray(Q))).tolist() == Q.tolist()
    assert read(saved(np.empty((0, 3)))).shape == (0, 3)
    assert read(saved(np.asfortranarray(Q[:1]))).tolist() == Q[:1].tolist()


def test_numbers_that_are_not_finite_are_named_as_numpy_counts() -> None:
    """Rows from 0; the good ones know where they stand."""
    table = Q.copy()
    table[1, 2], table[3, 0] = np.nan, -np.inf
    [block] = rows(saved(table), path="q.npy").blocks()
    assert [str(problem) for problem in block.bad] == [
        "q.npy[1]: d3 is nan, not a finite number",
        "q.npy[3]: theta1 is -inf, not a finite number",
    ]
    assert (block.bad_rows, list(block.rows)) == (2, [0, 2, 4])
    assert block.values.tolist() == Q[[0, 2, 4]].tolist()


@row_by_row(
    ("content", "said"),
    [
        (saved(Q[:, :2]), "has the shape (5, 2), and scara has 3 joints: (N, 3) is wanted"),
        (saved(Q[0]), "one pose is Q.reshape(1, -1)"),
        (saved(Q[None]), "has the shape (1, 5, 3)"),
        (saved(Q.astype(complex)), "holds complex128, not real numbers"),
        (saved(Q > 0), "holds bool, not real numbers"),
        (saved(Q.astype("U9")), "holds str288, not real numbers"),
        (saved(Q.astype(object)), "holds object, not real numbers"),
        (saved(np.zeros((2, 3), [("a", float)])), "holds records, not real numbers"),
        (saved(np.zeros(2, [("theta1", float), ("d3", float)])), "holds records, not real numbers"),
        (saved(np.asfortranarray(Q))[:-1], "is cut off"),
        (saved(Q)[:-1], "is cut off: it holds 4 of the 5 rows that it promises"),
        (saved(Q)[:40], "is no .npy file that can be read"),
        (b"\x93NUMPY\x09\x00", "is no .npy file that can be read"),
        (headed("{'descr': ("), "is no .npy file that can be read"),
        (headed("{[]: 1}"), "is no .npy file that can be read"),
        (headed("-" * 5000 + "1"), "is no .npy file that can be read"),
        (headed("{'descr': '<,8', 'fortran_order': False, 'shape': (3, 3)}"), "is no .npy file that can be read"),
        (headed("{'descr': '<f8', 'fortran_order': False, 'shape': (-1, 3)}"), "promises -1 rows"),
        (b"0.1,0.2,0.3\n", "is no .npy file"),
        (b"", "is no .npy file"),
    ],
)
def test_what_is_no_table_of_numbers_is_refused(content: bytes, said: str) -> None:
    """With what would be; an object is never unpickled."""
    with pytest.raises(FileError) as caught:
        read(content, path="q.npy")
    assert said in str(caught.value)


def test_columns_behind_the_joints_may_be_left_aside() -> None:
    """As `dhcli sweep` writes them; what is in them does not matter."""
    table = np.concatenate((Q, np.full((5, 3), np.nan)), axis=1)
    assert read(saved(table), path="q.npy", ignores=True).tolist() == Q.tolist()
    assert read(saved(table[:, :4]), path="q.npy", ignores=True, held={"theta2": 7.0})[0].tolist() == [
        Q[0, 0],
        7.0,
        Q[0, 1],
    ]
    with pytest.raises(FileError, match="--ignore-columns takes the first 3 columns"):
        read(saved(table), path="q.npy")
