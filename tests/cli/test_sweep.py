"""`dhcli sweep`: what it shows, what it writes, and what happens when somebody stops it."""

from __future__ import annotations

import csv
import io
import json
import os
from pathlib import Path

import numpy as np
import pytest

from dhcli import forward, load_robot
from tests.cli.running import Run
from tests.cli.terminal import Terminal

SWEEP = {
    *("robot", "convention", "values", "reference", "frame", "point", "poses", "joints", "box", "extremes"),
}
EXTREMES = ["farthest", "nearest", "x_min", "x_max", "y_min", "y_max", "z_min", "z_max"]
PAGE = """\
sweep of scara: origin of frame 3, seen from frame 0
product of moves · l1 = 0.4 m · l2 = 0.3 m · l3 = 0.2 m · lengths in m
held: theta2 = 90°

 joint    from   to      step     values
 ───────────────────────────────────────
 theta1   -90°   90°     5°       37
 d3       0 m    0.2 m   0.02 m   11

407 poses; reach 0.4123 to 0.5385 m from the origin of frame 0
box: x -0.3605 to 0.3 · y -0.2 to 0.3605 · z 0.2 to 0.4

 extreme    distance   x         y         z     theta1   d3
 ──────────────────────────────────────────────────────────────
 farthest   0.5385      0.3       0.2      0.4   -90°     0 m
 nearest    0.4123      0.3       0.2      0.2   -90°     0.2 m
 x min      0.5385     -0.3605    0.0082   0.4    55°     0 m
 x max      0.5385      0.3       0.2      0.4   -90°     0 m
 y min      0.5385     -0.3      -0.2      0.4    90°     0 m
 y max      0.5385      0.0082    0.3605   0.4   -35°     0 m
 z min      0.4123      0.3       0.2      0.2   -90°     0.2 m
 z max      0.5385      0.3       0.2      0.4   -90°     0 m

extremes of this grid; between its poses the robot may reach a little further
"""
SCARA = ("sweep", "scara", "--over", "theta1=-90°..90° step 30°", "--over", "q2=0..2 n 5", "--over", "d3=0..0.2 n 3")


def test_the_whole_answer_stands_on_a_page(dhcli: Run) -> None:
    """Heading, what was given, the grid, the reach, the box, and a pose for each side: in this order."""
    done = dhcli("sweep", "scara", "--over", "theta1=-90°..90° step 5°", "--over", "d3=0..0.2 n 11", "--q", "q2=90°")
    assert (done.code, done.err) == (0, "")
    assert done.out == PAGE


def test_limits_of_a_file_are_in_degrees_and_radians_stay_what_was_typed(dhcli: Run) -> None:
    """As `show` tells the limits, whose file has 2.8973 rad; the poses of a joint are told as its range is."""
    rows = [line.split() for line in dhcli("sweep", "panda", "--over", "q1", "--over", "q2=-1..1 n 3").out.splitlines()]
    assert ["theta1", "-166.0031°", "166.0031°", "1.8445°", "181"] in rows
    assert ["theta2", "-1", "rad", "1", "rad", "1", "rad", "3"] in rows
    farthest = next(row for row in rows if row[:1] == ["farthest"])
    assert farthest[-3].endswith("°")
    assert farthest[-1] == "rad"


def test_json_has_exactly_these_keys(dhcli: Run) -> None:
    """A new key is a decision, and stands here; joint values are in radians and metres."""
    data = dhcli(*SCARA, "--format", "json").data
    assert set(data) == SWEEP
    assert (data["robot"], data["reference"], data["frame"], data["point"]) == ("scara", "0", "3", [0.0, 0.0, 0.0])
    assert data["poses"] == 7 * 5 * 3
    assert data["values"] == {"l1": 0.4, "l2": 0.3, "l3": 0.2}
    assert data["joints"][2] == {"name": "d3", "first": 0.0, "last": 0.2, "count": 3}
    assert list(data["extremes"]) == EXTREMES
    assert all(set(extreme) == {"distance", "position", "q"} for extreme in data["extremes"].values())
    assert [len(side) for side in data["box"]] == [2, 2, 2]


def test_the_joint_values_of_an_extreme_give_its_position(dhcli: Run) -> None:
    """In full precision, so that `fk` can go on from there."""
    for extreme in dhcli(*SCARA, "--format", "json").data["extremes"].values():
        pose = forward(load_robot("scara"), extreme["q"])
        assert pose.position == pytest.approx(extreme["position"], abs=1e-15)


def test_csv_has_a_line_for_each_extreme(dhcli: Run) -> None:
    """With all joints, also those that stand still."""
    rows = list(csv.reader(io.StringIO(dhcli("sweep", "puma560", "--over", "q1=0..1 n 3", "--format", "csv").out)))
    assert rows[0][:5] == ["extreme", "distance", "p_x", "p_y", "p_z"]
    assert rows[0][5:] == [f"theta{k}" for k in range(1, 7)]
    assert [row[0] for row in rows[1:]] == EXTREMES
    assert all(len(row) == 11 for row in rows)


