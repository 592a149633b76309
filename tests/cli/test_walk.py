"""The walk through an exercise on a terminal: its commands, what it asks again, and how lines are edited."""

from __future__ import annotations

import os
import re
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhcli.checking.verdicts import Verdict
from dhcli.cli.shell.lines import recalled
from dhcli.files.progress import Try, read_progress, record
from dhcli.files.yaml.exercises import load_exercise
from dhcli.files.yaml.sheets import write_sheet
from dhcli.notation.matrix import parse_matrix
from tests.cli.running import Run
from tests.cli.terminal import Terminal
from tests.row_by_row import row_by_row

PLANAR = "yim/planar-two-links"
A1 = "[c1 -s1 0 a1*c1; s1 c1 0 a1*s1; 0 0 1 0; 0 0 0 1]"
TURNED = "[c1 s1 0 a1*c1; -s1 c1 0 a1*s1; 0 0 1 0; 0 0 0 1]"
TRANSPOSED = "the rotation is transposed"
PARTS = [part.id for part in load_exercise(PLANAR).parts]
UP = "\x1b[A"

pytestmark = pytest.mark.skipif(os.name == "nt", reason="pseudo-terminals as Unix knows them")


def test_credits_and_the_order_of_columns_are_told_before_a_part_is_answered(tmp_path: Path) -> None:
    """As `show` and the sheet tell them."""
    with Terminal(tmp_path, "check", PLANAR) as screen:
        asked = screen.until("table> ")
        assert re.search(r"\ntable: .* · 2 credits\n", asked)
        assert "the standard DH table\n" in asked
        assert "columns: a  alpha  d  theta; angles in degrees" in asked


def test_what_an_answer_is_computed_with_is_told_before_the_first_part(tmp_path: Path) -> None:
    """The values given, the lengths of the robot, and the unit of a bare number: all that stands on the sheet."""
    with Terminal(tmp_path, "check", "yim/stanford-in-numbers", columns=100) as screen:
        asked = screen.until("> ")
    sheet = write_sheet(load_exercise("yim/stanford-in-numbers"))
    lines = [
        line.removeprefix("# ") for line in sheet.splitlines() if line.startswith(("# Given", "# Robot", "# Numbers"))
    ]
    assert len(lines) == 3
    flat = " ".join(asked.split()).lower()
    assert all(" ".join(line.split()).lower() in flat for line in lines)
    with Terminal(tmp_path, "check", PLANAR) as screen:
        assert "Symbols: c1 for cos(theta1)" in screen.until("table> ")


def test_how_a_formula_is_written_is_told_once(tmp_path: Path) -> None:
    """And not again for the next part, which is another formula."""
    with Terminal(tmp_path, "check", "inverse/planar-joints") as screen:
        assert "Write ± for two signs" in screen.until("elbow> ")
        screen.type("skip\n")
        assert "Write ± for two signs" not in screen.until("shoulder> ")


def test_an_answer_in_too_few_digits_is_asked_for_again(tmp_path: Path) -> None:
    """It is ROUNDED, and no proof of work."""
    with Terminal(tmp_path, "check", "yim/planar-in-numbers", "--part", "a1") as screen:
        screen.until("a1> ")
        screen.type("[0.9 -0.5 0 0.3; 0.5 0.9 0 0.2; 0 0 1 0; 0 0 0 1]\n")
        judged = screen.until("a1> ")
        assert "ROUNDED" in judged
        assert "Try again" in judged


def test_a_table_in_one_line_is_judged_at_once(tmp_path: Path) -> None:
    """One whose line ends with a semicolon goes on."""
    with Terminal(tmp_path, "check", PLANAR, "--part", "table") as screen:
        screen.until("table> ")
        screen.type("a1 0 0 theta1;\n")
        screen.until(r"... ")
        screen.type("\n")
        assert "CAN'T READ" in screen.until("table> ")
        screen.type("a1 0 0 theta1; a2 0 0 theta2\n")
        assert screen.end() == 0


@pytest.mark.parametrize("word", ["quit", "Exit", "q"])
def test_a_word_ends_the_walk(tmp_path: Path, word: str) -> None:
    """Also within an answer; what was reached is summed up."""
    with Terminal(tmp_path, "check", PLANAR) as screen:
        screen.until("table> ")
        screen.type(f"a1 0 0 theta1\n{word}\n")
        assert "0 of 8 parts solved" in screen.until("credits")
        assert screen.end() == 1


