"""Poses of rows in files: `dhcli fk --rows` beside numpy's own way to read, compute and write the same file at once."""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
import tempfile
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING
from unittest.mock import patch

import numpy as np
from measure import Row, Task, side_by_side
from poses import CLOSE

from dhcli import forward_batch, load_robot
from dhcli.cli.main import main
from dhcli.files.rows.npyrows import ROWS
from dhcli.kinematics.frames import View
from dhcli.kinematics.many import PoseRows
from dhcli.kinematics.values import parameter_values
from dhcli.notation import decimals

if TYPE_CHECKING:
    from numpy.typing import NDArray

POSES = {"npy": 1_000_000, "csv": 50_000, "jsonl": 50_000}
ROBOT = load_robot("puma560")
WIDTH = 12
"""Numbers of a pose in text: the upper three rows of the matrix."""


def rows(rounds: int) -> Iterator[Row]:
    """PUMA 560, six numbers in and twelve or sixteen out, in each format, with orjson and without."""
    yield _blocks(rounds)
    with tempfile.TemporaryDirectory() as folder, contextlib.chdir(folder):
        for kind, (peer, work) in PEERS.items():
            _write_joint_values(np.random.default_rng(1).uniform(-1, 0.7, (POSES[kind], 6)), kind)
            ways = {"": _dhcli} if kind == "npy" else {", orjson": _dhcli, ", plain Python": _plainly}
            for name, ours in ways.items():
                row = side_by_side(
                    f"{POSES[kind]} rows of {kind}",
                    Task(f"fk --rows{name}", partial(ours, kind)),
                    Task(peer, work),
                    _same,
                    rounds=rounds,
                )
                yield replace(row, note=f"{POSES[kind] / row.seconds:,.0f} rows a second")
            if kind != "npy":
                yield side_by_side(
                    f"{POSES[kind]} rows of {kind}",
                    Task("fk --rows, orjson", partial(_whole, _dhcli, kind)),
                    Task("fk --rows, plain Python", partial(_whole, _plainly, kind)),
                    bytes.__eq__,
                    rounds=rounds,
                    note="the same bytes",
                )


def _blocks(rounds: int) -> Row:
    """What a pose costs in the blocks in which rows come, and in one call."""
    q = np.random.default_rng(1).uniform(-1, 0.7, (POSES["npy"], 6))
    wanted = PoseRows(ROBOT, (View.of(ROBOT),), parameter_values(ROBOT, {}))
    row = side_by_side(
        f"{len(q)} poses",
        Task(
            f"blocks of {ROWS}, as fk --rows",
            lambda: [wanted.poses(q[k : k + ROWS])[-1, 0].copy() for k in _starts(len(q))],
        ),
        Task("forward_batch, one call", lambda: forward_batch(ROBOT, q)),
        lambda own, whole: all(
            np.allclose(last, whole[min(k + ROWS, len(q)) - 1], rtol=0, atol=CLOSE) for k, last in _pairs(own, q)
        ),
        rounds=rounds,
    )
    return replace(row, note=f"{row.seconds / len(q) * 1e9:.0f} ns a pose")


def _starts(count: int) -> range:
    return range(0, count, ROWS)


def _pairs(own: list[NDArray[np.float64]], q: NDArray[np.float64]) -> Iterator[tuple[int, NDArray[np.float64]]]:
    return zip(_starts(len(q)), own, strict=True)


def _write_joint_values(q: NDArray[np.float64], kind: str) -> None:
    """Joint values in a format."""
    match kind:
        case "npy":
            np.save("q.npy", q)
        case "csv":
            np.savetxt("q.csv", q, fmt="%.17g", delimiter=",", header=",".join(ROBOT.variables), comments="")
        case _:
            lines = (json.dumps(dict(zip(ROBOT.variables, row, strict=True))) for row in q.tolist())
            Path("q.jsonl").write_text("\n".join(lines), encoding="utf-8")


def _plainly(kind: str) -> NDArray[np.float64]:
    """The same as where orjson is not installed."""
    with patch.object(decimals, "quick_json", lambda: None):
        return _dhcli(kind)


def _whole(work: Callable[[str], object], kind: str) -> bytes:
    """All that is in the file then, in short."""
    work(kind)
    with open(f"p.{kind}", "rb") as file:  # noqa: PTH123
        return hashlib.file_digest(file, "sha256").digest()


def _dhcli(kind: str) -> NDArray[np.float64]:
    """What a user types, in this process; what stands in the file then, shape (N, 3, 4)."""
    with open(os.devnull, "w", encoding="utf-8") as nowhere, contextlib.redirect_stderr(nowhere):  # noqa: PTH123
        if main(["fk", ROBOT.name, "--rows", f"q.{kind}", "-o", f"p.{kind}", "--overwrite"]):
            raise SystemExit(f"dhcli fk --rows q.{kind} does not work")
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
    np.save("peer.npy", forward_batch(load_robot(ROBOT.name), np.load("q.npy")))
    return _last("npy", "peer")


def _same(ours: NDArray[np.float64], theirs: NDArray[np.float64]) -> bool:
    return bool(np.allclose(ours, theirs, rtol=0, atol=1e-15))


PEERS: dict[str, tuple[str, Callable[[], NDArray[np.float64]]]] = {
    "npy": ("numpy.load, save", _npy),
    "csv": ("numpy.loadtxt, savetxt", _csv),
    "jsonl": ("json.loads, dumps", _jsonl),
}
