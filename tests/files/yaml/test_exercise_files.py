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
from dhcli.files.library.entries import Kind, full_id
from dhcli.files.library.kinds import kind_of
from dhcli.files.yaml.exercises import load_exercise, read_exercise
from dhcli.notation.angle import Angle
from tests.row_by_row import row_by_row

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
        ("right: b", "right: 'b' is not the number of one of the 2 options, counted from 1 (write 2)"),
        ("right: 0", "right: '0' is not the number of one of the 2 options, counted from 1 (write 1 to 2)"),
        ("right: 1.5", "right: '1.5' is not the number of one of the 2 options, counted from 1 (write 1 to 2)"),
        ("right: [1]", "right: should be a text, is a list"),
        ("right:", "right: is empty"),
        ("hints: [x]", "right: is missing (write 1 to 2)"),
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
        "my.yaml:3:9: item: is missing",
        "my.yaml:4:8: robot: there is no robot 'planar-2' (did you mean planar-2r",
        "my.yaml:5:1: tsk: unknown key (did you mean task",
        "my.yaml:6:17: theta1: the angle 30 has no unit (write 30°",
        "my.yaml:7:10: numeric: should be true or false, is 'maybe'",
        "my.yaml:8:7: unit: 'furlong' is not known",
        "my.yaml:9:11: feedback: 'always' is not known (write expected, or leave it out)",
        "my.yaml:10:23: rotation: x is not a name",
        "my.yaml:10:26: size: unknown key",
        "my.yaml:12:53: right: '3' is not the number of one of the 2 options, counted from 1 (write 1 to 2)",
        "my.yaml:13:5: id: is missing",
        "my.yaml:14:18: 'link y' asks nothing that is known (did you mean link 1",
        "my.yaml:16:5: answer: is missing (write answer: ..., or mistake: sin-cos 1)",
        "my.yaml:16:6: part: there is no part pik (did you mean pick?)",
        "my.yaml:16:17: verdict: 'RIGT' is not known (write RIGHT)",
        "my.yaml:17:10: picture: 'all' is not known (known: none, axes, frames)",
    ]
    assert len(found) == len(starts), found
    for problem, start in zip(found, starts, strict=True):
        assert problem.startswith(start)


