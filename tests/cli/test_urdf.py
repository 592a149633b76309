"""URDF on the command line."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from tests.cli.running import run

ARM = "tests/data/urdf/three-joints.urdf"
ROOT = Path(__file__).parents[2]


def test_a_urdf_stands_where_a_robot_does() -> None:
    """With a tip."""
    done = run("fk", str(ROOT / ARM), "--tip", "tool0", "--q", "0,0,0", "--as", "position")
    assert done.code == 0
    assert "p_z = 0.3" in done.out


def test_what_was_taken_for_round_is_told_where_the_robot_is_shown(tmp_path: Path) -> None:
    """And with each result only where a result shows it."""
    told = "taken for multiples of 15°: 3 of 12 angles"
    near, far = str(ROOT / ARM), tmp_path / "far.urdf"
    far.write_text((ROOT / ARM).read_text("utf-8").replace("1.5708 ", "1.571 "), "utf-8")
    for name, is_seen in ((near, False), (str(far), True)):
        assert told in run("show", name, "--tip", "tool0").err
        assert told in run("describe", name, "--tip", "tool0").err
        assert (told in run("fk", name, "--tip", "tool0", "--q", "0,0,0").err) is is_seen
        assert (told in run("jacobian", name, "--tip", "tool0", "--q", "0,0,0").err) is is_seen
        assert told not in run("show", name, "--tip", "tool0", "--as-typed").err


def test_a_urdf_becomes_a_table_and_a_table_a_urdf(tmp_path: Path) -> None:
    """There and back."""
    table, urdf = tmp_path / "arm.yaml", tmp_path / "arm.urdf"
    assert run("describe", str(ROOT / ARM), "--tip", "tool0", "--as", "modified", "-o", str(table)).code == 0
    assert run("describe", str(table), "-o", str(urdf)).code == 0
    first = run("fk", str(ROOT / ARM), "--tip", "tool0", "--q", "0.1,0.2,0.3", "--format", "csv").out
    again = run("fk", str(urdf), "--q", "0.1,0.2,0.3", "--format", "csv").out
    assert [round(float(x), 12) for x in first.replace("\n", ",").split(",") if x] == [
        round(float(x), 12) for x in again.replace("\n", ",").split(",") if x
    ]


def test_a_link_that_is_typed_for_a_frame_is_told_how_it_becomes_one() -> None:
    """Frames have numbers, links have names."""
    done = run("fk", str(ROOT / ARM), "--tip", "tool0", "--to", "camera", "--q", "0,0,0")
    assert done.code == 2
    said = "a link of the URDF is the last frame with --tip camera, and frame 0 with --base camera"
    assert f"hint: frames: base, 0, 1, 2, 3, tool; {said}" in done.err
    assert "URDF" not in run("fk", "scara", "--to", "camera", "--q", "0,0,0").err


def test_an_exercise_that_is_a_urdf_is_called_one(tmp_path: Path) -> None:
    """Not "should be a mapping"."""
    path = tmp_path / "x.yaml"
    path.write_text("<robot name='x'/>", "utf-8")
    done = run("start", str(path))
    assert done.code == 2
    assert "this is a URDF" in done.err


def test_every_command_about_a_robot_takes_the_links_of_a_urdf(tmp_path: Path) -> None:
    """Each answers for the chain that ends at the tip; a base further on has fewer joints."""
    rows = tmp_path / "q.csv"
    rows.write_text("theta1,theta2,d3\n0.1,0.2,0.3\n", "utf-8")
    poses = tmp_path / "p.csv"
    pose = run("fk", str(ROOT / ARM), "--tip", "tool0", "--rows", str(rows), "-o", str(poses))
    assert pose.code == 0, pose.err
    for words in (
        ("show",),
        ("ik", "--q", "0.1,0.2,0.3"),
        ("ik", "--rows", str(poses)),
        ("jacobian", "--symbolic"),
        ("jacobian", "--rows", str(rows)),
        ("rates", "--q", "0.1,0.2,0.3", "--rates", "1,0,0"),
        ("torques", "--q", "0.1,0.2,0.3", "--force", "1,0,0"),
        ("singularities",),
        ("sweep", "--over", "theta1=0..1 step 0.5", "--q", "theta2=0,d3=0.1"),
    ):
        command, *others = words
        asked = run(command, str(ROOT / ARM), *others)
        assert asked.code == 2, words
        assert "which one?" in asked.err
        done = run(command, str(ROOT / ARM), "--tip", "tool0", *others)
        assert done.code == 0, (words, done.err)
    shown = run("show", str(ROOT / ARM), "--tip", "tool0", "--base", "upper", "--draw")
    assert shown.code == 0, shown.err
    assert "2 joints RP" in shown.out


def test_ik_finds_back_what_fk_has_found_at_a_tip() -> None:
    """With the numbers as typed, so that nothing was taken for something else."""
    done = run("ik", str(ROOT / ARM), "--tip", "tool0", "--as-typed", "--q", "0.1,0.2,0.3", "--format", "json")
    joints = [each["q"] for each in done.envelope["data"]["solutions"]]
    assert any(abs(q[0] - 0.1) < 1e-9 and abs(q[1] - 0.2) < 1e-9 and abs(q[2] - 0.3) < 1e-9 for q in joints)


def test_only_a_robot_has_links_to_choose() -> None:
    """An exercise and a linkage say so."""
    done = run("show", "bennett", "--tip", "hand")
    assert (done.code, "bennett is no robot" in done.err) == (2, True)


def test_a_log_with_the_names_of_the_urdf_is_read(tmp_path: Path) -> None:
    """In any order, with units in the heads."""
    log = tmp_path / "joint_states.csv"
    log.write_text("slide [mm],elbow[deg],shoulder\n200,-60,0.3\n", "utf-8")
    rows = run("fk", str(ROOT / ARM), "--tip", "tool0", "--rows", str(log), "--as", "position").out.splitlines()
    one = run("fk", str(ROOT / ARM), "--tip", "tool0", "--q", "shoulder=0.3,elbow=-60deg,slide=0.2", "--format", "json")
    assert [float(x) for x in rows[1].split(",")] == pytest.approx(
        [row[3] for row in one.data["matrix"][:3]], abs=1e-14
    )


def test_formulas_of_tilted_axes_have_few_decimals_for_people_and_all_for_programs(tmp_path: Path) -> None:
    """An axis whose length is 1 to seven digits; what is typed with many is shown as it was typed."""
    path = tmp_path / "arm.urdf"
    path.write_text(TILTED, encoding="utf-8")
    for words in (
        ("fk", str(path), "--symbolic"),
        ("fk", str(path), "--symbolic", "--let"),
        ("fk", str(path), "--symbolic", "--format", "latex"),
        ("jacobian", str(path), "--symbolic"),
        ("show", str(path), "--format", "md"),
        ("show", str(path), "--format", "latex"),
    ):
        text = run(*words).out
        assert "0.866025" in text or "0.5" in text, words
        assert not re.search(r"\.[0-9]{9}", text), words
    assert "p_z = 0.35" in run("fk", str(path), "--symbolic").out
    assert "0.519615" in run("fk", str(path), "--symbolic").out
    assert "0.51962*" in run("fk", str(path), "--symbolic", "--digits", "5").out
    assert "p_x = 0.05123456" in run("fk", str(path), "--symbolic").out
    assert re.search(r"0\.51961524170\d+", run("fk", str(path), "--symbolic", "--format", "sympy").out)


TILTED = """<robot name="tilted">
  <link name="base"/><link name="tip"/>
  <joint name="j1" type="revolute">
    <parent link="base"/><child link="tip"/><origin xyz="0.05123456 0 0.35"/><axis xyz="0.3 0.4 0.8660254"/>
    <limit lower="-2" upper="2" effort="1" velocity="1"/>
  </joint>
</robot>
"""
"""A joint about an axis that stands at odd angles."""
