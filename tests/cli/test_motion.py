"""`dhcli jacobian`, `singularities`, `rates` and `torques`: what each option shows, and what is refused."""

from __future__ import annotations

import json
import math
from pathlib import Path

import numpy as np
import pytest

from dhcli import jacobian, load_robot, torques
from tests.cli.running import Run
from tests.nightly import NIGHT
from tests.row_by_row import row_by_row


def test_the_jacobian_of_the_book_is_shown_with_what_it_is(dhcli: Run) -> None:
    """Heading with both frames; rows, units, point and axes; then the matrix with its names."""
    done = dhcli("jacobian", "planar-2r", "--symbolic")
    assert (done.code, done.err) == (0, "")
    assert done.out == (
        "Jacobian of planar-2r: frame 2 against frame 0\n"
        "rows v of the origin of frame 2 in m/s above ω in rad/s, along the axes of frame 0 · per rad/s\n"
        "s1 = sin(theta1) · s12 = sin(theta1+theta2)\n"
        "columns theta1, theta2\n"
        "v_x ⎡ -a1*s1 - a2*s12  -a2*s12 ⎤\n"
        "v_y ⎢  a1*c1 + a2*c12   a2*c12 ⎥\n"
        "v_z ⎢        0            0    ⎥\n"
        "ω_x ⎢        0            0    ⎥\n"
        "ω_y ⎢        0            0    ⎥\n"
        "ω_z ⎣        1            1    ⎦\n"
    )


def test_rates_of_angles_say_where_they_are_none(dhcli: Run) -> None:
    """And which angles stand in the formulas."""
    out = dhcli("jacobian", "articulated", "-s", "--analytic", "rpy", "--part", "angular").out
    assert out.endswith("det B = cos(pitch)\nno rates where pitch is ±90°\n")


def test_a_long_result_names_the_frame_in_which_it_is_short(dhcli: Run) -> None:
    """One entry a line, and a hint."""
    lines = dhcli("jacobian", "puma560", "-s").out.splitlines()
    assert lines[-1] == "75 operations here, 13 in frame 3: --in 3"
    assert "v_x = -s1*(a2*c2 + a3*c23 - d4*s23) - d3*c1" in lines


@pytest.mark.parametrize(
    ("words", "keywords"),
    [
        ("", {}),
        ("--in 3", {"axes": 3}),
        ("--from 1 --to 5", {"start": 1, "end": 5}),
        ("--point 0.1,0,20mm", {"point": (0.1, 0, 0.02)}),
        ("--part linear", {"part": "linear"}),
        ("--order angular-first", {"angular_first": True}),
        ("--analytic rpy", {"analytic": "rpy"}),
        ("--analytic zyz --part angular", {"analytic": "zyz", "part": "angular"}),
        ("--space", {"place": 0, "angular_first": True}),
        ("--body", {"axes": 6, "angular_first": True}),
        ("--set a2=0.5", {"parameters": {"a2": 0.5}}),
    ],
)
def test_json_holds_what_the_library_gives(dhcli: Run, words: str, keywords: dict[str, object]) -> None:
    """Every option, in full precision."""
    q = "10°,-45°,20°,30°,40°,5°"
    found = dhcli("jacobian", "puma560", "--q", q, *words.split(), "--format", "json").data
    expected = jacobian(load_robot("puma560"), q, **keywords)  # type: ignore[arg-type]
    assert np.array(found["matrix"]) == pytest.approx(expected, abs=1e-15)
    assert len(found["rows"]) == len(expected)


def test_the_jacobian_has_exactly_these_keys(dhcli: Run) -> None:
    """A new key is a decision, and stands here."""
    data = dhcli("jacobian", "scara", "-s", "--let", "--format", "json").data
    keys = {"robot", "values", "symbolic", "frame", "from", "to", "point", "rows", "joints", "matrix"}
    assert set(data) - {"definitions"} == keys
    assert (data["frame"], data["from"], data["to"]) == ("0", "0", "3")
    assert data["point"] == {"frame": "3", "at": [0.0, 0.0, 0.0]}
    assert data["rows"] == ["v_x", "v_y", "v_z", "ω_x", "ω_y", "ω_z"]
    assert data["joints"] == ["theta1", "theta2", "d3"]


