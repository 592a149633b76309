"""`dhcli draw`, and `show --draw`."""

from __future__ import annotations

import json
import math
import re
from pathlib import Path

import pytest

from tests.cli.running import Run

ROOT = Path(__file__).parents[2]


def test_without_a_file_the_picture_is_drawn_in_letters(dhcli: Run) -> None:
    """With a caption that says what, how and at which pose."""
    done = dhcli("draw", "puma560")
    assert (done.code, done.err) == (0, "")
    assert "z₀, z₁" in done.out
    assert done.out.endswith("PUMA 560, modified DH · puma560 · modified DH · pose nominal · az 37°, el 18°\n")


@pytest.mark.parametrize("size", ["20x10", "60x20", "119x40"])
def test_no_line_is_wider_than_asked(dhcli: Run, size: str) -> None:
    """Nor are there more rows, but those of the caption."""
    columns, rows = map(int, size.split("x"))
    lines = dhcli("draw", "stanford", "--size", size).out.split("\n")
    assert max(map(len, lines)) <= columns
    assert sum(any("\u2800" <= c <= "\u28ff" for c in line) for line in lines) <= rows


def test_letters_in_a_file_have_the_size_asked_for(dhcli: Run, tmp_path: Path) -> None:
    """Columns and rows, as on the terminal."""
    assert dhcli("draw", "scara", "--size", "30x12", "-o", "arm.txt").code == 0
    text = (tmp_path / "arm.txt").read_text("utf-8")
    assert text == dhcli("draw", "scara", "--size", "30x12").out
    assert max(map(len, text.split("\n"))) <= 30


def test_a_robot_is_read_from_standard_input_and_a_linkage_from_its_file(dhcli: Run) -> None:
    """Where the name is a dash, and where it is a path."""
    arm = (ROOT / "robots" / "scara.yaml").read_text("utf-8")
    linkage = str(ROOT / "robots" / "linkages" / "watt.yaml")
    for done, label in ((dhcli("draw", "-", stdin=arm), "z₀"), (dhcli("draw", linkage), "coupler")):
        assert done.code == 0, done.err
        assert label in done.out


def test_a_narrow_window_gets_a_narrow_picture(dhcli: Run) -> None:
    """Without Unicode in plain letters."""
    done = dhcli("draw", "scara", "--size", "40x16", PYTHONIOENCODING="ascii")
    assert done.code == 0, done.err
    assert done.out.isascii()
    assert "theta1" in done.out
    assert max(map(len, done.out.split("\n"))) <= 40


@pytest.mark.parametrize(
    ("suffix", "begins"), [("svg", b"<svg"), ("tex", b"% SCARA"), ("pdf", b"%PDF-"), ("html", b"<!DOCTYPE html>")]
)
def test_the_suffix_of_a_file_chooses_the_format(dhcli: Run, tmp_path: Path, suffix: str, begins: bytes) -> None:
    """An existing file is left alone without --overwrite."""
    path = tmp_path / f"arm.{suffix}"
    done = dhcli("draw", "scara", "--pose", "pick", "-o", str(path))
    assert (done.code, done.out, done.err) == (0, "", f"wrote {path}\n")
    assert path.read_bytes().startswith(begins)
    again = dhcli("draw", "scara", "-o", str(path))
    assert again.code == 2
    assert "--overwrite overwrites it" in again.err
    assert dhcli("draw", "scara", "-o", str(path), "--overwrite").code == 0


def test_joint_values_pose_lengths_view_and_worksheet_reach_the_picture(dhcli: Run, tmp_path: Path) -> None:
    """Each changes it, and the caption says the pose."""
    found = set()
    for number, words in enumerate(
        (
            "",
            "--q 0.3,0.4,0.1",
            "--deg --q 30,40,0.1",
            "--pose elbow",
            "--set l1=0.9",
            "--view 10,50",
            "--worksheet",
            "--table",
            "--dark",
        )
    ):
        path = tmp_path / f"{number}.svg"
        assert dhcli("draw", "scara", *words.split(), "-o", str(path)).code == 0, words
        found.add(path.read_text("utf-8"))
    assert len(found) == 9
    assert "θ1 = 30°, θ2 = 40°, d3 = 0.1 m" in (tmp_path / "2.svg").read_text("utf-8")


