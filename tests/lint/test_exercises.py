"""Rules for exercises: each is broken once, by a file that is clean but for that."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from dhcli.checking.judge import Judge
from dhcli.checking.verdicts import Mark, Verdict
from dhcli.files.yaml.exercises import load_exercise, read_exercise
from dhcli.lint import exercises
from tests.lint.linting import Broken, assert_told, cases, findings

ROOT = Path(__file__).parents[2]

CLEAN = """\
format: 1
title: Two links
source: a test
robot: planar-2r
numeric: true
unit: m
given: {theta1: 35°, theta2: 20°}
tolerance: {rotation: 0.001}
task: Find the pose of the end.
parts:
  - id: t02
    ask: pose 0..2
    credit: 2
    hints: [multiply, the angles add up]
  - id: tip
    ask: position of pose 0..2
    prompt: Where is the end?
    depends: [t02]
    hints: [the last column]
  - id: table
    ask: table standard
    compare: same-robot
    hints: [two rows]
printed:
  tip: "0.5, 0.475, 0"
tests:
  - {part: tip, answer: "0.4997, 0.4752, 0", verdict: RIGHT}
  - {part: tip, answer: "0.4997, 0.5752, 0", verdict: WRONG}
  - {part: t02, mistake: a-sign 2, verdict: WRONG}
"""

WRITE = "write what belongs there"


@cases(
    Broken(
        "unit: m\n",
        "unit: m\npicture: frames\n",
        "7:10",
        "picture: frames would answer table, and are not shown",
        "picture: axes; frames may not stand beside: table",
    ),
)
def test_a_picture_shows_nothing_that_a_part_asks_for(broken: Broken, tmp_path: Path) -> None:
    """By the list of what each kind of question may stand beside."""
    assert_told(tmp_path, CLEAN, broken)


def test_a_picture_of_nothing_is_told(tmp_path: Path) -> None:
    """Where there is neither an arm nor a linkage."""
    text = CLEAN[: CLEAN.index("given:")].replace("robot: planar-2r\n", "picture: axes\n") + (
        "task: Count.\nparts:\n  - {id: n, ask: scalar 2*3, hints: [a, b]}\n"
        "tests:\n  - {part: n, answer: '6', verdict: RIGHT}\n  - {part: n, answer: '5', verdict: WRONG}\n"
    )
    assert [one.message for one in findings(tmp_path, text)] == [
        "picture: there is neither an arm nor a linkage to draw"
    ]


@cases(
    Broken("title: Two links", "title: TODO", "2:8", "title: still says 'TODO'", WRITE),
    Broken("source: a test", "source: FIXME later", "3:9", "source: still says 'FIXME'", WRITE),
    Broken("source: a test", "source: {document: D, item: TBD}", "3:1", "source: still says 'TBD'", WRITE),
    Broken("Find the pose of the end.", "XXX", "9:7", "task: still says 'XXX'", WRITE),
    Broken("Where is the end?", "write here", "17:13", "prompt: still says 'write here'", WRITE),
    Broken("[the last column]", "[TODO]", "19:13", "hint: still says 'TODO'", WRITE),
)
def test_a_text_that_is_not_finished_is_told(broken: Broken, tmp_path: Path) -> None:
    """Wherever it stands."""
    assert_told(tmp_path, CLEAN, broken)


@cases(
    Broken("    hints: [two rows]\n", "", "20:5", "table: has no hints", "hints: [gentle, plain]"),
    Broken(
        "[multiply, the angles add up]",
        "[multiply, multiply]",
        "14:23",
        "t02: the same hint stands twice",
        "the second one goes further",
    ),
    Broken("credit: 2", "credit: 0", "13:13", "t02: is worth nothing", "credit: 1"),
    Broken("credit: 2", "credit: -1", "13:13", "t02: is worth nothing", "credit: 1"),
    Broken("depends: [t02]", "depends: [t02, t02]", "18:20", "tip: depends on t02 twice", "delete one"),
)
def test_a_part_without_help_or_worth_is_told(broken: Broken, tmp_path: Path) -> None:
    """Whoever is stuck needs a hint, and whoever is not wants credit."""
    assert_told(tmp_path, CLEAN, broken)


@cases(
    Broken(
        'tip: "0.5, 0.475, 0"',
        'tip: "0.5, 0.475"',
        "25:8",
        "printed: tip: is judged CAN'T READ (2 numbers are given, 3 were asked: is z missing?)",
        "write it as a student would",
    ),
    Broken(
        'tip: "0.5, 0.475, 0"',
        'tip: "_"',
        "25:8",
        "printed: tip: is judged SKIPPED",
        "write it as a student would",
    ),
    Broken(
        'tip: "0.5, 0.475, 0"',
        't02: "[0.5736 -1.8192 0 0.4997; 0.8192 0.5736 0 0.4752; 0 0 1 0; 0 0 0 1]"',
        "25:8",
        "printed: t02: entry (1,2) is -1.8192, right is -0.8192",
        "a misprint: t02: {answer: ..., note: what is wrong with it}; a typo of yours: mend it",
        is_warning=True,
    ),
    Broken(
        'tip: "0.5, 0.475, 0"',
        'tip: "0.6, 0.475, 0.1"',
        "25:8",
        "printed: tip: entry (1,1) is 0.6, right is 0.4997 (and 1 more)",
        "a misprint: tip: {answer: ..., note: what is wrong with it}; a typo of yours: mend it",
        is_warning=True,
    ),
    Broken(
        'tip: "0.5, 0.475, 0"',
        'table: "a, alpha, d, theta; a1, 0, 0, theta1; a2, 90°, 0, theta2"',
        "25:10",
        "printed: table: entry (2,2) is 90°, right is 0",
        "a misprint: table: {answer: ..., note: what is wrong with it}; a typo of yours: mend it",
        is_warning=True,
    ),
)
def test_a_printed_answer_that_cannot_be_what_is_printed_is_told(broken: Broken, tmp_path: Path) -> None:
    """An author's slip is not a misprint of the document."""
    assert_told(tmp_path, CLEAN, broken)


