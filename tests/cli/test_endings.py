"""A file's ending and the format asked for."""

from __future__ import annotations

from pathlib import Path

import pytest

from dhcli.cli import app
from dhcli.render.code.rows import FORMATS
from dhcli.render.endings import ENDINGS
from dhcli.render.kinds import _RENDERERS, formats
from tests.cli.running import Run
from tests.row_by_row import row_by_row

LINES = {
    "fk": "fk planar-2r --symbolic --format latex",
    "transform": "transform Trans(1,2,3) --format latex",
    "jacobian": "jacobian planar-2r --symbolic --format matlab",
    "singularities": "singularities planar-2r --format sympy",
    "torques": "torques planar-2r --symbolic --force 0,0,10 --format latex",
    "rates": "rates planar-2r --symbolic --format latex",
    "ik": "ik planar-2r --derive --format latex",
    "show": "show planar-2r --format latex",
    "list": "list --format json",
    "describe": "describe planar-2r --format urdf",
    "dof": "dof 6R --format json",
    "check": "check planar-2r --format json --symbolic --entry 1,4 --answer a1",
    "grade": "grade . --format gradescope",
    "lint": "lint . --format json",
}
"""For each command with a format and a file: what writes neither C nor a table."""


TASK = """\
format: 1
title: x
source: x
robot: my robot.yaml
task: x
parts:
  - {id: tip, ask: position of pose 0..1}
"""


@row_by_row("ending", [".c", ".H", ".pdf", ".xlsx"])
@row_by_row("line", LINES.values())
def test_an_ending_and_a_format_that_contradict_each_other_are_refused(
    dhcli: Run, tmp_path: Path, line: str, ending: str
) -> None:
    """With what to write instead, and before anything is computed or written."""
    done = dhcli(*line.split(), "-o", f"result{ending}")
    format_ = line.partition("--format ")[2].split()[0]
    said = done.out + done.err
    assert done.code == 2
    assert f"result{ending} ends as a file in " in said
    assert f"does, and --format says {format_}" in said
    assert f"write {ENDINGS[format_][0]}" in said
    assert not list(tmp_path.iterdir())


def test_every_command_with_a_format_and_a_file_is_among_them() -> None:
    """A sweep writes its points, and the format is that of its summary."""
    options = {name: {option for one in app.load(name).params for option in one.opts} for name in app.COMMANDS}
    takes = {name for name in app.COMMANDS if {"--format", "--output"} <= options[name]}
    assert takes == {*LINES, "sweep"}


@pytest.mark.parametrize(
    ("line", "ways"),
    [
        ("fk planar-2r -s --format latex -o x.py", "write .tex, or --format numpy"),
        ("fk planar-2r -s --format numpy -o x.tex", "write .py, or --format latex"),
        ("fk planar-2r -s --format table -o x.csv", "write .txt, or --format csv"),
        ("fk planar-2r --rows q.csv --format jsonl -o x.csv", "write .jsonl, or --format csv"),
        ("fk planar-2r --rows q.csv --format csv -o x.npy", "write .csv, or --format npy"),
        ("jacobian planar-2r --rows q.csv --format npy -o x.ndjson", "write .npy, or --format jsonl"),
        ("ik planar-2r --rows T.csv --format csv -o x.jsonl", "write .csv, or --format jsonl"),
        ("grade . --format csv -o x.json", "write .csv, or --format json"),
        ("describe scara --format yaml -o x.urdf", "write .yaml, or --format urdf"),
        ("ik planar-2r --derive --format md -o x.tex", "write .md, or --format latex"),
    ],
)
def test_both_ways_out_are_said(dhcli: Run, tmp_path: Path, line: str, ways: str) -> None:
    """The right ending, and a format of this result for the ending that was typed."""
    done = dhcli(*line.split())
    assert (done.code, f"hint: {ways}\n" in done.err) == (2, True), done.err
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("name", ["result", "result.txt", "result.sty", "folder.py/result"])
def test_an_ending_that_says_nothing_holds_what_is_asked_for(dhcli: Run, tmp_path: Path, name: str) -> None:
    """None, .txt, one that nobody knows, and that of the folder."""
    (tmp_path / "folder.py").mkdir()
    line = "fk planar-2r --symbolic --format latex"
    assert dhcli(*line.split(), "-o", name).code == 0
    assert (tmp_path / name).read_text("utf-8") == dhcli(*line.split()).out


