"""`dhcli check`: exit codes, JSON, sheets, robots, tolerances, and the walk on a terminal."""

from __future__ import annotations

import json
import os
import re
from pathlib import Path

import pytest

from dhcli.files.progress import Try, path_of_progress, read_progress
from tests.cli.running import Run
from tests.cli.terminal import Terminal
from tests.row_by_row import row_by_row

ROOT = Path(__file__).parents[2]

PLANAR, MOTION = "yim/planar-two-links", "planar-jacobian"
A1 = "[c1 -s1 0 a1*c1; s1 c1 0 a1*s1; 0 0 1 0; 0 0 0 1]"
MISPRINT = "[c1 -s1 0 a1*c1; s1 c1 0 a1*c1; 0 0 1 0; 0 0 0 1]"
NUMBERS = "[0.2588 -0.9659 0 0.4241; 0.9659 0.2588 0 0.4898; 0 0 1 0; 0 0 0 1]"
ROWS = [r"c_1 & -s_1 & 0 & a_1 c_1 \\", r"s_1 & c_1 & 0 & a_1 s_1 \\", r"0 & 0 & 1 & 0 \\", "0 & 0 & 0 & 1"]
LATEX = [r"\begin{bmatrix}", *ROWS, r"\end{bmatrix}"]
ARRAY = [r"\begin{array}{cccc}", *ROWS, r"\end{array}"]
ROW_2 = [r"a2 & 0 & 0 & \theta_2", r"\end{array}"]
AT = ("check", "planar-2r", "--q", "30°, 45°")

DATA = {"exercise", "variant", "verdict", "passed", "earned", "credit", "parts", "withdrawn"}
PART = {"part", "verdict", "passed", "earned", "credit", "cause"}
CAUSE = {"rationale", "help", "expected", "actual", "diagnosis"}

terminal = pytest.mark.skipif(os.name == "nt", reason="pseudo-terminals as Unix knows them")


def sheet(folder: Path, answers: str, exercise: str = PLANAR, name: str = "sheet.yaml") -> str:
    """A sheet with these answers."""
    (folder / name).write_text(f"format: 1\nexercise: {exercise}\nanswers:\n{answers}", "utf-8")
    return name


# ---------------------------------------------------------------------------------------------------- exit codes


@pytest.mark.parametrize(
    ("answer", "word", "code", "passed"),
    [
        (NUMBERS, "RIGHT", 0, True),
        ("[0.26 -0.97 0 0.42; 0.97 0.26 0 0.49; 0 0 1 0; 0 0 0 1]", "ROUNDED", 1, None),
        (NUMBERS.replace("0.4241", "0.4255"), "CLOSE", 1, False),
        (NUMBERS.replace("0.4241", "0.5"), "WRONG", 1, False),
        ("_", "SKIPPED", 1, None),
        ("[1 2; 3", "CAN'T READ", 2, None),
    ],
)
def test_every_verdict_has_its_exit_code(dhcli: Run, answer: str, word: str, code: int, passed: object) -> None:
    """And its word, on stdout alone; in JSON too, whose `ok` says that the command itself worked."""
    done = dhcli(*AT, "--answer", answer)
    assert (done.code, done.err) == (code, "")
    assert word in done.out
    done = dhcli(*AT, "--answer", answer, "--format", "json")
    assert (done.code, done.envelope["ok"]) == (code, True)
    assert (done.envelope["data"]["verdict"], done.envelope["data"]["passed"]) == (word, passed)


def test_an_equivalent_table_ends_with_0(dhcli: Run) -> None:
    """It is right, in another way."""
    done = dhcli("check", PLANAR, "--part", "table", "--answer", "[-a1 0 0 theta1+180; a2 0 0 theta2-180]")
    assert done.code == 0
    assert "EQUIVALENT" in done.out
    assert "x1" in done.out


def test_json_has_exactly_its_keys(dhcli: Run) -> None:
    """For the whole, for a part, and for its cause; the right answer is not among them."""
    done = dhcli("check", PLANAR, "--part", "a1", "--answer", MISPRINT, "--format", "json")
    envelope = done.envelope
    assert set(envelope) == {"dhcli", "command", "ok", "data", "problems"}
    assert (envelope["command"], envelope["problems"]) == ("check", [])
    assert set(envelope["data"]) == DATA
    (part,) = envelope["data"]["parts"]
    assert set(part) == PART
    assert set(part["cause"]) == CAUSE
    assert part["cause"]["expected"] is None
    assert set(part["cause"]["diagnosis"]) == {"causes", "follows"}
    assert part["cause"]["diagnosis"]["causes"][0][0]["name"] == "misprint"
    assert "misprint" in part["cause"]["rationale"][0]
    assert (part["part"], part["verdict"], part["passed"], part["credit"]) == ("a1", "WRONG", False, 2)
    assert part["earned"] == pytest.approx(5 / 6 * 2)


def test_the_right_answer_is_shown_only_where_the_exercise_allows(dhcli: Run, tmp_path: Path) -> None:
    """`feedback: expected` in its file."""
    text = "format: 1\ntitle: t\nsource: s\ntask: t\nparts:\n  - {id: a, ask: scalar 6*7}\n"
    for feedback, shown in (("", None), ("feedback: expected\n", "42")):
        (tmp_path / "e.yaml").write_text(text + feedback, "utf-8")
        done = dhcli("check", "e.yaml", "--part", "a", "--answer", "41", "--format", "json")
        assert done.envelope["data"]["parts"][0]["cause"]["expected"] == shown
        assert ("right: 42" in dhcli("check", "e.yaml", "--part", "a", "--answer", "41").out) == (shown == "42")


