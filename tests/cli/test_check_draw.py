"""`dhcli check --draw FILE`: an answer over the arm that is right."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from tests.cli.running import Run

RIGHT = "a1*c1 + a2*c12, a1*s1 + a2*s12, 0"
TABLE = """format: 1
title: Mine
source: made for a test
convention: standard
variables: [theta1, theta2, theta3]
parameters: {a2: 0.5, a3: 0.3, d1: 0.4}
links:
  - {a: 0, alpha: 90°, d: 0.4, theta: theta1}
  - {a: 0.5, alpha: 0, d: 0, theta: theta2}
  - {a: 0.3, alpha: 0, d: 0, theta: theta3}
"""


def _drawn(path: Path) -> tuple[int, str]:
    """How many rings mark a frame, and the words of the title."""
    text = path.read_text("utf-8")
    return text.count('class="theirs-mark"'), text


def test_a_wrong_position_is_drawn_where_it_leads_and_marked(dhcli: Run) -> None:
    """The judgement is what it is without a picture; the pose is one at which the slip shows."""
    words = ("check", "planar-two-links", "--part", "d02", "--answer", "a1*c1 + a2*c2, a1*s1 + a2*s12, 0")
    plain, drawn = dhcli(*words), dhcli(*words, "--draw", "d.svg")
    assert (drawn.code, drawn.out) == (1, plain.out)
    assert drawn.err == "wrote d.svg: part d02\n"
    marks, text = _drawn(Path("d.svg"))
    assert marks == 1
    assert "2′" in re.sub(r"<[^>]*>", "", text)


def test_a_right_answer_differs_nowhere(dhcli: Run) -> None:
    """No frame is marked."""
    done = dhcli("check", "planar-two-links", "--part", "d02", "--answer", RIGHT, "--draw", "d.svg")
    assert (done.code, done.err) == (0, "wrote d.svg: part d02\n")
    assert _drawn(Path("d.svg"))[0] == 0


@pytest.mark.parametrize(
    ("old", "new", "row"),
    [("alpha: 90°", "alpha: -90°", 1), ("a: 0.5", "a: 0.45", 2), ("d: 0, theta: theta3", "d: 0.1, theta: theta3", 3)],
)
def test_of_a_table_the_frame_of_the_first_wrong_row_is_marked(dhcli: Run, old: str, new: str, row: int) -> None:
    """Its axes carry the number of the row with a stroke."""
    Path("right.yaml").write_text(TABLE, "utf-8")
    Path("mine.yaml").write_text(TABLE.replace(old, new), "utf-8")
    done = dhcli("check", "./right.yaml", "--table", "mine.yaml", "--compare", "same-motion", "--draw", "t.svg")
    assert (done.code, done.err) == (1, "wrote t.svg: part table\n")
    marks, text = _drawn(Path("t.svg"))
    assert marks == 1
    assert set(re.findall(r"(\d)′", re.sub(r"<[^>]*>", "", text))) == {str(row)}


def test_a_rotation_is_drawn_too(dhcli: Run) -> None:
    """It stands at the right place."""
    turned = dhcli("check", "scara", "--pose", "zero", "--answer", "0 1 0; 1 0 0; 0 0 -1", "--draw", "r.svg")
    assert (turned.code, turned.err) == (1, "wrote r.svg: part rotation\n")
    assert _drawn(Path("r.svg"))[0] == 1


def test_of_a_sheet_the_first_wrong_part_that_can_be_drawn_is(dhcli: Run) -> None:
    """`--part` chooses another."""
    Path("sheet.yaml").write_text(
        "format: 1\nexercise: yim/planar-two-links\nanswers:\n"
        f"  a1: c1 -s1 0 a1*c1; s1 c1 0 a1*s1; 0 0 1 0; 0 0 0 1\n  d02: {RIGHT.replace('c12', 'c2')}\n",
        "utf-8",
    )
    assert dhcli("check", "planar-two-links", "sheet.yaml", "--draw", "s.svg").err == "wrote s.svg: part d02\n"
    again = dhcli("check", "planar-two-links", "sheet.yaml", "--part", "a1", "--draw", "s.svg", "--overwrite")
    assert again.err == "wrote s.svg: part a1\n"


def test_a_position_in_another_unit_is_said_to_be_outside(dhcli: Run) -> None:
    """It does not make the arm a dot."""
    done = dhcli("check", "scara", "--pose", "zero", "--answer", "0, 500, 400", "--draw", "u.svg")
    assert done.err == "wrote u.svg: part position\n"
    assert _drawn(Path("u.svg"))[0] == 0
    assert "far outside the picture" in Path("u.svg").read_text("utf-8")


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("check", "planar-two-links", "--draw", "d.svg"), "--draw draws an answer that was given"),
        (("check", "planar-two-links", "--part", "d02", "--answer", RIGHT, "--draw", "d.html"), "a page shows one"),
        (("check", "planar-two-links", "--part", "d02", "--answer", RIGHT, "--draw", "d"), "does not say which format"),
        (
            ("check", "planar-2r", "--ik", "--position", "0.5,0,0", "--answer", "1, 2", "--draw", "d.svg"),
            "can be drawn",
        ),
        (("check", "planar-two-links", "--part", "d02", "--answer", RIGHT, "--draw", "old.svg"), "exists already"),
        (("check", "planar-two-links", "--part", "d02", "--answer", RIGHT, "--draw", "no/d.svg"), "no/d.svg"),
    ],
)
def test_what_cannot_be_drawn_is_refused(dhcli: Run, words: tuple[str, ...], said: str) -> None:
    """With exit code 2 and no file."""
    Path("old.svg").write_text("mine", "utf-8")
    done = dhcli(*words)
    assert done.code == 2
    assert said in done.err
    assert not Path("d.svg").exists()
    assert Path("old.svg").read_text("utf-8") == "mine"


def test_an_answer_that_cannot_be_read_is_not_drawn(dhcli: Run) -> None:
    """The judgement stands, and it is said."""
    done = dhcli("check", "planar-two-links", "--part", "d02", "--answer", "what?", "--draw", "d.svg")
    assert done.code == 2
    assert "nothing was drawn" in done.err
    assert not Path("d.svg").exists()


FRAMES = """format: 1
title: Frames
source: made for a test
robot: articulated
task: Put frames on the axes.
parts:
  - {id: fr, ask: frames standard, hints: [a, b]}
"""
RIGHT_FRAMES = "(0,0,0) +x +z; (0,0,d1) +x -y; (a2,0,d1) +x -y; (a2+a3,0,d1) +x -y"


@pytest.mark.parametrize(
    ("old", "new", "wrong"),
    [("+x -y; (a2,0", "+x +z; (a2,0", "1"), ("(a2,0,d1) +x", "(a2,0,d1) +z", "2"), ("+x +z; (0,0", "-x +z; (0,0", "")],
)
def test_of_frames_the_first_that_breaks_a_rule_is_marked(dhcli: Run, old: str, new: str, wrong: str) -> None:
    """Other frames that keep the rules are right, and none of them is."""
    Path("frames.yaml").write_text(FRAMES, "utf-8")
    answer = RIGHT_FRAMES.replace(old, new, 1)
    assert answer != RIGHT_FRAMES
    done = dhcli("check", "./frames.yaml", "--answer", answer, "--draw", "f.svg")
    assert (done.code, done.err) == (int(bool(wrong)), "wrote f.svg: part fr\n")
    marks, text = _drawn(Path("f.svg"))
    assert marks == int(bool(wrong))
    assert set(re.findall(r"(\d)′", re.sub(r"<[^>]*>", "", text))) == ({wrong} if wrong else set())
