"""The schemas for editors: every file of the library is right by them, and mistakes that dhcli refuses are marked."""

from __future__ import annotations

from functools import cache, lru_cache
from pathlib import Path
from typing import Any

import jsonschema
import pytest
import yaml

from dhcli.checking.kinds.registry import every_kind
from dhcli.errors import DhcliError
from dhcli.files.keys.exercises import OF_KINDS
from dhcli.files.keys.robots import ROBOTS
from dhcli.files.keys.schema import KINDS, schema_of
from dhcli.files.keys.shapes import names
from dhcli.files.yaml.exercises import read_exercise
from dhcli.files.yaml.linkages import read_linkage
from dhcli.files.yaml.robots import read_robot
from tests.row_by_row import row_by_row

ROOT = Path(__file__).parents[3]
FILES = [
    *(("robot", path) for path in sorted((ROOT / "robots").glob("*.yaml"))),
    *(("linkage", path) for path in sorted((ROOT / "robots" / "linkages").glob("*.yaml"))),
    *(("exercise", path) for path in sorted((ROOT / "exercises").rglob("*.yaml"))),
]


def test_every_key_that_a_kind_of_question_reads_is_described() -> None:
    """Whoever adds one to a kind adds a line to OF_KINDS."""
    assert set(names(OF_KINDS)) == {key for kind in every_kind() for key in kind.keys}


@cache
def validator(kind: str) -> jsonschema.Draft202012Validator:
    """What tells mistakes by a schema, which is one itself."""
    schema = schema_of(kind)
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)


@lru_cache(maxsize=1)
def content(text: str) -> object:
    """What an editor finds in a file; the one of several schemas is asked of what was read for the other."""
    return yaml.load(text, getattr(yaml, "CSafeLoader", yaml.SafeLoader))  # noqa: S506  both are safe


def faults(kind: str, text: str) -> list[str]:
    """The mistakes in a file that an editor marks."""
    return [error.message for error in validator(kind).iter_errors(content(text))]


@row_by_row(("kind", "path"), FILES)
def test_a_file_of_the_library_is_right_by_its_schema(kind: str, path: Path) -> None:
    """And a file of one kind is none of another."""
    text = path.read_text("utf-8")
    assert faults(kind, text) == []
    assert all(faults(other, text) for other in KINDS if other != kind)


ROBOT = """\
format: 1
title: t
source: s
convention: standard
variables: [q1, q2]
parameters: {a1: 0.4, a2: }
links:
  - {a: a1, alpha: 0, d: 0, theta: q1}
  - {a: a2, alpha: 90°, d: 0, theta: q2}
limits: {q1: [-90°, 90°]}
poses: {home: [0, 0]}
tools: {gripper: "Trans(0, 0, 0.1)"}
first: 1
x-mine: {anything: [1]}
"""
DRAWN = """\
format: 1
title: t
source: s
convention: axes
variables: [q1, q2]
axes:
  - {q1: +z, through: [0, 0, 0]}
  - {q2: [0, 1, 0], through: (0, 0, 0.4)}
end: Trans(0.4, 0, 0)
"""
EXERCISE = """\
format: 1
title: t
source: {document: d, item: 1}
robot: planar-2r
task: Both joints turn about z, with the arm stretched along x0.
given: {theta1: 35°}
unit: mm
tolerance: {rotation: 0.001, decimals: 3}
credit: {close: 1/2}
parts:
  - {id: a, ask: pose 0..2, credit: 2, hints: [h]}
  - {id: b, ask: choice, options: [x, y], right: 1, credit: {points: 2, close: 1/2}}
printed: {a: {answer: "1", note: n}}
tests:
  - {part: b, answer: 1, verdict: RIGHT}
"""
LINKAGE = """\
format: 1
title: t
source: s
space: planar
points: {A: [0, 0], B: [1, 0], C: [1, 1], D: [0, 1]}
joints:
  - ground R crank at A
  - crank R rod at B
  - {type: R, links: [rod, rocker], point: C}
  - rocker R ground at D
output: rod
"""
TEXTS = {"robot": ROBOT, "exercise": EXERCISE, "linkage": LINKAGE}
READERS: dict[str, Any] = {"robot": read_robot, "exercise": read_exercise, "linkage": read_linkage}


@pytest.mark.parametrize("kind", KINDS)
def test_a_file_with_every_sort_of_value_is_right(kind: str) -> None:
    """By the schema, and for dhcli."""
    assert faults(kind, TEXTS[kind]) == []
    READERS[kind](TEXTS[kind], "x", "x")


def test_drawn_axes_are_right() -> None:
    """Their points in square brackets, or in round ones, which are several values to YAML."""
    assert faults("robot", DRAWN) == []
    read_robot(DRAWN, "x", "x")