def test_csv_has_a_line_for_each_part(dhcli: Run, tmp_path: Path) -> None:
    """With the credit."""
    path = sheet(tmp_path, f"  a1: '{A1}'\n  t02: '{A1}'\n")
    lines = dhcli("check", PLANAR, path, "--format", "csv").out.splitlines()
    assert lines[0] == "part,verdict,earned,credit"
    assert "a1,RIGHT,2,2" in lines
    assert len(lines) == 1 + 8


@pytest.mark.parametrize(
    ("question", "hint", "name"),
    [
        (
            ("rotate-a-vector", "--part", "quarter", "--answer", "0 1 0 0; -1 0 0 0; 0 0 1 0; 0 0 0 1"),
            "which frame do the columns of the rotation belong to?",
            "the rotation is transposed",
        ),
        (
            ("rotate-a-vector", "--part", "about_z", "--answer", "0 -1 0"),
            "which way is a positive turn?",
            "it is turned the other way",
        ),
        (
            ("counting-exceptions", "--part", "bennett", "--answer", "-8"),
            "go through what was counted",
            "the ground is not counted",
        ),
    ],
)
def test_a_slip_is_a_hint_first_and_named_once_when_asked(
    dhcli: Run, question: tuple[str, ...], hint: str, name: str
) -> None:
    """Nothing else on the page says the name, nor names the same thing otherwise."""
    first = dhcli("check", *question).out
    assert hint in first
    assert name not in first
    asked = dhcli("check", *question, "--why").out
    assert asked.count(name) == 1
    assert f"why: {name}" in asked
    assert "inverse" not in first + asked


def test_where_no_slip_is_found_it_is_said_when_asked(dhcli: Run) -> None:
    """In one line; a choice has no slips, and an answer that is typed too short is told that."""
    calm = "why: no slip that dhcli knows gives this answer"
    answer = ("check", "puma560-at-work-in-mm", "--part", "approach", "--answer")
    assert calm in dhcli(*answer, "0.1 0.2 0.97", "--why").out
    assert calm not in dhcli(*answer, "0.1 0.2 0.97").out
    assert calm not in dhcli(*answer, "-0.3 0.3 -0.9", "--why").out
    assert calm not in dhcli(*answer, "-0.277 0.347 -0.896", "--why").out
    assert calm not in dhcli("check", "rotate-a-vector", "--part", "sense", "--answer", "1", "--why").out


def test_a_formula_that_loses_its_quadrants_is_not_said_to_have_no_slip(dhcli: Run) -> None:
    """Two atan for two atan2 are no single slip, and a remark has told what they lose."""
    formula = "atan(py/px) - atan(a2*s2/(a1 + a2*c2))"
    said = dhcli("check", "planar-joints", "--part", "shoulder", "--answer", formula, "--why").out
    assert "as atan loses the quadrants on the left" in said
    assert "no slip" not in said


def test_a_format_that_a_judgement_does_not_have_is_refused_first(dhcli: Run) -> None:
    """Before anything is judged and counted as a try."""
    done = dhcli("check", PLANAR, "--part", "a1", "--answer", A1, "--format", "latex")
    assert (done.code, done.out) == (2, "")
    assert read_progress()[0] == {}


# -------------------------------------------------------------------------------------------------------- sheets


def test_a_sheet_is_judged_part_by_part(dhcli: Run, tmp_path: Path) -> None:
    """With the sum at the end."""
    done = dhcli("check", "planar-two-links", sheet(tmp_path, f"  a1: '{A1}'\n  a2: '{A1}'\n  d02: _\n"))
    assert done.code == 1
    lines = done.out.splitlines()
    assert next(line for line in lines if line.startswith("✓ RIGHT")).split()[2] == "a1:"
    assert "1 of 8 parts solved, 2 of 13 credits" in done.out


@pytest.mark.parametrize(
    ("answer", "told"),
    [
        ("-0.30739, 0.4253, 0.2", " (1 of 2 credits)\n    right in m; this sheet is in mm"),
        ("-307.39, 425.3, 210", " (1.33 of 2 credits)\n"),
        ("0, 0, 0", ": three lengths\n"),
    ],
)
def test_one_answer_says_what_earned_a_part_of_its_credit(dhcli: Run, answer: str, told: str) -> None:
    """As a sheet does: half of it where only the unit is another."""
    assert told in dhcli("check", "scara-pose-in-mm", "--part", "tip", "--answer", answer).out


def test_a_sheet_says_what_earned_a_part_of_its_credit(dhcli: Run, tmp_path: Path) -> None:
    """A part of it, and all of it where the slip was made before; what is solved or earned nothing says nothing."""
    wrong = "c12 -s12 0 a1*c1+a2*c12; s12 c12 0 a1*s1-a2*s12; 0 0 1 0; 0 0 0 1"
    answers = f"  a1: '{A1}'\n  t02: '{wrong}'\n  d02: 'a1*c1+a2*c12; a1*s1-a2*s12; 0'\n  x2: '0 0 1'\n"
    lines = dhcli("check", PLANAR, sheet(tmp_path, answers)).out.splitlines()
    heads = {part: line for line in lines for part in ("a1", "t02", "d02", "x2") if f"  {part}: " in line}
    assert heads["t02"].endswith("(2.5 of 3 credits)")
    assert heads["d02"].endswith("(credit kept: 1)")
    assert "credit" not in heads["a1"] + heads["x2"]
    assert lines[-1] == "1 of 8 parts solved, 5.5 of 13 credits"


