"""Rules for linkages: texts that are finished, and a geometry that settles the mobility."""

from __future__ import annotations

from pathlib import Path

import pytest

from dhcli.files.library.entries import Kind
from dhcli.files.library.lookup import find
from tests.lint.linting import Broken, assert_told, cases, findings

CLEAN = """\
format: 1
title: Five bars
source: a test
space: planar
points: {A: [0, 0], B: [-0.5, 1], C: [0.6, 1.8], D: [1.8, 1.1], E: [1.2, 0]}
bars:
  ground: [A, E]
  left: [A, B]
  left2: [B, C]
  right2: [C, D]
  right: [D, E]
"""

WRITE = "write what belongs there"


@cases(
    Broken("title: Five bars", "title: TODO", "2:8", "title: still says 'TODO'", WRITE),
    Broken("source: a test", "source: FIXME", "3:9", "source: still says 'FIXME'", WRITE),
)
def test_a_text_that_is_not_finished_is_told(broken: Broken, tmp_path: Path) -> None:
    """Wherever it stands."""
    assert_told(tmp_path, CLEAN, broken)


def test_a_geometry_that_cannot_be_is_told(tmp_path: Path) -> None:
    """With the reason, and what would be right."""
    text = CLEAN[: CLEAN.index("points:")] + (
        "points: {O: [0, 0]}\n"
        "joints:\n"
        "  - ground R carrier at O\n"
        "  - carrier R sun at O\n"
        "  - {type: gear, links: [sun, planet], carrier: carrier, radii: [1, 0.6]}\n"
    )
    (found,) = findings(tmp_path, text)
    assert (found.at, found.message) == ("1:1", "nothing but gear teeth holds planet")
    assert found.hint == "a wheel turns in a carrier: add its joint"


def test_a_geometry_that_leaves_the_mobility_open_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """As with more motions than are tried."""
    parallel = find(Kind.LINKAGES, "parallel-four-bar-third-crank").read_text("utf-8")
    assert findings(tmp_path, parallel) == []
    monkeypatch.setattr("dhcli.mobility.truth.MOST_MOTIONS", 1)
    (found,) = findings(tmp_path, parallel)
    assert found.message.startswith("the geometry does not decide the mobility: undecided: more than 1 motions")
    assert found.hint == "are the lengths exact? expressions keep them so"


def test_counts_alone_need_only_a_title(tmp_path: Path) -> None:
    """Without a geometry there is nothing to decide."""
    counts = "format: 1\ntitle: TITLE\nsource: a test\nspace: planar\nlinks: 4\njoints: 4R\n"
    assert findings(tmp_path, counts.replace("TITLE", "Four bars")) == []
    (found,) = findings(tmp_path, counts.replace("TITLE", "TODO"))
    assert (found.at, found.message) == ("2:8", "title: still says 'TODO'")


def test_points_in_millimetres_without_their_unit_are_told_once(tmp_path: Path) -> None:
    """By the one that lies farthest out: with a name, without one, and in a loop of rows."""
    drawn = CLEAN.replace("[0.6, 1.8]", "[60, 180]")
    (found,) = findings(tmp_path, drawn)
    assert (found.at, found.message) == ("5:35", "C: a coordinate of 180 m is larger than any linkage")
    assert (found.hint, found.is_warning) == ("bare lengths are metres: did you mean 180 mm?", True)
    head = CLEAN[: CLEAN.index("points:")]
    listed = head + "joints:\n  - {type: R, links: [ground, a], point: [300, 0]}\n"
    (found,) = findings(tmp_path, listed)
    assert (found.at, found.message) == ("5:1", "a point: a coordinate of 300 m is larger than any linkage")
    row = "    - {a: 300, alpha: 0, d: 0, theta: 90°}\n"
    loop = head.replace("planar", "spatial") + f"loop:\n  convention: standard\n  rows:\n{4 * row}"
    (found,) = findings(tmp_path, loop)
    assert (found.at, found.message) == ("5:1", "a point: a coordinate of 300 m is larger than any linkage")


def test_a_joint_whose_place_is_forgotten_is_told(tmp_path: Path) -> None:
    """Of a linkage without any points nothing is: only its formula is wanted."""
    text = CLEAN[: CLEAN.index("points:")] + (
        "points: {O: [0, 0], A: [0.1, 0.2], B: [0.5, 0]}\n"
        "joints:\n"
        "  - ground R crank at O\n"
        "  - crank R rod at A\n"
        "  - rod R slider at B\n"
        "  - slider P ground along x\n"
    )
    assert findings(tmp_path, text) == []
    (found,) = findings(tmp_path, text.replace(" along x", ""))
    assert (found.at, found.message) == ("10:5", "joint 4: its axis is not said")
    assert (found.hint, found.is_warning) == ("without it only the formula counts", True)
    bare = text.replace(" at O", "").replace(" at A", "").replace(" at B", "").replace(" along x", "")
    assert findings(tmp_path, bare) == []


def test_a_pin_that_is_no_point_is_told_also_where_one_bar_alone_has_it(tmp_path: Path) -> None:
    """It is a slip of the pen."""
    told = findings(tmp_path, CLEAN.replace("left: [A, B]", "left: [A, b]"))
    assert [(one.at, one.message, one.hint) for one in told] == [
        ("8:13", "bars: there is no point called b", "did you mean B?")
    ]


