"""`dhcli fk --rows`: a pose for each row of a file; files, forms, frames, and bad rows."""

from __future__ import annotations

import csv
import io
import json
import math
import os
from pathlib import Path

import numpy as np
import pytest

from dhcli import forward, load_robot
from tests.cli.running import Run
from tests.row_by_row import row_by_row

pytestmark = pytest.mark.usefixtures("json_by")

POSIX = pytest.mark.skipif(os.name != "posix", reason="streams and signals as POSIX has them")
MATRIX = "r11,r12,r13,p_x,r21,r22,r23,p_y,r31,r32,r33,p_z"
GOOD = "theta1,theta2,d3\n0.3,0.5,0.1\n-0.2,1.5,0\n"


def table(text: str) -> np.ndarray:
    """The numbers of a CSV file with a header."""
    return np.array([[float(cell) for cell in row] for row in list(csv.reader(io.StringIO(text)))[1:]])


def puma(rows: int) -> np.ndarray:
    """Joint values for PUMA 560 within its limits."""
    return np.random.default_rng(5).uniform(-1, 0.7, (rows, 6))


@pytest.mark.parametrize("given", ["csv", "jsonl", "npy"])
@pytest.mark.parametrize("wanted", ["csv", "jsonl", "npy"])
def test_every_row_is_the_pose_of_its_joint_values(dhcli: Run, tmp_path: Path, given: str, wanted: str) -> None:
    """The law: as `forward` one by one, whatever the files are."""
    q = puma(9)
    names = ",".join(f"theta{i}" for i in range(1, 7))
    np.save("q.npy", q)
    Path("q.csv").write_text(f"{names}\n" + "".join(",".join(map(repr, row)) + "\n" for row in q.tolist()), "utf-8")
    Path("q.jsonl").write_text("".join(json.dumps(row) + "\n" for row in q.tolist()), "utf-8")
    done = dhcli("fk", "puma560", "--rows", f"q.{given}", "-o", f"poses.{wanted}")
    assert (done.code, done.out, done.err) == (0, "", f"wrote poses.{wanted}: 9 rows\n")
    robot = load_robot("puma560")
    expected = np.array([forward(robot, list(row)).matrix for row in q])
    match wanted:
        case "npy":
            poses = np.load("poses.npy", allow_pickle=False)
        case "csv":
            assert Path("poses.csv").read_text("utf-8").split("\n")[0] == MATRIX
            rows = table(Path("poses.csv").read_text("utf-8")).reshape(-1, 3, 4)
            poses = np.concatenate([rows, np.tile([0.0, 0, 0, 1], (9, 1, 1))], axis=1)
        case _:
            poses = np.array([json.loads(line)["matrix"] for line in Path("poses.jsonl").read_text().splitlines()])
    assert poses.shape == (9, 4, 4)
    assert np.allclose(poses, expected, rtol=0, atol=1e-12)
    assert not list(tmp_path.glob(".*"))


def test_several_forms_stand_side_by_side(dhcli: Run) -> None:
    """In the order in which they are asked for, angles in radians; JSON nests them as `--format json` does."""
    words = ("fk", "scara", "--rows", "-", "--as", "position,rpy", "--as", "quaternion")
    done = dhcli(*words, stdin=GOOD)
    assert done.out.split("\n")[0] == "p_x,p_y,p_z,roll,pitch,yaw,q_w,q_x,q_y,q_z"
    pose = forward(load_robot("scara"), [0.3, 0.5, 0.1])
    said, turn = pose.rpy, pose.quaternion
    expected = [*pose.position, said.roll, said.pitch, said.yaw, turn.w, turn.x, turn.y, turn.z]
    assert table(done.out)[0] == pytest.approx(expected, abs=1e-12)
    [first, _] = map(json.loads, dhcli(*words, "--format", "jsonl", stdin=GOOD).out.splitlines())
    assert set(first) == {"position", "rpy", "quaternion"}
    assert first["position"] == pytest.approx(list(pose.position))
    assert first["rpy"]["yaw"] == pytest.approx(said.yaw)
    assert set(first["quaternion"]) == set("wxyz")


