"""Exercise files: what they may say, and every mistake at once with its place."""

from __future__ import annotations

from pathlib import Path

import pytest

from dhcli.checking.exercise import Exercise
from dhcli.checking.kinds.choice import ChoiceQuestion
from dhcli.checking.kinds.count import CountQuestion
from dhcli.checking.kinds.matrix import MatrixQuestion
from dhcli.checking.verdicts import Verdict
from dhcli.errors import FileError, UnknownNameError
from dhcli.files.library.kinds import kind_of
from dhcli.files.library.lookup import Kind, full_id
from dhcli.files.yaml.exercises import load_exercise, read_exercise
from dhcli.notation.angle import Angle

HEAD = "format: 1\ntitle: T\nsource: S\ntask: Do it\nrobot: planar-2r\n"
PARTS = "parts:\n  - {id: t, ask: pose 0..2, hints: [one, two]}\n"


def read(text: str) -> Exercise:
    """An exercise from its text."""
    return read_exercise(text, "my.yaml", "my/own")


def problems(text: str) -> list[str]:
    """Everything that is wrong with a file."""
    with pytest.raises(FileError) as caught:
        read(text)
    return [str(problem) for problem in caught.value.problems]


@pytest.mark.parametrize(
    ("right", "said"),
    [
        ("right: b", "right: should be the number of an option, counted from 1, is 'b' (write 2)"),
        ("right: 0", "right: should be the number of an option, counted from 1, is '0' (write a number from 1 to 2)"),
        (
            "right: 1.5",
            "right: should be the number of an option, counted from 1, is '1.5' (write a number from 1 to 2)",
        ),
        ("right: [1]", "right: should be a text, is a list"),
        ("right:", "right: is empty"),
        ("hints: [x]", "right: should be the number of an option, counted from 1 (write a number from 1 to 2)"),
    ],
)
def test_which_option_is_right_is_told_once(right: str, said: str) -> None:
    """And with a number that there is."""
    parts = "parts:\n  - id: pick\n    ask: choice\n    options: [one, two]\n    "
    found = problems(f"{HEAD.partition('parts:')[0]}{parts}{right}\n")
    assert [said in problem for problem in found if "right" in problem] == [True], found


def test_an_exercise_holds_what_its_file_says() -> None:
    """Names, values, parts, hints, what is printed, and its own tests."""
    exercise = read(
        HEAD
        + "given: {theta1: 30°, e: 5 mm}\nnames: [w]\nunit: mm\nfeedback: expected\npicture: axes\n"
        + "tolerance: {rotation: 0.01, position: 2 mm, angle: 1°, decimals: 3}\n"
        + "parts:\n  - {id: first, ask: link 1, prompt: P, credit: 2.5, hints: [h], exact: true}\n"
        + "  - {id: second, ask: position of pose 0..2, depends: [first]}\n"
        + 'printed: {first: {answer: "[1]", note: lost}, second: "[1 2 3]"}\n'
        + 'tests:\n  - {part: first, answer: "1", verdict: WRONG}\n'
    )
    first, second = exercise.parts
    assert (exercise.id, exercise.title, exercise.unit, exercise.shows_expected) == ("my/own", "T", "mm", True)
    assert exercise.picture == "axes"
    assert exercise.given["theta1"] == Angle.in_degrees(30)
    assert exercise.tolerance.position == pytest.approx(0.002)
    assert (exercise.tolerance.rotation, exercise.tolerance.angle, exercise.tolerance.decimals) == (0.01, 1, 3)
    assert (first.credit, first.hints, first.prompt, second.depends) == (2.5, ("h",), "P", ("first",))
    assert first.tolerance is not None
    assert (first.tolerance.exact, first.tolerance.rotation) == (True, 0.01)
    assert first.printed is not None
    assert (first.printed.text, first.printed.note) == ("[1]", "lost")
    assert second.printed is not None
    assert (second.printed.text, second.tolerance) == ("[1 2 3]", None)
    assert exercise.trials[0].verdict == Verdict.WRONG.word
    assert {"theta1", "theta2", "e", "w"} <= set(exercise.scope.names)


def test_a_source_may_be_a_document_and_an_item() -> None:
    """Or plain text."""
    named = HEAD.replace("source: S", "source: {document: Zhou, item: Ex 3-3-1}")
    assert read(named + PARTS).source == "Zhou, Ex 3-3-1"
    assert read(HEAD + PARTS).source == "S"


def test_an_exercise_needs_no_robot() -> None:
    """Moves, scalars, choices and counts stand on their own."""
    exercise = read(
        "format: 1\ntitle: T\nsource: S\ntask: Do it\nparts:\n"
        "  - {id: a, ask: 'product \"Rot(z, 90°)\"'}\n  - {id: b, ask: scalar 2*3}\n"
        "  - {id: c, ask: choice, options: [yes, no], right: 2}\n  - {id: d, ask: count mobility 6R}\n"
    )
    kinds = [type(part.question) for part in exercise.parts]
    assert kinds[0] is MatrixQuestion
    assert kinds[2:] == [ChoiceQuestion, CountQuestion]
    assert exercise.parts[2].question == ChoiceQuestion(("yes", "no"), 2)