def test_a_motion_is_a_film_strip_and_a_page_that_plays(dhcli: Run, tmp_path: Path) -> None:
    """From one pose to another, by name or by values; letters have no room for it."""
    path = tmp_path / "strip.svg"
    assert dhcli("draw", "scara", "--pose", "zero", "--to", "pick", "-o", str(path)).code == 0
    text = path.read_text("utf-8")
    assert "pose zero to pose pick" in text
    assert 'class="trace"' in text
    assert dhcli("draw", "scara", "--deg", "--to", "10,20,0.1", "-o", str(tmp_path / "s.html")).code == 0
    assert '"path":[[0.17453' in (tmp_path / "s.html").read_text("utf-8")


def test_rows_of_a_file_are_a_strip_an_animation_and_a_page(dhcli: Run, tmp_path: Path) -> None:
    """Columns by name, a joint without a column by --q, degrees by --deg: as fk reads them."""
    rows = tmp_path / "q.csv"
    rows.write_text("theta2,theta1\n" + "".join(f"{k},{2 * k}\n" for k in range(0, 90, 10)), "utf-8")
    words = ("draw", "scara", "--rows", str(rows), "--q", "d3=0.05", "--deg")
    assert dhcli(*words, "-o", "strip.svg").code == 0
    assert "to 9 rows" in Path("strip.svg").read_text("utf-8")
    assert dhcli(*words, "-o", "move.svg", "--animate").code == 0
    assert Path("move.svg").read_text("utf-8").count('<g class="') == 9
    assert dhcli(*words, "-o", "move.html").code == 0
    model = json.loads(re.findall(r'id="model">(.*?)</script>', Path("move.html").read_text("utf-8"))[0])
    assert model["joints"][0]["q"] == 0
    assert model["path"][-1] == pytest.approx([math.radians(160), math.radians(80), 0.05], abs=1e-8)
    assert len(model["path"]) == 8


def test_rows_that_are_none_for_this_arm_are_refused(dhcli: Run, tmp_path: Path) -> None:
    """With file and line."""
    rows = tmp_path / "q.csv"
    for text, said in (
        ("theta1,theta2\n1,2\n", "d3"),
        ("theta1,theta2,d3\n1,2,x\n", "q.csv:2:5"),
        ("theta1,theta2,d3\n", "q.csv"),
    ):
        rows.write_text(text, "utf-8")
        done = dhcli("draw", "scara", "--rows", str(rows), "-o", "a.svg")
        assert done.code == 2
        assert said in done.err


def test_another_table_is_drawn_over_the_arm_and_the_first_difference_named(dhcli: Run, tmp_path: Path) -> None:
    """A twist with the wrong sign shows in its own frame."""
    wrong = (
        (ROOT / "robots" / "puma560.yaml")
        .read_text("utf-8")
        .replace("{alpha: -90°, a: 0,  d: 0,  theta: theta2}", "{alpha: 90°, a: 0, d: 0, theta: theta2}")
    )
    (tmp_path / "mine.yaml").write_text(wrong, "utf-8")
    assert dhcli("draw", "puma560", "--beside", "mine.yaml", "-o", "both.svg").code == 0
    text = (tmp_path / "both.svg").read_text("utf-8")
    assert "over it mine: frame 2 is the first that differs" in text
    assert text.count('class="theirs-mark"') == 1
    assert dhcli("draw", "puma560", "--beside", "scara").code == 2


def test_show_puts_a_picture_under_the_table(dhcli: Run) -> None:
    """Of a robot and of a linkage; an exercise has none."""
    for name in ("planar-2r", "planar-four-bar"):
        done = dhcli("show", name, "--draw")
        assert done.code == 0, done.err
        assert done.out.startswith(dhcli("show", name).out)
        assert any("\u2800" <= letter <= "\u28ff" for letter in done.out)
    assert dhcli("show", "yim/dh-rules", "--draw").code == 2