@pytest.mark.parametrize(
    ("format_", "beginning"),
    [
        ("latex", "\\begin{bmatrix}"),
        ("matlab", "% Jacobian of planar-2r: frame 2 against frame 0; rows v of"),
        ("numpy", "# Jacobian of planar-2r"),
        ("sympy", "Matrix([["),
        ("csv", "row,theta1,theta2\nv_x,"),
    ],
)
def test_a_jacobian_comes_in_every_format(dhcli: Run, format_: str, beginning: str) -> None:
    """For papers and programs."""
    assert dhcli("jacobian", "planar-2r", "-s", "--format", format_).out.startswith(beginning)


def test_numbers_for_programs_run(dhcli: Run) -> None:
    """The file holds the matrix of the library."""
    assert dhcli("jacobian", "ur5e", "--q", "0,-90,90,0,45,0", "--deg", "-o", "j.py").code == 0
    names: dict[str, object] = {}
    exec(Path("j.py").read_text(encoding="utf-8"), names)  # noqa: S102  our own file, as a user would run it
    assert names["J"] == pytest.approx(jacobian(load_robot("ur5e"), "0, -90°, 90°, 0, 45°, 0"))


def test_rows_give_a_jacobian_each(dhcli: Run) -> None:
    """As CSV with names, as nested lists, as an array; a bad one is told or left out."""
    Path("q.csv").write_text("theta1,theta2\n0.1,0.2\n0.3,0.4\n", encoding="utf-8")
    expected = jacobian(load_robot("planar-2r"), [[0.1, 0.2], [0.3, 0.4]], part="linear")
    words = ("jacobian", "planar-2r", "--rows", "q.csv", "--part", "linear")
    lines = dhcli(*words).out.splitlines()
    assert lines[0] == "v_x_theta1,v_x_theta2,v_y_theta1,v_y_theta2,v_z_theta1,v_z_theta2"
    assert [float(cell) for cell in lines[2].split(",")] == pytest.approx(expected[1].ravel())
    nested = [json.loads(line)["matrix"] for line in dhcli(*words, "--format", "jsonl").out.splitlines()]
    assert np.array(nested) == pytest.approx(expected)
    assert dhcli(*words, "-o", "j.npy").code == 0
    assert np.load("j.npy") == pytest.approx(expected)
    np.save("many.npy", np.random.default_rng(4).uniform(-3, 3, (20_000, 2)))
    for jobs in ("1", "3"):
        assert dhcli("jacobian", "planar-2r", "--rows", "many.npy", "-o", f"{jobs}.npy", "--jobs", jobs).code == 0
    assert Path("1.npy").read_bytes() == Path("3.npy").read_bytes()
    assert "name their file with --rows FILE" in dhcli("jacobian", "planar-2r", "--jobs", "2", "--symbolic").err
    assert dhcli(*words, "--index").out.splitlines()[1].startswith("2,")
    Path("bad.csv").write_text("0.1,0.2\n0.3,nan\n", encoding="utf-8")
    assert dhcli("jacobian", "planar-2r", "--rows", "bad.csv").code == 2
    left = dhcli("jacobian", "planar-2r", "--rows", "bad.csv", "--skip-bad")
    assert (left.code, len(left.out.splitlines())) == (0, 2)


def test_a_row_without_rates_of_angles_is_told(dhcli: Run) -> None:
    """Pitch 90° in the second row."""
    Path("q.csv").write_text("0.1,0.2,0.3\n0,90,0\n", encoding="utf-8")
    done = dhcli("jacobian", "articulated", "--rows", "q.csv", "--deg", "--analytic", "rpy")
    assert done.code == 2
    assert "q.csv:2: the Jacobian has an entry that is not a real number" in done.err


def test_singularities_show_the_determinant_and_what_each_factor_means(dhcli: Run) -> None:
    """Factor, configuration, lost motion."""
    done = dhcli("singularities", "puma560")
    assert (done.code, done.err) == (0, "")
    assert "det J = -a2*s5*(a2*c2 + a3*c23 - d4*s23)*(a3*s3 + d4*c3)\n" in done.out
    assert (
        "s5 = 0  (theta5 is 0 or 180°)\n"
        "    axes 4 and 6 fall in line\n"
        "    lost: turning about the perpendicular to axes 4 and 5, with the wrist centre at rest\n"
    ) in done.out


