"""`dhcli ik`: every way to say a pose, what is shown of the solutions, and what is refused."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from dhcli import forward, inverse, load_robot
from tests.cli.running import Run
from tests.cli.terminal import Terminal
from tests.row_by_row import row_by_row

CONTENT = {
    *("robot", "convention", "values", "task", "reference", "frame", "joints", "reachable", "why", "held", "closest"),
    *("target", "solutions", "factors", "how"),
}
SOLUTION = {"q", "branch", "within_limits", "beyond", "residual", "free"}
PAGE = """\
inverse kinematics: position of frame 2 of planar-2r, seen from frame 0
standard DH · a1 = 0.4 m · a2 = 0.3 m · lengths in m
position 0.5, 0.3, 0 m

2 solutions

 #   theta1     theta2      branch
 ─────────────────────────────────────
 1    2.4773°    67.9757°   elbow down
 2   59.4502°   -67.9757°   elbow up

"""


def test_the_whole_answer_stands_on_a_page(dhcli: Run) -> None:
    """Heading, what was given, how many, a row for each."""
    done = dhcli("ik", "planar-2r", "--position", "0.5,0.3,0")
    assert (done.code, done.out, done.err) == (0, PAGE, "")


def test_json_has_exactly_these_keys(dhcli: Run) -> None:
    """A new key is a decision, and stands here; joint values are in radians and metres and reach the pose."""
    data = dhcli("ik", "puma560", "--pose", "ready", "--format", "json").data
    assert set(data) == CONTENT
    assert all(set(solution) == SOLUTION for solution in data["solutions"])
    assert (data["task"], data["reference"], data["frame"], data["reachable"], data["why"]) == (
        "pose",
        "0",
        "6",
        True,
        "",
    )
    robot = load_robot("puma560")
    for solution in data["solutions"]:
        assert np.allclose(forward(robot, solution["q"]).matrix, forward(robot, "ready").matrix, atol=1e-12)
    [free] = [way for solution in data["solutions"] for way in solution["free"]]
    assert free == {"joint": "theta4", "joints": ["theta4", "theta6"], "relation": "theta4 + theta6 = 0°, any theta4"}


def test_what_fk_prints_goes_back_in(dhcli: Run) -> None:
    """JSON, a table of numbers and a numpy matrix are read from standard input."""
    q = "0.3,-0.5,0.7,1,0.8,-2"
    for format_ in ("json", "matlab", "numpy"):
        text = dhcli("fk", "puma560", "--q", q, "--format", format_, "--digits", "12").out
        data = dhcli("ik", "puma560", "--target", "-", "--near", q, "--format", "json", stdin=text).data
        assert data["solutions"][0]["q"] == pytest.approx([0.3, -0.5, 0.7, 1, 0.8, -2], abs=1e-9)


@pytest.mark.parametrize(
    ("words", "task"),
    [
        (("--q", "0.3,-0.5,0.7,1,0.8,-2"), "pose"),
        (("--target", "Trans(0.4,0.2,0.3) Rot(x,180°)"), "pose"),
        (("--position", "0.4,0.2,0.3", "--rpy", "180°,0,0"), "pose"),
        (("--position", "0.4,0.2,0.3", "--quaternion", "0,1,0,0"), "pose"),
        (("--position", "0.4,0.2,0.3", "--pointing", "0,0,-1"), "axis"),
        (("--position", "400mm,0.2,0.3"), "position"),
        (("--pointing", "0,0,-1"), "direction"),
        (("--rpy", "180,0,0", "--deg"), "orientation"),
        (("--pose", "ready", "--task", "orientation"), "orientation"),
    ],
)
def test_a_pose_is_said_in_many_ways(dhcli: Run, words: tuple[str, ...], task: str) -> None:
    """What counts of it follows from what is said."""
    data = dhcli("ik", "puma560", *words, "--format", "json").data
    assert data["task"] == task
    assert data["solutions"]


def test_three_ways_to_say_one_pose_give_the_same_solutions(dhcli: Run) -> None:
    """Moves, angles and a quaternion."""
    ways = (
        ("--target", "Trans(0.4,0.2,0.3) Rot(x,180°)"),
        ("--position", "0.4,0.2,0.3", "--rpy", "180°,0,0"),
        ("--position", "0.4,0.2,0.3", "--quaternion", "0,1,0,0"),
    )
    found = [dhcli("ik", "ur5e", *way, "--near", "work", "--format", "json").data["solutions"] for way in ways]
    for other in found[1:]:
        assert [s["branch"] for s in other] == [s["branch"] for s in found[0]]
        assert np.allclose([s["q"] for s in other], [s["q"] for s in found[0]], atol=1e-9)


def test_rpy_turns_as_fk_says_it(dhcli: Run) -> None:
    """Roll, pitch and yaw of a pose lead back to it."""
    said = forward(load_robot("spherical-wrist"), [0.3, 0.6, -0.4]).rpy
    words = ",".join(repr(angle) for angle in (said.roll, said.pitch, said.yaw))
    data = dhcli("ik", "spherical-wrist", f"--rpy={words}", "--near", "0.3,0.6,-0.4", "--format", "json").data
    assert data["solutions"][0]["q"] == pytest.approx([0.3, 0.6, -0.4])


def test_a_pose_out_of_reach_ends_with_1_and_says_why(dhcli: Run) -> None:
    """Reasons, the part that can be reached, and where the arm comes nearest."""
    done = dhcli("ik", "puma560", "--target", "Trans(3,0,0)")
    assert done.code == 1
    assert (
        "no solution\n  the point is 3 m from the first joint, and the links laid end to end are 0.8894 m\n" in done.out
    )
    assert "  the nearest pose reached is 2." in done.out
    assert "  nearest with theta1 = " in done.out


def test_only_some_branches_are_shown_on_request(dhcli: Run) -> None:
    """Words of their names; one that no solution has is refused with those there are."""
    data = dhcli("ik", "puma560", "--pose", "nominal", "--branch", "elbow up, shoulder left", "--format", "json").data
    assert {s["branch"] for s in data["solutions"]} == {
        f"shoulder left, elbow up, wrist {w}" for w in ("flip", "noflip")
    }
    done = dhcli("ik", "puma560", "--pose", "nominal", "--branch", "elbow sideways")
    assert done.code == 2
    assert "branches here: " in done.err


def test_a_spare_joint_is_told_and_may_be_held_or_sampled(dhcli: Run) -> None:
    """Panda has seven joints."""
    held = dhcli("ik", "panda", "--pose", "ready", "--hold", "theta7=45°", "--format", "json").data
    assert held["held"] == {"theta7": pytest.approx(math.pi / 4)}
    told = dhcli("ik", "panda", "--pose", "ready")
    assert "panda has 1 joint more than this needs: held theta7 = 45°, as in the joint values given" in told.err
    again = dhcli("ik", "panda", "--q", "0.1,-0.5,0.2,-2,0.3,1.5,0.9", "--within-limits", "--format", "json").data
    assert [0.1, -0.5, 0.2, -2, 0.3, 1.5, 0.9] in [pytest.approx(s["q"], abs=1e-9) for s in again["solutions"]]
    sampled = dhcli("ik", "panda", "--pose", "ready", "--family", "6", "--format", "json").data
    assert len({round(s["q"][6], 9) for s in sampled["solutions"]}) > 1


def test_a_joint_at_its_limit_is_inside_to_the_digits_typed(dhcli: Run) -> None:
    """PUMA's theta2 at 45°, which four decimals put a thousandth of a degree above."""
    matrix = np.round(np.array(forward(load_robot("puma560"), "0.3, 45°, -2, 0.3, 0.7, 0.1").matrix), 4).tolist()
    done = dhcli("ik", "puma560", "--target", str(matrix), "--within-limits", "--format", "json")
    q = [s["q"] for s in done.data["solutions"]]
    assert [0.3, math.pi / 4, -2, 0.3, 0.7, 0.1] in [pytest.approx(row, abs=1e-3) for row in q]
    assert "to the digits typed theta2 may stand at a limit" in done.err