def test_every_frame_stands_side_by_side(dhcli: Run, tmp_path: Path) -> None:
    """Each under its name; a dimension of its own in .npy."""
    done = dhcli("fk", "scara", "--rows", "-", "--frames", "--as", "position", stdin=GOOD)
    heads = done.out.split("\n")[0].split(",")
    assert heads == [f"T_0{i}_p_{axis}" for i in (1, 2, 3) for axis in "xyz"]
    robot = load_robot("scara")
    expected = [x for i in (1, 2, 3) for x in forward(robot, [0.3, 0.5, 0.1], end=i).position]
    assert table(done.out)[0] == pytest.approx(expected, abs=1e-12)
    dhcli("fk", "scara", "--rows", "-", "--frames", "-o", "all.npy", stdin=GOOD)
    poses = np.load(tmp_path / "all.npy")
    assert poses.shape == (2, 3, 4, 4)
    assert poses[1, 0] == pytest.approx(forward(robot, [-0.2, 1.5, 0], end=1).matrix, abs=1e-12)
    dhcli("fk", "scara", "--rows", "-", "--frames", "--as", "position,quaternion", "-o", "7.npy", stdin=GOOD)
    assert np.load(tmp_path / "7.npy").shape == (2, 3, 7)
    [first, _] = dhcli("fk", "scara", "--rows", "-", "--frames", "--format", "jsonl", stdin=GOOD).out.splitlines()
    assert np.array(json.loads(first)["T_02"]["matrix"]).shape == (4, 4)


def test_frames_lengths_and_degrees_are_those_of_one_pose(dhcli: Run) -> None:
    """`--from`, `--to`, `--inverse`, `--set`, `--deg`."""
    words = "fk scara --rows - --deg --from 1 --to tool --inverse --set l2=500mm"
    done = dhcli(*words.split(), stdin="30,45,0.1\n")
    q = {"theta1": math.radians(30), "theta2": math.radians(45), "d3": 0.1}
    pose = forward(load_robot("scara"), q, start="tool", end=1, parameters={"l2": 0.5})
    assert table(done.out)[0] == pytest.approx(pose.matrix[:3].ravel(), abs=1e-12)


@pytest.mark.parametrize("format_", ["csv", "jsonl"])
def test_no_rows_give_no_rows(dhcli: Run, format_: str) -> None:
    """A header of CSV all the same."""
    done = dhcli("fk", "scara", "--rows", "-", "--format", format_, stdin="theta1,theta2,d3\n")
    assert (done.code, done.out, done.err) == (0, f"{MATRIX}\n" if format_ == "csv" else "", "")


def test_no_rows_make_an_array_of_none(dhcli: Run, tmp_path: Path) -> None:
    """Of the shape that rows would have."""
    assert dhcli("fk", "scara", "--rows", "-", "-o", "a.npy", stdin="theta1,theta2,d3\n").code == 0
    assert np.load(tmp_path / "a.npy").shape == (0, 4, 4)


def test_any_number_of_jobs_says_the_same(dhcli: Run, tmp_path: Path) -> None:
    """Whatever share of the rows each of them takes."""
    np.save("q.npy", puma(20_001))
    for jobs in ("1", "2", "7"):
        assert dhcli("fk", "puma560", "--rows", "q.npy", "-o", f"{jobs}.npy", "--jobs", jobs).code == 0
    assert len({(tmp_path / f"{jobs}.npy").read_bytes() for jobs in (1, 2, 7)}) == 1


@POSIX
def test_npy_goes_through_a_pipe(process: Run, tmp_path: Path) -> None:
    """In and out, from one command to the next program."""
    np.save(tmp_path / "q.npy", puma(3))
    words = "fk puma560 --rows - --format npy --as position"
    done = process(f'"$0" -m dhcli {words} < q.npy | cat > p.npy')
    assert (done.code, done.err) == (0, "")
    assert np.load(tmp_path / "p.npy").shape == (3, 3)


