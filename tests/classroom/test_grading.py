"""Grading never stops: a sheet that cannot be graded is a row that says why."""

from __future__ import annotations

import os
from functools import partial
from pathlib import Path

import pytest

from dhcli.checking.verdicts import Verdict
from dhcli.classroom.folder import Submission, find_sheets
from dhcli.classroom.grades import Graded
from dhcli.classroom.grading import grade_all
from dhcli.classroom.marking import grade
from dhcli.errors import FileError
from dhcli.files.yaml.exercises import load_exercise
from dhcli.files.yaml.sheets import write_sheet
from tests.classroom.sheets import EXERCISE, RIGHT, WRONG, hand_in, sheet
from tests.classroom.workers import trouble
from tests.judging import expected, vary

MINE = "format: 1\ntitle: Mine\nsource: mine\ntask: One plus one.\nparts:\n  - {id: sum, ask: scalar 2}\n"


def graded(folder: Path, text: str | bytes, only: str | None = None) -> Graded:
    """The grades of one sheet."""
    return grade(Submission(str(hand_in(folder, "student/a.yaml", text)), "student/a.yaml", "student"), only)


def test_a_sheet_is_graded_against_its_exercise(tmp_path: Path) -> None:
    """A row of grades, one for each part, with what the student should know."""
    row = graded(tmp_path, sheet({"d02": WRONG, "blocks": "1"}))
    grades = {part.part: part for part in row.parts}
    assert (row.student, row.exercise, row.variant, row.problems) == ("student", EXERCISE, "", ())
    assert (grades["blocks"].verdict, grades["blocks"].earned, grades["blocks"].credit) == (Verdict.RIGHT, 1, 1)
    assert grades["d02"].verdict is Verdict.WRONG
    assert 0 < grades["d02"].earned < grades["d02"].credit
    assert any("yours gives" in remark for remark in grades["d02"].remarks)
    assert grades["t02"].verdict is Verdict.SKIPPED
    assert row.credit == sum(part.credit for part in row.parts) > row.earned > 1


def test_every_slip_that_explains_an_answer_is_counted(tmp_path: Path) -> None:
    """The likeliest first; the student is told where to look."""
    row = graded(tmp_path, "format: 1\nexercise: yim/counting-exceptions\nanswers:\n  bennetttrue: -2\n")
    (part,) = [one for one in row.parts if one.part == "bennetttrue"]
    assert part.slips == ("the formula is believed", "joints counted as links")
    assert part.remarks == ("go through what was counted: links with the ground, joints, and the freedoms of each",)


def test_the_name_on_the_sheet_comes_first(tmp_path: Path) -> None:
    """Cut where nobody's name is so long."""
    assert graded(tmp_path, sheet({}, name="no. 17") + "  d02: _\n").student == "no. 17"
    assert len(graded(tmp_path, sheet({"d02": "_"}, name="x" * 5000)).student) == 120


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        ("answers: [", "a value is missing here"),
        (b"\x00\x01\xff\xfe", "is not a text file"),
        (b"\xff\xfea\x00", "UTF-16"),
        ("", "is empty"),
        ("# nothing\n", "is empty"),
        ("x" * 300_000, "more than the 256 kB"),
        ("- a\n- b\n", "should be a mapping"),
        ("format: 1\nanswers: {d02: 0}\n", "exercise: is missing"),
        ("format: 1\nexercise: yim/planar-two-links\n", "answers: is missing"),
        ("format: 9\nanswers: {d02: 0}\n", "format 9 needs a newer dhcli"),
        (sheet({"d02": RIGHT}, "yim/planar-tow-links"), "there is no exercise 'yim/planar-tow-links'"),
        (sheet({"d02": RIGHT}, "y" * 5000), "there is no exercise 'yyy"),
        (sheet({"d99": RIGHT}), "has no part d99"),
        (sheet({"d02": RIGHT}, variant="x" * 500), "yim/planar-two-links has no variants"),
    ],
)
def test_a_sheet_that_cannot_be_read_is_a_row(tmp_path: Path, text: str | bytes, problem: str) -> None:
    """With its first problem, and nothing else."""
    row = graded(tmp_path, text)
    assert (row.sheet, row.student, row.parts) == ("student/a.yaml", "student", ())
    assert problem in row.problems[0].message
    assert all(one.place is None or one.place.source == "student/a.yaml" for one in row.problems)
    assert len(repr(row.problems)) < 2000


