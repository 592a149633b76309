"""YAML read with its spelling and its places, under both parsers of PyYAML."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator

import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhcli.errors import FileError, Place, Problem
from dhcli.files.yaml import placed
from dhcli.files.yaml.placed import (
    DEEPEST,
    MOST_NODES,
    PlacedMapping,
    PlacedNode,
    PlacedScalar,
    PlacedSequence,
    read_yaml,
)
from dhcli.files.yaml.syntax import explain_syntax
from tests.nightly import NIGHT
from tests.row_by_row import row_by_row

# Pieces that mean something to YAML, so that random texts get past its first checks.
PIECES = (
    *(
        "a",
        "b: ",
        ": ",
        ": 1\n",
        "- ",
        "? ",
        "[",
        "]",
        "{",
        "}",
        ", ",
        "&x ",
        "*x",
        "!t ",
        "|",
        "> ",
        "'",
        '"',
        "%",
        "@",
    ),
    *(
        " ",
        "\n",
        "\n  ",
        "\r\n",
        "\r",
        "\n\t",
        "\x85",
        "\u2028",
        "\ufeff",
        "\0",
        "\\",
        "\\n",
        "<<",
        "---\n",
        "...",
        "#",
    ),
    *("~", "`", "-", "θ", "𝛼", "30°", "\xa0"),
)


@pytest.fixture(scope="module", params=["libyaml", "python"], autouse=True)
def parser(request: pytest.FixtureRequest) -> Iterator[None]:
    """Run every test with the fast parser and with the one that is always there."""
    import yaml

    has_libyaml = yaml.__with_libyaml__  # asked before the patch: PyYAML decides it once, when it is first asked
    if request.param == "libyaml" and not has_libyaml:
        pytest.skip("this PyYAML was built without libyaml")
    with pytest.MonkeyPatch.context() as patch:
        if request.param == "python":
            patch.setitem(sys.modules, "yaml._yaml", None)  # as where it was built without
        yield


def value_of(text: str) -> PlacedScalar:
    """The only value of a mapping with one entry."""
    root = read_yaml(text, "robot.yaml")
    assert isinstance(root, PlacedMapping)
    ((_, value),) = root.entries
    assert isinstance(value, PlacedScalar)
    return value


def problems_of(text: str) -> list[str]:
    """What is wrong with a text, one line each."""
    with pytest.raises(FileError) as caught:
        read_yaml(text, "robot.yaml")
    return [str(problem) for problem in caught.value.problems]


def scalars(node: PlacedNode) -> Iterator[PlacedScalar]:
    """Every text of a tree."""
    if isinstance(node, PlacedScalar):
        yield node
    for child in node.items if isinstance(node, PlacedSequence) else ():
        yield from scalars(child)
    for key, value in node.entries if isinstance(node, PlacedMapping) else ():
        yield key
        yield from scalars(value)


@row_by_row(
    "spelled",
    [
        "1e-3",
        "on",
        "no",
        "010",
        "0x10",
        "12:30",
        "1_000",
        "null",
        "~",
        "2024-01-01",
        ".inf",
        "θ1",
        "30°",
        "-90°",
        "√3/2",
    ],
)
def test_a_plain_text_keeps_its_spelling(spelled: str) -> None:
    """YAML 1.1 would make a bool, an octal, a base-60 number or a date of some of these."""
    assert value_of(f"theta: {spelled}\n").text == spelled


def test_formulas_with_operators_are_plain_texts() -> None:
    """Products of moves and offsets need no quotes in a block list."""
    root = read_yaml("- Trans(0, 0, l1) * Rot(z, theta1)\n- theta3 - 180°\n- -d3\n", "f")
    assert [scalar.text for scalar in scalars(root)] == ["Trans(0, 0, l1) * Rot(z, theta1)", "theta3 - 180°", "-d3"]


@row_by_row(("spelled", "quoted"), [("1", False), ("'1'", True), ('"1"', True), ("|-\n  1", True)])
def test_a_quoted_text_is_told_from_a_plain_one(spelled: str, quoted: bool) -> None:
    """A title `'1'` is a text even where a number could stand."""
    assert (value_of(f"a: {spelled}").text, value_of(f"a: {spelled}").quoted) == ("1", quoted)


def test_places_are_counted_in_characters() -> None:
    """Greek letters, degree signs and letters beyond the basic plane are one column each."""
    root = read_yaml("links:\n  - {α𝛼: 30°, θ: 'x', a: y}\n", "robot.yaml")
    places = {scalar.text: str(scalar.place) for scalar in scalars(root)}
    assert places["30°"] == "robot.yaml:2:10"
    assert places["y"] == "robot.yaml:2:26"


def test_a_place_holds_its_whole_line() -> None:
    """A marker can be shown without opening the file again."""
    assert value_of("# head\na: 30° # note\n").place.text == "a: 30° # note"


def test_a_list_and_a_mapping_know_where_they_begin() -> None:
    """Their first entry or their bracket."""
    root = read_yaml("\nlinks:\n  - {a: 1}\n", "f")
    assert isinstance(root, PlacedMapping)
    links = root.entries[0][1]
    assert isinstance(links, PlacedSequence)
    assert [str(node.place) for node in (root, links, links.items[0])] == ["f:2:1", "f:3:3", "f:3:5"]


@row_by_row(
    ("text", "column"),
    [("a: x + y1", 8), ("a: 'x + y1'", 9), ('a: "x + y1"', 9), ("a: 'x+''y1'", 4), ("a: x +\n y1", 4)],
)
def test_a_character_inside_a_text_has_a_place(text: str, column: int) -> None:
    """It is exact where the text stands in the file as it reads, else that of the whole text."""
    assert value_of(text).place_of(4).column == column


def test_a_text_that_stands_in_no_file_has_no_exact_place() -> None:
    """An option of the command line is read by the same loaders."""
    assert PlacedScalar("x + y", Place("--set")).place_of(4) == Place("--set")


def test_a_missing_value_is_an_empty_text() -> None:
    """`title:` alone is not an error of YAML; the loader says what is missing."""
    assert value_of("title:\n") == PlacedScalar("", value_of("title:\n").place)


@row_by_row("line_end", ["\n", "\r\n", "\r"])
@row_by_row("mark", ["", "\ufeff"])
def test_line_ends_and_a_byte_order_mark_change_nothing(line_end: str, mark: str) -> None:
    """Files from Windows read the same."""
    root = read_yaml(mark + "a: 1\nb: 'x\n  y'\n".replace("\n", line_end), "f")
    assert [(scalar.text, str(scalar.place)) for scalar in scalars(root)] == [
        *[("a", "f:1:1"), ("1", "f:1:4"), ("b", "f:2:1"), ("x y", "f:2:4")]
    ]


@row_by_row("text", ["", "\n\n", "# only a comment\n", "---\n", "\ufeff", " \n"])
def test_an_empty_file_is_called_empty(text: str) -> None:
    """Also one with nothing but comments."""
    assert problems_of(text) == ["robot.yaml: is empty"]


def test_every_duplicate_key_is_reported_with_the_line_of_the_first() -> None:
    """PyYAML would silently take the last."""
    assert problems_of("a: 1\nb: {c: 1, c: 2}\na: 3\n'a': 4\n") == [
        "robot.yaml:2:11: c: stands twice, first on line 2 (keep one)",
        "robot.yaml:3:1: a: stands twice, first on line 1 (keep one)",
        "robot.yaml:4:1: a: stands twice, first on line 1 (keep one)",
    ]


@row_by_row(
    ("text", "problem"),
    [
        ("a: &x 1", "robot.yaml:1:4: '&x' is a YAML anchor"),
        ("a: &x [1]", "robot.yaml:1:4: '&x' is a YAML anchor"),
        ("a: *x", "robot.yaml:1:4: '*x' is a YAML alias"),
        ("a: * x", "robot.yaml:1:4: '*' begins a YAML alias"),
        ("a: & x", "robot.yaml:1:4: '&' begins a YAML anchor"),
        ("a: !!python/object:os.system x", "robot.yaml:1:4: '!' begins a YAML tag"),
        ("a: !x {b: 1}", "robot.yaml:1:4: '!' begins a YAML tag"),
        ("a: !e!x y", "robot.yaml:1:4: '!' begins a YAML tag"),
        ("<<: {a: 1}", "robot.yaml:1:1: '<<' is a YAML merge key"),
        ("a: 1\n---\nb: 2", "robot.yaml:2:1: a second document begins here"),
        ("[a]: 1", "robot.yaml:1:1: a key cannot be a list or mapping"),
        ("{{a}: 1}", "robot.yaml:1:2: a key cannot be a list or mapping"),
        ("'': 1", "robot.yaml:1:1: a key is missing before ':'"),
        ("{: 1}", "robot.yaml:1:2: a key is missing before ':'"),
        ("a: 1\nb: x\0y", "robot.yaml:2:5: the character U+0000 cannot stand in a YAML file"),
        ("a: \x1b[31m", "robot.yaml:1:4: the character U+001B cannot stand in a YAML file"),
        ("ab: \ud800", "robot.yaml:1:5: the character U+D800 cannot stand in a YAML file"),
        (r'a: "$\theta$"', "robot.yaml:1:4: this text in double quotes holds the control character U+0009"),
    ],
)
def test_what_could_hide_a_mistake_is_refused(text: str, problem: str) -> None:
    """Each with its place and what it is."""
    (only,) = problems_of(text)
    assert only.startswith(problem)


def test_quotes_make_a_text_of_what_yaml_would_take_for_a_sign() -> None:
    """The way out that the hints name works."""
    root = read_yaml("['*x', '&x', '!x', '<<', '$\\theta$', 'a: b', '{x}', 'it''s']", "f")
    assert [scalar.text for scalar in scalars(root)] == ["*x", "&x", "!x", "<<", "$\\theta$", "a: b", "{x}", "it's"]


def test_all_that_is_refused_is_reported_before_a_syntax_error() -> None:
    """One error with three problems, in reading order."""
    assert [problem.split(" ")[0] for problem in problems_of("a: &x 1\na: *x\nb: [1\n")] == [
        *["robot.yaml:1:4:", "robot.yaml:2:1:", "robot.yaml:2:4:", "robot.yaml:3:4:"]
    ]


@row_by_row(
    ("text", "place", "message", "hint"),
    [
        ("a:\n\tb: 1\n", "2:1", "a tab indents this line; YAML wants spaces", "two spaces"),
        ("a: x\n  \tb: 1\n", "2:3", "a tab indents this line; YAML wants spaces", "two spaces"),
        ("-\ta: 1\n", "1:2", "a tab stands here; YAML wants a space", ""),
        ("title: Foo: bar\n", "1:11", "a second ': ' stands in one value", "needs quotes"),
        ("a: 1\n  b: 2\n", "2:3", "this key cannot stand here", "start in one column"),
        ("title:foo\nb: 1\n", "2:1", "this key cannot stand here", "colon needs a space after it"),
        ("title\nb: 1\n", "2:1", "this key cannot stand here", "no ': ' after its key"),
        ("a: 1\nb\nc: 2\n", "2:1", "this line is neither 'key: value' nor '- entry'", "a space after it"),
        ("a: 'x\nb: 2\n", "1:4", "this quote is never closed", "close it"),
        ("a: [1, 2", "1:4", "this '[' is never closed", "']' is missing"),
        ("a: {b: 1\nc: 2\n", "1:4", "this '{' is still open on line 2", "'}' is missing"),
        ("- {a: 0 d: 0}\n", "1:10", "',' or '}' should stand here", "separated by ', '"),
        ("- {alpha_{i-1}: 0}\n", "1:10", "',' or '}' should stand here", "a name with braces or brackets needs quotes"),
        ("- [T^{0}_{6}]\n", "1:6", "',' or ']' should stand here", "a name with braces or brackets needs quotes"),
        ("a: 1\nb: {c: 2}}\n", "2:10", "this '}' closes nothing", "delete it"),
        ("a:\n  b: 1\n c: 2\n", "3:2", "this line does not line up with the lines above it", "start in column 1"),
        ("- a: 1\n b: 2\n", "2:2", "this line does not", ""),
        ("a:\n  b: |\n    1 0 0\n   0 1 0\n", "4:4", "this line stands further left than the text", "in column 5"),
        ("a:\n  b: |\n    1 0 0\n   -1 1 0\n", "4:4", "this line stands further left than the text", "in column 5"),
        ("a: 1\n- b\n", "2:1", "a list entry stands among the keys", "under their key"),
        ("a: - theta1\n", "1:4", "a list cannot begin on the line of its key", "a minus sign has no space after it"),
        ("a: 'it's'\n", "1:8", "text follows the closing quote", 'write a: "it\'s"'),
        ("- 'so it's'  # yes\n", "1:10", "text follows the closing quote", 'write "so it\'s"'),
        ("{a: b, c: 'it's', d: e}\n", "1:15", "text follows the closing quote", 'write c: "it\'s"'),
        ("['it's', 'x']\n", "1:6", "text follows the closing quote", 'write "it\'s"'),
        ('["say "a" first", \'x\']\n', "1:8", "text follows the closing quote", "write 'say \"a\" first'"),
        ('a: "the "end" frame"\n', "1:10", "text follows the closing quote", "write a: 'the \"end\" frame'"),
        ("a: 'on\n  two lines it's'\n", "2:16", "text follows the closing quote", "written twice"),
        ("{a: 'x' b: c}\n", "1:9", "',' or '}' should stand here", "separated by ', '"),
        ("a: @x\n", "1:4", "a value cannot begin with '@'", "quotes"),
        ("a: |x|\n", "1:4", "'|' and '>' begin a block of text", "quotes"),
        ("a: [1,,2]\n", "1:7", "a value is missing here", "needs quotes"),
        ("a: 1\n% note\n", "2:1", "a line cannot begin with '%'", "use # for a comment"),
        (": 1\n", "1:1", "a key is missing before ':'", ""),
        ("a: {b: 1} c\n", "1:11", "this does not belong to the value before it", "the whole value may need quotes"),
    ],
)
def test_a_syntax_error_says_in_plain_words_where_and_what(text: str, place: str, message: str, hint: str) -> None:
    """No word of PyYAML's own reaches the reader."""
    with pytest.raises(FileError) as caught:
        read_yaml(text, "f")
    (problem,) = caught.value.problems
    assert str(problem.place) == f"f:{place}"
    assert problem.message.startswith(message)
    assert hint in problem.hint


