"""What people get wrong, and what dhcli says: where, what, what would be right; exit code 2 and nothing on stdout."""

import os
from pathlib import Path

import pytest

from tests.cli.running import Run
from tests.row_by_row import row_by_row


@row_by_row(
    ("words", "said"),
    [
        ("fk", "dhcli fk needs 'ROBOT'"),
        ("schema", "KIND is robot, exercise or linkage"),
        ("fkk scara", "did you mean fk?"),
        ("fk scra --q 0,0,0", "did you mean scara"),
        ("fk scara", "no value for theta1, theta2, d3"),
        ("fk scara --q 0.3,0.5", "scara has 3 joints, 2 values given"),
        ("fk scara --q 1,2,3,4", "scara has 3 joints, 4 values given"),
        ("fk scara --q nan,0,0", "nan"),
        ("fk planar-two-links", "'planar-two-links' is the name of an exercise"),
        ("torques scara --rows q.csv", "rows of a file are read by fk, ik, draw and jacobian"),
        ("fk scara --q 0,0,1e999", "--q:5: "),
        ("fk scara --q 30mm,0,0", "mm is a unit of length"),
        ("fk scara --q 0,0,30deg", "deg is a unit of angle"),
        ("fk scara --q q9=1", "scara has no joint q9"),
        ("fk scara --q q1=1,q1=2", "theta1 is given twice"),
        ("fk scara --q @nowhere.txt", "nowhere.txt: there is no such file"),
        ("fk scara --pose pik", "did you mean pick?"),
        ("fk cartesian --pose x", "cartesian has no pose called x"),
        ("fk scara --pose pick --q 0,0,0", "--q and --pose"),
        ("fk scara --pose pick --frames --links", "--frames and --links"),
        ("fk scara --pose pick --point 0,0,0 --as rpy", "--point and --as"),
        ("fk scara --pose pick --factors 1 --inverse", "--factors and --inverse"),
        ("fk scara --pose pick --let", "add --symbolic"),
        ("fk scara -s --as rpy", "rpy needs numbers"),
        ("fk scara --pose pick --as rpyy", "did you mean rpy?"),
        ("fk scara --pose pick --from 7", "scara has no frame 7"),
        ("fk scara --pose pick --to wrist", "frames: base, 0, 1, 2, 3, tool"),
        ("fk scara --pose pick --factors 4", "scara has no link 4"),
        ("fk scara --pose pick --point 1,2", "a point has three coordinates"),
        ("fk scara --pose pick --point 1,2,q8", "q8 of the point has no value"),
        ("fk scara --pose pick --point 1,2,30°", "--point:5: "),
        ("fk scara --pose pick --set l9=1", "scara has no length called l9"),
        ("fk scara --pose pick --set l1", "l1 is not NAME=VALUE"),
        ("fk scara --pose pick --set l1=1 --set l1=2", "l1 is set twice"),
        ("fk scara --pose pick --set theta1=1", "write --q theta1="),
        ("fk dh-link --q 1", "--set a_i=0.4 --set alpha_i=30° --set d_i=0.4"),
        ("fk scara --pose pick --format foo", "formats: json, table, latex, matlab, numpy, sympy, csv"),
        ("fk scara -s --let --format csv", "there is no format csv for --let"),
        ("fk scara --pose pick --as rpy --format latex", "there is no format latex for --as"),
        ("fk scara --pose pick --style ful", "did you mean full?"),
        ("fk scara --pose pick --digits 99", "99"),
        ("fk scara --pose pick --digits two", "'two' is not a whole number"),
        ("fk scara --pose pick -o pose.foo", "known suffixes: .json .txt .tex .m .py .csv; or say --format"),
        ("fk scara --pose pick -o nowhere/pose.json", "there is no folder nowhere"),
        ("fk scara --pose pick --overwrite", "--overwrite needs a file"),
        ("fk scara --q 0 0 0", "quotes around them"),
        ("fk scara 0 0 0", "joint values stand behind --q; "),
        ("fk planar2r --q 0,0", "did you mean planar-2r?; "),
        ("fk scara --formt json", "did you mean --format"),
        ("fk scara --pose", "requires an argument"),
        ("check scara --pose", "dhcli check --help shows what can be typed"),
        ("new robot arm --convention", "dhcli new robot --help shows what can be typed"),
        ("fk scara --pose pick --force", "did you mean --overwrite?"),
        ("rates scara --pose pick --linear 1,0,0", "did you mean --velocity"),
        ("rates scara --pose pick --omega 0,0,1", "did you mean --angular?"),
        ("show scra", "did you mean scara"),
        ("show scara --format matlab", "there is no format matlab for a robot"),
        ("list robotz", "did you mean robots"),
        ("list --format latex", "there is no format latex for a list"),
        ("new robot ../x --joints R", "cannot be the name of a robot"),
        ("new robot my-Träger.yaml", "such as my-Trager"),
        ("new exercise a/b/c --robot scara", "'b/c' cannot be the name of an exercise"),
        ("new linkage é!", "cannot be the name of a linkage"),
        ("new robot arm --joints 2r-P", "R is revolute, P is prismatic: --joints RRP"),
        ("new robot arm --joints 99R", "is not a row of joints"),
        ("new robot x --joints RXP", "R is revolute, P is prismatic"),
        ("new robot x --joints RRRRRRRRRRRRRRRRRRRRRRRRR", "more than 20"),
        ("new robot x --convention modifed", "did you mean modified?"),
        ("new robt x", "did you mean robot?"),
        ("transform Rot(w,90°)", "x, y or z"),
        ("transform Rot(z,90)", "write 90° or 1.5708 rad"),
        ("ik scara --target 0.3,0.3,0", "write --position 0.3,0.3,0, where"),
        ("transform Rot(z,-1.5)", "write -1.5° or -1.5 rad"),
        ("jacobian scara --in q.csv", "dhcli jacobian scara --rows q.csv"),
        ("fk scara --q 30\udcc2\udcb0,0,0", "write deg, pi, sqrt, theta1"),
        ("transform Trans(1,2)", "Trans"),
        ("transform Rot(z,a)Trans(1,2,3) --set b=1", "b does not stand in the product"),
        ("transform Rot(z,a) --set a=3m", "m is a unit of length"),
        ("transform Rot(z,0) --point 1,2", "a point has three coordinates"),
    ],
)
def test_bad_input_is_told_in_words_with_exit_code_2(dhcli: Run, words: str, said: str) -> None:
    """Every line begins the same way, nothing is on stdout, and no traceback shows."""
    done = dhcli(*words.split())
    assert done.code == 2
    assert done.out == ""
    assert done.err.startswith("dhcli: ")
    assert said in done.err
    assert "Traceback" not in done.err