def test_rows_of_few_decimals_are_taken_as_single_poses_are(dhcli: Run, tmp_path: Path) -> None:
    """An arm of three joints takes none of them with exactly these digits, and that is said once."""
    exact = [[0.3, 0.9, 0.2], [0.1, 0.4, 1.2]]
    matrices = [np.round(np.array(forward(load_robot("zhou-3r"), q).matrix), 4).tolist() for q in exact]
    path = tmp_path / "poses.jsonl"
    path.write_text("".join(json.dumps({"matrix": matrix}) + "\n" for matrix in matrices), encoding="utf-8")
    done = dhcli("ik", "zhou-3r", "--rows", str(path), "--format", "csv")
    assert done.code == 0
    rows = [[float(cell) for cell in line.split(",")] for line in done.out.splitlines()[1:]]
    assert rows == [pytest.approx([line, *q], abs=1e-3) for line, q in enumerate(exact, 1)]
    assert done.err.count("no pose with exactly the digits of some rows") == 1


def test_csv_has_a_line_for_each_solution(dhcli: Run) -> None:
    """And goes back into `fk --rows` without its first two columns."""
    lines = dhcli("ik", "ur5e", "--pose", "work", "--format", "csv").out.splitlines()
    assert lines[0] == "branch,within_limits,theta1,theta2,theta3,theta4,theta5,theta6"
    assert len(lines) == 9