def test_a_rounded_answer_of_a_sheet_says_that_it_earned_all(dhcli: Run, tmp_path: Path) -> None:
    """It is not counted as solved, so that the sum would be a riddle."""
    text = "  a1: '0.866 -0.5 0 0.346; 0.5 0.866 0 0.2; 0 0 1 0; 0 0 0 1'\n"
    path = tmp_path / "numbers.yaml"
    path.write_text(f"format: 1\nexercise: yim/planar-in-numbers\nanswers:\n{text}", "utf-8")
    done = dhcli("check", "planar-in-numbers", str(path))
    assert done.out.splitlines()[0].endswith("(full credit: 2)")


def test_a_sheet_comes_from_standard_input_too(dhcli: Run) -> None:
    """As `-`."""
    text = f"format: 1\nexercise: {PLANAR}\nanswers:\n  a1: '{A1}'\n"
    done = dhcli("check", PLANAR, "-", "--part", "a1", stdin=text)
    assert (done.code, done.err) == (0, "")
    assert "RIGHT" in done.out


def test_an_answer_comes_from_standard_input_too(dhcli: Run) -> None:
    """As `--answer -`."""
    done = dhcli("check", PLANAR, "--part", "a1", "--answer", "-", stdin=A1.replace("; ", "\n"))
    assert (done.code, done.err) == (0, "")


def test_a_sheet_of_another_exercise_is_refused(dhcli: Run, tmp_path: Path) -> None:
    """With the command that would be right; one that does not say is taken."""
    path = sheet(tmp_path, f"  a1: '{A1}'\n", exercise="yim/dh-factors")
    done = dhcli("check", PLANAR, path)
    assert (done.code, done.out) == (2, "")
    assert "is a sheet of yim/dh-factors, not of yim/planar-two-links" in done.err
    assert "dhcli check yim/dh-factors sheet.yaml" in done.err
    (tmp_path / path).write_text(f"format: 1\nanswers: {{a1: '{A1}'}}\n", "utf-8")
    assert dhcli("check", PLANAR, path, "--part", "a1").code == 0


@pytest.mark.parametrize(
    ("answers", "said"),
    [
        ("  a9: '1'\n", "has no part a9"),
        ("  a1: '1'\n  a1: '2'\n", "sheet.yaml:5:3: a1: stands twice"),
        ("  - a1: 1\n", "answers:"),
        ("  a1: '" + "1 " * 150_000 + "'\n", "256 kB"),
    ],
)
def test_a_sheet_that_is_none_ends_with_2(dhcli: Run, tmp_path: Path, answers: str, said: str) -> None:
    """And is no try."""
    done = dhcli("check", PLANAR, sheet(tmp_path, answers))
    assert (done.code, done.out) == (2, "")
    assert said in done.err
    assert read_progress()[0] == {}


def test_a_stray_quote_leaves_the_other_answers_judged(dhcli: Run, tmp_path: Path) -> None:
    """With its line and what to write; the sheet has an answer that cannot be read, so it ends with 2."""
    done = dhcli("check", PLANAR, sheet(tmp_path, f"  a1: '{A1}'\n  blocks: '1'st'\n  x2: (c12, s12, 0)\n"))
    assert done.code == 2
    assert re.findall(r"^. RIGHT +(\w+)", done.out, re.MULTILINE) == ["a1", "x2"]
    assert "CAN'T READ  blocks" in done.out
    assert "sheet.yaml:5:14: text follows the closing quote (write blocks: " in done.out
    assert read_progress()[0][PLANAR]["a1"].best == "RIGHT"


def test_a_mistake_in_a_sheet_is_found_by_its_line(dhcli: Run, tmp_path: Path) -> None:
    """Of the file, not of the answer."""
    path = sheet(tmp_path, "  a1: |\n    c1 -s1 0 a1*c1\n    s1 c1 0 L*s1\n    0 0 1 0\n    0 0 0 1\n")
    done = dhcli("check", PLANAR, path, "--part", "a1")
    assert done.code == 2
    assert "sheet.yaml:6:" in done.out
    assert "L is not a name that is known here" in done.out


@pytest.mark.parametrize(
    "words",
    [
        ("check", PLANAR),
        ("check", PLANAR, "--part", "a1"),
        (*AT,),
        ("check", "planar-2r", "--symbolic"),
    ],
)
def test_without_an_answer_and_without_a_terminal_it_never_waits(dhcli: Run, words: tuple[str, ...]) -> None:
    """Standard input is not read, whatever stands there."""
    done = dhcli(*words)
    assert (done.code, done.out) == (2, "")
    assert "there is no answer to check" in done.err


