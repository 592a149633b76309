"""`dhcli ik --rows`: many poses from a file, and the joint values that reach each of them."""

from __future__ import annotations

import csv
import io
import json
import math
import os
import signal
from pathlib import Path

import numpy as np
import pytest

from dhcli import forward_batch, inverse_batch, load_robot
from tests.cli.running import PIPES, Run, start
from tests.row_by_row import row_by_row

Q = "theta1,theta2,theta3,theta4,theta5,theta6\n0.3,-0.5,0.7,1,0.8,-2\n0.1,0.2,0.3,0.4,0.5,0.6\n"
NEAR = "0.3,-0.5,0.7,1,0.8,-2"


@pytest.mark.parametrize("format_", ["csv", "jsonl"])
def test_what_fk_writes_goes_back_in(dhcli: Run, format_: str) -> None:
    """Through standard input: the joint values come back, behind the line that each pose stands in."""
    poses = dhcli("fk", "puma560", "--rows", "-", "--format", format_, stdin=Q).out
    done = dhcli("ik", "puma560", "--rows", "-", "--each", "nearest", "--near", NEAR, stdin=poses)
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
    done = dhcli("ik", "scara-yim", "--rows", str(tmp_path / "poses.npy"), "-o", str(tmp_path / "q.npy"))
    assert done.code == 0, done.err
    found, index = inverse_batch(robot, poses)
    table = np.load(tmp_path / "q.npy")
    assert np.array_equal(table[:, 0], index)
    assert np.allclose(table[:, 1:], found)


@pytest.mark.parametrize("format_", ["csv", "jsonl"])
@pytest.mark.parametrize("form", ["quaternion", "rpy", "axis-angle", "rotation-vector", "zyz", "fixed-xyz"])
def test_a_position_with_an_orientation_is_a_whole_pose(dhcli: Run, form: str, format_: str) -> None:
    """In whatever way fk says it: the orientation is kept, not left out."""
    poses = dhcli("fk", "puma560", "--rows", "-", "--as", f"position,{form}", "--format", format_, stdin=Q).out
    done = dhcli("ik", "puma560", "--rows", "-", "--each", "nearest", "--near", NEAR, stdin=poses)
    assert done.code == 0, done.err
    found = np.loadtxt(io.StringIO(done.out), delimiter=",", skiprows=1)[:, 1:]
    assert np.allclose(found, np.loadtxt(io.StringIO(Q), delimiter=",", skiprows=1))


def test_what_else_stands_beside_a_position_is_never_left_aside_unsaid(dhcli: Run) -> None:
    """Columns of another program are asked about; the number of a row is none, and a task leaves them aside."""
    text = "row,p_x,p_y,p_z,rx,ry,rz\n1,0.5,0.2,0,0,0,0\n"
    done = dhcli("ik", "planar-2r", "--rows", "-", stdin=text)
    assert done.code == 2
    assert "rx, ry, rz beside a position" in done.err
    assert "r_x,r_y,r_z" in done.err
    assert dhcli("ik", "planar-2r", "--rows", "-", "--task", "position", stdin=text).code == 0
    assert dhcli("ik", "planar-2r", "--rows", "-", stdin="row,p_x,p_y,p_z\n1,0.5,0.2,0\n").code == 0


def test_columns_may_be_called_as_others_call_them(dhcli: Run) -> None:
    """The same as `fk` calls them; the same twice is refused."""
    row = "0.4,0.1,0.3,0,1,0,0\n"
    own = dhcli("ik", "ur5e", "--rows", "-", stdin="p_x,p_y,p_z,q_w,q_x,q_y,q_z\n" + row)
    assert own.code == 0
    for heads in ("x,y,z,qw,qx,qy,qz", "px,PY,pz,q_w,q_x,q_y,q_z", "pos_x,pos_y,pos_z,qw,qx,qy,qz"):
        assert dhcli("ik", "ur5e", "--rows", "-", stdin=f"{heads}\n{row}").out == own.out
    assert "p_x has two columns" in dhcli("ik", "ur5e", "--rows", "-", stdin="x,p_x,y,z\n1,1,1,1\n").err