def test_a_misprint_with_a_note_is_known(tmp_path: Path) -> None:
    """The author has looked at it."""
    printed = '{answer: "[0.5736 -1.8192 0 0.4997; 0.8192 0.5736 0 0.4752; 0 0 1 0; 0 0 0 1]", note: a digit is lost}'
    assert findings(tmp_path, CLEAN.replace('tip: "0.5, 0.475, 0"', f"t02: {printed}")) == []


def test_a_table_of_one_motion_needs_a_task_that_leaves_nothing_open(tmp_path: Path) -> None:
    """Told with everything that is missing, until the task states it."""
    same = CLEAN.replace("compare: same-robot", "compare: same-motion")
    (found,) = findings(tmp_path, same)
    assert (found.at, found.hint) == ("22:14", "state it, or compare: same-robot")
    assert found.message == (
        "table: same-motion wants one table, and the task does not state: "
        "base frame, end frame, joint zero, positive sense"
    )
    stated = "task: |\n  Base frame 0: at joint 1. End frame 2: at the\n  tip. Joint zero: stretched out."
    (found,) = findings(tmp_path, same.replace("task: Find the pose of the end.", stated))
    assert found.message.endswith("does not state: positive sense")
    stated += " Positive sense: the\n  right-hand rule."
    assert findings(tmp_path, same.replace("task: Find the pose of the end.", stated)) == []
    (found,) = findings(tmp_path, CLEAN.replace("task: Find the pose of the end.", stated))
    assert (found.message, found.hint) == (
        "table: same-robot leaves frames, zeros and senses free, and the task fixes them all",
        "compare: same-motion",
    )


def test_a_table_says_by_name_how_it_is_compared(tmp_path: Path) -> None:
    """The default follows from the task; whoever reads the file should not have to work it out."""
    silent = CLEAN.replace("    compare: same-robot\n", "")
    (found,) = findings(tmp_path, silent)
    assert (found.at, found.message) == ("20:5", "table: does not say how tables are compared")
    assert found.hint.startswith("compare: same-robot; the task does not state: base frame, end frame")
    stated = "task: The base frame, the end frame, each joint zero and each positive sense are those of the figure."
    (found,) = findings(tmp_path, silent.replace("task: Find the pose of the end.", stated))
    assert found.hint == "compare: same-motion; the task fixes all that it needs"


@cases(
    Broken(
        '0.4752, 0", verdict: RIGHT}',
        '0.4752, 0", verdict: CLOSE}',
        "27:25",
        "tip: is judged RIGHT; the test says CLOSE",
    ),
    Broken(
        "a-sign 2",
        "a-sine 2",
        "29:26",
        "t02: the mistake 'a-sine 2' cannot be made here",
        "did you mean a-sign 2 or a-sign 1 or a-in-mm 2?",
    ),
)
def test_an_own_test_that_does_not_come_out_is_told(broken: Broken, tmp_path: Path) -> None:
    """At the answer, or at the mistake."""
    another = '  - {part: tip, answer: "0.49967, 0.47518, 0", verdict: RIGHT}\n'  # one is RIGHT, whatever is changed
    assert_told(tmp_path, CLEAN + another, broken)


