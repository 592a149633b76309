"""`dhcli fk`: what each option shows."""

import csv
import io
import json
from math import cos, pi, sin
from pathlib import Path

import numpy as np
import pytest
import sympy

from dhcli import forward, load_robot, symbolic
from tests.cli.running import Done, Run

Q = "0.3,0.5,0.1"


def _matrix(done: Done) -> np.ndarray:
    return np.array(done.data["matrix"])


def test_the_first_command_of_the_readme_prints_the_pose(dhcli: Run) -> None:
    """Heading, values used, matrix, words: all of it, in this order."""
    done = dhcli("fk", "scara", "--q", Q)
    assert (done.code, done.err) == (0, "")
    assert done.out == (
        "T_03 of scara: frame 3 seen from frame 0\n"
        "product of moves · theta1 = 0.3 rad · theta2 = 0.5 rad · d3 = 0.1 m · l1 = 0.4 m · l2 = 0.3 m\n"
        "l3 = 0.2 m · lengths in m\n"
        "⎡ 0.6967  -0.7174  0  -0.2321 ⎤\n"
        "⎢ 0.7174   0.6967  0   0.4259 ⎥\n"
        "⎢ 0        0       1   0.3    ⎥\n"
        "⎣ 0        0       0   1      ⎦\n"
        "z' points along +z\n"
    )


def test_json_holds_the_full_precision_of_the_library(dhcli: Run) -> None:
    """The same floats as `forward` gives, none rounded."""
    done = dhcli("fk", "scara", "--q", Q, "--format", "json")
    assert _matrix(done).tolist() == [list(row) for row in forward(load_robot("scara"), [0.3, 0.5, 0.1]).rows]


@pytest.mark.parametrize(
    "words",
    [
        ("--q", "30°, 45deg, 100 mm"),
        ("--q", "theta1=30°,q2=45°,d3=10cm"),
        ("--q", "30,45,0.1", "--deg"),
        ("--q", "pi/6,pi/4,0.1"),
        ("--q", "pick"),
        ("--pose", "pick"),
    ],
)
def test_joint_values_are_read_in_every_form(dhcli: Run, words: tuple[str, ...]) -> None:
    """Units, names, degrees, π and named poses all say the same pose."""
    found = _matrix(dhcli("fk", "scara", *words, "--format", "json"))
    assert np.allclose(found, forward(load_robot("scara"), "pick").matrix, atol=1e-15)


def test_a_leading_minus_is_a_value_and_not_an_option(dhcli: Run) -> None:
    """`--q -0.3,0.5,0.1` works as it is typed."""
    assert dhcli("fk", "scara", "--q", "-0.3,0.5,0.1", "--format", "json").data["values"]["theta1"] == -0.3


def test_joint_values_come_from_a_file(dhcli: Run, tmp_path: Path) -> None:
    """Lines, commas and comments."""
    (tmp_path / "q.txt").write_text("# the elbow up\n0.3, 0.5,\n100mm\n", "utf-8")
    assert dhcli("fk", "scara", "--q", "@q.txt", "--format", "json").data["values"]["d3"] == 0.1


def test_set_replaces_a_length(dhcli: Run) -> None:
    """In any unit."""
    done = dhcli("fk", "scara", "--q", "0,0,0", "--set", "l2=1000mm", "--set", "l3=1", "--format", "json")
    assert _matrix(done)[1][3] == 2.0


def test_symbolic_prints_the_textbook_form(dhcli: Run) -> None:
    """The line that the blueprint promises."""
    assert "p_x = c1*(a2*c2 + a3*c23 - d4*s23) - d3*s1\n" in dhcli("fk", "puma560", "--symbolic").out


def test_the_full_style_spells_functions_out(dhcli: Run) -> None:
    """No shorthand is left, so no legend is needed either."""
    out = dhcli("fk", "planar-2r", "-s", "--style", "full").out
    assert "cos(theta1+theta2)" in out
    assert "c12" not in out


