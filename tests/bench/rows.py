"""Many poses: `dhcli fk --in` beside numpy's own way to read, compute and write the same file at once."""

from __future__ import annotations

import contextlib
import json
import os
import tempfile
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
from measure import Row, side_by_side

from dhcli import forward_batch, load_robot
from dhcli.cli.main import main

POSES = 200_000
NAMES = [f"theta{i}" for i in range(1, 7)]


def rows(rounds: int) -> Iterator[Row]:
    """PUMA 560, a million numbers in and more than twice as many out."""
    robot, here = load_robot("puma560"), Path.cwd()
    q = np.random.default_rng(1).uniform(-1, 0.7, (POSES, 6))
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        try:
            np.save("q.npy", q)
            np.savetxt("q.csv", q, fmt="%.17g", delimiter=",", header=",".join(NAMES), comments="")
            Path("q.jsonl").write_text(
                "".join(f"{json.dumps(dict(zip(NAMES, row, strict=True)))}\n" for row in q.tolist())
            )

            def csv() -> None:
                table = np.loadtxt("q.csv", delimiter=",", skiprows=1)
                np.savetxt("p.csv", forward_batch(robot, table)[:, :3].reshape(-1, 12), fmt="%.17g", delimiter=",")

            def jsonl() -> None:
                with open("q.jsonl") as lines:  # noqa: PTH123  as the peer would be written
                    table = [[row[name] for name in NAMES] for row in map(json.loads, lines)]
                poses = forward_batch(robot, table).tolist()
                Path("p.jsonl").write_text("".join(json.dumps({"matrix": pose}) + "\n" for pose in poses))

            def npy() -> None:
                np.save("p.npy", forward_batch(robot, np.load("q.npy")))

            peers: dict[str, tuple[str, Callable[[], None]]] = {
                "npy": ("numpy.load, save", npy),
                "csv": ("numpy.loadtxt, savetxt", csv),
                "jsonl": ("json.loads, dumps", jsonl),
            }
            for kind, peer in peers.items():
                row = side_by_side(f"poses, {kind}", (f"dhcli fk --in q.{kind}", _fk(kind)), peer, rounds=rounds)
                yield replace(row, note=f"{POSES} rows; {POSES / row.seconds:.0f} a second")
        finally:
            os.chdir(here)


def _fk(kind: str) -> Callable[[], None]:
    """What a user types, in this process."""

    def run() -> None:
        with open(os.devnull, "w", encoding="utf-8") as nowhere, contextlib.redirect_stderr(nowhere):  # noqa: PTH123
            code = main(["fk", "puma560", "--in", f"q.{kind}", "-o", f"p.{kind}", "--force"])
        if code:
            raise RuntimeError(code)

    return run