@pytest.mark.parametrize(
    ("matrix", "said"),
    [
        ("[1 0 0 0; 0 2 0 0; 0 0 1 0; 0 0 0 1]", "column 2 is not a unit vector"),
        ("[1 0 0 0; 0 1 0 0; 0 0 -1 0; 0 0 0 1]", "left-handed"),
        ("[1 0 0 0; 0 1 0 0; 0 0 1 0; 0 0 0 2]", "the last row of a pose is 0 0 0 1"),
        ("[1 0 0; 0 1 0; 0 0 1]", "3x3"),
    ],
)
def test_a_matrix_that_is_no_pose_is_refused(dhcli: Run, matrix: str, said: str) -> None:
    """With a marker under it."""
    done = dhcli("transform", f"Trans(1,2,3) {matrix}")
    assert done.code == 2
    assert said in done.err
    assert f"\n  {' ' * 13}^\n" in done.err


def test_the_marker_stands_under_the_column(dhcli: Run) -> None:
    """Place, line, marker, hint."""
    assert dhcli("fk", "scara", "--q", "0.3,30mm,0.1").err == (
        "dhcli: --q:5: mm is a unit of length, an angle is wanted, and theta2 turns\n"
        "  0.3,30mm,0.1\n"
        "      ^\n"
        "  hint: write 30° or 0.5 rad\n"
    )


