"""Answer sheets: what is written is read back, and answers are texts, whatever YAML would make of them."""

from __future__ import annotations

import re
from pathlib import Path
from textwrap import indent

import pytest

from dhcli.checking.kinds.cell import CellQuestion
from dhcli.checking.kinds.factors import FactorsQuestion
from dhcli.checking.kinds.table import TableQuestion
from dhcli.checking.verdicts import Verdict
from dhcli.errors import FileError
from dhcli.files.library.entries import Kind, entries
from dhcli.files.yaml.beside import values_text
from dhcli.files.yaml.exercises import load_exercise
from dhcli.files.yaml.robots import load_robot
from dhcli.files.yaml.sheets import WIDEST, Sheet, check_numbers, judged_sheet, read_sheet, write_sheet
from dhcli.files.yaml.tables import read_table
from dhcli.kinematics.conventions import Convention
from dhcli.notation.parser import parse
from tests.judging import judge_of, mark
from tests.row_by_row import row_by_row

ROOT = Path(__file__).parents[3]


@pytest.fixture
def sheet(tmp_path: Path) -> Path:
    """Where a sheet is written."""
    return tmp_path / "sheet.yaml"


def read(path: Path, answers: str, head: str = "format: 1\nexercise: yim/planar-two-links\n") -> Sheet:
    """A sheet with these answers."""
    path.write_text(f"{head}answers:\n{answers}", "utf-8")
    return read_sheet(path)


def problems(path: Path, text: str) -> list[str]:
    """Everything that is wrong with a sheet."""
    path.write_text(text, "utf-8")
    with pytest.raises(FileError) as caught:
        read_sheet(path)
    return [str(problem).replace(str(path), "sheet") for problem in caught.value.problems]


def test_a_blank_sheet_shows_the_task_and_how_to_answer() -> None:
    """In comments, so that it stays a sheet."""
    exercise = load_exercise("yim/planar-two-links")
    text = write_sheet(exercise)
    lines = text.splitlines()
    assert lines[0] == f"# {exercise.title}"
    assert f"dhcli check {exercise.id} THIS_FILE" in text
    assert "c1 for cos(theta1)" in text
    comments = " ".join(line.lstrip(" #") for line in lines)
    assert " ".join(exercise.task.split()) in comments
    assert "a1*c1 or a1c1" in comments
    for part in exercise.parts:
        assert f"  {part.id}: |" in lines
    assert "angles in degrees" in text
    option = "the upper index names the frame that is described, the lower index the frame it is seen from"
    assert f"#   1: {option}" in text.replace("\n  #      ", " ")
    assert all(len(line) <= WIDEST for line in lines)


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("bajd/order-of-displacements", "Numbers"),
        ("yim/dh-rules", "Symbols"),
        ("zhou/standard-or-modified", ""),
        ("yim/counting-freedoms", ""),
    ],
)
def test_a_blank_sheet_explains_only_what_it_needs(name: str, said: str) -> None:
    """Where every answer is a choice or a count, neither cosines nor decimals."""
    text = write_sheet(load_exercise(name))
    assert [word for word in ("Numbers", "Symbols") if f"# {word}" in text] == ([said] if said else [])


@pytest.mark.parametrize("name", ["yim/dh-rules", "zhou/standard-link-matrix", "yim/planar-two-links"])
def test_the_symbols_that_a_blank_sheet_shows_can_be_read_in_it(name: str) -> None:
    """A general link has c_i where an arm has c1."""
    exercise = load_exercise(name)
    (shown,) = re.findall(r"# Symbols: (\S+) for (cos\S+\))", write_sheet(exercise))
    short, written = (parse(text, exercise.scope) for text in shown)
    assert short == written
    products = re.findall(r"\w+\*\w+", write_sheet(exercise).partition("# Products:")[2].partition("format:")[0])
    assert products
    assert all(parse(text, exercise.scope) for text in products)


def test_every_blank_sheet_is_as_narrow_as_its_words_allow() -> None:
    """Only the command to be copied and single words may be wider."""
    for entry in entries(Kind.EXERCISES):
        for line in write_sheet(load_exercise(entry.name)).splitlines():
            assert len(line) <= WIDEST or "dhcli check" in line, line


@pytest.mark.parametrize(("name", "unit"), [("yim/planar-in-numbers", "m"), ("bajd/scara-pose-in-mm", "mm")])
def test_a_blank_sheet_for_numbers_names_its_unit(name: str, unit: str) -> None:
    """So that nobody has to guess."""
    assert f"lengths in {unit} unless a unit stands with them" in write_sheet(load_exercise(name))


