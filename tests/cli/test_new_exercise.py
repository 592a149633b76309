from pathlib import Path

from tests.cli.running import Run


def test_a_new_exercise_lints_once_its_blanks_are_filled_in(dhcli: Run, tmp_path: Path) -> None:
    """Every blank is pointed at; with words in their places nothing is left to mend."""
    written = dhcli("new", "exercise", "my-course/first", "--robot", "planar-2r")
    assert written.code == 0, written.err
    path = tmp_path / "exercises/my-course/first.yaml"
    blank = dhcli("lint", str(path))
    assert blank.code == 1
    assert (blank.out + blank.err).count("is empty") == 5
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