@row_by_row(
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
        (PARTS + "tests: [{part: t, answer: 1, verdict: CORRECT}]\n", "'CORRECT' is not known (write RIGHT)"),
        (PARTS + "tests: [{part: t, answer: 1, verdict: wrong}]\n", "'wrong' is not known (write WRONG)"),
        (PARTS + "tests: [{part: t, answer: 1, verdict: maybe}]\n", "'maybe' is not known (one of RIGHT, EQ"),
        (
            PARTS + "tests: [{part: t, verdict: WRONG}]\n",
            "answer: is missing (write answer: ..., or mistake: sin-cos 1)",
        ),
        (
            PARTS + "tests: [{part: t, answer: 1, mistake: transposed, verdict: WRONG}]\n",
            "mistake: a test tries an answer or a mistake, and not both",
        ),
        ("parts:\n  - {id: t, ask: choice}\n", "options: is missing"),
        ("parts:\n  - {id: t, ask: choice, options: [a, b]}\n", "right: is missing (write 1 to 2)"),
        ("parts:\n  - {id: t, ask: choice, options: [a, b], right: yes}\n", "right: 'yes' is not the number of one"),
        (PARTS + "given: {θ1: 20°, theta_1: 30°}\n", "given: theta1 stands twice"),
        (PARTS + "hints: [a]\n", "hints: unknown key (it stands in a part, below parts:)"),
        (PARTS + "decimals: 2\n", "decimals: unknown key (it stands below tolerance:)"),
        (PARTS + "solution: x\n", "solution: unknown key (answers are computed; those under tests: are tried)"),
        (PARTS + "author: me\n", "author: unknown key (a key of your own begins with x-: x-author)"),
        ("parts:\n  - {id: t, question: link 1}\n", "question: unknown key (did you mean ask?)"),
        (
            "parts:\n  - {id: t, ask: choice, choices: [a, b], right: 1}\n",
            "choices: unknown key (did you mean options?)",
        ),
        ("parts:\n  - {id: t, ask: table}\n", "which table? (write table standard or table modified)"),
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


@row_by_row(
    ("ask", "hint"),
    [
        ("position of T02", "write position of pose 0..2"),
        ("T_{0,2}", "write pose 0..2"),
        ("pose 0-2", "write pose 0..2"),
        ("rotation of pose 0 to 2", "write rotation of pose 0..2"),
        ("A_2", "write link 2"),
        ("linear jacobian of 0..2", "write jacobian linear of 0..2"),
        ("Jacobian matrix", "write jacobian"),
        ("det J", "write determinant of jacobian"),
        ("det(J)", "write determinant of jacobian"),
        ("determinant of the linear Jacobian", "write determinant of jacobian linear"),
        ("rank(J)", "write rank of jacobian"),
        ("singularities", "write singular when"),
        ("singularities of 0..2", "write singular when 0..2"),
        ("linear velocity of 0..2", "write velocity of 0..2"),
        ("number of links of bennett", "write count links bennett"),
        ("mobility of the bennett", "write count mobility bennett"),
        ("degrees of freedom of bennett", "write count mobility bennett"),
        ("inverse of link A2", "write inverse of link 2"),
        ("entry (1,2) of pose 0..2", "write entry 1 2 of pose 0..2"),
        ("entry 12 of T02", "write entry 1 2 of pose 0..2"),
        ("product Rot(z, 90°) Trans(1, 0, 0)", 'write product "Rot(z, 90°) Trans(1, 0, 0)"'),
        ("DH table", "did you mean table standard?"),
        ("standard table", "write table standard"),
        ("the modified DH table", "write table modified"),
        ("alpha of link 1", "write cell alpha 1"),
        ("z axis of pose 0..2", "write axis z of pose 0..2"),
        ("roll, pitch and yaw of pose 0..2", "write rpy of pose 0..2"),
        ("zyz angles of pose 0..2", "write euler zyz of pose 0..2"),
        ("joint torques for (1, 0, 0) of 0..2", "write torques for (1, 0, 0) of 0..2"),
        ("torque (1, 0, 0) of pose 0..2", "write torques for (1, 0, 0) of 0..2"),
        ("rates for (1, 0, 0) of 0..2", "write joint rates for (1, 0, 0) of 0..2"),
        ("joint values for position (0.1, 0.2, 0)", "write joints of position (0.1, 0.2, 0)"),
        ("number of solutions of position (0.1, 0.2, 0)", "write count solutions of position (0.1, 0.2, 0)"),
        ("velocity of pose 0..2 with rates (1, 2)", "write velocity of 0..2 with rates (1, 2)"),
        ("determinant of jacobian linear of pose 0..2", "write determinant of jacobian linear of 0..2"),
        ("inverse kinematics", "did you mean joints of position (0.5, 0.3, 0)?"),
        ("poze 0..2", "did you mean pose 0..3?"),
    ],
)
def test_a_question_in_other_words_is_told_in_those_of_dhcli(ask: str, hint: str) -> None:
    """With the author's own frames where they are clear."""
    (found,) = problems(HEAD + f"parts:\n  - {{id: t, ask: '{ask}'}}\n")
    assert found.endswith(f"asks nothing that is known ({hint})")


def test_a_question_of_no_known_kind_is_shown_a_few_and_where_all_are() -> None:
    """Not forty."""
    (found,) = problems(HEAD + "parts:\n  - {id: t, ask: xyz}\n")
    assert "such as link 1 · pose 0..3 · " in found
    assert found.endswith("; dhcli help exercise-files lists all)")


def test_names_of_a_robot_are_known_in_every_spelling() -> None:
    """θ1 is theta1, in values given and in those that vary."""
    exercise = read(HEAD + PARTS + "given: {θ1: 20°}\nvariants: {theta_2: 20°..40° step 5°}\n")
    assert list(exercise.given) == ["theta1"]
    assert list(exercise.variants) == ["theta2"]


@pytest.mark.parametrize(("word", "is_set"), [("true", True), ("Yes", True), ("False", False), ("no", False)])
def test_a_flag_is_yes_or_no_in_any_spelling(word: str, *, is_set: bool) -> None:
    """As other programs that read YAML take it."""
    assert read(HEAD + PARTS + f"numeric: {word}\ngiven: {{theta1: 1°, theta2: 2°}}\n").numeric is is_set


def test_answers_under_tests_and_printed_may_be_lists_as_on_a_sheet() -> None:
    """A matrix as YAML has it, and a vector."""
    rows = "[[c1, -s1, 0, a1*c1], [s1, c1, 0, a1*s1], [0, 0, 1, 0], [0, 0, 0, 1]]"
    parts = "parts:\n  - {id: t, ask: link 1}\n  - {id: p, ask: position of link 1}\n"
    tests = f"tests:\n  - {{part: t, answer: {rows}, verdict: RIGHT}}\n"
    printed = "printed:\n  p: [a1*c1, a1*s1, 0]\n  t:\n    answer:\n      - [c1]\n      - [s1]\n"
    exercise = read_exercise(HEAD + parts + tests + printed, "my.yaml", "my")
    assert exercise.trials[0].answer == rows
    printed_of = {part.id: part.printed.text for part in exercise.parts if part.printed is not None}
    assert printed_of == {"p": "[a1*c1, a1*s1, 0]", "t": "[[c1], [s1]]"}


@pytest.mark.parametrize(("right", "hint"), [("its axis", "write 1"), ("b", "write 2"), ("its length", "write 1 to 2")])
def test_the_right_option_in_words_is_told_with_its_number(right: str, hint: str) -> None:
    """Or by its letter."""
    part = f"  - {{id: t, ask: choice, options: [its axis, its origin], right: {right}}}\n"
    (found,) = problems(f"{HEAD}parts:\n{part}")
    assert found.endswith(f"({hint})")