def test_where_no_unit_is_named_a_blank_sheet_names_none() -> None:
    """And what is wrong is told without one."""
    exercise = load_exercise("bajd/composed-pose")
    assert "Numbers without a unit" in write_sheet(exercise)
    said = mark(exercise, exercise.part("h"), "0 0 1 14; 1 0 0 8; 0 1 0 -6; 0 0 0 1").remarks
    assert said == ("the rotation is right; the position is off by 6 along x, 14 along y, -20 along z",)


def test_a_table_in_numbers_says_that_a_joint_has_a_variable(tmp_path: Path) -> None:
    """Whose value stands among what is given, and would be no cell of a table; in letters nobody would think so."""
    path = tmp_path / "x.yaml"
    path.write_text(
        "format: 1\ntitle: x\nsource: {document: x, item: x}\nrobot: planar-2r\ntask: x\nnumeric: true\n"
        "given: {theta1: 30°, theta2: 45°}\nparts:\n  - {id: table, ask: table standard, hints: [x]}\n",
        "utf-8",
    )
    said = "in the cell that a joint changes stands its variable: theta1, theta2"
    assert said in write_sheet(load_exercise(path))
    assert said not in write_sheet(load_exercise("yim/planar-two-links"))


def test_the_task_can_hold_what_yaml_would_choke_on(sheet: Path) -> None:
    """Colons, quotes, dashes: a comment is a comment."""
    from dhcli.files.yaml.exercises import read_exercise

    text = "format: 1\ntitle: 'a: b # c'\nsource: '- x'\ntask: |\n  answers: {1}\n\n  --- 'quoted\nparts:\n"
    exercise = read_exercise(text + "  - {id: a, ask: scalar 1, prompt: 'so: # what'}\n", "my.yaml", "mine")
    sheet.write_text(write_sheet(exercise), "utf-8")
    assert {key: answer.text for key, answer in read_sheet(sheet).answers.items()} == {"a": "_"}


@pytest.mark.parametrize(
    ("written", "meant"),
    [
        ("  a: 1e-3\n", "1e-3"),
        ("  a: 010\n", "010"),
        ("  a: yes\n", "yes"),
        ("  a: 12:30\n", "12:30"),
        ("  a: ~\n", "~"),
        ("  a:\n", ""),
        ("  a: '[1 2; 3 4]'\n", "[1 2; 3 4]"),
        ("  a: [[1, 2], [3, 4]]\n", "[[1, 2], [3, 4]]"),
        ("  a:\n    - [c1, -s1]\n    - [s1, c1]\n", "[[c1, -s1], [s1, c1]]"),
        ("  a:\n    - - 1\n      - 2\n    - - 3\n      - 4\n", "[[1, 2], [3, 4]]"),
        ("  a: {x: 1, y: 2}\n", "{x: 1, y: 2}"),
        ("  a: |\n    1 2\n    3 4\n", "1 2\n3 4"),
        ("  a: >\n    1\n    2\n", "1 2"),
        ("  a: '\\theta_1'\n", "\\theta_1"),
    ],
)
def test_answers_are_texts_as_typed(sheet: Path, written: str, meant: str) -> None:
    """YAML lists become the matrix they look like; nothing becomes a number or a truth."""
    assert read(sheet, written).answers["a"].text == meant


@pytest.mark.parametrize(
    "answer",
    [
        "[[c1, -s1, 0, a1*c1], [s1, c1, 0, a1*s1], [0, 0, 1, 0], [0, 0, 0, 1]]",
        "\n    - [c1, -s1, 0, a1*c1]\n    - [s1, c1, 0, a1*s1]\n    - [0, 0, 1, 0]\n    - [0, 0, 0, 1]",
        "|\n    c1 -s1 0 a1*c1\n    s1  c1 0 a1*s1\n    0   0  1 0\n    0   0  0 1",
        "'[c1 -s1 0 a1*c1; s1 c1 0 a1*s1; 0 0 1 0; 0 0 0 1]'",
        ">-\n    [c1 -s1 0 a1*c1;\n    s1 c1 0 a1*s1;\n    0 0 1 0;\n    0 0 0 1]",
    ],
)
def test_a_matrix_is_right_however_yaml_holds_it(sheet: Path, answer: str) -> None:
    """Flow lists, block lists, blocks of text, quotes."""
    exercise = load_exercise("yim/planar-two-links")
    found = read(sheet, f"  a1: {answer}\n").answers["a1"]
    assert mark(exercise, exercise.part("a1"), found.text).verdict is Verdict.RIGHT


