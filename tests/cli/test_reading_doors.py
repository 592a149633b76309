"""Aimed input at every door that reads: a clear refusal with exit code 2, never a bug, in bounded work.

A reader that went back and forth would hang a test; none of them measures time.
"""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from dhcli.cli.main import main
from tests.cli.running import Run
from tests.nightly import NIGHT

LONG = 10_000 if NIGHT else 4_000
"""Of what a reader that goes back and forth would not come to an end with."""
TINY = "1e-60^5 mm"
FAT = "+".join(f"1/{10**50 + k}" for k in range(35))
FAT_TURNS = " ".join(f"Rot(z, 1/{10**50 + k} rad)" for k in range(190))
FAT_SHIFTS = " ".join(f"Trans(1/{10**50 + k}, 0, 0)" for k in range(190))
FAT_MULTIPLES = " ".join(f"Rot(z, theta1/{10**50 + k})" for k in range(190))
DIVIDES = """format: 1
title: t
source: t
convention: standard
variables: [theta1, theta2]
parameters: {a1: 0.5, a2: 30°}
links:
  - {a: 1/(a1-0.4), alpha: 0, d: 0, theta: theta1}
  - {a: 0, alpha: 0, d: tan(a2), theta: theta2}
"""
ASKS = """format: 1
title: t
source: t
task: t
robot: planar-2r
parts:
  - id: p
    ask: ASKED
    hints: [h]
"""


def refused(capsys: pytest.CaptureFixture[str], *typed: str) -> str:
    """What is said to bad input, which ends with 2."""
    assert main(list(typed)) == 2
    said = capsys.readouterr()
    text = said.out + said.err
    assert "bug in dhcli" not in text
    assert text.strip()
    return text


@pytest.mark.parametrize(
    "typed",
    [
        ("fk", "scara", "--q", f"0, 0, {TINY}"),
        ("fk", "scara", "--q", "0,0,1", "--set", f"l1={TINY}"),
        ("fk", "scara", "--q", "0,0,1", "--point", f"{TINY}, 0, 0"),
        ("sweep", "scara", "--over", f"d3=0..{TINY} n 3", "--q", "theta1=0,theta2=0"),
        ("transform", f"Trans({TINY}, 0, 0)"),
        ("transform", "Trans(l1, 0, 0)", "--set", f"l1={TINY}"),
        ("check", "planar-two-links", "--part", "d02", "--answer", f"{TINY}, 0, 0"),
    ],
)
def test_a_number_too_small_for_its_unit_is_refused(typed: tuple[str, ...], capsys: pytest.CaptureFixture[str]) -> None:
    """At every door."""
    assert "the number becomes too large or too small" in refused(capsys, *typed)