@pytest.mark.parametrize("robot", ["planar-2r", "puma560", "panda", "zhou-6r"])
def test_no_line_is_wider_than_a_usual_window(dhcli: Run, robot: str) -> None:
    """Whatever the number of joints; wide tables are drawn in parts, and every joint is in one."""
    words = [word for name in load_robot(robot).variables for word in ("--over", f"{name}=-1..1.5708 n 3")]
    done = dhcli("sweep", robot, *words)
    assert done.code == 0
    table = done.out.split("\n\n", 1)[1]
    assert max(map(len, table.split("\n"))) <= 80
    heads = [word for line in done.out.split("\n") if line.startswith(" extreme") for word in line.split()]
    assert [head for head in heads if head != "extreme"] == ["distance", *"xyz", *load_robot(robot).variables]


def test_points_go_to_a_file_and_the_summary_to_stdout(dhcli: Run, tmp_path: Path) -> None:
    """In three formats that hold the same numbers: joint values and position, in the order of the grid."""
    summary = dhcli(*SCARA).out
    for name in ("points.csv", "points.jsonl", "points.npy"):
        done = dhcli(*SCARA, "-o", name)
        assert (done.code, done.out, done.err) == (0, summary, f"wrote {name}: 105 rows\n")
    table = np.load(tmp_path / "points.npy")
    assert table.shape == (105, 6)
    with (tmp_path / "points.csv").open(encoding="utf-8", newline="") as file:
        heads, *rows = csv.reader(file)
    assert heads == ["theta1", "theta2", "d3", "p_x", "p_y", "p_z"]
    assert np.array_equal(np.array(rows, dtype=float), table)
    lines = [json.loads(line) for line in (tmp_path / "points.jsonl").read_text("utf-8").splitlines()]
    assert [[*line["q"].values(), *line["position"]] for line in lines] == table.tolist()
    assert list(lines[0]["q"]) == heads[:3]
    for row in table[::13]:
        assert forward(load_robot("scara"), row[:3].tolist()).position == pytest.approx(row[3:], abs=1e-14)


def test_a_file_that_is_there_stays_unless_it_may_be_overwritten(dhcli: Run, tmp_path: Path) -> None:
    """And nothing is computed before that is known."""
    (tmp_path / "points.csv").write_text("precious")
    done = dhcli(*SCARA, "-o", "points.csv")
    assert (done.code, done.out) == (2, "")
    assert "points.csv: exists already" in done.err
    assert (tmp_path / "points.csv").read_text() == "precious"
    assert dhcli(*SCARA, "-o", "points.csv", "--overwrite").code == 0
    assert (tmp_path / "points.csv").read_text("utf-8").count("\n") == 106


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("scra",), "did you mean scara"),
        (("scara",), "say it: --over theta1 --over theta2 --over d3=0..0.2"),
        (("scara", "--over", "d3=0..30°"), "--over:7: deg is a unit of angle"),
        (("dh-link",), "--set a_i=0.4"),
        (("puma560", "--over", "q1", "--q", "1,2"), "puma560 has 6 joints, 2 values given"),
        (("puma560", "--over", "q1", "--pose", "redy"), "did you mean ready?"),
        (("puma560", "--pose", "ready"), "nothing to sweep"),
        (("puma560", "--to", "9"), "puma560 has no frame 9"),
        (("puma560", "--to", "0"), "no joint moves this point of frame 0"),
        (("puma560", "--point", "1,2"), "a point has three coordinates"),
        (("puma560", "--point", "1,2,q8"), "q8 of the point has no value"),
        (("puma560", "--point", "1,2,theta1"), "theta1 of the point has no value"),
        (("puma560", "--format", "latex"), "there is no format latex for a sweep"),
        (("puma560", "-o", "points.json"), "known suffixes of points: .csv .jsonl .ndjson .npy"),
        (("puma560", "-o", "nowhere/points.csv"), "there is no folder nowhere"),
        (("puma560", "--overwrite"), "--overwrite needs a file"),
        (("puma560", "--over", "q1=0..1 n 1000000000000"), "1,000,000,000,000 values"),
        (("puma560", "--jobs", "0"), "'--jobs': 0 is not in the range"),
        (("puma560", "--jobs", "-3"), "'--jobs': -3 is not in the range"),
        (("puma560", "--jobs", "all"), "'--jobs': 'all' is not a whole number"),
    ],
)
def test_bad_input_ends_with_2_and_words(dhcli: Run, tmp_path: Path, words: tuple[str, ...], said: str) -> None:
    """Nothing on stdout, no file, no traceback."""
    done = dhcli("sweep", *words)
    assert (done.code, done.out) == (2, "")
    assert done.err.startswith("dhcli: ")
    assert said in done.err
    assert not list(tmp_path.iterdir())