def test_an_unknown_escape_points_to_single_quotes() -> None:
    """A LaTeX command in double quotes is the usual cause."""
    (problem,) = problems_of(r'a: "\sin x"')
    assert "use single quotes" in problem


def test_a_message_not_known_yet_is_handed_on() -> None:
    """A later PyYAML may have new ones, and may not say where."""
    import yaml

    error = yaml.MarkedYAMLError("while scanning a dream", None, "found a new word", None)
    problem = explain_syntax(error, [], lambda mark: Place("f" if mark is None else "g"))
    assert str(problem) == "f: not valid YAML: while scanning a dream found a new word"


def test_a_tab_inside_quotes_or_a_comment_is_no_problem() -> None:
    """Only where YAML counts spaces a tab is none."""
    assert value_of("a: 'x\ty' # note\tmore\n").text == "x\ty"


@pytest.mark.parametrize("opening", ["[", "{a: ", "- ", "? "])
def test_deep_nesting_is_refused_at_the_limit(opening: str) -> None:
    """A file of a hundred thousand brackets costs forty steps, not a recursion error."""
    (problem,) = problems_of(opening * 100_000)
    assert f"nested more than {DEEPEST} deep" in problem


def test_nesting_up_to_the_limit_is_read() -> None:
    """The limit itself is allowed."""
    text = "[" * (DEEPEST - 1) + "x" + "]" * (DEEPEST - 1)
    assert [scalar.text for scalar in scalars(read_yaml(text, "f"))] == ["x"]


