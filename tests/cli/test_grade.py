"""`dhcli grade`: exit codes, options, files, and what happens when somebody stops it."""

from __future__ import annotations

import csv
import json
import os
import signal
from collections.abc import Callable, Iterable, Iterator
from functools import partial
from pathlib import Path
from typing import Any

import pytest

from dhcli.classroom import grading
from tests.classroom.sheets import EXERCISE, RIGHT, WRONG, hand_in, sheet
from tests.classroom.workers import trouble
from tests.cli.running import PIPES, Run, start
from tests.cli.terminal import Terminal

ROOT = Path(__file__).parents[2]
CLASS = str(ROOT / "tests" / "data" / "class")
REPORT = {
    *("folder", "sheets", "graded", "failed", "empty", "others", "notices", "mean", "distribution", "parts", "results"),
}
RESULT = {"student", "sheet", "exercise", "variant", "earned", "credit", "parts", "problems"}
PART = {"part", "verdict", "passed", "earned", "credit", "actual", "rationale", "slips", "unit"}
FIGURES = {"exercise", "part", "credit", "mean", "verdicts", "slips"}


@pytest.fixture(autouse=True)
def in_this_process(monkeypatch: pytest.MonkeyPatch) -> None:
    """Sheets are graded one after another here; tests/classroom/ and README's examples do it in processes."""

    def one_by_one(work: Callable[[Any], Any], tasks: Iterable[Any], **_: object) -> Iterator[tuple[Any, Any]]:
        return ((task, work(task)) for task in tasks)

    monkeypatch.setattr("dhcli.classroom.grading.spread", one_by_one)


def test_a_class_is_graded_whatever_the_verdicts(dhcli: Run, tmp_path: Path) -> None:
    """0: the command did what it should; nothing is said on stderr, where no bar is drawn without a terminal."""
    hand_in(tmp_path, "hw/1/a.yaml")
    hand_in(tmp_path, "hw/2/a.yaml", sheet({"d02": WRONG}))
    done = dhcli("grade", "hw", "--jobs", "2")
    assert (done.code, done.err) == (0, "")
    assert done.out.startswith("hw: 2 sheets, 2 graded\n")


def test_a_sheet_that_cannot_be_read_ends_with_1(dhcli: Run) -> None:
    """The others are graded."""
    done = dhcli("grade", CLASS)
    assert done.code == 1
    assert "5 sheets, 4 graded, 1 not" in done.out
    assert "yim/planar-in-numbers has no part T02" in done.out


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ("grade nowhere", "there is no such folder"),
        ("grade empty", "there is no sheet in this folder"),
        ("grade hw --timeout soon", "soon is no time"),
        ("grade hw --timeout 0s", "0s is no time"),
        ("grade hw --timeout -1s", "-1s is no time"),
        ("grade hw --jobs 0", "0 is not in the range"),
        ("grade hw --exercise nothing", "there is no exercise 'nothing'"),
        ("grade hw --exercise -", "standard input only one"),
        ("grade hw --format latex", "there is no format latex for a class"),
        ("grade hw -o hw/1/a.yaml", "there is no format yaml for a class"),
        ("grade hw -o old.csv", "exists already"),
    ],
)
def test_bad_usage_ends_with_2_before_anything_is_graded(
    dhcli: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, words: str, message: str
) -> None:
    """No process is started."""
    monkeypatch.setattr("dhcli.classroom.grading.spread", None)
    (tmp_path / "empty").mkdir()
    hand_in(tmp_path, "hw/1/a.yaml")
    hand_in(tmp_path, "hw/2/a.yaml")
    hand_in(tmp_path, "old.csv", "mine")
    done = dhcli(*words.split())
    assert (done.code, done.out) == (2, "")
    assert message in done.err
    assert (tmp_path / "old.csv").read_text() == "mine"


def test_the_envelope_has_exactly_these_keys(dhcli: Run) -> None:
    """A new key is a decision, and stands here."""
    done = dhcli("grade", CLASS, "--format", "json")
    envelope = done.envelope
    assert (done.code, envelope["command"], envelope["ok"], envelope["problems"]) == (1, "grade", True, [])
    data = envelope["data"]
    assert set(data) == REPORT
    assert (data["sheets"], data["graded"], data["failed"], data["empty"]) == (5, 4, 1, ["student-6"])
    assert all(set(one) == RESULT for one in data["results"])
    assert all(set(part) == PART for one in data["results"] for part in one["parts"])
    assert all(set(part) == FIGURES for part in data["parts"])
    assert [set(one) for one in data["distribution"]] == [{"from", "sheets"}] * 6
    assert {key for part in data["parts"] for slip in part["slips"] for key in slip} == {"slip", "sheets"}
    (problem,) = data["results"][4]["problems"]
    assert problem["hint"] == "did you mean t02?"