def test_symbolic_substitutes_exactly_what_is_given(dhcli: Run) -> None:
    """theta4 and a3 become zero; nothing else gets a value."""
    done = dhcli("fk", "puma560", "-s", "--q", "theta4=0", "--set", "a3=0", "--style", "short", "--format", "json")
    assert set(done.data["values"]) == {"theta4", "a3"}
    pose = symbolic(load_robot("puma560"), {"theta4": "0"}, parameters={"a3": "0"})
    assert done.data["matrix"] == [list(row) for row in pose.cells()]


def test_frames_lists_every_frame_from_the_first(dhcli: Run) -> None:
    """T_01 to T_03, and the last is the pose itself."""
    data = dhcli("fk", "scara", "--q", Q, "--frames", "--format", "json").data
    assert [(f["name"], f["reference"], f["frame"]) for f in data["frames"]] == [
        ("T_01", "0", "1"),
        ("T_02", "0", "2"),
        ("T_03", "0", "3"),
    ]
    assert data["frames"][-1]["matrix"] == data["matrix"]


def test_the_product_of_the_links_is_the_pose(dhcli: Run) -> None:
    """A_1 A_2 A_3 = T_03."""
    data = dhcli("fk", "scara", "--q", Q, "--links", "--format", "json").data
    assert [link["name"] for link in data["links"]] == ["A_1", "A_2", "A_3"]
    product = np.linalg.multi_dot([np.array(link["matrix"]) for link in data["links"]])
    assert np.allclose(product, data["matrix"], atol=1e-15)


@pytest.mark.parametrize(
    ("robot", "names"),
    [
        ("dh-link", ["Rot(z, theta_i)", "Trans(0, 0, d_i)", "Trans(a_i, 0, 0)", "Rot(x, alpha_i)"]),
        (
            "dh-link-modified",
            ["Rot(x, alpha_{i-1})", "Trans(a_{i-1}, 0, 0)", "Trans(0, 0, d_i)", "Rot(z, theta_i)"],
        ),
    ],
)
def test_the_factors_stand_in_the_order_of_the_convention(dhcli: Run, robot: str, names: list[str]) -> None:
    """Four elementary matrices for a DH row."""
    data = dhcli("fk", robot, "-s", "--factors", "all", "--format", "json").data
    assert [factor["name"] for factor in data["factors"]] == names


def test_factors_of_one_link_need_the_values_of_that_link_only(dhcli: Run) -> None:
    """The pose beside them is that link's own."""
    data = dhcli("fk", "puma560", "--q", "q2=30°", "--factors", "2", "--format", "json").data
    assert (data["reference"], data["frame"], len(data["factors"])) == ("1", "2", 4)
    product = np.linalg.multi_dot([np.array(factor["matrix"]) for factor in data["factors"]])
    assert np.allclose(product, data["matrix"], atol=1e-15)


def test_from_and_to_choose_the_frames(dhcli: Run) -> None:
    """Zhou's tool stands behind frame 6."""
    data = dhcli("fk", "zhou-6r", "--pose", "zero", "--from", "3", "--to", "tool", "--format", "json").data
    assert (data["reference"], data["frame"]) == ("3", "tool")
    assert data["matrix"] == [list(row) for row in forward(load_robot("zhou-6r"), "zero", start=3, end="tool").rows]


def test_the_inverse_undoes_the_pose(dhcli: Run) -> None:
    """Frames change places, and the product is the identity."""
    there = dhcli("fk", "scara", "--q", Q, "--format", "json").data
    back = dhcli("fk", "scara", "--q", Q, "--inverse", "--format", "json").data
    assert (back["reference"], back["frame"]) == ("3", "0")
    assert np.allclose(np.array(there["matrix"]) @ np.array(back["matrix"]), np.eye(4), atol=1e-15)


def test_a_point_of_the_end_frame_is_seen_from_the_first(dhcli: Run) -> None:
    """A unit along x3."""
    seen = dhcli("fk", "planar-2r", "--q", "90°,-90°", "--set", "a1=1,a2=1", "--point", "1,0,0.5").out
    assert seen.endswith("p_x = 2\np_y = 1\np_z = 0.5\n")


