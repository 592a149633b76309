"""Slips about motion: two at once are named together, and what follows from an earlier slip keeps its credit."""

from __future__ import annotations

import math
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from random import Random
from typing import Any

import pytest

from dhcli.algebra.floats import Floats
from dhcli.checking.exercise import Case, Exercise, Part
from dhcli.checking.judge import Judge
from dhcli.checking.kinds.made import question_about
from dhcli.checking.kinds.registry import read_question
from dhcli.checking.marked import SheetMark
from dhcli.checking.motion import differentiated, grid
from dhcli.checking.motion.from_columns import ColumnsQuestion
from dhcli.checking.verdicts import Verdict
from dhcli.files.yaml.exercises import load_exercise, read_exercise
from dhcli.files.yaml.robots import load_robot
from dhcli.kinematics.forward import forward
from dhcli.kinematics.values import joint_values
from dhcli.notation.tree import Expr, Symbol, number
from tests.nightly import NIGHT, paired, some

MOTION = Path(__file__).parents[3] / "exercises" / "motion"


@cache
def asked(robot: str, ask: str, q: tuple[float, ...] | None) -> Judge:
    """The judge of one question, in numbers where joint values are given; it is made once for all tests."""
    arm = load_robot(robot)
    given = joint_values(arm, list(q)) if q is not None else {}
    return Judge(question_about(arm, ask, numeric=q is not None, given=given))


Q = (0.4, 0.7, -1.1)


PAIRS = [
    ("jacobian of 0..3", ("in-frame 3", "reference 2")),
    ("jacobian of 0..3", ("in-frame 3", "angular-dropped")),
    ("jacobian of 0..3", ("cross-reversed", "rows-swapped")),
    ("jacobian linear of 0..3", ("origin-not-subtracted", "columns-reversed")),
    ("jacobian linear of 0..3", ("joint-left-out theta1", "joint-left-out theta3")),
    ("torques for (3, -2, 5) of 0..3", ("reference 2", "sign")),
    ("joint rates for (0.1, 0.2, 0.3) of 0..3", ("in-frame 3", "transpose-for-inverse")),
]


@pytest.mark.parametrize(("asked_for", "q"), paired(PAIRS, [None, Q]))
def test_two_slips_are_named_together(asked_for: tuple[str, tuple[str, str]], q: tuple[float, ...] | None) -> None:
    """Where neither alone gives the answer; in numbers and in symbols."""
    ask, pair = asked_for
    judge = asked("articulated", ask, q)
    part = judge.exercise.parts[0]
    case, question = Case(part, judge.memo), part.question
    assert isinstance(question, ColumnsQuestion)
    made = next(one for one in question.pairs(case) if tuple(slip.name for slip in one.slips) == pair)
    mark = judge.check(part, question.text(case, made.grid))
    assert mark.verdict is Verdict.WRONG
    assert mark.diagnosis is not None
    assert " + ".join(pair) in mark.diagnosis.ids


def test_two_slips_differentiate_the_position_once_for_each_wrong_rule(monkeypatch: pytest.MonkeyPatch) -> None:
    """Whatever went wrong in the columns before; and an entry that tables have in common is evaluated once."""
    counted: list[str] = []
    velocities, value = differentiated._velocities, Floats.value

    def counting(*given: Any) -> Any:  # noqa: ANN401  as it is called
        counted.append("position")
        return velocities(*given)

    def valued(over: Floats, expr: Expr) -> float:
        counted.append("entry")
        return value(over, expr)

    monkeypatch.setattr(differentiated, "_velocities", counting)
    monkeypatch.setattr(Floats, "value", valued)
    judge = asked("ur5e", "jacobian of 0..6", (0.4, 0.7, -1.1, 0.3, 0.9, -0.2))
    part = judge.exercise.parts[0]
    assert isinstance(part.question, ColumnsQuestion)
    found = part.question.pairs(Case(part, judge.memo))
    assert len(found) > 400
    assert counted.count("position") == 2
    assert counted.count("entry") < len(found) * 36


def test_values_of_entries_are_remembered_and_not_without_end(monkeypatch: pytest.MonkeyPatch) -> None:
    """Each is that of the tree, however many came before it and were let go."""
    monkeypatch.setattr(grid, "MOST_MET", 3)
    over, plain = grid.Remembering({"a": 0.4}), Floats({"a": 0.4})
    entries = [Symbol("a") * number(k) for k in range(2, 9)]
    for expr in (*entries, *entries, *reversed(entries)):
        assert over.value(expr) == plain.value(expr)
        assert len(over._met) <= 3