def test_all_problems_of_a_file_are_told_at_once(dhcli: Run, tmp_path: Path) -> None:
    """Each with file, line and column."""
    text = "format: 1\ntitel: x\nsource: y\nconvention: standrd\nvariables: [theta1]\nlinks: []\n"
    (tmp_path / "bad.yaml").write_text(text, "utf-8")
    done = dhcli("fk", "./bad.yaml", "-s")
    assert done.code == 2
    heads = [line for line in done.err.split("\n") if line.startswith("dhcli: ")]
    assert len(heads) >= 3
    assert all(line.startswith("dhcli: bad.yaml:") for line in heads)
    assert "did you mean title?" in done.err
    assert "did you mean standard?" in done.err


@pytest.mark.parametrize("point", ["0.3 0.3 0", "[0.3, 0.3, 0]", "(0.3  0.3 0)", "[0.3 0.3 0]"])
def test_a_position_where_a_pose_is_wanted_is_sent_to_its_option(dhcli: Run, point: str) -> None:
    """However its numbers are parted."""
    done = dhcli("ik", "scara", point)
    assert done.code == 2
    assert "write --position 0.3,0.3,0, where the turn is free" in done.err


def test_many_rows_behind_q_are_sent_where_rows_go(dhcli: Run, tmp_path: Path) -> None:
    """A file of one pose is read; of ten it is not said that scara has thirty joints."""
    rows = tmp_path / "q.csv"
    rows.write_text("0.1, 0.2, 0.3\n", "utf-8")
    assert dhcli("fk", "scara", "--q", f"@{rows}").code == 0
    rows.write_text("0.1, 0.2, 0.3\n" * 10, "utf-8")
    done = dhcli("fk", "scara", "--q", f"@{rows}")
    assert done.code == 2
    assert "10 rows of 3 values, and one pose is wanted" in done.err
    assert f"fk --rows {rows}" in done.err


@pytest.mark.parametrize(
    ("content", "theta1", "d3"),
    [
        ("theta1,theta2,d3\n0.5,0.2,0.1\n", 0.5, 0.1),
        ("d3[mm];theta1[deg];theta2\n100;90;0,25\n", 1.5707963267948966, 0.1),
        ("theta1 theta2 d3\n0,5 pi/2 0,1\n", 0.5, 0.1),
        ("d3 = 0.1\ntheta1 = 0.5\ntheta2 = 0\n", 0.5, 0.1),
        ("J1: 0.5\nJ2: 0\nJ3: 100 mm\n", 0.5, 0.1),
        ("d3: 0,1\ntheta1: 90,0 deg\ntheta2: -0,5\n", 1.5707963267948966, 0.1),
        ("J1 90.00 deg\nJ2 -12.50 deg\nJ3 100.0 mm\n", 1.5707963267948966, 0.1),
        ('{"theta1": 0.5, "theta2": 0, "d3": 0.1}', 0.5, 0.1),
        ('{\n  "joint_3": 0.1,\n  "joint_1": 0.5,\n  "joint_2": 0\n}\n', 0.5, 0.1),
        ("J1,J2,J3\n0.5,0.2,0.1\n", 0.5, 0.1),
        ("A1;A2;A3\n0,5;0,2;0,1\n", 0.5, 0.1),
        ("rax_1,rax_2,rax_3\n0.5,0.2,0.1\n", 0.5, 0.1),
    ],
)
def test_a_file_of_one_pose_behind_q_is_read_by_the_names_in_it(
    dhcli: Run, tmp_path: Path, content: str, theta1: float, d3: float
) -> None:
    """In a header, in lines as a pendant writes them, or as JSON, with the units that stand there."""
    rows = tmp_path / "q.csv"
    rows.write_text(content, "utf-8")
    done = dhcli("fk", "scara", "--q", f"@{rows}", "--format", "json")
    assert (done.data["values"]["theta1"], done.data["values"]["d3"]) == (theta1, d3)