def test_names_of_a_symbolic_point_may_be_unknown_to_the_robot(dhcli: Run) -> None:
    """Bajd's grasped block, in letters of its own."""
    out = dhcli("fk", "scara", "-s", "--point", "-e*cos(alpha), -e*sin(alpha), c").out
    assert "p_z = l1 - d3 + c\n" in out
    assert "e*c12*cos(alpha)" in out


def test_as_replaces_the_matrix_and_states_its_convention(dhcli: Run) -> None:
    """Roll, pitch, yaw and position, in the order asked."""
    out = dhcli("fk", "scara", "--pose", "pick", "--as", "rpy", "--as", "position").out
    assert "R = Rz(yaw) Ry(pitch) Rx(roll)" in out
    assert "yaw   = 75°" in out
    assert out.index("rpy") < out.index("position")


@pytest.mark.parametrize(
    ("form", "hint"),
    [
        ("quat", "did you mean quaternion?"),
        ("rotvec", "did you mean rotation-vector?"),
        ("euler", "zyz and all orders of"),
    ],
)
def test_a_form_that_there_is_not_is_told_the_nearest_or_all(dhcli: Run, form: str, hint: str) -> None:
    """Orders of axes among them."""
    done = dhcli("fk", "scara", "--pose", "pick", "--as", form)
    assert (done.code, done.out) == (2, "")
    assert hint in done.err


def test_roll_at_the_pole_is_zero_with_a_warning(dhcli: Run) -> None:
    """Pitch 90° leaves only one of roll and yaw."""
    done = dhcli("transform", "Rot(z,20°) Rot(y,90°) Rot(x,30°)", "--as", "rpy")
    assert "roll  =   0°" in done.out
    assert "dhcli: warning: pitch is ±90°" in done.err


def test_let_names_the_brackets_that_come_twice(dhcli: Run) -> None:
    """As a lecturer writes it."""
    out = dhcli("fk", "puma560", "-s", "--let").out
    assert "let k1 = c4*c5*c6 - s4*s6\n" in out
    assert "c1*k8 - d3*s1" in out


def test_a_limit_that_is_passed_warns_on_stderr_and_names_the_joint(dhcli: Run) -> None:
    """The pose is computed all the same."""
    done = dhcli("fk", "puma560", "--q", "200,0,0,0,0,0", "--deg")
    assert done.code == 0
    assert done.err == "dhcli: warning: theta1 = 200° is outside its limits, -160° to 160°\n"
    assert "warning" not in done.out


def test_warnings_stand_in_the_envelope_too(dhcli: Run) -> None:
    """With their severity; the command is a success."""
    envelope = dhcli("fk", "puma560", "--q", "200,0,0,0,0,0", "--deg", "--format", "json").envelope
    assert envelope["ok"] is True
    assert [problem["severity"] for problem in envelope["problems"]] == ["warning"]


def test_numpy_reads_the_numpy_format(dhcli: Run) -> None:
    """Full precision, comment and all."""
    out = dhcli("fk", "scara", "--q", Q, "--format", "numpy").out
    assert np.array_equal(eval(out, {"np": np}), forward(load_robot("scara"), [0.3, 0.5, 0.1]).matrix)  # noqa: S307


def test_sympy_reads_the_sympy_format(dhcli: Run) -> None:
    """And finds the same pose."""
    out = dhcli("fk", "puma560", "-s", "--format", "sympy").out
    values = {f"theta{i}": i / 10 for i in range(1, 7)} | {"a2": 0.4318, "a3": 0.0203, "d3": 0.15005, "d4": 0.4318}
    found = sympy.sympify(out).subs(values).evalf()
    expected = forward(load_robot("puma560"), [i / 10 for i in range(1, 7)]).matrix
    assert np.allclose(np.array(found.tolist(), dtype=float), expected, atol=1e-12)


