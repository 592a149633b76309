"""Tables: what gives way on a narrow terminal, and what never does."""

import pytest

from dhcli.render.paper import Paper, in_ascii
from dhcli.render.text.table import Inked, columns_of, table_text

NAME, TITLE = "a-name-that-somebody-has-to-type", "A title that goes on and on " * 4


def test_on_a_narrow_terminal_titles_are_folded_between_words_and_nothing_is_lost() -> None:
    """A name is what a person types next, and a title what it is chosen by."""
    text = table_text(["name", "title", "from"], [[NAME, TITLE, "built-in"]], Paper(80, terminal=True), fold="title")
    _, _, line, *more = text.splitlines()
    assert max(map(len, text.splitlines())) <= 80
    assert line.split()[0] == NAME
    assert line.endswith("built-in")
    title = [line.removesuffix("built-in").split(maxsplit=1)[1], *more]
    assert " ".join(" ".join(title).split()) == TITLE.strip()
    assert all(one.startswith(" " * line.index("A title")) for one in more)


@pytest.mark.parametrize("unicode", [True, False])
def test_what_stands_for_other_letters_fits_too(*, unicode: bool) -> None:
    """In ASCII they may be wider than the signs that they stand for, and wide letters take two columns."""
    paper = Paper(80, terminal=True, unicode=unicode)
    text = table_text(["name", "title"], [[NAME, "θ … ± 机器人" * 20]], paper, fold="title")
    assert max(map(columns_of, (text if unicode else in_ascii(text)).splitlines())) <= 80


def test_each_line_of_a_folded_cell_has_its_colour() -> None:
    """The blanks that fill its column have none."""
    paper = Paper(80, colour=True, terminal=True)
    text = table_text(["name", "title"], [[NAME, Inked(paper.ink(TITLE.strip(), "red"))]], paper, fold="title")
    lines = [line for line in text.splitlines() if "\x1b[31m" in line]
    assert len(lines) > 1
    assert all(line.endswith("\x1b[0m") and line.count("\x1b") == 2 for line in lines)


def test_on_a_terminal_too_narrow_for_the_names_lines_are_longer_than_it() -> None:
    """Which the terminal folds itself; nothing is lost."""
    text = table_text(["name", "title"], [[NAME, TITLE]], Paper(30, terminal=True), fold="title")
    assert NAME in text
    assert text.split()[3:] == [NAME, *TITLE.split()]


def test_through_a_pipe_nothing_is_folded() -> None:
    """Whatever reads it wants a line for each row."""
    assert TITLE.strip() in table_text(["name", "title"], [[NAME, TITLE]], Paper(80), fold="title")


def test_markup_and_emoji_codes_stay_text() -> None:
    """What stands in a file is never an instruction to the terminal."""
    assert "[red]x[/red] :smile:" in table_text(["a"], [["[red]x[/red] :smile:"]], Paper(80))