@row_by_row(
    ("words", "said"),
    [
        (("check", "nobody"), "there is no robot and no exercise 'nobody'"),
        (("check", "planar-2r"), "planar-2r is a robot: say at which joint values, or ask for symbols"),
        (("check", PLANAR, "--q", "0,0", "--answer", "1"), "is an exercise and says itself what is asked"),
        (("check", PLANAR, "--answer", "1"), "has 8 parts: say which one is answered"),
        (("check", PLANAR, "--part", "a9", "--answer", "1"), "has no part a9"),
        (("check", PLANAR, "none.yaml"), "no such file"),
        (("check", PLANAR, "none.yaml", "--answer", "1"), "are ways to give an answer"),
        ((*AT, "--from", "7", "--answer", "1"), "7"),
        ((*AT, "--tol-position", "1°", "--answer", "1"), "unit of angle"),
        ((*AT, "--tol-position", "x", "--answer", "1"), "x"),
        ((*AT, "--tol-position", "-1mm", "--answer", "1"), "negative"),
        ((*AT, "--tol-rotation", "-1", "--answer", "1"), "negative"),
        ((*AT, "--decimals", "0", "--answer", "1"), "decimals"),
        ((*AT, "--decimals", "two", "--answer", "1"), "whole number"),
        ((*AT, "--tol-rotation", "nan", "--answer", "1"), "negative"),
        (
            ("check", "dh-link", "--q", "0", "--answer", "[1 0 0 0; 0 1 0 0; 0 0 1 0; 0 0 0 1]"),
            "value for a_i, alpha_i, d_i",
        ),
    ],
)
def test_what_cannot_be_asked_ends_with_2(dhcli: Run, words: tuple[str, ...], said: str) -> None:
    """And says what would be right."""
    done = dhcli(*words)
    assert (done.code, done.out) == (2, "")
    assert said in done.err


# -------------------------------------------------------------------------------------------- questions to robots


def test_a_robot_is_asked_in_numbers(dhcli: Run) -> None:
    """At joint values, at a named pose, with lengths set, between two frames."""
    assert dhcli(*AT, "--answer", NUMBERS).code == 0
    assert dhcli("check", "planar-2r", "--q", "30,45", "--deg", "--answer", NUMBERS).code == 0
    straight = "[1 0 0 0.7; 0 1 0 0; 0 0 1 0; 0 0 0 1]"
    assert dhcli("check", "planar-2r", "--pose", "zero", "--answer", straight).code == 0
    assert dhcli("check", "planar-2r", "--pose", "zero", "--set", "a1=1m", "--answer", straight).code == 1
    assert dhcli("check", "planar-2r", "--pose", "zero", "--to", "1", "--answer", straight.replace("7", "4")).code == 0


def test_puma_is_asked_in_numbers_and_in_symbols(dhcli: Run) -> None:
    """The quick self-checks of the issue, partial products too."""
    zero = "[1 0 0 0.4521; 0 -1 0 0.15; 0 0 -1 -0.4318; 0 0 0 1]"
    assert dhcli("check", "puma560", "--q", "0,0,0,0,0,0", "--answer", zero).code == 0
    wrist = "c5c6 -c5s6 -s5 0; s6 c6 0 0; s5c6 -s5s6 c5 0; 0 0 0 1"
    assert dhcli("check", "puma560", "--symbolic", "--from", "4", "--to", "6", "--answer", wrist).code == 0
    wrong = wrist.replace("-c5s6", "c5s6")
    done = dhcli("check", "puma560", "--symbolic", "--from", "4", "--to", "6", "--answer", wrong)
    assert done.code == 1
    assert "entry (1,2)" in done.out


def test_some_joints_may_have_values_among_symbols(dhcli: Run) -> None:
    """And the answer may keep the symbol or put the value in."""
    asked = ("check", "planar-2r", "--symbolic", "--q", "theta2=0", "--answer")
    for c, s in (("c1", "s1"), ("c12", "s12")):
        assert dhcli(*asked, f"[{c} -{s} 0 a1*c1+a2*{c}; {s} {c} 0 a1*s1+a2*{s}; 0 0 1 0; 0 0 0 1]").code == 0


def test_a_table_is_checked_against_a_robot(dhcli: Run, tmp_path: Path) -> None:
    """A robot file in either convention, also from standard input."""
    head = "format: 1\ntitle: t\nsource: s\nvariables: [theta1, theta2]\nparameters: {a1: , a2: }\n"
    standard = head + "convention: standard\nlinks:\n"
    standard += "  - {a: a1, alpha: 0, d: 0, theta: theta1}\n  - {a: a2, alpha: 0, d: 0, theta: theta2}\n"
    (tmp_path / "mine.yaml").write_text(standard, "utf-8")
    assert dhcli("check", "planar-2r", "--table", "mine.yaml").code == 0
    assert dhcli("check", "planar-2r", "--table", "-", stdin=standard).code == 0
    (tmp_path / "wrong.yaml").write_text(standard.replace("a: a2", "a: a1"), "utf-8")
    assert dhcli("check", "planar-2r", "--table", "wrong.yaml").code == 1
    (tmp_path / "broken.yaml").write_text("links: 1\n", "utf-8")
    assert dhcli("check", "planar-2r", "--table", "broken.yaml").code == 2


FRAMES = """format: 1
convention: standard
frames:
  - {origin: (0, 0, 0), x: +x, z: +z}
  - {origin: (a, 0, 0), x: +x, z: +z}
  - {origin: (a + b, 0, 0), x: +x, y: -z, z: +y}
  - {frame: 3, origin: [a + b, 0, 0], x: +x, z: +y}
"""


