"""New exercise files: for every robot they lint once their blanks are filled in, in letters and in numbers."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from dhcli.errors import DhcliError
from dhcli.files.library.entries import Kind, entries
from dhcli.files.yaml.exercise_template import exercise_template
from dhcli.files.yaml.exercises import read_exercise
from dhcli.files.yaml.robots import load_robot
from dhcli.lint import variants
from dhcli.lint.files import lint
from tests.judging import expected
from tests.nightly import some

ROBOTS = [entry.name for entry in entries(Kind.ROBOTS) if load_robot(entry.name).variables]


def filled(text: str, *, with_answer: bool = True) -> str:
    """The template with words in its blanks, and the right answer in its test."""
    words = text.replace('title: ""', "title: T").replace('source: ""', "source: S").replace('[""]', "[look closely]")
    words = words.replace("write here", "the place and")
    if not with_answer:
        return words
    exercise = read_exercise(words.replace('answer: ""', "answer: 1"), "new.yaml", "c/new")
    right = expected(exercise, exercise.part("tip"))
    return words.replace('answer: ""', f'answer: "{right}"')


def in_numbers(text: str) -> str:
    """The template with the # before its last lines taken away, as it says."""
    head, _, tail = text.partition("# Numbers instead of letters")
    return head + re.sub(r"^# (?=\w+:)", "", "# Numbers instead of letters" + tail, flags=re.MULTILINE)


def errors(folder: Path, text: str) -> list[str]:
    """What lint calls an error."""
    path = folder / "new.yaml"
    path.write_text(text, "utf-8")
    return [str(told.problem) for told in lint([str(path)]).told if not told.is_warning]


@pytest.mark.parametrize("name", some(ROBOTS, 12))
def test_a_template_lints_once_its_blanks_are_filled_in(name: str, tmp_path: Path) -> None:
    """In letters, as it is written."""
    text = exercise_template("c/new", load_robot(name))
    blank = errors(tmp_path, text)
    assert sum("is empty" in line for line in blank) == 6
    left = [line for line in blank if "task: still says 'write here" in line]
    assert len(left) == 4
    (no_answer,) = [line for line in blank if "tip: the answer of the test is empty; it says RIGHT" in line]
    assert len(blank) == 6 + len(left)
    unsaid = errors(tmp_path, filled(text).replace("the place and", "write here"))
    assert [line.partition("task")[2] for line in unsaid] == [line.partition("task")[2] for line in left]
    assert errors(tmp_path, filled(text, with_answer=False)) == [no_answer]
    assert errors(tmp_path, filled(text)) == []


@pytest.mark.parametrize(
    "name", some(["planar-2r", "cartesian", "scara-yim", "dh-link-modified", "panda", "puma200"], 3)
)
def test_a_template_lints_in_numbers_too(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """With the # taken away from its last lines; a few variants of each are drawn."""
    monkeypatch.setattr(variants, "SEEDS", some(variants.SEEDS, 50))
    text = in_numbers(exercise_template("c/new", load_robot(name)))
    assert "\nnumeric: true\n" in text
    assert errors(tmp_path, filled(text)) == []


@pytest.mark.parametrize(
    ("name", "hint"),
    [("first", "write dhcli new exercise my-course/first"), ("c/with blank", ""), ("../up", ""), ("c/", "")],
)
def test_a_name_that_cannot_be_is_refused(name: str, hint: str) -> None:
    """With what would do."""
    with pytest.raises(DhcliError) as caught:
        exercise_template(name, load_robot("scara"))
    assert hint in caught.value.problems[0].hint


def test_a_robot_without_joints_is_refused() -> None:
    """There is nothing to ask."""
    with pytest.raises(DhcliError, match="has no joint to ask about"):
        exercise_template("c/new", load_robot("assembly-blocks"))
