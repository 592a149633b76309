"""`transform`, `show`, `list` and `new`."""

import json
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from markdown_it import MarkdownIt

from dhcli import load_exercise, load_robot
from tests.cli.running import Run
from tests.nightly import in_turn, paired

BAJD = "Trans(8,-6,14) Rot(y,90°) Rot(z,90°)"


def test_steps_show_every_frame_on_the_way(dhcli: Run) -> None:
    """Bajd's example: the last frame is the printed one."""
    out = dhcli("transform", BAJD, "--steps").out
    assert [line.split(" = ")[0] for line in out.split("\n") if line.startswith("T_")] == ["T_01", "T_02", "T_03"]
    assert "⎡ 0  0  1   8 ⎤\n⎢ 1  0  0  -6 ⎥\n⎢ 0  1  0  14 ⎥\n⎣ 0  0  0   1 ⎦\n" in out


@pytest.mark.parametrize("format_", ["table", "json", "latex", "matlab", "numpy", "csv", "sympy"])
@pytest.mark.parametrize("words", ["--q 0.3,0.5,0.1", "--symbolic"])
def test_what_fk_prints_is_read_as_a_matrix(dhcli: Run, format_: str, words: str) -> None:
    """In any format, with headings and all; and called a matrix, not by all of its text."""
    printed = dhcli("fk", "scara", *words.split(), "--format", format_).out
    done = dhcli("transform", "-", "--format", "json", stdin=printed)
    assert done.code == 0, done.err
    expected = dhcli("fk", "scara", *words.split(), "--format", "json").data["matrix"]
    if words == "--symbolic":
        assert str(done.data["matrix"]).replace("0.0", "0").replace("1.0", "1") == str(expected)
    else:
        assert np.array(done.data["matrix"]) == pytest.approx(np.array(expected), abs=1e-4)
    assert done.data["steps"][0]["move"] == "[4x4 matrix]"


def test_a_matrix_and_a_move_multiply(dhcli: Run) -> None:
    """A literal pose may stand anywhere in the product."""
    matrix = "[0 0 1 8; 1 0 0 -6; 0 1 0 14; 0 0 0 1]"
    data = dhcli("transform", f"{matrix} inv({matrix})", "--format", "json").data
    assert data["matrix"] == np.eye(4).tolist()


def test_fixed_moves_multiply_from_the_left(dhcli: Run) -> None:
    """About the fixed frame the product is the one of the moves in reverse."""
    fixed = dhcli("transform", "Rot(x,30°) Trans(1,2,3) Rot(z,40°)", "--fixed", "--format", "json").data
    current = dhcli("transform", "Rot(z,40°) Trans(1,2,3) Rot(x,30°)", "--format", "json").data
    assert fixed["matrix"] == current["matrix"]
    assert [step["move"] for step in fixed["steps"]] == ["Rot(x, 30°)", "Trans(1, 2, 3)", "Rot(z, 40°)"]


def test_a_vector_is_turned_and_a_point_is_shifted_too(dhcli: Run) -> None:
    """The same three numbers, seen from frame 0."""
    done = dhcli("transform", BAJD, "--point", "1,2,3", "--vector", "1,2,3", "--format", "json")
    assert [point["seen"] for point in done.data["points"]] == [[11.0, -5.0, 16.0]]
    assert [vector["seen"] for vector in done.data["vectors"]] == [[3.0, 1.0, 2.0]]


def test_several_points_are_seen_in_the_order_typed(dhcli: Run) -> None:
    """`--point` is repeatable."""
    out = dhcli("transform", "Trans(1,0,0)", "--point", "0,0,0", "--point", "1,0,0").out
    assert out.endswith("point (0, 0, 0) of frame 1 is at (1, 0, 0) in frame 0\n"
                        "point (1, 0, 0) of frame 1 is at (2, 0, 0) in frame 0\n")  # fmt: skip


def test_names_make_a_transform_symbolic_until_they_have_values(dhcli: Run) -> None:
    """An angle or a length by where the name stands."""
    words = ("transform", "Rot(z,theta1) Trans(l1,0,0)")
    assert "l1*c1" in dhcli(*words).out
    half = dhcli(*words, "--set", "theta1=90°").out
    assert "⎢ 1  0   0  l1 ⎥" in half
    both = dhcli(*words, "--set", "theta1=90°", "--set", "l1=40cm", "--format", "json").data
    assert both["symbolic"] is False
    assert both["matrix"][1][3] == 0.4