def test_why_names_the_slip_behind_the_last_answer(tmp_path: Path) -> None:
    """Before an answer there is none, and none behind one that is right."""
    with Terminal(tmp_path, "check", PLANAR, "--part", "a1") as screen:
        screen.until("a1> ")
        screen.type("why\n")
        assert "answer first" in screen.until("a1> ")
        screen.type(f"{TURNED}\n")
        judged = screen.until("a1> ")
        assert "(why names the slip)" in judged
        assert "--why" not in judged
        assert "dhcli hint" not in judged
        screen.type("why\n")
        assert f"why: {TRANSPOSED}" in screen.until("a1> ")
        screen.type("\x04")
        assert screen.end() == 1


def test_behind_a_choice_no_slip_is_looked_for(tmp_path: Path) -> None:
    """Which is said, and that there are hints; it is not said that none was found."""
    with Terminal(tmp_path, "check", PLANAR, "--part", "blocks") as screen:
        screen.until("blocks> ")
        screen.type("3\n")
        screen.until("blocks> ")
        screen.type("why\n")
        assert "why: no slip is looked for behind such an answer; hint helps on" in screen.until("blocks> ")
        screen.type("\x04")
        screen.end()


def test_half_the_credit_is_told_where_only_the_unit_is_another(tmp_path: Path) -> None:
    """Behind the name of the part, as `check` tells it."""
    with Terminal(tmp_path, "check", "scara-pose-in-mm", "--part", "tip") as screen:
        screen.until("tip> ")
        screen.type("-0.30739, 0.4253, 0.2\n")
        assert "CAN'T READ  tip (1 of 2 credits)\n    right in m; this sheet is in mm" in screen.until("tip> ")
        screen.type("\x04")
        screen.end()


def test_with_the_option_slips_are_named_at_once(tmp_path: Path) -> None:
    """As with a sheet."""
    with Terminal(tmp_path, "check", PLANAR, "--part", "a1", "--why") as screen:
        screen.until("a1> ")
        screen.type(f"{TURNED}\n")
        assert f"why: {TRANSPOSED}" in screen.until("a1> ")
        screen.type("\x04")
        screen.end()


def test_hints_come_one_by_one_between_the_rows_of_an_answer_too(tmp_path: Path) -> None:
    """The last one stays, and what was typed so far is kept."""
    with Terminal(tmp_path, "check", PLANAR, "--part", "table") as screen:
        screen.until("table> ")
        screen.type("hint\n")
        assert "hint 1 of 2: " in screen.until("table> ")
        screen.type("a1 0 0 theta1\n")
        screen.until(r"\.\.\. ")
        for _ in range(2):
            screen.type("?\n")
            assert "hint 2 of 2: " in screen.until(r"\.\.\. ")
        screen.type("why\n")
        assert "is not judged yet: an empty line ends it" in screen.until(r"\.\.\. ")
        screen.type("a2 0 0 theta2\n")
        screen.until(r"\.\.\. ")
        screen.type("\n")
        assert screen.end() == 0


def test_help_lists_what_can_be_typed(tmp_path: Path) -> None:
    """Each with what it does."""
    with Terminal(tmp_path, "check", PLANAR) as screen:
        screen.until("table> ")
        screen.type("help\n")
        told = screen.until("table> ")
        assert all(re.search(rf"^  {word} +\w", told, re.MULTILINE) for word in ("hint", "why", "skip", "back", "help"))
        screen.type("\x04")
        screen.end()


def test_back_and_skip_move_between_the_parts(tmp_path: Path) -> None:
    """Back asks a part that is solved again; on the way forward it is passed over."""
    with Terminal(tmp_path, "check", PLANAR) as screen:
        screen.until("table> ")
        screen.type("back\n")
        assert "This is the first part" in screen.until("table> ")
        screen.type("skip\n")
        screen.until("a1> ")
        screen.type(f"{A1}\n")
        assert "RIGHT" in screen.until("a2> ")
        screen.type("back\n")
        screen.until("a1> ")
        screen.type("back\n")
        screen.until("table> ")
        screen.type("skip\n")
        assert "a1>" not in screen.until("a2> ")
        screen.type("\x04")
        assert screen.end() == 1
        assert "1 of 8 parts solved, 2 of 13 credits" in screen.seen
    assert read_progress()[0] == {PLANAR: {"a1": Try("RIGHT", 1)}}


