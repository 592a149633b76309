"""Whatever is asked about an author's own robot with numbers in its cells: what dhcli shows as right is right typed."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from dhcli.checking.exercise import Exercise
from dhcli.checking.judge import Judge
from dhcli.checking.verdicts import Verdict
from dhcli.files.yaml.exercises import load_exercise
from tests.nightly import paired

TURRET = """format: 1
title: A turret, a telescope and a wrist
source: made up
convention: modified
units: mm
variables: [q1, q2, q3]
parameters: {h: 320, b: 60}
links:
  - {a: 0, alpha: 0, d: h, theta: q1}
  - {a: b, alpha: 90°, d: q2 + 200, theta: 0}
  - {a: 80, alpha: -90°, d: 0, theta: q3}
"""
ELBOW = """format: 1
title: An elbow arm with an offset shoulder
source: made up
convention: standard
units: mm
variables: [q1, q2, q3]
parameters: {a2: 300}
links:
  - {a: 50, alpha: 90°, d: 400, theta: q1 + 90°}
  - {a: a2, alpha: 0, d: 0, theta: q2}
  - {a: 250, alpha: 0, d: 20, theta: q3}
"""
ASKS = (
    "table OWN",
    "frames OWN",
    "cell d 2",
    "factors 2",
    "link 1",
    "position of pose 0..3",
    "jacobian of 0..3",
    "jacobian space of 0..3",
    "column 1 of jacobian of 0..3",
    "velocity of 0..3",
    "velocity of 0..3 with rates (0.5, -1, 0.2)",
    "differential motion (0.002, 0, 0) turn (0, 0, 0.01) of 0..3",
    "angle q1 of pose",
    "joints of position (0.3, 0.2, 0.32)",
    "joints of position (0.3, 0.2, 0.32) all",
    "count solutions of position (0.3, 0.2, 0.32)",
)


def written(folder: Path, text: str, ask: str, unit: str) -> Exercise:
    """A question in letters about a robot beside it, on a sheet in some unit; the place asked for is in that unit."""
    for name in ("robots", "exercises"):
        (folder / name).mkdir(exist_ok=True)
    (folder / "robots" / "own.yaml").write_text(text, encoding="utf-8")
    place = re.sub(r"0\.[23]\d*(?=[,)] *)", lambda number: f"{float(number[0]) * (1000 if unit == 'mm' else 1):g}", ask)
    asked = (place if " position (" in ask else ask).replace("OWN", text.split("convention: ")[1].split(maxsplit=1)[0])
    path = folder / "exercises" / "about-own.yaml"
    head = f"format: 1\ntitle: t\nsource: s\nrobot: own\nunit: {unit}\nnames: [dq1, dq2, dq3]\ntask: t\n"
    path.write_text(f"{head}parts:\n  - {{id: p, ask: '{asked}', credit: 1}}\n", encoding="utf-8")
    return load_exercise(path)


@pytest.mark.parametrize(("ask", "unit"), paired(ASKS, ["m", "mm", "none"]))
@pytest.mark.parametrize("text", [TURRET, ELBOW], ids=["turret", "elbow"])
def test_the_solution_is_right_as_it_is_shown(tmp_path: Path, text: str, ask: str, unit: str) -> None:
    """In letters, with the numbers of the cells in the unit of the sheet, and joint values in numbers all the same."""
    exercise = written(tmp_path, text, ask, unit)
    judge, part = Judge(exercise), exercise.parts[0]
    assert judge.mark(part, judge.expected(part)).verdict is Verdict.RIGHT


def test_a_solution_is_told_in_the_unit_of_the_sheet(tmp_path: Path) -> None:
    """On a sheet in millimetres no step says 0.2 where the table says q2 + 200."""
    for ask in ("table OWN", "frames OWN", "cell d 2", "jacobian of 0..3", "position of pose 0..3"):
        exercise = written(tmp_path, TURRET, ask, "mm")
        told = " ".join(step.text for step in Judge(exercise).solution(exercise.parts[0]))
        told += " ".join(exercise.parts[0].question.notes(exercise))
        assert "200" in told, ask
        assert not re.search(r"\b0\.(2|08)\b", told), ask


def test_a_table_is_read_back_in_the_unit_of_the_sheet(tmp_path: Path) -> None:
    """What was typed as 180 mm is not read back as 0.18."""
    exercise = written(tmp_path, TURRET, "table OWN", "mm")
    mark = Judge(exercise).mark(exercise.parts[0], "0 0 h q1; b 90 q2+200 0; 180 -90 0 q3")
    assert mark.verdict is Verdict.WRONG
    assert mark.reading == "[[0, 0, h, q1], [b, 90°, q2 + 200, 0], [180, -90°, 0, q3]]"


def test_a_wrong_entry_of_a_jacobian_is_expected_in_the_unit_of_the_sheet(tmp_path: Path) -> None:
    """The right entry is one that could have been typed."""
    exercise = written(tmp_path, TURRET, "entry 1 1 of jacobian of 0..2", "mm")
    mark = Judge(exercise).mark(exercise.parts[0], "-b*s1 + c1*(q2 + 0.2)")
    assert mark.verdict is Verdict.WRONG
    assert mark.cells[0].expected == "-b*s1 + c1*(q2 + 200)"


@pytest.mark.parametrize(
    "answer",
    ["dq1*(c1*(q2+200) - b*s1) + dq2*s1", "200*dq1*c1 + dq1*c1*q2 - b*dq1*s1 + dq2*s1"],
    ids=["in brackets", "expanded"],
)
def test_numbers_beside_rates_are_lengths_of_the_sheet(tmp_path: Path, answer: str) -> None:
    """A rate dq1 is no length, so that the number beside it is one."""
    exercise = written(tmp_path, TURRET, "velocity of 0..2", "mm")
    typed = f"{answer}, dq1*(s1*(q2+200) + b*c1) - dq2*c1, 0"
    assert Judge(exercise).mark(exercise.parts[0], typed).verdict is Verdict.RIGHT


def test_a_shoulder_from_which_the_arm_is_too_short_is_no_slip(tmp_path: Path) -> None:
    """Of an arm with an offset shoulder not every pose is reached from behind; both angles are right all the same."""
    exercise = written(tmp_path, ELBOW, "angle q1 of position", "m")
    judge, part = Judge(exercise), exercise.parts[0]
    assert judge.mark(part, "atan2(py, px) ± acos(0.02/sqrt(px^2 + py^2))").verdict is Verdict.RIGHT
    assert judge.mark(part, "atan2(py, px) ± acos(0.03/sqrt(px^2 + py^2))").verdict is Verdict.WRONG
    assert judge.mark(part, "atan2(py, px) + acos(0.02/sqrt(px^2 + py^2))").verdict is Verdict.WRONG