def test_singularities_at_joint_values_say_how_far_they_are(dhcli: Run) -> None:
    """Rank, singular values, manipulability; the nearest factor first."""
    out = dhcli("singularities", "articulated", "--q", "30,60,-75", "--deg").out
    assert "here: rank 3 (full); singular values 0.6044, 0.4898, 0.1918\n" in out
    assert "s3 = 0: -0.9659 here, 1.309 rad (75.0°) away\n" in out
    stretched = dhcli("singularities", "articulated", "--q", "30,60,0", "--deg").out
    assert "here: rank 2: 1 less than elsewhere" in stretched
    assert "condition without bound" in stretched


def test_singularities_have_exactly_these_keys(dhcli: Run) -> None:
    """Without joint values, and with."""
    data = dhcli("singularities", "stanford", "--format", "json").data
    keys = {"robot", "values", "from", "to", "point", "part", "rows", "joints", "finding", "rank", "still", "place"}
    assert set(data) == keys | {"determinant", "factors", "probed"}
    assert data["determinant"] == "d3**2*sin(theta2)*sin(theta5)"
    assert {frozenset(factor) for factor in data["factors"]} == {
        frozenset(("text", "zeros", "exponent", "joints", "angles", "words", "dependent", "lost"))
    }
    assert {factor["text"]: factor["joints"] for factor in data["factors"]}["d3 = 0"] == ["d3"]
    there = dhcli("singularities", "stanford", "--pose", "level", "--format", "json").data["at"]
    assert set(there) == {"rank", "singular_values", "manipulability", "condition", "determinant", "factors"}
    assert (there["rank"], there["condition"]) == (5, None)
    assert set(there["factors"][0]) == {"factor", "values", "distance"}


def test_a_stretched_arm_is_as_far_from_its_singular_pose_as_its_joints_have_to_move(dhcli: Run) -> None:
    """Level, no joint changes the distance from axis 1 at first; a grid of both joints finds no shorter way."""
    words = ("singularities", "articulated", "--q", "0,0,0")
    two, three = np.meshgrid(np.linspace(-2, 2, 1001), np.linspace(-2, 2, 1001))
    there = 0.4 * np.cos(two) + 0.3 * np.cos(two + three) <= 0
    least = np.hypot(two, three)[there].min()
    factors = dhcli(*words, "--format", "json").data["at"]["factors"]
    assert [one["distance"] for one in factors] == [0.0, pytest.approx(least, abs=3e-3)]
    assert f"a2*c2 + a3*c23 = 0: 0.7 here, {factors[1]['distance']:.4g} rad" in dhcli(*words).out


def test_a_factor_that_no_joint_makes_zero_has_no_distance(dhcli: Run, tmp_path: Path) -> None:
    """The lower arm is too short to bring the end back to axis 1; JSON has no infinity."""
    robot = tmp_path / "long.yaml"
    robot.write_text(
        "format: 1\ntitle: Long shoulder\nsource: made for a test\nconvention: standard\n"
        "variables: [t1, t2]\nparameters: {a1: 0.5, a2: 0.3}\n"
        "links:\n  - {alpha: 90°, a: a1, d: 0, theta: t1}\n  - {alpha: 0, a: a2, d: 0, theta: t2}\n"
    )
    words = ("singularities", str(robot), "--q", "0.2,0.3")
    done = dhcli(*words, "--format", "json").data
    assert [one["distance"] for one in done["at"]["factors"] if one["values"][0] > 0.5] == [None]
    assert "out of reach from here" in dhcli(*words).out


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        ("puma560 --part linear --to 4", "rank 3, and less where one of these holds"),
        ("zhou-3r", "singular everywhere: theta3 does not move the origin of frame 3; rank 2 of 3"),
        ("zhou-3r --point 0.1,0,0", "det J = "),
        ("cartesian", "rank 3 at all joint values: singular nowhere"),
        ("panda", "one or two at a time:\nless than 6 at theta2 = 0°, theta4 = 0°"),
        ("puma560 --set a3=0 --style full", "d4*cos(theta3)"),
        ("planar-2r --format latex", r"\det J = a_{1} a_{2} s_{2}"),
        ("planar-2r --format sympy", "a1*a2*sin(theta2)"),
        ("planar-2r --format csv", "zero,exponent,angles,words,lost\nsin(theta2),1,theta2 is 0 or 180°,"),
    ],
)
def test_every_finding_is_said(dhcli: Run, words: str, expected: str) -> None:
    """In whatever format."""
    assert expected in dhcli("singularities", *words.split()).out


