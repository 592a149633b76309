"""Answers pasted back: what dhcli printed in any format, and entries by their names."""

from __future__ import annotations

import pytest

from dhcli import load_robot
from dhcli.checking.exercise import Exercise, question_about
from dhcli.checking.marking import mark
from dhcli.checking.reading import LARGEST
from dhcli.checking.verdicts import Verdict
from dhcli.cli.main import main

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
    return question_about(load_robot("planar-2r"), "0", "2", numeric=False, given={})


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