def test_symbolic_keeps_roots(dhcli: Run) -> None:
    """30° stays exact."""
    assert "sqrt(3)/2" in dhcli("transform", "Rot(z,30°)", "-s").out


def test_a_product_is_read_from_standard_input(dhcli: Run) -> None:
    """Lines and all."""
    done = dhcli("transform", "-", "--format", "csv", stdin="Trans(1,2,3)\nRot(z,90°)\n")
    assert done.out == "0.0,-1.0,0.0,1.0\n1.0,0.0,0.0,2.0\n0.0,0.0,1.0,3.0\n0.0,0.0,0.0,1.0\n"


def test_points_are_what_code_formats_hold_when_asked_for(dhcli: Run) -> None:
    """One line each in CSV."""
    out = dhcli("transform", "Trans(1,0,0)", "--point", "0,0,0", "--vector", "1,0,0", "--format", "csv").out
    assert out == "1.0,0.0,0.0\n1.0,0.0,0.0\n"


@pytest.mark.parametrize(
    ("robot", "heads"),
    [
        ("puma560", ["i", "α_{i-1}", "a_{i-1}", "d_i", "θ_i", "joint"]),
        ("planar-2r", ["i", "a_i", "α_i", "d_i", "θ_i", "joint"]),
        ("scara", ["i", "A_i", "joint"]),
    ],
)
def test_the_table_is_headed_as_its_convention_counts(dhcli: Run, robot: str, heads: list[str]) -> None:
    """In the order of the file's columns."""
    out = dhcli("show", robot).out
    assert heads in [line.split() for line in out.split("\n")]


def test_the_page_of_a_robot_tells_all_of_it(dhcli: Run) -> None:
    """Title, order of operations, limits, parameters with units, poses, tool, notes, source."""
    out = dhcli("show", "zhou-6r").out
    robot = load_robot("zhou-6r")
    assert out.startswith(f"{robot.title}\nzhou-6r · standard DH · 6 joints RRRRRR\n")
    assert "A_i = Rot(z, θ_i) Trans(z, d_i) Trans(x, a_i) Rot(x, α_i)\n" in out
    assert "tool  Trans(0, 0, d7)\n" in out
    assert "0.08 m" in out
    assert all(word in out.split() for word in (*robot.poses, *robot.notes.split(), *robot.source.split()))
    assert "-160°   160°" in dhcli("show", "puma560").out


def test_limits_and_poses_are_in_degrees_however_they_were_written(dhcli: Run, tmp_path: Path) -> None:
    """As `ik` and the warnings tell them; JSON has radians to the last digit."""
    (tmp_path / "arm.yaml").write_text(
        "format: 1\ntitle: T\nsource: mine\nconvention: standard\nvariables: [q1, d2]\n"
        "links:\n  - {a: 1 m, alpha: 0, d: 0, theta: q1}\n  - {a: 0, alpha: 0, d: d2, theta: 0}\n"
        "limits: {q1: [-2.8973 rad, 160.5°], d2: [0, 300 mm]}\nposes: {home: [0.7853981634 rad, 0.2]}\n",
        "utf-8",
    )
    rows = [line.split() for line in dhcli("show", "./arm.yaml").out.splitlines()]
    assert ["q1", "-166.0031°", "160.5°"] in rows
    assert ["d2", "0", "m", "0.3", "m"] in rows
    assert ["home", "45°", "0.2", "m"] in rows
    content = dhcli("show", "./arm.yaml", "--format", "json").data
    assert content["joints"][0]["limits"][0] == -2.8973


