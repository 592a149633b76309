"""Reading rows from a file of any length: which format they have shows in its first bytes."""

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
    """Rows."""

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
    match format_of(source):
        case "npy":
            return NpyRows(source, asked, threads)
        case "csv":
            return CsvRows(source, asked)
        case _:
            from dhcli.files.rows.jsonrows import JsonRows  # json, which the others do not need

            return JsonRows(source, asked)


def format_of(source: Source) -> str:
    """Which format rows have, as their first bytes show: csv, jsonl or npy.

    Raises:
        FileError: They are called .npy and are something else.
    """
    beginning = _beginning(source)
    if beginning.startswith(MAGIC):
        return "npy"
    if source.path.lower().endswith(".npy"):
        raise FileError(Problem("is no .npy file", Place(source.name), "np.save writes one"))
    is_json = beginning.removeprefix(b"\xef\xbb\xbf").lstrip()[:1] in (b"{", b"[")
    return "jsonl" if is_json or source.path.lower().endswith((".jsonl", ".ndjson")) else "csv"


def _beginning(source: Source) -> bytes:
    """The first bytes, until one is not blank; no more, for a row may be all there is for a while."""
    count = len(MAGIC)
    while (beginning := source.peek(count)).isspace() and len(beginning) == count < PIECE:
        count *= 2
    return beginning
