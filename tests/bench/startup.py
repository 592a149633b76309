"""Start-up: each command as a whole process, beside Python importing what that command imports from outside."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

from measure import Row, Task, side_by_side

COMMANDS = (
    "--help",
    "fk scara --q 0.3,0.5,0.1",
    "fk puma560 --symbolic",
    "fk puma560 --in q.csv",
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
"""What is typed for each command but `watch`, which does not end; run in a folder of its own."""

NAMED = {"numpy", "rich", "sympy", "typer", "yaml"}
"""What dhcli itself imports from outside; these bring modules of their own, which the peer imports, too."""

REPORT = """
import atexit, json, runpy, sys
before = set(sys.modules)

@atexit.register
def report(path=sys.argv.pop(1)):
    found = [name for name, module in sys.modules.items() if name not in before and getattr(module, "__spec__", None)]
    with open(path, "w") as file:
        json.dump(found, file)

sys.argv[0] = "dhcli"
runpy.run_module("dhcli", run_name="__main__", alter_sys=True)
"""


def rows(rounds: int, commands: tuple[str, ...] = COMMANDS) -> Iterator[Row]:
    """A row for each command, each with its bytecode at hand as in an installation."""
    with tempfile.TemporaryDirectory() as home:
        workplace(Path(home))
        for typed in commands:
            ours = [sys.executable, "-m", "dhcli", *typed.split()]
            needed = imported(typed, home)
            peer = [sys.executable, "-c", f"import {', '.join(needed)}"]
            yield side_by_side(
                f"dhcli {typed}",
                Task("the whole process", lambda command=ours: run(command, home)),
                Task(
                    f"importing {', '.join(sorted(NAMED.intersection(needed)))}",
                    lambda command=peer: run(command, home),
                ),
                both_work,
                rounds=rounds,
            )


def workplace(home: Path) -> None:
    """A folder with what the commands need, and the variables that keep them in it."""
    os.environ["PYTHONPYCACHEPREFIX"] = str(home / "bytecode")
    os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
    (home / "q.csv").write_text("theta1,theta2,theta3,theta4,theta5,theta6\n0,0.1,0.2,0.3,0.4,0.5\n", encoding="utf-8")
    os.environ["XDG_DATA_HOME"] = str(home / "user-data")
    for typed in (
        "start planar-two-links -o sheets/student.yaml",
        "new exercise my-course/first --robot planar-2r -o exercise.yaml",
    ):
        (home / "sheets").mkdir(exist_ok=True)
        run([sys.executable, "-m", "dhcli", *typed.split()], str(home))


def imported(typed: str, home: str) -> list[str]:
    """The modules that a command imports, without Python's own and dhcli's."""
    path = Path(home, "modules.json")
    run([sys.executable, "-c", REPORT, str(path), *typed.split()], home)
    own = {*sys.stdlib_module_names, "__mp_main__", "dhcli"}
    return [name for name in json.loads(path.read_text("utf-8")) if name.partition(".")[0] not in own]


def both_work(ours: subprocess.CompletedProcess[str], theirs: subprocess.CompletedProcess[str]) -> bool:
    """Whether neither has failed, and dhcli has said something; a finding ends with 1."""
    return ours.returncode in {0, 1} and bool(ours.stdout + ours.stderr) and theirs.returncode == 0


def run(command: list[str], folder: str | None = None) -> subprocess.CompletedProcess[str]:
    """Run a command to its end, with nothing to read."""
    return subprocess.run(
        command, cwd=folder, capture_output=True, encoding="utf-8", check=False, stdin=subprocess.DEVNULL
    )