def test_a_spreadsheet_has_a_row_for_each_sheet(dhcli: Run, tmp_path: Path) -> None:
    """The suffix says the format."""
    done = dhcli("grade", CLASS, "-o", "grades.csv")
    assert (done.code, done.out, done.err.splitlines()[0]) == (1, "", "wrote grades.csv")
    with (tmp_path / "grades.csv").open(newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert [row["student"] for row in rows] == [f"student-{n}" for n in range(1, 6)]
    assert [row["earned"] for row in rows] == ["10.0", "8.0", "7.0", "3.0", ""]
    assert rows[1]["t02 verdict"] == "WRONG"


def test_gradescope_gets_its_file(dhcli: Run, tmp_path: Path) -> None:
    """For the one sheet of a submission, which need not say its exercise."""
    hand_in(tmp_path, "submission/a.yaml", sheet({"d02": RIGHT}, None))
    words = ("--exercise", EXERCISE, "--format", "gradescope", "-o", "results.json", "--timeout", "1min")
    done = dhcli("grade", "submission", *words)
    assert (done.code, done.out) == (0, "")
    results = json.loads((tmp_path / "results.json").read_text("utf-8"))
    assert results["score"] == 1.0
    assert {test["name"]: test["score"] for test in results["tests"]}["d02"] == 1.0


@pytest.mark.parametrize(
    ("files", "said"),
    [
        (["bob.yaml.txt"], "this submission holds no sheet, but bob.yaml.txt"),
        ([], "this submission holds no sheet"),
        (["a.yaml", "b.yaml"], "this submission holds 2 sheets, a.yaml, b.yaml, and one is graded"),
    ],
)
def test_gradescope_gets_its_file_for_a_submission_that_cannot_be_graded(
    dhcli: Run, tmp_path: Path, files: list[str], said: str
) -> None:
    """It scores 0 and tells its student why; without a file Gradescope would only say that the autograder failed."""
    (tmp_path / "submission").mkdir()
    for name in files:
        hand_in(tmp_path, f"submission/{name}")
    done = dhcli("grade", "submission", "--exercise", EXERCISE, "--format", "gradescope", "-o", "results.json")
    assert (done.code, done.out) == (1, "")
    results = json.loads((tmp_path / "results.json").read_text("utf-8"))
    assert (results["score"], results["tests"]) == (0, [])
    assert said in results["output"]
    assert "the sheet that dhcli start writes" in results["output"]


def test_files_that_are_no_sheets_are_named(dhcli: Run, tmp_path: Path) -> None:
    """At the end of the report, and in JSON: a sheet may hide behind the suffix that a browser has given it."""
    for name in ("hw/ada/a.yaml", "hw/bob/sheet.yaml.txt", "hw/nina_9.zip", "hw/.hidden", "hw/__MACOSX/a.txt"):
        hand_in(tmp_path, name)
    end = "Not looked at: 2 other files, for sheets end in .yaml or .yml\n bob/sheet.yaml.txt\n nina_9.zip\n"
    assert dhcli("grade", "hw").out.endswith(end)
    data = dhcli("grade", "hw", "--format", "json").envelope["data"]
    assert data["others"] == ["bob/sheet.yaml.txt", "nina_9.zip"]


def test_many_files_that_are_no_sheets_are_counted(dhcli: Run, tmp_path: Path) -> None:
    """A page names twenty."""
    hand_in(tmp_path, "hw/a.yaml")
    for number in range(25):
        hand_in(tmp_path, f"hw/{number:02}.txt")
    out = dhcli("grade", "hw").out
    assert " 19.txt\n and 5 more\n" in out
    assert "20.txt" not in out


def test_sheets_that_fail_for_the_same_reason_stand_together(dhcli: Run, tmp_path: Path) -> None:
    """With where exercises are looked for, once."""
    for name in ("ada", "bob"):
        hand_in(tmp_path, f"hw/{name}.yaml", sheet({"d02": RIGHT}, "my-course/first"))
    out = dhcli("grade", "hw").out
    assert " ada.yaml\n bob.yaml\n   exercise: there is no exercise 'my-course/first'" in out
    assert out.count("exercises are looked for in ./exercises and in the folders of DHCLI_PATH") == 1


def test_variants_that_are_shared_or_missing_are_told(dhcli: Run, tmp_path: Path) -> None:
    """And a student who has handed in twice, and two of one name."""
    text = partial(sheet, {"a1": "_"}, "yim/planar-in-numbers")
    hand_in(tmp_path, "hw/zed/a.yaml", text(variant="alice"))
    hand_in(tmp_path, "hw/yan/a.yaml", text(variant="alice", name="Yan Y."))
    hand_in(tmp_path, "hw/bob/a.yaml", text())
    hand_in(tmp_path, "hw/sam/1.yaml", text(variant="sam"))
    hand_in(tmp_path, "hw/sam/2.yaml", text(variant="sam"))
    hand_in(tmp_path, "hw/tom/a.yaml", text(variant="tom", name="Yan Y."))
    notices = [
        "yim/planar-in-numbers: no variant: 1 sheet (bob)",
        "yim/planar-in-numbers: variant alice: 2 sheets (Yan Y., zed)",
        "yim/planar-in-numbers: 2 sheets in sam",
        "yim/planar-in-numbers: Yan Y. is the name on sheets of tom, yan",
    ]
    data = dhcli("grade", "hw", "--format", "json").envelope["data"]
    assert sorted(data["notices"]) == sorted(notices)
    out = dhcli("grade", "hw").out
    assert "Worth a look\n" in out
    assert all(f" {notice}\n" in out for notice in notices)


def test_the_progress_of_a_student_is_not_the_lecturers(dhcli: Run, tmp_path: Path, user_data: Path) -> None:
    """Grading leaves no trace among the exercises that the lecturer has solved."""
    hand_in(tmp_path, "hw/a.yaml")
    assert dhcli("grade", "hw").code == 0
    assert not user_data.exists()


@pytest.mark.skipif(os.name == "nt", reason="needs a pseudo-terminal")
def test_a_terminal_shows_a_bar_and_then_the_report(tmp_path: Path) -> None:
    """The bar is taken away."""
    hand_in(tmp_path, "hw/a.yaml")
    with Terminal(tmp_path, "grade", "hw", own_process=True) as terminal:
        assert "0/1" in terminal.until("grading.*0/1")
        terminal.until("hw: 1 sheet, 1 graded")
        assert terminal.end() == 0


@pytest.mark.skipif(os.name == "nt", reason="signals as Unix knows them")
@pytest.mark.parametrize(("name", "code"), [("SIGINT", 130), ("SIGTERM", 143), ("SIGHUP", 129)])
def test_a_signal_leaves_no_file_and_no_process(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str, code: int
) -> None:
    """It reaches every process of the terminal; the pipe ends only when all of them have gone."""
    hand_in(tmp_path, "hw/a.yaml")
    hand_in(tmp_path, "hw/stuck.yaml")
    monkeypatch.undo()  # in processes, that is
    monkeypatch.setattr(grading, "grade_all", partial(grading.grade_all, work=trouble))
    words = ["grade", "hw", "--jobs", "2", "--timeout", "60", "-o", "grades.csv"]
    with start(tmp_path, *words, **PIPES, start_new_session=True) as running:
        assert running.stdout is not None
        assert running.stdout.readline() == "stuck\n"
        os.killpg(running.pid, getattr(signal, name))
        out, err = running.communicate(timeout=30)
    assert (running.returncode, out, err.strip()) == (code, "", "")
    assert [path.name for path in tmp_path.iterdir() if path.is_file()] == []


def test_a_report_in_a_file_is_summed_up_on_the_screen(dhcli: Run) -> None:
    """How many sheets were graded is seen without opening it; standard output stays for results."""
    done = dhcli("grade", str(ROOT / "tests/data/class/student-1"), "-o", "grades.csv")
    assert done.out == ""
    assert done.err.splitlines()[-2] == "wrote grades.csv"
    assert done.err.splitlines()[-1].endswith("student-1: 1 sheet, 1 graded")