@row_by_row(
    ("words", "said"),
    [
        ("fk scara --rows q.csv --q 0,0,0", "--q gives all joints, and so does the file"),
        ("fk scara --rows q.csv --pose pick --symbolic", "--pose and --symbolic do not go with --rows"),
        ("fk scara --rows q.csv --links", "--links does not"),
        ("fk scara --rows q.csv --factors 1 --let", "--let and --factors"),
        ("fk scara --rows q.csv --point 0,0,0 --as rpy", "--point and --as ask for different things"),
        ("fk scara --rows q.csv --point 0,0,0 --frames", "--point and --frames"),
        ("fk scara --rows q.csv --point 0,0", "a point has three coordinates"),
        ("fk scara --rows q.csv --point 0,0,h", "h of the point has no value"),
        ("fk scara --rows q.csv --q d3=0.1", "d3 has a column, and --q gives it too"),
        ("fk scara --rows q.csv --q q1=0,q2=0,d3=0.1", "leave --rows out, or a joint to the file"),
        ("fk scara --index --pose pick", "name their file with --rows FILE"),
        ("fk scara --jobs 2 --pose pick", "name their file with --rows FILE"),
        ("fk scara --rows q.csv --jobs 0", "'--jobs': 0 is not in the range"),
        ("fk scara --rows q.csv --jobs all", "'--jobs': 'all' is not a whole number"),
        ("fk scara --rows q.csv --let", "--let"),
        ("fk scara --rows q.csv --style full --digits 0", "--style and --digits"),
        ("fk scara --skip-bad --pose pick", "name their file with --rows FILE"),
        ("fk - --rows -", "cannot both come from standard input"),
        ("fk scara --rows nowhere.csv", "nowhere.csv: there is no such file"),
        ("fk scara --rows .", "is a folder"),
        ("fk scara --rows q.csv --format cvs", "did you mean csv?"),
        ("fk scara --rows q.csv -o poses.tex", "known suffixes of rows: .csv .jsonl .ndjson .npy"),
        ("fk scara --rows q.csv -o poses.json", "did you mean .jsonl"),
        ("fk scara --rows q.csv -o q.csv", "q.csv: exists already"),
        ("fk scara --rows q.csv -o nowhere/p.csv", "there is no folder nowhere"),
        ("fk scara --rows q.csv --overwrite", "--overwrite needs a file"),
        ("fk scara --rows q.csv --as rpyy", "did you mean rpy?"),
        ("fk scara --rows q.csv --to 9", "scara has no frame 9"),
        ("fk scara --rows q.csv --set l9=1", "scara has no length called l9"),
        ("fk dh-link --rows q.csv", "--set a_i=0.4 --set alpha_i=30° --set d_i=0.4"),
        ("fk assembly-blocks --rows q.csv", "assembly-blocks has no joint"),
        ("fk puma560 --rows q.csv", "puma560 has no joint d3"),
    ],
)
def test_bad_usage_is_told_before_any_row(dhcli: Run, words: str, said: str) -> None:
    """With exit code 2, nothing on stdout, and no file."""
    Path("q.csv").write_text(GOOD, "utf-8")
    done = dhcli(*words.split())
    assert (done.code, done.out) == (2, "")
    assert said in done.err
    assert "Traceback" not in done.err
    assert os.listdir() == ["q.csv"]


def test_an_envelope_is_no_row(dhcli: Run) -> None:
    """Whoever asks for JSON is told what there is, in JSON."""
    Path("q.csv").write_text(GOOD, "utf-8")
    done = dhcli("fk", "scara", "--rows", "q.csv", "--format", "json")
    assert done.code == 2
    assert done.envelope["problems"][0]["hint"] == "jsonl has one object a row"


def test_bad_rows_are_told_and_nothing_is_written(dhcli: Run) -> None:
    """With line, column and joint, all of them, and what to do."""
    Path("q.csv").write_text("theta1,theta2,d3\n0.1,abc,0.3\n1,2\n", "utf-8")
    done = dhcli("fk", "scara", "--rows", "q.csv", "-o", "p.csv")
    assert (done.code, done.out) == (2, "")
    assert done.err == (
        "dhcli: q.csv:2:5: theta2 'abc' is not a number\n"
        "  0.1,abc,0.3\n"
        "      ^\n"
        "  hint: a cell is a plain number, such as -0.25 or 1e-3\n"
        "dhcli: q.csv:3: 2 cells in a table of 3 columns\n"
        "  1,2\n"
        "dhcli: q.csv: 2 rows cannot be read\n"
        "  hint: --skip-bad goes on without them\n"
    )
    assert os.listdir() == ["q.csv"]


def test_bad_rows_can_be_left_out(dhcli: Run) -> None:
    """They are counted and listed; the exit code is 0, as it was asked for."""
    Path("q.csv").write_text(GOOD + "0.1,abc,\n" + "x,1,2\n" * 30 + "0.1,0.2,0.3\n", "utf-8")
    done = dhcli("fk", "scara", "--rows", "q.csv", "--skip-bad", "--as", "position")
    assert done.code == 0
    assert len(table(done.out)) == 3
    lines = done.err.splitlines()
    assert lines[0] == "dhcli: warning: left out 31 of 34 rows:"
    assert lines[1:3] == ["  q.csv:4:5: theta2 'abc' is not a number", "  q.csv:4:9: d3 is empty"]
    assert lines[3:] == ["  q.csv:5:1: theta1 'x' is not a number, the same in lines 6 to 22", "  and 12 rows more"]