@cases(
    Broken(
        '  - {part: tip, answer: "0.4997, 0.4752, 0", verdict: RIGHT}\n',
        "",
        "26:1",
        "tests: none is RIGHT",
        "tests: - {part: t02, answer: ..., verdict: RIGHT}",
    ),
    Broken(
        '  - {part: tip, answer: "0.4997, 0.5752, 0", verdict: WRONG}\n'
        "  - {part: t02, mistake: a-sign 2, verdict: WRONG}\n",
        "",
        "26:1",
        "tests: none is WRONG",
        "tests: - {part: t02, answer: ..., verdict: WRONG}",
    ),
)
def test_an_exercise_must_test_itself_both_ways(broken: Broken, tmp_path: Path) -> None:
    """With something right, and with something that must not pass."""
    assert_told(tmp_path, CLEAN, broken)


def test_an_exercise_without_tests_does_not_lint(tmp_path: Path) -> None:
    """Both findings stand at the head of the file, for there is nothing to point at."""
    found = findings(tmp_path, CLEAN[: CLEAN.index("tests:")])
    told = [(one.at, one.message) for one in found]
    assert told == [("1:1", "tests: none is RIGHT"), ("1:1", "tests: none is WRONG")]


@cases(
    Broken(
        "rotation: 0.001",
        "position: 31 mm",
        "8:23",
        "position: a tolerance of 31 mm is large beside a2 = 300 mm",
        "at most 30 mm, or an answer without a2 may pass",
    ),
    Broken(
        "rotation: 0.001",
        "rotation: 0.1",
        "8:23",
        "rotation: a direction cosine may be off by 0.1",
        "less than 0.1; the usual is 0.001",
    ),
    Broken(
        "rotation: 0.001", "angle: 5.5°", "8:20", "angle: an angle may be off by 5.5°", "at most 5°; the usual is 0.05°"
    ),
)
def test_a_tolerance_that_says_nothing_is_told(broken: Broken, tmp_path: Path) -> None:
    """An answer without the smallest length must not pass."""
    found = findings(tmp_path, CLEAN.replace(broken.old, broken.new))
    assert Broken("", "", broken.at, broken.message, broken.hint) in found
    assert findings(tmp_path, CLEAN) == []


def test_the_smallest_length_may_be_one_that_is_given(tmp_path: Path) -> None:
    """A parameter of the task counts as one of the robot does."""
    given = (
        CLEAN.replace("theta2: 20°}", "theta2: 20°, e: 4 mm}")
        .replace("the end.", "the end, e away.")
        .replace("rotation: 0.001", "position: 1 mm")
    )
    (found,) = findings(tmp_path, given)
    assert found.message == "position: a tolerance of 1 mm is large beside e = 4 mm"
    assert found.hint == "at most 0.4 mm, or an answer without e may pass"


def test_a_solution_that_is_not_right_is_told(tmp_path: Path) -> None:
    """Where exact values are wanted, dhcli cannot type them in from floats."""
    exact = CLEAN.replace("    credit: 2\n", "    credit: 2\n    exact: true\n")
    (found,) = findings(tmp_path, exact)
    assert found.at == "12:10"
    assert found.message.startswith("t02: its own solution [[0.57357")
    assert found.message.endswith("is judged ROUNDED (this task wants exact values, such as sqrt(2)/2 for 0.7071)")


TABLELESS = """\
format: 1
title: A table of one's own
source: a test
robot: scara
task: Write down a table.
parts:
  - {id: table, ask: table standard, compare: same-robot, hints: [three rows]}
tests:
  - {part: table, answer: "[1 2; 3 4]", verdict: CAN'T READ}
"""


def test_a_part_whose_solution_nobody_knows_is_told(tmp_path: Path) -> None:
    """A robot given as products has no table to show; a test that is RIGHT would show one."""
    first, *_ = findings(tmp_path, TABLELESS)
    assert first.at == "7:22"
    assert first.message.startswith("table: has no solution: ")
    assert first.hint


def test_a_blank_sheet_that_earns_something_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    """No file does that today; the rule holds the door shut."""
    judge = Judge(read_exercise(CLEAN, "own.yaml", "own"))
    sheet = judge.sheet({})
    free = [replace(one, mark=Mark(Verdict.RIGHT, "")) if one.part.id == "tip" else one for one in sheet.parts]
    monkeypatch.setattr(judge, "sheet", lambda *_: replace(sheet, parts=tuple(free)))
    (found,) = exercises.findings(judge)
    assert (found.where, found.message) == (("parts", 1), "tip: a blank answer is judged RIGHT")


def test_a_name_without_a_value_is_told_by_its_name(tmp_path: Path) -> None:
    """Once, and not once more for everything that cannot be judged without it."""
    (found,) = findings(tmp_path, CLEAN.replace(", theta2: 20°", ""))
    assert (found.at, found.hint) == ("7:1", "given: {theta2: 25°}")
    assert found.message == "given: no value for theta2, and the answers are numbers"