@row_by_row(
    ("words", "said"),
    [
        (("puma560",), "no pose is given"),
        (("puma560", "--pose", "ready", "--target", "Trans(1,0,0)"), "given in two ways"),
        (("puma560", "--rpy", "0,0,0", "--pointing", "0,0,1"), "orientation is given in two ways"),
        (("puma560", "--rpy", "0,0"), "three angles are wanted, not 2"),
        (("puma560", "--quaternion", "0,0,0,0"), "it has no length"),
        (("puma560", "--quaternion", "1,0,0"), "4 numbers are wanted, not 3"),
        (("puma560", "--position", "1,2"), "a point has three coordinates"),
        (("puma560", "--position", "x,0,0"), "x has no value"),
        (("puma560", "--target", "Trans(a,0,0)"), "a has no value"),
        (("puma560", "--target", "[1 0 0 0; 0 2 0 0; 0 0 1 0; 0 0 0 1]"), "column 2 is not a unit vector"),
        (("puma560", "--pose", "ready", "--task", "positon"), "did you mean position"),
        (("puma560", "--pose", "ready", "--hold", "theta9=1"), "no joint theta9"),
        (("puma560", "--pose", "ready", "--hold", "1"), "is not NAME=VALUE"),
        (("puma560", "--pose", "ready", "--near", "nowhere"), "no pose called nowhere"),
        (("assembly-blocks", "--target", "Trans(1,0,0)"), "no joint moves the end"),
        (("dh-link", "--target", "Trans(1,0,0)"), "have no value"),
        (("puma560", "--pose", "ready", "--to", "9"), "no frame 9"),
        (("puma560", "--pose", "ready", "--format", "matlab"), "there is no format matlab"),
    ],
)
def test_what_cannot_be_answered_is_refused_with_2(dhcli: Run, words: tuple[str, ...], said: str) -> None:
    """What is wrong, on standard error, and nothing on standard output."""
    done = dhcli("ik", *words)
    assert (done.code, done.out) == (2, "")
    assert said in done.err


def test_formulas_are_derived_step_by_step(dhcli: Run) -> None:
    """The rule, the equations with the level they stand in, the formula, and where it says nothing."""
    out = dhcli("ik", "planar-2r", "--derive").out
    assert "standard DH · c2 = cos(theta2) · c12 = cos(theta1+theta2)\n" in out
    assert "1. theta2: SQUARES" in out
    assert "   theta2 = ± acos((px^2 + py^2 - a1^2 - a2^2)/(2*a1*a2))\n" in out
    assert "   px = a1*c1 + a2*c12    (1,4) of T = T_02\n" in out
    assert "   theta1 = atan2(py, px) - atan2(a2*s2, a1 + a2*c2)\n" in out
    assert "2 combinations of signs" in out


def test_a_derivation_says_what_its_letters_mean_in_the_names_of_the_robot(dhcli: Run, tmp_path: Path) -> None:
    """No theta1 where the joints are called otherwise."""
    table = "convention: standard\nvariables: [alpha, beta]\nparameters: {a1: 1 m, a2: 1 m}\nlinks:\n"
    rows = "".join(f"  - {{a: a{k}, alpha: 0, d: 0, theta: {name}}}\n" for k, name in ((1, "alpha"), (2, "beta")))
    (tmp_path / "arm.yaml").write_text(f"format: 1\ntitle: t\nsource: s\n{table}{rows}", encoding="utf-8")
    out = dhcli("ik", str(tmp_path / "arm.yaml"), "--derive").out
    assert "theta" not in out
    assert "standard DH\n" in out


