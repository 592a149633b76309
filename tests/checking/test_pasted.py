"""Answers pasted back: what dhcli printed in any format, and entries by their names."""

from __future__ import annotations

from dataclasses import replace

import pytest

from dhcli import load_robot
from dhcli.checking.exercise import Exercise, Part
from dhcli.checking.judge import check
from dhcli.checking.kinds.made import question_about
from dhcli.checking.kinds.matrix import MatrixQuestion
from dhcli.checking.pasted import LARGEST
from dhcli.checking.verdicts import Verdict
from dhcli.checking.wanted import View
from dhcli.cli.main import main
from dhcli.files.yaml.exercises import load_exercise
from dhcli.notation.angle import Angle
from tests.judging import mark

NAMED = """r11 = c12
r12 = -s12
r13 = 0
r21 = s12; r22 = c12; r23 = 0
r_{31} = 0, r_32 = 0, R33 = 1
px = a1c1 + a2c12
py = a1*s1 +
     a2 s12
p_z = 0"""


@pytest.fixture
def pose() -> Exercise:
    """The pose of the planar arm, in symbols."""
    return question_about(load_robot("planar-2r"), "pose 0..2", numeric=False, given={})


@pytest.fixture
def position() -> Exercise:
    """The position of the planar arm with links of 0.4 m and 0.3 m, in numbers."""
    values = {"theta1": Angle(), "theta2": Angle()}
    asked = question_about(load_robot("planar-2r"), "pose 0..2", numeric=True, given=values)
    return replace(asked, parts=(Part("tip", MatrixQuestion(View("0", "2"), piece="position")),))


def remarks(exercise: Exercise, answer: str) -> tuple[Verdict, tuple[str, ...]]:
    """The verdict on an answer, and what is said to it."""
    judged = mark(exercise, exercise.parts[0], answer)
    return judged.verdict, judged.remarks


@pytest.mark.parametrize("format_", ["table", "json", "latex", "matlab", "numpy", "csv", "sympy"])
@pytest.mark.parametrize("joints", ["--symbolic", "--q=0.3,0.4"])
def test_what_dhcli_prints_is_an_answer(format_: str, joints: str, capsys: pytest.CaptureFixture[str]) -> None:
    """Copied from the screen, in numbers and in symbols, with the lines that stand around the matrix."""
    task = ["planar-2r", joints, "--set", "a1=0.4", "--set", "a2=0.3"]
    assert main(["fk", *task, "--format", format_]) == 0
    assert main(["check", *task, "--answer", capsys.readouterr().out]) == 0


@pytest.mark.parametrize(
    "answer",
    [
        NAMED,
        "nx=c12, ny=s12, nz=0, ox=-s12, oy=c12, oz=0, ax=0, ay=0, az=1, px=a1c1+a2c12, py=a1s1+a2s12, pz=0",
        '{"matrix": [["c12", "-s12", 0, "a1c1+a2c12"], ["s12", "c12", 0, "a1s1+a2s12"], [0, 0, 1, 0], [0, 0, 0, 1.0]]}',
        "syms a1 a2 theta1 theta2 real\n" + "T = [c12 -s12 0 a1c1+a2c12; s12 c12 0 a1s1+a2s12; 0 0 1 0; 0 0 0 1];",
    ],
)
def test_entries_by_name_make_the_matrix(pose: Exercise, answer: str) -> None:
    """In any order, on lines of their own or not, broken over lines; n, o and a are the columns of the rotation."""
    assert remarks(pose, answer) == (Verdict.RIGHT, ())


