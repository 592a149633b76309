"""Which files lint looks at, and that a broken one keeps it from none of the others."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from dhcli.errors import DhcliError, FileError
from dhcli.lint.files import Linted, lint
from tests.lint.linting import ONE_JOINT, findings

ROOT = Path(__file__).parents[2]


def put(folder: Path, *names: str, text: str | bytes = ONE_JOINT) -> None:
    """The same text in several files."""
    for name in names:
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text if isinstance(text, bytes) else text.encode())


def messages(linted: Linted) -> list[str]:
    """Every finding with its place."""
    return [f"{one.problem.place}: {one.problem.message}" for one in linted.told]


@pytest.fixture(autouse=True)
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty folder to work in."""
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_a_folder_is_all_files_in_it_and_below(here: Path) -> None:
    """By name; hidden ones, sheets and files of other kinds are passed over."""
    put(here, "arms/b.yaml", "arms/a.yml", "arms/more/c.YAML", "arms/.git/d.yaml", "arms/.e.yaml", "arms/f.txt")
    put(here, "arms/alice.sheet.yaml", text="format: 1\nanswers: {}\n")
    linted = lint(["arms"])
    assert linted.files == tuple(str(Path("arms", name)) for name in ("a.yml", "b.yaml", "more/c.YAML"))
    assert linted.told == ()
    assert (linted.errors, linted.warnings) == (0, 0)


def test_several_paths_are_one_list_and_no_file_is_read_twice(here: Path) -> None:
    """Under the name by which it came first."""
    put(here, "arms/a.yaml", "arms/b.yaml", "c.yaml")
    (here / "arms/z.yaml").symlink_to("a.yaml")
    assert lint(["c.yaml", "./arms/b.yaml", "arms", "arms/b.yaml"]).files == (
        "c.yaml",
        str(Path("arms/b.yaml")),
        str(Path("arms/a.yaml")),
    )


def test_without_a_path_the_usual_folders_are_looked_at(here: Path) -> None:
    """Where neither is there, the error names what to write."""
    with pytest.raises(DhcliError, match=r"there is no \./robots and no \./exercises here") as caught:
        lint([])
    assert caught.value.problems[0].hint == "name files or folders: dhcli lint my-arm.yaml"
    put(here, "robots/a.yaml", "exercises/course/b.yaml", "elsewhere/c.yaml")
    assert lint([]).files == (str(Path("robots/a.yaml")), str(Path("exercises/course/b.yaml")))


def test_every_path_that_leads_nowhere_is_told(here: Path) -> None:
    """Before anything is linted: a file that is not there, a folder with nothing in it, a name of the library."""
    put(here, "good.yaml")
    (here / "empty").mkdir()
    with pytest.raises(FileError) as caught:
        lint(["good.yaml", "god.yaml", "empty", "planar-2r", "-"])
    told = [(str(one.place or ""), one.message, one.hint) for one in caught.value.problems]
    assert told == [
        ("god.yaml", "there is no such file", "did you mean good.yaml?"),
        ("empty", "holds no YAML file", "name a folder with robots or exercises"),
        ("planar-2r", "there is no such file or folder", "lint takes files and folders, such as robots/my-arm.yaml"),
        ("", "lint reads files, not standard input", "save it first: a file name is a name"),
    ]


BROKEN: dict[str, tuple[str | bytes, list[str]]] = {
    "a.yaml": (b"\xff\xfeb\x00a\x00d\x00", ["a.yaml: is written in UTF-16"]),
    "b.yaml": ("format: 1\ntitle: [\n", ["b.yaml:3:1: a value is missing here"]),
    "c.yaml": ("", ["c.yaml: is empty"]),
    "d.yaml": (ONE_JOINT.replace("An arm", "TODO"), ["d.yaml:2:8: title: still says 'TODO'"]),
    "e.yaml": (ONE_JOINT, []),
    "f.yaml": (
        ONE_JOINT.replace("theta: theta1", "theta: 2").replace("standard", "usual"),
        [
            "f.yaml:4:13: convention: 'usual' is not known",
            "f.yaml:8:36: theta: the angle 2 has no unit",
        ],
    ),
    "g.yaml": ("format: 1\nparts: {}\n", ["g.yaml:1:1: title: is missing", "g.yaml:1:1: source: is missing"]),
}