def test_a_derivation_has_these_keys_in_json(dhcli: Run) -> None:
    """A new key is a decision, and stands here."""
    data = dhcli("ik", "zhou-3r", "--derive", "--format", "json").data
    assert set(data) == {
        "robot",
        "convention",
        "reference",
        "frame",
        "task",
        "branches",
        "proved",
        "only_where",
        "steps",
    }
    keys = {"rule", "unknown", "equations", "value", "plus_minus", "or_half_a_turn_more", "condition", "instead"}
    assert all(set(step) == keys for step in data["steps"])
    assert [step["unknown"] for step in data["steps"]] == ["theta1 + theta2", "theta3", "theta1", "theta2"]


def test_a_urdf_has_the_formulas_of_its_table(dhcli: Run, tmp_path: Path) -> None:
    """Its links end where its maker drew them; a table has a frame where the wrist can be taken off."""
    path = tmp_path / "arm.urdf"
    assert dhcli("describe", "ur5e", "--as", "urdf", "-o", str(path)).code == 0
    done = dhcli("ik", str(path), "--code", "python")
    assert done.code == 0
    assert "the formulas are those of its DH table" in done.err
    space: dict[str, Any] = {}
    exec(done.out, space)  # noqa: S102  our own output, as a user runs it
    robot, q = load_robot("ur5e"), [0.4, -0.7, 0.5, -0.6, 0.8, 1.1]
    rows = space["inverse"](np.array(forward(robot, q).matrix).tolist())
    found = inverse(robot, forward(robot, q))
    assert len(rows) == len(found) == 4
    assert max(found.distances(row).min() for row in rows) < 1e-9


def test_a_derivation_is_written_for_papers_and_programs(dhcli: Run) -> None:
    """LaTeX, Python, MATLAB."""
    assert dhcli("ik", "planar-2r", "--derive", "--format", "latex").out.startswith(
        "\\begin{aligned}\n\\theta_{2} &= \\pm "
    )
    assert "def inverse(T, a1=0.4, a2=0.3, tolerance=0.001):" in dhcli("ik", "planar-2r", "--code", "numpy").out
    assert (
        "function solutions = inverse(T, a1, a2, tolerance)"
        in dhcli("ik", "planar-2r", "--derive", "--code", "matlab").out
    )


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("puma200", "--derive"), "no textbook form by these rules"),
        (("assembly-blocks", "--derive"), "no joint moves the end"),
        (("assembly-blocks", "--code", "matlab"), "no joint moves the end"),
        (("puma560", "--derive", "--pose", "ready"), "takes no pose"),
        (("puma560", "--derive", "--task", "axis"), "knows no task axis"),
        (("puma560", "--derive", "--format", "csv"), "there is no format csv"),
    ],
)
def test_what_cannot_be_derived_is_refused_with_2(dhcli: Run, words: tuple[str, ...], said: str) -> None:
    """And why."""
    done = dhcli("ik", *words)
    assert (done.code, done.out) == (2, "")
    assert said in done.err


def test_errors_are_json_too_when_json_is_asked_for(dhcli: Run) -> None:
    """One envelope."""
    done = dhcli("ik", "puma560", "--format", "json")
    assert json.loads(done.out)["ok"] is False


@pytest.mark.parametrize(
    ("words", "line", "target"),
    [
        (("--position", "500mm,0.3,0"), "position 0.5, 0.3, 0 m", {"position": [0.5, 0.3, 0.0]}),
        (("--pointing", "0,0,2"), "z 0, 0, 1", {"z": [0.0, 0.0, 1.0]}),
        (
            ("--target", "Trans(0,0.7,0) Rot(z,90°)"),
            "position 0, 0.7, 0 m · rpy 0°, 0°, 90°",
            {"position": [0.0, 0.7, 0.0], "rotation": [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]},
        ),
    ],
)
def test_the_target_is_repeated_as_it_was_read(
    dhcli: Run, words: tuple[str, ...], line: str, target: dict[str, list[float]]
) -> None:
    """What of it counts, in text and in JSON: a unit or a sign that was lost is seen."""
    assert f"\n{line}\n" in dhcli("ik", "planar-2r", *words).out
    data = dhcli("ik", "planar-2r", *words, "--format", "json").data
    assert data["target"] == target