def test_lengths_that_no_arm_has_are_told_where_a_robot_is_shown_or_made(dhcli: Run, tmp_path: Path) -> None:
    """Millimetres without their unit are metres; once, and with what to do about it."""
    table = "a,alpha,d,theta\n400,0,0,q1\n300,0,0,q2\n"
    made = ("new", "robot", "--from", "-", "--convention", "standard")
    arm = tmp_path / "arm.yaml"
    long = dhcli(*made, "-o", str(arm), stdin=table)
    said = "a of row 1: 400 m is longer than any arm, and 1 more; "
    assert f"note: {said}--units mm takes bare lengths as such\n" in long.err
    warning = f"dhcli: warning: {said}bare lengths are metres: did you mean 400 mm? units: mm makes all of them so\n"
    assert dhcli("show", str(arm)).err == warning
    assert "longer" not in dhcli(*made, "--units", "mm", "-o", "-", stdin=table).err
    assert "did you mean 0.4 m?" in dhcli(*made, "-o", "-", stdin=table.replace("400", "4e-4").replace("300", "0")).err


def test_a_table_is_exported(dhcli: Run) -> None:
    """CSV for a spreadsheet, LaTeX for a paper."""
    assert dhcli("show", "planar-2r", "--format", "csv").out.split("\n")[:2] == ["i,a,alpha,d,theta", "1,a1,0,0,theta1"]
    assert r"$\alpha_{i-1}$" in dhcli("show", "puma560", "--format", "latex").out


def test_a_broken_file_is_listed_with_what_is_wrong(dhcli: Run, tmp_path: Path) -> None:
    """The others are listed all the same, and the exit code is 0."""
    (tmp_path / "robots").mkdir()
    (tmp_path / "robots" / "bad.yaml").write_text("format: 1\ntitle: x\n", "utf-8")
    done = dhcli("list", "robots")
    assert done.code == 0
    (line,) = (line for line in done.out.split("\n") if line.split()[:1] == ["bad"])
    assert "broken: " in line
    assert "is missing" in line
    assert "./robots" in line
    assert any(line.split()[:2] == ["scara", "RRP"] for line in done.out.split("\n"))


