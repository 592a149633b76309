"""When an answer that is typed line by line is judged: where it is plainly complete, and not before."""

from __future__ import annotations

import pytest

from dhcli.checking.judge import check
from dhcli.checking.verdicts import Verdict
from tests.judging import expected
from tests.once import load_exercise
from tests.row_by_row import row_by_row

EXERCISES = (
    "bajd/scara-pose-in-m",
    "bajd/scara-as-dh-table",
    "inverse/planar-joints",
    "inverse/planar-joints-in-numbers",
    "inverse/planar-reach",
    "motion/articulated-jacobian",
    "motion/articulated-load",
    "motion/differential-motion",
    "motion/planar-jacobian",
    "motion/planar-rates-in-numbers",
    "yim/counting-freedoms",
    "yim/dh-factors",
    "yim/planar-two-links",
    "zhou/three-r-arm-modified",
)
LOAD, SCARA = "motion/articulated-load", "bajd/scara-pose-in-m"
PLANAR, JACOBIAN, JOINTS = "yim/planar-two-links", "motion/planar-jacobian", "inverse/planar-joints-in-numbers"


@row_by_row("name", EXERCISES)
def test_every_solution_in_one_line_is_whole(name: str) -> None:
    """In brackets or with separators, of every kind of question."""
    exercise = load_exercise(name)
    for part in exercise.parts:
        assert part.question.is_whole(expected(exercise, part), part.question.blank(exercise)), part.id


@row_by_row("name", EXERCISES)
def test_a_matrix_by_lines_is_not_whole_before_its_end(name: str) -> None:
    """An empty line ends it, as the last row may be followed by another one."""
    exercise = load_exercise(name)
    for part in exercise.parts:
        rows, columns = part.question.blank(exercise)
        if not part.question.in_rows or min(rows, columns) == 1:
            continue
        text = expected(exercise, part)
        lines = [row.replace(", ", " ") for row in text.strip("[]").replace("], [", "; ").split("; ")]
        assert len(lines) == rows
        for count in range(1, rows + 1):
            assert not part.question.is_whole("\n".join(lines[:count]), (rows, columns)), (part.id, count)


@row_by_row(
    ("name", "part", "text", "is_whole"),
    [
        (PLANAR, "a1", "answer [c1 -s1 0 a1c1; s1 c1 0 a1s1; 0 0 1 0; 0 0 0 1]", True),
        (PLANAR, "a1", "T = [c1 -s1 0 a1c1; s1 c1 0 a1s1; 0 0 1 0; 0 0 0 1]", True),
        (PLANAR, "a1", "T = [c1 -s1 0 a1c1; s1 c1 0 a1s1;", False),
        (PLANAR, "a1", "A_1 = np.array([[c1, -s1, 0, a1*c1], [s1, c1, 0, a1*s1], [0, 0, 1, 0], [0, 0, 0, 1]])", True),
        (PLANAR, "d02", "p = (a1 c1 + a2 c12, a1 s1 + a2 s12, 0)", True),
        (PLANAR, "d02", "(a1 c1 + a2 c12, a1 s1 + a2 s12, 0)", True),
        (PLANAR, "d02", "(a1 c1 + a2 c12, a1 s1 +", False),
        (PLANAR, "table", "DH [a1 0 0 t1; a2 0 0 t2]", True),
        (PLANAR, "table", "a1 0 0 t1", False),
        (JACOBIAN, "whole", "-a1 s1 - a2 s12, -a2 s12", False),
        (JACOBIAN, "whole", "-a1*s1-a2*s12 -a2*s12; a1*c1+a2*c12 a2*c12; 0 0; 0 0; 0 0; 1 1", True),
        (JACOBIAN, "whole", "Jv = [-a1*s1-a2*s12 -a2*s12; a1*c1+a2*c12 a2*c12; 0 0]", False),
        (JACOBIAN, "whole", "Jv = [-a1s1-a2s12, -a2s12; a1c1+a2c12, a2c12; 0, 0]", False),
        (JACOBIAN, "whole", "Jv = [[-a1*s1-a2*s12, -a2*s12], [a1*c1+a2*c12, a2*c12], [0, 0]]", False),
        (JACOBIAN, "whole", "Jv = [-a1*s1-a2*s12 -a2*s12; a1*c1+a2*c12 a2*c12; 0 0]\nJw = [0 0; 0 0; 1 1]", True),
        ("motion/scara-jacobian", "first", "v = (-l2c1-l3c12, -l2s1-l3s12, 0)", False),
        ("motion/scara-jacobian", "first", "v = (-l2c1-l3c12, -l2s1-l3s12, 0), ω = (0, 0, 1)", True),
        (PLANAR, "t02", "R = [c12 -s12 0; s12 c12 0; 0 0 1]", False),
        (PLANAR, "r02", "R = [c12 -s12 0; s12 c12 0; 0 0 1]", True),
        (JACOBIAN, "column1", "-a1 s1 - a2 s12, a1 c1 + a2 c12, 0", True),
        (JACOBIAN, "column1", "-a1 s1 - a2 s12", False),
        (JOINTS, "any", "2.48, 67.98", True),
        (JOINTS, "all", "2.48, 67.98", False),
        (JOINTS, "all", "2.48, 67.98; 59.45, -67.98", True),
        (JOINTS, "all", "(2.48, 67.98) or (59.45, -67.98)", True),
        ("motion/articulated-load", "load", "0 10.34 5.2", True),
        ("motion/articulated-load", "load", "0", False),
        ("bajd/scara-pose-in-m", "tool", "0.0435 0.399 0.25", True),
        ("bajd/scara-pose-in-m", "tool", "0.0435", False),
    ],
)
def test_brackets_separators_and_numbers_say_that_nothing_is_missing(
    name: str, part: str, text: str, *, is_whole: bool
) -> None:
    """A word or a name before a bracket leaves nobody waiting, and no first row is judged alone."""
    exercise = load_exercise(name)
    question = exercise.part(part).question
    assert question.is_whole(text, question.blank(exercise)) is is_whole


