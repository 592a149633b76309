"""Benchmarks of dhcli: `python tests/bench [GROUP ...] [--rounds N]`.

Every row is compared with its peer and then timed side by side with it, in this one run: read the ratios, not the
times. A peer that is not installed is listed as such; `pip install -r tests/bench/requirements.txt` installs them.
Tables of another kind, about what is found and not how fast, come from mechanisms.py and diagnosis.py beside this file.
"""

from __future__ import annotations

import argparse
import os
import platform
from collections.abc import Callable, Iterator
from contextlib import nullcontext
from datetime import UTC, datetime
from importlib.metadata import version
from pathlib import Path

# One thread for all: these are read when a library of linear algebra is imported.
os.environ.update(dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"), "1"))

import arrays
import classes
import freedoms
import marking
import motion
import pictures
import poses
import rows
import startup
import symbols
from measure import Row, one_core, table
from peers import PEERS

GROUPS: dict[str, Callable[[int], Iterator[Row]]] = {
    "start-up": startup.rows,
    "pose": poses.one,
    "batch": poses.batch,
    "fast": poses.fast,
    "threads": poses.threads,
    "growth": poses.growth,
    "sweeps": poses.sweeps,
    "arrays": arrays.rows,
    "rows": rows.rows,
    "symbols": symbols.rows,
    "jacobian": motion.one,
    "jacobians": motion.batch,
    "jacobian-symbols": motion.symbols,
    "singularities": motion.factors,
    "parsing": marking.parsing,
    "marking": marking.rows,
    "freedoms": freedoms.rows,
    "pictures": pictures.rows,
    "classes": classes.rows,
}

ALL_CORES = {"classes", "threads"}
"""The groups that are about how many cores there are."""


def main(arguments: list[str] | None = None) -> None:
    """Run the groups asked for and print the table of each."""
    parser = argparse.ArgumentParser(
        "python tests/bench", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument(
        "groups", nargs="*", metavar="GROUP", choices=[*GROUPS, []], help=f"{', '.join(GROUPS)}; all by default"
    )
    parser.add_argument("--rounds", type=int, default=5, help="pairs that are counted (default: 5)")
    asked = parser.parse_args(arguments)
    if asked.rounds < 1:
        parser.error("--rounds takes 1 or more")
    print(machine())
    others = " and ".join(sorted(ALL_CORES))
    print(f"Medians of {asked.rounds} pairs, all on one core but {others}; peer/dhcli above 1: dhcli is faster.")
    for name in asked.groups or GROUPS:
        with nullcontext() if name in ALL_CORES else one_core():
            print(f"\n{name}\n\n{table(list(GROUPS[name](asked.rounds)))}", flush=True)


def machine() -> str:
    """The day, the kind of machine, and the versions of what is compared."""
    today = datetime.now(UTC).date()
    kind = ", ".join(filter(None, (platform.machine(), f"{os.cpu_count()} processors", processor())))
    packages = [f"{peer.package} {peer.version or 'not installed'}" for peer in PEERS]
    peers = ", ".join((*packages, f"sympy {version('sympy')}"))
    return f"{today}, {kind}, {platform.system()}, Python {platform.python_version()}\n{peers}"


def processor() -> str:
    """The model of the processor, where the system tells it."""
    told = Path("/proc/cpuinfo")
    lines = told.read_text("utf-8").splitlines() if told.exists() else []
    return next((line.partition(":")[2].strip() for line in lines if line.startswith("model name")), "")


if __name__ == "__main__":
    main()
