"""Start-up: each command as a whole process, beside Python importing typer, the tables of rich, and yaml."""

from __future__ import annotations

import os
import shutil
import statistics
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

from measure import Row, Task, side_by_side

UNIT = "import typer, rich.table, yaml"
"""What a start is held against: the libraries a program like this cannot do without, and nothing done with them."""

COMMANDS = (
    "--help",
    "fk scara --q 0.3,0.5,0.1",
    "fk puma560 --symbolic",
    "fk puma560 --rows q.csv",
    "sweep puma560 --over q1",
    "jacobian puma560 --symbolic",
    "singularities puma560",
    "rates planar-2r --q 0.3,0.5 --velocity 0.1,0,0",
    "torques planar-2r --q 0.3,0.5 --force 0,10,0",
    "transform Trans(8,-6,14)Rot(y,90°)",
    "show puma560",
    "describe puma560 --as standard",
    "draw puma560",
    "list",
    "check planar-two-links --part d02 --answer a1*c1+a2*c12,a1*s1+a2*s12,0",
    "start planar-two-links -o -",
    "hint planar-two-links",
    "solution planar-two-links --yes",
    "dof 6R",
    "dof bennett",
    "grade sheets",
    "lint exercise.yaml",
    "new robot my-arm --overwrite",
    "schema robot",
    "help fk",
    "ik puma560 --pose nominal",
)
"""What is typed for each command but `watch`, which does not end; run in a folder that `furnish` has filled."""

SHEETS = 5
"""What is to be graded."""


def rows(rounds: int, commands: tuple[str, ...] = COMMANDS) -> Iterator[Row]:
    """A row for each command, each with its bytecode at hand as in an installation."""
    peer = [sys.executable, "-c", UNIT]
    with tempfile.TemporaryDirectory() as home:
        os.environ["PYTHONPYCACHEPREFIX"] = str(Path(home, "bytecode"))
        os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
        os.environ["XDG_DATA_HOME"] = str(Path(home, "user-data"))
        furnish(Path(home))
        for typed in commands:
            ours = [sys.executable, "-m", "dhcli", *typed.split()]
            row = side_by_side(
                f"dhcli {typed}",
                Task("the whole process", lambda command=ours: run(command, home)),
                Task(UNIT, lambda: run(peer, home)),
                both_work,
                rounds=rounds,
            )
            yield replace(row, note=in_units(row, instructions(ours, home), instructions(peer, home)))


def in_units(row: Row, counted: int, unit: int) -> str:
    """How often the unit goes into a command: by time, and by instructions where they were counted."""
    by_time = f"{1 / statistics.median(row.ratios):.2f} units"
    return f"{by_time}, {counted / unit:.2f} by instructions" if counted and unit else by_time


def furnish(home: Path) -> None:
    """Fill a folder with what the commands need."""
    (home / "q.csv").write_text("theta1,theta2,theta3,theta4,theta5,theta6\n0,0.1,0.2,0.3,0.4,0.5\n", encoding="utf-8")
    sheets = home / "sheets"
    sheets.mkdir(exist_ok=True)
    for typed in (
        "start planar-two-links -o sheets/student.yaml",
        "new exercise my-course/first --robot planar-2r -o exercise.yaml",
    ):
        run([sys.executable, "-m", "dhcli", *typed.split()], str(home))
    for number in range(1, SHEETS):
        shutil.copy(sheets / "student.yaml", sheets / f"student-{number}.yaml")


def instructions(command: list[str], folder: str) -> int:
    """How many instructions a command takes outside the kernel, as perf counts them; 0 where it cannot.

    They tell more of a busy machine than the time does.
    """
    if not shutil.which("perf"):
        return 0
    said = run(["perf", "stat", "-x,", "-e", "instructions:u", "--", *command], folder).stderr
    counts = [line.split(",")[0] for line in said.splitlines() if "instructions:u" in line]
    return int(counts[0]) if counts and counts[0].isdigit() else 0


def both_work(ours: subprocess.CompletedProcess[str], theirs: subprocess.CompletedProcess[str]) -> bool:
    """Whether neither has failed, and dhcli has said something; a finding ends with 1."""
    return ours.returncode in {0, 1} and bool(ours.stdout + ours.stderr) and theirs.returncode == 0


def run(command: list[str], folder: str | None = None) -> subprocess.CompletedProcess[str]:
    """Run a command to its end, with nothing to read."""
    return subprocess.run(
        command, cwd=folder, capture_output=True, encoding="utf-8", check=False, stdin=subprocess.DEVNULL
    )