def test_positions_alone_are_solved_as_positions(dhcli: Run) -> None:
    """Three columns are a point."""
    points = dhcli("fk", "planar-2r", "--rows", "-", "--as", "position", stdin="theta1,theta2\n0.3,0.5\n").out
    done = dhcli("ik", "planar-2r", "--rows", "-", "--format", "jsonl", stdin=points)
    rows = [json.loads(line) for line in done.out.splitlines()]
    assert [row["row"] for row in rows] == [2, 2]
    assert any(row["q"] == pytest.approx({"theta1": 0.3, "theta2": 0.5}) for row in rows)


def test_poses_out_of_reach_have_no_row_and_are_counted(dhcli: Run) -> None:
    """The command ends with 1."""
    done = dhcli("ik", "planar-2r", "--rows", "-", stdin="p_x,p_y,p_z\n0.5,0.2,0\n9,0,0\n")
    assert done.code == 1
    assert "1 of 2 poses has no solution, and no row" in done.err
    assert {row[0] for row in csv.reader(io.StringIO(done.out))} == {"row", "2"}


@row_by_row(
    ("words", "stdin", "said"),
    [
        (("--each", "all"), None, "name their file with --rows FILE"),
        (("--rows", "-", "--each", "nearest"), "p_x,p_y,p_z\n", "nearest to what?"),
        (("--rows", "-", "--each", "best"), "p_x,p_y,p_z\n", "there is no best of solutions"),
        (("--rows", "-", "--pose", "ready"), "p_x,p_y,p_z\n", "--pose does not go with --rows"),
        (("--rows", "no-such.csv"), None, "no-such.csv: there is no such file"),
        (("--rows", "-"), "a,b\n1,2\n", "no column is called p_x, p_y, p_z"),
        (("--rows", "-"), "p_x[deg],p_y,p_z\n1,2,3\n", "deg is a unit of angle, and p_x is a length"),
        (("--rows", "-"), "p_x,p_y[ft],p_z\n1,2,3\n", "standard input:1:5: ft is no unit"),
        (("--rows", "-"), "p_x,p_y,p_z,q_w[deg],q_x,q_y,q_z\n1,2,3,1,0,0,0\n", "q_w has no unit, and not deg"),
        (("--rows", "-"), "p_x,p_y,p_z\n1,two,3\n", "standard input:2:3: p_y 'two' is not a number"),
        (("--rows", "-"), "p_x,p_y,p_z\n1,20 cm,3\n", "the unit stands once, in the header: [cm]"),
        (("--rows", "-"), "p_x,p_y,p_z\n1,2\n", "standard input:2: 2 cells in a table of 3 columns"),
        (("--rows", "-"), "p_x,p_y,p_z\n1,nan,3\n", "not a finite number"),
        (("--rows", "-"), '{"matrix": 3}\n', "is no pose"),
        (("--rows", "-"), "", "standard input: is empty"),
        (("--rows", "-"), "p_x,p_y,p_z,q_w,q_x,q_y,q_z\n1,2,3,0,0,0,0\n", "are all 0: that is no quaternion"),
        (("--rows", "-"), '{"position": [1, 0, 0], "orientation": [1]}\n', "orientation beside a position"),
        (("--rows", "-", "--format", "json"), "p_x,p_y,p_z\n", "jsonl has one object a row"),
    ],
)
def test_what_cannot_be_read_is_refused_with_2(
    dhcli: Run, words: tuple[str, ...], stdin: str | None, said: str
) -> None:
    """With the line it stands in."""
    done = dhcli("ik", "puma560", *words, stdin=stdin)
    assert done.code == 2
    assert said in done.err


FLAT = """format: 1
title: flat arm whose third joint undoes the second
source: made for the tests
convention: standard
variables: [q1, q2, q3]
links:
  - {a: 0.4, alpha: 0, d: 0, theta: q1}
  - {a: 0.3, alpha: 0, d: 0, theta: q2}
  - {a: 0.3, alpha: 0, d: 0, theta: -q2}
  - {a: 0.2, alpha: 0, d: 0, theta: q3}
"""


