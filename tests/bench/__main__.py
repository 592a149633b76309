"""Benchmarks of dhcli: `python tests/bench [start-up|symbols|marking|freedoms|classes|rows] [--rounds N]`.

Every row is measured side by side with its peer in this one run; read the ratios, not the times.
"""

from __future__ import annotations

import argparse
import platform

import classes
import freedoms
import marking
import rows
import startup
import symbols
from measure import table

GROUPS = {
    "start-up": startup.rows,
    "symbols": symbols.rows,
    "marking": marking.rows,
    "freedoms": freedoms.rows,
    "classes": classes.rows,
    "rows": rows.rows,
}


def main() -> None:
    """Run the groups asked for and print their table."""
    parser = argparse.ArgumentParser(prog="python tests/bench", description=__doc__.splitlines()[0])
    parser.add_argument("groups", nargs="*", choices=[*GROUPS, []], help="which groups to run; all by default")
    parser.add_argument("--rounds", type=int, default=5, help="pairs that are counted (default: 5)")
    asked = parser.parse_args()
    print(f"Python {platform.python_version()}, {platform.machine()}, median of {asked.rounds} pairs\n")
    print(table([row for name in asked.groups or GROUPS for row in GROUPS[name](asked.rounds)]))


if __name__ == "__main__":
    main()