def test_csv_has_four_lines_of_four(dhcli: Run) -> None:
    """Numbers in full precision."""
    rows = list(csv.reader(io.StringIO(dhcli("fk", "scara", "--q", Q, "--format", "csv").out)))
    assert [len(row) for row in rows] == [4] * 4
    assert float(rows[0][0]) == pytest.approx(cos(0.8), abs=1e-15)


def test_matlab_declares_the_symbols_it_uses(dhcli: Run) -> None:
    """But not the names of brackets, which have a line of their own."""
    lines = dhcli("fk", "stanford", "-s", "--let", "--format", "matlab").out.split("\n")
    assert lines[0] == "% T_06 of stanford: frame 6 seen from frame 0"
    assert lines[1] == "syms d2 d3 d6 theta1 theta2 theta4 theta5 theta6 real"
    assert lines[2].startswith("k1 = ")


def test_latex_is_a_bracketed_matrix(dhcli: Run) -> None:
    """With subscripts in braces."""
    out = dhcli("fk", "planar-2r", "-s", "--format", "latex").out
    assert out.startswith("\\begin{bmatrix}\n  c_{12} & -s_{12} & 0 & ")


def test_digits_round_what_people_read(dhcli: Run) -> None:
    """Ten decimals."""
    assert f"{sin(0.8):.10f}" in dhcli("fk", "scara", "--q", Q, "--digits", "10").out


@pytest.mark.parametrize(
    ("suffix", "start"),
    [
        *(("json", "{"), ("tex", r"\begin{bmatrix}"), ("m", "%")),
        *(("py", "import numpy as np"), ("csv", "0.69"), ("txt", "T_03 of scara")),
    ],
)
def test_the_suffix_of_the_file_chooses_the_format(dhcli: Run, tmp_path: Path, suffix: str, start: str) -> None:
    """Nothing on stdout, one line of talk on stderr."""
    done = dhcli("fk", "scara", "--q", Q, "-o", f"pose.{suffix}")
    assert (done.code, done.out, done.err) == (0, "", f"wrote pose.{suffix}\n")
    assert (tmp_path / f"pose.{suffix}").read_text("utf-8").startswith(start)


def test_a_file_is_overwritten_only_with_force(dhcli: Run, tmp_path: Path) -> None:
    """The old content stays until then."""
    (tmp_path / "pose.json").write_text("precious", "utf-8")
    done = dhcli("fk", "scara", "--q", Q, "-o", "pose.json")
    assert done.code == 2
    assert "--overwrite" in done.err
    assert (tmp_path / "pose.json").read_text("utf-8") == "precious"
    assert dhcli("fk", "scara", "--q", Q, "-o", "pose.json", "--overwrite").code == 0
    assert json.loads((tmp_path / "pose.json").read_text("utf-8"))["ok"] is True


def test_a_robot_file_is_read_from_standard_input(dhcli: Run) -> None:
    """`-` is accepted wherever a robot is asked for."""
    text = (Path(__file__).parents[2] / "robots" / "scara.yaml").read_text("utf-8")
    done = dhcli("fk", "-", "--q", f"0,{pi / 2},0", stdin=text)
    assert done.code == 0
    assert done.out.startswith("T_03 of stdin: frame 3 seen from frame 0\n")


def test_the_matrix_is_one_of_the_ways_to_say_a_pose(dhcli: Run) -> None:
    """Beside others, in numbers and in symbols, for people and for programs."""
    words = ("fk", "planar-2r", "--as", "position,matrix")
    assert "⎡ c12  -s12  0  a1*c1 + a2*c12 ⎤" in dhcli(*words, "--symbolic").out
    data = dhcli(*words, "--q", "0,0", "--format", "json").data
    assert data["as"]["matrix"] == data["matrix"] == [[1, 0, 0, 0.7], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]
    lines = dhcli(*words, "--q", "0,0", "--format", "csv").out.splitlines()
    assert lines[1] == "matrix,1.0,0.0,0.0,0.7,0.0,1.0,0.0,0.0,0.0,0.0,1.0,0.0"