def test_frames_are_checked_against_the_axes_of_a_robot(dhcli: Run, tmp_path: Path) -> None:
    """By the rules of their convention, each broken one named; a robot file is its table."""
    for name, text in (
        ("right.yaml", FRAMES),
        ("wrong.yaml", FRAMES.replace("standard", "modified")),
        ("table.yaml", (Path(__file__).parents[2] / "robots" / "zhou-3r-modified.yaml").read_text("utf-8")),
        ("pose.yaml", FRAMES.replace("frames:", "pose: elbow\nframes:")),
    ):
        (tmp_path / name).write_text(text, "utf-8")
    right = dhcli("check", "zhou-3r", "--frames", "right.yaml")
    assert (right.code, right.out) == (0, "✓ RIGHT       frames: frames 0 to 3 by the rules of standard DH\n")
    assert dhcli("check", "zhou-3r", "--frames", "-", stdin=FRAMES).code == 0
    wrong = dhcli("check", "zhou-3r", "--frames", "wrong.yaml", "--why")
    assert wrong.code == 1
    assert "DH1: o1 is off the axis of joint 1 (theta1): z1 passes a beside it" in wrong.out
    assert "why: the frames are those of standard DH, and modified was asked" in wrong.out
    assert dhcli("check", "zhou-3r", "--frames", "table.yaml").code == 0
    assert dhcli("check", "puma560", "--frames", "table.yaml").code == 2
    assert dhcli("check", "zhou-3r", "--frames", "pose.yaml").code == 1
    assert dhcli("check", "zhou-3r", "--frames", "pose.yaml", "--pose", "zero").code == 0
    assert dhcli("check", "zhou-3r", "--frames", "right.yaml", "--set", "a=1").code == 0


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("convention: standard", "convention: standrd", "did you mean standard?"),
        ("convention: standard\n", "", "convention: is missing"),
        ("x: +x, y: -z, z: +y", "x: +x, z: (0, 0, 0)", "z2 is (0, 0, 0): a direction is not zero"),
        ("{origin: (a, 0, 0), x: +x, z: +z}", "{origin: (a, 0, 0), x: +x}", "z: is missing"),
        ("{origin: (a, 0, 0), x: +x, z: +z}", "{o: (a, 0, 0), x: +x, z: +z}", "o: unknown key"),
        ("{origin: (a, 0, 0), x: +x, z: +z}", "[1, 2]", "should be a mapping"),
        ("frames:\n", "frames: []\nsource: x\nrest:\n", "frames: there are none"),
        ("frame: 3", "frame: 7", "there is no frame 7"),
        ("(a, 0, 0)", "(c, 0, 0)", "c is not a name that is known here"),
    ],
)
def test_a_file_of_frames_with_a_slip_is_refused(dhcli: Run, old: str, new: str, said: str) -> None:
    """Exit code 2, and where it is."""
    done = dhcli("check", "zhou-3r", "--frames", "-", stdin=FRAMES.replace(old, new))
    assert done.code == 2
    assert said in done.out + done.err


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("zhou-3r", "--q", "1,2,3"), "only --pose NAME and --set go with it"),
        (("zhou-3r", "--pose", "elbo"), "elbow"),
        (("zhou-3r", "--answer", "0"), "use one of them"),
        (("dh-link",), "directions depend on alpha_i"),
        (("assembly-blocks",), "has no joints"),
        ((PLANAR,), "leave --q, --symbolic and so on out"),
        (("planar-2r", "--ik", "--position", "0.5,0.3,0"), "leave --table, --frames"),
    ],
)
def test_frames_go_with_a_robot_alone(dhcli: Run, words: tuple[str, ...], said: str) -> None:
    """Exit code 2, and what would do."""
    done = dhcli("check", *words, "--frames", "-", stdin=FRAMES)
    assert done.code == 2
    assert said in done.err


def test_a_table_is_compared_as_one_says(dhcli: Run, tmp_path: Path) -> None:
    """As the same robot by default; the same motion, or the cells alone, on request."""
    text = (ROOT / "robots" / "ur5e.yaml").read_text("utf-8")
    (tmp_path / "mine.yaml").write_text(text.replace("a2: -425 mm", "a2: 425 mm"), "utf-8")
    asked = ("check", "ur5e", "--table", "mine.yaml")
    robot = dhcli(*asked)
    assert (robot.code, robot.out.split()[1]) == (0, "EQUIVALENT")
    assert "your theta2 has another zero (180°)" in robot.out
    assert dhcli(*asked, "--compare", "same-robot").out == robot.out
    motion = dhcli(*asked, "--compare", "same-motion")
    assert (motion.code, motion.out.split()[1]) == (1, "WRONG")
    assert "the same robot, but this comparison fixes base" in motion.out
    literal = dhcli(*asked, "--compare", "literal")
    assert (literal.code, literal.out.split()[1]) == (1, "WRONG")
    assert "a right table of the same robot" in literal.out


def test_a_comparison_that_is_not_known_is_refused(dhcli: Run, tmp_path: Path) -> None:
    """Or one of nothing."""
    (tmp_path / "mine.yaml").write_text((ROOT / "robots" / "ur5e.yaml").read_text("utf-8"), "utf-8")
    wrong = dhcli("check", "ur5e", "--table", "mine.yaml", "--compare", "samerobot")
    assert (wrong.code, "did you mean same-robot" in wrong.err) == (2, True)
    nothing = dhcli("check", "ur5e", "--q", "0,0,0,0,0,0", "--compare", "literal", "--answer", "1")
    assert (nothing.code, "--table FILE" in nothing.err) == (2, True)


def test_a_tool_that_no_table_holds_is_told(dhcli: Run, tmp_path: Path) -> None:
    """The file's own poses go on to it, those of the robot do not."""
    text = (ROOT / "robots" / "ur5e.yaml").read_text("utf-8")
    (tmp_path / "mine.yaml").write_text(text + "tool: Trans(0, 0, 100 mm)\n", "utf-8")
    told = "beside the table: tool: of mine differs from ur5e, and was not compared"
    assert told in dhcli("check", "ur5e", "--table", "mine.yaml").out
    same = (ROOT / "robots" / "zhou-6r.yaml").read_text("utf-8")
    (tmp_path / "same.yaml").write_text(same, "utf-8")
    assert "beside the table" not in dhcli("check", "zhou-6r", "--table", "same.yaml").out


