"""`--code`: functions by the command line."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from dhcli import forward, jacobian, load_robot
from tests.cli.running import Run
from tests.render.code.running import namespace
from tests.row_by_row import row_by_row


def test_a_function_is_written_to_a_file_and_runs(dhcli: Run, tmp_path: Path) -> None:
    """With another length put in, and the tool behind the last frame."""
    done = dhcli("fk", "scara", "--code", "python", "--set", "l1=0.5", "--tool", "Trans(0,0,0.1)", "-o", "fk.py")
    assert (done.code, done.out) == (0, "")
    found = namespace((tmp_path / "fk.py").read_text("utf-8"))["forward"](0.3, 0.5, 0.1)
    robot = load_robot("scara").copy(tool="Trans(0,0,0.1)", parameters={"l1": 0.5})
    assert np.allclose(found, forward(robot, [0.3, 0.5, 0.1], end="tool").matrix, rtol=0, atol=1e-15)


def test_the_jacobian_is_a_function_too(dhcli: Run) -> None:
    """The body Jacobian, with the robot's lengths in it."""
    text = dhcli("jacobian", "scara", "--body", "--code", "python", "--with-values").out
    assert "def jacobian(theta1, theta2, d3):" in text
    robot = load_robot("scara")
    wanted = jacobian(robot, [0.3, 0.5, 0.1], axes=3, angular_first=True)
    assert np.allclose(namespace(text)["jacobian"](0.3, 0.5, 0.1), wanted, rtol=0, atol=1e-15)


def test_a_function_says_what_it_is(dhcli: Run) -> None:
    """Frames, convention, units, joints, and where the numbers are from."""
    said = dhcli("fk", "stanford", "--code", "c").out.partition("void")[0]
    for text in (
        "T_06 of stanford: frame 6 seen from frame 0",
        "standard DH",
        "radians and metres",
        "d3 [m]",
        "Source: ",
    ):
        assert text in said
    assert "Of this robot: d2 = 0.154, d6 = 0.263." in said


def test_json_has_the_formulas(dhcli: Run) -> None:
    """For a language that is not among them."""
    data = dhcli("fk", "planar-2r", "--code", "c", "--format", "json").data
    assert data["joints"] == ["theta1", "theta2"]
    assert data["lengths"] == {"a1": 0.4, "a2": 0.3}
    assert data["rows"][0] == ["c12", "-s12", "0", "a1*c1 + a2*c12"]
    assert (data["operations"], data["cosines_and_sines"]) == (7, 4)


def test_a_way_back_takes_the_lengths_that_are_not_put_in(dhcli: Run) -> None:
    """Those typed stand as numbers, also in what a derivation writes; with its values all of them do."""
    assert (
        "def inverse(T, a2=0.3, tolerance=0.001):"
        in dhcli("ik", "planar-2r", "--code", "python", "--set", "a1=0.5").out
    )
    text = dhcli("ik", "planar-2r", "--code", "python", "--with-values", "--set", "a1=0.5").out
    assert "def inverse(T, tolerance=0.001):" in text
    assert "0.5 + 0.3*c2" in text
    assert "0.55 + 1.1*c2" in dhcli("fk", "palletizer", "--code", "c", "--with-values").out  # a1 + a4
    derived = dhcli("ik", "planar-2r", "--derive", "--set", "a1=0.5").out
    assert " a1" not in derived
    assert "(0.5 + a2*c2)^2" in derived


@row_by_row(
    ("words", "said"),
    [
        (("fk", "scara", "--code", "cobol"), "--code knows no language cobol"),
        (("fk", "scara", "--code", "javascipt"), "did you mean javascript?"),
        (("fk", "scara", "--code", "Octave"), "did you mean matlab?; Octave runs it"),
        (("fk", "scara", "--code", "c++"), "did you mean c?; C++ compiles it"),
        (("fk", "scara", "--code", "py"), "did you mean python or numpy?"),
        (("fk", "scara", "--code", "rust"), "beside one of these --format json gives the formulas"),
        (("fk", "scara", "-s", "--format", "octave"), "did you mean matlab?; Octave runs it; formats: json, table"),
        (("fk", "scara", "-s", "--format", ""), "there is no format ''"),
        (("fk", "scara", "-s", "--format", "tex"), "did you mean latex?; formats: json, table"),
        (("fk", "scara", "--in", "q.csv", "--format", "ndjson"), "did you mean jsonl?"),
        (("fk", "scara", "--code", "c", "-o", "fk.py"), "write .c, or --code python"),
        (
            ("ik", "planar-2r", "--code", "numpy", "-o", "ik.JL"),
            "in julia does, and --code says numpy",
        ),
        (
            ("jacobian", "scara", "--code", "c", "--format", "json", "-o", "J.c"),
            "write .json, or leave --format out",
        ),
        (("fk", "scara", "--with-values"), "--with-values is for --code"),
        (("fk", "scara", "--code", "c", "--links"), "--code and --links ask for different things"),
        (("fk", "scara", "--code", "c", "--as", "rpy", "--let"), "--code and --as and --let ask for different things"),
        (("fk", "scara", "--code", "c", "--format", "numpy"), "--code says the language, and --format another"),
        (("fk", "scara", "--code", "c", "--rows", "q.csv"), "--code does not go with --rows"),
        (("ik", "planar-2r", "--code", "c", "--why"), "--code and --why ask for different things"),
        (("ik", "planar-2r", "--with-values"), "--with-values is for --code"),
        (("ik", "planar-2r", "--rows", "T.csv", "--with-values"), "--with-values does not go with --rows"),
        (("ik", "planar-2r", "--derive", "--near", "0,0"), "--derive and --near ask for different things"),
        (("ik", "planar-2r", "--code", "c", "--position", "0.5,0,0"), "is in letters and takes no pose"),
        (("ik", "panda", "--code", "c"), "has no textbook form"),
        (("ik", "planar-2r", "--derive", "--format", "c"), "a function that runs is --code c"),
        (("jacobian", "scara", "--code", "c", "--let"), "--code and --let ask for different things"),
        (("jacobian", "scara", "--code", "c", "--rows", "q.csv"), "--code does not go with --rows"),
        (("fk", "scara", "-s", "-o", "fk.c"), "a function that runs is --code c"),
        (("fk", "scara", "-s", "--format", "julia"), "a function that runs is --code julia"),
    ],
)
def test_what_does_not_go_is_refused_in_words(dhcli: Run, words: tuple[str, ...], said: str) -> None:
    """With what would be right."""
    done = dhcli(*words)
    assert done.code == 2
    assert said in " ".join(done.err.split())
