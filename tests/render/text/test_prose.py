"""Prose: folded in a window, paragraph by paragraph, and as it stands elsewhere."""

from functools import cache

import pytest

from dhcli.files.library.entries import Kind, entries
from dhcli.files.yaml.exercises import load_exercise
from dhcli.files.yaml.prose import folded
from dhcli.render.look import Look
from dhcli.render.paper import Paper
from dhcli.render.text.exercise import exercise_table
from dhcli.render.text.forward import packed
from dhcli.render.text.marks import question_text
from dhcli.render.text.prose import WIDEST, heading_text, prose_lines
from tests.nightly import some

loaded = cache(load_exercise)
TEXT = "One two three\nfour five.\nSix seven.\n\n- eight nine\n  ten\n"


def test_lines_of_a_paragraph_flow_together() -> None:
    """A line that ends a sentence, an empty one, an indented one and one with a dash stand alone."""
    assert folded(TEXT, 80) == ["One two three four five.", "Six seven.", "", "- eight nine", "  ten"]
    assert folded(TEXT, 14)[:3] == ["One two three", "four five.", "Six seven."]


def test_what_stands_before_the_lines_counts_as_width() -> None:
    """A number before an option, and blanks below it."""
    assert folded("one two three", 10, "1: ", "   ") == ["1: one two", "   three"]


def test_a_word_is_never_broken() -> None:
    """A formula without blanks stays one that can be copied."""
    formula = "r11=" + "c1*" * 30 + "s2"
    assert folded(f"so {formula}", 20) == ["so", formula]


def test_what_is_piped_stays_as_it_stands() -> None:
    """A program that reads it does not depend on a window."""
    assert prose_lines(TEXT, Paper(40)) == TEXT.strip().splitlines()


@pytest.mark.parametrize("width", [60, 80, 200])
def test_the_page_of_every_exercise_fits_its_window(width: int) -> None:
    """Task, prompts, options and what is asked; never wider than is good to read. All are tried where it is narrow."""
    paper = Paper(width, terminal=True)
    for entry in some([*entries(Kind.EXERCISES)], 1 if width == 60 else 4):
        exercise = loaded(entry.name)
        text = exercise_table(exercise, Look(paper=paper))
        text += "".join(question_text(exercise, part, paper) for part in exercise.parts)
        wide = [line for line in text.splitlines() if len(line) > min(width, WIDEST) and "dhcli " not in line]
        assert not wide


@pytest.mark.parametrize("width", [30, 40, 80])
def test_a_heading_is_folded_to_a_window_and_bold_in_each_line(width: int) -> None:
    """In a pipe it stays the one line that a program looks for."""
    text = "Jacobian of parallel-manipulator: frame 6 against frame 0, as if fixed to frame 6"
    lines = heading_text(text, Paper(width, colour=True, terminal=True)).split("\n")
    assert len(lines) > 1
    assert all(line.startswith("\x1b[1m") and line.endswith("\x1b[0m") for line in lines)
    plain = [line[4:-4] for line in lines]
    assert max(map(len, plain)) <= width
    assert " ".join(plain) == text
    assert heading_text(text, Paper(width)) == text


@pytest.mark.parametrize("width", [20, 40, 60])
def test_a_part_longer_than_the_window_is_folded_between_words(width: int) -> None:
    """Not by the terminal in the middle of one; shorter parts stand together as ever."""
    long = "rows v of the origin of frame 3 in m/s above w in rad/s, along the axes of frame 0"
    lines = list(packed(["short", long, "theta1 = 0", "theta2 = 0"], Paper(width, terminal=True)))
    assert max(map(len, lines)) <= width
    assert " ".join(lines).replace(" ·", "") == f"short {long} theta1 = 0 theta2 = 0"
    assert long in list(packed(["short", long], Paper(width)))