# ---------------------------------------------------------------------------------------------------- tolerances


def test_the_tolerance_of_a_position_is_a_length(dhcli: Run) -> None:
    """In any unit; bare metres. The truth is 0.424056, the answer 0.4245."""
    answer = NUMBERS.replace("0.4241", "0.4245")
    assert dhcli(*AT, "--answer", answer).code == 0
    for tolerance, code in (("0.5mm", 0), ("0.4mm", 1), ("0.0005", 0), ("0.04 cm", 1)):
        assert dhcli(*AT, "--tol-position", tolerance, "--answer", answer).code == code, tolerance


def test_the_tolerance_of_a_rotation_is_a_number(dhcli: Run) -> None:
    """It does not touch lengths."""
    answer = NUMBERS.replace("0.2588", "0.262").replace("0.9659", "0.9651")
    assert dhcli(*AT, "--answer", answer).code == 1
    assert dhcli(*AT, "--tol-rotation", "0.005", "--answer", answer).code == 0
    assert dhcli(*AT, "--tol-rotation", "0.005", "--answer", answer.replace("0.4241", "0.43")).code == 1


def test_the_decimals_that_a_task_asks_for_are_enough(dhcli: Run) -> None:
    """Fewer are not."""
    two = "[0.26 -0.97 0 0.42; 0.97 0.26 0 0.49; 0 0 1 0; 0 0 0 1]"
    assert dhcli(*AT, "--answer", two).code == 1
    assert dhcli(*AT, "--decimals", "2", "--answer", two).code == 0
    assert dhcli(*AT, "--decimals", "3", "--answer", two).code == 1


def test_a_tolerance_of_the_command_line_beats_that_of_a_part(dhcli: Run, tmp_path: Path) -> None:
    """For every part."""
    text = "format: 1\ntitle: t\nsource: s\ntask: t\nrobot: planar-2r\nnumeric: true\n"
    text += "given: {theta1: 30°, theta2: 45°}\nparts:\n  - {id: a, ask: position of pose 0..2, decimals: 4}\n"
    (tmp_path / "e.yaml").write_text(text, "utf-8")
    asked = ("check", "e.yaml", "--part", "a", "--answer", "0.42 0.49 0")
    assert [dhcli(*asked).code, dhcli(*asked, "--tol-position", "5mm").code] == [1, 0]


# ------------------------------------------------------------------------------------------------------ progress


def test_a_check_is_remembered(dhcli: Run, tmp_path: Path) -> None:
    """The best verdict and the tries; what was left blank is no try, nor is a question to a robot."""
    dhcli("check", PLANAR, "--part", "a1", "--answer", MISPRINT)
    dhcli("check", "planar-two-links", "--part", "a1", "--answer", A1)
    dhcli("check", PLANAR, sheet(tmp_path, "  a1: '1'\n  a2: _\n"))
    dhcli(*AT, "--answer", NUMBERS)
    assert read_progress()[0] == {PLANAR: {"a1": Try("RIGHT", 3)}}


def test_a_broken_progress_file_is_set_aside_and_the_check_goes_on(dhcli: Run) -> None:
    """With a message on stderr, and JSON still whole on stdout."""
    path = path_of_progress()
    path.parent.mkdir(parents=True)
    path.write_text("{broken")
    done = dhcli("check", PLANAR, "--part", "a1", "--answer", A1, "--format", "json")
    assert done.code == 0
    assert "set aside as progress.json.broken-1" in done.err
    assert done.envelope["data"]["verdict"] == "RIGHT"
    assert json.loads(path.read_text())["exercises"] == {PLANAR: {"a1": {"best": "RIGHT", "tries": 1, "hints": 0}}}


def test_progress_that_cannot_be_saved_does_not_lose_the_verdict(dhcli: Run, user_data: Path) -> None:
    """It is said on stderr."""
    user_data.parent.mkdir(exist_ok=True)
    user_data.write_text("in the way")
    done = dhcli("check", PLANAR, "--part", "a1", "--answer", A1)
    assert done.code == 0
    assert "progress could not be saved" in done.err


# ---------------------------------------------------------------------------------------------------- safe output


@pytest.mark.parametrize(
    "answer",
    [
        "\x1b[2J\x1b[31mRIGHT",
        "[bold red]RIGHT[/]",
        "\x9b31m\x07",
        "\u202eTHGIR",
        "c1\rRIGHT",
        "[link=http://x]x[/link]",
    ],
)
def test_what_was_typed_never_steers_the_terminal(dhcli: Run, answer: str) -> None:
    """Control characters and markup come back as plain letters, or not at all."""
    done = dhcli("check", PLANAR, "--part", "a1", "--answer", answer)
    assert done.code == 2
    assert (done.out + done.err).replace("\n", "").isprintable()
    assert "✓" not in done.out


def test_without_unicode_the_signs_are_ascii(dhcli: Run) -> None:
    """And the word says it anyway."""
    done = dhcli("check", PLANAR, "--part", "a1", "--answer", MISPRINT, PYTHONIOENCODING="ascii")
    assert done.code == 1
    assert done.out.isascii()
    assert "x WRONG" in done.out


# -------------------------------------------------------------------------------------------------------- a walk


