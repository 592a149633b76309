"""`dhcli describe`."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest

from dhcli import Robot, forward, load_robot
from dhcli.algebra.floats import Floats
from dhcli.files.yaml.robots import read_robot
from dhcli.notation.parser import parse
from tests.cli.running import run


def test_a_table_in_the_other_convention_says_what_went_to_the_tool() -> None:
    """A planar arm in modified DH needs a tool."""
    out = run("describe", "planar-2r", "--as", "modified").out
    assert "a_{i-1}" in out
    assert "to tool: Trans(a2, 0, 0)" in out
    assert "proved: the same motion from base to tool, for all values" in out


def test_the_steps_name_their_rules_and_what_was_free() -> None:
    """DH1 to DH3, parallel axes."""
    out = " ".join(run("describe", "puma560", "--as", "modified", "--steps").out.split())
    for words in ("DH1: z_i is the axis of joint i", "DH2: x_i is", "DH3: x_i meets it", "are parallel, a2 apart"):
        assert words in out
    assert "free: d2, as a normal stands anywhere; d2 is 0 there" in out
    assert "x3: z3 and z4 are skew" in out


def second_row(out: str) -> list[str]:
    """The cells of row 2 of a table."""
    return next(line for line in out.split("\n") if line.startswith(" 2 ")).split()


def test_a_choice_is_made_as_it_is_asked_for() -> None:
    """The lengths of the maker are negative, and the cylindrical arm has its height in row 1."""
    assert "-a2" in second_row(run("describe", "ur5e", "--as", "standard", "--steps").out)
    assert "a2" in second_row(run("describe", "ur5e", "--as", "standard", "--choose", "previous-x").out)
    out = run("describe", "cylindrical", "--as", "standard", "--choose", "next-d", "--steps").out
    assert " 1   0     0      d1    theta1   revolute" in out
    assert "free: x1 and its origin; x0 is kept, d2 is 0 there" in out


def test_a_written_description_is_a_robot(tmp_path: Path) -> None:
    """And can be described back."""
    path = str(tmp_path / "drawn.yaml")
    assert run("describe", "stanford", "--as", "axes", "-o", path).code == 0
    out = run("describe", path, "--as", "standard").out
    assert [line.split()[1:5] for line in out.split("\n") if line.startswith((" 1 ", " 2 ", " 3 "))] == [
        ["0", "-90°", "0", "theta1"],
        ["0", "90°", "d2", "theta2"],
        ["0", "0", "d3", "0"],
    ]


def test_json_has_the_table_the_steps_and_the_proof() -> None:
    """For programs."""
    data = json.loads(run("describe", "zhou-3r", "--as", "modified", "--steps", "--format", "json").out)["data"]
    assert data["proof"] == {"kind": "exact", "error": 0.0}
    assert data["result"]["convention"] == "modified"
    assert {step["step"] for step in data["steps"]} == {1, 2, 3, 4, 5, 6}


def test_moves_that_share_variables_are_said_beside_the_joints_that_make_them() -> None:
    """On the screen where joints are named, and in JSON; a table has the sums in its cells."""
    assert "theta3 = j3 - j2 · theta4 = -j3" in run("describe", "palletizer", "--as", "axes").out
    assert "theta3 = j3 - j2" in run("describe", "palletizer", "--as", "standard", "--steps").out
    table = run("describe", "palletizer", "--as", "standard").out
    assert "j3 - j2" in table
    assert "theta3 =" not in table
    data = json.loads(run("describe", "palletizer", "--as", "screws", "--format", "json").out)["data"]
    assert data["shared"] == {"theta3": "j3 - j2", "theta4": "-j3"}
    refused = run("describe", "palletizer", "--as", "screws", "--format", "yaml")
    assert (refused.code, refused.out) == (2, "")
    assert "theta3 has no variable of its own" in refused.err


def test_a_joint_that_moves_by_a_part_of_its_variable_says_so_among_axes(tmp_path: Path) -> None:
    """A file of axes has no such joint, and would turn it by all of it; screws have, and are as long."""
    path = tmp_path / "half.yaml"
    head = "format: 1\ntitle: t\nsource: s\nconvention: product\nvariables: [q1]\n"
    path.write_text(f"{head}links:\n  - Rot(z, q1/2) * Trans(1, 0, 0)\n", "utf-8")
    assert " q1/2 " in run("describe", str(path), "--as", "axes").out
    data = json.loads(run("describe", str(path), "--as", "axes", "--format", "json").out)["data"]
    assert [axis["rate"] for axis in data["axes"]] == ["1/2"]
    refused = run("describe", str(path), "--as", "axes", "--format", "yaml")
    assert (refused.code, refused.out) == (2, "")
    assert "q1 moves its joint by 1/2 of its own value" in refused.err
    assert "(0, 0, 0.5, 0, 0, 0)" in run("describe", str(path), "--as", "screws", "--format", "yaml").out


def test_an_arm_is_described_by_its_motor_values_too(tmp_path: Path) -> None:
    """What is written moves by them as `fk --motors` does; the drives themselves are another question."""
    path = str(tmp_path / "by-motors.yaml")
    assert "J2 + J3" in run("describe", "fanuc-like", "--motors", "--as", "standard").out
    assert run("describe", "fanuc-like", "--motors", "--as", "modified", "-o", path).code == 0
    pose = ("--q", "0,30,40,0,10,0", "--deg", "--from", "base", "--to", "tool", "--format", "csv")
    assert run("fk", path, *pose).out == run("fk", "fanuc-like", "--motors", *pose).out
    assert "leave one out" in run("describe", "fanuc-like", "--motors", "--as", "motors").err


def test_a_urdf_of_coupled_motors_says_what_it_has_not_got() -> None:
    """The drives; one without says nothing."""
    assert "no motors that drive joints together" in run("describe", "fanuc-like", "--as", "urdf").err
    assert not run("describe", "palletizer", "--as", "urdf").err


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("scara", "--as", "modifed"), "did you mean modified"),
        (("dh-link", "--as", "axes"), "directions depend on alpha_i"),
        (("scara", "--as", "standard", "--choose", "next_d"), "did you mean next-d"),
        (("scara", "--as", "axes", "--choose", "next-d"), "--choose is about tables"),
        (("scara", "--as", "axes", "--steps"), "--steps tells how a table is found"),
        (("scara", "--as", "standard", "--as-typed"), "only a URDF is read as it is typed"),
        (("assembly-blocks", "--as", "standard"), "no joints"),
        (("scara", "--as", "axes", "--pose", "elbo"), "elbow"),
        (("dh-link", "--as", "modified", "--numbers"), "a_i, alpha_i, d_i have no value"),
    ],
)
def test_what_cannot_be_described_is_said(words: tuple[str, ...], said: str) -> None:
    """Exit code 2 and a reason."""
    result = run("describe", *words)
    assert result.code == 2
    assert said in result.err


def test_every_description_is_told_to_whoever_asks_for_another() -> None:
    """URDF among them, which is a file besides."""
    hint = run("describe", "puma560", "--as", "foo").err.splitlines()[-1]
    assert all(form in hint for form in ("standard", "modified", "axes", "screws", "body-screws", "product", "urdf"))


MEASURED = """
format: 1
title: An arm as it was measured
source: made up
convention: standard
variables: [theta1, theta2]
links:
  - {a: 0.42, alpha: 0.00005 rad, d: 574.3, theta: theta1}
  - {a: 0.39, alpha: 0, d: -574.3, theta: theta2}