@pytest.mark.parametrize(
    "words",
    [
        ("fk", "scara", "--q"),
        ("jacobian", "scara", "--q"),
        ("torques", "scara", "--force", "0,0,1", "--q"),
        ("rates", "scara", "--q"),
        ("singularities", "scara", "--q"),
        ("ik", "scara", "--q"),
        ("ik", "scara", "--pose", "pick", "--near"),
        ("sweep", "scara", "--over", "q1=0..1 n 2", "--q"),
        ("check", "scara", "--answer", "0", "--q"),
        ("draw", "scara", "--q"),
        ("draw", "scara", "--to"),
    ],
)
def test_a_header_is_not_counted_as_a_row(dhcli: Run, tmp_path: Path, words: tuple[str, ...]) -> None:
    """Wherever joint values are typed."""
    rows = tmp_path / "q.csv"
    rows.write_text("theta1,theta2,d3\n0.1,0.2,0.3\n0.4,0.5,0.6\n", "utf-8")
    done = dhcli(*words, f"@{rows}")
    assert done.code == 2
    assert f"{words[-1]} {rows}: 2 rows of 3 values, and one pose is wanted" in done.err


@pytest.mark.parametrize(
    ("content", "said"),
    [
        ("theta1,theta2,d3\n", "is a header without values"),
        ("J1: 0\nJ2: 0\nJ4: 0\n", "scara has no joint J4"),
        ("J1: 0\ntheta1: 0\nd3: 0\n", "theta1 is given twice"),
        ("- 0.1\n- 0.2\n- 0.3\n", "each line is a list entry, or negative"),
        ("theta1,theta2,d3\n1,2\n", "2 cells in a table of 3 columns"),
        ("theta1,theta2,d4\n1,2,3\n", "did you mean d3?"),
        ("theta1[mm],theta2,d3\n1,2,3\n", "mm is a unit of length, an angle is wanted"),
        ("0.1,0.2,0.3,0.4,0.5,0.6\n", "scara has 3 joints, 6 values given"),
    ],
)
def test_a_table_behind_q_that_is_none_says_why(dhcli: Run, tmp_path: Path, content: str, said: str) -> None:
    """And six values in a line are no two rows."""
    (tmp_path / "q.csv").write_text(content, "utf-8")
    done = dhcli("fk", "scara", "--q", f"@{tmp_path / 'q.csv'}")
    assert done.code == 2
    assert said in done.err


@pytest.mark.parametrize("name", ["arm.urdf", "arm.xacro"])
@pytest.mark.parametrize("text", ["format: 1\n", "robot = 3\n"])
def test_a_urdf_that_is_no_xml_is_not_read_as_yaml(dhcli: Run, tmp_path: Path, name: str, text: str) -> None:
    """Its name says what it should be."""
    (tmp_path / name).write_text(text, "utf-8")
    done = dhcli("fk", str(tmp_path / name), "--q", "0")
    assert done.code == 2
    assert f"{name}:1: is no XML" in done.err
    assert "unknown key" not in done.err


@pytest.mark.parametrize("text", ['{"data": {"x": 1}}', '{"matrix": [[1, 2]]}', '{ "matrix": "none"}'])
def test_json_without_a_pose_is_told_as_json(dhcli: Run, tmp_path: Path, text: str) -> None:
    """By every command that reads a pose."""
    (tmp_path / "pose.json").write_text(text, "utf-8")
    for words in (("ik", "puma560", "--target", f"@{tmp_path / 'pose.json'}"), ("transform", text)):
        done = dhcli(*words)
        assert done.code == 2
        assert "this JSON holds no 4x4 matrix" in done.err


@pytest.mark.parametrize("steering", ["\x1b[31mred", "\x9b31mred", "a\rb", "\u202eevil", "[bold]x[/bold]", ":smile:"])
def test_nothing_that_a_user_types_steers_the_terminal(dhcli: Run, steering: str) -> None:
    """Controls become blanks, and markup stays text."""
    err = dhcli("fk", steering).err
    assert not {"\x1b", "\x9b", "\r", "\u202e"} & set(err)
    assert "[bold]x[/bold]" in err or "[bold]" not in steering
    assert ":smile:" in err or ":smile:" not in steering


