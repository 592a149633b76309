"""Text that somebody else wrote steers no terminal, leaves no comment and becomes no formula, whatever is shown.

Two contracts: hostile files are shown by every command in every format there is, and the code that shows them writes
nothing but what went through `dhcli.safe`.
"""

from __future__ import annotations

import ast
import csv
import io
from collections.abc import Iterator
from html import escape as html_text
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest
from hypothesis import given
from hypothesis import strategies as st
from markdown_it import MarkdownIt

import dhcli
from dhcli.render import kinds
from dhcli.safe import (
    comment,
    csv_cell,
    docstring,
    html,
    latex,
    markdown,
    markdown_code,
    markdown_heading,
    one_line,
    xml_attribute,
    xml_comment,
)
from tests.cli.running import Run

EVIL = "e\x1b[31m\x9b2J\u202e\u200b\u2028\x85\r\nimport os"
"""What is typed may hold colours, the clearing of the screen, letters from right to left, ends of lines."""
TITLE = "e\u202e\u200b\u2066\u2028import os"
"""What the reader of YAML lets through; it refuses controls."""
NAME = "e\u202e\x1b]0;x\x07\x9b\nimport os"
"""What the name of a file may hold."""
STEERING = set("\x1b\x07\x9b\x85\r\u202e\u200b\u2028\ufeff")
PACKAGE = Path(dhcli.__file__).parent

ROBOT = """\
format: 1
title: {evil}
source: {evil}
notes: {evil}
convention: standard
variables: [theta1, d2]
parameters: {{a1: 0.4 m}}
links:
  - {{a: a1, alpha: 90°, d: 0, theta: theta1}}
  - {{a: 0, alpha: 0, d: d2, theta: 0}}
limits: {{theta1: [-170°, 170°]}}
poses: {{home: [0, 0.1 m]}}
"""
MOTORS = "actuators:\n  motors: [m1, m2]\n  theta1: m1 - m2\n  d2: m2 * 20 mm / 360°\n"
PRODUCTS = """\
format: 1
title: {evil}
source: {evil}
convention: product
variables: [theta1]
links:
  - |
    Rot(z, theta1)
    Trans(1, 0, 0)
"""
LINKAGE = """\
format: 1
title: {evil}
source: {evil}
notes: {evil}
space: planar
ground: a
joints:
  - {{name: p, type: R, links: [a, b], point: [0, 0]}}
  - {{name: q, type: R, links: [b, c], point: [1 m, 1 m]}}
  - {{name: r, type: R, links: [c, d], point: [2 m, 1 m]}}
  - {{name: s, type: R, links: [d, a], point: [3 m, 0]}}
"""
EXERCISE = """\
format: 1
title: {evil}
source: {evil}
robot: planar-2r
task: {evil}
parts:
  - {{id: a, ask: pose 0..2, prompt: {evil}, hints: [{evil}]}}
  - {{id: b, ask: link 1}}
"""
SHEET = "format: 1\nexercise: '{id}'\nname: {evil}\nvariant: {evil}\nanswers:\n  a: {evil}\n"


@pytest.fixture
def files(tmp_path: Path) -> Path:
    """A folder with hostile files of every kind."""
    evil = f"'{TITLE}'"
    texts = {
        "robots": {NAME: ROBOT, f"p{NAME}": PRODUCTS, "r": ROBOT, f"m{NAME}": ROBOT + MOTORS},
        "robots/linkages": {f"l{NAME}": LINKAGE},
        "exercises/c": {f"x{NAME}": EXERCISE},
        "class/one": {f"s{NAME}": SHEET},
    }
    for folder, named in texts.items():
        (tmp_path / folder).mkdir(parents=True, exist_ok=True)
        for name, text in named.items():
            filled = text.format(evil=evil, id=f"c/x{NAME}".replace("'", "''"))
            (tmp_path / folder / f"{name}.yaml").write_text(filled, "utf-8")
    (tmp_path / f"{NAME}.csv").write_text(f"theta1,d2,{EVIL!r}\n0,0,0\n", "utf-8")
    return tmp_path


