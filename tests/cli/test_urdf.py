"""URDF on the command line."""

from __future__ import annotations

from pathlib import Path

from tests.cli.running import run

ARM = "tests/data/urdf/three-joints.urdf"
ROOT = Path(__file__).parents[2]


def test_a_urdf_stands_where_a_robot_does() -> None:
    """With a tip; what was taken for round is a warning."""
    done = run("fk", str(ROOT / ARM), "--tip", "tool0", "--q", "0,0,0", "--as", "position")
    assert done.code == 0
    assert "p_z = 0.3" in done.out
    assert "3 of 12 angles are multiples of 15° rounded" in done.err
    assert "rounded" not in run("fk", str(ROOT / ARM), "--tip", "tool0", "--q", "0,0,0", "--as-typed").err


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


def test_an_exercise_that_is_a_urdf_is_called_one(tmp_path: Path) -> None:
    """Not "should be a mapping"."""
    path = tmp_path / "x.yaml"
    path.write_text("<robot name='x'/>", "utf-8")
    done = run("start", str(path))
    assert done.code == 2
    assert "this is a URDF" in done.err
