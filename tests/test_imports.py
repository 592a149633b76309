"""What a command imports: the start-up a user feels depends on what it does not.

The table says it for each command. A room is a folder of dhcli, and has its files imported as they are needed.
"""

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from tests.cli.running import run

HERE = Path(__file__).parent

ALWAYS = {"typer", "dhcli", "dhcli.cli", "dhcli.cli.commands", "dhcli.cli.shell"}
LIBRARIES = {"numpy", "rich", "yaml"}
ALSO = {"numba", "orjson"}
"""Of the extras, used wherever they are installed."""
COSTLY = {"asyncio", "concurrent", "csv", "hashlib", "html", "http", "json", "logging", "multiprocessing", "random"}
COSTLY |= {"socket", "ssl", "statistics", "tempfile", "xml"}
"""Of Python's own, what takes a third of a millisecond or more; some comes or not with the version of a library."""

HELP = "rich random notation render"
BASE = "algebra geometry kinematics notation render"
FILES = "files files.keys files.library files.yaml"
ROBOT = f"{BASE} {FILES} yaml"
TEXT = f"{ROBOT} render.text"
COUNTED = f"{BASE} {FILES} mobility render.text"
DRAWN = f"{ROBOT} kinematics.sweep mobility scene render.pictures"
LISTED = "kinematics notation render csv files files.library storage render.code render.text"
EXERCISE = f"{ROBOT} checking checking.diagnosis checking.kinds checking.tables mobility"
CHECK = f"{EXERCISE} csv storage render.code render.text"
GRADED = "checking checking.diagnosis classroom files kinematics notation render render.text"
EXPLAINED = "checking.diagnosis.mistakes random"

MAY = {
    "--version": "",
    "--help": HELP,
    "fk --help": HELP,
    "help fk": "files notation render render.text",
    "fk scara --q 0.3,0.5,0.1": TEXT,
    "fk scara --q 0.3,0.5,0.1 --format json": f"{TEXT} csv json render.code render.json",
    "fk puma560 --pose ready": TEXT,
    "fk puma560 --symbolic": TEXT,
    "fk puma560 --rows q.csv": f"{TEXT} numpy csv json files.rows render.code",
    "sweep puma560 --over q1": f"{TEXT} numpy csv kinematics.sweep render.code",
    "jacobian puma560 --symbolic": f"{TEXT} kinematics.velocity",
    "jacobian puma560 --pose nominal": f"{TEXT} kinematics.velocity",
    "singularities puma560": f"{TEXT} kinematics.singular kinematics.velocity",
    "singularities puma560 --pose nominal": f"{TEXT} numpy kinematics.singular kinematics.velocity",
    "rates planar-2r --symbolic": f"{TEXT} kinematics.velocity",
    "rates planar-2r --q 0.3,0.5 --velocity 0.1,0,0": f"{TEXT} numpy kinematics.velocity",
    "torques planar-2r --q 0.3,0.5 --force 0,10,0": f"{TEXT} kinematics.velocity",
    "transform Trans(8,-6,14)Rot(y,90°)": f"{BASE} csv render.code render.json render.text",
    "describe puma560 --as standard": f"{TEXT} csv kinematics.describe render.code",
    "ik puma560 --pose nominal": f"{TEXT} numpy csv json kinematics.inverse storage render.code",
    "ik planar-2r --derive": f"{TEXT} kinematics.inverse random",
    "show puma560": f"{TEXT} csv lint render.code",
    "draw puma560": DRAWN,
    "draw watt": DRAWN,
    "draw yim/planar-linkages": f"{DRAWN} {EXERCISE}",
    "list": f"{LISTED} checking checking.diagnosis",
    "list linkages": LISTED,
    "dof 6R": COUNTED,
    "dof --planar --links 4 --joints 4R": f"{BASE} mobility render.text",
    "dof bennett": f"{COUNTED} yaml numpy random",
    "check planar-two-links --part d02 --answer a1*c1+a2*c12,a1*s1+a2*s12,0": CHECK,
    "check puma560 --symbolic --from 5 --answer [c6,-s6,0,0;0,0,1,0;-s6,-c6,0,0;0,0,0,1]": CHECK,
    "check planar-two-links --part d02 --answer a1*c1,a1*s1,0": f"{CHECK} {EXPLAINED}",
    "start planar-two-links -o -": EXERCISE,
    "hint planar-two-links": f"{EXERCISE} json storage render.text",
    "solution planar-two-links --yes": f"{EXERCISE} csv kinematics.describe render.code render.text",
    "grade sheets": f"{GRADED} multiprocessing random socket tempfile",
    "lint exercise.yaml": f"{EXERCISE} {EXPLAINED} lint render.text",
    "new robot my-arm --overwrite": f"{BASE} files files.library files.yaml storage",
    "schema robot": "algebra geometry kinematics notation render json files files.keys",
}
"""What each command imports besides `ALWAYS`: libraries, costly parts of Python's own, rooms of dhcli."""