def command_lines() -> Iterator[tuple[str, ...]]:
    """Commands that show what stands in the hostile files, in every format that each has."""
    robot, products, linkage = (f"./robots/{NAME}.yaml", f"./robots/p{NAME}.yaml", f"./robots/linkages/l{NAME}.yaml")
    exercise = f"./exercises/c/x{NAME}.yaml"
    for kind, words in {
        "pose": ("fk", robot, "-s"),
        "let": ("fk", robot, "-s", "--let"),
        "poses": ("fk", robot, "-s", "--links"),
        "point": ("fk", robot, "-s", "--point", "1,2,3"),
        "placement": ("fk", robot, "--pose", "home", "--as", "rpy"),
        "robot": ("show", robot),
        "description": ("describe", robot),
        "motors": ("describe", f"./robots/m{NAME}.yaml", "--as", "motors"),
        "linkage": ("show", linkage),
        "mobility": ("dof", linkage),
        "mobility at joint values": ("dof", robot, "--pose", "home"),
        "exercise": ("show", exercise),
        "marks": ("check", exercise, "--part", "a", "--answer", EVIL, "--why"),
        "class": ("grade", "class"),
        "library": ("list",),
        "lint": ("lint", "robots", "exercises"),
        "sweep": ("sweep", robot, "--over", "theta1=-90°..90° step 90°", "--q", "d2=0.1"),
        "jacobian": ("jacobian", robot, "-s"),
        "singularities": ("singularities", robot),
        "velocity": ("rates", robot, "--pose", "home", "--rates", "1,1"),
        "torques": ("torques", robot, "--pose", "home", "--force", "1,0,0"),
        "inverse": ("ik", robot, "--pose", "home", "--task", "position"),
        "derivation": ("ik", robot, "--derive", "--task", "position"),
        "transform": ("transform", "Rot(z, theta1) Trans(1, 0, 0)"),
        "steps": ("transform", "Rot(z, theta1) Trans(1, 0, 0)", "--steps"),
    }.items():
        yield from ((*words, "--format", name) for name in kinds.formats(kind) if name != "gradescope")
    yield from (("show", products, "--format", name) for name in kinds.formats("robot"))
    yield "describe", robot, "--format", "urdf"  # a URDF has no steps
    yield "grade", "class/one", "--format", "gradescope"
    for words in (("fk", robot), ("jacobian", robot)):
        yield from ((*words, "--code", name) for name in kinds.formats("function") if name != "json")
        yield (*words, "--code", "c", "--format", "json")
    solver = ("ik", robot, "--task", "position", "--code")
    yield from ((*solver, name) for name in kinds.formats("inverse function") if name != "json")
    yield "draw", robot, "--pose", "home"
    yield "draw", robot, "--pose", "home", "-o", f"{NAME}.svg"
    yield "describe", robot, "--steps"
    yield "start", exercise, "-o", "-"
    yield "start", exercise, "-o", NAME
    yield "hint", exercise
    yield "solution", exercise, "--yes"
    yield "new", "exercise", "c/y", "--robot", "./robots/r.yaml", "-o", "-"
    yield "fk", robot, "--pose", "home", "-o", f"{NAME}.m"
    yield "fk", robot, "--rows", f"{NAME}.csv"
    yield "fk", robot, "--rows", f"{NAME}.csv", "--ignore-columns", "-o", f"{NAME}.jsonl"
    for command in ("fk", "show", "check", "dof", "start", "grade", "lint", "transform", "sweep", "help", "new"):
        yield command, EVIL
        yield command, f"./{EVIL}.yaml", f"--{EVIL}", EVIL


def test_no_file_and_no_word_steers_the_terminal(
    dhcli: Run, files: Path, monkeypatch: pytest.MonkeyPatch, subtests: pytest.Subtests
) -> None:
    """Every kind of result in every format, and what is said beside it; none of them is left out."""
    shown = set()

    def noted(kind: str, name: str) -> None:
        shown.add((kind, name))
        check(kind, name)

    check = kinds.check_format
    monkeypatch.setattr(kinds, "check_format", noted)
    for words in command_lines():
        with subtests.test(words=words):
            done = dhcli(*words)
            assert not STEERING & set(done.out + done.err), done
            assert done.code != 3, done.err
            is_code = words[0] in ("fk", "transform", "jacobian", "ik") and words[-1] != "table"  # that folds headings
            assert not is_code or not any(line.startswith("import os") for line in done.out.split("\n"))
    assert shown >= set(kinds._RENDERERS)


