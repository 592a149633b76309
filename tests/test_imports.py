"""What a command imports: the start-up a user feels depends on what it does not.

Each program runs in a process of its own, which says on its last line what it has loaded.
"""

import subprocess
import sys
from pathlib import Path

CLASS = Path(__file__).parent / "data" / "class"
HEAVY = {"matplotlib", "mpmath", "numpy", "pydantic", "sympy"}
COMMANDS = (
    "--help",
    "--version",
    "list",
    "list robots",
    "list linkages",
    "list exercises",
    "show puma560",
    "fk --help",
    "sweep --help",
    "fk scara --q 0.3,0.5,0.1",
    "fk scara --q 0.3,0.5,0.1 --format json",
    "fk puma560 --pose ready",
    "fk puma560 --symbolic",
    "check puma560 --symbolic --from 5 --answer [c6,-s6,0,0;0,0,1,0;-s6,-c6,0,0;0,0,0,1]",
    "check planar-two-links --part d02 --answer a1*c1+a2*c12,a1*s1+a2*s12,0",
    "draw puma560",
    "draw watt",
    "draw yim/planar-linkages",
    "dof 6R",
    "dof --planar --links 4 --joints 4R",
    "start planar-two-links -o -",
    f"grade {CLASS / 'student-1'}",
)

_ONE_BY_ONE = f"""
import io, runpy, sys
from contextlib import redirect_stderr, redirect_stdout

for line in sys.argv[1:]:
    sys.argv[:] = ["dhcli", *line.split()]
    with redirect_stdout(io.StringIO()), redirect_stderr(io.StringIO()) as said:
        try:
            runpy.run_module("dhcli", run_name="__main__", alter_sys=True)
        except SystemExit as ended:
            code = ended.code
    if code or {HEAVY}.intersection(sys.modules):
        print(line, code, said.getvalue())
        break
"""
_REPORT = "\nimport sys; print(*{name.partition('.')[0] for name in sys.modules})"


def _loaded(folder: Path, code: str, *arguments: str) -> tuple[str, set[str]]:
    """What a program prints, and the top-level modules that are loaded at its end, outside the checkout."""
    program = [sys.executable, "-c", code + _REPORT, *arguments]
    done = subprocess.run(program, cwd=folder, capture_output=True, encoding="utf-8", timeout=60, check=False)
    assert done.returncode == 0, done.stderr
    *lines, last = done.stdout.splitlines()
    return "\n".join(lines), set(last.split())


def test_the_report_names_a_module_that_is_imported(tmp_path: Path) -> None:
    """Were the report empty, the other tests here could not fail."""
    assert "numpy" in _loaded(tmp_path, "import numpy.linalg")[1]


def test_no_command_loads_numpy_or_sympy(tmp_path: Path) -> None:
    """Nor pydantic, which a later typer would bring along. One after another: the first that does is printed."""
    said, loaded = _loaded(tmp_path, _ONE_BY_ONE, *COMMANDS)
    assert said == ""
    assert "dhcli" in loaded
    assert not loaded & HEAVY


def test_a_command_that_loads_numpy_is_found(tmp_path: Path) -> None:
    """Were it not, the test above could not fail."""
    said, loaded = _loaded(tmp_path, _ONE_BY_ONE, "--version", "fk scara --in nowhere.csv", "--help")
    assert said.startswith("fk scara --in nowhere.csv 2")
    assert "numpy" in loaded


def test_importing_dhcli_loads_no_outside_library(tmp_path: Path) -> None:
    """A notebook pays for what it uses, when it uses it."""
    _, loaded = _loaded(tmp_path, "import dhcli")
    assert "dhcli" in loaded
    assert not loaded & {*HEAVY, "rich", "typer", "yaml"}