def test_torques_have_units_and_say_where_the_force_acts(dhcli: Run) -> None:
    """By hand: 10 N at a lever of 0.3464 m."""
    out = dhcli("torques", "planar-2r", "--q", "30,60", "--deg", "--force", "0,10,0").out
    assert "force (0, 10, 0) N and moment (0, 0, 0) N m at the origin of frame 2" in out
    assert out.endswith("tau_theta1 = 3.4641 N m\ntau_theta2 = 0      N m\n")


@pytest.mark.parametrize("moment", ["5", "5Nm", "5 N m", "5N*m", "5N·m", "500Ncm", "5000 N mm", "5000N*mm", "0.005kNm"])
def test_a_moment_may_have_any_unit_of_moments(dhcli: Run, moment: str) -> None:
    """Five newton metres about z."""
    done = dhcli("torques", "planar-2r", "--pose", "zero", "--moment", f"0,0,{moment}")
    assert "tau_theta1 = 5 N m\n" in done.out


def test_torques_in_letters_are_those_of_the_book(dhcli: Run) -> None:
    """Jᵀ F."""
    out = dhcli("torques", "planar-2r", "-s", "--force", "f_x,f_y,0").out
    assert "tau_theta1 = -f_x*(a1*s1 + a2*s12) + f_y*(a1*c1 + a2*c12) N m\n" in out


@pytest.mark.parametrize(
    ("words", "keywords"),
    [
        ("--in 6", {"axes": 6}),
        ("--at 0.1,0,0", {"point": (0.1, 0, 0)}),
        ("--at 4", {"place": 4}),
        ("--from base --to tool", {"start": "base", "end": "tool"}),
    ],
)
def test_a_force_acts_in_any_frame_at_any_point(dhcli: Run, words: str, keywords: dict[str, object]) -> None:
    """As the library has it; kilonewtons and newton millimetres are read."""
    typed = ("--force", "0,0,-0.01kN", "--moment", "0,0,2000 N mm")
    data = dhcli("torques", "puma560", "--pose", "nominal", *typed, *words.split(), "--format", "json").data
    expected = torques(load_robot("puma560"), "nominal", (0, 0, -10), (0, 0, 2), **keywords)  # type: ignore[arg-type]
    assert data["torques"] == pytest.approx(expected)
    assert data["units"] == ["N*m"] * 6
    assert set(data) >= {"robot", "values", "frame", "from", "to", "point", "force", "moment", "joints"}


def test_rates_go_both_ways(dhcli: Run) -> None:
    """A velocity gives rates, and these the velocity."""
    words = ("rates", "puma560", "--pose", "nominal", "--format", "json")
    data = dhcli(*words, "--velocity", "0.1,0,0", "--angular", "0,0,30deg/s").data
    assert data["solved"]["reached"] is True
    back = dhcli(*words, "--rates", ",".join(map(repr, data["rates"]))).data
    assert back["velocity"] == pytest.approx([0.1, 0, 0, 0, 0, math.radians(30)])
    assert set(back) == {"robot", "values", "frame", "from", "to", "point", "joints", "rates", "rows", "velocity"}
    assert set(data["solved"]) == {"wanted", "reached", "rank", "damping", "idle"}


def test_a_singular_pose_has_no_infinite_rates(dhcli: Run) -> None:
    """It is said, and the exit code is that of work that was done."""
    done = dhcli("rates", "planar-2r", "--q", "0,0", "--velocity", "0.1,0,0")
    assert done.code == 0
    assert "the arm is singular here (rank 1 of 2)" in done.err
    assert "inf" not in done.out
    damped = dhcli("rates", "planar-2r", "--q", "0,0.01", "--velocity", "0.1,0,0", "--damped", "0.05")
    assert "damped by 0.05" in damped.err


def test_the_self_motion_of_a_redundant_arm_is_shown(dhcli: Run) -> None:
    """Below the velocity."""
    out = dhcli("rates", "panda", "--pose", "ready", "--velocity", "0.1,0,0", "--angular", "0,0,0").out
    assert "moves nothing of it, at any speed: 0.7213 theta1', -0.4665 theta3'" in out


def test_velocities_in_letters_name_the_rates(dhcli: Run) -> None:
    """J q'."""
    out = dhcli("rates", "planar-2r", "--symbolic").out
    assert "v_x = -dtheta1*(a1*s1 + a2*s12) - a2*dtheta2*s12 m/s\n" in out
    assert "ω_z = dtheta1 + dtheta2 rad/s\n" in out