def test_a_large_tree_is_refused_at_the_limit(monkeypatch: pytest.MonkeyPatch) -> None:
    """The list is one node, its items are the others; at night at the limit itself, by day at a lower one."""
    assert MOST_NODES == 20_000
    most = MOST_NODES if NIGHT else 2_000
    monkeypatch.setattr(placed, "MOST_NODES", most)
    assert len(list(scalars(read_yaml("- x\n" * (most - 1), "f")))) == most - 1
    (problem,) = problems_of("- x\n" * most)
    assert problem.startswith(f"robot.yaml:{most}:3: the file holds more than {most:,} keys and values")


@given(st.text() | st.lists(st.sampled_from(PIECES), max_size=30).map("".join))
def test_any_text_gives_a_tree_or_a_file_error(text: str) -> None:
    """Nothing else is ever raised; a word is found where its place says; every problem is in plain words."""
    try:
        root = read_yaml(text, "f")
    except FileError as error:
        assert error.problems
        assert "not valid YAML" not in str(error)
        return
    for scalar in scalars(root):
        assert scalar.place.column is not None
        if not scalar.quoted and scalar.text.split() == [scalar.text]:
            assert scalar.place.text.startswith(scalar.text, scalar.place.column - 1)


def test_importing_the_room_does_not_import_yaml() -> None:
    """Commands that read no file do not pay for PyYAML."""
    modules = "dhcli.files.yaml.fields, dhcli.files.reading, dhcli.files.library.lookup, dhcli.storage.atomic"
    code = f"import sys, {modules}; sys.exit(bool({{'yaml', 'importlib.resources', 'tempfile'}} & set(sys.modules)))"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