"""


def test_axes_are_straightened_on_request_and_it_is_said(tmp_path: Path) -> None:
    """On the screen, in JSON, and in and beside a file that is written."""
    path = tmp_path / "measured.yaml"
    path.write_text(MEASURED, encoding="utf-8")
    assert "574.3" in run("describe", str(path), "--as", "standard").out
    out = run("describe", str(path), "--straighten", "0.01°").out
    assert "574.3" not in out
    assert "straightened within 0.000174533 rad, so not the same robot" in out
    assert "theta2 is turned by 0.0029°: parallel to theta1" in out
    assert "the same motion as the straightened robot" in out
    data = json.loads(run("describe", str(path), "--straighten", "1e-4", "--format", "json").out)["data"]
    assert set(data["straightened"]) == {"within", "exact", "tip", "turn", "strokes", "changes"}
    assert data["straightened"]["exact"] is False
    assert [change["joint"] for change in data["straightened"]["changes"]] == ["theta2", "end"]
    written = run("describe", str(path), "--straighten", "1e-4", "-o", str(tmp_path / "s.yaml"))
    assert "not the same robot" in written.err
    assert "not the same robot" in (tmp_path / "s.yaml").read_text("utf-8")


@pytest.mark.parametrize(
    ("angle", "message"),
    [("10", "up to 5°"), ("0", "above 0"), ("1 mm", "angle is wanted"), ("a", "a is no number"), ("1e-4 +", "")],
)
def test_an_angle_to_straighten_within_is_read_with_care(angle: str, message: str) -> None:
    """Exit 2, and what would be right."""
    result = run("describe", "ur5e", "--straighten", angle)
    assert result.code == 2
    assert message in result.err


SURVEYED = """\
<robot name="measured">
  <link name="l0"/><link name="l1"/><link name="l2"/><link name="l3"/>
  <joint name="j1" type="continuous"><parent link="l0"/><child link="l1"/>
    <origin xyz="0 0 0.333" rpy="1.5707963 0 0"/><axis xyz="0 0 1"/></joint>
  <joint name="j2" type="continuous"><parent link="l1"/><child link="l2"/>
    <origin xyz="{x} 0.2503 0" rpy="-1.5707963 {tilt} 0"/><axis xyz="0 0 1"/></joint>
  <joint name="j3" type="continuous"><parent link="l2"/><child link="l3"/>
    <origin xyz="0.3 0 0.05" rpy="0.785398 0 0.523599"/><axis xyz="0 1 0"/></joint>