@pytest.mark.parametrize(
    ("q", "said"),
    [
        ("90°,0", "x' points along +y, y' points along -x, z' points along +z"),
        ("1.5707963267948966,0", "x' points along +y, y' points along -x, z' points along +z"),
        ("1e-9,0", "z' points along +z"),
        ("3.14159,0", "z' points along +z"),
    ],
)
def test_an_axis_points_along_another_only_where_it_does(dhcli: Run, q: str, said: str) -> None:
    """Not where it looks so in four decimals."""
    assert dhcli("fk", "planar-2r", "--q", q).out.splitlines()[-1] == said


def test_a_small_position_is_not_shown_as_zero(dhcli: Run) -> None:
    """Of a matrix and of a point; where one coordinate is not small, or digits are asked for, all are rounded."""
    words = ("fk", "planar-2r", "--q", "90°,90°", "--set", "a1=0.03mm")
    assert dhcli(*words, "--set", "a2=0.0123456mm").out.splitlines()[2:4] == [
        "⎡ -1   0  0  -0.0000123 ⎤",
        "⎢  0  -1  0   0.00003   ⎥",
    ]
    point = dhcli(*words, "--set", "a2=0", "--point", "0,0,0").out.splitlines()[-3:]
    assert point == ["p_x = 0", "p_y = 0.00003", "p_z = 0"]
    assert dhcli(*words, "--set", "a2=0", "--point", "0,0,1").out.splitlines()[-2] == "p_y = 0"
    assert dhcli(*words, "--set", "a2=0", "--point", "0,0,0", "--digits", "2").out.splitlines()[-2] == "p_y = 0"


def test_a_named_pose_may_be_varied(dhcli: Run) -> None:
    """By joints with their names; a list of all joints would leave nothing of it."""
    varied = dhcli("fk", "puma560", "--pose", "ready", "--q", "q1=30°", "--format", "json").data
    plain = dhcli("fk", "puma560", "--q", "30°,-90°,-90°,0,0,0", "--format", "json").data
    assert varied["matrix"] == plain["matrix"]
    done = dhcli("fk", "puma560", "--pose", "ready", "--q", "0,0,0,0,0,0")
    assert done.code == 2
    assert "--q NAME=VALUE varies a pose" in done.err


def test_the_heading_says_what_the_pose_leaves_out(dhcli: Run, tmp_path: Path) -> None:
    """Base and tool of the file, where it has them, and only where both ends are the first and the last frame."""
    text = (Path(__file__).parents[2] / "robots" / "planar-2r.yaml").read_text("utf-8")
    cases = {
        "": (None, None),
        "tool: Trans(0, 0, 0.1)\n": ("without tool: --to tool has it", "--to tool"),
        "base: Trans(0, 0, 1)\n": ("without base: --from base has it", "--from base"),
        "base: Trans(0, 0, 1)\ntool: Rot(x, 30°)\n": (
            "without base and tool: --from base --to tool has both",
            "--from base --to tool",
        ),
    }
    path = tmp_path / "arm.yaml"
    for more, (said, options) in cases.items():
        path.write_text(text + more, "utf-8")
        for way in (("-s",), ("-s", "--inverse"), ("--q", "0,0", "--as", "rpy"), ("-s", "--point", "0,0,0")):
            out = dhcli("fk", str(path), *way).out
            assert (said in out) if said else ("without" not in out), (more, way)
            assert options is None or "without" not in dhcli("fk", str(path), *way, *options.split()).out
        assert "without" not in dhcli("fk", str(path), "-s", "--to", "1").out