def test_a_decimal_comma_between_braces_is_told_as_what_it_is() -> None:
    """YAML makes a key without a value of what stands behind it; keys that are numbers stay keys."""
    with pytest.raises(FileError) as error:
        read_yaml("a: {b: 0,3 m, c: 0,3 m , d: -1,5}\n", "robot.yaml")
    assert [str(problem) for problem in error.value.problems] == [
        "robot.yaml:1:10: 0,3 m has a decimal comma, which ends a value here (write 0.3 m)",
        "robot.yaml:1:20: 0,3 m has a decimal comma, which ends a value here (write 0.3 m)",
        "robot.yaml:1:32: 1,5 has a decimal comma, which ends a value here (write 1.5)",
    ]
    root = read_yaml("a: {1: 5,2: 6, x: 7, 3: 1}\nb: [0,5, 1]\n", "robot.yaml")
    assert isinstance(root, PlacedMapping)
    inner = root.entries[0][1]
    assert isinstance(inner, PlacedMapping)
    assert [key.text for key, _ in inner.entries][-2:] == ["x", "3"]


@row_by_row(
    ("text", "told", "value"),
    [
        ("{b: point (1, 2,3) of pose 0..2, c: 1}", "1:8: b: | write b: ", "point (1, 2,3) of pose 0..2"),
        ("{c: 1, b: atan2(f(1, 2), 3)}", "1:14: b: | write b: ", "atan2(f(1, 2), 3)"),
        ('{b: product "a, b", c: 1}', "1:8: b: | write b: ", 'product "a, b"'),
        ("[it's Rot(z, 90°), then more]", "1:5: | write ", "it's Rot(z, 90°)"),
        ("{b: [1, 2] of x, c: 1}", "1:15: | write b: ", "[1, 2] of x"),
        ("{b: f([1, 2], 3), c: 1}", "1:10: | write b: ", "f([1, 2], 3)"),
        ('{c: 1, b: "product "Rot(z, 90°)""}', "1:24: | write b: ", 'product "Rot(z, 90°)"'),
    ],
)
def test_a_text_that_a_comma_or_a_bracket_cuts_is_shown_whole_in_quotes(text: str, told: str, value: str) -> None:
    """Once, at its beginning, or where the reading ends; and put into the quotes shown it is read."""
    with pytest.raises(FileError) as error:
        read_yaml(f"a: {text}\n", "f", is_foreign=True)
    (problem,) = error.value.problems
    place, hint = told.split("| ")
    assert f"{problem.place}: {problem.message}".startswith(f"f:{place}".rstrip())
    assert problem.hint.startswith(hint)
    shown = problem.hint.removeprefix("write ")
    root = read_yaml(f"{{{shown}, c: 1}}" if shown.startswith("b: ") else f"{{b: {shown}}}", "f", is_foreign=True)
    assert [scalar.text for scalar in scalars(root)][:2] == ["b", value]