def test_joint_rates_for_a_velocity_come_in_letters(dhcli: Run) -> None:
    """Over the determinant in factors, along any axes; not where there are more joints, nor for what none can give."""
    out = dhcli("rates", "planar-2r", "--symbolic", "--velocity", "v_x,v_y,0", "--in", "2").out
    assert out.startswith("Joint rates of planar-2r")
    assert "theta1' = v_x/(a1*s2) rad/s\n" in out
    out = dhcli("rates", "articulated", "--symbolic", "--velocity", "v_x,0,0", "--in", "1").out
    assert "theta3' = -v_x*(a2*c2 + a3*c23)/(a2*a3*s3) rad/s\n" in out
    done = dhcli("rates", "planar-2r", "--symbolic", "--velocity", "1,0,1")
    assert (done.code, "no joint gives v_z" in done.err) == (2, True)
    done = dhcli("rates", "puma560", "--symbolic", "--velocity", "1,0,0")
    assert (done.code, "in letters as many joints as rows" in done.err) == (2, True)


@pytest.mark.parametrize("command", ["torques", "rates"])
@pytest.mark.parametrize("format_", ["latex", "matlab", "numpy", "sympy", "csv"])
def test_torques_and_rates_come_in_every_format(dhcli: Run, command: str, format_: str) -> None:
    """In numbers and in symbols."""
    asked = ("--force", "0,10,0") if command == "torques" else ("--rates", "1,2")
    for words in (("--q", "0.3,0.5"), ("--symbolic",)):
        done = dhcli(command, "planar-2r", *words, *asked, "--format", format_)
        assert (done.code, done.err) == (0, "")
        assert len(done.out) > 10