@pytest.mark.skipif(os.name == "nt" or os.geteuid() == 0, reason="nothing is forbidden there")
def test_a_sheet_that_may_not_be_read_is_a_row(tmp_path: Path) -> None:
    """No permission, no grade."""
    path = hand_in(tmp_path, "a.yaml")
    path.chmod(0)
    (row,) = map(grade, find_sheets(str(tmp_path)).submissions)
    assert "no permission" in row.problems[0].message


def test_what_the_search_found_wrong_is_a_row(tmp_path: Path) -> None:
    """Such as a link; the file is not opened."""
    row = grade(Submission(str(hand_in(tmp_path, "a.yaml")), "a.yaml", "a", "is a link"))
    assert [problem.message for problem in row.problems] == ["is a link"]


def test_a_bug_is_a_row(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """One sheet brings it to light, the others have their grades."""

    def broken(*_: object) -> None:
        raise RecursionError("too deep")

    monkeypatch.setattr("dhcli.classroom.marking.judged_sheet", broken)
    row = graded(tmp_path, sheet({"d02": RIGHT}))
    assert [problem.message for problem in row.problems] == ["this is a bug in dhcli: RecursionError: too deep"]


def test_a_sheet_cannot_choose_a_file_for_its_exercise(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A student who hands in an easy exercise too is not graded by it."""
    monkeypatch.chdir(tmp_path)
    mine = hand_in(tmp_path, "easy/mine.yaml", MINE)
    for name in (str(mine), "./easy/mine.yaml", "easy/mine", "-"):
        row = graded(tmp_path, sheet({"sum": "2"}, name))
        assert "there is no exercise" in row.problems[0].message


def test_the_lecturer_can_name_the_exercise(tmp_path: Path) -> None:
    """From the library or a file; sheets that do not say are taken, sheets of another exercise are not."""
    mine = str(hand_in(tmp_path, "mine.yaml", MINE))
    assert graded(tmp_path, sheet({"sum": "2"}, None), mine).earned == 1
    assert graded(tmp_path, sheet({"sum": "2"}, "mine"), mine).earned == 1
    assert graded(tmp_path, sheet({"d02": RIGHT}, "planar-two-links"), EXERCISE).earned == 1
    other = graded(tmp_path, sheet({"d02": RIGHT}), mine)
    assert other.problems[0].message == f"student/a.yaml is a sheet of {EXERCISE}, not of mine"


def test_many_processes_give_what_one_gives(tmp_path: Path) -> None:
    """And that is what no process gives; the order is that of the sheets."""
    for number in range(6):
        hand_in(tmp_path, f"{number}/a.yaml", sheet({"d02": (RIGHT, WRONG)[number % 2], "blocks": str(number)}))
    hand_in(tmp_path, "7/a.yaml", "answers: [")
    hand_in(tmp_path, "8/a.yaml", sheet({"a1": "[1 0 0 0; 0 1 0 0; 0 0 1 0; 0 0 0 1]"}, "yim/planar-in-numbers"))
    sheets = find_sheets(str(tmp_path)).submissions
    told: list[int] = []
    alone = grade_all(sheets, jobs=1, timeout=60, tell=lambda: told.append(1))
    assert alone == grade_all(sheets, jobs=3, timeout=60) == tuple(map(partial(grade, only=None), sheets))
    assert len(told) == len(sheets) == 8


def test_a_sheet_that_takes_too_long_and_one_that_kills_are_rows(tmp_path: Path) -> None:
    """The sheets behind them are graded all the same, by processes that take the place of the lost ones."""
    for name in ("a", "deadly-1", "deadly-2", "stuck", "z"):
        hand_in(tmp_path, f"{name}.yaml")
    rows = grade_all(find_sheets(str(tmp_path)).submissions, jobs=1, timeout=1.0, work=trouble)
    assert {row.student: [str(problem) for problem in row.problems] for row in rows} == {
        "a": [],
        "deadly-1": ["the process that graded it died (perhaps it ran out of memory)"],
        "deadly-2": ["the process that graded it died (perhaps it ran out of memory)"],
        "stuck": ["took longer than 1 s (--timeout gives it more)"],
        "z": [],
    }
    assert [row.earned for row in rows] == [1, 0, 0, 0, 1]


def test_a_sheet_with_other_numbers_than_the_exercise_has_now_is_not_graded(tmp_path: Path) -> None:
    """Who changes an exercise, its ranges or its robot while sheets are out is told, and no student loses credit."""
    text = write_sheet(vary(load_exercise("yim/planar-in-numbers"), "alice"))
    assert graded(tmp_path, text).problems == ()
    row = graded(tmp_path, text.replace("a1: 0.4 m", "a1: 0.5 m"))
    assert row.parts == ()
    (problem,) = row.problems
    assert problem.message == (
        "this sheet was written with other numbers than this exercise has: a1 = 0.5 m there, 0.4 m now"
    )
    gone = graded(tmp_path, text.replace("a1: 0.4 m", "a1: 0.4 m, b: 1 m")).problems[0].message
    assert gone.endswith("b = 1 m there, no value now")


def test_an_exercise_given_by_its_path_takes_the_robots_of_its_course(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """From any folder; and the sheets that were written inside the course are sheets of it."""
    arm = (Path(__file__).parents[2] / "robots" / "planar-2r.yaml").read_text("utf-8")
    robot = hand_in(tmp_path, "course/robots/my-crane.yaml", arm)
    text = MINE.replace("task:", "robot: my-crane\ntask:").replace("scalar 2", "scalar a1")
    exercise = hand_in(tmp_path, "course/exercises/robotics/sum.yaml", text)
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    monkeypatch.chdir(elsewhere)
    row = graded(tmp_path, sheet({"sum": "a1"}, "robotics/sum"), str(exercise))
    assert (row.problems, row.exercise, row.earned) == ((), "sum", 1)
    other = graded(tmp_path, sheet({"sum": "a1"}, "robotics/product"), str(exercise))
    assert "is a sheet of robotics/product, not of sum" in other.problems[0].message
    robot.unlink()
    with pytest.raises(FileError, match="there is no robot 'my-crane'"):
        load_exercise(str(exercise))


def test_what_is_no_slip_of_its_own_is_not_counted_as_one(tmp_path: Path) -> None:
    """Neither what cannot be read nor what is right from an earlier answer."""
    exercise = "yim/planar-in-numbers"
    slipped = "[√3/2 1/2 0 0.2√3; -1/2 √3/2 0 -1/5; 0 0 1 0; 0 0 0 1]"  # A_1 turned back by 30°, and A_1 A_2 from it
    after = "[0.9659 -0.2588 0 0.6362; 0.2588 0.9659 0 -0.1224; 0 0 1 0; 0 0 0 1]"
    grades = {part.part: part for part in graded(tmp_path, sheet({"a1": slipped, "t02": after}, exercise)).parts}
    assert (grades["a1"].verdict, grades["t02"].verdict) == (Verdict.WRONG, Verdict.WRONG)
    assert grades["a1"].slips
    assert grades["t02"].remarks[0].startswith("right from your a1")
    assert grades["t02"].slips == ()
    row = graded(tmp_path, sheet({"a1": "[1 2", "a2": "0.7, 0.7"}, exercise))
    assert {part.verdict for part in row.parts} == {Verdict.CANNOT_READ, Verdict.SKIPPED}
    assert all(part.remarks and not part.slips for part in row.parts if part.verdict is Verdict.CANNOT_READ)


def test_a_slip_without_a_name_is_the_same_in_every_variant(tmp_path: Path) -> None:
    """What was remarked of it, without the numbers of the sheet."""
    exercise = load_exercise("yim/planar-in-numbers")
    slips = set()
    for seed in ("alice", "bob"):
        drawn = vary(exercise, seed)
        entries = [line.split(", ") for line in expected(drawn, drawn.part("a1"))[2:-2].split("], [")]
        entries[0][3] = f"{float(entries[0][3]) + 0.1234}"
        answer = "; ".join(" ".join(row) for row in entries)
        row = graded(tmp_path, sheet({"a1": f"[{answer}]"}, exercise.id, variant=seed))
        (part,) = (part for part in row.parts if part.part == "a1")
        assert part.verdict is Verdict.WRONG
        slips |= set(part.slips)
    assert len(slips) == 1, slips
    assert "…" in slips.pop()


def test_orientations_that_are_off_by_any_angle_are_counted_together(tmp_path: Path) -> None:
    """About whatever axis."""
    turns = ("1 0 0 {}; 0 .6 -.8 {}; 0 .8 .6 0; 0 0 0 1", ".6 0 .8 {}; 0 1 0 {}; -.8 0 .6 0; 0 0 0 1")
    answers = [turn.format(0.34641, 0.2) for turn in turns]
    rows = [graded(tmp_path, sheet({"a1": answer}, "yim/planar-in-numbers")) for answer in answers]
    slips = [part.slips for row in rows for part in row.parts if part.part == "a1"]
    assert slips == [("the orientation is off by …°",)] * 2