def test_an_exercise_about_a_table_is_drawn_without_what_the_table_says(dhcli: Run, tmp_path: Path) -> None:
    """Bodies, axes and numbers: no frame, no length, no angle, whoever drew it."""
    path = tmp_path / "task.svg"
    assert dhcli("draw", "wpi/puma560-table", "-o", str(path)).code == 0
    text = path.read_text("utf-8")
    assert set(re.findall(r'class="t-(\w+)"', text)) == {"number", "caption"}
    assert "dhcli draw wpi/puma560-table draws the arm" in dhcli("show", "puma560-table").out
    assert "dhcli draw yim/stanford-arm draws" in dhcli("start", "yim/stanford-arm", "-o", str(tmp_path / "s.yaml")).err


@pytest.mark.parametrize(
    ("exercise", "pose"), [("yim/dh-process", "zero"), ("zhou/puma200-table", "zero"), ("yim/stanford-arm", "zero")]
)
def test_frames_are_asked_in_the_pose_in_which_the_arm_is_drawn(dhcli: Run, exercise: str, pose: str) -> None:
    """Though another would show it better."""
    assert f"pose {pose} " in " ".join(dhcli("draw", exercise).out.split())


def test_an_exercise_in_numbers_is_drawn_at_its_own_values_with_frames(dhcli: Run, tmp_path: Path) -> None:
    """Where the arm stands is given there; where the frames lead is asked."""
    path = tmp_path / "task.svg"
    assert dhcli("draw", "yim/planar-in-numbers", "--variant", "alice", "-o", str(path)).code == 0
    text = path.read_text("utf-8")
    assert 't-x"' in text
    assert dhcli("draw", "yim/planar-in-numbers", "--variant", "bob", "-o", str(path), "--overwrite").code == 0
    assert path.read_text("utf-8") != text


def test_the_linkages_of_a_task_stand_on_one_sheet_without_what_is_to_be_counted(dhcli: Run, tmp_path: Path) -> None:
    """And `show` and `start` say so; with --solution after a try they have names and numbers."""
    path = tmp_path / "task.svg"
    assert dhcli("draw", "yim/planar-linkages", "-o", str(path)).code == 0
    text = path.read_text("utf-8")
    assert set(re.findall(r'class="t-(\w+)"', text)) == {"caption"}
    assert text.count('class="t-caption"') == 4
    assert "dhcli draw yim/planar-linkages draws the linkages" in dhcli("show", "yim/planar-linkages").out
    assert "draws the linkages" in dhcli("start", "yim/planar-linkages", "-o", str(tmp_path / "s.yaml")).err
    letters = dhcli("draw", "yim/planar-linkages", "--size", "60x16").out
    assert letters.count("Parallel four-bar") == 2
    assert max(map(len, letters.split("\n"))) <= 60
    assert dhcli("draw", "yim/planar-linkages", "--solution").code == 2
    for part in ("n4", "j4", "f4", "parallel", "n5", "f5", "m5", "six"):
        dhcli("check", "yim/planar-linkages", "--part", part, "--answer", "4")
    solved = dhcli("draw", "yim/planar-linkages", "--solution", "-o", str(path), "--overwrite")
    assert solved.code == 0, solved.err
    assert "coupler" in path.read_text("utf-8")


