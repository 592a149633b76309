"""Benchmarks of dhcli: `python tests/bench [GROUP ...] [--rounds N]`.

Every row is compared with its peer and then timed side by side with it, in this one run: read the ratios, not the
times. A peer that is not installed is listed as such; `pip install -r tests/bench/requirements.txt` installs them.
On a processor with AVX-512 the groups that it matters for are run again without, all libraries being told so.
Tables of another kind, about what is found and not how fast, come from mechanisms.py and diagnosis.py beside this file.
"""

from __future__ import annotations

import argparse
import os
import platform
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import nullcontext
from datetime import UTC, datetime
from importlib.metadata import PackageNotFoundError, version
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
from measure import Row, behind, one_core, table
from peers import PEERS
from processor import processor, without_wide

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
    "fast-jacobians": motion.fast,
    "jacobian-symbols": motion.symbols,
    "singularities": motion.factors,
    "parsing": marking.parsing,
    "marking": marking.rows,
    "freedoms": freedoms.rows,
    "large-freedoms": freedoms.large,
    "pictures": pictures.rows,
    "classes": classes.rows,
}

ALL_CORES = {"classes", "threads"}
"""The groups that are about how many cores there are."""

WIDE = ("batch", "fast", "threads", "growth", "sweeps", "arrays", "jacobians", "fast-jacobians", "freedoms")
"""The groups that AVX-512 matters for."""


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
    names = asked.groups or [*GROUPS]
    done: list[Row] = []
    for name in names:
        with nullcontext() if name in ALL_CORES else one_core():
            found = list(GROUPS[name](asked.rounds))
        done += found
        print(f"\n{name}\n\n{table(found)}", flush=True)
    if slower := behind(done):
        print("\nwhere dhcli takes longer than what it is held against\n", *slower, sep="\n- ", flush=True)
    again, environment = [name for name in names if name in WIDE], without_wide()
    if again and environment:
        print("\nWithout AVX-512:\n", flush=True)
        program = [sys.executable, str(Path(__file__).parent), *again, "--rounds", str(asked.rounds)]
        if subprocess.run(program, env=environment, check=False).returncode:
            raise SystemExit(1)


def machine() -> str:
    """The day, the kind of machine, and the versions of what is compared."""
    kind = ", ".join((platform.machine(), f"{os.cpu_count()} processors", processor()))
    versions = ", ".join(f"{name} {installed(name)}" for name in PACKAGES)
    return f"{datetime.now(UTC).date()}, {kind}, {platform.system()}, Python {platform.python_version()}\n{versions}"


PACKAGES = (*(peer.package for peer in PEERS), arrays.KINEMATICS.package, "torch", "numba", "sympy")
"""What is compared, and what plays batches."""


def installed(package: str) -> str:
    """The version of a package, or that there is none."""
    try:
        return version(package)
    except PackageNotFoundError:
        return "not installed"


if __name__ == "__main__":
    main()