@pytest.mark.parametrize(("position", "is_asked"), [("500,300,0", True), ("5,3,0", False), ("1e6,0,0", False)])
def test_a_point_in_millimetres_is_recognised_by_its_distance(dhcli: Run, position: str, is_asked: bool) -> None:
    """Nobody can mean so many metres; nobody means so many millimetres either."""
    done = dhcli("ik", "planar-2r", "--position", position)
    assert done.code == 1
    assert ("did you mean mm?" in done.out) is is_asked


@pytest.mark.parametrize("columns", [80, 40])
def test_no_line_is_wider_than_a_terminal_and_no_word_is_broken(tmp_path: Path, columns: int) -> None:
    """Words go below the numbers, and at last each number gets its name."""
    with Terminal(tmp_path, "ik", "puma560", "--pose", "ready", columns=columns, own_process=True) as screen:
        assert screen.end() == 0
    page = screen.seen.replace("\r", "")
    assert all(len(line) <= columns for line in page.splitlines())
    assert "shoulder right, elbow down, wrist flip" in " ".join(page.split())
    assert ("theta2 = -92.6931°" in page) is (columns == 40)


def test_of_all_ways_to_stand_nearest_the_plainest_is_offered() -> None:
    """Inside the limits, and near to the joint values asked for."""
    robot = load_robot("puma560")
    pose = np.array(forward(robot, "nominal").matrix)
    pose[0, 3] = 3
    found = [inverse(robot, pose, near=near).closest for near in (None, [0, 0, -1.5, 1.9, 0, -1.9])]
    plain, other = (np.asarray(q) for q in found)
    assert np.abs(plain[0]) < math.pi / 2, "the way back over the shoulder is out of theta1's limits"
    assert plain[3] < 0 < other[3], "the wrist flipped"
    assert np.allclose(forward(robot, list(plain)).matrix, forward(robot, list(other)).matrix, atol=1e-6)


def test_a_pose_whose_axes_are_told_in_words_is_no_position(dhcli: Run) -> None:
    """Three of them, with commas between, under the matrix that is meant."""
    printed = dhcli("fk", "puma560", "--pose", "zero").out
    assert "x' points along +x, y' points along -y, z' points along -z" in printed
    done = dhcli("ik", "puma560", "-", stdin=printed)
    assert (done.code, done.err) == (0, "")
    assert "8 solutions" in done.out


@pytest.mark.parametrize("typed", ["0.5,0.3,0", "[0.5, 0.3, 0]"])
def test_a_position_for_a_pose_is_recognised(dhcli: Run, typed: str) -> None:
    """It has an option of its own."""
    done = dhcli("ik", "planar-2r", typed)
    assert done.code == 2
    assert f"'{typed}' is a position, and a whole pose is wanted" in done.err
    assert f"write --position {typed.strip('[]').replace(' ', '')}, where the turn is free" in done.err


def test_formulas_asked_for_as_symbols_are_found(dhcli: Run) -> None:
    """Other commands take `--symbolic`."""
    assert "did you mean --derive?" in dhcli("ik", "planar-2r", "--symbolic").err


def test_rows_from_the_keyboard_are_waited_for_aloud(tmp_path: Path) -> None:
    """A command that says nothing seems to hang; Ctrl-D ends what is typed."""
    with Terminal(tmp_path, "ik", "planar-2r", "--rows", "-", own_process=True) as screen:
        screen.until("reading from the keyboard; Ctrl-D on an empty line ends it")
        screen.type("p_x,p_y,p_z\n0.5,0.3,0\n\x04")
        assert screen.end() == 0
    assert "0 rows" not in screen.seen, "a bar would stand between what is typed"
    assert "theta1" in screen.seen