def test_all_mistakes_are_told_at_once_in_their_order() -> None:
    """Each with its line and column."""
    found = problems(
        "format: 1\ntitle: Broken\nsource: {document: X}\nrobot: planar-2\ntsk: nothing\ngiven: {theta1: 30}\n"
        "numeric: maybe\nunit: furlong\nfeedback: always\ntolerance: {rotation: x, size: 1}\nparts:\n"
        "  - {id: pick, ask: choice, options: [a, b], right: 3}\n  - {ask: link 1}\n  - {id: x, ask: link y}\n"
        "tests:\n  - {part: pik, verdict: RIGT}\npicture: all\n"
    )
    starts = [
        "my.yaml:1:1: task: is missing",
        "my.yaml:3:9: item: is missing",
        "my.yaml:4:8: robot: there is no robot 'planar-2' (did you mean planar-2r",
        "my.yaml:5:1: tsk: unknown key (did you mean task",
        "my.yaml:6:17: theta1: the angle 30 has no unit (write 30°",
        "my.yaml:7:10: numeric: should be true or false, is 'maybe'",
        "my.yaml:8:1: unit: 'furlong' is no unit of length",
        "my.yaml:9:1: feedback: 'always' is not known (write expected)",
        "my.yaml:10:23: rotation: x is not a name",
        "my.yaml:10:26: size: unknown key",
        "my.yaml:12:53: right: should be the number of an option, counted from 1, is '3' (write a number from 1 to 2)",
        "my.yaml:13:5: id: is missing",
        "my.yaml:14:18: 'link y' asks nothing that is known (did you mean link 1",
        "my.yaml:16:6: part: there is no part pik (did you mean pick?)",
        "my.yaml:16:17: verdict: 'RIGT' is not known (one of RIGHT, EQUIVALENT, ROUNDED, CLOSE, WRONG,",
        "my.yaml:17:1: picture: 'all' is not known (write none, axes, frames)",
    ]
    assert len(found) == len(starts), found
    for problem, start in zip(found, starts, strict=True):
        assert problem.startswith(start)


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ("parts:\n  - {id: t, ask: pose 0..3}\n", "frame 3"),
        ("parts:\n  - {id: t, ask: link 5}\n", "has no frame 4 (frames: "),
        ("parts:\n  - {id: t, ask: cell beta 1}\n", "no column 'beta' (columns: "),
        ("parts:\n  - {id: t, ask: table craig}\n", "no table 'craig'"),
        ("parts:\n  - {id: t, ask: 'point (1, 2) of pose 0..2'}\n", "a point has three coordinates, not 2"),
        ("parts:\n  - {id: t, ask: scalar 2*b7}\n", "b7 is not a name"),
        ("parts:\n  - {id: t, ask: count wheels 6R}\n", "'count wheels 6R' is not understood"),
        ("parts:\n  - {id: t, ask: count mobility nothing-at-all}\n", "nothing-at-all"),
        ("parts:\n  - {id: t, ask: link 1, compare: samerobot}\n", "compare: 'samerobot' is not known (did you"),
        ("parts:\n  - {id: t, ask: link 1, credit: one}\n", "one is not a name"),
        ("parts:\n  - {id: t, ask: link 1, decimals: 1.5}\n", "decimals: '1.5' is not a whole number"),
        ("parts:\n  - {id: t, ask: link 1, hint: [a]}\n", "hint: unknown key (did you mean hints"),
        ("parts:\n  - {id: 'a b', ask: link 1}\n", "holds more than letters, digits, _ and -"),
        ("parts:\n  - {id: t, ask: link 1}\n  - {id: t, ask: link 2}\n", "the id t is used twice"),
        ("parts:\n  - {id: t, ask: link 1, depends: [u]}\n", "t depends on u, which does not stand before it"),
        ("parts:\n  - {id: t, ask: poze 0..2}\ntests:\n  - {part: t, answer: 1, verdict: WRONG}\n", "mean pose 0..3?"),
        ("parts:\n  - {id: t, ask: link 1, numeric: false}\n", "stands at the top of the file, and holds for all"),
        ("parts:\n  - {id: t, ask: link 1, credit: three}\n", "credit: three is not a name"),
        ("parts:\n  - {id: t, ask: link 1, decimals: 13}\n", "decimals: 13 cannot be asked for (1 to 12)"),
        ("parts: []\n", "parts: an exercise has at least one (write - {id: a1, ask: link 1})"),
        ("parts: {t: 1}\n", "parts: should be a list, is a mapping (write - {id: a1, ask: link 1})"),
        ("parts: [t]\n", "parts: should be a mapping, is a text (write {id: a1, ask: link 1})"),
        (PARTS + "tests: [t]\n", "should be a mapping, is a text (write {part: a1, answer: ..., verdict: WRONG})"),
        (PARTS + "tests: [{part: t, answer: 1, verdict: CORRECT}]\n", "'CORRECT' is not known (one of RIGHT, EQ"),
        (PARTS + "given: [30°]\n", "given: should be a mapping, is a list (write {theta1: 30°})"),
        (PARTS + "tolerance: {decimals: 30}\n", "decimals: 30 cannot be asked for (1 to 12)"),
        (PARTS + "unit: mm\ngiven: {a1: 100}\n", "a1: a length without its unit, on a sheet in mm (write 100 mm)"),
        (PARTS + "unit: mm\nvariants: {a1: 100..300}\n", "write 100 mm..300 mm step 10 mm"),
        (PARTS + "unit: mm\nvariants: {a1: 100..300 step 20}\n", "write 100 mm..300 mm step 20 mm"),
        (PARTS + "unit: mm\nvariants: {a1: [100, 0]}\n", "write [100 mm, 0 mm]"),
        (PARTS + "printed: {u: '[1]'}\n", "printed: there is no part u"),
        (PARTS + "tolerance: {position: -1 mm}\n", "a tolerance is not negative"),
        (PARTS + "tolerance: {position: x}\n", "x is not a name"),
        (PARTS + "tolerance: {angle: 1}\n", "the angle 1 has no unit"),
        (PARTS + "given: {a1: 30°}\n", "a1: "),
        (PARTS + "also: {note: n}\n", "robot: is missing"),
        (PARTS + "also: {robot: nobody}\n", "nobody"),
        (PARTS + "format: 1\n", "format: stands twice"),
    ],
)
def test_a_mistake_is_told_once(line: str, said: str) -> None:
    """In words that say what would be right."""
    found = problems(HEAD + line)
    assert len(found) == 1, found
    assert said in found[0]