def test_what_a_comma_has_cut_is_read_as_it_was_meant() -> None:
    """So that nothing follows from it; lists in lines and texts in quotes have no such commas."""
    problems: list[Problem] = []
    root = read_yaml("a: {b: f(1, 2), c: 3, d: [g(4, 5), 6]}\n", "f", problems, is_foreign=True)
    assert [scalar.text for scalar in scalars(root)] == [*"ab", "f(1, 2)", "c", "3", "d", "g(4, 5)", "6"]
    assert len(problems) == 2
    assert read_yaml("- f(1\n- 2)\n- 'g(3, 4)'\n- [':(', ':)']\n", "f", is_foreign=True)


@row_by_row(
    ("text", "at", "hint"),
    [
        ("a: 1\nb:2\nc: 3\n", "2:1", "a colon and a space stand behind a key: b: 2"),
        ("a: 1\nb = 2\nc: 3\n", "2:1", "a colon and a space stand behind a key: b: 2"),
        ("a: 1\n// no\nc: 3\n", "2:1", "use # for a comment"),
        ("a: |\nno\nc: 3\n", "2:1", "text below 'a: |' is indented more than its key"),
        ("a:\n   - 1\n  - 2\n", "3:3", "the '- ' of one list stand in one column, here in column 4"),
        ("- a: 1, b: 2\n", "1:10", "several keys on one line stand in braces: {a: 1, b: 2}"),
        ("- {a: [1, 2]°, b: 2}\n", "1:13", "the unit stands behind each number: [1°, 2°]"),
        ("- {a: [1, 2] mm, b: 2}\n", "1:14", "the unit stands behind each number: [1 mm, 2 mm]"),
    ],
)
def test_a_slip_of_form_is_told_with_what_would_be_right(text: str, at: str, hint: str) -> None:
    """In the author's own words where they can be mended."""
    with pytest.raises(FileError) as error:
        read_yaml(text, "f", is_foreign=True)
    assert [(str(problem.place), problem.hint) for problem in error.value.problems] == [(f"f:{at}", hint)]
