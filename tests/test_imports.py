"""What a command imports: the start-up a user feels depends on what it does not.

Each case runs in a process of its own, which writes down `sys.modules` as it ends.
"""

import json
import subprocess
import sys
from pathlib import Path

import pytest

CLASS = Path(__file__).parent / "data" / "class"

_REPORT = """
import atexit, json, sys

@atexit.register
def report(path=sys.argv.pop(1)):
    with open(path, "w") as file:
        json.dump(sorted(sys.modules), file)
"""
_COMMAND = """
import runpy
sys.argv[0] = "dhcli"
runpy.run_module("dhcli", run_name="__main__", alter_sys=True)
"""


def _loaded(tmp_path: Path, code: str, *arguments: str) -> set[str]:
    """The top-level modules loaded when a program has run to its end, outside the checkout."""
    report = tmp_path / "modules.json"
    program = [sys.executable, "-c", _REPORT + code, str(report), *arguments]
    done = subprocess.run(program, cwd=tmp_path, capture_output=True, encoding="utf-8", timeout=60, check=False)
    assert done.returncode == 0, done.stderr
    return {name.partition(".")[0] for name in json.loads(report.read_text("utf-8"))}


def test_the_report_names_a_module_that_is_imported(tmp_path: Path) -> None:
    """Were the report empty, the other tests here could not fail."""
    assert "numpy" in _loaded(tmp_path, "import numpy.linalg")


@pytest.mark.parametrize(
    "command",
    [
        "--help",
        "--version",
        "list",
        "list robots",
        "show puma560",
        "fk --help",
        "sweep --help",
        "fk scara --q 0.3,0.5,0.1",
        "fk scara --q 0.3,0.5,0.1 --format json",
        "fk puma560 --pose ready",
        "fk puma560 --symbolic",
        "check puma560 --symbolic --from 5 --answer [c6,-s6,0,0;0,0,1,0;-s6,-c6,0,0;0,0,0,1]",
        "check planar-two-links --part d02 --answer a1*c1+a2*c12,a1*s1+a2*s12,0",
        "dof 6R",
        "list exercises",
        "start planar-two-links -o -",
        f"grade {CLASS / 'student-1'}",
    ],
)
def test_a_command_loads_neither_numpy_nor_sympy(tmp_path: Path, command: str) -> None:
    """Nor pydantic, which a later typer would bring along."""
    loaded = _loaded(tmp_path, _COMMAND, *command.split())
    assert "dhcli" in loaded
    assert not loaded & {"matplotlib", "mpmath", "numpy", "pydantic", "sympy"}


def test_importing_dhcli_loads_no_outside_library(tmp_path: Path) -> None:
    """A notebook pays for what it uses, when it uses it."""
    loaded = _loaded(tmp_path, "import dhcli")
    assert "dhcli" in loaded
    assert not loaded & {"matplotlib", "mpmath", "numpy", "pydantic", "rich", "sympy", "typer", "yaml"}
