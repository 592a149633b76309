"""`dhcli help`: pages of the manual for people, and as Markdown for everybody else."""

from __future__ import annotations

import importlib
import re
from pathlib import Path

import pytest

from dhcli.cli import app
from dhcli.files.manual import read_page, topics
from dhcli.render.paper import Paper
from dhcli.render.text.manual import page_text
from tests.cli.running import Run
from tests.cli.terminal import Terminal
from tests.nightly import in_turn, paired
from tests.row_by_row import row_by_row


def test_without_a_topic_all_are_listed(dhcli: Run) -> None:
    """Each with its heading."""
    done = dhcli("help")
    assert done.code == 0
    assert all(f"[`{topic.name}`]" in done.out and topic.title in done.out for topic in topics())


def test_a_page_in_a_pipe_is_markdown(dhcli: Run) -> None:
    """As it stands in the manual, so that grep finds what an editor would."""
    assert dhcli("help", "fk").out == read_page("fk")


@row_by_row("name", app.COMMANDS)
def test_a_command_is_a_topic(dhcli: Run, name: str) -> None:
    """The page in whose heading it stands."""
    done = dhcli("help", name)
    assert done.code == 0
    assert f"`dhcli {name}" in done.out.partition("\n")[0]


@pytest.mark.parametrize(
    ("typed", "hint"),
    [
        ("exercise", "did you mean exercises or exercise-files?"),
        ("convnetions", "did you mean conventions"),
        ("credit", "it is spoken of in judging, "),
        ("joint values", "it is spoken of in "),
        ("robts", "did you mean robots?;"),
        ("xyzzy", "dhcli help lists the topics"),
    ],
)
def test_an_unknown_topic_is_answered_with_the_nearest(dhcli: Run, typed: str, hint: str) -> None:
    """By letters, by how a topic begins, or by what pages speak of."""
    done = dhcli("help", typed)
    assert (done.code, done.out) == (2, "")
    assert f"the manual has no page '{typed}'" in done.err
    assert hint in done.err


@pytest.mark.parametrize(("name", "unicode"), in_turn(paired([topic.name for topic in topics()], [True, False]), 0, 3))
def test_running_text_fits_a_narrow_window(name: str, *, unicode: bool) -> None:
    """Examples and tables are as wide as they are; in ASCII every letter is."""
    text = page_text("# One\n\n" + "words and `code` " * 40, Paper(40, terminal=True, unicode=unicode))
    assert max(map(len, text.splitlines())) <= 40
    drawn = page_text(read_page(name), Paper(40, terminal=True, unicode=unicode))
    assert unicode or drawn.isascii()
    assert "\x1b" not in drawn


def test_an_example_is_never_folded() -> None:
    """A matrix in two halves is none."""
    line = "x" * 120
    assert f"  {line}\n" in page_text(f"# One\n\n```text\n{line}\n```\n", Paper(60, terminal=True))


def test_headings_have_colour_where_there_is_any() -> None:
    """And no box around them."""
    drawn = page_text("# One `two`\n\nText.\n\n## Three\n", Paper(60, colour=True, terminal=True))
    assert "\x1b[1" in drawn
    assert [line.rstrip() for line in re.sub(r"\x1b\[[0-9;]*m", "", drawn).splitlines()] == [
        "One two",
        "",
        "Text.",
        "",
        "Three",
    ]


def test_a_long_page_goes_to_the_pager(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The one the user has chosen."""
    pager = tmp_path / "pager"
    pager.write_text("#!/bin/sh\necho the pager has $(wc -l) lines\n", "utf-8")
    pager.chmod(0o755)
    monkeypatch.setenv("PAGER", str(pager))
    with Terminal(tmp_path, "help", "conventions", own_process=True) as terminal:
        assert "the pager has" in terminal.until(r"lines")
        assert terminal.end() == 0


@row_by_row("name", app.COMMANDS)
def test_examples_of_help_fit_a_usual_window(dhcli: Run, name: str) -> None:
    """At 80 columns none of them is folded, so that it can be copied in one go."""
    lines = dhcli(name, "--help").out.split("\n")
    examples = [line.strip() for line in lines if line.startswith(" dhcli ")]
    module = importlib.import_module(f"dhcli.cli.commands.{name}")
    typed = [line for line in getattr(module, "EXAMPLES", "").split("\n") if line.startswith("dhcli ")]
    assert all(len(line) <= 78 for line in typed), max(typed, key=len)
    assert set(typed) <= set(examples)


def test_help_of_an_option_speaks_of_no_other_that_the_command_has_not(dhcli: Run) -> None:
    """`describe` has no --q that could vary a pose, and `show` shows more than robots."""
    assert "varies it" not in dhcli("describe", "--help").out
    assert "varies it" in dhcli("fk", "--help").out
    assert "needs 'NAME'\n  hint: NAME is a robot, a linkage or an exercise" in dhcli("show").err
    assert "hint: ROBOT is a name of the library" in dhcli("fk").err