@pytest.mark.parametrize("suffix", ["py", "m"])
def test_the_name_of_a_file_does_not_leave_the_comment(dhcli: Run, files: Path, suffix: str) -> None:
    """What stands below it would be run."""
    name = f"out.{suffix}"
    assert dhcli("fk", f"./robots/{NAME}.yaml", "--pose", "home", "-o", name).code == 0
    written = (files / name).read_text("utf-8")
    assert not STEERING & set(written)
    assert [line for line in written.splitlines() if "import os" in line] == [
        f"{'#' if suffix == 'py' else '%'} T_02 of {one_line(NAME)}: frame 2 seen from frame 0"
    ]


def test_a_sheet_of_a_hostile_exercise_is_read_back(dhcli: Run, files: Path) -> None:
    """Its comments stay comments, and its id is the one it was written for; controls YAML takes from nobody."""
    exercise = "./exercises/c/'x\u202e\u200b.yaml"
    (files / exercise).write_text((files / "exercises" / "c" / f"x{NAME}.yaml").read_text("utf-8"), "utf-8")
    assert dhcli("start", exercise, "-o", "sheet.yaml").code == 0
    assert not STEERING & set((files / "sheet.yaml").read_text("utf-8"))
    done = dhcli("check", exercise, "sheet.yaml", "--format", "json")
    assert done.code == 1, done
    assert [part["verdict"] for part in done.envelope["data"]["parts"]] == ["SKIPPED", "SKIPPED"]


def test_help_has_no_bold_where_colours_are_unwanted(dhcli: Run) -> None:
    """Nor on a terminal that knows none."""
    for variables in ({"NO_COLOR": "1"}, {"NO_COLOR": "", "TERM": "dumb"}):
        for words in (("--help",), ("fk", "--help"), ("new", "robot", "--help")):
            done = dhcli(*words, FORCE_COLOR="1", **variables)
            assert done.code == 0
            assert "\x1b" not in done.out


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("a_1 50% {x} \\input{y} #&$ ^~", None),
        ("\\", r"\textbackslash{}"),
    ],
)
def test_latex_gets_no_command(text: str, shown: str | None) -> None:
    """Every sign that steers it has another behind or before it."""
    said = latex(text)
    assert shown is None or said == shown
    bare = said.replace("\\textbackslash{}", "").replace("\\textasciicircum{}", "").replace("\\textasciitilde{}", "")
    assert "\\input" not in bare
    assert all(bare[i - 1] == "\\" for i, sign in enumerate(bare) if sign in "$&#%_{}")


def test_html_gets_no_tag_and_no_end_of_an_attribute() -> None:
    """Neither do its quotes end one."""
    assert html("<b a='x' b=\"y\">&\x1b\n") == "&lt;b a=&#x27;x&#x27; b=&quot;y&quot;&gt;&amp;  "


def test_xml_is_read_with_what_was_put_in() -> None:
    """Whatever stands in an attribute, and whatever would end a comment."""
    for text in ("--><evil/>", "a---", "<b a='x' b=\"y\">&", EVIL):
        root = ET.fromstring(f"<r a={xml_attribute(text)}>{xml_comment(text)}</r>")  # noqa: S314  our own
        assert root.get("a") == one_line(text)
        assert list(root) == []


def test_a_comment_is_one_line() -> None:
    """In the eyes of every language."""
    said = comment(EVIL, "#")
    assert len(said.splitlines()) == 1
    assert said.startswith("# e")


def test_a_docstring_is_one_string() -> None:
    """Neither quotes nor a backslash end it."""
    for text in ('x""" + import_os() + """', "x\\", 'x"', EVIL):
        (statement,) = ast.parse(docstring(text)).body
        assert isinstance(statement, ast.Expr)
        assert isinstance(statement.value, ast.Constant)


def test_a_cell_with_letters_of_no_width_is_no_formula() -> None:
    """A spreadsheet may drop them."""
    line = next(csv.reader(io.StringIO(csv_cell("\u200b\u2060=1+1"))))
    assert line[0].startswith("'")


# --- What the code may do ---------------------------------------------------------------------------------------------


def nodes(room: str, *words: str) -> Iterator[tuple[str, ast.AST]]:
    """What the files of a room are made of that hold one of some words, each with the file it stands in."""
    for path in sorted((PACKAGE / room).rglob("*.py")):
        text = path.read_text("utf-8")
        if any(word in text for word in words):  # to parse all of them takes a second
            yield from ((path.relative_to(PACKAGE).as_posix(), node) for node in ast.walk(ast.parse(text)))


