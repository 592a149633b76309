"""Tables: what gives way on a narrow terminal, and what never does."""

from dhcli.render.paper import Paper, in_ascii
from dhcli.render.text.table import table_text

NAME, TITLE = "a-name-that-somebody-has-to-type", "A title that goes on and on " * 4


def test_on_a_narrow_terminal_titles_are_cut_and_names_are_not() -> None:
    """A name is what a person types next."""
    text = table_text(["name", "title", "from"], [[NAME, TITLE, "built-in"]], Paper(80, terminal=True), cut="title")
    line = text.split("\n")[-2]
    assert len(line) <= 80
    assert NAME in line
    assert "…" in line
    assert line.endswith("built-in")


def test_three_dots_of_ascii_fit_too() -> None:
    """They are wider than the sign that they stand for."""
    paper = Paper(80, terminal=True, unicode=False)
    text = table_text(["name", "title", "from"], [[NAME, TITLE, "built-in"]], paper, cut="title")
    assert "..." in in_ascii(text)
    assert max(map(len, in_ascii(text).split("\n"))) <= 80


def test_on_a_terminal_too_narrow_for_the_names_lines_are_longer_than_it() -> None:
    """Which the terminal folds itself; nothing is lost but the title."""
    text = table_text(["name", "title", "from"], [[NAME, TITLE, "built-in"]], Paper(30, terminal=True), cut="title")
    assert NAME in text
    assert text.count("\n") == 3


def test_through_a_pipe_nothing_is_cut() -> None:
    """Whatever reads it wants all of it."""
    assert TITLE.strip() in table_text(["name", "title"], [[NAME, TITLE]], Paper(80), cut="title")


def test_markup_and_emoji_codes_stay_text() -> None:
    """What stands in a file is never an instruction to the terminal."""
    assert "[red]x[/red] :smile:" in table_text(["a"], [["[red]x[/red] :smile:"]], Paper(80))