@pytest.mark.parametrize(
    ("answer", "words"),
    [
        ("-a1*s1 - a2*s12, a1*c1 + a2*c2, 0", "entry (2,1) has c2 for c12"),
        ("-a1*s1 + a2*s12, a1*c1 + a2*c12, 0", "the sign of a2*s12 in entry (1,1) is turned round"),
        ("-a1*s1 - a2*s12, a1*c1, 0", "entry (2,1) lacks a2*c12"),
        ("-a1*s1 - a2*s12, -a1*c1 - a2*c12, 0", "the sign of entry (2,1) is turned round"),
        ("-a1*s1 - a1*s12, a1*c1 + a1*c12, 0", "entries (1,1) and (2,1) have a1 for a2"),
        ("-a1*s1 - a2*s1*s2, a1*c1 + a2*c1*c2, 0", "entries (1,1) and (2,1) have s1*s2 for s12 and c1*c2 for c12"),
    ],
)
def test_slips_in_the_terms_of_an_entry_are_named(answer: str, words: str) -> None:
    """As in a pose; the entry is told by its place in the whole Jacobian."""
    judge = asked("planar-2r", "column 1 of jacobian linear of 0..2", None)
    found = judge.check(judge.exercise.parts[0], answer).diagnosis
    assert found is not None
    assert found.names == (words,)


@pytest.mark.parametrize(
    ("answer", "words"),
    [
        ("[0 s1 s1; 0 c1 c1; 1 0 0]", "the signs of entries (2,2) and (2,3) are turned round"),
        ("[0 s1 s1; 0 c1 c1; -1 0 0]", "the signs of entries (2,2), (2,3) and (3,1) are turned round"),
        ("[0 s1 s1; 0 s1 c1; 1 0 0]", None),
    ],
)
def test_signs_in_several_entries_are_named_together(answer: str, words: str | None) -> None:
    """Where all else is right."""
    judge = asked("articulated", "jacobian angular of 0..3", None)
    found = judge.check(judge.exercise.parts[0], answer).diagnosis
    if words is None:
        assert found is None or "signs of" not in " ".join(found.names)
    else:
        assert found is not None
        assert found.names == (words,)


@pytest.mark.parametrize(
    ("ask", "answer", "words"),
    [
        ("determinant of jacobian linear of 0..2", "a1*a2*s12", "the answer has s12 for s2"),
        ("determinant of jacobian linear of 0..2", "a1*a2*c2", "the answer has c2 for s2"),
        ("determinant of jacobian linear of 0..2", "a1^2*s2", "the answer has a1 for a2"),
        (
            "jacobian of 0..2",
            "[a1*c1+a2*c12 a2*c12; -a1*s1-a2*s12 -a2*s12; 0 0; 0 0; 0 0; 1 1]",
            "rows 1 and 2 have changed places",
        ),
    ],
)
def test_what_stands_for_something_else_of_the_robot_is_named(ask: str, answer: str, words: str) -> None:
    """An angle that is not in the right answer at all; of a single answer no row and column is told."""
    judge = asked("planar-2r", ask, None)
    found = judge.check(judge.exercise.parts[0], answer).diagnosis
    assert found is not None
    assert found.names == (words,)
    assert "(1,1)" not in " ".join(found.hints)


@pytest.mark.parametrize(
    ("answer", "words"),
    [
        ("[0.4679 -0.2989; -0.3364 -0.0261; 0 0; 0 0; 0 0; -1 1]", "column 1 has the opposite sign"),
        ("[-0.4679 0.2989; 0.3364 0.0261; 0 0; 0 0; 0 0; 1 1]", "rows 1 to 3 of column 2 have the opposite sign"),
        ("[-0.4679 -0.2989; 0.3364 -0.0261; 0 0; 0 0; 0 0; 1 -1]", "the sign of entry (6,2) is turned round"),
    ],
)
def test_a_column_that_is_turned_round_is_named_in_numbers(answer: str, words: str) -> None:
    """As a whole, or its v alone; one entry is that entry's sign."""
    judge = asked("planar-2r", "jacobian of 0..2", (math.radians(25), math.radians(70)))
    found = judge.check(judge.exercise.parts[0], answer).diagnosis
    assert found is not None
    assert found.names == (words,)