@pytest.mark.parametrize(("word", "meant"), [("plane", "planar"), ("2D", "planar")])
def test_a_space_in_other_words_is_told_alone(tmp_path: Path, word: str, meant: str) -> None:
    """Not that its points lack a third coordinate."""
    (found,) = findings(tmp_path, CLEAN.replace("space: planar", f"space: {word}"))
    assert (found.message, found.hint) == (f"space: there is no space '{word}'", f"write {meant}")
    (found,) = findings(tmp_path, CLEAN.replace("space: planar\n", ""))
    assert found.message == "space: is missing"


def test_points_in_round_brackets_are_shown_in_square_ones(tmp_path: Path) -> None:
    """Between braces, where their comma ends them, and in lines."""
    (found,) = findings(tmp_path, CLEAN.replace("A: [0, 0]", "A: (0, 0)"))
    assert found.hint == "write A: [0, 0], or as a text '(0, 0)'"
    lines = CLEAN.replace("points: {A: [0, 0], B:", "points:\n  A: (0, 0)\n  B:").replace(", 1], C", ", 1]\n  C")
    lines = lines.replace("], D", "]\n  D").replace("], E", "]\n  E").replace("}", "")
    (found,) = findings(tmp_path, lines)
    assert (found.message, found.hint) == ("A: should be a list, is a text", "write [0, 0]")


def test_a_decimal_comma_in_a_point_is_told(tmp_path: Path) -> None:
    """Also where three numbers in the plane would be taken for a point above it."""
    (found,) = findings(tmp_path, CLEAN.replace("A: [0, 0]", "A: [0,0, 0]"))
    assert found.message == "A: a number has a decimal comma, which ends a value here"
    assert found.hint == "write [0.0, 0]"


def test_links_without_brackets_are_shown_with_them(tmp_path: Path) -> None:
    """A blank separates names, and nothing else follows."""
    text = "format: 1\ntitle: T\nsource: S\nspace: planar\njoints:\n"
    (found,) = findings(tmp_path, f"{text}  - {{type: R, links: crank rod}}\n  - {{type: R, links: [crank, rod]}}\n")
    assert (found.message, found.hint) == ("links: should be a list, is a text", "write [crank, rod]")
    (found,) = findings(tmp_path, f"{text}  - {{type: R, links: crank}}\n  - {{type: R, links: [crank, rod]}}\n")
    assert (found.message, found.hint) == ("links: should be a list, is a text", "write [ground, crank]")


def test_cosines_of_degrees_without_their_sign_are_told(tmp_path: Path) -> None:
    """Nobody means 60 radians, written or by a name."""
    (found,) = findings(tmp_path, CLEAN.replace("B: [-0.5, 1]", "B: [-0.5, cos(60)]"))
    assert found.message == "cos of 60 does not say what 60 is"
    assert found.hint == "write 60° for degrees, 60 rad for radians"
    named = CLEAN.replace("points:", "let: {phi: 60}\npoints:").replace("B: [-0.5, 1]", "B: [-0.5, 2*cos(phi)]")
    (found,) = findings(tmp_path, named)
    assert found.message == "phi is 60 without a unit, and stands in a cosine or sine"
    assert found.hint == "write phi: 60°"
    assert findings(tmp_path, named.replace("phi: 60", "phi: 60°")) == []
    assert findings(tmp_path, named.replace("phi: 60", "phi: 1.0472")) == []


LOOSE = "format: 1\ntitle: T\nsource: S\nspace: planar\npoints: {A: [0, 0], B: [1, 0]}\njoints:\n"


@pytest.mark.parametrize(
    ("joint", "message", "hint"),
    [
        ("ground - R - crank", "'ground - R - crank' is not read as a joint", "write ground R crank"),
        (
            "ground -> R -> crank at A",
            "'ground -> R -> crank at A' is not read as a joint",
            "write ground R crank at A",
        ),
        ("ground, R, crank", "'ground, R, crank' is not read as a joint", "write ground R crank"),
        ("R ground crank", "'R ground crank' is not read as a joint", "write ground R crank"),
        ("ground R crank at (0, 1)", "point: should be a list, is a text", "write [0, 1]"),
        ("ground R crank at [0 1]", "point: a comma stands between values", "write [0, 1]"),
        ("ground R crank at [0, 1, 2, 3]", "point: two coordinates are wanted, not 4", "write [x, y]"),
        ("ground P crank along (1, 0)", "axis: should be a list, is a text", "write [1, 0]"),
        ("ground P crank along X", "axis: 'X' is no direction", "write x"),
        ("ground P crank along A-B", "axis: 'A-B' is no direction", "write A to B"),
        ("{type: R, links: [ground, crank], at: A}", "at: unknown key", "did you mean point?"),
        (
            "{type: H, links: [ground, crank], axis: x, pitch: 5 mm/rev}",
            "5 mm/rev says for each turn, which a pitch is anyway",
            "write 5 mm",
        ),
        ("{type: R, between: [ground, crank], point: A}", "between: unknown key", "did you mean links?"),
        ("{type: P, links: [ground, crank], axis: [1 0]}", "axis: a comma stands between values", "write [1, 0]"),
        ("{type: P, links: [ground, crank], axis: [1; 0]}", "axis: a comma stands between values", "write [1, 0]"),
    ],
)
def test_a_joint_in_other_words_is_shown_as_it_is_written(tmp_path: Path, joint: str, message: str, hint: str) -> None:
    """One problem each, with what would be right."""
    found = findings(tmp_path, f"{LOOSE}  - {joint}\n  - crank R ground at B\n")
    assert [(one.message, one.hint) for one in found if one.at.startswith("7:")] == [(message, hint)]