def test_any_number_of_jobs_says_the_same(dhcli: Run, tmp_path: Path) -> None:
    """The same summary, the same points in the same order, the same picture; of a grid of many blocks."""
    ranges = [word for k in (1, 2, 3) for word in ("--over", f"q{k}=-1..1 n 47")]
    said = set()
    for jobs in ("1", "2", "5"):
        files = ("-o", f"{jobs}.npy", "--draw", f"{jobs}.svg")
        done = dhcli("sweep", "puma560", *ranges, *files, "--jobs", jobs)
        assert done.code == 0
        said.add(done.out.replace(f"{jobs}.svg", "").replace(f"{jobs}.npy", ""))
    said.add(dhcli("sweep", "puma560", *ranges).out)
    assert len(said) == 1
    for suffix in ("npy", "svg"):
        assert len({(tmp_path / f"{jobs}.{suffix}").read_bytes() for jobs in (1, 2, 5)}) == 1


def test_warnings_are_said_and_stand_in_json(dhcli: Run) -> None:
    """Degrees that were taken for radians are not a mistake of the program."""
    done = dhcli("sweep", "planar-2r", "--over", "q1=0..90 n 3", "--format", "json")
    assert done.code == 0
    assert [problem["severity"] for problem in done.envelope["problems"]] == ["warning"]
    assert "did you mean 90°, or --deg?" in done.err


def test_deg_takes_bare_numbers_for_degrees(dhcli: Run) -> None:
    """In ranges and in --q."""
    words = ("sweep", "planar-2r", "--over", "q1=0..90 step 45", "--q", "q2=90", "--deg", "--format", "json")
    assert dhcli(*words).data["joints"] == [
        {"name": "theta1", "first": 0.0, "last": np.pi / 2, "count": 3},
        {"name": "theta2", "first": np.pi / 2, "last": np.pi / 2, "count": 1},
    ]


def test_a_point_of_another_frame_is_followed(dhcli: Run) -> None:
    """Which the heading says."""
    words = ("sweep", "planar-2r", "--to", "1", "--point", "0,a2,0")
    done = dhcli(*words)
    assert done.out.startswith("sweep of planar-2r: (0, 0.3, 0) of frame 1, seen from frame 0\n")
    data = dhcli(*words, "--format", "json").data
    assert data["extremes"]["farthest"]["distance"] == pytest.approx(0.5)
    assert [joint["count"] for joint in data["joints"]] == [181, 1]


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs /dev/full")
def test_a_full_disk_is_told(dhcli: Run, tmp_path: Path) -> None:
    """And the summary is not, for the points are not there."""
    (tmp_path / "points.csv").symlink_to("/dev/full")
    done = dhcli(*SCARA, "-o", "points.csv")
    assert (done.code, done.out) == (2, "")
    assert "points.csv: cannot be written: the disk is full" in done.err


@pytest.mark.skipif(os.name == "nt", reason="pseudo-terminals as Unix knows them")
def test_ctrl_c_ends_with_130_and_leaves_no_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """While the bar on the terminal says how far it is."""
    monkeypatch.setattr("dhcli.kinematics.sweep.walk.BLOCK", 1024)
    ranges = [word for k in (1, 2, 3) for word in ("--over", f"q{k}=0..1 n 1000")]
    with Terminal(tmp_path, "sweep", "puma560", *ranges, "-o", "points.csv", own_process=True) as screen:
        screen.until(r"[1-9][0-9,]* rows")
        assert [path.suffix for path in tmp_path.iterdir()] == [".tmp"]
        screen.interrupt()
        assert screen.end() == 130
        assert "Traceback" not in screen.seen
    assert not list(tmp_path.iterdir())


def test_a_small_step_is_not_shown_as_zero(dhcli: Run) -> None:
    """Nor is the end of a small range."""
    done = dhcli("sweep", "scara", "--over", "d3=0..0.03mm n 3")
    assert ["d3", "0", "m", "0.00003", "m", "0.000015", "m", "3"] in [line.split() for line in done.out.splitlines()]


def test_the_arm_among_the_points_holds_the_joints_that_they_were_swept_with(dhcli: Run, tmp_path: Path) -> None:
    """The pose that shows a robot best may be none of those swept."""
    for held, said in (([], "theta1 = 0°"), (["--q", "theta1=35°,theta3=20°"], "theta1 = 35°")):
        words = ("sweep", "articulated", "--over", "theta2=0..90° n 20", *held, "--draw", "w.svg", "--overwrite")
        assert said in dhcli(*words).out
        assert f"{said.replace('theta', 'θ')}, θ2 = " in (tmp_path / "w.svg").read_text("utf-8")


def test_points_are_drawn_from_two_sides_or_in_space(dhcli: Run, tmp_path: Path) -> None:
    """Beside the summary, which is as it is without a picture."""
    words = ("sweep", "planar-2r", "--over", "theta1 n 41", "--over", "theta2 n 41")
    plain = dhcli(*words)
    for name, begins in (("w.svg", "<svg"), ("w.html", "<!DOCTYPE")):
        done = dhcli(*words, "--draw", name)
        assert (done.code, done.out, done.err) == (0, plain.out, f"wrote {name}\n")
        assert Path(name).read_text("utf-8").startswith(begins)
    again = dhcli(*words, "--draw", "w.svg")
    assert again.code == 2
    assert "exists already" in again.err
    assert dhcli(*words, "--draw", "w.svg", "--overwrite").code == 0
    assert dhcli(*words, "--draw", "w").code == 2