</robot>
"""
SIZES = [("0.1001", "0.0012"), ("0.0001", "0.00002"), ("81.5", "1.1"), ("0", "0.3")]


def tip(robot: Robot, q: tuple[float, ...]) -> list[list[float]]:
    """The pose of the tool in the base."""
    return [list(map(float, row)) for row in forward(robot, q, start="base", end="tool").matrix]


def typed_off(out: str, form: str) -> Robot:
    """A robot that somebody has typed off the page."""
    heads, rows, ends = [], [], {}
    for line in out.splitlines():
        cells = re.split(r"\s{2,}", line.strip())
        if cells[0] == "i":
            heads = [cell[0].replace("α", "alpha").replace("θ", "theta") for cell in cells[1:-1]]
            heads = [{"a": "a", "d": "d"}.get(head, head) for head in heads]
        elif heads and cells[0].isdecimal():
            rows.append(", ".join(f"{head}: {cell}" for head, cell in zip(heads, cells[1:-1], strict=True)))
        elif line.startswith(("to base: ", "to tool: ")):
            ends[line[3:7]] = line[9:]
    text = f"format: 1\ntitle: x\nsource: x\nconvention: {form}\nvariables: [j1, j2, j3]\nlinks:\n"
    text += "".join(f"  - {{{row}}}\n" for row in rows) + "".join(f"{key}: {moves}\n" for key, moves in ends.items())
    return read_robot(text, "page", "page")


@pytest.mark.parametrize("form", ["standard", "modified"])
@pytest.mark.parametrize(("x", "tilt"), SIZES)
def test_a_page_has_the_digits_that_the_tip_needs_and_a_file_all(tmp_path: Path, form: str, x: str, tilt: str) -> None:
    """Whoever types the table off gets the tip as near as it says."""
    path = tmp_path / "measured.urdf"
    path.write_text(SURVEYED.format(x=x, tilt=tilt), "utf-8")
    out = run("describe", str(path), "--as", form).out
    assert not re.search(r"\.\d{13}", out)
    said = re.search(r"rounded to (\d+) decimals, which moves the tip by at most (\S+) µm", out)
    assert said is not None
    assert max(map(len, re.findall(r"\.(\d+)", out.partition("rounded")[0]))) <= int(said[1])
    assert float(said[2]) <= 1.0
    typed, robot = typed_off(out, form), load_robot(path)
    files = []
    for name, as_ in (("table.yaml", form), ("arm.urdf", "urdf")):
        assert run("describe", str(path), "--as", as_, "-o", str(tmp_path / name)).code == 0
        files.append(load_robot(tmp_path / name))
    reach = 0.7 + float(x)
    for q in ((0.0, 0.0, 0.0), (0.3, -1.2, 2.0), (-2.5, 0.7, -0.4)):
        right = tip(robot, q)
        off = max(abs(a[3] - b[3]) for a, b in zip(tip(typed, q), right, strict=True))
        assert off <= float(said[2]) * 1.05e-6
        for file in files:
            rows = zip(tip(file, q), right, strict=True)
            assert max(abs(a - b) for r, s in rows for a, b in zip(r, s, strict=True)) <= 1e-12 * max(1.0, reach)
    assert files


def test_a_page_has_the_digits_that_are_asked_for(tmp_path: Path) -> None:
    """In every form; what is short stays so, and nothing becomes nothing."""
    path = tmp_path / "measured.urdf"
    path.write_text(SURVEYED.format(x="0.1001", tilt="0.0012"), "utf-8")
    for form in ("standard", "axes", "screws", "body-screws", "product"):
        words = ("describe", str(path), "--as", form)
        out = run(*words, "--digits", "3").out
        assert "rounded to" not in out
        assert not re.search(r"\.\d{4}", out.replace("0.00036", ""))
        assert re.search(r"\.\d{8}\b", run(*words).out)
        assert re.search(r"\.\d{15}\b", run(*words, "--digits", "15").out)
        exact = run(*words, "--format", "json").data
        assert exact == run(*words, "--format", "json", "--digits", "3").data
    assert "rounded to" not in run("describe", "panda", "--as", "screws").out


def test_the_pose_at_zero_of_a_robot_without_letters_is_numbers(tmp_path: Path) -> None:
    """As forward has it; letters and roots stay."""
    path = tmp_path / "measured.urdf"
    path.write_text(SURVEYED.format(x="0.1001", tilt="0.0012"), "utf-8")
    out = run("describe", str(path), "--as", "screws", "--digits", "12").out
    rows = [line.strip("⎡⎢⎣⎤⎥⎦ ").split() for line in out.splitlines() if line[0] in "⎡⎢⎣"]
    right = tip(load_robot(path), (0.0, 0.0, 0.0))
    assert len(rows) == 4
    for row, known in zip(rows, right, strict=False):
        assert [Floats().value(parse(entry)) for entry in row] == pytest.approx(known, abs=1e-12)
    assert "a2 + a3" in run("describe", "puma560", "--as", "screws").out


def test_the_title_of_a_robot_is_not_rounded(tmp_path: Path) -> None:
    """It is somebody's words."""
    path = tmp_path / "measured.urdf"
    named = SURVEYED.replace('name="measured"', 'name="v1.234567890123456"')
    path.write_text(named.format(x="0.1001", tilt="0.0012"), "utf-8")
    assert run("describe", str(path)).out.startswith("v1.234567890123456 ")


def test_nothing_is_said_of_the_tip_where_lengths_have_no_value(tmp_path: Path) -> None:
    """Nobody knows how far it lies from what is rounded."""
    path = tmp_path / "letters.yaml"
    table = "  - {a: a1, alpha: 1.23456789012345 rad, d: 0, theta: t1}\n  - {a: 0.3, alpha: 0, d: 0, theta: t2}\n"
    head = "format: 1\ntitle: x\nsource: x\nconvention: standard\nvariables: [t1, t2]\n"
    for values, is_told in (("{a1: }", False), ("{a1: 0.4 m}", True)):
        path.write_text(f"{head}parameters: {values}\nlinks:\n{table}", "utf-8")
        out = run("describe", str(path), "--as", "modified").out
        assert ("rounded to 8 decimals" in out, "moves the tip by at most" in out) == (True, is_told)