@pytest.mark.parametrize("as_folder", [True, False])
def test_a_broken_file_keeps_lint_from_no_other(here: Path, *, as_folder: bool) -> None:
    """Whether it came with its folder or by its name, everything is told of every file, in the order of the lines."""
    for name, (text, _) in BROKEN.items():
        put(here, name, text=text)
    linted = lint(["."] if as_folder else sorted(BROKEN))
    assert list(linted.files) == sorted(BROKEN)
    told = messages(linted)
    for name, (_, expected) in BROKEN.items():
        own = [line for line in told if line.startswith(name)]
        assert own[: len(expected)] == expected
        assert bool(own) is bool(expected)
    assert (linted.errors, linted.warnings) == (len(told), 0)


def test_a_sheet_is_no_content(here: Path) -> None:
    """Who names one is told what looks at it."""
    put(here, "alice.sheet.yaml", text="format: 1\nanswers: {}\n")
    (told,) = lint(["alice.sheet.yaml"]).told
    assert (str(told.problem.place), told.problem.message) == ("alice.sheet.yaml", "is an answer sheet")
    assert told.problem.hint == "dhcli check EXERCISE alice.sheet.yaml judges it"


def test_two_things_of_one_name_are_told(here: Path) -> None:
    """A robot named like an exercise is an error, one that hides another a warning; both stand at the head."""
    put(here, "robots/planar-2r.yaml", "robots/four-bar-in-space.yaml", "robots/mine.yaml")
    linted = lint(["robots"])
    assert [(line.message, line.hint) for line in (one.problem for one in linted.told)] == [
        ("four-bar-in-space is the name of the built-in linkage, too", "name the file otherwise"),
        ("planar-2r hides the built-in robot", "name the file otherwise"),
    ]
    assert [one.is_warning for one in linted.told] == [False, True]
    assert {str(one.problem.place).split(":", 1)[1] for one in linted.told} == {"1:1"}


@pytest.mark.parametrize("folder", ["robots", "exercises/wpi"])
def test_a_part_of_the_library_is_clean(folder: str) -> None:
    """The robots, the linkages and a folder of exercises; CI lints all of it, as an author does."""
    linted = lint([str(ROOT / folder)])
    assert len(linted.files) == sum(1 for _ in (ROOT / folder).rglob("*.yaml"))
    assert messages(linted) == []


DRAFT = """\
format: 1
title: ""
source: a test
robot: planar-2r
numeric: true
given: {theta1: 35°, theta2: 20°}
variants: {theta1: 20°..70°}
task: |
  Find the end; write here what it is.
parts:
  - id: tip
    ask: position of pose 0..2
    credit: 0
    hints: [""]
tests:
  - {part: tip, answer: "", verdict: WRONG}
"""


def test_a_draft_is_told_all_that_is_left_to_do_at_once(tmp_path: Path) -> None:
    """Words that are missing and a range that cannot be read hide no rule that does not need them."""
    told = [(one.at, one.message) for one in findings(tmp_path, DRAFT)]
    assert told == [
        ("2:8", "title: is empty"),
        ("7:20", "theta1: '20°..70°' is no range"),
        ("8:1", "task: still says 'write here what it is'"),
        ("13:13", "tip: is worth nothing"),
        ("14:13", "hints: is empty"),
        ("15:1", "tests: none is RIGHT"),
        ("16:25", "tip: the answer of the test is empty; it says WRONG"),
    ]


def test_nothing_is_judged_where_what_is_right_is_in_doubt(tmp_path: Path) -> None:
    """A robot that is not found makes no solution wrong: only what is written is looked at besides."""
    messages = [one.message for one in findings(tmp_path, DRAFT.replace("planar-2r", "planar-2x"))]
    assert "tests: none is RIGHT" in messages
    assert not [message for message in messages if "judged" in message]