@pytest.mark.parametrize("skip", [[], ["--skip-bad"]])
def test_if_every_row_is_bad_it_is_an_error(dhcli: Run, skip: list[str]) -> None:
    """Also for those who skip them: an empty file would pass for a result."""
    Path("q.csv").write_text("theta1,theta2,d3\n1deg,2deg,3\n", "utf-8")
    done = dhcli("fk", "scara", "--rows", "q.csv", "-o", "p.csv", *skip)
    assert done.code == 2
    assert "the unit stands once, in the header" in done.err
    assert os.listdir() == ["q.csv"]


def test_a_pose_that_is_no_number_is_a_bad_row(dhcli: Run) -> None:
    """Its place is that of the row."""
    Path("q.csv").write_text("d1\n1\n1e308\n", "utf-8")
    Path("far.yaml").write_text(
        "format: 1\ntitle: Far\nsource: nowhere\nconvention: standard\nvariables: [d1]\n"
        "links:\n  - {a: 0, alpha: 0, d: 4*d1, theta: 0}\n",
        "utf-8",
    )
    words = ("fk", "./far.yaml", "--rows", "q.csv")
    done = dhcli(*words)
    assert done.code == 2
    assert "q.csv:3: the pose has an entry that is not a real number" in done.err
    done = dhcli(*words, "--skip-bad")
    assert (done.code, len(table(done.out))) == (0, 1)


def test_what_a_person_should_know_is_said_once(dhcli: Run) -> None:
    """With how many rows it is true of."""
    Path("q.csv").write_text(",".join(f"theta{i}" for i in range(1, 7)) + "\n" + "90,0,0,0,0,0\n" * 7, "utf-8")
    done = dhcli("fk", "puma560", "--rows", "q.csv", "-o", "p.csv")
    assert done.code == 0
    assert done.err == (
        "wrote p.csv: 7 rows\n"
        "dhcli: warning: more than a turn: theta1 in 7 of 7 rows; did you mean degrees, --deg?\n"
        "dhcli: warning: 7 of 7 rows outside the limits of a joint: theta1 in 7\n"
    )
    assert dhcli("fk", "puma560", "--rows", "q.csv", "--deg").err == ""


def test_where_roll_and_yaw_are_one_is_said_once(dhcli: Run) -> None:
    """As for one pose, with how many."""
    Path("q.csv").write_text("theta4,theta5,theta6\n0,0,0\n0,90,0\n1,90,0\n", "utf-8")
    done = dhcli("fk", "spherical-wrist", "--rows", "q.csv", "--deg", "--as", "rpy", "--set", "d6=0.1")
    assert done.code == 0
    assert done.err.startswith("dhcli: warning: pitch is ±90° in 2 of 3 rows")


def test_rows_left_out_of_an_array_are_counted_as_rows(dhcli: Run) -> None:
    """However many of their numbers are bad."""
    q = puma(40)
    q[:30, :2] = np.nan
    np.save("q.npy", q)
    lines = dhcli("fk", "puma560", "--rows", "q.npy", "-o", "p.csv", "--skip-bad").err.splitlines()
    assert lines[:3] == [
        "wrote p.csv: 10 rows",
        "dhcli: warning: left out 30 of 40 rows:",
        f"  q.npy[0]: theta1 is nan, not a finite number, the same at {', '.join(f'q.npy[{k}]' for k in range(1, 10))}",
    ]
    assert lines[-1] == "  and 20 rows more"


def test_rows_behind_a_pose_that_is_no_number_keep_their_index(dhcli: Run) -> None:
    """It is left out like a row that cannot be read."""
    Path("q.csv").write_text("d1\n1\n1e308\n2\n", "utf-8")
    Path("far.yaml").write_text(
        "format: 1\ntitle: Far\nsource: nowhere\nconvention: standard\nvariables: [d1]\n"
        "links:\n  - {a: 0, alpha: 0, d: 4*d1, theta: 0}\n",
        "utf-8",
    )
    done = dhcli("fk", "./far.yaml", "--rows", "q.csv", "--skip-bad", "--index", "--as", "position")
    assert done.out == "row,p_x,p_y,p_z\n2,0.0,0.0,4.0\n4,0.0,0.0,8.0\n"


