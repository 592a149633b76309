"""What a template leaves to write, and words that only look like it."""

from __future__ import annotations

import pytest

from dhcli.lint.wording import unfinished


@pytest.mark.parametrize("text", ["TODO", "see FIXME.", "XXX", "(TBD)", "write here what the robot is"])
def test_what_is_left_to_write_is_found(text: str) -> None:
    """At its path, by its key, with the word."""
    (found,) = unfinished({("parts", 0, "prompt"): text})
    assert found.where == ("parts", 0, "prompt")
    assert found.message.startswith("prompt: still says '")
    assert found.message.split("'")[1] in text


@pytest.mark.parametrize("text", ["to do", "todo", "XXXL", "METHODOLOGY", "you write here and there"[:9], "0"])
def test_finished_texts_are_left_alone(text: str) -> None:
    """Parts of words, and words in small letters."""
    assert list(unfinished({("task",): text})) == []


def test_each_thing_that_is_left_to_write_is_found() -> None:
    """To the end of its sentence, and once where the same is left twice."""
    text = (
        "Base frame 0: write here where it stands. Joint zero: write here how it looks.\nTip: write here how it looks."
    )
    assert [found.message for found in unfinished({("task",): text})] == [
        "task: still says 'write here where it stands'",
        "task: still says 'write here how it looks'",
    ]


@pytest.mark.parametrize("text", ["", " ", "\n\t "])
def test_a_blank_text_is_found(text: str) -> None:
    """Whatever it is blank with."""
    (found,) = unfinished({("title",): text})
    assert (found.message, found.hint) == ("title: nothing but blanks", "say it, or leave the key out")