def test_parts_that_were_solved_before_are_not_asked_again(tmp_path: Path) -> None:
    """They count in the sum; `--part` asks one again, and a part that was tried in vain is asked."""
    record(PLANAR, {"table": Verdict.RIGHT, "a1": Verdict.EQUIVALENT, "a2": Verdict.CLOSE})
    with Terminal(tmp_path, "check", PLANAR) as screen:
        told = screen.until("a2> ")
        assert "Solved already, and not asked again: table, a1" in told
        assert "table>" not in told
        screen.type("\x04")
        assert screen.end() == 1
        assert "2 of 8 parts solved, 4 of 13 credits" in screen.seen
    with Terminal(tmp_path, "check", PLANAR, "--part", "a1") as screen:
        screen.until("a1> ")
        screen.type(f"{A1}\n")
        assert screen.end() == 0


def test_an_exercise_that_is_solved_asks_nothing(tmp_path: Path) -> None:
    """And says how a part is asked again; the exit code is that of what was reached."""
    record(PLANAR, dict.fromkeys(PARTS, Verdict.RIGHT))
    with Terminal(tmp_path, "check", PLANAR) as screen:
        assert screen.end() == 0
        assert f"dhcli check {PLANAR} --part table asks one again" in screen.seen
        assert "8 of 8 parts solved, 13 of 13 credits" in screen.seen


def test_a_variant_has_numbers_of_its_own_and_is_asked_whole(tmp_path: Path) -> None:
    """Whatever was solved with other numbers."""
    record("yim/planar-in-numbers", {"a1": Verdict.RIGHT})
    with Terminal(tmp_path, "check", "planar-in-numbers", "--variant", "alice") as screen:
        screen.until("a1> ")
        screen.type("\x04")
        screen.end()


def test_an_answer_that_follows_from_an_earlier_one_keeps_its_credit(tmp_path: Path) -> None:
    """As it does on a sheet: the walk remembers what was answered."""
    swapped = "[c2 -s2 0 a2*s2; s2 c2 0 a2*c2; 0 0 1 0; 0 0 0 1]"
    x, y = "a1*c1 + a2*(c1*s2 - s1*c2)", "a1*s1 + a2*(s1*s2 + c1*c2)"
    with Terminal(tmp_path, "check", PLANAR) as screen:
        for part in ("table", "a1"):
            screen.until(f"{part}> ")
            screen.type("skip\n")
        screen.until("a2> ")
        screen.type(f"{swapped}\n")
        screen.until("a2> ")
        screen.type("\n")
        screen.until("blocks> ")
        screen.type("skip\n")
        screen.until("t02> ")
        screen.type(f"[c12, -s12, 0, {x}; s12, c12, 0, {y}; 0, 0, 1, 0; 0, 0, 0, 1]\n")
        assert "right from your a2" in " ".join(screen.until("t02> ").split())
        screen.type("why\n")
        assert "right from your a2" in " ".join(screen.until("t02> ").split())
        screen.type("\x04")
        screen.end()


def test_a_line_is_edited_and_an_answer_recalled_as_one_line(tmp_path: Path) -> None:
    """The rows of the table come back together, and the last letter is mended."""
    with Terminal(tmp_path, "check", PLANAR, "--part", "table", own_process=True, columns=80) as screen:
        screen.until("table> ")
        screen.type("a1 0 0 theta1\n")
        screen.until(r"\.\.\. ")
        screen.type("a2 0 0 theta1\n")
        screen.until(r"\.\.\. ")
        screen.type("\n")
        screen.until("Try again")
        screen.until("table> ")
        screen.type(UP)
        screen.until("a1 0 0 theta1; a2 0 0 theta1")
        screen.type("\x7f2\n")
        assert screen.end() == 0
        assert "RIGHT" in screen.seen


def test_a_table_from_a_spreadsheet_is_read_with_its_tabs(tmp_path: Path) -> None:
    """A tab completes nothing here."""
    with Terminal(tmp_path, "check", PLANAR, "--part", "table", own_process=True, columns=80) as screen:
        screen.until("table> ")
        screen.type("a1\t0\t0\ttheta1\n")
        screen.until(r"\.\.\. ")
        screen.type("a2\t0\t0\ttheta2\n")
        screen.until(r"\.\.\. ")
        screen.type("\n")
        assert screen.end() == 0


