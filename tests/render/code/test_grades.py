"""The grades of a class on screen and in files: nothing that a student wrote does anything there."""

from __future__ import annotations

import csv
import io
import json
from itertools import starmap

import pytest

from dhcli.checking.verdicts import Verdict
from dhcli.classroom.folder import Folder
from dhcli.classroom.grades import Graded, PartGrade
from dhcli.classroom.report import ClassReport, report_on
from dhcli.errors import Place, Problem
from dhcli.render.kinds import render
from dhcli.render.look import Look
from dhcli.render.paper import Paper
from dhcli.safe import csv_cell
from tests.row_by_row import row_by_row

ESCAPES = "\x1b[2J\x07\x9b31m\u202e"


def report(*rows: Graded) -> ClassReport:
    """The report of a class that handed in these sheets."""
    return report_on(Folder("class", (), ()), rows)


def cells(*rows: Graded) -> list[dict[str, str]]:
    """The CSV file of a class, as a program reads it."""
    return list(csv.DictReader(io.StringIO(render("class", report(*rows), Look("csv")))))


@row_by_row(
    "text", ["=1+1", "+1", "-1", "@SUM(A1)", "\t=1", "\r=1", "\n=1", " =1", "＝1", "\u200b=1+1", "\ufeff\u00ad@x"]
)
def test_no_text_of_a_student_is_a_formula(text: str) -> None:
    """An apostrophe stands before it; what would begin a line or move the cell is a blank."""
    (row,) = cells(Graded(text, text, text, text, problems=(Problem(text),)))
    expected = Paper().spell(f"'{text}")
    assert [row[key] for key in ("student", "sheet", "exercise", "variant", "problem")] == [expected] * 5


@pytest.mark.parametrize("text", ["", "no. 17", "a=b", "5-1", 'ü, "x"; y'])
def test_other_texts_stay_as_they_are(text: str) -> None:
    """Quotes and commas are read back."""
    assert csv_cell(text) == text
    (row,) = cells(Graded("a.yaml", text))
    assert row["student"] == text


def test_numbers_of_ours_stay_numbers() -> None:
    """A penalty is negative and no formula; a sheet without a grade has no numbers at all."""
    good, bad = cells(
        Graded("1", "1", "x/y", "", (PartGrade("a", Verdict.WRONG, -0.5, 2.0), PartGrade("b", Verdict.RIGHT, 1, 1))),
        Graded("2", "2", problems=(Problem("is empty", Place("2", 3, 1)),)),
    )
    assert (good["a verdict"], good["a earned"], good["b earned"]) == ("WRONG", "-0.5", "1.0")
    assert (good["earned"], good["credit"], good["problem"]) == ("0.5", "3.0", "")
    assert (bad["a earned"], bad["earned"], bad["credit"], bad["problem"]) == ("", "", "", "2:3:1: is empty")


def test_a_part_of_another_exercise_has_no_cell() -> None:
    """The columns are those of all exercises."""
    first, second = cells(
        Graded("1", "1", "x/y", "", (PartGrade("a", Verdict.RIGHT, 1, 1),)),
        Graded("2", "2", "x/z", "", (PartGrade("b", Verdict.RIGHT, 1, 1),)),
    )
    assert (first["a verdict"], first["b verdict"]) == ("RIGHT", "")
    assert (second["a verdict"], second["b verdict"]) == ("", "RIGHT")


@pytest.mark.parametrize("name", ["table", "csv", "gradescope"])
def test_nothing_steers_a_terminal(name: str) -> None:
    """Names, slips, remarks and problems come from students."""
    rows = [
        Graded(ESCAPES, ESCAPES, "x/y", ESCAPES, (PartGrade("a", Verdict.WRONG, 0, 1, *[ESCAPES], *[(ESCAPES,)] * 2),)),
        Graded(ESCAPES, ESCAPES, problems=(Problem(ESCAPES),)),
    ]
    texts = [render("class", report(row), Look(name)) for row in rows]
    texts = [json.dumps(json.loads(text), ensure_ascii=False) for text in texts] if name == "gradescope" else texts
    assert not [letter for letter in ESCAPES if not letter.isprintable() and letter in "".join(texts)]