def test_a_value_outside_the_limits_is_told(tmp_path: Path) -> None:
    """As that of a variant is; an author may mean it."""
    arm = (ROOT / "robots" / "planar-2r.yaml").read_text("utf-8")
    (tmp_path / "arm.yaml").write_text(f"{arm}\nlimits: {{theta1: [-30°, 30°]}}\n", "utf-8")
    text = CLEAN.replace("robot: planar-2r", f"robot: {tmp_path}/arm.yaml")
    (found,) = findings(tmp_path, text)
    assert (found.at, found.message, found.is_warning) == (
        "7:17",
        "theta1: 35° is outside its limits, -30° to 30°",
        True,
    )


def test_the_right_answer_stands_beside_a_test_that_takes_another_for_it(tmp_path: Path) -> None:
    """Its author wants to know."""
    (found,) = findings(
        tmp_path, CLEAN.replace('"0.4997, 0.4752, 0", verdict: RIGHT', '"0.4997, 1, 0", verdict: RIGHT')
    )
    assert found.hint.startswith("right is [0.4997")
    (other,) = findings(tmp_path, CLEAN.replace('"0.4997, 0.5752, 0"', '"0.4997, 0.4752, 0"'))
    assert other.hint == ""


def test_beside_a_tolerance_that_lets_all_pass_nothing_else_is_told(tmp_path: Path) -> None:
    """That mistakes do not show, and tests do not fail, comes of it."""
    (found,) = findings(tmp_path, CLEAN.replace("tolerance: {rotation: 0.001}", "tolerance: {position: 400 mm}"))
    assert found.message.startswith("position: a tolerance of 400 mm is large beside")


@pytest.mark.parametrize(
    ("part", "told"),
    [
        ("{id: a, ask: 'point (a1, 0, 0) of product \"Trans(0, 0, 0)\"', hints: [look]}", True),
        ("{id: a, ask: 'point (a1, 0, 0) of product \"Trans(0, 0, 0)\"', prompt: Where is P?, hints: [look]}", False),
        ("{id: a, ask: 'point (a1, 0, 0) of pose 0..1', hints: [look]}", False),
        ("{id: a, ask: 'product \"Rot(z, theta1)\"', hints: [look]}", False),
    ],
)
def test_a_question_that_shows_its_answer_is_told(tmp_path: Path, part: str, *, told: bool) -> None:
    """The coordinates in its heading are the answer, unless words of its own take their place."""
    text = f"""format: 1
title: A point
source: mine
robot: planar-2r
task: Find it.
parts:
  - {part}
tests:
  - {{part: a, answer: "_", verdict: SKIPPED}}
"""
    path = tmp_path / "point.yaml"
    path.write_text(text, "utf-8")
    found = [finding.message for finding in exercises.findings(Judge(load_exercise(str(path))))]
    assert any("shows its answer" in message for message in found) is told


def test_a_part_that_was_withdrawn_is_not_looked_at(tmp_path: Path) -> None:
    """It may be as faulty as it is; the others, and their places, are as before."""
    broken = CLEAN.replace('tip: "0.5, 0.475, 0"', 'tip: "9, 9, 9"').replace("hints: [two rows]", "credit: 0")
    gone = broken.replace("    prompt: Where is the end?", "    withdrawn: the figure is wrong")
    told = findings(tmp_path, broken)
    assert len(told) > 2
    left = [one for one in findings(tmp_path, gone) if "tests: none is RIGHT" not in str(one)]
    assert left
    assert all("table" in str(one) for one in left)


@cases(
    Broken(
        "theta2: 20°}",
        "theta2: 20°, a1: 300}",
        "7:39",
        "a1: 300 m is longer than any arm",
        "bare lengths are metres: did you mean 300 mm?",
        is_warning=True,
    ),
)
def test_a_length_of_the_robot_that_is_given_in_millimetres_without_its_unit_is_told(
    broken: Broken, tmp_path: Path
) -> None:
    """Beside all that follows from it, such as tests that do not come out."""
    found = findings(tmp_path, CLEAN.replace(broken.old, broken.new))
    assert Broken("", "", broken.at, broken.message, broken.hint, broken.is_warning) in found
    drawn = CLEAN.replace("theta2: 20°}", "theta2: 20°}\nvariants: {a1: 300..400 step 100}")
    assert "a1: 400 m is longer than any arm" in [one.message for one in findings(tmp_path, drawn)]
    other = CLEAN.replace("theta2: 20°}", "theta2: 20°, f_x: 300}")
    other = other.replace("Find the pose", "A force f_x pulls. Find the pose")
    assert findings(tmp_path, other) == []