SLIPS = [
    ("robot", "format: 1\n", "format: 2\n"),
    ("robot", "format: 1\n", ""),
    ("robot", "title: t\n", "titel: t\n"),
    ("robot", "source: s\n", ""),
    ("robot", "source: s\n", "source: [s]\n"),
    ("robot", "standard", "standrad"),
    ("robot", "convention: standard\n", ""),
    ("robot", "convention: standard\n", "convention: axes\n"),
    ("robot", "convention: standard\n", "convention: product\n"),
    ("robot", "variables: [q1, q2]", "variables: q1"),
    ("robot", "parameters: {a1: 0.4, a2: }", "parameters: [a1]"),
    ("robot", "alpha: 90°", "alpha: 90"),
    ("robot", "theta: q2}", "theta: q2, beta: 3}"),
    ("robot", "d: 0, theta: q1", "theta: q1"),
    ("robot", "  - {a: a1, alpha: 0, d: 0, theta: q1}\n", "  - Rot(z, q1)\n"),
    ("robot", "[-90°, 90°]", "[-90°, 0, 90°]"),
    ("robot", "[-90°, 90°]", "-90°"),
    ("robot", "home: [0, 0]", "home: {q1: 0}"),
    ("robot", 'tools: {gripper: "Trans(0, 0, 0.1)"}', "tools: [gripper]"),
    ("robot", "first: 1", "first: one"),
    ("robot", "first: 1", "exact: maybe"),
    ("robot", "first: 1", "x_mine: 1"),
    ("robot", "first: 1", "home: Trans(0, 0, 1)"),
    ("exercise", "task: ", "tsak: "),
    ("exercise", "source: {document: d, item: 1}", "source: {document: d}"),
    ("exercise", "unit: mm", "unit: miles"),
    ("exercise", "decimals: 3", "digits: 3"),
    ("exercise", "decimals: 3", "exact: perhaps"),
    ("exercise", "credit: {close: 1/2}\n", "credit: {near: 1/2}\n"),
    ("exercise", "ask: pose 0..2, ", ""),
    ("exercise", "hints: [h]", "hint: h"),
    ("exercise", "options: [x, y]", "options: x"),
    ("exercise", "right: 1", "compare: same"),
    ("exercise", "points: 2", "worth: 2"),
    ("exercise", "note: n", "nota: n"),
    ("exercise", "verdict: RIGHT", "verdict: right"),
    ("exercise", ", verdict: RIGHT", ""),
    ("exercise", "given: {theta1: 35°}", "given: [35°]"),
    ("exercise", "unit: mm", "feedback: none"),
    ("exercise", "unit: mm", "numeric: perhaps"),
    ("linkage", "space: planar", "space: flat"),
    ("linkage", "space: planar\n", ""),
    ("linkage", "space: planar\n", "space: planar\nlambda: 3\n"),
    ("linkage", "output: rod", "outputs: rod"),
    ("linkage", "output: rod", "chain: ground R a R ground"),
    ("linkage", "A: [0, 0]", "A: [0]"),
    ("linkage", "links: [rod, rocker]", "links: [rod]"),
    ("linkage", "type: R, ", ""),
    ("linkage", "point: C", "points: C"),
    ("linkage", "joints:", "jionts:"),
]


@row_by_row(("kind", "old", "new"), SLIPS)
def test_a_mistake_of_each_class_is_marked_and_refused(kind: str, old: str, new: str) -> None:
    """By the editor first, and by dhcli all the same."""
    assert TEXTS[kind].count(old) >= 1
    text = TEXTS[kind].replace(old, new, 1)
    assert faults(kind, text)
    with pytest.raises(DhcliError):
        READERS[kind](text, "x", "x")


@pytest.mark.parametrize("convention", ["axes", "screws", "product", "modified"])
def test_each_convention_has_its_own_keys(convention: str) -> None:
    """Those of another are marked, and what is missing."""
    head = f"format: 1\ntitle: t\nsource: s\nconvention: {convention}\nvariables: [q1]\n"
    assert faults("robot", head)
    own = names(ROBOTS[convention])
    other = next(name for keys in ROBOTS.values() for name in names(keys) if name not in own)
    assert any("False schema" in fault for fault in faults("robot", f"{head}{other}: x\n"))


def test_every_key_is_told_in_a_sentence() -> None:
    """Which an editor shows beside it."""
    for kind in KINDS:
        for name, key in schema_of(kind)["properties"].items():
            assert key["description"].rstrip().endswith((".", key["description"].partition("Example: ")[2])), name
            assert key["description"][0].isupper() or not key["description"][0].isalpha()
