"""Reading joint values from a file of any length: which format it has shows in its first bytes."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Protocol

from dhcli.errors import FileError, Place, Problem
from dhcli.files.rows.blocks import Block
from dhcli.files.rows.columns import JointTable
from dhcli.files.rows.csvrows import CsvRows
from dhcli.files.rows.npyrows import MAGIC, NpyRows
from dhcli.files.rows.source import PIECE, Source


class Rows(Protocol):
    """Rows of joint values."""

    def blocks(self) -> Iterator[Block]:
        """The rows, block by block, each read when it is asked for."""

    def place_of(self, row: int) -> Place:
        """Where a row stands."""


def joint_rows(source: Source, asked: JointTable, threads: int = 1) -> Rows:
    """The joint values of a robot in CSV, JSON Lines or .npy.

    Args:
        source: Where they stand.
        asked: What they are read for.
        threads: How many share a block; one of an array is so much longer then.

    Raises:
        FileError: It is called .npy and is something else.
    """
    beginning = _beginning(source)
    if beginning.startswith(MAGIC):
        return NpyRows(source, asked, threads)
    if source.path.lower().endswith(".npy"):
        raise FileError(Problem("is no .npy file", Place(source.name), "np.save writes one"))
    is_json = beginning.removeprefix(b"\xef\xbb\xbf").lstrip()[:1] in (b"{", b"[")
    is_named_json = source.path.lower().endswith((".jsonl", ".ndjson"))
    if not is_json and not is_named_json:
        return CsvRows(source, asked)
    from dhcli.files.rows.jsonrows import JsonRows  # json, which the others do not need

    return JsonRows(source, asked)


def _beginning(source: Source) -> bytes:
    """The first bytes, until one is not blank; no more, for a row may be all there is for a while."""
    count = len(MAGIC)
    while (beginning := source.peek(count)).isspace() and len(beginning) == count < PIECE:
        count *= 2
    return beginning
