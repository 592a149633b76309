"""Poses of rows in files: `dhcli fk --in` beside numpy's own way to read, compute and write the same file at once."""

from __future__ import annotations

import contextlib
import json
import os
import tempfile
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from measure import Row, Task, side_by_side

from dhcli import forward_batch, load_robot
from dhcli.cli.main import main

if TYPE_CHECKING:
    from numpy.typing import NDArray

POSES = 200_000
ROBOT = load_robot("puma560")
WIDTH = 12
"""Numbers of a pose in text: the upper three rows of the matrix."""


def rows(rounds: int) -> Iterator[Row]:
    """PUMA 560, a million numbers in and twice as many out, in each format."""
    with tempfile.TemporaryDirectory() as folder, contextlib.chdir(folder):
        _write_joint_values(np.random.default_rng(1).uniform(-1, 0.7, (POSES, 6)))
        for kind, (peer, work) in PEERS.items():
            row = side_by_side(
                f"{POSES} rows of {kind}",
                Task(f"dhcli fk --in q.{kind}", partial(_dhcli, kind)),
                Task(peer, work),
                _same,
                rounds=rounds,
            )
            yield replace(row, note=f"{POSES / row.seconds:,.0f} rows a second")


def _write_joint_values(q: NDArray[np.float64]) -> None:
    """The same joint values in each format."""
    np.save("q.npy", q)
    np.savetxt("q.csv", q, fmt="%.17g", delimiter=",", header=",".join(ROBOT.variables), comments="")
    lines = (json.dumps(dict(zip(ROBOT.variables, row, strict=True))) for row in q.tolist())
    Path("q.jsonl").write_text("\n".join(lines), encoding="utf-8")


def _dhcli(kind: str) -> NDArray[np.float64]:
    """What a user types, in this process; what stands in the file then, shape (N, 3, 4)."""
    with open(os.devnull, "w", encoding="utf-8") as nowhere, contextlib.redirect_stderr(nowhere):  # noqa: PTH123
        if main(["fk", ROBOT.name, "--in", f"q.{kind}", "-o", f"p.{kind}", "--overwrite"]):
            raise SystemExit(f"dhcli fk --in q.{kind} does not work")
    return _last(kind, "p")


def _last(kind: str, name: str) -> NDArray[np.float64]:
    """The last pose of a file, shape (12,): enough to see that rows, columns and their order are right."""
    if kind == "npy":
        return np.asarray(np.load(f"{name}.npy", mmap_mode="r")[-1, :3]).ravel()
    with open(f"{name}.{kind}", "rb") as file:  # noqa: PTH123
        file.seek(-2000, os.SEEK_END)
        line = file.read().decode().splitlines()[-1]
    return np.array(json.loads(line)["matrix"] if kind == "jsonl" else line.split(","), dtype=np.float64).ravel()[
        :WIDTH
    ]


def _csv() -> NDArray[np.float64]:
    table = np.loadtxt("q.csv", delimiter=",", skiprows=1)
    np.savetxt("peer.csv", forward_batch(ROBOT, table)[:, :3].reshape(-1, WIDTH), fmt="%.17g", delimiter=",")
    return _last("csv", "peer")


def _jsonl() -> NDArray[np.float64]:
    with open("q.jsonl", encoding="utf-8") as lines:  # noqa: PTH123
        table = [[row[name] for name in ROBOT.variables] for row in map(json.loads, lines)]
    text = "\n".join(json.dumps({"matrix": pose}) for pose in forward_batch(ROBOT, table).tolist())
    Path("peer.jsonl").write_text(text, encoding="utf-8")
    return _last("jsonl", "peer")


def _npy() -> NDArray[np.float64]:
    np.save("peer.npy", forward_batch(ROBOT, np.load("q.npy")))
    return _last("npy", "peer")


def _same(ours: NDArray[np.float64], theirs: NDArray[np.float64]) -> bool:
    return bool(np.allclose(ours, theirs, rtol=0, atol=1e-15))


PEERS: dict[str, tuple[str, Callable[[], NDArray[np.float64]]]] = {
    "npy": ("numpy.load, save", _npy),
    "csv": ("numpy.loadtxt, savetxt", _csv),
    "jsonl": ("json.loads, dumps", _jsonl),
}