CODES = {"check planar-two-links --part d02 --answer a1*c1,a1*s1,0": 1, "lint exercise.yaml": 1}
"""What a command ends with that finds something wrong."""


def imports_of(lines: list[str], folder: Path) -> list[dict[str, Any]]:
    """Run commands, each in a process of its own: see `importing`."""
    program = [sys.executable, str(HERE / "importing.py"), *lines]
    done = subprocess.run(program, cwd=folder, capture_output=True, encoding="utf-8", timeout=120, check=False)
    assert done.returncode == 0, done.stderr
    found: list[dict[str, Any]] = json.loads(done.stdout)
    return found


def room_of(module: str) -> str | None:
    """What of the table a module belongs to; None for a part of Python's own that costs little."""
    top = module.partition(".")[0]
    if top == "dhcli":
        return module.rpartition(".")[0] or "dhcli"
    return top if top in COSTLY or top not in sys.stdlib_module_names else None


def chain(module: str, asked: dict[str, str]) -> str:
    """Who imported a module first, and who that, up to the command."""
    links = [module]
    while (asker := asked.get(links[-1])) and asker not in links:
        links.append(asker)
    return " < ".join(links)


def differences(allowed: str, asked: dict[str, str]) -> list[str]:
    """What is imported that is not in the table, each with its chain; and what is in the table and is not imported."""
    found = {room: module for module in reversed(asked) if (room := room_of(module))}
    may = {name if name in COSTLY or name in LIBRARIES else f"dhcli.{name}" for name in allowed.split()}
    more = [f"{room}: {chain(found[room], asked)}" for room in found.keys() - may - ALWAYS - ALSO]
    return sorted([*more, *(f"{room} is not imported any more" for room in may - found.keys() - COSTLY)])


@pytest.mark.skipif(not hasattr(os, "fork"), reason="a process for each command is forked")
def test_a_command_imports_what_it_may(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Each of the table, which has all that are timed; and what it may not is told with who imports it."""
    monkeypatch.syspath_prepend(str(HERE / "bench"))
    import startup

    assert MAY.keys() > {*startup.COMMANDS}
    startup.furnish(tmp_path)
    assert run("list").code == 0  # the first one reads the whole library
    reports = imports_of([*MAY, "fk scara --rows q.csv"], tmp_path)
    by_line = dict(zip(MAY, reports, strict=False))
    assert {line: report["said"] for line, report in by_line.items() if report["code"] != CODES.get(line, 0)} == {}
    assert {line: report["left"] for line, report in by_line.items() if report["left"] > 1000} == {}
    found = [f"{line}\n  {each}" for line in MAY for each in differences(MAY[line], by_line[line]["asked"])]
    if found:
        pytest.fail("what the table does not say:\n" + "\n".join(found), pytrace=False)
    told = differences(f"{TEXT} rich", reports[-1]["asked"])
    assert "rich is not imported any more" in told
    assert any(one.startswith("numpy: numpy < dhcli.files.rows.") for one in told)
    assert sum(" < dhcli.cli.commands.fk < dhcli.cli.app < " in one for one in told) == len(told) - 1


def test_importing_dhcli_imports_no_library(tmp_path: Path) -> None:
    """A notebook pays for what it uses, when it uses it."""
    assert outside("dhcli", tmp_path) == set()
    assert "numpy" in outside("numpy.linalg", tmp_path)


def outside(module: str, folder: Path) -> set[str]:
    """The libraries that a module imports, in a process of its own."""
    program = f"import sys\nbefore = {{*sys.modules}}\nimport {module}\nprint(*({{*sys.modules}} - before))"
    done = subprocess.run(
        [sys.executable, "-c", program], cwd=folder, capture_output=True, encoding="utf-8", check=True
    )
    return {name.partition(".")[0] for name in done.stdout.split()} - {*sys.stdlib_module_names, "dhcli"}


def test_what_help_does_without_is_there_for_others(tmp_path: Path) -> None:
    """The readers of Markdown and of tracebacks, imported after a help page, are rich's own."""
    program = "from dhcli.cli.main import main; main(['--help'])\nimport sys; assert 'markdown_it' not in sys.modules\n"
    program += "from rich.markdown import Markdown; from rich.traceback import Traceback; Markdown('a'); Traceback"
    done = subprocess.run(
        [sys.executable, "-c", program], cwd=tmp_path, capture_output=True, encoding="utf-8", check=False
    )
    assert (done.returncode, done.stderr) == (0, "")
    assert "Show the version and stop." in done.stdout