def test_a_robot_that_hides_a_built_in_one_is_said_to(dhcli: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    """Both are listed; the exercises, which are read anew beside it, are left out."""
    from dhcli.files.library import catalogue
    from dhcli.files.library.entries import Kind, entries

    monkeypatch.setattr(catalogue, "entries", lambda kind: entries(kind) if kind is Kind.ROBOTS else ())
    dhcli("new", "robot", "scara")
    lines = [line for line in dhcli("list", "robots").out.split("\n") if line.split()[:1] == ["scara"]]
    assert len(lines) == 2
    assert "./robots" in lines[0]
    assert "hidden by" in lines[1]


def test_kinds_without_content_are_not_shown(dhcli: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    """And an empty kind that is asked for is said to be empty."""
    from dhcli.files.library import catalogue
    from dhcli.files.library.entries import Kind, entries

    monkeypatch.setattr(catalogue, "entries", lambda kind: entries(kind) if kind is Kind.ROBOTS else ())
    assert "linkages" not in dhcli("list").out
    done = dhcli("list", "linkages")
    assert (done.code, done.out.strip()) == (0, "")
    assert done.err == "there are no linkages yet\n"


@pytest.mark.parametrize(
    ("convention", "joints"),
    paired(["standard", "modified", "product"], ["R", "P", "RRP", "PPP", "PRRPRR", "RRRRRRRRRRRR"]),
)
def test_a_new_robot_works_at_once(dhcli: Run, tmp_path: Path, convention: str, joints: str) -> None:
    """`dhcli fk NAME` finds it, in numbers, by its named pose and in symbols."""
    done = dhcli("new", "robot", "my-arm", "--convention", convention, "--joints", joints)
    assert done.code == 0
    assert done.err.startswith("wrote robots/my-arm.yaml\nnext: dhcli show my-arm, ")
    assert dhcli("show", "my-arm", "--format", "json").data["pattern"] == joints
    assert dhcli("fk", "my-arm", "--pose", "zero").code == 0
    assert dhcli("fk", "my-arm", "-s").out.startswith(
        f"T_{{0,{len(joints)}}}" if len(joints) > 9 else f"T_0{len(joints)}"
    )


def test_a_new_robot_never_overwrites_unasked(dhcli: Run, tmp_path: Path) -> None:
    """`--overwrite` asks."""
    dhcli("new", "robot", "arm", "--joints", "R")
    done = dhcli("new", "robot", "arm", "--joints", "P")
    assert done.code == 2
    assert "exists already" in done.err
    assert dhcli("show", "arm", "--format", "json").data["pattern"] == "R"
    assert dhcli("new", "robot", "arm", "--joints", "P", "--overwrite").code == 0
    assert dhcli("show", "arm", "--format", "json").data["pattern"] == "P"


def test_a_new_robot_is_written_where_it_is_asked_for(dhcli: Run, tmp_path: Path) -> None:
    """The next command names the file."""
    done = dhcli("new", "robot", "arm", "-o", "elsewhere.yaml")
    assert "dhcli show elsewhere.yaml" in done.err
    assert dhcli("fk", "elsewhere.yaml", "-s").code == 0


@pytest.mark.parametrize(
    "words",
    [
        "fk scara --q 0,0,0 -o - --format csv",
        "transform Rot(z,90°) -o - --format csv",
        "show scara -o - --format csv",
        "new robot arm -o -",
        "new exercise mine/first --robot planar-2r -o -",
        "start planar-two-links -o -",
    ],
)
def test_a_dash_is_standard_output(dhcli: Run, tmp_path: Path, words: str) -> None:
    """As it is standard input elsewhere; no file of that name appears."""
    done = dhcli(*words.split())
    assert (done.code, done.err) == (0, "")
    assert done.out
    assert not list(tmp_path.glob("**/-"))


def test_everything_listed_can_be_shown_and_asked(dhcli: Run) -> None:
    """Every robot that comes with dhcli, in symbols and on its page; by day on one of the two."""
    names = [e["name"] for e in dhcli("list", "robots", "--format", "json").data["entries"]]
    assert len(names) > 20
    for name in in_turn(names, 0, 2):
        assert dhcli("show", name).code == 0, name
    for name in in_turn(names, 1, 2):
        assert json.loads(dhcli("fk", name, "-s", "--format", "json").out)["ok"] is True


def table_cells(text: str) -> list[list[str]]:
    """The cells of the table in a page of Markdown, as a reader of it finds them."""
    tokens = MarkdownIt("commonmark").enable("table").parse(text)
    rows: list[list[str]] = []
    for before, token in pairwise(tokens):
        if before.type == "tr_open":
            rows.append([])
        if before.type in ("th_open", "td_open"):
            rows[-1].append(token.content)
    return rows


@pytest.mark.parametrize("name", ["puma560", "scara"])
def test_a_table_for_a_page_has_the_cells_of_the_table_for_a_paper(dhcli: Run, name: str) -> None:
    """In the same order; of moves each product is code."""
    cells = table_cells(dhcli("show", name, "--format", "md").out)
    paper = dhcli("show", name, "--format", "latex").out.splitlines()[1:-1]
    if name == "puma560":
        rows = [line.removesuffix(r" \\ \hline").removesuffix(r" \\").strip().split(" & ") for line in paper]
        assert cells == rows
    else:
        assert cells[1] == ["1", f"`{load_robot(name).links[0].product}`"]
        assert len(cells) == len(paper)


def test_an_exercise_for_a_page_tells_its_parts_and_no_hint(dhcli: Run, tmp_path: Path) -> None:
    """What stands indented in the task stays a formula; a variant has its own numbers."""
    done = dhcli("show", "bajd/composed-pose", "-o", "task.md")
    assert (done.code, done.err) == (0, "wrote task.md\n")
    page = (tmp_path / "task.md").read_text("utf-8")
    assert page.startswith("## A pose composed of a shift and two quarter turns\n\nThe frame")
    assert "\n\n    H = Trans(8, -6, 14) Rot(y, 90°) Rot(z, 90°)\n\nsays." in page
    exercise = load_exercise("bajd/composed-pose")
    listed = [token.content for token in MarkdownIt("commonmark").parse(page) if token.type == "inline"]
    for part in exercise.parts:
        assert any(one.startswith(f"**{part.id}**: ".replace("_", r"\_")) for one in listed)
        assert not any(hint in page for hint in part.hints)
    assert "   2. the 3x3 block is the orientation, the column right of it the position" in page
    words = ("show", "yim/planar-in-numbers", "--variant", "ada")
    (given,) = (line for line in dhcli(*words).out.splitlines() if line.startswith("given: "))
    assert f"\nG{given[1:]}\n" in dhcli(*words, "--format", "md").out