@row_by_row(
    ("words", "message"),
    [
        ("jacobian scara", "no value for theta1, theta2, d3"),
        ("jacobian assembly-blocks", "has no joint"),
        ("jacobian planar-2r --q 0,0 --point x,0,0", "x of the point has no value"),
        ("jacobian planar-2r --q 0,0 --point 0,0", "a point has three coordinates"),
        ("jacobian articulated --q 0,90,0 --deg --analytic rpy", "pitch is ±90°, where there are no rates of rpy"),
        ("jacobian articulated --pose zero --analytic abc", "there are no angles called abc"),
        ("jacobian articulated --pose zero --analytic rpy --in 1", "in no other axes"),
        ("jacobian articulated --pose zero --analytic rpy --part linear", "--part linear leaves them out"),
        ("jacobian articulated --pose zero --part top", "there is no part top"),
        ("jacobian articulated --pose zero --order down", "there is no order down"),
        ("jacobian articulated --pose zero --space --body", "two different Jacobians"),
        ("jacobian articulated --pose zero --body --in 1 --point 0,0,1", "--in and --point do not go with --body"),
        ("jacobian articulated --pose zero --let", "add --symbolic"),
        ("jacobian articulated --pose zero --in 9", "has no frame 9"),
        ("jacobian articulated --pose zero --from 2 --to 2", "no joint of articulated moves frame 2"),
        ("jacobian articulated --skip-bad", "name their file with --rows FILE"),
        ("jacobian - --rows -", "cannot both come from standard input"),
        ("jacobian articulated --rows q.csv -s", "--symbolic does not go with --rows"),
        ("jacobian articulated --rows q.csv", "there is no such file"),
        ("jacobian planar-four-bar -s", "is the name of a linkage"),
        ("singularities planar-four-bar", "is the name of a linkage"),
        ("rates bennett --velocity 1,0,0", "is the name of a linkage"),
        ("torques bennett --force 1,0,0", "is the name of a linkage"),
        ("rates assembly-blocks -s", "has no joint"),
        ("torques assembly-blocks -s --force 1,0,0", "has no joint"),
        ("rates dh-link -s --velocity x,y,0", "1 joint for 2 rows that can move"),
        ("singularities assembly-blocks", "has no joint"),
        ("singularities articulated --part up", "there is no part up"),
        ("singularities articulated --q 0,0", "3 joints"),
        ("torques planar-2r --pose zero", "torques of what?"),
        ("jacobian planar-2r --in q.csv", "rows of a file: dhcli jacobian planar-2r --rows q.csv"),
        (
            "torques planar-2r --pose zero --force 1,0,0 --in q.csv",
            "a Jacobian for each of the rows of a file: dhcli jacobian planar-2r --rows",
        ),
        ("rates planar-2r --pose zero --in q.csv --rates 1,1", "one pose is taken: --q VALUES"),
        ("torques planar-2r --pose zero --force 0,1", "three numbers are wanted"),
        ("torques planar-2r --pose zero --force 1,0,0,0,0,3Nm", "write --force 1,0,0 --moment 0,0,3Nm"),
        ("rates planar-2r --pose zero --velocity 1,0,0,0,0,3", "write --velocity 1,0,0 --angular 0,0,3"),
        ("torques planar-2r --pose zero --force 0,0,3Nm", "3Nm is in N m, and N is wanted"),
        ("torques planar-2r --pose zero --force 0,0,3kg", "3kg is in kg, and N is wanted"),
        ("rates planar-2r --pose zero --velocity 0,0,3km/h", "3km/h is in km/h, and m/s is wanted"),
        ("torques planar-2r --pose zero --moment 0,0,3mm", "3mm is in mm, and N m is wanted"),
        ("torques planar-2r --pose zero --moment 0,0,3N", "3N is in N, and N m is wanted"),
        ("torques planar-2r --pose zero --force f,0,0", "f of the force or moment has no value"),
        ("torques planar-2r --pose zero --force 0,0,1 --at 9", "has no frame 9"),
        ("torques planar-2r --pose zero --force 0,0,1 --overwrite", "--overwrite needs a file"),
        ("rates planar-2r --pose zero", "rates of the joints, or a velocity"),
        ("rates planar-2r --pose zero --rates 1,2,3", "3 rates for 2 joints"),
        ("rates planar-2r --pose zero --rates 1m/s,2", "1m/s is in m/s, and rad/s is wanted"),
        ("rates planar-2r --pose zero --velocity nan,0,0", "nan is no number"),
        ("rates planar-2r --pose zero --velocity 1,0,0 --rates 1,2", "--rates does not go with a velocity"),
        ("rates planar-2r --damped 0.1 --velocity 1,0,0 -s", "--symbolic does not go with --damped"),
        ("rates planar-2r --pose zero --rates 1,2 --damped 0.1", "--damped is about joint rates for a velocity"),
        ("rates planar-2r --pose zero --velocity 1,0,0 --damped nan", "damping is 0 or a positive number"),
        ("rates planar-2r --pose zero --velocity 1,0,0 --damped -1", "damping is 0 or a positive number"),
    ],
)
def test_what_cannot_be_is_refused(dhcli: Run, words: str, message: str) -> None:
    """Exit code 2, a sentence, nothing on stdout, and never a traceback."""
    done = dhcli(*words.split())
    assert (done.code, done.out) == (2, "")
    assert message in done.err
    assert "Traceback" not in done.err


def long_arm(joints: int) -> str:
    """The file of an arm without parallel axes."""
    names = ", ".join(f"theta{k}" for k in range(1, joints + 1))
    rows = (f"  - {{a: a, alpha: {90 - 180 * (k % 2)}°, d: 0, theta: theta{k}}}" for k in range(1, joints + 1))
    head = (
        f"format: 1\ntitle: Long\nsource: own\nconvention: standard\nvariables: [{names}]\nparameters: {{a: 0.1 m}}\n"
    )
    return "\n".join((head + "links:", *rows, ""))


@pytest.mark.parametrize(
    "words",
    [
        "jacobian long.yaml -s",
        "jacobian long.yaml -s --analytic rpy",
        "torques long.yaml -s --force 1,0,0",
        "rates long.yaml -s",
        "rates long.yaml -s --velocity x,0,0",
    ],
)
def test_fifty_joints_are_too_many_for_letters(dhcli: Run, words: str) -> None:
    """Said before the work is done."""
    Path("long.yaml").write_text(long_arm(50), "utf-8")
    done = dhcli(*words.split())
    assert (done.code, done.out) == (2, "")
    assert "symbols long, more than the 20000 that are written" in done.err