def values_in(text: ast.expr) -> Iterator[ast.expr]:
    """What is put into a text that is about to be written, but not what is handed to a function on the way."""
    if isinstance(text, ast.FormattedValue):
        yield text.value
    elif isinstance(text, ast.Call) and isinstance(text.func, ast.Attribute) and text.func.attr == "join":
        yield from (value for argument in text.args for value in values_in(argument))
    elif not isinstance(text, ast.Call):
        yield from (value for part in ast.iter_child_nodes(text) for value in values_in(part))  # type: ignore[arg-type]


def is_ours(value: ast.expr) -> bool:
    """Whether a value was made by a function, is a constant, or a text that a renderer has made line by line."""
    if isinstance(value, ast.Name):
        return value.id.isupper() or value.id in ("__version__", "line", "text")
    return isinstance(value, ast.Call)


ESCAPING = ("html", "xml.sax.saxutils")
SHOWING = ("cli", "render", "files", "classroom", "lint")
"""The rooms that write for people and programs."""


def test_only_one_module_says_what_is_safe() -> None:
    """Nothing else escapes what it shows by itself."""
    found = {
        name
        for room in SHOWING
        for name, node in nodes(room, *ESCAPING)
        if (isinstance(node, ast.Import) and any(alias.name in ESCAPING for alias in node.names))
        or (isinstance(node, ast.ImportFrom) and node.module in ESCAPING)
    }
    assert found == set()


def test_commands_write_no_name_as_it_is() -> None:
    """A value in what is said or written has gone through a function: `spell`, `ink`, a renderer; `tell` spells all."""
    bare = [
        f"{name}:{call.lineno}: {ast.unparse(value)}"
        for name, call in nodes("cli", "say(", "write_out(")
        if isinstance(call, ast.Call) and isinstance(call.func, ast.Name) and call.func.id in ("say", "write_out")
        for argument in call.args
        for value in values_in(argument)
        if not is_ours(value)
    ]
    assert bare == []


def test_streams_are_written_in_one_file() -> None:
    """The console holds the streams; what it writes was made safe by others."""
    writers = {
        name
        for room in SHOWING
        for name, node in nodes(room, "stdout", "stderr", "print(")
        if (isinstance(node, ast.Attribute) and ast.unparse(node) in ("sys.stdout.write", "sys.stderr.write"))
        or (isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "print")
    }
    assert writers == {"cli/shell/console.py", "cli/main.py"}


def test_comments_of_code_are_made_in_one_place() -> None:
    """A text that begins a comment and goes on with a value may hold the end of a line."""
    found = [
        f"{name}:{node.lineno}: {ast.unparse(node)}"
        for name, node in nodes("render", "{")
        if isinstance(node, ast.JoinedStr)
        and isinstance(first := node.values[0] if node.values else None, ast.Constant)
        and str(first.value).lstrip().startswith(("# ", "% ", "// ", "/*", "<!--", '"""'))
    ]
    assert found == []


@given(st.text(st.characters(min_codepoint=32, max_codepoint=126), min_size=1))
def test_markdown_shows_a_text_as_it_is(text: str) -> None:
    """As one paragraph, by a reader of Markdown that is not ours."""
    shown = MarkdownIt("commonmark").enable(["table", "strikethrough"]).render(markdown(text))
    said = html_text(text.strip(), quote=False).replace('"', "&quot;")
    assert shown == (f"<p>{said}</p>\n" if said else "")


def test_markdown_gets_no_markup() -> None:
    """Every sign that means something there has a backslash before it; a comma means nothing."""
    said = markdown("# a_b *c* [d](e) <script> $x$ `f` | \n1. g, h: i. (j)")
    assert said == r"\# a\_b \*c\* \[d\](e) \<script\> \$x\$ \`f\` \|  1. g, h: i. (j)"
    assert markdown("1. g") == r"1\. g"
    assert markdown("http://a.b or www.a.b") == r"http\://a.b or www\.a.b"
    assert markdown_code("a`b\n") == "`a'b `"
    assert markdown_heading(2, "a\n# b") == r"## a \# b"