@pytest.mark.parametrize(
    "options",
    [
        ("--q", "0.1,0.2", "--set", "a1=0.4"),
        ("--q", "0.1,0.2", "--set", "a1=0.4", "--frames"),
        ("--symbolic", "--set", "a1=0.4"),
        ("--q", "0.1,0.2", "--set", "a2=90°"),
        ("--symbolic", "--set", "a2=90°", "--links"),
    ],
)
def test_a_division_by_zero_that_values_bring_is_refused(
    options: tuple[str, ...], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """In numbers and in symbols."""
    (tmp_path / "arm.yaml").write_text(DIVIDES, encoding="utf-8")
    said = refused(capsys, "fk", str(tmp_path / "arm.yaml"), *options)
    assert "divided by zero" in said or "not a real number" in said


@pytest.mark.parametrize("product", ["Trans(1/(l1-1),0,0)", "Trans(tan(l1*90°),0,0)", "Trans(tan(theta2),0,0)"])
def test_a_transform_divides_by_nothing(product: str, capsys: pytest.CaptureFixture[str]) -> None:
    """`tan(theta2)` at 90°, `1/(l1-1)` at 1."""
    name, value = ("theta2", "90°") if "theta2" in product else ("l1", "1")
    refused(capsys, "transform", product, "--set", f"{name}={value}")


@pytest.mark.parametrize(
    "product", [f"Trans({FAT}, 0, 0)", f"Rot(z, ({FAT}) rad)", FAT_TURNS, FAT_SHIFTS, FAT_MULTIPLES]
)
def test_numbers_of_thousands_of_digits_are_refused(product: str, capsys: pytest.CaptureFixture[str]) -> None:
    """Before Python refuses to write them."""
    said = refused(capsys, "transform", product, "--symbolic")
    assert any(words in said for words in ("too many digits", "too large", "moves are more than the 80"))


@pytest.mark.parametrize(
    ("asked", "message"),
    [
        ("entry 4 4 of pose 0..2", "the bottom row of a pose is 0 0 0 1 for everybody"),
        ("entry 5 1 of pose 0..2", "a pose has four rows and four columns"),
        ("entry one 1 of pose 0..2", "a pose has four rows and four columns"),
        ("pose 0..0", "a frame seen from itself is no question"),
        ("link " + "1" * 5000, "a question of more than 2000 characters is not read"),
        ("link " + "1" * 1500, "asks nothing that is known"),
        ("factors " + "1" * 1500, "is not the number of a link"),
        ("cell alpha " + "1" * 1500, "is not the number of a link"),
        ("inverse of " * 2000 + "pose 0..2", "a question of more than 2000 characters is not read"),
        ("'scalar a1*90°'", "e.yaml:8:18: an angle is a sum of joint angles and constants"),
        ("'scalar 400mm/2mm'", "e.yaml:8:25: a second unit, mm, stands in one product"),
        ("'scalar acos(2)'", "acos(2) is not a real number"),
        ("'scalar nan'", "nan is no number that a robot can have"),
        ("'point (1e-60^5 mm, 0, 0) of pose 0..2'", "the number becomes too large or too small"),
    ],
)
def test_a_question_that_asks_nothing_is_refused(
    asked: str, message: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """With its line, in every command that loads it."""
    path = tmp_path / "e.yaml"
    path.write_text(ASKS.replace("ASKED", asked), encoding="utf-8")
    assert message in refused(capsys, "check", str(path), "--answer", "1").replace(str(path), "e.yaml")
    assert message in refused(capsys, "solution", str(path), "--yes").replace(str(path), "e.yaml")


def test_an_inverse_of_an_inverse_is_the_pose(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """However often."""
    path = tmp_path / "e.yaml"
    path.write_text(ASKS.replace("ASKED", "inverse of " * 100 + "pose 0..1"), encoding="utf-8")
    assert main(["check", str(path), "--answer", "[c1 -s1 0 a1*c1; s1 c1 0 a1*s1; 0 0 1 0; 0 0 0 1]"]) == 0
    assert "RIGHT" in capsys.readouterr().out


@pytest.mark.parametrize(
    "table",
    [
        "theta1,theta2,d3\n" + "9" * 20 * LONG + "x,0,0\n",
        "9" * 20 * LONG + "x,0,0\n",
        "theta1" + " " * 20 * LONG + "x,theta2,d3\n0,0,0\n",
        "a [ " * 6 * LONG + "\n0,0,0\n",
        "theta1 [ " * 2 * LONG + "\n0,0,0\n",
        "theta1 theta2 d3\n" + "a [ " * 6 * LONG + "\n",
        "theta1;theta2;d3\n" + "9" * 10 * LONG + "," + "9" * 10 * LONG + "x;0;0\n",
    ],
)
def test_a_table_of_one_long_cell_is_refused(table: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Digits, blanks and brackets without end, in cells and in heads."""
    (tmp_path / "q.csv").write_text(table, encoding="utf-8")
    refused(capsys, "fk", "scara", "--rows", str(tmp_path / "q.csv"))


@pytest.mark.parametrize("text", ["1.. " * 40_000, "1..2" + " " * 40_000 + "x", "1" * 50_000, "1.." * 50_000])
def test_a_range_without_end_is_refused(text: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """By its length, before it is looked through."""
    path = tmp_path / "e.yaml"
    path.write_text(ASKS.replace("ASKED", "pose 0..2").replace("parts:", f"variants: {{a1: {text}}}\nparts:"))
    assert "is no range" in refused(capsys, "check", str(path), "--answer", "1")


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no named pipes here")
@pytest.mark.parametrize("command", ["fk", "check", "dof"])
def test_a_pipe_that_nobody_writes_to_is_refused(
    command: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A reader would wait for ever."""
    path = tmp_path / "pipe.yaml"
    os.mkfifo(path)
    assert "is a pipe that nobody writes to" in refused(capsys, command, str(path))


def test_a_cell_of_115_cosines_is_judged(capsys: pytest.CaptureFixture[str]) -> None:
    """Each with another fraction of an angle; sums are gathered at once."""
    cell = "+".join(f"cos(theta1/{k})" for k in range(2, 117))
    assert main(["check", "planar-two-links", "--part", "d02", "--answer", f"{cell}, {cell}, 0"]) == 1
    assert "WRONG" in capsys.readouterr().out


@pytest.mark.parametrize("text", ["a [ " * 5000, "(" * 20_000, "9" * 20_000, "_{" * 9000, "cos" * 6000, "= " * 9000])
@pytest.mark.parametrize(
    "door",
    [
        ("fk", "scara", "--q"),
        ("transform",),
        ("fk", "scara", "--symbolic", "--point"),
        ("sweep", "scara", "--over"),
        ("dof",),
    ],
)
def test_a_long_text_of_one_thing_is_refused(
    door: tuple[str, ...], text: str, capsys: pytest.CaptureFixture[str]
) -> None:
    """At every door where a line is typed."""
    refused(capsys, *door, text)


def test_show_says_what_was_taken_exactly_and_what_follows_from_what(dhcli: Run, tmp_path: Path) -> None:
    """On stderr, as a warning; a formula stands before its value."""
    (tmp_path / "arm.yaml").write_text(
        "format: 1\ntitle: T\nsource: mine\nconvention: standard\nvariables: [q1]\n"
        "parameters: {a2: 0.4 m, a3: 2*a2}\nlinks:\n  - {a: a3, alpha: 1.5708 rad, d: 0, theta: q1}\n",
        "utf-8",
    )
    done = dhcli("show", "./arm.yaml")
    assert done.code == 0
    assert "1.5708 rad is taken as 90°" in done.err
    assert "2*a2 = 0.8 m" in done.out