def test_why_tells_the_rule_the_steps_and_the_limits(dhcli: Run) -> None:
    """A line for each joint in the order in which it is found, and for each solution that limits keep out."""
    done = dhcli("ik", "puma560", "--pose", "nominal", "--why", "--format", "json").data
    how = done["how"]
    assert how["rules"] == ["ONE"]
    assert [step.partition(":")[0] for step in how["steps"]] == [f"theta{k}" for k in (3, 2, 1, 4, 5, 6)]
    assert "the point fixed under theta4, theta5, theta6" in how["steps"][0]
    outside = [k + 1 for k, solution in enumerate(done["solutions"]) if not solution["within_limits"]]
    assert [int(line.partition(":")[0]) for line in how["limits"]] == outside == [1, 6, 7]
    page = dhcli("ik", "puma560", "--pose", "nominal", "--why", "--within-limits").out
    assert "left, elbow up, wrist noflip, left out: theta4 would be 180°, its limits are -110° and" in page
    assert "How, by rule ONE" in page
    assert dhcli("ik", "puma560", "--pose", "nominal", "--format", "json").data["how"] is None


def test_the_number_of_solutions_is_told_as_a_product(dhcli: Run) -> None:
    """Where the choices between roots multiply to it; of a part of the solutions they do not."""
    assert "8 solutions = 2 (theta3) × 2 (theta2) × 2 (wrist)" in dhcli("ik", "puma560", "--pose", "nominal").out
    assert dhcli("ik", "puma560", "--pose", "nominal", "--format", "json").data["factors"] == {
        "theta3": 2,
        "theta2": 2,
        "wrist": 2,
    }
    part = dhcli("ik", "puma560", "--pose", "nominal", "--branch", "elbow up").out
    assert "4 solutions\n" in part


@pytest.mark.parametrize(("order", "moves"), [("zyz", "Rot(z,{0}) Rot(y,{1}) Rot(z,{2})"), ("fixed-xyz", "")])
def test_three_turns_say_an_orientation(dhcli: Run, order: str, moves: str) -> None:
    """In any order, about current or fixed axes: the same as in moves, or as rpy."""
    angles = ("10°", "20°", "30°")
    same = ("--target", moves.format(*angles), "--task", "orientation") if moves else ("--rpy", ",".join(angles))
    one = dhcli("ik", "spherical-wrist", "--euler", f"{order} {','.join(angles)}", "--format", "json").data
    other = dhcli("ik", "spherical-wrist", *same, "--format", "json").data
    found, wanted = ([solution["q"] for solution in each["solutions"]] for each in (one, other))
    assert np.allclose(found, wanted, atol=1e-12)
    assert len(found) == 2


def test_the_pose_may_be_the_second_word(dhcli: Run) -> None:
    """As a pipe gives it: `dhcli fk ... --format json | dhcli ik ROBOT -`."""
    told = dhcli("fk", "puma560", "--pose", "nominal", "--format", "json").out
    assert dhcli("ik", "puma560", "-", stdin=told).out == dhcli("ik", "puma560", "--pose", "nominal").out
    done = dhcli("ik", "puma560", "Trans(0.4,0,0)", "--target", "Trans(0.4,0,0)")
    assert (done.code, "two ways" in done.err) == (2, True)


@pytest.mark.parametrize(
    ("euler", "said"),
    [
        ("zzy 1,2,3", "no order zzy"),
        ("zyz 1,2", "three angles are wanted, not 2"),
        ("zyz", "three angles are wanted"),
        ("zyz a,1,2", "a is not a name"),
        ("fixed-zyz 300,0,0", "more than a turn"),
    ],
)
def test_what_is_no_order_or_no_angles_is_refused(dhcli: Run, euler: str, said: str) -> None:
    """With what would be right."""
    done = dhcli("ik", "spherical-wrist", "--euler", euler)
    assert (done.code, said in done.err) == (2, True)


def test_out_of_reach_is_told_by_the_joint_that_has_no_real_value(dhcli: Run) -> None:
    """Too near to the shoulder: the links laid end to end would reach it, the law of cosines would not."""
    done = dhcli("ik", "planar-2r", "--position", "0.05,0,0")
    assert done.code == 1
    assert "theta2 has no real value: a cosine in its equation would be 1.031" in done.out
    cosine = (0.05**2 - 0.4**2 - 0.3**2) / (2 * 0.4 * 0.3)
    assert cosine == pytest.approx(-1.031, abs=5e-4)