@pytest.mark.parametrize("filler", ["\n", " ", ",", "\n ", ",x", "r11 = ", "syms ", "... "])
def test_a_long_answer_of_nothing_is_gone_through_once(pose: Exercise, filler: str) -> None:
    """As long as an answer may be; where blanks were tried again from each of them, this took many minutes."""
    verdict, _ = remarks(pose, filler * (LARGEST // len(filler)))
    assert verdict in (Verdict.CANNOT_READ, Verdict.SKIPPED)


@pytest.mark.parametrize(
    "answer",
    ["0,5; -0,25; 0", "0,5 -0,25 0", "[0,5; -0,25; 0]", "(0,5; -0,25; 0)", "0,5\n-0,25\n0", "50,0 cm; -25,0 cm; 0"],
)
def test_decimal_commas_are_read_where_they_can_separate_nothing(position: Exercise, answer: str) -> None:
    """Three pieces between semicolons, blanks or line ends, and the commas inside them."""
    judged = mark(position, position.parts[0], answer)
    assert [float(cell.typed.removesuffix(" cm")) for cell in judged.cells] in ([0.5, -0.25, 0], [50, -25, 0])


@pytest.mark.parametrize(
    ("answer", "remark"),
    [
        ("a1 c1 + a2 c12; a1 s1 + a2 s12", "2 numbers are given, 3 were asked: is z missing?"),
        ("a1*c1, a1*s1", "2 numbers are given, 3 were asked: is z missing?"),
        ("a1", "1 number is given, 3 were asked"),
        ("1, 2, 3, 4, 5", "5 numbers are given, 3 were asked"),
        ("1; 2; 3, 4", "row 3 has 2 cells where others have 1"),
        ("0,449, 0,4819, 0", "if 0,449 is one number, write 0.449: decimals take a point"),
        ("0,449; 0,4819", "if 0,449 is one number, write 0.449: decimals take a point"),
        ("a1*c1; a1*s1; _", "some entries are still blank: fill in every _"),
    ],
)
def test_a_vector_that_is_none_is_told_what_is_missing(position: Exercise, answer: str, remark: str) -> None:
    """How many numbers are there and how many were asked; decimal commas that may separate are not guessed at."""
    judged = mark(position, position.parts[0], answer)
    assert judged.verdict is Verdict.CANNOT_READ
    assert remark in "; ".join(judged.remarks)


@pytest.mark.parametrize(
    ("part", "answer"), [("gruebler", "F = λ(n-1-j)+ j f"), ("gruebler", "λ = λ(n-1-j)+ jf"), ("links", "n = +7")]
)
def test_a_label_may_stand_before_one_value(part: str, answer: str) -> None:
    """Whatever its first character is."""
    assert check(load_exercise("counting-freedoms"), part, answer).verdict is Verdict.RIGHT


@pytest.mark.parametrize(
    ("exercise", "part", "answer", "hint"),
    [
        ("dh-rules", "cosine", "cosα", "did you mean alpha_i?"),
        ("wpi/puma560-table", "general", "cos(theta) 0 0 0; 0 1 0 0; 0 0 1 0; 0 0 0 1", "did you mean theta_i or"),
        ("planar-two-links", "a1", "a*c1 0 0 0; 0 1 0 0; 0 0 1 0; 0 0 0 1", "did you mean a1 or a2?"),
    ],
)
def test_a_name_without_its_index_is_suggested_with_it(exercise: str, part: str, answer: str, hint: str) -> None:
    """Suggested, not guessed; the general one before those of single joints."""
    judged = check(load_exercise(exercise), part, answer)
    assert judged.verdict is Verdict.CANNOT_READ
    assert hint in judged.remarks[0]


def test_a_table_that_is_half_filled_in_says_so() -> None:
    """As a matrix does."""
    judged = check(load_exercise("planar-two-links"), "table", "a1 0 0 θ1\na2 0 0 _")
    assert judged.remarks == ("some entries are still blank: fill in every _",)


@pytest.mark.parametrize(
    ("answer", "remark"),
    [
        (NAMED.replace("r13 = 0\n", ""), "r13 is missing"),
        ("px = a1c1 + a2c12; py = a1s1 + a2s12", "r11, r12, r13, r21, r22, r23, r31, r32, r33, pz are missing"),
        ("r11 = c12, r11 = c12", "r11 stands there twice"),
        (NAMED.replace("-s12", "-s13"), "s13 is not a name"),
        ('{"matrix": [[1, {}]]}', "a number, a name or a bracket was expected"),
        ('{"matrix": ' + "[" * 5000, "more than 2000 characters"),
    ],
)
def test_what_is_wrong_in_a_list_of_entries_is_said(pose: Exercise, answer: str, remark: str) -> None:
    """By the names of the entries."""
    verdict, said = remarks(pose, answer)
    assert verdict is Verdict.CANNOT_READ
    assert remark in said[0]


@pytest.mark.parametrize(
    "answer", ["x = 0.7 y = 0 z = 0", "x=0.7 y=0 z=0", "px = 0.7  py = 0  pz = 0", "p ≈ (0.7, 0, 0)", "≈ 0.7, 0, 0"]
)
def test_coordinates_may_have_names_between_blanks_and_be_about_right(position: Exercise, answer: str) -> None:
    """As a calculator is copied."""
    assert remarks(position, answer)[0] is Verdict.RIGHT


def test_rows_that_run_together_are_told_apart_by_nobody(pose: Exercise) -> None:
    """Sixteen cells in one row are no matrix yet."""
    verdict, said = remarks(pose, "c12 -s12 0 0 s12 c12 0 0 0 0 1 0 0 0 0 1")
    assert verdict is Verdict.CANNOT_READ
    assert said == ("all 16 cells stand in one row; a 4x4 matrix was asked: put ; or a line end behind each row",)


@pytest.mark.parametrize(
    "answer",
    [
        "［c12，－s12，0，a1*c1 + a2*c12；s12，c12，0，a1*s1 + a2*s12；0，0，1，0；0，0，0，1］",
        "[𝑐12 −𝑠12 0 𝑎1*𝑐1+𝑎2*𝑐12; 𝐬12 𝐜12 0 𝑎1*𝑠1+𝑎2*𝑠12; 𝟎 0 1 0; 0 0 0 𝟏]",
        "[cos(𝜃1+𝜃2), -sin(𝜃1+𝜃2), 0, a1 cos 𝜃1 + a2 c12; s12, c12, 0, a1 s1 + a2 s12; 0,0,1,0; 0,0,0,1]",
        "((c12,-s12,0,a1*c1+a2*c12),(s12,c12,0,a1*s1+a2*s12),(0,0,1,0),(0,0,0,1))",
        "(c12 -s12 0 a1*c1+a2*c12; s12 c12 0 a1*s1+a2*s12; 0 0 1 0; 0 0 0 1)",
        "mat(c12, -s12, 0, a1*c1+a2*c12; s12, c12, 0, a1*s1+a2*s12; 0,0,1,0; 0,0,0,1)",
        "c12;-s12;0;a1*c1+a2*c12\ns12;c12;0;a1*s1+a2*s12\n0;0;1;0\n0;0;0;1",
        "[cos(½(2θ1+2θ2)) -s12 0 a1*c1+a2*c12; s12 c12 0 a1*s1+a2*s12; 0 0 1 0; 0 0 0 1]",
    ],
)
def test_letters_of_papers_wide_signs_and_round_brackets_are_read(pose: Exercise, answer: str) -> None:
    """As they are pasted from a PDF, typed on a keyboard of wide letters, and by programs."""
    assert check(pose, pose.parts[0].id, answer).verdict is Verdict.RIGHT


@pytest.mark.parametrize(
    "answer",
    [
        "⟨a1 c1 + a2 c12, a1 s1 + a2 s12, 0⟩",
        "(a1c1+a2c12)î + (a1s1+a2s12)ĵ",
        "[a1*c1+a2*c12, a1*s1+a2*s12, 0]ᵀ",
    ],
)
def test_signs_of_vectors_are_read(position: Exercise, answer: str) -> None:
    """Angle brackets, hats and a raised T."""
    mark_ = check(position, position.parts[0].id, answer)
    assert mark_.verdict is not Verdict.CANNOT_READ, mark_.remarks


def test_a_look_alike_letter_is_still_named(pose: Exercise) -> None:
    """A Cyrillic letter is no styled Latin one."""
    found = check(pose, pose.parts[0].id, "[с12 -s12 0 0; s12 c12 0 0; 0 0 1 0; 0 0 0 1]")
    assert found.verdict is Verdict.CANNOT_READ


def test_a_bracket_that_is_never_closed_is_told(pose: Exercise) -> None:
    """It is what is wrong, whatever else cannot be read then."""
    found = check(pose, pose.parts[0].id, "[0.25 -0.96 0 0\n0.96 0.25 0 0\n0 0 1 0\n0 0 0 1")
    assert "this [ is never closed" in found.remarks[0]


@pytest.mark.parametrize(
    "answer",
    [
        "0,2588; -0,9659; 0; 0,4241\n0,9659; 0,2588; 0; 0,4898\n0; 0; 1; 0\n0; 0; 0; 1",
        "[≈0.2588 ≈-0.9659 0 0.4241; 0.9659 0.2588 0 0.4898; 0 0 1 0; 0 0 0 1]",
        "０．２５８８　－０．９６５９　０　０．４２４１；0.9659　0.2588 0 ０．４８９８；0 0 1 0；0 0 0 １",
    ],
)
def test_numbers_of_other_keyboards_are_read(answer: str) -> None:
    """Wide digits, decimal commas between semicolons in lines, and a sign of about before a number."""
    assert check(load_exercise("yim/planar-in-numbers"), "t02", answer).verdict is Verdict.RIGHT


@pytest.mark.parametrize(
    ("answer", "verdict"),
    [
        ("R = [c12 -s12 0; s12 c12 0; 0 0 1], p = [a1c1 + a2c12; a1s1 + a2s12; 0]", Verdict.RIGHT),
        ("R02 = [[c12, -s12, 0], [s12, c12, 0], [0, 0, 1]] and d02 = [a1*c1+a2*c12, a1*s1+a2*s12, 0]^T", Verdict.RIGHT),
        ("R = [c12 s12 0; -s12 c12 0; 0 0 1], p = [a1c1 + a2c12; a1s1 + a2s12; 0]", Verdict.WRONG),
        ("R = [c12 -s12 0; s12 c12 0; 0 0 1]", Verdict.CANNOT_READ),
        ("R = [c12 -s12 0; s12 c12 0; 0 0 1], p = [a1c1 + a2c12; a1s1 + a2s12]", Verdict.CANNOT_READ),
    ],
)
def test_a_pose_may_be_its_rotation_and_its_position(pose: Exercise, answer: str, verdict: Verdict) -> None:
    """Beside each other, by their names."""
    assert remarks(pose, answer)[0] is verdict