@row_by_row(
    ("lines", "is_matrix", "text"),
    [
        (["c1 -s1", "s1 c1", ""], True, "c1 -s1; s1 c1"),
        (["c1, -s1;", "s1, c1"], True, "c1, -s1; s1, c1"),
        (["[[c1, -s1],", " [s1, c1]]"], True, "[[c1, -s1], [s1, c1]]"),
        (["[c1 -s1", "s1 c1]"], True, "[c1 -s1; s1 c1]"),
        (["a1*(c1 +", "c12)"], True, "a1*(c1 + c12)"),
        ([r"\begin{bmatrix}", r"c1 & -s1 \\", r"s1 & c1", r"\end{bmatrix}"], True, None),
        (["λ(n - j -", "1) +", "j f"], False, "λ(n - j - 1) + j f"),
        (["", ""], True, ""),
    ],
)
def test_lines_are_recalled_as_one(lines: list[str], is_matrix: bool, text: str | None) -> None:
    """Rows with a semicolon between them, unless a bracket or a sign says that they go on."""
    assert recalled(lines, is_matrix=is_matrix) == (" ".join(lines) if text is None else text)


@given(st.lists(st.lists(st.integers(0, 99), min_size=3, max_size=3), min_size=2, max_size=4), st.booleans())
def test_a_matrix_that_is_recalled_is_the_matrix_that_was_typed(rows: list[list[int]], has_brackets: bool) -> None:
    """Law: with or without brackets around it."""
    lines = [" ".join(map(str, row)) for row in rows]
    if has_brackets:
        lines[0], lines[-1] = f"[{lines[0]}", f"{lines[-1]}]"
    typed, again = "\n".join(lines), recalled(lines, is_matrix=True)
    assert [[cell.expr for cell in row] for row in parse_matrix(again)] == [
        [cell.expr for cell in row] for row in parse_matrix(typed)
    ]


@row_by_row("name", ["planar-two-link", "planar-tow-links", "yim/planar-two-link", "planar-two"])
@row_by_row("command", [("check",), ("show",), ("start",), ("hint",)])
def test_a_name_one_letter_off_is_found_among_exercises(dhcli: Run, command: tuple[str, ...], name: str) -> None:
    """Though a robot's name is not far."""
    done = dhcli(*command, name)
    assert done.code == 2
    assert "did you mean " in done.err
    assert "yim/planar-two-links" in done.err
    assert "planar-2r" not in done.err


@pytest.mark.parametrize("name", ["planr-2r", "puma-560"])
@pytest.mark.parametrize("command", ["check", "show", "fk"])
def test_a_name_one_letter_off_is_found_among_robots(dhcli: Run, command: str, name: str) -> None:
    """Exercises about it are not listed beside it."""
    done = dhcli(command, name)
    assert done.code == 2
    assert f"did you mean {'planar-2r' if name == 'planr-2r' else 'puma560'}" in done.err


@pytest.mark.parametrize("format_", ["table", "json"])
def test_a_question_at_angles_beyond_a_turn_warns_as_fk_does(dhcli: Run, format_: str) -> None:
    """In the same words, where fk has them."""
    asked = ("planar-2r", "--q", "30,45", "--format", format_)
    done, fk = dhcli("check", *asked, "--answer", "1, 2, 3"), dhcli("fk", *asked)
    assert "theta1 = 30 rad is more than a turn; did you mean 30°, or --deg?" in done.err
    assert done.err == fk.err
    if format_ == "json":
        assert done.envelope["problems"] == fk.envelope["problems"]
        assert len(done.envelope["problems"]) == 2
    right = dhcli("check", "planar-2r", "--q", "30,45", "--deg", "--answer", "1, 2, 3")
    assert right.err == ""


def test_the_walk_warns_too_before_it_asks(tmp_path: Path) -> None:
    """An hour of work at the wrong pose would be a pity."""
    with Terminal(tmp_path, "check", "planar-2r", "--q", "30,45") as screen:
        assert "more than a turn" in screen.until("pose> ")
        screen.type("\x04")
        screen.end()


@row_by_row("word", ["dunno", "next", "solution"])
def test_a_word_that_is_no_answer_is_told_at_once(tmp_path: Path, word: str) -> None:
    """It would be the first row of a matrix, and the walk would wait for the others; a name may stand before one."""
    with Terminal(tmp_path, "check", PLANAR, "--part", "a1") as screen:
        screen.until("a1> ")
        screen.type(f"{word}\n")
        told = screen.until("a1> ")
        assert f"'{word}' is no answer, and none of the words hint, why, skip, back, quit, help." in told
        assert ("dhcli solution yim/planar-two-links --part a1 works it out" in told) is (word == "solution")
        screen.type("T\n")
        screen.until("... ")
        screen.type(f"{A1}\n\n")
        assert screen.end() == 0
