"""`dhcli ik --in`: many poses from a file, and the joint values that reach each of them."""

from __future__ import annotations

import csv
import io
import json
from pathlib import Path

import numpy as np
import pytest

from dhcli import forward_batch, inverse_batch, load_robot
from tests.cli.running import Run

Q = "theta1,theta2,theta3,theta4,theta5,theta6\n0.3,-0.5,0.7,1,0.8,-2\n0.1,0.2,0.3,0.4,0.5,0.6\n"
NEAR = "0.3,-0.5,0.7,1,0.8,-2"


@pytest.mark.parametrize("format_", ["csv", "jsonl"])
def test_what_fk_writes_goes_back_in(dhcli: Run, format_: str) -> None:
    """Through standard input: the joint values come back, behind the line that each pose stands in."""
    poses = dhcli("fk", "puma560", "--in", "-", "--format", format_, stdin=Q).out
    done = dhcli("ik", "puma560", "--in", "-", "--each", "nearest", "--near", NEAR, stdin=poses)
    assert done.code == 0, done.err
    rows = list(csv.reader(io.StringIO(done.out)))
    assert rows[0] == ["row", "theta1", "theta2", "theta3", "theta4", "theta5", "theta6"]
    first = 2 if format_ == "csv" else 1
    assert [row[0] for row in rows[1:]] == [str(first), str(first + 1)]
    assert np.allclose(
        [[float(x) for x in row[1:]] for row in rows[1:]], np.loadtxt(io.StringIO(Q), delimiter=",", skiprows=1)
    )


def test_an_array_of_poses_gives_all_solutions_in_an_array(dhcli: Run, tmp_path: Path) -> None:
    """More poses than a block: as many rows as the library gives, each with the number of its pose."""
    robot = load_robot("scara-yim")
    q = np.random.default_rng(1).uniform(-2, 2, (2500, 4))
    poses = forward_batch(robot, q)
    np.save(tmp_path / "poses.npy", poses)
    done = dhcli("ik", "scara-yim", "--in", str(tmp_path / "poses.npy"), "-o", str(tmp_path / "q.npy"))
    assert done.code == 0, done.err
    found, index = inverse_batch(robot, poses)
    table = np.load(tmp_path / "q.npy")
    assert np.array_equal(table[:, 0], index)
    assert np.allclose(table[:, 1:], found)


def test_positions_alone_are_solved_as_positions(dhcli: Run) -> None:
    """Three columns are a point."""
    points = dhcli("fk", "planar-2r", "--in", "-", "--as", "position", stdin="theta1,theta2\n0.3,0.5\n").out
    done = dhcli("ik", "planar-2r", "--in", "-", "--format", "jsonl", stdin=points)
    rows = [json.loads(line) for line in done.out.splitlines()]
    assert [row["row"] for row in rows] == [2, 2]
    assert any(row["q"] == pytest.approx({"theta1": 0.3, "theta2": 0.5}) for row in rows)


def test_poses_out_of_reach_have_no_row_and_are_counted(dhcli: Run) -> None:
    """The command ends with 1."""
    done = dhcli("ik", "planar-2r", "--in", "-", stdin="p_x,p_y,p_z\n0.5,0.2,0\n9,0,0\n")
    assert done.code == 1
    assert "1 of 2 poses have no solution, and no row" in done.err
    assert {row[0] for row in csv.reader(io.StringIO(done.out))} == {"row", "2"}


@pytest.mark.parametrize(
    ("words", "stdin", "said"),
    [
        (("--each", "all"), None, "name their file with --in FILE"),
        (("--in", "-", "--each", "nearest"), "p_x,p_y,p_z\n", "nearest to what?"),
        (("--in", "-", "--each", "best"), "p_x,p_y,p_z\n", "there is no best of solutions"),
        (("--in", "-", "--pose", "ready"), "p_x,p_y,p_z\n", "--pose does not go with --in"),
        (("--in", "no-such.csv"), None, "no-such.csv: cannot be read"),
        (("--in", "-"), "x,y\n1,2\n", "no column is called p_x, p_y, p_z"),
        (("--in", "-"), "p_x,p_y,p_z\n1,two,3\n", "-:2: p_y is 'two', which is no number"),
        (("--in", "-"), "p_x,p_y,p_z\n1,2\n", "p_z is '', which is no number"),
        (("--in", "-"), "p_x,p_y,p_z\n1,nan,3\n", "not a number"),
        (("--in", "-"), '{"matrix": 3}\n', "is no pose"),
        (("--in", "-", "--format", "json"), "p_x,p_y,p_z\n", "jsonl has one object a row"),
    ],
)
def test_what_cannot_be_read_is_refused_with_2(
    dhcli: Run, words: tuple[str, ...], stdin: str | None, said: str
) -> None:
    """With the line it stands in."""
    done = dhcli("ik", "puma560", *words, stdin=stdin)
    assert done.code == 2
    assert said in done.err