MATRIX = "[c1 -s1 0 a1c1; s1 c1 0 a1s1; 0 0 1 0; 0 0 0 1]"


@pytest.mark.parametrize(
    ("before", "verdict"),
    [
        ("answer ", Verdict.RIGHT),
        ("the matrix is ", Verdict.RIGHT),
        ("T01 ", Verdict.RIGHT),
        ("A1: ", Verdict.RIGHT),
        ("My answer is:\n", Verdict.RIGHT),
        ("A1 ", Verdict.CANNOT_READ),
        ("a1 ", Verdict.CANNOT_READ),
        ("transpose ", Verdict.CANNOT_READ),
        ("inv", Verdict.CANNOT_READ),
        ("diag", Verdict.CANNOT_READ),
        ("1*", Verdict.RIGHT),
        ("+", Verdict.RIGHT),
        ("c1 ", Verdict.CANNOT_READ),
    ],
)
def test_words_before_a_bracket_are_read_past_and_factors_are_not(before: str, verdict: Verdict) -> None:
    """A name of the task may be either, and is asked about; a word that does something is none of these."""
    found = check(load_exercise(PLANAR), "a1", before + MATRIX)
    assert found.verdict is verdict
    assert ("stands before the bracket" in " ".join(found.remarks)) == (before in ("A1 ", "a1 ", "c1 "))


@pytest.mark.parametrize(
    ("exercise", "part", "answer", "verdict"),
    [
        (LOAD, "load", "-[0, 10.3385, 5.1962]", Verdict.WRONG),
        (LOAD, "load", "-(0, -10.3385, -5.1962)", Verdict.RIGHT),
        (LOAD, "load", "2*(0, 5.16925, 2.5981)", Verdict.RIGHT),
        (SCARA, "tool", "-[[0.0435], [0.399], [0.25]]", Verdict.WRONG),
        (SCARA, "tool", "-[-0.0435; -0.399; -0.25]", Verdict.RIGHT),
        (SCARA, "tool", "- [0.0435]\n- [0.399]\n- [0.25]", Verdict.RIGHT),
        (SCARA, "heading", "-[-0.766 0.643 0; -0.643 -0.766 0; 0 0 -1]", Verdict.RIGHT),
        (SCARA, "heading", "-[0.766 -0.643 0; 0.643 0.766 0; 0 0 1]", Verdict.WRONG),
        (JACOBIAN, "column1", "-[a1*s1 + a2*s12; -a1*c1 - a2*c12; 0]", Verdict.RIGHT),
        (JACOBIAN, "column1", "-(a1*s1 + a2*s12), a1*c1 + a2*c12, 0", Verdict.RIGHT),
        (JACOBIAN, "column1", "a1*(-s1, c1, 0)", Verdict.WRONG),
    ],
)
def test_a_sign_or_a_factor_before_a_bracket_is_that_of_all_in_it(
    exercise: str, part: str, answer: str, verdict: Verdict
) -> None:
    """And is no bullet of a list with one item."""
    assert check(load_exercise(exercise), part, answer).verdict is verdict