def test_the_page_in_ascii_is_ascii() -> None:
    """Bars too."""
    text = render("class", report(Graded("1", "é", "x/y", "", (PartGrade("a", Verdict.RIGHT, 1, 1),))), LOOK_ASCII)
    assert text.isascii()
    assert "100 %   # 1" in text


LOOK_ASCII = Look(paper=Paper(unicode=False))


@pytest.mark.parametrize(("sheets", "longest"), [(3, 3), (30, 30), (3000, 30)])
def test_a_bar_is_as_long_as_its_count_until_there_is_no_room(sheets: int, longest: int) -> None:
    """And one sheet among thousands can still be seen."""
    one = Graded("1", "1", "x/y", "", (PartGrade("a", Verdict.WRONG, 0, 1),))
    many = Graded("2", "2", "x/y", "", (PartGrade("a", Verdict.RIGHT, 1, 1),))
    text = render("class", report(one, *[many] * sheets), LOOK_ASCII)
    assert f"100 %   {'#' * longest} {sheets}\n" in text
    assert "0-19 %   # 1\n" in text


def test_a_long_text_is_folded_on_a_terminal_only() -> None:
    """What is piped can be searched line by line."""
    slip = " ".join(["word"] * 30)
    rows = report(Graded("1", "1", "x/y", "", (PartGrade("a", Verdict.WRONG, 0, 1, slips=(slip,)),)))
    assert f" a   1 of 1   {slip}\n" in render("class", rows, Look())
    text = render("class", rows, Look(paper=Paper(width=60, terminal=True)))
    assert max(map(len, text.split("\n"))) < 60
    assert " ".join(text.split()).count("word") == 30


def test_results_of_gradescope_have_the_fields_of_its_specification() -> None:
    """`score` and `tests`, each with a score, its maximum, a name and what the student reads."""
    parts = list(
        starmap(
            PartGrade,
            [
                ("a", Verdict.RIGHT, 2.0, 2.0, "[1]"),
                ("b", Verdict.WRONG, 0.5, 1.0, "[2]", ("a remark",), ("a slip",)),
                ("c", Verdict.SKIPPED, 0.0, 1.0),
                ("d", Verdict.WRONG, 1.0, 1.0, "[3]", ("right from your a",)),
            ],
        )
    )
    found = json.loads(render("class", report(Graded("1", "1", "x/y", "", tuple(parts))), Look("gradescope")))
    common = {"visibility": "visible", "output_format": "text"}
    assert found == {
        "score": 3.5,
        "stdout_visibility": "hidden",
        **common,
        "tests": [
            {"name": "a", "score": 2.0, "max_score": 2.0, "status": "passed", **common}
            | {"output": "✓ RIGHT\nI read this as: [1]"},
            {"name": "b", "score": 0.5, "max_score": 1.0, "status": "failed", **common}
            | {"output": "✗ WRONG\nI read this as: [2]\na remark"},
            {"name": "c", "score": 0.0, "max_score": 1.0, **common, "output": "– SKIPPED"},
            {"name": "d", "score": 1.0, "max_score": 1.0, **common}
            | {"output": "✗ WRONG\nI read this as: [3]\nright from your a"},
        ],
    }


def test_a_sheet_that_was_not_graded_scores_nothing_and_says_why() -> None:
    """Its student can mend it, where a failed autograder would tell nothing."""
    found = json.loads(render("class", report(Graded("1", "1", problems=(Problem("is empty"),))), Look("gradescope")))
    assert (found["score"], found["tests"]) == (0.0, [])
    assert found["output"] == "this sheet could not be graded\nis empty"
