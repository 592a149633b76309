"""`dhcli new robot --from FILE`, and what is said of such a file elsewhere."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from tests.cli.running import Run

DATA = Path(__file__).parents[1] / "data"


@pytest.mark.parametrize("name", ["puma560.m", "four-links.m", "three-links.txt", "craig.md", "ur5e-kinematics.yaml"])
def test_a_robot_is_made_of_a_file_and_found_by_its_name(dhcli: Run, tmp_path: Path, name: str) -> None:
    """Named as the file, shown and computed."""
    shutil.copy(DATA / "foreign" / name, tmp_path / name)
    stem = Path(name).stem
    written = dhcli("new", "robot", "--from", name)
    assert written.code == 0, written.err
    assert f"next: dhcli show {stem}" in written.err
    assert dhcli("fk", f"robots/{stem}.yaml", "-s").code == 0
    assert dhcli("lint", f"robots/{stem}.yaml").code == 0
    assert dhcli("new", "robot", "--from", name).code == 2


def test_what_is_open_and_what_was_taken_is_said(dhcli: Run) -> None:
    """On standard error, and the file alone on standard output."""
    table = "a,alpha,d,theta\na1,1.5708 rad,0,q1\n"
    done = dhcli("new", "robot", "arm", "--from", "-", "--convention", "standard", "-o", "-", stdin=table)
    assert done.out.startswith("format: 1\ntitle: arm\n")
    assert "note: alpha: 1.5708 rad is taken as 90°" in done.err
    assert "note: a1 has no value yet, see parameters:" in done.err


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["new", "robot"], "a new robot wants a name"),
        (["new", "robot", "arm", "--tip", "hand"], "say how a file is read"),
        (["new", "robot", "--from", "nothing.csv"], "there is no such file"),
        (["new", "robot", "../x", "--from", "table.csv"], "cannot be the name of a robot"),
        (["new", "robot", "--from", "table.csv"], "--convention standard or --convention modified"),
        (["new", "robot", "--from", "arm.urdf"], "has 2 tips: which one?"),
        (["fk", "table.csv"], "this is a DH table as CSV, Markdown or LaTeX"),
        (["show", "./table.csv"], "dhcli new robot --from table.csv --convention standard"),
        (["check", "table.csv"], "this is a DH table as CSV, Markdown or LaTeX"),
        (["dof", "arm.urdf"], "has 2 tips: which one?"),
        (["start", "arm.urdf"], "dhcli describe arm.urdf --as standard"),
        (["fk", "arm.m"], "this is a listing of a robotics toolbox"),
        (["fk", "ros.yaml"], "this is a kinematics file of ROS"),
        (["fk", "arm.sdf"], "this is an SDF"),
        (["fk", "arm.xacro"], "xacro arm.xacro > arm.urdf"),
    ],
)
def test_what_cannot_be_is_refused_with_what_it_is(dhcli: Run, tmp_path: Path, words: list[str], said: str) -> None:
    """And with the command that takes it."""
    shutil.copy(DATA / "urdf" / "three-joints.urdf", tmp_path / "arm.urdf")
    shutil.copy(DATA / "foreign" / "puma560.m", tmp_path / "arm.m")
    shutil.copy(DATA / "foreign" / "ur5e-kinematics.yaml", tmp_path / "ros.yaml")
    (tmp_path / "table.csv").write_text("a,alpha,d,theta\n1,0,0,q1\n", "utf-8")
    (tmp_path / "arm.sdf").write_text("<sdf version='1.6'/>", "utf-8")
    (tmp_path / "arm.xacro").write_text("<robot xmlns:xacro='http://x' name='x'><xacro:a/></robot>", "utf-8")
    done = dhcli(*words)
    assert (done.code, said in done.err) == (2, True), done.err