def test_a_mistake_in_an_answer_is_found_in_the_sheet(sheet: Path) -> None:
    """With the line of the file."""
    exercise = load_exercise("yim/planar-two-links")
    found = read(sheet, "  a1: |\n    c1 -s1 0 a1*c1\n    s1 c1 0 a9*s1\n    0 0 1 0\n    0 0 0 1\n").answers["a1"]
    judged = mark(exercise, exercise.part("a1"), found.text, found.place)
    assert f"{sheet}:6" in judged.remarks[0]
    assert "a9" in judged.remarks[0]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "is empty"),
        ("answers: [1, 2]\nformat: 1\n", "answers"),
        ("answers: 5\nformat: 1\n", "answers"),
        ("format: 1\nexercise: x\n", "answers: is missing"),
        ("format: 1\nexercise: [a]\nanswers: {a: 1}\n", "exercise"),
        ("format: 1\nanswer: {a: 1}\nanswers: {a: 1}\n", "answer: unknown key (did you mean answers"),
        ("format: 2\nanswers: {a: 1}\n", "2"),
        ("- 1\n", ""),
        ("format: 1\nanswers: {a: 1, a: 2}\n", "a: stands twice"),
        ("format: 1\nanswers: {a: &x [1], b: *x}\n", "YAML anchor"),
        ("format: 1\nanswers: {a: !!python/object/apply:os.system [ls]}\n", "tag"),
        ("format: 1\nanswers:\n  <<: {a: 1}\n", "merge key"),
        ("format: 1\nanswers: {? [1, 2] : 3}\n", "a key cannot be a list"),
        ("format: 1\nanswers: {a: [1, 2\n", ""),
        ('format: 1\nanswers: {a: "\\theta"}\n', "control character U+0009"),
        ("format: 1\nanswers: {a: '\x1b[31m'}\n", "U+001B"),
        ("format: 1\nanswers: {a: 1}\n---\nformat: 1\n", "a second document"),
        ("format: 1\nanswers: {a: " + "[" * 500 + "]" * 500 + "}\n", "nested more than"),
        ("format: 1\nanswers: {a: [" + "1, " * 30_000 + "1]}\n", "more than 20,000 keys"),
        ("format: 1\nanswers: {a: '" + "1 " * 150_000 + "'}\n", "more than the 256 kB"),
    ],
)
def test_what_is_no_sheet_is_refused_with_a_reason(sheet: Path, text: str, said: str) -> None:
    """Wrong types, YAML's hidden doors, and more than anybody types."""
    found = problems(sheet, text)
    assert said in "\n".join(found)
    assert all(problem.startswith("sheet") for problem in found)


def test_a_billion_laughs_are_not_laughed(sheet: Path) -> None:
    """Aliases are refused before anything is expanded, in each answer by itself."""
    levels = "".join(f"  x{i}: &x{i} [{', '.join([f'*x{i - 1}'] * 9)}]\n" for i in range(1, 30))
    found = read(sheet, "  x0: &x0 [lol]\n" + levels).answers
    assert len(found) == 30
    assert all("anchor" in answer.problem for answer in found.values())
    assert sum(len(answer.text) for answer in found.values()) < len(levels)


ANSWERS = {
    "a1": "c1 -s1 0 a1*c1; s1 c1 0 a1*s1; 0 0 1 0; 0 0 0 1",
    "blocks": "1",
    "d02": "a1*c1 + a2*c12, a1*s1 + a2*s12, 0",
    "x2": "c12, s12, 0",
}


@row_by_row("slip", ["'{}", '"{}', "'{}'s", "[{}", "{{{}", "& {}", "*x {}", "|\n{}", "a: b: {}", "'{}\n\n  "])
@row_by_row("broken", ANSWERS)
def test_an_answer_that_is_no_yaml_leaves_the_others_what_they_are(sheet: Path, broken: str, slip: str) -> None:
    """A stray quote, an open bracket, a line too far left: that answer is told of with its line, and no other."""
    right = read(sheet, "".join(f"  {name}: '{text}'\n" for name, text in ANSWERS.items()))
    written = [(name, slip.format(text) if name == broken else f"'{text}'") for name, text in ANSWERS.items()]
    found = read(sheet, "".join(f"  {name}: {text}\n" for name, text in written))
    assert set(found.answers) == set(ANSWERS)
    for name, answer in found.answers.items():
        assert (answer.text == right.answers[name].text) == (name != broken)
        assert bool(answer.problem) == (name == broken)
    marks = judged_sheet(judge_of(load_exercise(found.exercise)), found, "this sheet")
    mark_of = {one.part.id: one.mark for one in marks.parts}
    assert mark_of[broken].verdict is Verdict.CANNOT_READ
    assert all(mark_of[name].verdict is Verdict.RIGHT for name in ANSWERS if name != broken)
    line = 4 + list(ANSWERS).index(broken)
    assert re.match(rf"{re.escape(str(sheet))}:({line}|{line + 1}):", mark_of[broken].remarks[0])


