"""Tables in memory, read as if they came from a file or a pipe."""

from __future__ import annotations

import io
from collections.abc import Iterator
from typing import Any

import numpy as np

from dhcli import load_robot
from dhcli.files.rows.columns import JointTable
from dhcli.files.rows.formats import Rows, joint_rows
from dhcli.files.rows.source import Source


class Drops(io.BytesIO):
    """A pipe that gives a few bytes at a time."""

    def read1(self, size: int | None = -1, /) -> bytes:
        """Seven bytes, whatever is asked for."""
        return super().read1(7 if size is None or size < 0 else min(7, size))


def saved(array: object, version: tuple[int, int] | None = None) -> bytes:
    """What numpy writes."""
    stream = io.BytesIO()
    np.lib.format.write_array(stream, np.asanyarray(array), version)
    return stream.getvalue()


def rows(
    content: str | bytes,
    robot: str = "scara",
    *,
    path: str = "q.csv",
    drops: bool = False,
    degrees: bool = False,
    held: dict[str, float] | None = None,
    ignores: bool = False,
) -> Rows:
    """The reader of some content."""
    content = content.encode() if isinstance(content, str) else content
    stream = (Drops if drops else io.BytesIO)(content)
    return joint_rows(Source(path, stream), JointTable(load_robot(robot), degrees, held or {}, ignores))


def read(
    content: str | bytes,
    robot: str = "scara",
    **options: Any,  # noqa: ANN401
) -> np.ndarray:
    """The joint values of the good rows, shape (N, n)."""
    blocks = [block.values for block in rows(content, robot, **options).blocks()]
    return np.concatenate(blocks) if blocks else np.empty((0, 3))


def bad(content: str | bytes, robot: str = "scara", *, path: str = "q.csv") -> list[str]:
    """What is wrong with the bad rows, each on one line."""
    return list(_said(content, robot, path))


def _said(content: str | bytes, robot: str, path: str) -> Iterator[str]:
    for block in rows(content, robot, path=path).blocks():
        yield from map(str, block.bad)