ARM = """\
format: 1
title: An arm; TODO
source: a test
convention: standard
variables: [theta1, theta2, d3]
parameters: {a1: 300, a2: 0.3 m, a3: 0.1 m}
tool: Trans(0, 0, 100)
links:
  - {a: a1, alpha: 0, d: 120, theta: theta1}
  - {a: a2, alpha: 180, d: 0, theta: theta2}
  - {a: 0, alpha: 0, d: d3, theta: 0}
limits:
  theta1: [-160°, 160°]
  theta2: [90°, -90°]
poses:
  up: [190°, 100°, 0]
  home: [0, 0]
"""


@pytest.mark.parametrize(("key", "message"), [("Parts", "Parts: unknown key"), ("questions", "questions: unknown key")])
def test_an_exercise_is_one_also_where_its_parts_are_called_otherwise(tmp_path: Path, key: str, message: str) -> None:
    """And no robot without variables."""
    told = findings(tmp_path, DRAFT.replace("parts:", f"{key}:"))
    assert ("10:1", message, "did you mean parts?") in [(one.at, one.message, one.hint) for one in told]
    assert not [one for one in told if one.at == "1:1"]
    without = DRAFT[: DRAFT.index("parts:")] + DRAFT[DRAFT.index("tests:") :]
    assert "parts: is missing" in [one.message for one in findings(tmp_path, without)]
    assert not [one for one in findings(tmp_path, without) if "has no part" in one.message]


def test_a_slip_in_a_table_hides_nothing_that_stands_beside_it(tmp_path: Path) -> None:
    """Lengths, parameters, limits and poses are looked at, as far as they do not follow from the slip."""
    told = [(one.at, one.message) for one in findings(tmp_path, ARM)]
    assert told == [
        ("2:8", "title: still says 'TODO'"),
        ("6:18", "a1: 300 m is longer than any arm"),
        ("6:38", "a3: no link uses it"),
        ("7:7", "tool: 100 m is longer than any arm"),
        ("9:26", "d of row 1: 120 m is longer than any arm"),
        ("10:20", "alpha: the angle 180 has no unit"),
        ("14:3", "theta2: the lower limit is not below the upper one"),
        ("16:3", "up: theta1 = 190° is outside its limits"),
        ("17:3", "home: 2 values for 3 joints"),
    ]


def test_what_follows_from_a_slip_is_not_told_beside_it(tmp_path: Path) -> None:
    """A length that stands in a cell that cannot be read is used, and with an unknown unit no length is long."""
    text = ARM.replace("alpha: 180,", "alpha: 180°,").replace("theta: 0}", "theta: 5 + a3}")
    assert "a3: no link uses it" not in [one.message for one in findings(tmp_path, text)]
    text = ARM.replace("convention:", "units: millimetre\nconvention:")
    assert not [one for one in findings(tmp_path, text) if "longer than any arm" in one.message]


def test_of_two_parts_with_one_id_the_one_that_is_meant_is_pointed_at(tmp_path: Path) -> None:
    """By where it stands, for the id does not tell."""
    text = DRAFT.replace("tests:", "  - {id: tip, ask: link 1, credit: 0, prompt: TODO}\ntests:")
    told = [(one.at, one.message) for one in findings(tmp_path, text) if one.at.startswith("15:")]
    assert told == [
        ("15:5", "tip: has no hints"),
        ("15:6", "id: the id tip is used twice"),
        ("15:36", "tip: is worth nothing"),
        ("15:47", "prompt: still says 'TODO'"),
    ]


def test_a_file_that_does_not_load_is_still_told_that_its_name_is_taken(tmp_path: Path) -> None:
    """The name needs no more than the file."""
    messages = [one.message for one in findings(tmp_path, DRAFT, "puma560.yaml")]
    assert any("is the name of the built-in robot" in message for message in messages)


def test_a_folder_that_cannot_be_read_is_not_called_empty(here: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """One problem, and the one there is."""
    (here / "closed").mkdir()

    def walk(folder: Path, onerror: Callable[[OSError], None]) -> Iterator[object]:
        onerror(PermissionError(13, "Permission denied", str(folder)))
        return iter(())

    monkeypatch.setattr("os.walk", walk)
    with pytest.raises(FileError) as error:
        lint(["closed"])
    assert str(error.value) == "closed: cannot be read: Permission denied"