def test_rows_say_where_they_come_from(dhcli: Run, tmp_path: Path) -> None:
    """With `--index`, as in messages: so that what is left out is missed in its place."""
    text = GOOD + "x,0,0\n\n0.3,0.5,0.1\n"
    done = dhcli("fk", "scara", "--rows", "-", "--as", "position", "--index", "--skip-bad", stdin=text)
    assert done.out.split("\n")[0] == "row,p_x,p_y,p_z"
    assert [line.split(",")[0] for line in done.out.split("\n")[1:-1]] == ["2", "3", "6"]
    assert ":4:1: theta1 'x' is not a number" in done.err
    done = dhcli("fk", "scara", "--rows", "-", "--index", "--skip-bad", "--format", "jsonl", stdin=text)
    assert [json.loads(line)["row"] for line in done.out.splitlines()] == [2, 3, 6]
    dhcli("fk", "scara", "--rows", "-", "--index", "--skip-bad", "-o", "p.npy", stdin=text)
    found = np.load(tmp_path / "p.npy")
    assert found.shape == (3, 13)
    assert found[:, 0].tolist() == [2, 3, 6]
    assert found[0, 1:] == pytest.approx(forward(load_robot("scara"), [0.3, 0.5, 0.1]).matrix[:3].ravel())


def test_a_point_is_followed_through_all_rows(dhcli: Run) -> None:
    """As for one pose; the other joint stands where `--q` says."""
    words = ("--q", "d3=10cm", "--point", "0,0,l2", "--from", "1")
    done = dhcli("fk", "scara", "--rows", "-", *words, stdin="theta2,theta1\n0.5,0.3\n")
    assert done.out.split("\n")[0] == "p_x,p_y,p_z"
    expected = forward(load_robot("scara"), [0.3, 0.5, 0.1], start=1) @ (0, 0, 0.3)
    assert table(done.out)[0] == pytest.approx(list(expected), abs=1e-12)


@pytest.mark.parametrize("suffix", ["csv", "jsonl", "npy"])
def test_the_points_of_a_sweep_are_read_again(dhcli: Run, suffix: str) -> None:
    """Every pose comes out where the sweep says it is; an array has no names that would tell what is no joint."""
    ranges = ("--over", "q1=0..1 n 3", "--over", "d3=0..0.2 n 2")
    assert dhcli("sweep", "scara", *ranges, "-o", f"points.{suffix}").code == 0
    assert dhcli("sweep", "scara", *ranges, "-o", "expected.csv").code == 0
    words = ("fk", "scara", "--rows", f"points.{suffix}", "--as", "position")
    done = dhcli(*words)
    if suffix == "npy":
        assert "--ignore-columns" in done.err
        done = dhcli(*words, "--ignore-columns")
    assert table(done.out) == pytest.approx(table(Path("expected.csv").read_text("utf-8"))[:, 3:], abs=1e-12)


def test_no_two_columns_have_one_name(dhcli: Run) -> None:
    """Also where the matrix and the position are asked for, which both have p_x."""
    done = dhcli("fk", "scara", "--rows", "-", "--as", "matrix,position", stdin=GOOD)
    heads = done.out.split("\n")[0].split(",")
    assert heads[-3:] == ["position_p_x", "position_p_y", "position_p_z"]
    assert len(set(heads)) == len(heads) == 15


@pytest.mark.parametrize("line", ["fk scara --rows", "jacobian scara --rows"])
@pytest.mark.parametrize("format_", ["csv", "jsonl"])
def test_a_file_without_a_good_row_is_told_as_one(dhcli: Run, tmp_path: Path, line: str, format_: str) -> None:
    """Whatever is computed of its rows, of which there are none."""
    (tmp_path / "q.csv").write_text("theta1,theta2,d3\nx,y,z\n", "utf-8")
    done = dhcli(*line.split(), "q.csv", "--skip-bad", "--format", format_)
    assert done.code == 2
    assert "no row can be read" in done.err


@pytest.mark.parametrize("command", ["fk", "ik", "draw"])
def test_the_file_goes_by_its_former_name_too(dhcli: Run, tmp_path: Path, command: str) -> None:
    """Which no help shows, for `--in` is a frame elsewhere."""
    (tmp_path / "rows.csv").write_text("p_x,p_y,p_z\n0.5,0.2,0\n" if command == "ik" else "0,0.1\n0.3,0.5\n", "utf-8")
    more = ("-o", "way.svg", "--overwrite") if command == "draw" else ()
    former, now = (dhcli(command, "planar-2r", option, "rows.csv", *more) for option in ("--in", "--rows"))
    assert (former.code, former.out, former.err) == (now.code, now.out, now.err)
    assert now.code == 0
    assert "--in " not in dhcli(command, "--help").out
    both = dhcli(command, "planar-2r", "--rows", "rows.csv", "--in", "other.csv", *more)
    assert both.code == 2
    assert "--rows and --in both name the file" in both.err
