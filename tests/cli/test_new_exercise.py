from pathlib import Path

import pytest

from tests.cli.running import Run


def test_a_new_exercise_lints_once_its_blanks_are_filled_in(dhcli: Run, tmp_path: Path) -> None:
    """Every blank is pointed at; with words in their places nothing is left to mend."""
    written = dhcli("new", "exercise", "my-course/first", "--robot", "planar-2r")
    assert written.code == 0, written.err
    path = tmp_path / "exercises/my-course/first.yaml"
    blank = dhcli("lint", str(path))
    assert blank.code == 1
    assert (blank.out + blank.err).count("is empty") == 6
    assert blank.out.count("still says 'write here") == 4
    text = path.read_text("utf-8").replace('title: ""', "title: A first arm").replace('source: ""', "source: my notes")
    text = text.replace("write here", "the place").replace('hints: [""]', "hints: [look at the table]")
    text = text.replace('answer: "", verdict: RIGHT', 'answer: "a1 c1 + a2 c12, a1 s1 + a2 s12, 0", verdict: RIGHT')
    path.write_text(text, "utf-8")
    filled = dhcli("lint", str(path))
    assert (filled.code, "nothing to mend" in filled.out + filled.err) == (0, True)


def test_an_exercise_without_a_course_is_refused(dhcli: Run) -> None:
    """The hint says what to write."""
    refused = dhcli("new", "exercise", "first", "--robot", "planar-2r")
    assert refused.code == 2
    assert "my-course/first" in refused.err


ARM = """format: 1
title: An arm
source: a test
convention: standard
variables: [t1]
links: [{a: 1, alpha: 0, d: 0, theta: t1}]
"""


def test_the_path_of_a_robot_begins_at_the_file_that_names_it(
    dhcli: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Wherever it is read from; `new` writes it so, and what is not there is told with the folder looked in."""
    arms, task = tmp_path / "arms", tmp_path / "exercises/c/one.yaml"
    arms.mkdir()
    (arms / "arm.yaml").write_text(ARM, "utf-8")
    assert dhcli("new", "exercise", "c/one", "--robot", "arms/arm.yaml").code == 0
    text = task.read_text("utf-8")
    assert "robot: '../../arms/arm.yaml'\n" in text
    for folder in (tmp_path, arms, task.parent):
        monkeypatch.chdir(folder)
        assert "robot:" not in dhcli("lint", str(task)).out
    beside = arms / "two.yaml"
    beside.write_text(text.replace("../../arms/arm.yaml", "arm.yaml"), "utf-8")
    assert "robot:" not in dhcli("lint", str(beside)).out
    beside.write_text(text.replace("../../arms/arm.yaml", "./leg.yaml"), "utf-8")
    missing = dhcli("lint", str(beside)).out
    assert f"robot: {arms / 'leg.yaml'}: there is no such file" in missing
    assert f"looked in {arms}" in missing