def test_a_matrix_that_is_no_rotation_is_told_with_the_nearest_one(dhcli: Run) -> None:
    """And how far away it is; none for a reflection."""
    done = dhcli("ik", "puma560", "--target", "[1 0 0 0.4; 0 1 0 0.2; 0 0.1 1.2 0.1; 0 0 0 1]")
    left, _, right = np.linalg.svd([[1, 0, 0], [0, 1, 0], [0, 0.1, 1.2]])
    nearest = left @ right
    shown = "; ".join(" ".join(f"{round(x, 6) + 0.0:g}" for x in row) for row in nearest)
    assert f"the nearest rotation is {shown}, an entry of it 0.2 away" in done.err
    mirrored = dhcli("ik", "puma560", "--target", "[1 0 0 0.4; 0 1 0 0.2; 0 0 -1 0.1; 0 0 0 1]")
    assert "nearest" not in mirrored.err


@pytest.mark.parametrize("pose", [("--target", "Trans(x,0,0)"), ("--position", "x,0,0")])
def test_letters_in_a_pose_lead_to_the_derivation(dhcli: Run, pose: tuple[str, str]) -> None:
    """Numbers are solved, letters are derived."""
    done = dhcli("ik", "puma560", *pose)
    hint = "a pose to reach is in numbers; --derive gives the formulas in letters"
    assert (done.code, done.err) == (2, f"dhcli: {pose[0]}: x has no value\n  hint: {hint}\n")


def test_a_matrix_of_few_decimals_is_told_to_be_taken_for_the_nearest_rotation(dhcli: Run) -> None:
    """One decimal lets an entry be 0.05 off; one that is a rotation to the last digit needs no word."""
    done = dhcli("ik", "puma560", "--target", "[1 0.1 0 0.4; 0 1 0 0.1; 0 0 1 0.2; 0 0 0 1]")
    left, _, right = np.linalg.svd([[1, 0.1, 0], [0, 1, 0], [0, 0, 1]])
    apart = np.abs(left @ right - [[1, 0.1, 0], [0, 1, 0], [0, 0, 1]]).max()
    said = "a matrix with 1 decimal is a rotation to its digits; the nearest rotation is taken"
    assert (done.code, done.err) == (0, f"dhcli: warning: {said}, an entry of it {apart:.2g} away\n")
    assert dhcli("ik", "puma560", "--target", "[0.6 -0.8 0 0.4; 0.8 0.6 0 0.1; 0 0 1 0.2; 0 0 0 1]").err == ""


def test_the_column_of_distances_ascends_and_is_what_the_joints_have_to_move(dhcli: Run) -> None:
    """Panda's fourth joint has no turn to spare: the short way round is barred to it."""
    done = dhcli("ik", "panda", "--pose", "ready", "--near", "ready")
    head, *rows = [line.split() for line in done.out.splitlines() if line.strip().startswith(("#", *"12345678"))][1:]
    distances = [float(row[head.index("distance")]) for row in rows]
    assert len(distances) == 8
    assert distances == sorted(distances)
    robot = load_robot("panda")
    found = inverse(robot, forward(robot, "ready"), near="ready")
    there = np.asarray([0, -45, 0, -135, 0, 90, 45])
    for row, q, distance in zip(rows, found, distances, strict=True):
        assert [float(cell.rstrip("°")) for cell in row[1:8]] == pytest.approx(np.degrees(q), abs=1e-3)
        assert math.hypot(*np.radians(np.degrees(q) - there)) == pytest.approx(distance, abs=1e-4)


def test_joints_to_spare_are_held_where_an_arm_is_inside_its_limits(dhcli: Run) -> None:
    """Which values these are is said; not so where the user holds them all, or has asked for a family."""
    asked = ("ik", "panda", "--position=-0.3,0,0.5", "--within-limits")
    plain = dhcli(*asked, "--format", "json")
    assert plain.code == 0
    assert all(solution["within_limits"] for solution in plain.data["solutions"])
    assert "with which all joints are inside their limits" in dhcli(*asked).err
    assert dhcli(*asked, *[f"--hold=theta{k}=0" for k in (3, 5, 6, 7)]).code == 1
    assert "more than this needs: theta3, theta5, theta6, theta7 sampled" in dhcli(*asked, "--family", "9").err


def test_where_no_value_of_a_joint_to_spare_keeps_the_limits_that_is_said(dhcli: Run) -> None:
    """Straight above its base the hand of a Panda points up at no value of its last joint."""
    done = dhcli("ik", "panda", "--target", "Trans(0,0,0.9)", "--within-limits")
    assert done.code == 1
    assert "none of 480 values of theta7 has a solution inside all limits" in done.err


