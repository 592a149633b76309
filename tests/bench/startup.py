"""Start-up: each command as a whole process, beside Python importing what the command line is made of."""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from collections.abc import Iterator

from measure import Row, side_by_side

COMMANDS = {
    "--help": ["--help"],
    "fk, numbers": ["fk", "scara", "--q", "0.3,0.5,0.1"],
    "fk, symbols": ["fk", "puma560", "--symbolic"],
    "list": ["list"],
}
IMPORTS = "import typer, rich.table, yaml"


def rows(rounds: int) -> Iterator[Row]:
    """A row for each command, each with its bytecode at hand as in an installation."""
    with tempfile.TemporaryDirectory() as cache:
        os.environ["PYTHONPYCACHEPREFIX"] = cache
        os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
        yield from _rows(rounds)


def _rows(rounds: int) -> Iterator[Row]:
    for name, arguments in COMMANDS.items():
        ours = [sys.executable, "-m", "dhcli", *arguments]
        result = run(ours)
        if result.returncode != 0 or not result.stdout.strip():
            raise SystemExit(f"dhcli {' '.join(arguments)} does not work: {result.stderr}")
        peer = [sys.executable, "-c", IMPORTS]
        yield side_by_side(
            f"start-up of {name}",
            (f"dhcli {' '.join(arguments)}", lambda command=ours: run(command)),
            (f"python -c '{IMPORTS}'", lambda command=peer: run(command)),
            rounds=rounds,
        )


def run(command: list[str]) -> subprocess.CompletedProcess[str]:
    """Run a command to its end, with nothing to read."""
    return subprocess.run(command, capture_output=True, text=True, check=False, stdin=subprocess.DEVNULL)