def test_rows_that_may_not_be_all_are_said_to_be_so(dhcli: Run, tmp_path: Path) -> None:
    """Four moves by three variables in a plane; once for all rows, and not where one is held."""
    robot = tmp_path / "flat.yaml"
    robot.write_text(FLAT, encoding="utf-8")
    poses = dhcli("fk", str(robot), "--rows", "-", stdin="0.3,0.5,0.1\n0.2,0.6,0.7\n").out
    told = dhcli("ik", str(robot), "--rows", "-", stdin=poses)
    assert len(told.out.splitlines()) == 5
    assert told.err.count("4 moves by 3 variables: looked for from many places, which may not find all") == 1
    held = dhcli("ik", str(robot), "--rows", "-", "--hold", "q1=0.3", stdin=poses)
    assert held.err.count("which may not find all") == 0
    assert [line.split(",")[0] for line in held.out.splitlines()] == ["row", "2"]


def circle(turns: float, radius: float = 0.15) -> str:
    """Points on a circle around (0.35, 0), as CSV."""
    angles = np.linspace(0, 2 * np.pi * turns, 40)
    rows = [f"{0.35 + radius * math.cos(a)},{radius * math.sin(a)},0" for a in angles.tolist()]
    return "p_x,p_y,p_z\n" + "\n".join(rows) + "\n"


def test_a_path_stays_on_one_branch(dhcli: Run) -> None:
    """The one that begins near the values given; each row is near to the one before it."""
    for elbow in (1, -1):
        near = f"{-0.5 * elbow},{elbow}"
        done = dhcli("ik", "planar-2r", "--rows", "-", "--follow", "--near", near, stdin=circle(1))
        assert done.code == 0, done.err
        rows = np.loadtxt(io.StringIO(done.out), delimiter=",", skiprows=1)
        assert rows[:, 0].tolist() == list(range(2, 42))
        assert (rows[:, 2] * elbow > 0).all()
        assert np.abs(np.diff(rows[:, 1:], axis=0)).max() < 0.5
        assert not done.err


def test_a_path_tells_what_it_cannot_reach(dhcli: Run) -> None:
    """By the line; the rows that are reached are there."""
    done = dhcli(
        "ik", "planar-2r", "--rows", "-", "--follow", "--near", "0,1", stdin="p_x,p_y,p_z\n0.5,0,0\n2,0,0\n0.5,0.1,0\n"
    )
    assert done.code == 1
    assert "out of reach, and without a row: row 3" in done.err
    assert [line.split(",")[0] for line in done.out.splitlines()] == ["row", "2", "4"]


def test_a_path_of_a_palletizer_is_followed(dhcli: Run) -> None:
    """Its rods move joints together; the rows come back, and the one out of reach is told."""
    q = "j1,j2,j3,j4\n" + "".join(f"{0.1 * k:.1f},{1.5 - 0.1 * k:.1f},{-0.1 * k:.1f},{0.4 * k:.1f}\n" for k in range(5))
    head, *poses = (line.split(",") for line in dhcli("fk", "palletizer", "--rows", "-", stdin=q).out.splitlines())
    poses[2][head.index("p_z")] = "9.0"
    rows = "".join(",".join(row) + "\n" for row in (head, *poses))
    done = dhcli("ik", "palletizer", "--rows", "-", "--follow", "--near", "0,1.5,0,0", stdin=rows)
    assert done.code == 1
    assert "out of reach, and without a row: row 4" in done.err
    found = np.loadtxt(io.StringIO(done.out), delimiter=",", skiprows=1)[:, 1:]
    wanted = np.loadtxt(io.StringIO(q), delimiter=",", skiprows=1)
    assert found == pytest.approx(np.delete(wanted, 2, axis=0), abs=1e-9)


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (("--follow",), "are for many rows"),
        (("--rows", "-", "--follow"), "begin near to"),
        (("--rows", "-", "--follow", "--near", "0,1", "--each", "all"), "leave --each out"),
        (("--rows", "-", "--follow", "--near", "0,1", "--within-limits"), "leave --within-limits out"),
    ],
)
def test_a_path_that_cannot_be_followed_says_why(dhcli: Run, options: tuple[str, ...], said: str) -> None:
    """It needs rows, a beginning, and has one solution each."""
    done = dhcli("ik", "planar-2r", *options, stdin="p_x,p_y,p_z\n0.5,0,0\n")
    assert done.code == 2
    assert said in done.err


