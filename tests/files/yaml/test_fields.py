"""Taking fields out of a file: every problem is told, all at once, and the loader still gets a value."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from dhcli.errors import FileError, NotationError, Place, Problem, RobotError
from dhcli.files.yaml.exercises import load_exercise
from dhcli.files.yaml.fields import Fields, Problems
from dhcli.files.yaml.frames import read_frames
from dhcli.files.yaml.linkages import load_linkage
from dhcli.files.yaml.placed import PlacedScalar, read_yaml
from dhcli.files.yaml.robots import load_robot
from dhcli.files.yaml.sheets import read_sheet
from dhcli.files.yaml.slips import node_kind
from tests.row_by_row import row_by_row

KNOWN = ("title", "source", "links", "parameters")


def document(text: str, *required: str) -> tuple[Problems, Fields]:
    """The fields of a file, and where its problems gather."""
    problems = Problems()
    return problems, problems.document(read_yaml(text, "robot.yaml"), known=KNOWN, required=required)


def said(problems: Problems) -> list[str]:
    """The problems that would be raised."""
    with pytest.raises(FileError) as caught:
        problems.raise_if_any()
    return [str(problem) for problem in caught.value.problems]


def test_a_right_file_has_no_problem() -> None:
    """Texts, lists and mappings come as they are."""
    problems, fields = document("format: 1\ntitle: PUMA\nlinks: [x, {a: 1}]\nparameters: {a2: 1 m}\n", "title")
    assert fields.text("title") == "PUMA"
    assert [node_kind(item) for item in fields.sequence("links")] == ["a text", "a mapping"]
    assert fields.mapping("parameters").text("a2") == "1 m"
    problems.raise_if_any()


def test_a_key_that_is_not_there_gives_an_empty_value() -> None:
    """What must stand there has been named already."""
    problems, fields = document("format: 1\n")
    assert (fields.text("title"), fields.text("title", "no title"), fields.sequence("links")) == ("", "no title", ())
    assert (fields.get("title"), fields.scalar("title"), "title" in fields) == (None, None, False)
    assert fields.mapping("parameters", known=("a",), required=("a",)).entries == {}
    problems.raise_if_any()


def test_free_keys_keep_their_order_and_their_places() -> None:
    """Names of parameters are for the loader to judge."""
    _, fields = document("format: 1\nparameters: {b: 1, a: 2}\n")
    parameters = fields.mapping("parameters")
    assert [(key.text, str(key.place)) for key, _ in parameters.entries.values()] == [
        ("b", "robot.yaml:2:14"),
        ("a", "robot.yaml:2:20"),
    ]


def test_a_scalar_has_its_place() -> None:
    """For what the notation finds wrong inside of it."""
    _, fields = document("format: 1\ntitle: PUMA\n")
    assert fields.scalar("title") == PlacedScalar("PUMA", Place("robot.yaml", 2, 8, "title: PUMA"))


def test_a_key_has_a_place_and_a_missing_one_that_of_its_mapping() -> None:
    """So that every later problem can point somewhere."""
    _, fields = document("# head\nformat: 1\ntitle: PUMA\n")
    assert [str(fields.place_of(key)) for key in ("title", "source")] == ["robot.yaml:3:1", "robot.yaml:2:1"]


def test_all_problems_come_at_once_in_the_order_of_the_file() -> None:
    """Unknown, missing, of the wrong kind, and what the loader adds."""
    problems, fields = document("format: 1\nlinks: {a: 1}\nxyz: PUMA\nsource:\n", "title", "source")
    problems.add(fields.place_of("source"), "source: is not a book", "name one")
    fields.sequence("links")
    fields.text("source")
    problems.take(NotationError(Problem("'1 +' ends too soon", Place("robot.yaml", 2, 12))))
    assert said(problems) == [
        "robot.yaml:1:1: title: is missing",
        "robot.yaml:2:8: links: should be a list, is a mapping (write [a, b] or lines that begin with '- ')",
        "robot.yaml:2:12: '1 +' ends too soon",
        "robot.yaml:3:1: xyz: unknown key (known: format, title, source, links, parameters)",
        "robot.yaml:4:1: source: is not a book (name one)",
        "robot.yaml:4:8: source: is empty",
    ]


@pytest.mark.parametrize(
    ("text", "hint"),
    [
        ("titel: x", "did you mean title?"),
        ("xyz: x", "known: format, title, source, links, parameters"),
        ("{format: 1, title:PUMA}", "a colon needs a space after it"),
        ("\xa0title: x", "it holds the invisible character U+00A0"),
    ],
)
def test_an_unknown_key_names_the_likely_slip(text: str, hint: str) -> None:
    """The nearest key, or what YAML made of a slip."""
    problems = Problems()
    problems.document(read_yaml(text, "f"), known=KNOWN)
    assert [problem.hint for problem in problems.found if "unknown key" in problem.message] == [hint]


@pytest.mark.parametrize(
    ("word", "key"),
    [("titel", "title"), ("Title", "title"), ("reference", "source"), ("parameter", "parameters"), ("dh", "links")],
)
def test_what_stands_under_a_key_that_is_plainly_another_is_read(word: str, key: str) -> None:
    """So that the key is not said to be missing; where it stands there too, that one counts."""
    text = "{format: 1, title: T, source: S, links: L, parameters: P}"
    problems = Problems()
    required = {name: f"{name}: ..." for name in KNOWN}
    fields = problems.document(read_yaml(text.replace(f"{key}:", f"{word}:"), "f"), known=KNOWN, required=required)
    assert [problem.message for problem in problems.found] == [f"{word}: unknown key"]
    assert fields.text(key) == key[0].upper()
    both = problems.document(read_yaml(text.replace("}", f", {word}: other}}"), "f"), known=KNOWN)
    assert both.text(key) == key[0].upper()


def test_a_key_that_is_missing_is_shown() -> None:
    """By an example, or by what it means."""
    problems = Problems()
    problems.document(read_yaml("title: T", "f"), known=KNOWN, required={"title": "", "links": "links: [a]"})
    assert said(problems) == ["f:1:1: format: is missing (format: 1)", "f:1:1: links: is missing (links: [a])"]


@pytest.mark.parametrize(
    ("text", "told", "values"),
    [
        (
            "{a1 = 3 mm, a2= 4}",
            "a1: a colon stands behind a key, and not = (write a1: 3 mm)",
            {"a1": "3 mm", "a2": "4"},
        ),
        (
            "[a1 = 3, a2: 4]",
            "parameters: should be a mapping, is a list (write {a1: 3, a2: 4})",
            {"a1": "3", "a2": "4"},
        ),
        ("[a1, 4]", "parameters: should be a mapping, is a list (write 'key: value' lines)", {}),
        ("a1", "parameters: should be a mapping, is a text (write 'key: value' lines)", {}),
    ],
)
def test_a_mapping_in_another_form_is_shown_and_read(text: str, told: str, values: dict[str, str]) -> None:
    """With `=`, or as a list."""
    problems, fields = document(f"format: 1\nparameters: {text}\n")
    inner = fields.mapping("parameters")
    assert [line.partition(": ")[2] for line in said(problems)] == [told]
    assert {key: inner.text(key) for key in inner.entries} == values


@pytest.mark.parametrize(
    ("text", "shown", "values"),
    [
        ("theta1, theta2", "[theta1, theta2]", ["theta1", "theta2"]),
        ("(0, f(1, 2))", "[0, f(1, 2)]", ["0", "f(1, 2)"]),
        ("first turn, then go", "['first turn, then go']", ["first turn, then go"]),
        ("alone", "[alone]", ["alone"]),
        ("{a: 1}", "[a, b] or lines that begin with '- '", []),
    ],
)
def test_a_list_in_another_form_is_shown_and_read(text: str, shown: str, values: list[str]) -> None:
    """With its commas, in round brackets, or as a sentence."""
    problems, fields = document(f"format: 1\nlinks: {text}\n")
    items = [item.text for item in fields.sequence("links") if isinstance(item, PlacedScalar)]
    assert [problem.hint for problem in problems.found] == [f"write {shown}"]
    assert items == values


def test_a_sentence_that_its_commas_have_cut_is_one_problem() -> None:
    """Between braces each piece is a key; the text is read whole all the same, and a key that is one is left."""
    problems = Problems()
    fields = problems.document(
        read_yaml("{format: 1, title: Where, exactly, is it?, xyz, source: S}", "f"), known=KNOWN
    )
    assert said(problems) == [
        "f:1:20: title: a comma ends a text without quotes here (write title: 'Where, exactly, is it?, xyz')"
    ]
    assert fields.text("title") == "Where, exactly, is it?, xyz"
    assert fields.text("source") == "S"
    free = problems.mapping(read_yaml("{a1: 0.3 m, a2}", "f", is_foreign=True), "parameters")
    assert list(free.entries) == ["a1", "a2"]


@pytest.mark.parametrize(
    ("text", "hint"),
    [
        ("title: [a, [b, c]] # no", "text that begins with a bracket needs quotes: '[a, [b, c]]'"),
        ("title: {a: 1}", "text that begins with a bracket needs quotes: '{a: 1}'"),
        ("title:\n  - a\n  - b", "write one line, or several behind |"),
        ("title: [a,\n  b]", "text that begins with a bracket needs quotes"),
    ],
)
def test_a_list_in_the_place_of_a_text_is_shown_in_the_quotes_that_it_needs(text: str, hint: str) -> None:
    """To be copied, where it stands on one line."""
    problems, fields = document(f"format: 1\n{text}\n")
    fields.text("title")
    assert problems.found[0].hint == hint


@pytest.mark.parametrize(
    ("spelled", "kind"), [("x", "a text"), ("''", "a text"), ("", "empty"), ("{b: 1}", "a mapping"), ("[1]", "a list")]
)
def test_a_value_of_the_wrong_kind_is_told_what_it_is(spelled: str, kind: str) -> None:
    """Each of the three kinds against the others."""
    problems, fields = document(f"format: 1\ntitle: {spelled}\nlinks: {spelled}\nparameters: {spelled}\n")
    fields.text("title")
    fields.sequence("links")
    fields.mapping("parameters")
    expected = {
        "a text": {"title: is empty"} if spelled == "''" else set(),
        "empty": {"title: is empty"},
    }.get(kind, {f"title: should be a text, is {kind}"})
    expected |= {f"links: should be a list, is {kind}"} if kind != "a list" else set()
    expected |= {f"parameters: should be a mapping, is {kind}"} if kind != "a mapping" else set()
    assert {problem.message for problem in problems.found} == expected


def test_a_file_that_is_no_mapping_says_so() -> None:
    """A robot is not a list of rows alone; and of its keys nothing is told."""
    with pytest.raises(FileError) as caught:
        document("- {alpha: 0}\n", "title")
    hint = "write format: 1 and other 'key: value' lines; dhcli new writes a file to start from"
    told = [str(problem) for problem in caught.value.problems]
    assert told == [f"robot.yaml:1:1: the file: should be a mapping, is a list ({hint})"]


def test_a_file_without_a_format_is_told_so() -> None:
    """The line that lets a later dhcli know what it reads."""
    problems, _ = document("title: PUMA\n")
    assert said(problems) == ["robot.yaml:1:1: format: is missing (format: 1)"]


@pytest.mark.parametrize("spelled", ["2", "10", "9" * 5000])
def test_a_later_format_is_refused_without_another_word(spelled: str) -> None:
    """Its unknown keys are no mistakes of the author."""
    with pytest.raises(FileError) as caught:
        document(f"unheard-of: 1\nformat: {spelled}\n", "title")
    assert str(caught.value) == (
        f"robot.yaml:2:9: format {spelled} needs a newer dhcli; this one reads format 1 (pip install --upgrade dhcli)"
    )


@row_by_row("spelled", ["0", "one", "1.0", "01", "-1", "٢", "[1]", ""])
def test_a_format_that_is_no_number_of_a_format_is_refused(spelled: str) -> None:
    """Only 1 is 1."""
    with pytest.raises(FileError, match="format: should be 1, is "):
        document(f"format: {spelled}\n")


def test_the_error_can_be_of_another_class() -> None:
    """A robot made of other parts may be wrong too."""
    problems = Problems()
    problems.add(Place("--set"), "l1: is not a parameter")
    with pytest.raises(RobotError, match="--set: l1: is not a parameter"):
        problems.raise_if_any(RobotError)


SHEET = "format: 1\nexercise: yim/planar-two-links\nanswers: {a1: _}\n"
ANOTHER = {
    "answer sheet": (SHEET, "this is an answer sheet, and {} is wanted (dhcli check yim/planar-two-links f.yaml"),
    "exercise": ("format: 1\ntitle: t\nparts: []\n", "this is an exercise, and {} is wanted (dhcli start f.yaml"),
    "robot": ("format: 1\nvariables: [q1]\n", "this is a robot, and {} is wanted (dhcli show f.yaml"),
    "linkage": ("format: 1\nbars: 4\n", "this is a linkage, and {} is wanted (dhcli dof f.yaml"),
    "list of frames": ("format: 1\nframes: []\n", "this is a list of frames, and {} is wanted (dhcli check ROBOT"),
}
LOADERS: dict[str, Callable[[Path], object]] = {
    "a robot": load_robot,
    "an exercise": load_exercise,
    "a linkage": load_linkage,
    "an answer sheet": read_sheet,
    "a list of frames": lambda path: read_frames(path, load_robot("builtin:planar-2r")),
}


@pytest.mark.parametrize(
    ("wanted", "given"),
    [
        (wanted, given)
        for wanted in LOADERS
        for given in ANOTHER
        if not wanted.endswith(f" {given}") and (wanted, given) != ("a linkage", "robot")
    ],
)
def test_a_file_of_another_kind_is_called_what_it_is(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, wanted: str, given: str
) -> None:
    """In one sentence with what it is good for, and not key by key; a robot is a linkage, too."""
    monkeypatch.chdir(tmp_path)
    text, told = ANOTHER[given]
    Path("f.yaml").write_text(text, encoding="utf-8")
    with pytest.raises(FileError) as caught:
        LOADERS[wanted](Path("f.yaml"))
    assert told.format(wanted) in str(caught.value)