def test_a_tool_that_is_typed_stands_behind_the_last_frame(dhcli: Run, tmp_path: Path) -> None:
    """The pose is that of the robot times that of the tool, for one pose and for rows; that of the file gives way."""
    moves = "Trans(0.1,0,l3) Rot(x,90°)"
    tool = np.array([[1, 0, 0, 0.1], [0, 0, -1, 0], [0, 1, 0, 0.2], [0, 0, 0, 1]])
    expected = forward(load_robot("scara"), [0.3, 0.5, 0.1]).matrix @ tool
    assert np.allclose(_matrix(dhcli("fk", "scara", "--q", Q, "--tool", moves, "--format", "json")), expected)
    assert dhcli("fk", "scara", "--q", Q, "--tool", moves).out.startswith("T_{0,tool} of scara: tool seen")
    back = dhcli("fk", "scara", "--q", Q, "--tool", moves, "--from", "tool", "--to", "0", "--format", "json")
    assert np.allclose(_matrix(back) @ expected, np.eye(4))
    (tmp_path / "q.csv").write_text("theta1,theta2,d3\n0.3,0.5,0.1\n", "utf-8")
    rows = dhcli("fk", "scara", "--rows", str(tmp_path / "q.csv"), "--tool", moves, "--as", "position").out.splitlines()
    assert np.allclose([float(cell) for cell in rows[1].split(",")], expected[:3, 3])
    own = load_robot("zhou-6r")
    bare = forward(own.copy(tool="Trans(0,0,1)"), "zero", end="tool").matrix
    assert np.allclose(
        _matrix(dhcli("fk", "zhou-6r", "--pose", "zero", "--tool", "Trans(0,0,1)", "--format", "json")), bare
    )


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("--tool", "Trans(0,0,0.1)", "--to", "2"), "--to 2 does not reach it"),
        (("--tool", "Trans(0,0,l9)"), "--tool:11: l9 is not a name"),
        (("--tool", "gripper"), "--tool"),
        (("--tool", ""), "--tool"),
    ],
)
def test_a_tool_that_cannot_be_is_refused(dhcli: Run, words: tuple[str, ...], said: str) -> None:
    """With the place in what was typed."""
    done = dhcli("fk", "scara", "--q", Q, *words)
    assert done.code == 2
    assert said in done.err


def test_a_tool_of_the_file_is_asked_for_by_name(dhcli: Run, tmp_path: Path) -> None:
    """As if its moves were typed, with lengths of the robot; `show` lists it, and saving keeps it."""
    text = (Path(__file__).parents[2] / "robots" / "scara.yaml").read_text("utf-8")
    path, copy = tmp_path / "arm.yaml", tmp_path / "copy.yaml"
    path.write_text(text + "tools: {gripper: 'Trans(0,0,l3) Rot(z,30°)', none: 'Trans(0,0,0)'}\n", "utf-8")
    arm = load_robot(path)
    arm.save(copy)
    assert load_robot(copy).tools == arm.tools
    for robot in (path, copy):
        named, typed = (
            dhcli("fk", str(robot), "--q", Q, "--tool", tool, "--format", "csv").out
            for tool in ("gripper", "Trans(0,0,l3) Rot(z,30°)")
        )
        assert named == typed
    assert "tool gripper  Trans(0, 0, l3) Rot(z, 30°)" in dhcli("show", str(path)).out
    wrong = dhcli("fk", str(path), "--q", Q, "--tool", "griper")
    assert (wrong.code, "did you mean gripper?" in wrong.err) == (2, True)
    arm.save(tmp_path / "arm.urdf")
    assert load_robot(tmp_path / "arm.urdf").tools == {}
    said = dhcli("describe", str(path), "--as", "modified", "--numbers")
    assert "the tools of the file are left out" in said.out


def test_a_tool_that_moves_is_refused_where_it_stands(dhcli: Run, tmp_path: Path) -> None:
    """A joint variable in it, a name that is none, a matrix that is no rotation."""
    text = (Path(__file__).parents[2] / "robots" / "scara.yaml").read_text("utf-8")
    path = tmp_path / "arm.yaml"
    line = text.count("\n") + 2
    for moves, said in {
        "Rot(z, theta1)": "theta1 is a joint variable",
        "Trans(0, 0, l9)": "l9 is not a name",
        "[2 0 0 0; 0 1 0 0; 0 0 1 0; 0 0 0 1]": "",
    }.items():
        path.write_text(f"{text}tools:\n  gripper: '{moves}'\n", "utf-8")
        done = dhcli("fk", str(path), "--q", Q)
        assert (done.code, f"arm.yaml:{line}:" in done.err, said in done.err) == (2, True, True), done.err