def test_a_path_is_of_poses_or_of_positions(dhcli: Run) -> None:
    """The row is named where the other begins; one by one they are solved all the same."""
    text = '{"position": [0.3, 0.2, 0.3], "rpy": {"roll": 0, "pitch": 0, "yaw": 0}}\n{"position": [0.3, 0.2, 0.3]}\n'
    done = dhcli("ik", "scara", "--rows", "-", "--follow", "--near", "0,1,0.1", stdin=text)
    assert (done.code, "standard input:2: is a position among poses" in done.err) == (2, True), done.err
    assert "2," in dhcli("ik", "scara", "--rows", "-", stdin=text).out


def test_rows_that_are_no_pose_may_be_left_out(dhcli: Run) -> None:
    """A word for a number, a row too short, a matrix that is no rotation: each is named, the others are solved."""
    head = "r11,r12,r13,p_x,r21,r22,r23,p_y,r31,r32,r33,p_z\n"
    good = "1,0,0,0.5,0,-1,0,0.2,0,0,-1,-0.2\n"
    text = head + good + good.replace("0.5", "far") + "1,0,0\n" + good.replace("1,", "2,", 1) + good
    done = dhcli("ik", "scara-yim", "--rows", "-", "--skip-bad", "--each", "first", stdin=text)
    assert done.code == 0, done.err
    assert [line.split(",")[0] for line in done.out.splitlines()] == ["row", "2", "6"]
    assert all(f"standard input:{line}" in done.err for line in (3, 4, 5))
    assert "left out 3 of 5 rows:" in done.err
    assert dhcli("ik", "scara-yim", "--rows", "-", stdin=text).code == 2
    assert "far" in dhcli("ik", "scara-yim", "--rows", "-", stdin=text).err


def test_a_matrix_that_is_no_rotation_is_told_by_its_own_row(dhcli: Run, tmp_path: Path) -> None:
    """Not by the first of the rows that are solved with it; and rows of which none is a pose are no result."""
    poses = np.tile(np.eye(4), (3, 1, 1))
    poses[1, 0, 0] = 2
    np.save(tmp_path / "p.npy", poses)
    done = dhcli("ik", "puma560", "--rows", "p.npy")
    assert done.code == 2
    assert "p.npy[1]" in done.err
    assert "p.npy[0]" not in done.err
    np.save(tmp_path / "p.npy", poses[1:2])
    for more in ((), ("--follow", "--near", NEAR)):
        none = dhcli("ik", "puma560", "--rows", "p.npy", "--skip-bad", *more)
        assert (none.code, none.out, "no row can be read" in none.err) == (2, "", True)


@pytest.mark.parametrize("form", ["csv", "jsonl"])
def test_what_it_writes_goes_back_through_fk(dhcli: Run, form: str) -> None:
    """There and back by two pipes, the numbers of rows in front all the way."""
    text = "p_x,p_y,p_z\n0.3,0.2,0.1\n0.4,0.2,0.1\n"
    joints = dhcli("ik", "scara", "--rows", "-", "--format", form, stdin=text)
    poses = dhcli("fk", "scara", "--rows", "-", "--as", "position", "--index", stdin=joints.out)
    assert (joints.code, poses.code) == (0, 0), joints.err + poses.err
    rows = [[float(cell) for cell in line.split(",")] for line in poses.out.splitlines()[1:]]
    assert [round(row[1], 12) for row in rows] == [0.3, 0.3, 0.4, 0.4]
    assert dhcli("jacobian", "scara", "--rows", "-", stdin=joints.out).code == 0
    assert dhcli("ik", "scara", "--rows", "-", stdin=poses.out).code == 0


def _three_blocks() -> list[str]:
    """4200 places in the plane of an arm, some of them out of its reach, as rows of CSV with a heading."""
    places = np.random.default_rng(2).uniform((-0.4, -0.4, 0.0), (0.9, 0.9, 0.0), (4200, 3))
    return ["p_x,p_y,p_z\n", *(",".join(map(repr, place)) + "\n" for place in places.tolist())]