@terminal
def test_on_a_terminal_the_parts_are_asked_one_by_one(tmp_path: Path) -> None:
    """A wrong answer, a hint, a right one, a blank and the end of the input."""
    with Terminal(tmp_path, "check", "yim/planar-two-links") as screen:
        assert "Planar arm with two links" in screen.until("table> ")
        screen.type("?\n")
        assert "hint 1 of 2: Parallel axes have no twist" in screen.until("table> ")
        screen.type("a1 0 0 theta1\n")
        screen.until(r"\.\.\. ")
        screen.type("a2 0 0 theta2\n")
        screen.until(r"\.\.\. ")
        screen.type("\n")
        assert "RIGHT" in screen.until("a1> ")
        screen.type(f"{MISPRINT}\n")
        assert "misprint" in screen.until("a1> ")
        screen.type("\n")
        screen.until("a2> ")
        screen.type("\n")
        assert "SKIPPED" in screen.until("blocks> ")
        screen.type("\x04")
        assert screen.end() == 1
        assert "1 of 8 parts solved, 3.67 of 13 credits" in screen.seen
    assert read_progress()[0][PLANAR] == {"table": Try("RIGHT", 1), "a1": Try("WRONG", 1)}


@terminal
def test_a_wrong_answer_may_be_tried_again(tmp_path: Path) -> None:
    """As often as one likes, one that cannot be read too; an empty line goes on, and a right answer does."""
    with Terminal(tmp_path, "check", "counting-freedoms") as screen:
        screen.until("constraint> ")
        screen.type("lambda + f\n")
        assert "WRONG" in screen.until("Try again, or go on with an empty line")
        screen.until("constraint> ")
        screen.type("lambda - x\n")
        assert "CAN'T READ" in screen.until("constraint> ")
        screen.type("λ - f\n")
        assert "RIGHT" in screen.until("gruebler> ")
        screen.type("1\n")
        screen.until("Try again")
        screen.type("\n")
        assert "SKIPPED" not in screen.until("constrained> ")
        screen.type("\x04")
        assert screen.end() == 1
        assert re.search(r"\n1 of \d+ parts solved, 1 of \d+ credits\n", screen.seen)
    assert read_progress()[0]["yim/counting-freedoms"] == {"constraint": Try("RIGHT", 3), "gruebler": Try("WRONG", 1)}


@terminal
@pytest.mark.parametrize(
    ("exercise", "part", "lines", "verdict"),
    [
        ("counting-freedoms", "gruebler", ["λ(n - j - 1) + jf"], "RIGHT"),
        ("counting-freedoms", "gruebler", ["λ(n - j -", "1) +", "j f"], "RIGHT"),
        ("counting-freedoms", "gruebler", ["λ(n - j - 1)) + j"], "CAN'T READ"),
        ("counting-freedoms", "links", ["6 + 1"], "RIGHT"),
        (PLANAR, "d02", ["a1 c1 + a2 c12, a1 s1 + a2 s12, 0"], "RIGHT"),
        (PLANAR, "d02", ["a1 c1 + a2 c12;", "a1 s1 + a2 s12;", "0"], "RIGHT"),
        (PLANAR, "a1", ["c1 -s1 0 a1*c1", "s1 c1 0 a1*s1", "0 0 1 0", "0 0 0 1", ""], "RIGHT"),
        (PLANAR, "a1", ["c1, -s1, 0, a1*c1;", "s1, c1, 0, a1*s1;", "0, 0, 1, 0;", "0, 0, 0, 1"], "RIGHT"),
        (PLANAR, "table", ["a1,0,0,theta1", "a2,0,0,theta2", ""], "RIGHT"),
        (PLANAR, "r02", ["the answer is [c12 -s12 0; s12 c12 0; 0 0 1]"], "RIGHT"),
        (MOTION, "whole", ["Jv = [-a1s1-a2s12, -a2s12; a1c1+a2c12, a2c12; 0, 0]", "Jω = [0 0; 0 0; 1 1]"], "RIGHT"),
        (MOTION, "whole", ["-a1s1-a2s12, -a2s12", "a1c1+a2c12, a2c12", "0,0", "0,0", "0,0", "1,1", ""], "RIGHT"),
        (PLANAR, "a1", LATEX, "RIGHT"),
        (PLANAR, "a1", ["A_1 = \\left[", *ARRAY, "\\right]"], "RIGHT"),
        (PLANAR, "table", [r"\begin{array}{cccc}", r"a1 & 0 & 0 & \theta_1\\", *ROW_2], "RIGHT"),
    ],
)
def test_an_answer_is_judged_as_soon_as_it_is_whole(
    tmp_path: Path, exercise: str, part: str, lines: list[str], verdict: str
) -> None:
    """One value with its line, a matrix or a table with an empty one, unless its brackets or its rows say it before."""
    with Terminal(tmp_path, "check", exercise, "--part", part) as screen:
        screen.until(f"{part}> ")
        for line in lines[:-1]:
            screen.type(f"{line}\n")
            screen.until(r"\.\.\. ")
        screen.type(f"{lines[-1]}\n")
        assert re.search(rf"^. {verdict} ", screen.until(rf"{verdict} +{part}\n"), re.MULTILINE)


@terminal
def test_one_part_is_asked_alone(tmp_path: Path) -> None:
    """And its verdict is the exit code."""
    with Terminal(tmp_path, "check", PLANAR, "--part", "blocks") as screen:
        assert "1: the upper index" in screen.until("blocks> ")
        screen.type("1\n")
        assert screen.end() == 0
        assert "RIGHT" in screen.seen


@terminal
def test_a_robot_is_asked_on_a_terminal_too(tmp_path: Path) -> None:
    """A question made on the spot has one part."""
    with Terminal(tmp_path, *AT) as screen:
        screen.until("pose> ")
        screen.type(f"{NUMBERS}\n")
        assert screen.end() == 0