@pytest.mark.parametrize(
    "line",
    [
        "fk ~/arm.yaml",
        "show ~/arm.yaml",
        "draw scara --beside ~/arm.yaml",
        "fk scara --rows ~/q.csv",
        "fk scara --rows ~/q.npy",
        "fk scara --q @~/q.txt",
        "dof ~/press.yaml",
        "check planar-two-links ~/a.sheet.yaml",
        "check planar-2r --table ~/t.yaml",
        "lint ~/arm.yaml",
        "lint ~/arms",
        "grade ~/hw",
        "new robot --from ~/table.csv",
        "new robot arm -o ~/arm.yaml",
        "fk scara --pose pick -o ~/pose.json",
        "draw scara -o ~/scara.svg",
        "sweep planar-2r -o ~/points.csv",
    ],
)
def test_a_home_between_quotes_is_told_with_what_to_write(
    dhcli: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, line: str
) -> None:
    """The shell has not expanded it, and no folder of that name is made."""
    monkeypatch.setenv("HOME", "/home/me")
    done = dhcli(*line.split())
    assert (done.code, "~ stays as it is here, write /home/me/" in done.err) == (2, True), done.err
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    "words",
    [
        ("fk", "scara", "--rows", ""),
        ("ik", "scara", "--rows", ""),
        ("check", "planar-two-links", ""),
        ("new", "robot", "arm", "--from", ""),
        ("lint", ""),
        ("grade", ""),
        ("draw", "scara", "--rows", ""),
        ("fk", "scara", "--pose", "pick", "--format", "json", "-o", ""),
        ("fk", "scara", "--pose", "pick", "-o", ""),
        ("new", "robot", "arm", "-o", ""),
        ("new", "exercise", "swing", "--robot", "scara", "-o", ""),
        ("new", "linkage", "press", "-o", ""),
        ("start", "planar-two-links", "-o", ""),
        ("schema", "robot", "-o", ""),
        ("draw", "scara", "-o", ""),
        ("sweep", "scara", "-o", ""),
    ],
)
def test_a_path_of_no_letters_is_not_the_folder_one_stands_in(
    dhcli: Run, tmp_path: Path, words: tuple[str, ...]
) -> None:
    """A variable of the shell that is not set leaves nothing; what stands here is not meant."""
    (tmp_path / "a.yaml").write_text("format: 1\n", "utf-8")
    done = dhcli(*words)
    assert done.code == 2
    assert "the name is empty" in done.err + done.out
    assert [path.name for path in tmp_path.iterdir()] == ["a.yaml"]


@pytest.mark.parametrize(
    ("output", "said"),
    [
        ("nowhere/x.json", "there is no folder nowhere"),
        ("folder.json", "is a folder"),
        ("closed/x.json", "no permission"),
    ],
)
def test_a_place_where_nothing_can_be_written_is_told_before_the_work(
    dhcli: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, output: str, said: str
) -> None:
    """So that no class is graded for nothing."""
    for name in ("hw", "folder.json", "closed"):
        (tmp_path / name).mkdir()
    dhcli("start", "planar-two-links", "-o", "hw/a.yaml")
    may = os.access
    monkeypatch.setattr(os, "access", lambda path, mode: "closed" not in str(path) and may(path, mode))
    monkeypatch.setattr("dhcli.classroom.grading.grade_all", lambda *_, **__: pytest.fail("it was graded"))
    done = dhcli("grade", "hw", "-o", output)
    assert (done.code, said in done.err + done.out) == (2, True), done.err


@row_by_row("command", ["fk", "ik", "draw", "jacobian", "rates", "torques", "singularities", "sweep"])
def test_the_commands_that_read_rows_are_those_that_are_named(dhcli: Run, command: str) -> None:
    """Where the option is looked for in another."""
    named = "rows of a file are read by fk, ik, draw and jacobian"
    assert (" --rows " in dhcli(command, "--help").out) is (command in named.replace(",", "").split())


def test_of_a_file_without_keys_nothing_more_is_told(dhcli: Run, tmp_path: Path) -> None:
    """Neither what a robot nor what a linkage needs besides."""
    rows = tmp_path / "rows.csv"
    rows.write_text("theta1,theta2\n0.1,0.2\n")
    for command in ("dof", "show", "lint", "describe"):
        done = dhcli(command, str(rows))
        assert (done.out + done.err).count(":1:1: ") == 1
