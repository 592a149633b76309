"""Problems in words: what many lines have in common is told once."""

from __future__ import annotations

from dhcli.errors import Place, Problem
from dhcli.render.paper import Paper
from dhcli.render.text.problems import others_text, problems_text

PLAIN = Paper(80)


def at(line: int, message: str = "is empty", hint: str = "fill it in") -> Problem:
    """A problem in a line of a file."""
    return Problem(message, Place("q.csv", line, 3, "a,,b"), hint)


def test_what_three_lines_have_in_common_is_told_once_with_all_lines() -> None:
    """In the order of the file; what is said twice is told twice."""
    text = problems_text([at(1), at(2), at(3, "is odd"), at(4), at(5), at(6), at(9, "is odd")], PLAIN)
    assert [line for line in text.splitlines() if not line.startswith("  a") and "^" not in line] == [
        "dhcli: q.csv:1:3: is empty",
        "  hint: fill it in",
        "  the same in lines 2 and 4 to 6",
        "dhcli: q.csv:3:3: is odd",
        "  hint: fill it in",
        "dhcli: q.csv:9:3: is odd",
        "  hint: fill it in",
    ]


def test_what_stands_nowhere_or_has_another_hint_is_told_by_itself() -> None:
    """Nobody could say where the others are."""
    nowhere = [Problem("no"), Problem("no"), Problem("no")]
    assert problems_text(nowhere, PLAIN).count("dhcli: no") == 3
    assert problems_text([at(1), at(2), at(3, hint="or leave it out")], PLAIN).count("is empty") == 3


def test_a_line_of_another_file_and_one_that_is_told_twice_are_no_other_lines_of_the_first() -> None:
    """Lines are told without the name of their file; several problems may share one place."""
    others = [Problem("is empty", Place("p.csv", line), "fill it in") for line in (2, 4, 6)]
    text = problems_text([at(1), *others, at(5)], PLAIN)
    assert [line for line in text.splitlines() if "is empty" in line or "same" in line] == [
        "dhcli: q.csv:1:3: is empty",
        "dhcli: p.csv:2: is empty",
        "  the same in lines 4 and 6",
        "dhcli: q.csv:5:3: is empty",
    ]
    once = at(1)
    assert problems_text([once, once, once, at(4)], PLAIN).count("is empty") == 1
    assert problems_text([Problem("no"), *(Problem("no", Place("q.npy[4]")) for _ in range(3))], PLAIN).count("no") == 4


def test_other_places_are_told_by_their_lines_or_by_their_names() -> None:
    """Rows of arrays have no lines, and a line that has two cells counts once."""
    assert others_text([Place("f", 7, 1), Place("f", 7, 5)]) == "in line 7"
    assert others_text([Place("f", k) for k in (2, 3, 9)]) == "in lines 2, 3 and 9"
    assert others_text([Place("q.npy[4]"), Place("q.npy[5]")]) == "at q.npy[4], q.npy[5]"