def test_many_joints_in_numbers_are_like_any(dhcli: Run) -> None:
    """A column each, of fifty or by day of twenty; and no list of singular poses."""
    count = 50 if NIGHT else 20
    Path("long.yaml").write_text(long_arm(count), "utf-8")
    q = ",".join(["0.1"] * count)
    found = json.loads(dhcli("jacobian", "long.yaml", "--q", q, "--format", "json").out)["data"]["matrix"]
    assert [len(row) for row in found] == [count] * 6
    assert dhcli("rates", "long.yaml", "--q", q, "--velocity", "0.1,0,0").code == 0
    told = "no list of conditions that anybody would read; of more than 9 joints none is looked for; --q shows"
    assert told in dhcli("singularities", "long.yaml").out
    Path("long.yaml").write_text(long_arm(8).replace("90°", "20°"), "utf-8")
    told = "no list of conditions that anybody would read; one or two joints at right angles do not lower it; --q shows"
    assert told in dhcli("singularities", "long.yaml").out


def test_one_joint_moves_along_a_circle(dhcli: Run) -> None:
    """By hand: a at right angles to the arm."""
    Path("one.yaml").write_text(long_arm(1), "utf-8")
    found = json.loads(dhcli("jacobian", "one.yaml", "-s", "--format", "json").out)["data"]["matrix"]
    assert [row[0] for row in found] == ["-a*sin(theta1)", "a*cos(theta1)", "0", "0", "0", "1"]
    assert "singular nowhere" in dhcli("singularities", "one.yaml").out
    assert "1 joint cannot make every velocity" in dhcli("rates", "one.yaml", "--q", "0", "--velocity", "1,0,0").err


def test_a_file_of_torques_is_overwritten_when_told(dhcli: Run) -> None:
    """By the word that all commands have for it: `--force` is what the end exerts."""
    words = ("torques", "planar-2r", "--q", "0,0", "--force", "0,1,0", "-o", "t.csv")
    assert dhcli(*words).code == 0
    again = dhcli(*words)
    assert again.code == 2
    assert "--overwrite overwrites it" in again.err
    assert dhcli(*words, "--overwrite").code == 0


def test_dof_says_what_the_end_frame_has_lost(dhcli: Run) -> None:
    """At joint values of a robot: how many freedoms, and why."""
    out = dhcli("dof", "puma560", "--q", "10,20,30,40,0,60", "--deg").out
    assert "  5 freedoms in v_x, v_y, v_z, ω_x, ω_y, ω_z: 1 of 6 lost\n" in out
    assert "  s5 = 0: axes 4 and 6 fall in line\n" in out
    assert (
        "6 freedoms in v_x, v_y, v_z, ω_x, ω_y, ω_z: none is lost" in dhcli("dof", "puma560", "--pose", "nominal").out
    )
    end = dhcli("dof", "puma560", "--pose", "stretch", "--format", "json").data["end"]
    assert set(end) == {"values", "rows", "freedoms", "lost", "reasons"}
    assert (end["freedoms"], end["lost"]) == (5, 1)
    assert {frozenset(reason) for reason in end["reasons"]} == {frozenset(("text", "words", "lost"))}


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ("dof bennett --q 0", "is the name of a linkage"),
        ("dof 6R --pose zero", "there is no robot"),
        ("dof --planar --links 4 --joints 4R --q 0", "joint values are those of a robot"),
        ("dof puma560 --q 0", "6 joints"),
    ],
)
def test_dof_at_joint_values_is_for_robots(dhcli: Run, words: str, message: str) -> None:
    """A linkage has no end frame."""
    done = dhcli(*words.split())
    assert (done.code, done.out) == (2, "")
    assert message in done.err


def test_what_is_to_be_typed_next_leads_to_the_same_robot(dhcli: Run, tmp_path: Path) -> None:
    """By its name where that is found, else by its path, in quotes if need be."""
    for path, typed in (
        ("robots/mine.yaml", "mine"),
        ("arms/my arm.yaml", "'arms/my arm.yaml'"),
        ("robots/scara.yaml", "scara"),
        ("arms/scara.yaml", "arms/scara.yaml"),
    ):
        (tmp_path / path).parent.mkdir(exist_ok=True)
        load_robot("builtin:planar-2r").save(tmp_path / path)
        done = dhcli("jacobian", path, "--in", "q.csv", "--q", "0,0")
        assert f"hint: rows of a file: dhcli jacobian {typed} --rows q.csv" in done.err
        done = dhcli("dof", path, "--q", "0,0")
        assert done.out.endswith(f"where else it loses freedoms: dhcli singularities {typed}\n")
    assert "dhcli jacobian puma560 --rows" in dhcli("jacobian", "puma560", "--in", "q.csv").err