def test_a_slip_is_named_by_the_digits_typed() -> None:
    """The root is forgotten: 0.0127 is 0.012716 to three digits; 0.01 is too little for a name."""
    judge = asked("planar-2r", "manipulability of jacobian linear of 0..2", (0.4, 1.2217304763960306))
    part = judge.exercise.parts[0]
    assert judge.expected(part) == "0.11276"
    found = judge.check(part, "0.0127").diagnosis
    assert found is not None
    assert found.ids == ("root-forgotten",)
    assert judge.check(part, "0.01").diagnosis is None


def test_the_sign_of_one_number_of_several_is_seen() -> None:
    """In numbers too."""
    judge = asked("articulated", "torques for (3, -2, 5) of 0..3", Q)
    part = judge.exercise.parts[0]
    x, y, z = (float(text) for text in judge.expected(part).strip("[]").split(","))
    found = judge.check(part, f"{x}, {-y}, {z}").diagnosis
    assert found is not None
    assert found.ids == ("entry-sign 2,1",)


@pytest.mark.parametrize("ask", ["manipulability of jacobian linear of 0..3", "determinant of jacobian linear of 0..3"])
def test_one_number_is_too_little_for_two_slips(ask: str) -> None:
    """Some pair of hundreds gives nearly every number."""
    judge = asked("articulated", ask, Q)
    part = judge.exercise.parts[0]
    right = float(judge.expected(part))
    for share in some((0.31, 0.57, 0.73, 0.91, 1.21, 1.9), 3):
        found = judge.check(part, f"{right * share:.5f}").diagnosis
        assert found is None or all(len(cause) == 1 for cause in found.causes)


def test_two_slips_behind_one_number_are_named_by_its_digits() -> None:
    """54.098 is the pair's alone; 54 may be anything."""
    judge = judge_of("articulated-load")
    part = judge.exercise.part("w")
    found = judge.check(part, "54.098").diagnosis
    assert found is not None
    assert found.ids == ("sin-cos + reciprocal",)
    assert judge.check(part, "54").diagnosis is None


@pytest.mark.parametrize(("name", "part"), [("articulated-load", "w"), ("wrist-analytic", "rpy")])
def test_a_number_out_of_the_blue_hardly_ever_has_a_name(name: str, part: str) -> None:
    """However many digits it has: at most one in fifty."""
    judge, draw, tries = judge_of(name), Random(3), 200 if NIGHT else 100  # noqa: S311
    one, named = judge.exercise.part(part), 0
    right = float(judge.expected(one))
    for _ in range(tries):
        found = judge.check(one, f"{right * draw.uniform(-1.5, 1.5):.{draw.choice([3, 4, 5])}f}").diagnosis
        named += found is not None
    assert named <= tries / 50


@cache
def judge_of(name: str) -> Judge:
    """The judge of an exercise of the course."""
    return Judge(load_exercise(MOTION / f"{name}.yaml"))


def sheet(name: str, answers: Mapping[str, str]) -> SheetMark:
    """A sheet of an exercise of the course with right answers but for some."""
    judge = judge_of(name)
    right = {part.id: judge.expected(part) for part in judge.exercise.parts}
    return judge.sheet(right | answers)


FORGOTTEN = "-a1*s1, a1*c1, 0"
"""The first column of a planar arm, of somebody who has left the second link out."""

FOLLOWING = [
    ("planar-jacobian", {"column1": FORGOTTEN}, "whole", "[-a1*s1 -a2*s12; a1*c1 a2*c12; 0 0; 0 0; 0 0; 1 1]"),
    ("planar-jacobian", {"column2": "a2*s12, a2*c12, 0"}, "determinant",
     "-a2*c12*(a1*s1+a2*s12) - a2*s12*(a1*c1+a2*c12)"),
    ("planar-jacobian", {"determinant": "a1*a2*c2"}, "singular", "theta2 = ±90°"),
    ("scara-jacobian", {"v": "[-l2*c1 -l3*c12 0; -l2*s1 -l3*s12 0; 0 0 1]"}, "determinant", "l2*l3*s2"),
    ("planar-two-frames", {"base": "[a1*s1+a2*s12 a2*s12; a1*c1+a2*c12 a2*c12; 0 0]"}, "torques",
     "f_x*(a1*s1+a2*s12) + f_y*(a1*c1+a2*c12), f_x*a2*s12 + f_y*a2*c12"),
    ("five-bar-loop", {"crank": "a1*c2"}, "rates", "v_x/(a1*c2), (v_y - v_x*(a1*c2+a2)/(a1*c2))/a2"),
    ("wrist-angular", {"roll": "-c4*s5, -s4*s5, c5"}, "turning", "[0 -s4 -c4*s5; 0 c4 -s4*s5; 1 0 c5]"),
]  # fmt: skip