def test_a_pose_may_have_its_units_in_the_heads(dhcli: Run) -> None:
    """As joint values may; with cells in blocks, one by one, and an orientation."""
    plain = dhcli("ik", "planar-2r", "--rows", "-", stdin="p_x,p_y,p_z\n0.5,0.2,0\n").out
    assert dhcli("ik", "planar-2r", "--rows", "-", stdin="p_y (cm),P_X [mm],p_z[m]\n20,500,0\n").out == plain
    assert dhcli("ik", "planar-2r", "--rows", "-", stdin='p_y (cm),P_X [mm],p_z\n"20",500,0\n').out == plain
    turned = dhcli(
        "ik", "puma560", "--rows", "-", stdin="p_x,p_y,p_z,roll,pitch,yaw\n0.5,0.2,0,0,0,1.5707963267948966\n"
    )
    told = dhcli("ik", "puma560", "--rows", "-", stdin="p_x[mm],p_y,p_z,roll,pitch,yaw[deg]\n500,0.2,0,0,0,90\n")
    assert turned.out == told.out
    assert turned.out.count("\n") > 4


def test_processes_write_what_one_does(dhcli: Run, tmp_path: Path) -> None:
    """The same bytes, and the same words about what has no solution."""
    path = tmp_path / "places.csv"
    path.write_text("".join(_three_blocks()))
    ways = [dhcli("ik", "planar-2r", "--task", "position", "--rows", str(path), "--jobs", jobs) for jobs in ("1", "2")]
    assert ways[0] == ways[1]
    assert ways[0].code == 1
    assert "of 4200 poses have no solution" in ways[0].err
    assert ways[0].out.count("\n") > 1000


def test_processes_stop_at_the_row_where_one_does(dhcli: Run, tmp_path: Path) -> None:
    """A cell that is no number in the third block, with the rows of the blocks before it."""
    path = tmp_path / "places.csv"
    path.write_text("".join([*_three_blocks()[:4150], "1,2,three\n"]))
    ways = [dhcli("ik", "planar-2r", "--task", "position", "--rows", str(path), "--jobs", jobs) for jobs in ("1", "2")]
    assert ways[0] == ways[1]
    assert ways[0].code == 2
    assert "places.csv:4151:5: p_z 'three' is not a number" in ways[0].err
    assert ways[0].out.count("\n") > 1000


def test_a_path_is_not_shared(dhcli: Run) -> None:
    """Each of its rows goes on from the one before; one process is as many as there may be."""
    line = ("ik", "planar-2r", "--task", "position", "--rows", "-", "--follow", "--near", "0.1,0.2", "--jobs")
    done = dhcli(*line, "2", stdin="p_x,p_y,p_z\n0.6,0.2,0\n")
    assert (done.code, done.out) == (2, "")
    assert "--follow goes from row to row" in done.err
    assert dhcli(*line, "1", stdin="p_x,p_y,p_z\n0.6,0.2,0\n").code == 0


@pytest.mark.skipif(os.name == "nt", reason="signals as Unix knows them")
def test_ctrl_c_stops_all_processes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """It comes once rows have been written, while others are at work on the next ones."""
    monkeypatch.setattr("dhcli.files.rows.poses.BLOCK", 256)
    pose = forward_batch(load_robot("puma560"), [[0.3, -0.5, 0.7, 1, 0.8, -2]])
    np.save(tmp_path / "poses.npy", np.broadcast_to(pose, (20_000, *pose.shape[1:])))  # seconds of work
    words = ["ik", "puma560", "--rows", "poses.npy", "--jobs", "2"]
    with start(tmp_path, *words, **PIPES, start_new_session=True) as running:
        assert running.stdout is not None
        for _ in range(2_500):  # more than the first block, so that the others have begun
            running.stdout.readline()
        os.killpg(running.pid, signal.SIGINT)
        _, err = running.communicate(timeout=60)  # it ends when nobody is left who could write there
    assert running.returncode == 130
    assert "Traceback" not in err
