"""numpy's own format, row by row: what is written is what numpy reads."""

import io
from pathlib import Path

import numpy as np
import pytest

from dhcli.files.rows.npy import NpyWriter


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