@pytest.mark.parametrize("ending", [".py", ".PY"])
@pytest.mark.parametrize("format_", ["numpy", "sympy"])
def test_two_formats_may_end_alike(dhcli: Run, tmp_path: Path, format_: str, ending: str) -> None:
    """Both are Python; an ending is the same in capitals."""
    assert dhcli("fk", "planar-2r", "-s", "--format", format_, "-o", f"x{ending}").code == 0
    assert (tmp_path / f"x{ending}").is_file()


def test_a_form_that_is_a_format_is_held_to_the_ending_too(dhcli: Run, tmp_path: Path) -> None:
    """`--as urdf` says what `--format urdf` says."""
    done = dhcli("describe", "scara", "--as", "urdf", "-o", "x.yaml")
    assert (done.code, "and --as says urdf" in done.err, "write .urdf" in done.err) == (2, True, True)
    for others in (("--as", "urdf", "--format", "yaml"), ("--as", "modified", "-o", "x.urdf")):
        assert "ask for different things" in dhcli("describe", "scara", *others).err
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("line", "ending"),
    [
        ("new robot arm", ".yaml"),
        ("new linkage press", ".yaml"),
        ("new exercise c/one --robot scara", ".yaml"),
        ("start planar-two-links", ".yaml"),
        ("schema robot", ".json"),
    ],
)
def test_what_has_one_format_goes_in_no_file_of_another(dhcli: Run, tmp_path: Path, line: str, ending: str) -> None:
    """Such a file is found by no command."""
    done = dhcli(*line.split(), "-o", "x.csv")
    assert (done.code, "x.csv ends as a file in csv does, and would hold " in done.err) == (2, True)
    assert f"hint: write {ending}\n" in done.err
    assert not list(tmp_path.iterdir())
    for name in (f"x{ending}", "x"):
        assert dhcli(*line.split(), "-o", name).code == 0


def test_the_next_command_is_one_that_can_be_typed(dhcli: Run, tmp_path: Path) -> None:
    """Where a file is called as a name is, or has a blank in its own."""
    assert "next: dhcli show ./arm, then dhcli fk ./arm --symbolic" in dhcli("new", "robot", "arm", "-o", "arm").err
    assert dhcli("show", "./arm").code == 0
    assert "next: dhcli show 'my arm.yaml'," in dhcli("new", "robot", "arm", "-o", "my arm.yaml").err
    (tmp_path / "my robot.yaml").write_text((tmp_path / "arm").read_text("utf-8"), "utf-8")
    (tmp_path / "my task.yaml").write_text(TASK, "utf-8")
    said = dhcli("start", "my task.yaml", "-o", "my sheet.yaml").err
    assert "then dhcli check 'my task.yaml' 'my sheet.yaml'," in said


KINDS = {
    "check": "marks",
    "grade": "class",
    "lint": "lint",
    "list": "library",
    "show": "robot",
    "describe": "description",
}


@pytest.mark.parametrize("command", KINDS)
def test_the_help_of_a_command_names_the_endings_and_formats_that_it_has(dhcli: Run, command: str) -> None:
    """And no others: a class is not written as LaTeX."""
    said = " ".join(dhcli(command, "--help").out.replace("│", " ").split())
    there = formats(KINDS[command])
    endings = {ENDINGS[name][0] for name in there}
    named = said.partition("Write to a file; ")[2].partition(" choose the format")[0]
    assert set(named.split()) == endings
    listed = said.partition("--format NAME ")[2].partition(".")[0].replace(" or ", ", ")
    assert set(listed.split(", ")) == set(there)


def test_every_format_has_an_ending() -> None:
    """So that each can be named as a way out."""
    assert {"json", *FORMATS, *(name for _, name in _RENDERERS)} == set(ENDINGS)