@pytest.mark.parametrize(
    ("line", "place"),
    [
        ("  - {id: t, ask: link 1}\n  - {id: t, ask: link 2}\n", "my.yaml:8:6: id: the id t is used twice"),
        ("  - {id: t, ask: link 1, depends: [u]}\n", "my.yaml:7:26: depends: t depends on u"),
    ],
)
def test_a_slip_of_a_part_is_told_at_the_part(line: str, place: str) -> None:
    """Not where the list of all parts begins."""
    (found,) = problems(HEAD + "parts:\n" + line)
    assert found.startswith(place)


def test_a_robot_that_is_not_found_is_told_alone() -> None:
    """Names, frames and questions are not said to be wrong for want of it."""
    text = HEAD.replace("planar-2r", "crain") + "given: {theta1: 30°, a1: 5 mm}\n"
    (found,) = problems(f"{text}parts:\n  - {{id: t, ask: pose 0..2}}\n  - {{id: u, ask: scalar 2*a1 + a2}}\n")
    assert "there is no robot 'crain'" in found


def test_a_bare_length_is_one_where_the_sheet_is_in_metres() -> None:
    """Or has no unit."""
    for unit in ("m", "none"):
        assert "a1" in read(HEAD + PARTS + f"unit: {unit}\ngiven: {{a1: 0.1}}\n").given


def test_a_file_of_a_later_format_is_refused() -> None:
    """It may mean something else."""
    assert "2" in problems(HEAD.replace("format: 1", "format: 2") + PARTS)[0]


def test_an_exercise_is_found_by_its_short_name(tmp_path: Path) -> None:
    """Where only one ends so; and a file by its path."""
    assert full_id("planar-two-links") == "yim/planar-two-links"
    assert load_exercise("planar-two-links").id == "yim/planar-two-links"
    path = tmp_path / "mine.yaml"
    path.write_text(HEAD + PARTS, "utf-8")
    assert load_exercise(str(path)).id == "mine"
    assert load_exercise(path).id == "mine"


def test_an_unknown_exercise_is_refused_with_the_nearest() -> None:
    """As robots are."""
    with pytest.raises(UnknownNameError) as caught:
        load_exercise("planar-two-link")
    assert "planar-two-links" in caught.value.problems[0].hint


def test_what_is_an_exercise_is_seen_by_name_and_by_content(tmp_path: Path) -> None:
    """A robot has links and no parts; so has what is not there, until somebody loads it."""
    exercise, robot = tmp_path / "e.yaml", tmp_path / "r.yaml"
    exercise.write_text(HEAD + PARTS, "utf-8")
    robot.write_text("links:\n  - {a: 1}\n", "utf-8")
    for name in ("planar-two-links", "yim/planar-two-links", str(exercise)):
        assert kind_of(name) is Kind.EXERCISES
    for name in ("planar-2r", str(robot), str(tmp_path / "none.yaml"), "-"):
        assert kind_of(name) is Kind.ROBOTS
    assert kind_of("planar-four-bar") is Kind.LINKAGES


def test_a_table_whose_rows_share_a_joint_is_not_asked_for_nor_its_frames() -> None:
    """In an answer each joint has one cell, so no answer could be right."""
    for asked in ("table standard", "frames standard"):
        text = HEAD.replace("planar-2r", "palletizer") + f"parts: [{{id: t, ask: {asked}}}]\n"
        assert any("ask: its rows share a joint" in problem for problem in problems(text))