def test_open_writes_a_page_and_opens_it(dhcli: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Without -o in a folder of its own, where temporary files go."""
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    opened: list[str] = []
    monkeypatch.setattr("webbrowser.open", opened.append)
    assert dhcli("draw", "planar-2r", "--open").code == 0
    assert opened[0].startswith(f"file://{tmp_path}")
    assert opened[0].endswith("/planar-2r.html")
    assert Path(opened[0].removeprefix("file://")).read_text("utf-8").startswith("<!DOCTYPE html>")
    assert dhcli("draw", "wpi/puma560-table", "--open").code == 0
    assert opened[1].endswith("/puma560.svg")


def test_the_picture_of_a_solution_follows_the_rule_and_words_of_the_solution(dhcli: Run) -> None:
    """What is yet to try is named with how to; a part that was tried no more; --yes shows it all the same."""
    name = "yim/planar-two-links"
    refused = dhcli("draw", name, "--solution", "-o", "a.svg").err
    assert "never tried: table, blocks\n" in refused
    assert f"dhcli check {name} --part table asks for table; --yes shows what was not tried" in refused
    assert dhcli("solution", name, "--part", "blocks").err.endswith("asks for it; --yes shows what was not tried\n")
    assert dhcli("check", name, "--part", "table", "--answer", "[0, 0, 0, 0]").code in (1, 2)
    tried = dhcli("draw", name, "--solution", "-o", "a.svg").err
    assert "never tried: blocks\n" in tried
    assert "--part blocks asks for it" in tried
    assert dhcli("draw", name, "--solution", "--yes", "-o", "a.svg").code == 0


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ("nobody", "there is no robot 'nobody'"),
        ("scara --view isometric", "there is no view 'isometric'"),
        ("scara --view 10,100", "an elevation is from -90 to 90"),
        ("scara --pose nowhere", "has no pose called nowhere"),
        ("scara --q 1,2", "scara has 3 joints, 2 values given"),
        ("scara --q 1,2,3 --pose pick", "both say where all joints are"),
        ("scara --size big", "'big' is no size"),
        ("scara --size 10x4", "10 x 4 letters are too few"),
        ("scara --size 50x50 -o a.svg", "a picture of 50 x 50 pixels is not drawn"),
        ("scara -o a.jpg", "a.jpg does not say which format"),
        ("scara -o nowhere/at/all/a.svg", "nowhere/at/all"),
        ("scara --overwrite", "--overwrite needs a file"),
        ("ring-of-arms", "of ring-of-arms only counts are known"),
        ("bennett --pose zero", "bennett is a linkage"),
        ("scara --to pick", "no picture in letters"),
        ("scara --to 1,2 -o a.svg", "scara has 3 joints, 2 values given"),
        ("scara --to pick --worksheet -o a.svg", "a film strip has no frames"),
        ("scara --rows q.csv --pose pick -o a.svg", "--rows says where all joints are"),
        ("scara --rows no.csv -o a.svg", "no.csv"),
        ("scara --animate -o a.svg", "--animate is for a motion, and nothing moves"),
        ("scara --animate -o a.png", "--to or --rows says where to"),
        ("scara --to pick --animate -o a.html", "a page plays a motion by itself: leave --animate out"),
        ("scara --to pick --animate -o a.png", "only an .svg is animated"),
        ("scara --to pick --animate -o a.pdf", "write -o move.svg"),
        ("bennett --rows q.csv -o a.svg", "bennett is a linkage"),
        ("bennett --to zero -o a.svg", "bennett is a linkage"),
        ("bennett --table", "bennett is a linkage"),
        ("scara --table", "dhcli show scara --draw has both"),
        ("scara --table -o a.html", "a page always has the table"),
        ("watt --view top", "watt is planar: there is one view of it"),
        ("bajd/rotate-a-vector", "bajd/rotate-a-vector has no robot"),
        ("yim/counting-freedoms", "has no robot and no linkage with points"),
        ("motion/five-bar-loop -o a.html", "a page computes frames"),
        ("wpi/puma560-table -o a.html", "which a worksheet leaves to the student"),
        ("yim/stanford-arm --pose zero", "yim/stanford-arm is an exercise"),
        ("yim/stanford-arm --solution", "never tried"),
        ("stanford --solution", "stanford is no exercise"),
        ("stanford --yes", "stanford is no exercise"),
    ],
)
def test_what_cannot_be_drawn_is_refused_in_words(
    dhcli: Run, words: str, message: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Exit code 2, nothing on stdout and no file."""
    monkeypatch.chdir(tmp_path)
    done = dhcli("draw", *words.split())
    assert (done.code, done.out) == (2, "")
    assert message in done.err
    assert not list(tmp_path.glob("*.svg"))


def test_a_linkage_that_is_not_assembled_is_refused_by_its_file(dhcli: Run, tmp_path: Path) -> None:
    """A loop of rows that does not close has no position to draw."""
    path = tmp_path / "open.yaml"
    row = "{a: 1, alpha: 40°, d: 0, theta: 70°}"
    path.write_text(
        "format: 1\ntitle: T\nsource: S\nspace: spatial\nloop:\n  convention: standard\n  rows:\n"
        + f"    - {row}\n" * 4,
        "utf-8",
    )
    done = dhcli("draw", str(path))
    assert done.code == 2
    assert "the loop does not close" in done.err