def test_noise_is_no_part_of_the_name_of_a_branch(dhcli: Run) -> None:
    """A joint at -45° is called that, without a hundred-thousandth of a millionth of a degree."""
    done = dhcli("ik", "panda", "--pose", "ready", "--hold", "theta1=0", "--within-limits")
    assert "theta2 = -45°" in done.out
    assert "e-" not in done.out


TYPED = """[0.3551 -0.0720 -0.9320 0.4908; 0.9135 -0.1852 0.3624 0.3978; -0.1987 -0.9801 0.0000 0.0000; 0 0 0 1]"""


def test_a_matrix_of_four_decimals_is_reached_by_an_arm_of_few_joints(dhcli: Run) -> None:
    """It comes nearest to it; in a product, in other units and with a power of ten as well."""
    done = dhcli("ik", "zhou-3r", "--target", TYPED)
    assert done.code == 0
    assert "1 solution\n" in done.out
    assert "17.1878°" in done.out
    assert "the arm takes no pose with exactly these digits; the nearest is taken" in done.err
    for other in (f"{TYPED} * Trans(0,0,0)", TYPED.replace("0.4908", "490.8 mm"), TYPED.replace("0.4908", "4.908e-1")):
        assert "the nearest is taken" in dhcli("ik", "zhou-3r", "--target", other).err
    lifted = TYPED.replace("0.0000 0.0000; 0 0", "0.0000 0.0003; 0 0")
    assert dhcli("ik", "zhou-3r", "--target", lifted).code == 1


FIVE = str(Path(__file__).parents[1] / "data" / "five-axis.yaml")


@pytest.mark.parametrize(
    "typed",
    [
        ("--position", "0.7230,0.2236,0.7418", "--rpy", "-2.5584,-0.4120,-0.7253"),
        ("--position", "722.99 mm,223.65 mm,741.79 mm", "--rpy", "-146.58°,-23.61°,-41.56°"),
        ("--position", "0.7230,0.2236,0.7418", "--quaternion", "0.1936,-0.8974,0.2776,-0.2830"),
        ("--position", "0.7230,0.2236,0.7418", "--euler", "zyx -0.7253,-0.4120,-2.5584"),
        ("--position", "0.7230,0.2236,0.7418", "--pointing", "0.6154,0.1904,-0.7648"),
        ("--position", "0.723,0.224,0.742", "--rpy", "-2.558,-0.412,-0.725"),
        ("--position", "0.723,0.224,0.742", "--euler", "zyx -0.725, -0.412, -2.558"),
        ("--target", "Trans(0.723,0.224,0.742) Rot(z,-0.725 rad) Rot(y,-0.412 rad) Rot(x,-2.558 rad)"),
        ("--target", "Trans(0.7230,0.2236,0.7418) Rot(z,-41.56°) Rot(y,-23.61°) Rot(x,-146.58°)"),
    ],
)
def test_few_digits_leave_a_pose_open_in_whatever_way_it_is_given(dhcli: Run, typed: tuple[str, ...]) -> None:
    """The hand of a five-axis arm at theta = 0.3, 0.8, -0.6, 0.5, 0.9, rounded."""
    done = dhcli("ik", FIVE, *typed, "--format", "json")
    assert done.code == 0
    assert "the arm takes no pose with exactly these digits; the nearest is taken" in done.err
    rows = [solution["q"] for solution in done.data["solutions"]]
    assert min(max(abs(a - b) for a, b in zip(row[:4], (0.3, 0.8, -0.6, 0.5), strict=True)) for row in rows) < 2e-3


@pytest.mark.parametrize("height", ["0.2", "0.01", "0.001", "0.0005"])
def test_few_decimals_of_lengths_beside_a_plain_rotation_are_exact(dhcli: Run, height: str) -> None:
    """Nobody rounds 0.5; the hand of the planar arm stays where it is."""
    done = dhcli("ik", "planar-2r", "--task", "pose", "--target", f"[0 -1 0 0.4; 1 0 0 0.3; 0 0 1 {height}; 0 0 0 1]")
    assert done.code == 1
    assert f"z must be 0 m, is {height} m" in done.out
