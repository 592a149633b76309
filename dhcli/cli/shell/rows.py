"""Handing over rows of numbers as they are computed: to a file that appears whole, or to stdout."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any, BinaryIO

from dhcli.cli.shell.console import raw_out, somebody_reads, tell, write_out
from dhcli.cli.shell.delivery import check_free, check_overwrite
from dhcli.errors import DhcliError, UnknownNameError, plural
from dhcli.frozen import frozen
from dhcli.render.code.rows import FORMATS, Layout, RowText
from dhcli.render.endings import check_ending, format_by_ending, meant

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray


class RowSink:
    """Takes rows.

    Attributes:
        count: Rows taken so far.
        spell: What makes of a block of rows, shape (N, width), what is written of them; another process may do it.
    """

    def __init__(
        self, spell: Callable[[NDArray[np.float64]], Any], put: Callable[[Any], None], *, printed: bool
    ) -> None:
        """Hand every block on.

        Args:
            spell: What makes of a block what is written.
            put: What writes it.
            printed: Whether it goes to stdout, whose reader may go away.
        """
        self.count = 0
        self.spell = spell
        self._put = put
        self._printed = printed

    @property
    def wanted(self) -> bool:
        """Whether anybody still reads what is written."""
        return not self._printed or somebody_reads()

    def write(self, block: NDArray[np.float64]) -> None:
        """Take rows, shape (N, width)."""
        self.take(self.spell(block), len(block))

    def take(self, spelled: Any, count: int) -> None:  # noqa: ANN401  text or an array
        """Take so many rows that are spelled already."""
        self._put(spelled)
        self.count += count


@frozen
class RowDelivery:
    """How a person wants rows.

    Attributes:
        format: The format asked for; None leaves it to the file's ending, and else takes CSV.
        output: The file to write; None for stdout.
        overwrite: Whether that file may be overwritten.
    """

    format: str | None = None
    output: str | None = None
    overwrite: bool = False

    @property
    def is_away(self) -> bool:
        """Whether the rows go elsewhere than to the terminal, where they would run through a bar."""
        return self.output is not None or not sys.stdout.isatty()

    def chosen(self) -> str:
        """The format, once everything that can be known before the work has been looked at.

        Raises:
            UnknownNameError: There is no such format or ending.
            DhcliError: The file ends as one in another format does, a terminal would show bytes, or `--overwrite`
                has no file.
            FileError: The file exists already.
        """
        check_overwrite(self.output, overwrite=self.overwrite)
        if self.format is not None and self.format not in FORMATS:
            hint = "jsonl has one object a row" if self.format == "json" else meant(self.format, FORMATS)
            raise UnknownNameError(f"there is no format {self.format} for rows", hint)
        name = self.format or format_by_ending(self.output or "stdout.csv", FORMATS, of=" of rows")
        check_ending(self.output, name, "--format", FORMATS)
        if self.output is not None:
            check_free(self.output, overwrite=self.overwrite)
        elif name == "npy" and sys.stdout.isatty():
            raise DhcliError("npy is not for a terminal", "write it to a file with -o poses.npy, or into a pipe")
        return name

    @contextmanager
    def open(self, layout: Layout) -> Iterator[RowSink]:
        """Where to put the rows; the file is there when all of them are written, else not at all.

        Raises:
            FileError: It cannot be written.
        """
        name = self.chosen()
        if self.output is None:
            with _sink(name, layout) as sink:
                yield sink
            return
        from dhcli.storage.atomic import whole_file

        with (
            whole_file(self.output, overwrite=self.overwrite) as stream,
            _sink(name, layout, stream) as sink,
        ):
            yield sink
        tell(f"wrote {self.output}: {plural(sink.count, 'row')}")


@contextmanager
def _sink(name: str, layout: Layout, stream: BinaryIO | None = None) -> Iterator[RowSink]:
    """Rows in a format, in a file or on stdout."""
    if name == "npy":
        from dhcli.files.rows.npy import NpyWriter

        with NpyWriter(stream or raw_out(), layout.shape or (layout.width,)) as writer:
            yield RowSink(_as_it_is, writer.write, printed=stream is None)
        return
    text = RowText(layout, name)

    def put(lines: str) -> None:
        if stream is not None:
            stream.write(lines.encode("utf-8"))
            return
        write_out(lines)
        sys.stdout.flush()  # rows show as they come, and a reader that has gone away is noticed

    def put_rows(lines: str) -> None:
        # The heading comes with the first rows: work that fails before there are any leaves stdout empty.
        put(lines if sink.count else text.heading + lines)

    sink = RowSink(text.lines, put_rows, printed=stream is None)
    yield sink
    if not sink.count:
        put(text.heading)


def _as_it_is(block: NDArray[np.float64]) -> NDArray[np.float64]:
    return block