@pytest.mark.parametrize(("name", "slip", "part", "answer"), FOLLOWING)
def test_what_follows_rightly_from_a_slip_keeps_its_credit(
    name: str, slip: Mapping[str, str], part: str, answer: str
) -> None:
    """And says where the slip is; without it the same answer is wrong."""
    marks = {one.part.id: one.mark for one in sheet(name, {**slip, part: answer}).parts}
    (cause,) = slip
    assert marks[cause].verdict is Verdict.WRONG
    assert marks[part].diagnosis is not None
    assert marks[part].diagnosis.follows == (cause,)
    assert marks[part].earned == 1
    alone = {one.part.id: one.mark for one in sheet(name, {part: answer}).parts}[part]
    assert alone.earned < 1


def test_numbers_that_follow_from_wrong_numbers_keep_their_credit() -> None:
    """Velocities from a Jacobian with one wrong sign; from one of zeros nothing follows."""
    asked_ = read_exercise(
        "format: 1\ntitle: t\nsource: s\ntask: t\nrobot: planar-2r\nnumeric: true\n"
        "given: {theta1: 30°, theta2: 45°}\nparts:\n  - {id: j, ask: jacobian linear of 0..2}\n"
        "  - {id: v, ask: 'velocity of 0..2 with rates (1, 2)', depends: [j]}\n",
        "e",
        "e",
    )
    judge = Judge(asked_)
    marks = judge.sheet({"j": "-0.4898 -0.2898; 0.4241 -0.0776; 0 0", "v": "-1.0693, 0.2688, 0"}).parts
    assert marks[1].mark.diagnosis is not None
    assert (marks[1].mark.diagnosis.follows, marks[1].mark.earned) == (("j",), 1)
    marks = judge.sheet({"j": "0 0; 0 0; 0 0", "v": "0, 0, 0"}).parts
    assert (marks[1].mark.verdict, marks[1].mark.earned) == (Verdict.WRONG, 0)


def geometric(robot: str, q: tuple[float, ...]) -> list[list[float]]:
    """The Jacobian of an arm whose joints all turn, from axes and origins of its link frames."""
    arm, total = load_robot(robot), len(q)
    frames = [forward(arm, list(q), start="0", end=str(k)).matrix for k in range(total + 1)]
    columns = []
    for k in range(total):
        z, o, p = ([frames[i][r][c] for r in range(3)] for i, c in ((k, 2), (k, 3), (total, 3)))
        arm_of = [b - a for a, b in zip(o, p, strict=True)]
        columns.append([*(z[i - 2] * arm_of[i - 1] - z[i - 1] * arm_of[i - 2] for i in range(3)), *z])
    return [list(row) for row in zip(*columns, strict=True)]


@pytest.mark.parametrize(
    ("q", "name"),
    [
        ((-Q[0], Q[1], Q[2]), "theta-sign theta1"),
        ((Q[0], -Q[1], Q[2]), "theta-sign theta2"),
        ((Q[0], Q[1], -Q[2]), "theta-sign theta3"),
        (tuple(math.radians(angle) for angle in Q), "thetas-unit"),
    ],
)
def test_joint_angles_that_are_not_those_of_the_task_are_named_and_torques_from_there_keep_credit(
    q: tuple[float, ...], name: str
) -> None:
    """The angle of one joint counts the other way, or a calculator takes radians for degrees."""
    arm = load_robot("articulated")
    values = joint_values(arm, list(Q))
    parts = tuple(
        Part(text.split()[0], read_question(text, arm.scope), depends=before)
        for text, before in (("jacobian of 0..3", ()), ("torques for (3, -2, 5) of 0..3", ("jacobian",)))
    )
    rows = geometric("articulated", q)
    torques = [sum(row[k] * force for row, force in zip(rows, (3, -2, 5), strict=False)) for k in range(3)]
    answers = {
        "jacobian": "; ".join(" ".join(f"{x:.4f}" for x in row) for row in rows),
        "torques": ", ".join(f"{x:.4f}" for x in torques),
    }
    first, second = (
        one.mark for one in Judge(Exercise("e", "", "", "", parts, arm, values, numeric=True)).sheet(answers).parts
    )
    assert first.diagnosis is not None
    assert first.diagnosis.ids == (name,)
    assert (second.verdict, second.earned) == (Verdict.WRONG, 1)
    assert second.diagnosis is not None
    assert second.diagnosis.follows == ("jacobian",)