@pytest.mark.parametrize("part", ["  ", "\t", " \t"])
@pytest.mark.parametrize("row", ["    ", "\t\t", "\t", "  \t"])
def test_tabs_that_indent_answers_are_read_as_blanks(sheet: Path, part: str, row: str) -> None:
    """An editor writes them; each answer stays its own, whatever looks like a key within it."""
    written = {"a1": "c1 -s1\n", "d02": "x: 1, y: 2\n", "x2": "x: 1\ny: 2\n"}
    lines = ["  a2: |\n    1 2\n"]
    lines += [f"{part}{name}: |\n{indent(text, row)}\n" for name, text in written.items()]
    found = read(sheet, "".join(lines)).answers
    assert {name: answer.text.split() for name, answer in found.items()} == {
        name: text.split() for name, text in {"a2": "1 2", **written}.items()
    }
    assert not any(answer.problem for answer in found.values())


def test_a_sheet_whose_fault_is_in_no_answer_is_refused_as_before(sheet: Path) -> None:
    """A head that is no YAML, and an answer that stands twice."""
    assert "never closed" in problems(sheet, "format: 1\nexercise: 'x\nanswers:\n  a: 1\n")[0]
    assert "never closed" in problems(sheet, "format: 1\nanswers:\n  b: 2\n  b: 3\n  a: '1\n")[-1]


def test_a_robot_file_is_a_table(tmp_path: Path) -> None:
    """Its rows under a line that names the columns; products are none."""
    arm = load_robot("planar-2r")
    table = read_table(ROOT / "robots" / "planar-2r.yaml", arm)
    assert table.convention is Convention.STANDARD
    assert table.text.splitlines() == ["a [m], alpha, d [m], theta", "a1, 0, 0, theta1", "a2, 0, 0, theta2"]
    bare = (ROOT / "robots" / "planar-2r.yaml").read_text("utf-8").replace(" mm", "").replace(" m,", ",")
    (tmp_path / "bare.yaml").write_text(bare.replace(" m}", "}"), "utf-8")
    assert read_table(tmp_path / "bare.yaml", arm).text.startswith("a, alpha, d, theta\n")
    with pytest.raises(FileError, match="products"):
        read_table(ROOT / "robots" / "scara.yaml", arm)
    with pytest.raises(FileError, match="no such file"):
        read_table(tmp_path / "none.yaml", arm)


@pytest.mark.parametrize(
    ("name", "line"),
    [
        ("yim/planar-in-numbers", "# Robot: a1 = 0.4 m, a2 = 0.3 m; dhcli show planar-2r shows its table"),
        ("wpi/puma560-entries-of-0t6", "# Robot: dhcli show puma560 shows its table"),
    ],
)
def test_a_sheet_says_what_is_needed_of_the_robot(name: str, line: str) -> None:
    """Its lengths where numbers are asked, and where its table is to be seen."""
    assert line in write_sheet(load_exercise(name)).splitlines()


@row_by_row("name", [entry.name for entry in entries(Kind.EXERCISES)])
def test_a_sheet_does_not_give_the_table_away_that_it_asks_for(name: str) -> None:
    """Nor what can be read off it: one of its cells, or the moves of a link."""
    exercise = load_exercise(name)
    asks = any(isinstance(part.question, TableQuestion | CellQuestion | FactorsQuestion) for part in exercise.parts)
    text = write_sheet(exercise)
    if asks:
        assert "shows its table" not in text
    if exercise.numeric and exercise.robot:
        assert all(f" {name} = " in text for name, value in exercise.robot.parameters.items() if value is not None)


def test_every_sheet_is_read_back_with_the_numbers_it_was_written_with(sheet: Path) -> None:
    """Also where a value holds what YAML would take apart."""
    for entry in entries(Kind.EXERCISES):
        exercise = load_exercise(entry.path)
        sheet.write_text(write_sheet(exercise), "utf-8")
        found = read_sheet(sheet)
        assert dict(found.given) == (values_text(exercise) if exercise.numeric else {})
        check_numbers(found, exercise, "sheet")