@terminal
def test_ctrl_c_ends_a_walk_with_130(tmp_path: Path) -> None:
    """What was answered so far is kept, and summed up."""
    with Terminal(tmp_path, "check", PLANAR, own_process=True) as screen:
        screen.until("table> ")
        screen.type("\n")
        screen.until("a1> ")
        screen.type(f"{A1}\n")
        screen.until("a2> ")
        screen.interrupt()
        assert screen.end() == 130
        assert "1 of 8 parts solved, 2 of 13 credits" in screen.seen
        assert "Traceback" not in screen.seen
    assert read_progress()[0] == {PLANAR: {"a1": Try("RIGHT", 1)}}


@pytest.mark.parametrize(
    ("words", "part"),
    [
        (("--answer", "-0.2321, 0.4259, 0.3"), "position"),
        (("--answer", "0.6967 -0.7174 0; 0.7174 0.6967 0; 0 0 1"), "rotation"),
        (("--as", "rpy", "--answer", "0, 0, 45.8366"), "rpy"),
        (("--as", "quaternion", "--answer", "0.92106 0 0 0.389418"), "quaternion"),
        (("--as", "zyz", "--answer", "45.8366, 0, 0"), "euler"),
        (("--as", "position", "--answer", "-232.1 mm, 425.9 mm, 300 mm"), "position"),
        (("--entry", "1,4", "--answer", "-0.2321"), "entry"),
    ],
)
def test_a_piece_of_a_robots_pose_is_checked_alone(dhcli: Run, words: tuple[str, ...], part: str) -> None:
    """What it is says its shape, or an option; in JSON as on the screen."""
    done = dhcli("check", "scara", "--q", "0.3,0.5,0.1", *words, "--format", "json")
    assert (done.code, done.data["verdict"], done.data["parts"][0]["part"]) == (0, "RIGHT", part)


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("--as", "xyzz", "--answer", "1"), "there is no form xyzz"),
        (("--entry", "1,5", "--answer", "1"), "'1,5' is no entry of a 4x4"),
        (("--entry", "1,4", "--as", "rpy", "--answer", "1"), "--as and --entry both say what is answered"),
    ],
)
def test_a_piece_that_a_pose_does_not_have_is_refused(dhcli: Run, words: tuple[str, ...], said: str) -> None:
    """With exit code 2."""
    done = dhcli("check", "scara", "--q", "0.3,0.5,0.1", *words)
    assert done.code == 2
    assert said in done.err


@pytest.mark.parametrize(
    ("answer", "asked"),
    [
        ("abc!, 0.4259, 0.3", "position: the position of T_03"),
        ("-0.2321, 0,4259, 0.3", "position: the position of T_03"),
        ("1 0 0; 0 ? 0; 0 0 1", "rotation: the rotation of T_03"),
        ("1 0 0 0; 0 1 0 0; 0 0 1 0; 0 0 0", "pose: T_03"),
    ],
)
def test_an_answer_that_cannot_be_read_is_taken_for_what_it_is_nearest_to_in_size(
    dhcli: Run, answer: str, asked: str
) -> None:
    """Three entries are no 4x4 matrix, whatever is wrong with them."""
    done = dhcli("check", "scara", "--q", "0.3,0.5,0.1", "--answer", answer)
    assert done.code == 2
    assert done.out.startswith(f"? CAN'T READ  {asked}, ")


def test_hints_lead_to_the_variant_that_was_answered(dhcli: Run) -> None:
    """Its numbers are others than those of the file."""
    words = ("check", "planar-in-numbers", "--variant", "alice", "--part", "middle", "--answer", "1.001, 2.002, 3.003")
    assert "dhcli hint yim/planar-in-numbers --variant alice --part middle\n" in dhcli(*words).out


@pytest.mark.parametrize(
    ("rows", "verdict"),
    [
        ("- [a1, 0, 0, theta1]\n- [a2, 0, 0, theta2]\n", "RIGHT"),
        ("- {theta: theta1, d: 0, a: a1, alpha: 0}\n- {theta: theta2, d: 0, a: a2, alpha: 0}\n", "RIGHT"),
        ("theta, d, a, alpha\ntheta1, 0, a1, 0\ntheta2, 0, a2, 0\n", "RIGHT"),
        ("- [a1, 90°, 0, theta1]\n- [a2, 0, 0, theta2]\n", "WRONG"),
        ("- [a1, 0, 0]\n- [a2, 0, 0, theta2]\n", "CAN'T READ"),
        ("- just words\n", "CAN'T READ"),
    ],
)
def test_a_table_to_compare_may_be_its_rows_alone(dhcli: Run, rows: str, verdict: str) -> None:
    """As an answer has them: lists, mappings or lines, in the convention of the robot."""
    Path("rows.yaml").write_text(rows, "utf-8")
    done = dhcli("check", "planar-2r", "--table", "rows.yaml")
    assert verdict in done.out.splitlines()[0]
    assert ("the rows name no convention, and were read as standard DH" in done.out) is (verdict != "CAN'T READ")


def test_one_credit_is_one(dhcli: Run, tmp_path: Path) -> None:
    """Half of it is half of 1 credit."""
    (tmp_path / "sheet.yaml").write_text(
        'format: 1\nexercise: yim/planar-two-links\nanswers: {r02: "c12 -s12 0; s12 -c12 0; 0 0 1"}\n'
    )
    done = dhcli("check", PLANAR, str(tmp_path / "sheet.yaml"))
    assert re.search(r"\(0\.\d+ of 1 credit\)", done.out)
